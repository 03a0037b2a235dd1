#include "tb/model/compare.hpp"

#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstdio>
#include <map>

#include "hls/edge/triangle.hpp"

namespace relievo::tb {

namespace {

using words = std::vector<std::int64_t>;

struct record {
  words w;
  std::size_t place;  // in the run it came from
};

// Two records to be held against each other; null: the other run has none.
struct pairing {
  record const* of[2];
};

// Whose register a field of an output vertex is, and how far down the data path.
struct origin {
  char const* field;
  char const* unit;
  int stage;
};
constexpr origin origins[] = {{"u", "calculate_new_u", 0},    {"p", "calculate_new_p", 1}, {"t", "calculate_new_n", 1},
                              {"displaced_p", "displace", 2}, {"displaced_n", "bump", 2},  {"screen", "transform", 3},
                              {"w", "transform", 3},          {"behind", "transform", 3},  {"screen_n", "transform_normal", 3},
                              {"away", "transform_normal", 3}};
// Those that have another name in the sweep engine.
constexpr origin sweep_origins[] = {
    {"u", "perspective_correction", 0}, {"p", "perspective_correction", 0}, {"t", "perspective_correction", 0}};

origin origin_of(field const& f, bool sweep) {
  // v[i].member[k]
  const std::size_t dot = f.name.find('.');
  if (dot != std::string::npos) {
    const std::string member = f.name.substr(dot + 1, f.name.find('[', dot) - dot - 1);
    if (sweep)
      for (origin const& o : sweep_origins)
        if (member == o.field) return o;
    for (origin const& o : origins)
      if (member == o.field) return o;
  }
  return {"", "engine", 4};
}

std::vector<field> const& fields() { return layout<hls::triangle_out>(); }
std::size_t index_word() {
  static const std::size_t at = [] {
    std::size_t i = 0;
    while (fields()[i].name != "index") ++i;
    return i;
  }();
  return at;
}

std::vector<record> records_of(run_result const& r, bool in_order, bool& exact) {
  std::vector<record> list;
  list.reserve(r.triangles.size());
  for (std::size_t i = 0; i < r.triangles.size(); ++i) list.push_back({golden_words<hls::triangle_out>(r.triangles[i], exact), i});
  // `last` marks a place in the stream, not a triangle: it is left out where the order is free.
  if (!in_order) {
    for (record& x : list) x.w.back() = 0;
    std::sort(list.begin(), list.end(), [](record const& x, record const& y) { return x.w < y.w; });
  }
  return list;
}

std::size_t words_apart(record const& a, record const& b) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < a.w.size(); ++i) n += a.w[i] != b.w[i] ? 1 : 0;
  return n;
}

std::vector<pairing> pairs_in_order(std::vector<record> const& a, std::vector<record> const& b) {
  std::vector<pairing> pairs;
  for (std::size_t i = 0; i < a.size() || i < b.size(); ++i) {
    record const* x = i < a.size() ? &a[i] : nullptr;
    record const* y = i < b.size() ? &b[i] : nullptr;
    if (x == nullptr || y == nullptr || x->w != y->w) pairs.push_back({{x, y}});
  }
  return pairs;
}

// The likest two come first; many are not all held against all.
void bring_likest_first(std::vector<record const*>& x, std::vector<record const*>& y) {
  constexpr std::size_t most = 300;
  std::size_t best = ~std::size_t(0), at_x = 0, at_y = 0;
  for (std::size_t i = 0; i < std::min(most, x.size()); ++i)
    for (std::size_t j = 0; j < std::min(most, y.size()); ++j)
      if (const std::size_t n = words_apart(*x[i], *y[j]); n < best) {
        best = n;
        at_x = i;
        at_y = j;
      }
  if (x.empty() || y.empty()) return;
  std::rotate(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(at_x), x.begin() + static_cast<std::ptrdiff_t>(at_x) + 1);
  std::rotate(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(at_y), y.begin() + static_cast<std::ptrdiff_t>(at_y) + 1);
}

// What only one of two sorted lists has, by base triangle, the lowest first.
std::vector<pairing> pairs_by_base(std::vector<record> const& a, std::vector<record> const& b) {
  std::map<std::int64_t, std::array<std::vector<record const*>, 2>> left;
  const auto leave = [&](record const& r, std::size_t side) { left[r.w[index_word()]][side].push_back(&r); };
  std::size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    if (j == b.size() || (i < a.size() && a[i].w < b[j].w)) {
      leave(a[i++], 0);
    } else if (i == a.size() || b[j].w < a[i].w) {
      leave(b[j++], 1);
    } else {
      ++i;
      ++j;
    }
  }
  std::vector<pairing> pairs;
  for (auto& [base, lists] : left) {
    auto& [x, y] = lists;
    if (pairs.empty()) bring_likest_first(x, y);
    for (std::size_t k = 0; k < std::max(x.size(), y.size()); ++k)
      pairs.push_back({{k < x.size() ? x[k] : nullptr, k < y.size() ? y[k] : nullptr}});
  }
  return pairs;
}

using counter_list = std::vector<std::pair<std::string, std::uint64_t>>;

counter_list counters_of(run_result const& run) {
  counter_list values;
  const auto add = [&values](char const* name, auto const& x) {
    if constexpr (std::is_array_v<std::remove_reference_t<decltype(x)>>) {
      for (auto e : x) values.emplace_back(name, e);
    } else {
      values.emplace_back(name, x);
    }
  };
  if (run.sweep)
    run.sweep->count.counters.each_field(add);
  else
    run.counts.each_field(add);
  return values;
}

std::ptrdiff_t triangles_of(double base, run_result const& r) {
  return std::count_if(r.triangles.begin(), r.triangles.end(), [base](golden::triangle_out const& t) { return t.index == base; });
}

found_difference difference_of(pairing const& p, run_result const& first, run_result const& second) {
  found_difference d;
  d.side = p.of[0] != nullptr ? 0 : 1;
  run_result const& of = d.side == 0 ? first : second;
  d.place = p.of[d.side]->place;
  d.triangle = of.triangles[d.place];
  d.path = d.triangle.path;
  d.has_path = !of.sweep;
  d.words_different = fields().size();
  if (p.of[0] != nullptr && p.of[1] != nullptr) {
    d.words_different = words_apart(*p.of[0], *p.of[1]);
    int stage = 5;
    for (std::size_t i = 0; i < fields().size(); ++i) {
      const std::int64_t x = p.of[0]->w[i], y = p.of[1]->w[i];
      const origin o = origin_of(fields()[i], of.sweep.has_value());
      if (x == y || o.stage >= stage) continue;
      stage = o.stage;
      d.at = fields()[i];
      d.unit = o.unit;
      d.words[0] = x;
      d.words[1] = y;
    }
    // Golden's triangle of the two knows the path.
    if (d.path == 1) d.path = second.triangles[p.of[1]->place].path;
  }
  // Another number of triangles on the base triangle: an edge was split by one and not by the other.
  if (!d.at || triangles_of(d.triangle.index, first) != triangles_of(d.triangle.index, second))
    d.unit = of.sweep ? "sweep_line" : "pass_or_tessellate";
  return d;
}

}  // namespace

std::string word_text(std::string const& name, std::int64_t word, field const& f) {
  const std::uint64_t mask = f.width == 64 ? ~std::uint64_t(0) : (std::uint64_t(1) << f.width) - 1;
  char text[80];
  std::snprintf(text, sizeof text, " 0x%0*" PRIx64 " (%.12g)", (f.width + 3) / 4, static_cast<std::uint64_t>(word) & mask, f.value(word));
  return name + text;
}

std::string path_text(std::uint64_t path) {
  std::string text;
  while (path > 1) {
    text.insert(text.begin(), static_cast<char>('0' + (path & 3)));
    path >>= 2;
  }
  return text.empty() ? "base" : text;
}

std::string to_text(found_difference const& d) {
  char where[100];
  std::snprintf(where, sizeof where, "triangle %zu of %s (base triangle %.0f", d.place, d.names[d.side].c_str(), d.triangle.index);
  std::string text = where + (d.has_path ? ", path " + path_text(d.path) : "") + "), unit " + d.unit;
  if (!d.at) return text + ": " + d.names[1 - d.side] + " has no such triangle";
  return text + ", field " + d.at->name + ": " + word_text(d.names[0], d.words[0], *d.at) + ", " +
         word_text(d.names[1], d.words[1], *d.at) + "; " + std::to_string(d.words_different) + " of its " +
         std::to_string(fields().size()) + " words differ";
}

std::optional<std::uint64_t> path_in(run_result const& golden, golden::triangle_out const& t) {
  for (golden::triangle_out const& g : golden.triangles)
    if (g.index == t.index && g.v[0].u == t.v[0].u && g.v[1].u == t.v[1].u && g.v[2].u == t.v[2].u) return g.path;
  return std::nullopt;
}

comparison compare_runs(std::string const& first_name, run_result const& first, std::string const& second_name, run_result const& second,
                        bool in_order) {
  comparison result;
  bool first_exact = true, second_exact = true;
  const std::vector<record> a = records_of(first, in_order, first_exact);
  const std::vector<record> b = records_of(second, in_order, second_exact);
  result.triangles = std::max(a.size(), b.size());
  const std::vector<pairing> pairs = in_order ? pairs_in_order(a, b) : pairs_by_base(a, b);
  result.triangles_different = pairs.size();
  for (pairing const& p : pairs)
    result.words_different += p.of[0] != nullptr && p.of[1] != nullptr ? words_apart(*p.of[0], *p.of[1]) : fields().size();
  if (!pairs.empty()) {
    result.first = difference_of(pairs.front(), first, second);
    result.first->names[0] = first_name;
    result.first->names[1] = second_name;
    result.first_difference = to_text(*result.first);
  }
  if (!first_exact || !second_exact) {
    result.first_difference = (first_exact ? second_name : first_name) + " holds values that are no words of their format";
    ++result.words_different;
  }

  const counter_list x = counters_of(first), y = counters_of(second);
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    // How full a queue was is a matter of time where triangles overtake each other.
    const bool timed = !in_order && (x[i].first == "queue_high_water" || x[i].first == "fifo_fallbacks");
    if (!timed && x[i].second != y[i].second)
      result.counters_different.push_back(x[i].first + ": " + first_name + " " + std::to_string(x[i].second) + ", " + second_name + " " +
                                          std::to_string(y[i].second));
  }
  if (first.sweep && second.sweep && first.sweep->colours != second.sweep->colours)
    result.counters_different.push_back("colours: " + first_name + " and " + second_name + " differ");
  return result;
}

}  // namespace relievo::tb

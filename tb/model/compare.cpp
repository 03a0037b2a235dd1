#include "tb/model/compare.hpp"

#include <algorithm>
#include <cinttypes>
#include <cstdio>

#include "hls/edge/triangle.hpp"
#include "tb/model/words.hpp"

namespace relievo::tb {

namespace {

using words = std::vector<std::int64_t>;

struct record {
  words w;
  std::size_t place;  // in the run it came from
};

words words_of(golden::triangle_out const& t, bool& exact) { return golden_words<hls::triangle_out>(t, exact); }

std::string path_text(std::uint64_t path) {
  // 1 followed by two bits per generation.
  std::string text;
  while (path > 1) {
    text.insert(text.begin(), static_cast<char>('0' + (path & 3)));
    path >>= 2;
  }
  return text.empty() ? "base" : text;
}

std::string describe(std::string const& a_name, std::int64_t a, std::string const& b_name, std::int64_t b, field const& f,
                     golden::triangle_out const& t, std::size_t place) {
  const std::uint64_t mask = f.width == 64 ? ~std::uint64_t(0) : (std::uint64_t(1) << f.width) - 1;
  const int digits = (f.width + 3) / 4;
  char line[400];
  std::snprintf(line, sizeof line,
                "triangle %zu (base triangle %.0f, path %s), field %s: %s 0x%0*" PRIx64 " (%.12g), %s 0x%0*" PRIx64 " (%.12g)", place,
                t.index, path_text(t.path).c_str(), f.name.c_str(), a_name.c_str(), digits, static_cast<std::uint64_t>(a) & mask,
                f.value(a), b_name.c_str(), digits, static_cast<std::uint64_t>(b) & mask, f.value(b));
  return line;
}

std::vector<record> records_of(run_result const& r, bool in_order, bool& exact) {
  std::vector<record> list;
  list.reserve(r.triangles.size());
  for (std::size_t i = 0; i < r.triangles.size(); ++i) list.push_back({words_of(r.triangles[i], exact), i});
  // `last` marks a place in the stream, not a triangle: it is left out where the order is free.
  if (!in_order) {
    for (record& x : list) x.w.back() = 0;
    std::sort(list.begin(), list.end(), [](record const& x, record const& y) { return x.w < y.w; });
  }
  return list;
}

}  // namespace

comparison compare_runs(std::string const& first_name, run_result const& first, std::string const& second_name, run_result const& second,
                        bool in_order) {
  comparison result;
  bool first_exact = true, second_exact = true;
  const std::vector<record> a = records_of(first, in_order, first_exact);
  const std::vector<record> b = records_of(second, in_order, second_exact);
  if (!first_exact || !second_exact) {
    result.first_difference = (first_exact ? second_name : first_name) + " holds values that are no words of their format";
    ++result.words_different;
  }
  std::vector<field> const& fields = layout<hls::triangle_out>();
  result.triangles = std::max(a.size(), b.size());
  const std::size_t common = std::min(a.size(), b.size());
  for (std::size_t i = 0; i < common; ++i) {
    for (std::size_t j = 0; j < fields.size(); ++j) {
      if (a[i].w[j] == b[i].w[j]) continue;
      ++result.words_different;
      if (result.first_difference.empty())
        result.first_difference =
            describe(first_name, a[i].w[j], second_name, b[i].w[j], fields[j], first.triangles[a[i].place], a[i].place);
    }
  }
  if (a.size() != b.size()) {
    result.words_different += (result.triangles - common) * fields.size();
    if (result.first_difference.empty())
      result.first_difference =
          first_name + " has " + std::to_string(a.size()) + " triangles, " + second_name + " " + std::to_string(b.size());
  }

  std::vector<std::pair<std::string, std::uint64_t>> values;
  first.counts.each_field([&](char const* name, auto const& x) {
    if constexpr (std::is_array_v<std::remove_reference_t<decltype(x)>>) {
      for (auto e : x) values.emplace_back(name, e);
    } else {
      values.emplace_back(name, x);
    }
  });
  std::size_t i = 0;
  const auto check = [&](std::uint64_t x) {
    // How full a queue was is a matter of time where triangles overtake each other.
    const bool timed = !in_order && (values[i].first == "queue_high_water" || values[i].first == "fifo_fallbacks");
    if (!timed && values[i].second != x)
      result.counters_different.push_back(values[i].first + ": " + first_name + " " + std::to_string(values[i].second) + ", " +
                                          second_name + " " + std::to_string(x));
    ++i;
  };
  second.counts.each_field([&](char const*, auto const& x) {
    if constexpr (std::is_array_v<std::remove_reference_t<decltype(x)>>) {
      for (auto e : x) check(e);
    } else {
      check(x);
    }
  });
  return result;
}

}  // namespace relievo::tb

#include "tb/commands/vectors.hpp"

#include <charconv>
#include <random>
#include <sstream>

#include "hls/edge/engine_regs.hpp"
#include "hls/edge/triangle.hpp"
#include "hls/surface/normal_map.hpp"
#include "tb/host/files.hpp"
#include "tb/host/input_error.hpp"

namespace relievo::tb {

namespace {

using words = unit_vectors::words;

// The layouts of a unit's lines.
struct lines {
  std::vector<field> regs, in, out, normal_map;
};

bool layouts_of(std::string const& unit, lines& l) {
  if (unit == "engine") {
    l = {layout<hls::engine_regs>(), layout<hls::triangle>(), layout<hls::triangle_out>(), layout<hls::normal_map_regs>()};
    return true;
  }
  pure_unit const* u = find_unit(unit);
  if (u == nullptr) return false;
  l = {u->regs, u->in, u->out, {}};
  return true;
}

void append(std::string& text, char const* key, words const& w, std::vector<field> const& fields) {
  text += key;
  char digits[20];
  for (std::size_t i = 0; i < w.size(); ++i) {
    const std::uint64_t mask = fields[i].width == 64 ? ~std::uint64_t(0) : (std::uint64_t(1) << fields[i].width) - 1;
    const auto end = std::to_chars(digits, digits + sizeof digits, static_cast<std::uint64_t>(w[i]) & mask, 16).ptr;
    text += ' ';
    text.append(digits, end);
  }
  text += '\n';
}

class parser {
 public:
  parser(std::string_view text, std::string const& name) : text_(text), name_(name) {}

  [[noreturn]] void fail(std::string const& what) const { throw input_error(name_ + ", line " + std::to_string(line_) + ": " + what); }

  // The next line's key; false at the end.
  bool next() {
    if (at_ >= text_.size()) return false;
    const std::size_t end = text_.find('\n', at_);
    if (end == std::string_view::npos) {
      ++line_;
      fail("the line does not end; the file is cut off");
    }
    rest_ = text_.substr(at_, end - at_);
    at_ = end + 1;
    ++line_;
    key_ = word();
    return true;
  }
  std::string_view key() const { return key_; }
  std::string_view word() {
    const std::size_t begin = rest_.find_first_not_of(' ');
    if (begin == std::string_view::npos) {
      rest_ = {};
      return {};
    }
    rest_.remove_prefix(begin);
    const std::string_view w = rest_.substr(0, rest_.find(' '));
    rest_.remove_prefix(w.size());
    return w;
  }
  std::uint64_t number(int base) {
    const std::string_view w = word();
    std::uint64_t x = 0;
    const auto result = std::from_chars(w.data(), w.data() + w.size(), x, base);
    if (w.empty() || result.ec != std::errc() || result.ptr != w.data() + w.size())
      fail("'" + std::string(w) + "' is no number in base " + std::to_string(base));
    return x;
  }
  words record(std::vector<field> const& fields) {
    words w;
    w.reserve(fields.size());
    for (field const& f : fields) {
      const std::uint64_t x = number(16);
      if (f.width < 64 && (x >> f.width) != 0) fail("field " + f.name + " has more than its " + std::to_string(f.width) + " bits");
      const int unused = 64 - f.width;
      w.push_back(f.is_signed ? static_cast<std::int64_t>(x << unused) >> unused : static_cast<std::int64_t>(x));
    }
    if (!word().empty()) fail("more words than the " + std::to_string(fields.size()) + " fields of this record");
    return w;
  }

 private:
  std::string_view text_, rest_, key_;
  std::string const& name_;
  std::size_t at_ = 0;
  int line_ = 0;
};

}  // namespace

std::uint64_t format_hash() {
  // FNV-1a over the table.
  std::string table;
#define RELIEVO_FORMAT_TEXT(name, width, integer_bits, is_signed) \
  table += #name ":" + std::to_string(width) + ":" + std::to_string(integer_bits) + ":" + std::to_string(is_signed) + ";";
  RELIEVO_FORMATS(RELIEVO_FORMAT_TEXT)
#undef RELIEVO_FORMAT_TEXT
  std::uint64_t hash = 14695981039346656037u;
  for (char c : table) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return hash;
}

std::string to_text(unit_vectors const& v) {
  lines l;
  layouts_of(v.unit, l);
  std::ostringstream head;
  head << "relievo-vectors 1\nunit " << v.unit << "\nformats " << std::hex << format_hash() << std::dec << "\nseed " << v.seed << "\n";
  std::string text = head.str();
  if (!v.in_order) text += "order free\n";
  append(text, "regs", v.regs, l.regs);
  const bool engine = v.unit == "engine";
  if (engine) append(text, "normal_map", v.normal_map, l.normal_map);
  for (words const& row : v.texels)
    append(text, "texels", row, std::vector<field>(row.size(), {"texel", formats::texel::width, formats::texel::fraction, false}));
  for (std::size_t i = 0; i < v.in.size(); ++i) {
    append(text, "i", v.in[i], l.in);
    if (!engine) append(text, "o", v.out[i], l.out);
  }
  if (engine)
    for (words const& o : v.out) append(text, "o", o, l.out);
  return text;
}

unit_vectors parse_vectors(std::string_view text, std::string const& name) {
  parser p(text, name);
  unit_vectors v;
  lines l;
  if (!p.next() || p.key() != "relievo-vectors" || p.word() != "1") p.fail("this is no vector file; its first line is 'relievo-vectors 1'");
  if (!p.next() || p.key() != "unit") p.fail("'unit NAME' is missing");
  v.unit = p.word();
  if (!layouts_of(v.unit, l)) p.fail("unit '" + v.unit + "' is not known here");
  if (!p.next() || p.key() != "formats") p.fail("'formats HASH' is missing");
  if (p.number(16) != format_hash()) p.fail("recorded with another table of formats; record it again");
  if (!p.next() || p.key() != "seed") p.fail("'seed N' is missing");
  v.seed = p.number(10);
  bool more = p.next();
  if (more && p.key() == "order" && v.unit == "engine") {
    if (p.word() != "free") p.fail("'order' can only be 'free'");
    v.in_order = false;
    more = p.next();
  }
  if (!more || p.key() != "regs") p.fail("'regs WORDS' is missing");
  v.regs = p.record(l.regs);
  std::vector<field> row;
  std::size_t rows = 0;
  if (v.unit == "engine") {
    if (!p.next() || p.key() != "normal_map") p.fail("'normal_map WORDS' is missing");
    v.normal_map = p.record(l.normal_map);
    const std::int64_t width = v.regs[0], height = v.regs[1];
    if (width < 1 || width > max_map_size || height < 1 || height > max_map_size) p.fail("map size in regs must be 1..8192");
    row.assign(static_cast<std::size_t>(width), {"texel", formats::texel::width, formats::texel::fraction, false});
    rows = static_cast<std::size_t>(height);
  }
  while (p.next()) {
    if (p.key() == "texels" && v.texels.size() < rows && v.in.empty())
      v.texels.push_back(p.record(row));
    else if (p.key() == "i" && v.texels.size() == rows)
      v.in.push_back(p.record(l.in));
    else if (p.key() == "o" && !v.in.empty())
      v.out.push_back(p.record(l.out));
    else
      p.fail("'" + std::string(p.key()) + "' does not belong here; lines go regs, texels of every row, i, o");
  }
  if (v.texels.size() != rows) p.fail("the map has " + std::to_string(rows) + " rows, the file " + std::to_string(v.texels.size()));
  if (v.in.empty() || v.out.empty()) p.fail("no vectors");
  if (v.unit != "engine" && v.in.size() != v.out.size()) p.fail("as many i as o lines are needed");
  return v;
}

unit_vectors record_unit(pure_unit const& unit, std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto draw = [&](std::vector<field> const& fields, std::size_t i) {
    words w;
    for (field const& f : fields) {
      // The weight of an edge's second end is 0..16 by the units' contract; its format's other words mean nothing.
      constexpr std::int64_t whole = 16;
      const bool weight = f.name == "k";
      const std::int64_t corners[] = {0, 1, f.min(), weight ? whole : f.max()};
      // The first records run through the corners, the others are uniform over the words.
      if (i < 4) {
        w.push_back(corners[i]);
        continue;
      }
      const int unused = 64 - f.width;
      if (weight) {
        w.push_back(static_cast<std::int64_t>(random() % (whole + 1)));
        continue;
      }
      const std::uint64_t bits = random() << unused;
      w.push_back(f.is_signed ? static_cast<std::int64_t>(bits) >> unused : static_cast<std::int64_t>(bits >> unused));
    }
    return w;
  };
  unit_vectors v;
  v.unit = unit.name;
  v.seed = seed;
  v.regs = draw(unit.regs, 4);
  for (std::size_t i = 0; i < count; ++i) {
    v.in.push_back(draw(unit.in, i));
    v.out.push_back(unit.golden(v.in.back(), v.regs));
  }
  return v;
}

void write_engine_vectors(std::string const& path, scene const& sc, run_result const& run) {
  unit_vectors v;
  v.unit = "engine";
  v.in_order = run.in_order;
  bool exact = true;
  v.regs = golden_words<hls::engine_regs>(sc.regs, exact);
  v.normal_map = golden_words<hls::normal_map_regs>(sc.normal_map, exact);
  for (int y = 0; y < sc.map.height; ++y) {
    v.texels.emplace_back();
    for (int x = 0; x < sc.map.width; ++x) v.texels.back().push_back(sc.map.at(x, y));
  }
  for (golden::triangle const& t : sc.triangles) v.in.push_back(golden_words<hls::triangle>(t, exact));
  for (golden::triangle_out const& t : run.triangles) v.out.push_back(golden_words<hls::triangle_out>(t, exact));
  if (!exact) throw input_error("--vectors: the ideal model's output has no raw words; take golden or hls");
  if (v.out.empty()) throw input_error("--vectors: the scene puts out no triangle, there is nothing to record");
  write_bytes(path, to_text(v));
}

scene scene_of(unit_vectors const& v, std::string const& name) {
  scene sc;
  hls::engine_regs regs;
  set_raw_words(regs, v.regs);
  to_golden(regs, sc.regs);
  hls::normal_map_regs normals;
  set_raw_words(normals, v.normal_map);
  to_golden(normals, sc.normal_map);
  sc.map.width = static_cast<int>(hls::raw(regs.map.width));
  sc.map.height = static_cast<int>(hls::raw(regs.map.height));
  sc.map.wrap_u = regs.map.wrap_u;
  sc.map.wrap_v = regs.map.wrap_v;
  for (words const& row : v.texels)
    for (std::int64_t texel : row) sc.map.texels.push_back(static_cast<std::uint16_t>(texel));
  for (words const& w : v.in) {
    hls::triangle t;
    set_raw_words(t, w);
    // What lies beyond the map would be read outside the memory.
    for (hls::vertex const& x : t.v) {
      const double edge_u = sc.map.wrap_u ? sc.map.width : sc.map.width - 1, edge_v = sc.map.wrap_v ? sc.map.height : sc.map.height - 1;
      constexpr double texel = 1 << formats::coordinate::fraction;
      if (static_cast<double>(hls::raw(x.u[0])) > edge_u * texel || static_cast<double>(hls::raw(x.u[1])) > edge_v * texel)
        throw input_error(name + ": a base triangle's texture coordinate lies outside the map");
    }
    sc.triangles.emplace_back();
    to_golden(t, sc.triangles.back());
    sc.triangles.back().last = false;
  }
  sc.triangles.back().last = true;
  return sc;
}

run_result run_of(unit_vectors const& v) {
  run_result run;
  run.in_order = v.in_order;
  for (words const& w : v.out) {
    hls::triangle_out t;
    set_raw_words(t, w);
    run.triangles.emplace_back();
    to_golden(t, run.triangles.back());
  }
  return run;
}

}  // namespace relievo::tb

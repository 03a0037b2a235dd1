// tessellate: the circuit puts out the kernel's triangles one after the other, under all traffic; anywhere, near equal diagonals, and where
// the order by value decides between them; a triangle that does not split, and a base triangle that gets its vertices, pass. Five clocks to
// the first, a triangle a clock, and what two splits take longer.
// verilate: Vtessellate Depth=16
// verilate: Vtessellate_4 Depth=4
#include "Vtessellate.h"
#include "Vtessellate_4.h"
#include "hls/edge/tessellate.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/stream_unit.hpp"

namespace relievo::test {
namespace {

// collected_t and child_t of rtl/edge/engine_pkg.sv.
struct collected {
  hls::tessellate_in t;
  bool place;
  RELIEVO_FIELDS(t, place)
};
struct child {
  hls::triangle t;
  bool born, ends;
  RELIEVO_FIELDS(t, born, ends)
};
struct vector {
  collected in;
  hls::map_regs map;
  hls::fixed<formats::generation> max_generation;
  RELIEVO_FIELDS(in, map, max_generation)
};

int splits_of(vector const& v) { return v.in.t.split[0] + v.in.t.split[1] + v.in.t.split[2]; }

std::vector<child> kernel(vector const& v) {
  if (splits_of(v) != 0) {
    hls::tessellate_out out{};
    hls::tessellate(v.in.t, v.map, v.max_generation, out);
    std::vector<child> children;
    for (int i = 0; i < raw(out.count); ++i) children.push_back({out.t[i], true, i + 1 == raw(out.count)});
    return children;
  }
  child same{v.in.t.t, v.in.place, true};
  same.t.last = false;
  for (int i = 0; i < 3; ++i) {
    if (v.in.place) same.t.v[i] = v.in.t.m[i];
    if (!v.in.place) same.t.settled[i] = true;
  }
  return {same};
}

// Vertices that a map has.
void on_the_map(vector& v, generator& g) {
  if (raw(v.map.width) < 1 || raw(v.map.width) > 8192) size_within(v.map.width, 8192, g);
  if (raw(v.map.height) < 1 || raw(v.map.height) > 8192) size_within(v.map.height, 8192, g);
  for (auto* vertices : {v.in.t.t.v, v.in.t.m})
    for (int i = 0; i < 3; ++i) coordinates_within(vertices[i].u, v.map, g);
}
// What the engine can ask: edges that split are below the limit, and none of a base triangle that gets its vertices.
void split_edges(vector& v, int pattern) {
  for (int i = 0; i < 3; ++i) v.in.t.split[i] = ((pattern >> i) & 1) != 0;
  v.in.place = v.in.place && pattern == 0;
  if (raw(v.max_generation) == 0) v.max_generation = hls::from_raw<formats::generation>(1);
  for (int i = 0; i < 3; ++i)
    if (v.in.t.split[i]) v.in.t.t.generation[i] = hls::from_raw<formats::generation>(raw(v.in.t.t.generation[i]) % raw(v.max_generation));
}
void askable(vector& v, generator& g) {
  on_the_map(v, g);
  split_edges(v, static_cast<int>(g.below(8)));
}

// Two splits and the quad a rectangle anywhere in space, of any turn, mostly exact, sometimes off by an LSB; sometimes its ends agree
// in what comes first in their order.
void near_equal_diagonals(vector& v, generator& g) {
  on_the_map(v, g);
  const std::uint64_t whole = g.below(3);
  split_edges(v, 7 & ~(1 << whole));
  auto &a = v.in.t.t.v[whole], &b = v.in.t.t.v[(whole + 1) % 3], &p = v.in.t.m[(whole + 1) % 3], &q = v.in.t.m[(whole + 2) % 3];
  const std::int64_t size = g.chance(2) ? 4000000 : 100;
  const std::int64_t x = g.between(-size, size), y = g.between(-size, size), ox = g.between(-300000, 300000);
  const std::uint64_t first = g.below(3);
  const auto put = [&](hls::vertex& w, std::int64_t px, std::int64_t py) {
    w.p[first] = hls::from_raw<formats::position>(ox + px);
    w.p[(first + 1) % 3] = hls::from_raw<formats::position>(py + (g.chance(12) ? g.between(-1, 1) : 0));
    w.p[(first + 2) % 3] = hls::from_raw<formats::position>(g.chance(24) ? 1 : 0);
  };
  put(a, 0, 0);
  put(b, x, y);
  put(p, x - y, y + x);
  put(q, -y, x);
  if (g.chance(4)) {
    // The same place twice: what is left of the order decides.
    for (int i = 0; i < 3; ++i) {
      b.p[i] = a.p[i];
      p.p[i] = q.p[i];
      if (g.chance(2)) b.n[i] = a.n[i];
      if (g.chance(2)) b.t[i] = a.t[i];
    }
    if (g.chance(2)) {
      const hls::vertex same = a;
      for (int i = 0; i < 3; ++i) {
        b.n[i] = same.n[i];
        b.t[i] = same.t[i];
      }
    }
  }
}

template <class Model, class Shape, class Expected>
void under_all_traffic(Shape shape, Expected expected) {
  const auto list = all_traffic();
  // The registers are drawn once a run: many short runs.
  constexpr std::uint64_t runs = 16;
  for (std::uint64_t i = 0; i < runs; ++i)
    for (traffic const& t : list) stream_test<Model, vector>(t, shape, expected, {}, rtl_vector_count() / (runs * list.size()) + 1);
}

TEST(tessellate, rtl_equals_hls) { under_all_traffic<Vtessellate>(askable, kernel); }
// Places run out all the time.
TEST(tessellate, rtl_equals_hls_with_few_places) { under_all_traffic<Vtessellate_4>(askable, kernel); }
TEST(tessellate, rtl_equals_hls_near_equal_diagonals) {
  std::uint64_t equal = 0, seen = 0;
  under_all_traffic<Vtessellate>(near_equal_diagonals, [&](vector const& v) {
    int whole = 0;
    while (v.in.t.split[whole]) ++whole;
    const auto square = [](hls::vertex const& a, hls::vertex const& b) { return raw(hls::detail::squared_distance(a, b)); };
    const int b = (whole + 1) % 3, c = (whole + 2) % 3;
    ++seen;
    equal += square(v.in.t.t.v[whole], v.in.t.m[b]) == square(v.in.t.t.v[b], v.in.t.m[c]) ? 1 : 0;
    return kernel(v);
  });
  EXPECT_GT(equal, seen / 5);
}

// From the clock that takes the first triangle to the one in which the last one that comes of so many leaves.
std::uint64_t clocks_of(int pattern, std::uint64_t count) {
  const auto shape = [&](vector& v, generator& g) {
    on_the_map(v, g);
    split_edges(v, pattern);
  };
  return stream_test<Vtessellate, vector>({0, 0, 1, 1}, shape, kernel, {}, count);
}

TEST(tessellate, a_triangle_a_clock) {
  constexpr std::uint64_t latency = 5, decided = 14;
  for (const int pattern : {0b000, 0b001, 0b010, 0b100, 0b111}) {
    const std::uint64_t children = pattern == 0b111 ? 4 : pattern == 0 ? 1 : 2;
    EXPECT_EQ(clocks_of(pattern, 1), latency + children) << pattern;
    EXPECT_EQ(clocks_of(pattern, 1000), latency + 1000 * children) << pattern;
  }
  for (const int pattern : {0b011, 0b101, 0b110}) {
    EXPECT_EQ(clocks_of(pattern, 1), decided + 2) << pattern;
    EXPECT_EQ(clocks_of(pattern, 1000), decided + 2 + 999 * 3) << pattern;
  }
}

}  // namespace
}  // namespace relievo::test

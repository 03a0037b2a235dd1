// tessellate: the circuit equals the kernel, eight clocks later, in every triangle that there is; anywhere, near equal diagonals, and
// where the order by value decides between them.
#include "Vtessellate.h"
#include "hls/edge/tessellate.hpp"
#include "tests/support/pipeline.hpp"
#include "tests/support/shapes.hpp"

namespace relievo::test {
namespace {

struct vector {
  hls::tessellate_in in;
  hls::map_regs map;
  hls::fixed<formats::generation> max_generation;
  RELIEVO_FIELDS(in, map, max_generation)
};
constexpr int latency = 8;

hls::tessellate_out kernel(vector const& v) {
  hls::tessellate_out out{};
  hls::tessellate(v.in, v.map, v.max_generation, out);
  return out;
}

// Triangles from count on say nothing.
testing::AssertionResult same_triangles(hls::tessellate_out const& rtl, hls::tessellate_out const& hls) {
  if (raw(rtl.count) != raw(hls.count)) return testing::AssertionFailure() << raw(rtl.count) << " triangles against " << raw(hls.count);
  for (int i = 0; i < raw(hls.count); ++i) {
    const auto result = same_words(rtl.t[i], hls.t[i]);
    if (!result) return testing::AssertionFailure() << "triangle " << i << " of " << raw(hls.count) << ", " << result.message();
  }
  return testing::AssertionSuccess();
}

// What the engine can ask: at least one split edge, and those below the limit.
void askable(vector& v, generator& g) {
  if (raw(v.map.width) < 1 || raw(v.map.width) > 8192) size_within(v.map.width, 8192, g);
  if (raw(v.map.height) < 1 || raw(v.map.height) > 8192) size_within(v.map.height, 8192, g);
  for (auto* vertices : {v.in.t.v, v.in.m})
    for (int i = 0; i < 3; ++i) coordinates_within(vertices[i].u, v.map, g);
  if (!v.in.split[0] && !v.in.split[1] && !v.in.split[2]) v.in.split[g.below(3)] = true;
  if (raw(v.max_generation) == 0) v.max_generation = hls::from_raw<formats::generation>(1);
  for (int i = 0; i < 3; ++i)
    if (v.in.split[i]) v.in.t.generation[i] = hls::from_raw<formats::generation>(raw(v.in.t.generation[i]) % raw(v.max_generation));
}

// Two splits and the quad a rectangle anywhere in space, of any turn, mostly exact, sometimes off by an LSB; sometimes its ends agree
// in what comes first in their order.
void near_equal_diagonals(vector& v, generator& g) {
  askable(v, g);
  const std::uint64_t whole = g.below(3);
  for (std::uint64_t i = 0; i < 3; ++i) {
    v.in.split[i] = i != whole;
    v.in.t.generation[i] = hls::from_raw<formats::generation>(0);
  }
  auto &a = v.in.t.v[whole], &b = v.in.t.v[(whole + 1) % 3], &p = v.in.m[(whole + 1) % 3], &q = v.in.m[(whole + 2) % 3];
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

TEST(tessellate, rtl_equals_hls) { pipeline_test<Vtessellate, vector>(latency, askable, kernel, same_triangles); }
TEST(tessellate, rtl_equals_hls_near_equal_diagonals) {
  std::uint64_t equal = 0, seen = 0;
  pipeline_test<Vtessellate, vector>(
      latency, near_equal_diagonals,
      [&](vector const& v) {
        int whole = 0;
        while (v.in.split[whole]) ++whole;
        const auto square = [](hls::vertex const& a, hls::vertex const& b) { return raw(hls::detail::squared_distance(a, b)); };
        const int b = (whole + 1) % 3, c = (whole + 2) % 3;
        ++seen;
        equal += square(v.in.t.v[whole], v.in.m[b]) == square(v.in.t.v[b], v.in.m[c]) ? 1 : 0;
        return kernel(v);
      },
      same_triangles);
  EXPECT_GT(equal, seen / 5);
}

}  // namespace
}  // namespace relievo::test

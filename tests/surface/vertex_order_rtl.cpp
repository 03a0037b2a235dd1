// vertex_order: the circuit equals the kernel's precedes, two clocks later; anywhere, and on pairs that differ in few words or only by
// the side of a seam.
#include "Vvertex_order.h"
#include "hls/surface/vertex.hpp"
#include "tests/support/pipeline.hpp"
#include "tests/support/shapes.hpp"

namespace relievo::test {
namespace {

struct pair_of_vertices {
  hls::vertex a, b;
  RELIEVO_FIELDS(a, b)
};
struct order {
  bool precedes;
  RELIEVO_FIELDS(precedes)
};
struct vector {
  pair_of_vertices in;
  hls::map_regs map;
  RELIEVO_FIELDS(in, map)
};
struct order_ports {
  void in(Vvertex_order& model, pair_of_vertices const& word) const {
    tb::put(model.a_i, word.a);
    tb::put(model.b_i, word.b);
  }
  template <class Out>
  Out out(Vvertex_order const& model) const {
    return tb::get<Out>(model.precedes_o);
  }
};
constexpr int latency = 2;

order kernel(vector const& v) { return {precedes(v.in.a, v.in.b, v.map)}; }

void within(vector& v, generator& g) {
  if (raw(v.map.width) < 1 || raw(v.map.width) > 8192) size_within(v.map.width, 8192, g);
  if (raw(v.map.height) < 1 || raw(v.map.height) > 8192) size_within(v.map.height, 8192, g);
  coordinates_within(v.in.a.u, v.map, g);
  coordinates_within(v.in.b.u, v.map, g);
}

// b becomes a but for one word, and often for a later word that says the opposite; texture coordinates often sit on the seam.
void nearly_equal(vector& v, generator& g) {
  within(v, g);
  hls::vertex const drawn = v.in.b;
  hls::vertex &a = v.in.a, &b = v.in.b;
  for (int i = 0; i < 2; ++i)
    if (g.chance(3)) a.u[i] = hls::from_raw<formats::coordinate>(0);
  for (int i = 0; i < 3; ++i) {
    b.p[i] = a.p[i];
    b.n[i] = a.n[i];
    b.t[i] = a.t[i];
    b.u[i / 2] = a.u[i / 2];
  }
  for (std::uint64_t words = g.below(3); words-- > 0;) {
    const std::uint64_t axis = g.below(3);
    switch (g.below(4)) {
      case 0:
        near(b.p[axis], a.p[axis], 1, g);
        break;
      case 1:
        b.n[axis] = drawn.n[axis];
        break;
      case 2:
        near(b.t[axis], a.t[axis], 1, g);
        break;
      default:
        b.u[axis % 2] = drawn.u[axis % 2];
        break;
    }
  }
  for (auto* w : {&a, &b}) {
    if (v.map.wrap_u && g.chance(4)) w->u[0] = hls::from_raw<formats::coordinate>(coordinate_limit(v.map.width, true));
    if (v.map.wrap_v && g.chance(4)) w->u[1] = hls::from_raw<formats::coordinate>(coordinate_limit(v.map.height, true));
  }
}

TEST(vertex_order, rtl_equals_hls) { pipeline_test<Vvertex_order, vector>(latency, within, kernel, detail::all_words(), order_ports()); }
TEST(vertex_order, rtl_equals_hls_on_near_ties) {
  std::uint64_t seams = 0, positive = 0, seen = 0;
  pipeline_test<Vvertex_order, vector>(
      latency, nearly_equal,
      [&](vector const& v) {
        const order out = kernel(v);
        ++seen;
        positive += out.precedes ? 1 : 0;
        const bool differ = raw(v.in.a.u[0]) != raw(v.in.b.u[0]) || raw(v.in.a.u[1]) != raw(v.in.b.u[1]);
        seams += differ && !out.precedes && !kernel({{v.in.b, v.in.a}, v.map}).precedes ? 1 : 0;
        return out;
      },
      detail::all_words(), order_ports());
  EXPECT_GT(positive, seen / 10);
  EXPECT_LT(positive, seen * 9 / 10);
  EXPECT_GT(seams, seen / 100);
}

}  // namespace
}  // namespace relievo::test

// vertex: the order by value. hls equals golden; it is a strict order, sees one LSB of every field it names and none of the others, and
// takes the two sides of a wrap seam for one.
#include "hls/surface/vertex.hpp"

#include <gtest/gtest.h>

#include "golden/surface/vertex.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

struct pair_of_vertices {
  hls::vertex a, b;
  hls::map_regs map;
  RELIEVO_FIELDS(a, b, map)
};

void within(pair_of_vertices& v, generator& g) {
  size_within(v.map.width, 8192, g);
  size_within(v.map.height, 8192, g);
  coordinates_within(v.a.u, v.map, g);
  coordinates_within(v.b.u, v.map, g);
}

// b becomes a but for one word, so that every level of the order decides; texture coordinates often sit on the seam.
void nearly_equal(pair_of_vertices& v, generator& g) {
  within(v, g);
  if (g.chance(2)) v.a.u[g.below(2)] = hls::from_raw<formats::coordinate>(0);
  const hls::vertex drawn = v.b;
  v.b = v.a;
  const std::uint64_t axis = g.below(3);
  switch (g.below(8)) {
    case 0:
      v.b.p[axis] = drawn.p[axis];
      break;
    case 1:
      v.b.n[axis] = drawn.n[axis];
      break;
    case 2:
      v.b.t[axis] = drawn.t[axis];
      break;
    case 3:
      v.b.u[axis / 2] = drawn.u[axis / 2];
      break;
    case 4:
      near(v.b.p[axis], v.a.p[axis], 1, g);
      break;
    case 5:
      if (v.map.wrap_u) v.b.u[0] = hls::from_raw<formats::coordinate>(coordinate_limit(v.map.width, true));
      break;
    case 6:
      if (v.map.wrap_v) v.b.u[1] = hls::from_raw<formats::coordinate>(coordinate_limit(v.map.height, true));
      if (g.chance(2)) v.b.u[0] = drawn.u[0];
      break;
    default:
      break;
  }
}

testing::AssertionResult hls_equals_golden(pair_of_vertices const& v) {
  const auto map = as_golden<golden::map_regs>(v.map);
  const auto a = as_golden<golden::vertex>(v.a), b = as_golden<golden::vertex>(v.b);
  const bool forward = precedes(v.a, v.b, v.map), backward = precedes(v.b, v.a, v.map);
  if (forward && backward) return testing::AssertionFailure() << "each precedes the other";
  if (forward != precedes(a, b, map)) return testing::AssertionFailure() << "hls says " << forward << " to a < b";
  if (backward != precedes(b, a, map)) return testing::AssertionFailure() << "hls says " << backward << " to b < a";
  if (precedes(v.a, v.a, v.map)) return testing::AssertionFailure() << "a precedes itself";
  return testing::AssertionSuccess();
}

TEST(vertex, hls_equals_golden) { for_vectors<pair_of_vertices>(within, hls_equals_golden); }
TEST(vertex, hls_equals_golden_on_near_ties) { for_vectors<pair_of_vertices>(nearly_equal, hls_equals_golden); }

hls::vertex plain() {
  hls::vertex v{};
  for (auto& u : v.u) u = hls::from_raw<formats::coordinate>(2048);
  return v;
}
const hls::map_regs clamped = {hls::from_raw<formats::map_size>(16), hls::from_raw<formats::map_size>(16), false, false};
const hls::map_regs wrapped = {hls::from_raw<formats::map_size>(16), hls::from_raw<formats::map_size>(16), true, true};

// a before b by the one word that `up` raises.
template <class Up>
void expect_order(Up up) {
  hls::vertex a = plain(), b = plain();
  up(b);
  EXPECT_TRUE(precedes(a, b, clamped));
  EXPECT_FALSE(precedes(b, a, clamped));
}

TEST(vertex, one_lsb_of_every_named_field_decides) {
  for (int i = 0; i < 3; ++i) {
    expect_order([i](hls::vertex& v) { v.p[i] = hls::from_raw<formats::position>(1); });
    expect_order([i](hls::vertex& v) { v.n[i] = hls::from_raw<formats::unit>(1); });
    expect_order([i](hls::vertex& v) { v.t[i] = hls::from_raw<formats::unit>(1); });
  }
  for (int i = 0; i < 2; ++i) expect_order([i](hls::vertex& v) { v.u[i] = hls::from_raw<formats::coordinate>(2049); });
}

TEST(vertex, earlier_fields_outrank_later_ones) {
  const auto lower_from = [](hls::vertex& v, int from) {
    for (int i = 0; i < 3; ++i) {
      if (i > from) v.p[i] = hls::from_raw<formats::position>(-1);
      if (3 + i > from) v.n[i] = hls::from_raw<formats::unit>(-1);
      if (6 + i > from) v.t[i] = hls::from_raw<formats::unit>(-1);
    }
    if (9 > from) v.u[1] = hls::from_raw<formats::coordinate>(0);
    if (10 > from) v.u[0] = hls::from_raw<formats::coordinate>(0);
  };
  for (int word = 0; word < 10; ++word) {
    hls::vertex a = plain(), b = plain();
    lower_from(b, word);
    if (word < 3) b.p[word] = hls::from_raw<formats::position>(1);
    if (word >= 3 && word < 6) b.n[word - 3] = hls::from_raw<formats::unit>(1);
    if (word >= 6 && word < 9) b.t[word - 6] = hls::from_raw<formats::unit>(1);
    if (word == 9) b.u[1] = hls::from_raw<formats::coordinate>(2049);
    EXPECT_TRUE(precedes(a, b, clamped)) << "word " << word;
    EXPECT_FALSE(precedes(b, a, clamped)) << "word " << word;
  }
}

TEST(vertex, what_was_computed_of_a_vertex_does_not_count) {
  generator g("computed");
  hls::vertex drawn{};
  for (int i = 0; i < 1000; ++i) {
    draw_vector(drawn, draw::uniform, g);
    hls::vertex a = plain(), b = drawn;
    for (int k = 0; k < 3; ++k) {
      b.p[k] = a.p[k];
      b.n[k] = a.n[k];
      b.t[k] = a.t[k];
      b.u[k / 2] = a.u[k / 2];
    }
    ASSERT_FALSE(precedes(a, b, clamped) || precedes(b, a, clamped));
  }
}

TEST(vertex, both_sides_of_a_seam_are_equal) {
  for (int axis = 0; axis < 2; ++axis) {
    hls::vertex a = plain(), b = plain();
    a.u[axis] = hls::from_raw<formats::coordinate>(0);
    b.u[axis] = hls::from_raw<formats::coordinate>(16 * 2048);
    EXPECT_FALSE(precedes(a, b, wrapped) || precedes(b, a, wrapped));
    EXPECT_TRUE(precedes(a, b, clamped));
    b.u[axis] = hls::from_raw<formats::coordinate>(16 * 2048 - 1);
    EXPECT_TRUE(precedes(a, b, wrapped));
  }
}

}  // namespace
}  // namespace relievo::test

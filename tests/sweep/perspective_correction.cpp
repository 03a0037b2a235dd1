// perspective_correction: hls equals golden; near the exact quotients of its words (how near to the surface: vertex_data_ideal.cpp); what
// saturates and what does not; the limit; c is above 0 for all w.
#include "hls/sweep/perspective_correction.hpp"

#include <gtest/gtest.h>

#include "golden/sweep/perspective_correction.hpp"
#include "tests/support/swept_data.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::perspective_correction_in, hls::perspective_correction_regs>;

template <class F>
long double value(hls::fixed<F> x) {
  return std::ldexp(static_cast<long double>(raw(x)), -F::fraction);
}
template <class F>
constexpr long double lsb_of = std::int64_t{1} / static_cast<long double>(std::int64_t{1} << F::fraction);

// Words of a vertex: c in (0, 1] and a little above, and in one of two the attributes are within their formats.
void domain(vector& v, generator& g) {
  auto& c = v.in.v.c;
  const std::int64_t one = std::int64_t{1} << formats::step_c::fraction;
  std::int64_t word = raw(c) & (2 * one - 1);
  if (word > one + one / 1024 || word == 0) word = (word & (one - 1)) + 1;
  if (!g.chance(4)) word = std::max<std::int64_t>(word >> g.below(16), 1);
  c = hls::from_raw<formats::step_c>(word);
  if (g.chance(2)) return;
  const hls::base_vertex given = draw_vertex(g);
  hls::for_attributes(
      [&](auto& x, auto const& a) {
        using step = typename std::remove_reference_t<decltype(x)>::format_type;
        x = hls::from_raw<step>(std::llround(std::ldexp(value(a) * value(c), step::fraction)) + g.between(-4, 4));
      },
      v.in.v, given);
}

// s0_c and s1_w are right to 2^-25 of themselves each; s1_x to half an LSB, times at most 2; s2 to half an LSB.
template <class Interp, class Out>
long double bound(long double exact) {
  return std::abs(exact) * std::ldexp(1.0L, -24) * 1.0000002L + lsb_of<Interp> + lsb_of<Out> / 2;
}

testing::AssertionResult near_the_quotient(vector const& v) {
  const auto out = hls::perspective_correction(v.in, v.regs);
  const auto fails = [&](char const* what) { return testing::AssertionFailure() << what << "\n" << describe(out); };
  const long double c = value(v.in.v.c);
  const long double normalised = std::ldexp(c, static_cast<int>(raw(out.shift)));
  if (c < 1 ? normalised < 0.5L || normalised >= 1 : raw(out.shift) != 0) return fails("the shift");
  if (std::abs(value(out.w_correction) * normalised - 1) > std::ldexp(1.0L, -24)) return fails("1/c");
  if (out.saturated) return testing::AssertionSuccess();
  for (int i = 0; i < 3; ++i) {
    const long double p = value(v.in.v.p[i]) / c;
    if (std::abs(value(out.p[i]) - p) > bound<formats::interp_position, formats::position>(p)) return fails("p");
  }
  for (int i = 0; i < 2; ++i) {
    const long double u = value(v.in.v.u[i]) / c, right = std::min(std::max(u, 0.0L), value(v.regs.limit[i]));
    if (out.u[i] > v.regs.limit[i]) return fails("u beyond the limit");
    if (std::abs(value(out.u[i]) - right) > bound<formats::interp_coordinate, formats::coordinate>(u)) return fails("u");
  }
  for (int i = 0; i < 4; ++i) {
    const long double colour = value(v.in.v.colour[i]) / c;
    if (std::abs(value(out.colour[i]) - std::max(colour, 0.0L)) > bound<formats::interp_colour, formats::colour>(colour))
      return fails("colour");
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult agrees(vector const& v) {
  return equal_words(hls::perspective_correction(v.in, v.regs),
                     golden::perspective_correction(as_golden<golden::perspective_correction_in>(v.in),
                                                    as_golden<golden::perspective_correction_regs>(v.regs)));
}

TEST(perspective_correction, hls_equals_golden) { for_vectors<vector>(domain, agrees); }

TEST(perspective_correction, is_near_the_quotient_of_its_words) { for_vectors<vector>(domain, near_the_quotient, vector_count() / 4); }

hls::perspective_correction_regs whole_range() {
  const auto most = hls::from_raw<formats::coordinate>(hls::fixed<formats::coordinate>::max_raw);
  return {{most, most}};
}

// A vertex with c = 1/2: attributes of twice what the words say.
vector half() {
  vector v{};
  v.in.v.c = hls::from_raw<formats::step_c>(std::int64_t{1} << (formats::step_c::fraction - 1));
  v.in.v.n[2] = hls::from_raw<formats::step_unit>(std::int64_t{1} << (formats::step_unit::fraction - 1));
  v.in.v.t[0] = hls::from_raw<formats::step_unit>(std::int64_t{1} << (formats::step_unit::fraction - 1));
  v.regs = whole_range();
  return v;
}

TEST(perspective_correction, saturation_is_counted_and_what_is_none_is_not) {
  const auto saturated = [](vector const& v) { return hls::perspective_correction(v.in, v.regs).saturated; };
  EXPECT_FALSE(saturated(half()));
  vector p = half();
  p.in.v.p[1] = hls::from_raw<formats::step_position>(std::int64_t{4} << formats::step_position::fraction);
  EXPECT_TRUE(saturated(p)) << "8 is no position";
  p.in.v.p[1] = hls::from_raw<formats::step_position>(-(std::int64_t{4} << formats::step_position::fraction));
  EXPECT_FALSE(saturated(p)) << "-8 is one";
  vector u = half();
  u.in.v.u[0] = hls::from_raw<formats::step_coordinate>(-(std::int64_t{1} << formats::step_coordinate::fraction));
  EXPECT_FALSE(saturated(u));
  EXPECT_EQ(raw(hls::perspective_correction(u.in, u.regs).u[0]), 0);
  u.in.v.u[0] = hls::from_raw<formats::step_coordinate>(std::int64_t{100} << formats::step_coordinate::fraction);
  u.regs.limit[0] = hls::from_raw<formats::coordinate>(std::int64_t{199} << formats::coordinate::fraction);
  EXPECT_FALSE(saturated(u)) << "the limit is no saturation";
  EXPECT_EQ(raw(hls::perspective_correction(u.in, u.regs).u[0]), raw(u.regs.limit[0]));
  u.regs.limit[0] = hls::from_raw<formats::coordinate>(std::int64_t{201} << formats::coordinate::fraction);
  EXPECT_EQ(raw(hls::perspective_correction(u.in, u.regs).u[0]), std::int64_t{200} << formats::coordinate::fraction);
  vector colour = half();
  colour.in.v.colour[3] = hls::from_raw<formats::step_colour>(-1);
  EXPECT_FALSE(saturated(colour));
  colour.in.v.colour[3] = hls::from_raw<formats::step_colour>(std::int64_t{1} << formats::step_colour::fraction);
  EXPECT_TRUE(saturated(colour)) << "2 is no colour";
}

TEST(perspective_correction, normals_and_tangents_are_of_length_1) {
  for_vectors<vector>(
      domain,
      [](vector const& v) {
        const auto out = hls::perspective_correction(v.in, v.regs);
        for (auto const& n : {out.n, out.t}) {
          const long double square = value(n[0]) * value(n[0]) + value(n[1]) * value(n[1]) + value(n[2]) * value(n[2]);
          if (std::abs(square - 1) > 2 * 1.7321L / (1 << 15) + 1e-8L)
            return testing::AssertionFailure() << "length " << std::sqrt(static_cast<double>(square));
        }
        return testing::AssertionSuccess();
      },
      vector_count() / 10);
  const vector nothing = [] {
    vector v = half();
    v.in.v.n[2] = v.in.v.t[0] = {};
    return v;
  }();
  const auto out = hls::perspective_correction(nothing.in, nothing.regs);
  EXPECT_EQ(raw(out.n[2]), 1 << 14);
  EXPECT_EQ(raw(out.t[0]), 1 << 14);
}

// From raw w = 2 on every block has c above 0 at its farthest corner, and so at whatever lies between its corners.
TEST(perspective_correction, c_is_above_0_for_all_w) {
  const auto depth = [](std::int64_t w) { return hls::from_raw<formats::depth>(w); };
  const depth_word farthest = depth(hls::fixed<formats::depth>::max_raw);
  for (int bit = 1; bit < 28; ++bit)
    for (const std::int64_t nearest : {std::int64_t{1} << bit, (std::int64_t{2} << bit) - 1}) {
      const auto block = hls::block_exponent(depth(nearest), farthest);
      EXPECT_GT(raw(hls::perspective_preparation({{}, farthest, block}).c), 0) << "w from " << nearest << " on";
    }
}

}  // namespace
}  // namespace relievo::test

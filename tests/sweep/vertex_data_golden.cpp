// vertex_data_golden: each register of the sweep's vertex data against whole numbers of 128 bits, in golden alone: w, c and the products,
// the steps with the smallest determinants and with ties, the correction and what saturates.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/swept_vertices.hpp"

namespace relievo::test {
namespace {

using namespace golden;
using golden::detail::int128;

// q is floor(numerator / divisor + 1/2).
bool is_nearest(int128 numerator, int128 divisor, std::int64_t q) {
  if (divisor < 0) return is_nearest(-numerator, -divisor, q);
  const int128 twice = 2 * static_cast<int128>(q);
  return (twice - 1) * divisor <= 2 * numerator && 2 * numerator < (twice + 1) * divisor;
}
// floor(x / 2^shift + 1/2)
std::int64_t shifted(int128 x, int shift) { return static_cast<std::int64_t>((x + (static_cast<int128>(1) << (shift - 1))) >> shift); }

void expect_prepared(perspective_preparation_in const& in) {
  const interpolants out = perspective_preparation(in);
  const std::int64_t w = word<formats::depth>(in.w);
  int leading = 27;
  while (w >> leading == 0) --leading;
  const int cut = std::max(leading - 23, 0);
  const std::int64_t m = cut == 0 ? w : (w + (std::int64_t{1} << (cut - 1))) >> cut << cut;
  const std::int64_t c = word<formats::inverse_w>(out.c);
  ASSERT_TRUE(is_nearest(static_cast<int128>(1) << (in.exponent + 26), m, c)) << "w " << w << " c " << c;
  ASSERT_LE(c, std::int64_t{1} << 26);
  each_attribute(
      [c](auto f, double const& given, double const& interpolant) {
        using F = decltype(f);
        const int shift = F::given::fraction + formats::inverse_w::fraction - F::interp::fraction;
        EXPECT_EQ(word<typename F::interp>(interpolant), shifted(static_cast<int128>(word<typename F::given>(given)) * c, shift));
      },
      in.vertex, out);
}

TEST(vertex_data_golden, w_c_and_the_products_are_rounded_once) {
  draw d(seed());
  const double lsb = range_of<formats::depth>::lsb;
  base_vertex extreme[2];
  each_attribute(
      [](auto f, double& low, double& high) {
        using G = typename decltype(f)::given;
        low = range_of<G>::min;
        high = range_of<G>::max;
      },
      extreme[0], extreme[1]);
  for (int k = 0; k < 28; ++k)
    for (int off = -9; off <= 9; ++off) {
      const std::int64_t w = (std::int64_t{1} << k) + off;
      if (w < 1 || w >= std::int64_t{1} << 28) continue;
      for (int block = 0; block <= block_exponent(static_cast<double>(w) * lsb); ++block)
        for (base_vertex const& v : extreme) expect_prepared({v, static_cast<double>(w) * lsb, block});
    }
  expect_prepared({extreme[1], range_of<formats::depth>::max, 27});
  for (std::uint64_t i = 0; i < rounds(10); ++i) {
    const auto w = static_cast<double>((std::int64_t{1} << 27 | d.integer(0, (1 << 27) - 1)) >> d.integer(0, 27)) * lsb;
    expect_prepared({draw_base_vertex(d), w, d.integer(0, block_exponent(w))});
    if (HasFailure()) return;
  }
}

// The nearest and the farthest corner in one block. w = 1 LSB is nearer than any w_min.
TEST(vertex_data_golden, c_is_above_zero) {
  const double lsb = range_of<formats::depth>::lsb, far = range_of<formats::depth>::max;
  for (int near = 2; near < 5000; ++near) {
    const int block = block_exponent(far, near * lsb);
    ASSERT_GT(perspective_preparation({{}, far, block}).c, 0) << near;
    ASSERT_LE(perspective_preparation({{}, near * lsb, block}).c, 1) << near;
  }
  EXPECT_EQ(perspective_preparation({{}, far, block_exponent(lsb, far)}).c, 0);
}

void expect_steps(base_triangle const& triangle) {
  const swept_vertices<rounded> swept(triangle);
  interpolated_vertex_in const& in = swept.setup();
  for (int e = 0; e < 3; ++e) {
    const auto n = static_cast<std::int64_t>(swept.steps_of(e));
    each_component(
        [n](auto f, double const& from, double const& to, double const& step) {
          using F = decltype(f);
          const std::int64_t d = word<typename F::step>(step);
          const int128 rise = static_cast<int128>(word<typename F::interp>(to) - word<typename F::interp>(from)) * 65536;
          ASSERT_TRUE(n == 0 ? d == 0 : is_nearest(rise, n, d)) << n;
        },
        in.end[e][0], in.end[e][1], in.difference.edge[e]);
  }
  const int s = in.plane.s, t = in.plane.t;
  const glm::dvec3 ab = in.p[in.plane.b] - in.p[in.plane.a], ac = in.p[in.plane.c] - in.p[in.plane.a];
  const auto s_ab = static_cast<int128>(ab[s]), t_ab = static_cast<int128>(ab[t]);
  const auto s_ac = static_cast<int128>(ac[s]), t_ac = static_cast<int128>(ac[t]);
  const int128 det = s_ab * t_ac - s_ac * t_ab;
  const bool used = (det < 0 ? -det : det) > s_ab;
  each_component(
      [&](auto f, double const& va, double const& vb, double const& vc, double const& sweep, double const& side) {
        using F = decltype(f);
        const std::int64_t a = word<typename F::interp>(va), along = word<typename F::step>(sweep), across = word<typename F::step>(side);
        const int128 v_ab = (word<typename F::interp>(vb) - a) * 65536, v_ac = (word<typename F::interp>(vc) - a) * 65536;
        ASSERT_TRUE(used ? is_nearest(v_ab * t_ac - v_ac * t_ab, det, along) : along == 0);
        ASSERT_TRUE(used ? is_nearest(v_ac * s_ab - v_ab * s_ac, det, across) : across == 0);
      },
      in.corner[in.plane.a], in.corner[in.plane.b], in.corner[in.plane.c], in.difference.sweep, in.difference.side);
}

TEST(vertex_data_golden, steps_are_rounded_once_and_fit_their_words) {
  draw d(seed());
  generator g("steps");
  for (std::uint64_t i = 0; i < rounds(20) && !HasFailure(); ++i) expect_steps(draw_any(d, g));
  // A determinant of 2^17, or of -2^17: every odd numerator is a tie, and goes up.
  for (int i = 0; i < 200; ++i) {
    const int mirror = i % 2 == 0 ? 1 : -1;
    const base_triangle tie = draw_base_triangle(d, {{{0, 0, 0}, {512, 512 * mirror, 0}, {1, 257 * mirror, 0}}}, 1e4);
    EXPECT_EQ(swept_vertices<rounded>(tie).plane().det, mirror * 131072);
    expect_steps(tie);
  }
  // The largest differences over the smallest determinant that is used, n + 1.
  base_triangle worst;
  for (double& w : worst.w) w = range_of<formats::depth>::lsb;
  each_attribute(
      [](auto f, double& low, double& high, double& other) {
        low = range_of<typename decltype(f)::given>::min;
        high = other = range_of<typename decltype(f)::given>::max;
      },
      worst.vertex[0], worst.vertex[1], worst.vertex[2]);
  for (int turn = 0; turn < 6; ++turn) {
    if (turn == 3) worst.vertex[2] = base_vertex();
    for (const int n : {3, 7, 99, 16383}) {
      const int half = (n + 1) / 2;
      to_grid({{{0, 0, 0}, {n, -1, 0}, {1, 1, 0}}}, worst.p);
      expect_steps(worst);
      to_grid({{{0, 0, 0}, {n, half, 0}, {n - 2, half, 0}}}, worst.p);
      expect_steps(worst);
      EXPECT_EQ(std::abs(swept_vertices<rounded>(worst).plane().det), n + 1);
    }
    std::rotate(worst.vertex, worst.vertex + 1, worst.vertex + 3);
  }
}

TEST(vertex_data_golden, the_correction_is_rounded_at_each_register) {
  draw d(seed());
  for (std::uint64_t i = 0; i < rounds(10) && !HasFailure(); ++i) {
    vertex_steps v;
    const std::int64_t c = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::exp2(d.real(0, 42))));
    v.c = static_cast<double>(i == 0 ? std::int64_t{1} << 42 : c) * range_of<formats::step_c>::lsb;
    each_attribute(
        [&](auto f, double& x) {
          x = rounded::at<typename decltype(f)::step>(v.c * d.real(-1, 1) * range_of<typename decltype(f)::given>::max * 1.1);
        },
        v);
    const glm::dvec2 limit(d.integer(0, 8192), d.integer(0, 8192));
    const auto out = perspective_correction({v}, {limit});
    int shift = 0;
    while (shift < 41 && word<formats::step_c>(v.c) << shift < std::int64_t{1} << 41) ++shift;
    ASSERT_EQ(out.shift, shift);
    const std::int64_t s0 = shifted(static_cast<int128>(word<formats::step_c>(v.c)) << shift, 17);
    const std::int64_t w = word<formats::correction>(out.w_correction);
    ASSERT_TRUE(is_nearest(static_cast<int128>(1) << 49, s0, w));
    bool saturated = false;
    const auto limited = [&saturated](auto f, std::int64_t x) {
      using range = range_of<decltype(f)>;
      const auto top = static_cast<std::int64_t>(range::raw_max), bottom = static_cast<std::int64_t>(range::raw_min);
      saturated |= x > top || (x < bottom && decltype(f)::is_signed);
      return std::min(std::max(x, bottom), top);
    };
    const auto expected = [&](auto f, auto to, double x) {
      using F = decltype(f);
      using To = decltype(to);
      const std::int64_t s1 = limited(typename F::interp{}, shifted(static_cast<int128>(word<typename F::step>(x)) << shift, 16));
      const int fraction = F::interp::fraction + formats::correction::fraction;
      return limited(to, shifted(static_cast<int128>(s1) * w, fraction - To::fraction));
    };
    normalize_in n, t;
    t.tangent = true;
    for (int k = 0; k < 3; ++k) {
      ASSERT_EQ(word<formats::position>(out.p[k]), expected(position_formats{}, formats::position{}, v.p[k]));
      n.v[k] = static_cast<double>(expected(unit_formats{}, formats::direction{}, v.n[k])) * range_of<formats::direction>::lsb;
      t.v[k] = static_cast<double>(expected(unit_formats{}, formats::direction{}, v.t[k])) * range_of<formats::direction>::lsb;
    }
    for (int k = 0; k < 2; ++k)
      ASSERT_EQ(word<formats::coordinate>(out.u[k]), std::min(expected(coordinate_formats{}, formats::coordinate{}, v.u[k]),
                                                              static_cast<std::int64_t>(limit[k]) << formats::coordinate::fraction));
    for (int k = 0; k < 4; ++k) ASSERT_EQ(word<formats::colour>(out.colour[k]), expected(colour_formats{}, formats::colour{}, v.colour[k]));
    ASSERT_EQ(out.n, normalize<rounded>(n).n);
    ASSERT_EQ(out.t, normalize<rounded>(t).n);
    ASSERT_EQ(out.saturated, saturated);
  }
}

TEST(vertex_data_golden, a_corner_is_not_interpolated) {
  draw d(seed());
  generator g("corner");
  const swept_vertices<rounded> swept(draw_any(d, g));
  EXPECT_THROW(swept.at({kind_corner, 0, 0, 0, 0}), std::logic_error);
}

}  // namespace
}  // namespace relievo::test

// vertex_data_ideal: the ideal against perspective interpolation written plainly, and golden within its bound of the ideal, on edges and
// within, with w_max / w_min up to 10^4 (docs/error_budget.md, "The sweep").
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "tests/support/swept_vertices.hpp"

namespace relievo::test {
namespace {

using namespace golden;

// Perspective interpolation as in the textbooks: sum b a / w over sum b / w.
struct plain_interpolation {
  base_triangle const& triangle;
  long double b[3];

  template <class Pick>
  long double of(Pick pick) const {
    long double sum = 0, inverse = 0;
    for (int i = 0; i < 3; ++i) {
      sum += b[i] * pick(triangle.vertex[i]) / triangle.w[i];
      inverse += b[i] / triangle.w[i];
    }
    return sum / inverse;
  }
};

TEST(vertex_data_ideal, the_ideal_is_perspective_interpolation) {
  draw d(seed());
  generator g("ideal");
  double most = 0;
  std::uint64_t tried = 0;
  for (std::uint64_t i = 0; i < rounds(10); ++i) {
    const base_triangle triangle = draw_any(d, g);
    const swept_vertices<exact> ideal(triangle);
    remeshed_vertex name;
    if (!ideal.draw_name(d, name)) continue;
    ++tried;
    plain_interpolation plain{triangle, {}};
    ideal.weights(name, plain.b);
    const auto out = ideal.corrected(name);
    // Double's own noise: on thin triangles the products are larger than their sum, and 1/c enlarges all of it.
    const double reach = name.kind == kind_edge ? 1 : 1 + ideal.n() * ideal.n() / std::abs(ideal.plane().det);
    const double noise = std::ldexp(8 * reach / ideal.at(name).c, -52);
    const auto near = [&](double x, long double y, double size) {
      const double error = static_cast<double>(std::abs(static_cast<long double>(x) - y)) / size;
      most = std::max(most, error / noise);
      return error <= noise;
    };
    glm::dvec3 n, t;
    for (int k = 0; k < 3; ++k) {
      ASSERT_TRUE(near(out.p[k], plain.of([k](base_vertex const& v) { return v.p[k]; }), 4));
      n[k] = static_cast<double>(plain.of([k](base_vertex const& v) { return v.n[k]; }));
      t[k] = static_cast<double>(plain.of([k](base_vertex const& v) { return v.t[k]; }));
    }
    const glm::dvec3 n_to = glm::normalize(n), t_to = glm::normalize(t);
    for (int k = 0; k < 3; ++k) {
      ASSERT_TRUE(near(out.n[k], n_to[k], 4 / glm::length(n)));
      ASSERT_TRUE(near(out.t[k], t_to[k], 4 / glm::length(t)));
    }
    for (int k = 0; k < 2; ++k) ASSERT_TRUE(near(out.u[k], plain.of([k](base_vertex const& v) { return v.u[k]; }), 8192));
    for (int k = 0; k < 4; ++k) ASSERT_TRUE(near(out.colour[k], plain.of([k](base_vertex const& v) { return v.colour[k]; }), 1));
  }
  std::printf("%llu vertices, %.3g of double's noise\n", static_cast<unsigned long long>(tried), most);
  EXPECT_GT(tried, rounds(10) / 4);
}

// Of one component: the formula in golden/sweep/perspective_correction.hpp, with the factors that this vertex really has.
struct path_error {
  double q, steps, correction;

  template <class Formats, class Out>
  double bound(double x, double range) const {
    const double h = range_of<typename Formats::interp>::lsb, lost = std::ldexp(steps / 2, -guard_bits);
    const double along = q * (h * (0.5 + lost) + std::abs(x) * std::ldexp(lost, -26) + std::ldexp(range, -27));
    const double back = correction * h / 2 + std::abs(x) * (std::ldexp(correction, -26) + std::ldexp(1 / correction, -25));
    return (along + back + std::ldexp(range, -25)) * (1 + 1e-3) + range_of<Out>::lsb / 2;
  }
  // The same as the header has it, for any vertex so far away.
  template <class Formats, class Out>
  static double simple(double x, double range, double far) {
    const double h = range_of<typename Formats::interp>::lsb;
    return (0.75 * h + std::ldexp(std::abs(x), -28) + std::ldexp(range, -27)) * far + h + 1.5 * std::ldexp(std::abs(x), -25) +
           std::ldexp(range, -25) + range_of<Out>::lsb / 2;
  }
};

class error_meter {
 public:
  void triangle(draw& d, base_triangle const& triangle) {
    const swept_vertices<rounded> golden(triangle);
    const swept_vertices<exact> ideal(triangle);
    for (int i = 0; i < 4; ++i) {
      remeshed_vertex name;
      if (golden.draw_name(d, name)) vertex(triangle, golden, ideal, name);
    }
  }
  void vertex(base_triangle const& triangle, swept_vertices<rounded> const& golden, swept_vertices<exact> const& ideal,
              remeshed_vertex const& name) {
    const auto got = golden.corrected(name), right = ideal.corrected(name);
    const vertex_steps v = ideal.at(name);
    ASSERT_FALSE(got.saturated);
    ASSERT_GT(golden.at(name).c, 0);
    glm::dvec3 const& a = golden.setup().p[golden.plane().a];
    const bool grid = name.kind == kind_grid;
    const double steps = grid ? std::abs(name.s - a[golden.plane().s]) + std::abs(name.t - a[golden.plane().t]) : name.i;
    const double q = got.w_correction * power_of_two(got.shift);
    const path_error error{q, steps, got.w_correction};

    int of[3] = {0, 1, 2}, count = 3;
    if (!grid) {
      of[0] = name.number;
      of[1] = (name.number + 1) % 3;
      count = 2;
    }
    double nearest = triangle.w[of[0]];
    for (int i = 1; i < count; ++i) nearest = std::min(nearest, triangle.w[of[i]]);
    const int block = block_exponent(nearest);
    const double w = power_of_two(block - formats::depth::fraction) / v.c;
    ASSERT_LT(w / nearest, 1.01e4);
    ASSERT_LT(q, 2.002 * w / nearest);
    const auto range = [&](auto pick) {
      double low = pick(triangle.vertex[of[0]]), high = low;
      for (int i = 1; i < count; ++i) {
        low = std::min(low, pick(triangle.vertex[of[i]]));
        high = std::max(high, pick(triangle.vertex[of[i]]));
      }
      return high - low;
    };
    const auto within = [&](auto f, auto to, double x, double y, double r, std::size_t kind) {
      using F = decltype(f);
      const double bound = error.template bound<F, decltype(to)>(y, r), off = std::abs(x - y);
      share_[kind] = std::max(share_[kind], off / bound);
      double& lsb = (q < 2 ? near_ : far_)[kind];
      lsb = std::max(lsb, off / range_of<decltype(to)>::lsb);
      EXPECT_LE(bound, (path_error::simple<F, decltype(to)>(y, r, 2 * w / nearest) * 1.002));
      return off <= bound;
    };
    for (int k = 0; k < 3; ++k)
      ASSERT_TRUE(within(position_formats{}, formats::position{}, got.p[k], right.p[k], range([k](auto const& b) { return b.p[k]; }), 0));
    for (int k = 0; k < 2; ++k)
      ASSERT_TRUE(
          within(coordinate_formats{}, formats::coordinate{}, got.u[k], right.u[k], range([k](auto const& b) { return b.u[k]; }), 1));
    for (int k = 0; k < 4; ++k)
      ASSERT_TRUE(within(colour_formats{}, formats::colour{}, got.colour[k], right.colour[k],
                         range([k](auto const& b) { return b.colour[k]; }), 2));
    // As a vector: 2 |a - b| / (|a| + |b|), then half an LSB.
    const auto direction = [&](glm::dvec3 const& x, glm::dvec3 const& y, glm::dvec3 const& before, auto pick) {
      double square = 0;
      for (int k = 0; k < 3; ++k) {
        const double e =
            error.template bound<unit_formats, formats::direction>(before[k], range([&](auto const& b) { return pick(b)[k]; }));
        square += e * e;
      }
      const double moved = std::sqrt(square), length = glm::length(before);
      if (length < 4 * moved) return true;
      const double bound = 2 * moved / (2 * length - moved) + range_of<formats::unit>::lsb / 2;
      const double off = std::max({std::abs(x.x - y.x), std::abs(x.y - y.y), std::abs(x.z - y.z)});
      share_[3] = std::max(share_[3], off / bound);
      double& lsb = (q < 2 ? near_ : far_)[3];
      if (length > 0.5) lsb = std::max(lsb, off / range_of<formats::unit>::lsb);
      return off <= bound;
    };
    ASSERT_TRUE(direction(got.n, right.n, v.n / v.c, [](auto const& b) { return b.n; }));
    ASSERT_TRUE(direction(got.t, right.t, v.t / v.c, [](auto const& b) { return b.t; }));
    ++count_[grid ? 1 : 0];
    farthest_ = std::max(farthest_, w / nearest);
  }
  void finish() const {
    std::printf("%llu vertices of edges, %llu within; w / w_min up to %.0f\n", static_cast<unsigned long long>(count_[0]),
                static_cast<unsigned long long>(count_[1]), farthest_);
    char const* const names[4] = {"P", "U", "colour", "N, T"};
    for (std::size_t i = 0; i < 4; ++i) {
      std::printf("  %-6s %.3f of the bound; %.3f LSB near the eye (q < 2), %.2f beyond\n", names[i], share_[i], near_[i], far_[i]);
      EXPECT_GT(share_[i], 0.25) << "the vectors do not come near the bound";
    }
    EXPECT_GT(count_[0], 0U);
    EXPECT_GT(count_[1], 0U);
  }

 private:
  double share_[4] = {0, 0, 0, 0}, near_[4] = {0, 0, 0, 0}, far_[4] = {0, 0, 0, 0}, farthest_ = 0;
  std::uint64_t count_[2] = {0, 0};
};

TEST(vertex_data_ideal, golden_stays_within_its_bound_of_the_ideal) {
  draw d(seed());
  generator g("bound");
  error_meter near, any, far;
  for (std::uint64_t i = 0; i < rounds(100) && !HasFailure(); ++i) {
    near.triangle(d, draw_base_triangle(d, draw_grid(g), 1.5));
    any.triangle(d, draw_any(d, g));
    far.triangle(d, draw_base_triangle(d, draw_grid(g), 1e4));
  }
  near.finish();
  any.finish();
  far.finish();
}

// The one function of the grid, at the corners: A's own words, and B's and C's up to what the steps lost.
TEST(vertex_data_ideal, the_interior_function_meets_the_corners) {
  draw d(seed());
  generator g("corners");
  error_meter meter;
  for (std::uint64_t i = 0; i < rounds(100) && !HasFailure(); ++i) {
    const base_triangle triangle = draw_any(d, g);
    const swept_vertices<rounded> golden(triangle);
    const swept_vertices<exact> ideal(triangle);
    remeshing_plane_out const& plane = golden.plane();
    if (std::abs(plane.det) <= golden.n()) continue;
    for (const int corner : {plane.a, plane.b, plane.c}) {
      const remeshed_vertex name{kind_grid, 0, 0, triangle.p[corner][plane.s], triangle.p[corner][plane.t]};
      meter.vertex(triangle, golden, ideal, name);
      const auto out = golden.corrected(name);
      base_vertex const& given = triangle.vertex[corner];
      const double q = out.w_correction * power_of_two(out.shift), steps = corner == plane.a ? 0 : golden.n() * 2;
      const path_error error{q, steps, out.w_correction};
      for (int k = 0; k < 3; ++k)
        ASSERT_LE(std::abs(out.p[k] - given.p[k]), (error.bound<position_formats, formats::position>(given.p[k], 0)));
      for (int k = 0; k < 2; ++k)
        ASSERT_LE(std::abs(out.u[k] - given.u[k]), (error.bound<coordinate_formats, formats::coordinate>(given.u[k], 0)));
      const vertex_steps v = golden.at(name);
      each_component(
          [&](auto f, double const& step, double const& prepared) {
            if (corner == plane.a)
              ASSERT_EQ(step, prepared);
            else
              ASSERT_LE(std::abs(step - prepared), golden.n() * range_of<typename decltype(f)::step>::lsb);
          },
          v, golden.setup().corner[corner]);
    }
  }
}

}  // namespace
}  // namespace relievo::test

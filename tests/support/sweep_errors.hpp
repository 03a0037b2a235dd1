// sweep_errors: the sweep's rows of docs/error_budget.md. The largest error of one random vector, golden against ideal given the same
// words, in LSB of the register; tests/core/error_budget.cpp holds them against the bounds.
//
//   sweep_measurements()   "unit register" -> the measurement
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <type_traits>

#include "tests/support/swept_vertices.hpp"

namespace relievo::test {

namespace detail {

// w of any size, all 28 bits of it, in a block of its own: c in (1/2, 1].
inline golden::perspective_preparation_in draw_preparation(draw& d) {
  golden::perspective_preparation_in in;
  in.vertex = draw_base_vertex(d);
  in.vertex.p = d.words<formats::position>(-8, 8);
  in.w = d.word<formats::depth>(0.004, d.coin() ? 256 : std::exp2(d.real(-8, 8)));
  in.exponent = golden::block_exponent(in.w);
  return in;
}

template <class Formats>
double preparation_error(draw& d) {
  const auto in = draw_preparation(d);
  const auto got = golden::perspective_preparation<golden::rounded>(in), right = golden::perspective_preparation<golden::exact>(in);
  double most = 0;
  golden::each_component(
      [&most](auto f, double const& a, double const& b) {
        using F = decltype(f);
        if (std::is_same_v<F, Formats>) most = std::max(most, std::abs(a - b) / golden::range_of<typename F::interp>::lsb);
      },
      got, right);
  return most;
}

// Differences of at most 2^16 LSB: double divides them with no noise worth measuring.
inline golden::difference_vertices_in draw_differences(draw& d, int size) {
  golden::difference_vertices_in in;
  for (glm::dvec3& p : in.p) p = {d.integer(0, size), d.integer(0, size), d.integer(0, size)};
  in.plane = golden::setup_of({{in.p[0], in.p[1], in.p[2]}}).plane;
  const auto fill = [&d](golden::interpolants& v) {
    golden::each_component([&d](auto f, double& x) { x = d.integer(0, 65535) * golden::range_of<typename decltype(f)::interp>::lsb; }, v);
  };
  for (int i = 0; i < 3; ++i) {
    fill(in.corner[i]);
    for (golden::interpolants& end : in.end[i]) fill(end);
  }
  return in;
}

inline double steps_error(golden::vertex_steps const& a, golden::vertex_steps const& b) {
  double most = 0;
  golden::each_component(
      [&most](auto f, double const& x, double const& y) {
        most = std::max(most, std::abs(x - y) / golden::range_of<typename decltype(f)::step>::lsb);
      },
      a, b);
  return most;
}

inline double difference_error(draw& d) {
  const auto in = draw_differences(d, 60);
  const auto got = golden::difference_vertices<golden::rounded>(in), right = golden::difference_vertices<golden::exact>(in);
  double most = std::max(steps_error(got.sweep, right.sweep), steps_error(got.side, right.side));
  for (int e = 0; e < 3; ++e) most = std::max(most, steps_error(got.edge[e], right.edge[e]));
  return most;
}

// On the longest edges, the corner opposite A where the steps add up to most.
inline double interpolation_error(draw& d) {
  const auto differences = draw_differences(d, 16383);
  golden::interpolated_vertex_in in;
  in.plane = differences.plane;
  for (int i = 0; i < 3; ++i) {
    in.p[i] = differences.p[i];
    in.corner[i] = differences.corner[i];
    for (int k = 0; k < 2; ++k) in.end[i][k] = differences.end[i][k];
  }
  const int corner = d.integer(0, 2);
  in.name = {golden::kind_grid, 0, 0, in.p[corner][in.plane.s], in.p[corner][in.plane.t]};
  if (d.coin()) {
    const double n = golden::main_direction({{in.p[corner], in.p[(corner + 1) % 3]}}).n;
    if (n < 2) return 0;
    in.name = {golden::kind_edge, corner, n - 1, 0, 0};
  }
  in.difference = golden::difference_vertices<golden::rounded>(differences);
  const golden::vertex_steps got = golden::interpolated_vertex<golden::rounded>(in);
  in.difference = golden::difference_vertices<golden::exact>(differences);
  return std::ldexp(steps_error(got, golden::interpolated_vertex<golden::exact>(in)), -golden::guard_bits);
}

// A vertex with data in range, anywhere down to c = 2^-16; N and T of half a unit's length and more.
inline golden::perspective_correction_in draw_correction(draw& d) {
  golden::base_vertex given = draw_base_vertex(d);
  given.p = d.words<formats::position>(-8, 8);
  given.n *= d.real(0.5, 1);
  given.t *= d.real(0.5, 1);
  golden::perspective_correction_in in;
  in.v.c = d.word<formats::step_c>(0, 1) * golden::power_of_two(-d.integer(0, 15)) + golden::range_of<formats::step_c>::lsb;
  in.v.c = golden::rounded::at<formats::step_c>(in.v.c);
  const double c = in.v.c;
  golden::each_attribute([c](auto f, double const& x, double& step) { step = golden::rounded::at<typename decltype(f)::step>(x * c); },
                         given, in.v);
  return in;
}

// Pick: the register of an output record, as a vector.
template <class F, class Pick>
double correction_error(draw& d, Pick pick) {
  const auto in = draw_correction(d);
  const golden::perspective_correction_regs regs{glm::dvec2(largest_coordinate)};
  const auto got = golden::perspective_correction<golden::rounded>(in, regs);
  const auto right = golden::perspective_correction<golden::exact>(in, regs);
  if (got.saturated) return 0;
  const auto off = glm::abs(pick(got) - pick(right)) / golden::range_of<F>::lsb;
  double most = 0;
  for (int i = 0; i < off.length(); ++i) most = std::max(most, off[i]);
  return most;
}

}  // namespace detail

inline std::map<std::string, std::function<double(draw&)>> sweep_measurements() {
  using detail::correction_error;
  using detail::preparation_error;
  using out = golden::perspective_correction_out const&;
  return {
      {"perspective_preparation inverse_w", preparation_error<golden::c_formats>},
      {"perspective_preparation interp_position", preparation_error<golden::position_formats>},
      {"perspective_preparation interp_unit", preparation_error<golden::unit_formats>},
      {"perspective_preparation interp_coordinate", preparation_error<golden::coordinate_formats>},
      {"perspective_preparation interp_colour", preparation_error<golden::colour_formats>},
      {"difference_vertices step_position", detail::difference_error},
      {"interpolated_vertex interp_position", detail::interpolation_error},
      {"perspective_correction correction",
       [](draw& d) { return correction_error<formats::correction>(d, [](out o) { return glm::dvec1(o.w_correction); }); }},
      {"perspective_correction position", [](draw& d) { return correction_error<formats::position>(d, [](out o) { return o.p; }); }},
      {"perspective_correction coordinate", [](draw& d) { return correction_error<formats::coordinate>(d, [](out o) { return o.u; }); }},
      {"perspective_correction colour", [](draw& d) { return correction_error<formats::colour>(d, [](out o) { return o.colour; }); }},
      {"perspective_correction unit",
       [](draw& d) {
         return d.coin() ? correction_error<formats::unit>(d, [](out o) { return o.n; })
                         : correction_error<formats::unit>(d, [](out o) { return o.t; });
       }},
  };
}

}  // namespace relievo::test

// vertex_data: what a vertex carries through the sweep beside its place on the grid.       Gumhold & Huettner 1999, sections 2.1 and 3.2
//
//   base_vertex    p position, n and t unit, u coordinate, colour colour      the given words of a corner
//   interpolants   p interp_position, n and t interp_unit, u interp_coordinate, colour interp_colour, c interp_c
//                  the same times c = 1/w, and c, which are affine on the screen
//   vertex_steps   the same in step_*: 16 guard bits behind the interpolants' last
//
//   each_attribute(call, records...)   calls call(formats, component of each record...) for P, N, T, U and the colour
//   each_component(call, records...)   and for c; `formats` is an attribute_formats, its Given of c is inverse_w
//   step_numbers<Rounding>             in what the steps are computed: words of step_* in int64, or real numbers
#pragma once
#include <cassert>
#include <cstdint>
#include <glm/glm.hpp>

#include "golden/core/rounding.hpp"
#include "golden/sweep/remeshed.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct base_vertex {
  glm::dvec3 p{0}, n{0}, t{0};
  glm::dvec2 u{0};
  glm::dvec4 colour{0};
  RELIEVO_FIELDS(p, n, t, u, colour)
};
struct interpolants {
  glm::dvec3 p{0}, n{0}, t{0};
  glm::dvec2 u{0};
  glm::dvec4 colour{0};
  double c = 0;
  RELIEVO_FIELDS(p, n, t, u, colour, c)
};
struct vertex_steps {
  glm::dvec3 p{0}, n{0}, t{0};
  glm::dvec2 u{0};
  glm::dvec4 colour{0};
  double c = 0;
  RELIEVO_FIELDS(p, n, t, u, colour, c)
};

constexpr int guard_bits = 16;

template <class Given, class Interp, class Step>
struct attribute_formats {
  using given = Given;
  using interp = Interp;
  using step = Step;
  static_assert(Step::fraction == Interp::fraction + guard_bits, "the guard bits");
};
using position_formats = attribute_formats<formats::position, formats::interp_position, formats::step_position>;
using unit_formats = attribute_formats<formats::unit, formats::interp_unit, formats::step_unit>;
using coordinate_formats = attribute_formats<formats::coordinate, formats::interp_coordinate, formats::step_coordinate>;
using colour_formats = attribute_formats<formats::colour, formats::interp_colour, formats::step_colour>;
using c_formats = attribute_formats<formats::inverse_w, formats::interp_c, formats::step_c>;

template <class Call, class... Record>
void each_attribute(Call call, Record&... r) {
  for (int i = 0; i < 3; ++i) call(position_formats{}, r.p[i]...);
  for (int i = 0; i < 3; ++i) call(unit_formats{}, r.n[i]...);
  for (int i = 0; i < 3; ++i) call(unit_formats{}, r.t[i]...);
  for (int i = 0; i < 2; ++i) call(coordinate_formats{}, r.u[i]...);
  for (int i = 0; i < 4; ++i) call(colour_formats{}, r.colour[i]...);
}
template <class Call, class... Record>
void each_component(Call call, Record&... r) {
  each_attribute(call, r...);
  call(c_formats{}, r.c...);
}

// Rounded: a number is the word of step_* in int64, never a double; quotients are rounded half up.
template <class Rounding>
struct step_numbers {
  using number = std::int64_t;

  template <class Formats>
  static number of_interpolant(double x) {
    const double word = x * power_of_two(Formats::interp::fraction);
    assert(static_cast<double>(static_cast<number>(word)) == word && "not a word of its format");
    return static_cast<number>(word) * (number{1} << guard_bits);
  }
  template <class Formats>
  static number of_step(double x) {
    const double word = x * power_of_two(Formats::step::fraction);
    assert(static_cast<double>(static_cast<number>(word)) == word && "not a word of its format");
    return static_cast<number>(word);
  }
  static number quotient(number numerator, number divisor) {
    return divisor < 0 ? nearest(-numerator, -divisor) : nearest(numerator, divisor);
  }
  template <class Formats>
  static double step(number x) {
    using range = range_of<typename Formats::step>;
    const double word = static_cast<double>(x);
    assert(word >= range::raw_min && word <= range::raw_max && "a step outside its format");
    return word * range::lsb;
  }
};
template <>
struct step_numbers<exact> {
  using number = double;

  template <class Formats>
  static number of_interpolant(double x) {
    return x;
  }
  template <class Formats>
  static number of_step(double x) {
    return x;
  }
  static number quotient(number numerator, number divisor) { return numerator / divisor; }
  template <class Formats>
  static double step(number x) {
    return x;
  }
};

}  // namespace golden
}  // namespace relievo

// fixed_ac: fixed over ac_fixed, for Catapult. AC_RND is round half up, AC_TRN floor.
#pragma once
#include <ac_fixed.h>

namespace relievo {
namespace hls {
namespace detail {

template <int W, int I, bool S>
struct tool {
  using plain = ac_fixed<W, I, S, AC_TRN, AC_WRAP>;
  using floored = ac_fixed<W, I, S, AC_TRN, AC_SAT>;
  using rounded = ac_fixed<W, I, S, AC_RND, AC_SAT>;

  static std::int64_t get(plain const& word) {
    const ac_int<W, S> bits = word.template slc<W>(0);
    return static_cast<std::int64_t>(bits.to_int64());
  }
  static void set(plain& word, std::int64_t raw) { word.set_slc(0, ac_int<W, S>(raw)); }

  template <class T>
  static constexpr int width_of() {
    return T::width;
  }
  template <class T>
  static constexpr int integer_bits_of() {
    return T::i_width;
  }
  template <class T>
  static constexpr bool signed_of() {
    return T::sign;
  }
};

}  // namespace detail
}  // namespace hls
}  // namespace relievo

#include "hls/core/fixed_tool.hpp"

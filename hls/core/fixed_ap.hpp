// fixed_ap: fixed over ap_fixed and ap_ufixed, for Vitis HLS and Bambu. AP_RND is round half up, AP_TRN floor.
#pragma once
#include <ap_fixed.h>

namespace relievo {
namespace hls {
namespace detail {

template <int W, int I, bool S>
struct ap_words {
  using plain = ap_fixed<W, I, AP_TRN, AP_WRAP>;
  using floored = ap_fixed<W, I, AP_TRN, AP_SAT>;
  using rounded = ap_fixed<W, I, AP_RND, AP_SAT>;
  using integer = ap_int<W>;
};
template <int W, int I>
struct ap_words<W, I, false> {
  using plain = ap_ufixed<W, I, AP_TRN, AP_WRAP>;
  using floored = ap_ufixed<W, I, AP_TRN, AP_SAT>;
  using rounded = ap_ufixed<W, I, AP_RND, AP_SAT>;
  using integer = ap_uint<W>;
};

// What is asked of the type of a result: its parameters, by deduction.
template <int W, int I, bool S, ap_q_mode Q, ap_o_mode O, int N>
constexpr int ap_width(ap_fixed_base<W, I, S, Q, O, N> const*) {
  return W;
}
template <int W, int I, bool S, ap_q_mode Q, ap_o_mode O, int N>
constexpr int ap_integer_bits(ap_fixed_base<W, I, S, Q, O, N> const*) {
  return I;
}
template <int W, int I, bool S, ap_q_mode Q, ap_o_mode O, int N>
constexpr bool ap_signed(ap_fixed_base<W, I, S, Q, O, N> const*) {
  return S;
}

template <int W, int I, bool S>
struct tool : ap_words<W, I, S> {
  using plain = typename ap_words<W, I, S>::plain;
  using integer = typename ap_words<W, I, S>::integer;

  static std::int64_t get(plain const& word) {
    integer bits;
    bits.range(W - 1, 0) = word.range(W - 1, 0);
    return static_cast<std::int64_t>(bits.to_int64());
  }
  static void set(plain& word, std::int64_t raw) {
    const integer bits = raw;
    word.range(W - 1, 0) = bits.range(W - 1, 0);
  }

  template <class T>
  static constexpr int width_of() {
    return ap_width(static_cast<T const*>(nullptr));
  }
  template <class T>
  static constexpr int integer_bits_of() {
    return ap_integer_bits(static_cast<T const*>(nullptr));
  }
  template <class T>
  static constexpr bool signed_of() {
    return ap_signed(static_cast<T const*>(nullptr));
  }
};

}  // namespace detail
}  // namespace hls
}  // namespace relievo

#include "hls/core/fixed_tool.hpp"

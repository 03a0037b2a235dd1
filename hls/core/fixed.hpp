// fixed: fixed-point words with full-precision + - *, and explicit, named conversions.
//
//   fixed<format<W, I, S>> holds raw * 2^-(W-I). Sums and products lose nothing: their type is as wide as the result can be.
//   Bits only through raw() and from_raw(); integers only through floor_int(); conversions only by name:
//     round_to<F>(x)            round half up (add half an LSB, floor), saturate         AC_RND/AC_SAT, AP_RND/AP_SAT
//     round_to<F>(x, clipped)   the same, and clipped |= it saturated
//     floor_to<F>(x)            floor, saturate                                          AC_TRN/AC_SAT
//     wrap_to<F>(x)             floor, modulo 2^width                                    AC_TRN/AC_WRAP
//     exact_to<F>(x)            refused at compile time where a value could be lost
//   Rules and widths are those on which ap_fixed and ac_fixed agree; with RELIEVO_AP_FIXED or RELIEVO_AC_FIXED defined, fixed holds
//   one of theirs and they do the arithmetic (fixed_ap.hpp, fixed_ac.hpp). No intermediate is wider than 64 bits: a wider type does not
//   compile.
#pragma once
#include "hls/core/formats.hpp"
#include "hls/core/synthesis.hpp"

// ---- widths of results, the same for every tool ---------------------------------------------------------------------------

namespace relievo {
namespace hls {

namespace detail {
constexpr int max(int a, int b) { return a > b ? a : b; }
}  // namespace detail

template <class A, class B>
struct sum_format {
  static constexpr bool is_signed = A::is_signed || B::is_signed;
  static constexpr int integer_bits =
      detail::max(A::integer_bits + (is_signed && !A::is_signed), B::integer_bits + (is_signed && !B::is_signed)) + 1;
  static constexpr int fraction = detail::max(A::fraction, B::fraction);
  using type = format<integer_bits + fraction, integer_bits, is_signed>;
  using difference = format<integer_bits + fraction, integer_bits, true>;
};
template <class A, class B>
using product_format = format<A::width + B::width, A::integer_bits + B::integer_bits, (A::is_signed || B::is_signed)>;

}  // namespace hls
}  // namespace relievo

#if defined(RELIEVO_AP_FIXED)
#include "hls/core/fixed_ap.hpp"
#elif defined(RELIEVO_AC_FIXED)
#include "hls/core/fixed_ac.hpp"
#else

namespace relievo {
namespace hls {

namespace detail {
template <bool Narrow>
struct storage {
  using type = std::int64_t;
};
template <>
struct storage<true> {
  using type = std::int32_t;
};
// 2^n * x without shifting a negative number (undefined before C++20).
constexpr std::int64_t scale_up(std::int64_t x, int n) { return static_cast<std::int64_t>(static_cast<std::uint64_t>(x) << n); }
}  // namespace detail

template <class Format>
class fixed {
 public:
  using format_type = Format;
  static constexpr std::int64_t max_raw =
      static_cast<std::int64_t>((std::uint64_t(1) << (Format::width - (Format::is_signed ? 1 : 0))) - 1);
  static constexpr std::int64_t min_raw = Format::is_signed ? -max_raw - 1 : 0;
  using storage = typename detail::storage<(Format::width <= (Format::is_signed ? 32 : 31))>::type;

  constexpr fixed() : raw_(0) {}
  static constexpr fixed from_raw(std::int64_t raw) { return fixed(static_cast<storage>(raw), 0); }
  constexpr std::int64_t raw() const { return raw_; }

 private:
  constexpr fixed(storage raw, int) : raw_(raw) {}
  storage raw_;
};

template <class Format>
constexpr std::int64_t raw(fixed<Format> x) {
  return x.raw();
}
template <class Format>
constexpr fixed<Format> from_raw(std::int64_t word) {
  return fixed<Format>::from_raw(word);
}

// ---- arithmetic: exact -----------------------------------------------------------------------------------------------

template <class A, class B>
constexpr fixed<typename sum_format<A, B>::type> operator+(fixed<A> a, fixed<B> b) {
  using R = sum_format<A, B>;
  return fixed<typename R::type>::from_raw(detail::scale_up(a.raw(), R::fraction - A::fraction) +
                                           detail::scale_up(b.raw(), R::fraction - B::fraction));
}
template <class A, class B>
constexpr fixed<typename sum_format<A, B>::difference> operator-(fixed<A> a, fixed<B> b) {
  using R = sum_format<A, B>;
  return fixed<typename R::difference>::from_raw(detail::scale_up(a.raw(), R::fraction - A::fraction) -
                                                 detail::scale_up(b.raw(), R::fraction - B::fraction));
}
template <class A, class B>
constexpr fixed<product_format<A, B> > operator*(fixed<A> a, fixed<B> b) {
  return fixed<product_format<A, B> >::from_raw(a.raw() * b.raw());
}
template <class A>
constexpr fixed<format<A::width + 1, A::integer_bits + 1, true> > operator-(fixed<A> a) {
  return fixed<format<A::width + 1, A::integer_bits + 1, true> >::from_raw(-a.raw());
}

// ---- comparison: by value, whatever the formats ------------------------------------------------------------------------

template <class A, class B>
constexpr std::int64_t compare(fixed<A> a, fixed<B> b) {
  return (a - b).raw();
}
template <class A, class B>
constexpr bool operator<(fixed<A> a, fixed<B> b) {
  return compare(a, b) < 0;
}
template <class A, class B>
constexpr bool operator>(fixed<A> a, fixed<B> b) {
  return compare(a, b) > 0;
}
template <class A, class B>
constexpr bool operator<=(fixed<A> a, fixed<B> b) {
  return compare(a, b) <= 0;
}
template <class A, class B>
constexpr bool operator>=(fixed<A> a, fixed<B> b) {
  return compare(a, b) >= 0;
}
template <class A, class B>
constexpr bool operator==(fixed<A> a, fixed<B> b) {
  return compare(a, b) == 0;
}
template <class A, class B>
constexpr bool operator!=(fixed<A> a, fixed<B> b) {
  return compare(a, b) != 0;
}

// ---- conversions -----------------------------------------------------------------------------------------------------

namespace detail {
// Fraction bits that a conversion cuts off, 0 where it cuts none.
template <class To, class From>
constexpr int cut() {
  return From::fraction > To::fraction ? From::fraction - To::fraction : 0;
}
// x * 2^(To - From), floor.
template <class To, class From>
constexpr std::int64_t floor_shift(std::int64_t x) {
  return From::fraction > To::fraction ? x >> cut<To, From>() : scale_up(x, cut<From, To>());
}
// Round half up. In a word of 64 bits x + 1/2 might not fit; floor(x / 2^(n-1) + 1) / 2 needs no bit more than x has.
template <class To, class From>
constexpr std::int64_t round_shift(std::int64_t x) {
  return From::fraction <= To::fraction ? floor_shift<To, From>(x)
         : From::width < 64             ? (x + ((std::int64_t(1) << cut<To, From>()) >> 1)) >> cut<To, From>()
                                        : ((x >> (cut<To, From>() - (cut<To, From>() > 0))) + 1) >> 1;
}
template <class To, class From>
struct conversion {
  static_assert(From::integer_bits + (To::fraction > From::fraction ? To::fraction : 0) <= 63 || From::fraction >= To::fraction,
                "widening a fraction must stay within 64 bits");
};
template <class To>
constexpr std::int64_t saturate(std::int64_t x) {
  return x > fixed<To>::max_raw ? fixed<To>::max_raw : x < fixed<To>::min_raw ? fixed<To>::min_raw : x;
}
}  // namespace detail

template <class To, class From>
constexpr fixed<To> round_to(fixed<From> x) {
  return (void)detail::conversion<To, From>(), fixed<To>::from_raw(detail::saturate<To>(detail::round_shift<To, From>(x.raw())));
}
template <class To, class From>
inline fixed<To> round_to(fixed<From> x, bool& clipped) {
  const std::int64_t rounded = detail::round_shift<To, From>(x.raw());
  const std::int64_t held = detail::saturate<To>(rounded);
  clipped |= held != rounded;
  return fixed<To>::from_raw(held);
}
template <class To, class From>
constexpr fixed<To> floor_to(fixed<From> x) {
  return (void)detail::conversion<To, From>(), fixed<To>::from_raw(detail::saturate<To>(detail::floor_shift<To, From>(x.raw())));
}
template <class To, class From>
constexpr fixed<To> wrap_to(fixed<From> x) {
  return fixed<To>::from_raw(To::is_signed ? detail::scale_up(detail::floor_shift<To, From>(x.raw()), 64 - To::width) >> (64 - To::width)
                                           : static_cast<std::int64_t>(static_cast<std::uint64_t>(detail::floor_shift<To, From>(x.raw())) &
                                                                       static_cast<std::uint64_t>(fixed<To>::max_raw)));
}
template <class To, class From>
constexpr fixed<To> exact_to(fixed<From> x) {
  static_assert(To::fraction >= From::fraction, "the fraction would be cut");
  static_assert(To::is_signed ? To::integer_bits >= From::integer_bits + !From::is_signed
                              : !From::is_signed && To::integer_bits >= From::integer_bits,
                "a value might not fit");
  return fixed<To>::from_raw(detail::scale_up(x.raw(), To::fraction - From::fraction));
}
template <class From>
constexpr std::int64_t floor_int(fixed<From> x) {
  return detail::floor_shift<format<From::integer_bits + 1, From::integer_bits + 1, true>, From>(x.raw());
}

template <class A>
constexpr fixed<format<A::width + 1, A::integer_bits + 1, A::is_signed> > magnitude(fixed<A> a) {
  return fixed<format<A::width + 1, A::integer_bits + 1, A::is_signed> >::from_raw(a.raw() < 0 ? -a.raw() : a.raw());
}
// The same bits with the binary point moved Places to the right: x * 2^Places, by a change of format.
template <int Places, class A>
constexpr fixed<format<A::width, A::integer_bits + Places, A::is_signed> > times_two_to(fixed<A> a) {
  return fixed<format<A::width, A::integer_bits + Places, A::is_signed> >::from_raw(a.raw());
}

}  // namespace hls
}  // namespace relievo

#endif

// fixed_tool: fixed over a synthesis tool's own fixed-point type. Included by fixed_ap.hpp and fixed_ac.hpp, which define
//
//   detail::tool<W, I, S>   plain    truncates and wraps when converted to: wrap_to, and results that lose nothing
//                           floored  truncates and saturates
//                           rounded  rounds half up and saturates
//                           get(word), set(word, raw)      the bits as an integer, its sign carried to bit 63
//                           width_of<T>, integer_bits_of<T>, signed_of<T>   of the type of one of its results
//
//   The tool does the arithmetic, the comparisons, the rounding and the saturation; here are names and formats. A result of the tool
//   whose width is not the one that sum_format and product_format promise does not compile. Same interface as the simulation's
//   class in fixed.hpp: there the contract.
#pragma once

namespace relievo {
namespace hls {

template <class Format>
class fixed {
 public:
  using format_type = Format;
  using tool_type = detail::tool<Format::width, Format::integer_bits, Format::is_signed>;
  using word_type = typename tool_type::plain;
  static constexpr std::int64_t max_raw =
      static_cast<std::int64_t>((std::uint64_t(1) << (Format::width - (Format::is_signed ? 1 : 0))) - 1);
  static constexpr std::int64_t min_raw = Format::is_signed ? -max_raw - 1 : 0;

  fixed() : word_(0) {}
  explicit fixed(word_type const& word) : word_(word) {}
  static fixed from_raw(std::int64_t raw) {
    fixed x;
    tool_type::set(x.word_, raw);
    return x;
  }
  std::int64_t raw() const { return tool_type::get(word_); }
  word_type const& word() const { return word_; }

 private:
  word_type word_;
};

template <class Format>
inline std::int64_t raw(fixed<Format> const& x) {
  return x.raw();
}
template <class Format>
inline fixed<Format> from_raw(std::int64_t word) {
  return fixed<Format>::from_raw(word);
}

// ---- arithmetic: exact -----------------------------------------------------------------------------------------------

namespace detail {
template <class Format, class Result>
inline fixed<Format> exact_result(Result const& result) {
  using tool_type = typename fixed<Format>::tool_type;
  static_assert(tool_type::template width_of<Result>() == Format::width, "the tool's result has another width");
  static_assert(tool_type::template integer_bits_of<Result>() == Format::integer_bits, "the tool's result has another binary point");
  static_assert(tool_type::template signed_of<Result>() == Format::is_signed, "the tool's result has another sign");
  return fixed<Format>(typename fixed<Format>::word_type(result));
}
}  // namespace detail

template <class A, class B>
inline fixed<typename sum_format<A, B>::type> operator+(fixed<A> const& a, fixed<B> const& b) {
  return detail::exact_result<typename sum_format<A, B>::type>(a.word() + b.word());
}
template <class A, class B>
inline fixed<typename sum_format<A, B>::difference> operator-(fixed<A> const& a, fixed<B> const& b) {
  return detail::exact_result<typename sum_format<A, B>::difference>(a.word() - b.word());
}
template <class A, class B>
inline fixed<product_format<A, B>> operator*(fixed<A> const& a, fixed<B> const& b) {
  return detail::exact_result<product_format<A, B>>(a.word() * b.word());
}
template <class A>
inline fixed<format<A::width + 1, A::integer_bits + 1, true>> operator-(fixed<A> const& a) {
  return detail::exact_result<format<A::width + 1, A::integer_bits + 1, true>>(-a.word());
}

// ---- comparison: by value, whatever the formats ------------------------------------------------------------------------
// By the sign of the exact difference: the open ap_fixed takes a negative ap_fixed<24, 2> for larger than an ap_ufixed<16, 16>.

namespace detail {
template <class Word>
inline int sign(Word const& difference) {
  const Word zero(0);
  return difference < zero ? -1 : difference == zero ? 0 : 1;
}
}  // namespace detail

template <class A, class B>
inline int compare(fixed<A> const& a, fixed<B> const& b) {
  return detail::sign((a - b).word());
}
template <class A, class B>
inline bool operator<(fixed<A> const& a, fixed<B> const& b) {
  return compare(a, b) < 0;
}
template <class A, class B>
inline bool operator>(fixed<A> const& a, fixed<B> const& b) {
  return compare(a, b) > 0;
}
template <class A, class B>
inline bool operator<=(fixed<A> const& a, fixed<B> const& b) {
  return compare(a, b) <= 0;
}
template <class A, class B>
inline bool operator>=(fixed<A> const& a, fixed<B> const& b) {
  return compare(a, b) >= 0;
}
template <class A, class B>
inline bool operator==(fixed<A> const& a, fixed<B> const& b) {
  return compare(a, b) == 0;
}
template <class A, class B>
inline bool operator!=(fixed<A> const& a, fixed<B> const& b) {
  return compare(a, b) != 0;
}

// ---- conversions -----------------------------------------------------------------------------------------------------

template <class To, class From>
inline fixed<To> round_to(fixed<From> const& x) {
  return fixed<To>(typename fixed<To>::word_type(typename fixed<To>::tool_type::rounded(x.word())));
}
template <class To, class From>
inline fixed<To> round_to(fixed<From> const& x, bool& clipped) {
  // Rounded with all the integer bits that the value can need, to see whether the saturated word is still it.
  constexpr int integer_bits = detail::max(From::integer_bits, To::integer_bits) + 2;
  using whole = detail::tool<integer_bits + To::fraction, integer_bits, true>;
  const fixed<To> held = round_to<To>(x);
  const typename whole::plain wanted = typename whole::rounded(x.word());
  const typename whole::plain got = held.word();
  clipped |= wanted != got;
  return held;
}
template <class To, class From>
inline fixed<To> floor_to(fixed<From> const& x) {
  return fixed<To>(typename fixed<To>::word_type(typename fixed<To>::tool_type::floored(x.word())));
}
template <class To, class From>
inline fixed<To> wrap_to(fixed<From> const& x) {
  return fixed<To>(typename fixed<To>::word_type(x.word()));
}
template <class To, class From>
inline fixed<To> exact_to(fixed<From> const& x) {
  static_assert(To::fraction >= From::fraction, "the fraction would be cut");
  static_assert(To::is_signed ? To::integer_bits >= From::integer_bits + !From::is_signed
                              : !From::is_signed && To::integer_bits >= From::integer_bits,
                "a value might not fit");
  return fixed<To>(typename fixed<To>::word_type(x.word()));
}
template <class From>
inline std::int64_t floor_int(fixed<From> const& x) {
  constexpr int width = detail::max(From::integer_bits, 1) + 1;
  return raw(wrap_to<format<width, width, true>>(x));
}

template <class A>
inline fixed<format<A::width + 1, A::integer_bits + 1, A::is_signed>> magnitude(fixed<A> const& a) {
  using wide = format<A::width + 1, A::integer_bits + 1, A::is_signed>;
  return a < fixed<A>() ? wrap_to<wide>(-a) : wrap_to<wide>(a);
}
template <int Places, class A>
inline fixed<format<A::width, A::integer_bits + Places, A::is_signed>> times_two_to(fixed<A> const& a) {
  return from_raw<format<A::width, A::integer_bits + Places, A::is_signed>>(raw(a));
}

}  // namespace hls
}  // namespace relievo

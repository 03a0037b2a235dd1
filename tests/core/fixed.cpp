// fixed: held against SystemC's sc_fixed and sc_ufixed, value and width: + - * unary minus, comparisons, every conversion, between
// formats of the table and awkward ones (all fraction, negative fraction, one side unsigned), on corners and random words.
#include "hls/core/fixed.hpp"

#include <gtest/gtest.h>

#define SC_INCLUDE_FX
#include <systemc>

#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

// ---- the same value in SystemC ------------------------------------------------------------------------------------------

template <class F, sc_dt::sc_q_mode Q, sc_dt::sc_o_mode O, bool Signed = F::is_signed>
struct systemc_type {
  using type = sc_dt::sc_fixed<F::width, F::integer_bits, Q, O>;
};
template <class F, sc_dt::sc_q_mode Q, sc_dt::sc_o_mode O>
struct systemc_type<F, Q, O, false> {
  using type = sc_dt::sc_ufixed<F::width, F::integer_bits, Q, O>;
};

// raw * 2^-fraction in SystemC's arbitrary precision.
sc_dt::sc_fxval scaled(std::int64_t raw, int fraction) {
  const sc_dt::sc_fxval word(static_cast<sc_dt::int64>(raw));
  return fraction >= 0 ? word >> fraction : word << -fraction;
}
template <class F>
sc_dt::sc_fxval value(hls::fixed<F> x) {
  return scaled(raw(x), F::fraction);
}

// A word of ours equals the exact value `right`, and lies within its format.
template <class F>
testing::AssertionResult is(hls::fixed<F> ours, sc_dt::sc_fxval const& right) {
  if (raw(ours) > hls::fixed<F>::max_raw || raw(ours) < hls::fixed<F>::min_raw)
    return testing::AssertionFailure() << raw(ours) << " is outside its format";
  if (value(ours) == right) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "ours " << value(ours).to_dec() << ", SystemC " << right.to_dec();
}

// ---- operands -----------------------------------------------------------------------------------------------------------

template <class F>
struct operand {
  hls::fixed<F> x;
  RELIEVO_FIELDS(x)
};
template <class A, class B>
struct operands {
  hls::fixed<A> a;
  hls::fixed<B> b;
  RELIEVO_FIELDS(a, b)
};

using formats::clip;
using formats::coordinate;
using formats::height;
using formats::rectangle_sum;
using formats::sample;
using formats::unit;
using table_scale = formats::scale;
using nibble = format<4, 4, false>;
using small_signed = format<5, 3, true>;
using all_fraction = format<7, 0, true>;
using below_point = format<9, -3, true>;
using above_point = format<6, 9, false>;
using wide = format<48, 30, true>;

template <class P>
class fixed_arithmetic : public testing::Test {};
template <class A, class B>
struct pair {
  using first = A;
  using second = B;
};
using arithmetic_pairs =
    testing::Types<pair<height, unit>, pair<unit, unit>, pair<table_scale, sample>, pair<sample, table_scale>, pair<coordinate, coordinate>,
                   pair<nibble, small_signed>, pair<small_signed, nibble>, pair<all_fraction, above_point>, pair<below_point, all_fraction>,
                   pair<above_point, below_point>, pair<formats::texel, formats::fraction>, pair<formats::depth, formats::matrix_xy>>;
TYPED_TEST_SUITE(fixed_arithmetic, arithmetic_pairs);

constexpr std::uint64_t pair_count = 12;

TYPED_TEST(fixed_arithmetic, sums_and_differences_and_comparisons) {
  using A = typename TypeParam::first;
  using B = typename TypeParam::second;
  for_vectors<operands<A, B>>(
      [](operands<A, B>& v, generator& g) {
        // One in four compares equals, one in four neighbours, where both formats hold such a word.
        constexpr int shift = A::fraction - B::fraction;
        if constexpr (shift >= 0) {
          const std::int64_t word = (raw(v.a) >> shift) + g.between(0, 1);
          if (g.chance(2) && word >= hls::fixed<B>::min_raw && word <= hls::fixed<B>::max_raw) v.b = hls::from_raw<B>(word);
        }
      },
      [](operands<A, B> const& v) {
        const sc_dt::sc_fxval a = value(v.a), b = value(v.b);
        testing::AssertionResult result = is(v.a + v.b, a + b);
        if (!result) return result << " for a + b";
        result = is(v.a - v.b, a - b);
        if (!result) return result << " for a - b";
        result = is(-v.a, -a);
        if (!result) return result << " for -a";
        const bool ours[] = {v.a<v.b, v.a> v.b, v.a <= v.b, v.a >= v.b, v.a == v.b, v.a != v.b};
        const bool right[] = {a<b, a> b, a <= b, a >= b, a == b, a != b};
        for (int i = 0; i < 6; ++i)
          if (ours[i] != right[i]) return testing::AssertionFailure() << "comparison " << i << " (< > <= >= == !=) says " << ours[i];
        return result;
      },
      vector_count() / pair_count);
}

TYPED_TEST(fixed_arithmetic, products) {
  using A = typename TypeParam::first;
  using B = typename TypeParam::second;
  for_vectors<operands<A, B>>(
      any_word(), [](operands<A, B> const& v) { return is(v.a * v.b, value(v.a) * value(v.b)); }, vector_count() / pair_count);
}

// Nothing narrower would do: one bit less on top, and some result of two corners would not fit; nor is a bit missing below.
template <class F>
bool needs_its_top_bit(sc_dt::sc_fxval const& x) {
  const bool too_low = F::is_signed && x < -scaled(std::int64_t(1) << (F::width - 2), F::fraction);
  const bool too_high = x > scaled((std::int64_t(1) << (F::width - (F::is_signed ? 2 : 1))) - 1, F::fraction);
  return too_low || too_high;
}

TYPED_TEST(fixed_arithmetic, results_are_as_wide_as_they_must_be) {
  using A = typename TypeParam::first;
  using B = typename TypeParam::second;
  using sum = typename decltype(hls::fixed<A>() + hls::fixed<B>())::format_type;
  using difference = typename decltype(hls::fixed<A>() - hls::fixed<B>())::format_type;
  using product = typename decltype(hls::fixed<A>() * hls::fixed<B>())::format_type;
  using negated = typename decltype(-hls::fixed<A>())::format_type;
  bool sums = false, differences = false, products = false, negations = false;
  for (int i = 0; i < corner_count; ++i)
    for (int k = 0; k < corner_count; ++k) {
      const sc_dt::sc_fxval a = scaled(corner_word<A>(i), A::fraction), b = scaled(corner_word<B>(k), B::fraction);
      sums |= needs_its_top_bit<sum>(a + b);
      differences |= needs_its_top_bit<difference>(a - b);
      products |= needs_its_top_bit<product>(a * b);
      negations |= needs_its_top_bit<negated>(-a);
    }
  // The rule of ap_fixed and ac_fixed gives every sum one bit above the larger operand, also where the smaller never reaches that far.
  constexpr bool overlap = A::integer_bits + B::fraction >= 1 && B::integer_bits + A::fraction >= 1;
  if (overlap) {
    EXPECT_TRUE(sums);
    EXPECT_TRUE(differences);
  }
  EXPECT_TRUE(products);
  EXPECT_TRUE(negations);
  EXPECT_EQ(sum::fraction, std::max(A::fraction, B::fraction));
  EXPECT_EQ(product::fraction, A::fraction + B::fraction);
}

// ---- conversions --------------------------------------------------------------------------------------------------------

template <class P>
class fixed_conversion : public testing::Test {};
using conversion_pairs =
    testing::Types<pair<height, unit>, pair<unit, height>, pair<clip, formats::screen>, pair<format<45, 5, true>, height>,
                   pair<format<42, 8, true>, formats::position>, pair<format<38, 16, false>, sample>, pair<wide, small_signed>,
                   pair<wide, nibble>, pair<small_signed, nibble>, pair<nibble, small_signed>, pair<sample, all_fraction>,
                   pair<all_fraction, sample>, pair<above_point, below_point>, pair<below_point, above_point>,
                   pair<coordinate, formats::fraction>, pair<rectangle_sum, formats::table_sum>,
                   pair<format<64, 44, true>, formats::screen>, pair<unit, unit>>;
TYPED_TEST_SUITE(fixed_conversion, conversion_pairs);
constexpr std::uint64_t conversion_count = 18;

TYPED_TEST(fixed_conversion, every_mode_equals_systemc) {
  using From = typename TypeParam::first;
  using To = typename TypeParam::second;
  using rounding = typename systemc_type<To, sc_dt::SC_RND, sc_dt::SC_SAT>::type;
  using flooring = typename systemc_type<To, sc_dt::SC_TRN, sc_dt::SC_SAT>::type;
  using wrapping = typename systemc_type<To, sc_dt::SC_TRN, sc_dt::SC_WRAP>::type;
  std::uint64_t clips = 0;
  for_vectors<operand<From>>(
      [](operand<From>& v, generator& g) {
        // A third of the words lie at or beside a tie of the conversion or an end of its range.
        constexpr int shift = From::fraction - To::fraction;
        if constexpr (shift >= 1) {
          const std::int64_t tie = ((raw(v.x) >> shift) * 2 + 1) * (std::int64_t(1) << (shift - 1)) + g.between(-1, 1);
          if (g.chance(3) && tie >= hls::fixed<From>::min_raw && tie <= hls::fixed<From>::max_raw) v.x = hls::from_raw<From>(tie);
        }
      },
      [&](operand<From> const& v) {
        const sc_dt::sc_fxval x = value(v.x);
        testing::AssertionResult result = is(hls::round_to<To>(v.x), rounding(x).value());
        if (!result) return result << " for round_to";
        result = is(hls::floor_to<To>(v.x), flooring(x).value());
        if (!result) return result << " for floor_to";
        result = is(hls::wrap_to<To>(v.x), wrapping(x).value());
        if (!result) return result << " for wrap_to";
        // The flag: saturation changed the rounded value.
        bool clipped = false, kept = true;
        result = is(hls::round_to<To>(v.x, clipped), rounding(x).value());
        if (!result) return result << " for round_to with its flag";
        hls::round_to<To>(v.x, kept);
        if (!kept) return testing::AssertionFailure() << "round_to cleared a flag that was set";
        const sc_dt::sc_fxval half = To::fraction < From::fraction ? scaled(1, To::fraction + 1) : sc_dt::sc_fxval(0);
        const bool beyond = x + half >= scaled(hls::fixed<To>::max_raw, To::fraction) + scaled(1, To::fraction) ||
                            x + half < scaled(hls::fixed<To>::min_raw, To::fraction);
        clips += beyond ? 1 : 0;
        if (clipped != beyond) return testing::AssertionFailure() << "clipped is " << clipped;
        return testing::AssertionSuccess();
      },
      vector_count() / conversion_count);
  constexpr int from_top = From::integer_bits - (From::is_signed ? 1 : 0), to_top = To::integer_bits - (To::is_signed ? 1 : 0);
  constexpr bool fits =
      (to_top > from_top || (to_top == from_top && To::fraction >= From::fraction)) && (To::is_signed || !From::is_signed);
  if (fits) {
    EXPECT_EQ(clips, 0u);
  } else if (From::integer_bits + To::fraction >= 1) {
    EXPECT_GT(clips, 0u) << "no vector tried the saturation";
  }
}

TEST(fixed, floor_int_is_the_integer_below) {
  for_vectors<operand<height>>(any_word(), [](operand<height> const& v) {
    const double x = static_cast<double>(raw(v.x)) / (1 << height::fraction);
    return hls::floor_int(v.x) == static_cast<std::int64_t>(std::floor(x)) ? testing::AssertionSuccess()
                                                                           : testing::AssertionFailure() << hls::floor_int(v.x);
  });
  EXPECT_EQ(hls::floor_int(hls::from_raw<coordinate>(hls::fixed<coordinate>::max_raw)), 16383);
  EXPECT_EQ(hls::floor_int(hls::from_raw<height>(-1)), -1);
}

TEST(fixed, magnitude_holds_the_lowest_value) {
  const auto m = hls::magnitude(hls::from_raw<unit>(-32768));
  static_assert(std::is_same_v<decltype(m), hls::fixed<format<17, 3, true>> const>);
  EXPECT_EQ(raw(m), 32768);
  for_vectors<operand<unit>>(
      any_word(),
      [](operand<unit> const& v) {
        const sc_dt::sc_fxval x = value(v.x), zero(0);
        return is(hls::magnitude(v.x), x < zero ? -x : x);
      },
      1000);
}

TEST(fixed, exact_to_and_times_two_to_lose_nothing) {
  for_vectors<operand<unit>>(
      any_word(),
      [](operand<unit> const& v) {
        const auto result = is(hls::exact_to<format<40, 10, true>>(v.x), value(v.x));
        return result ? is(hls::times_two_to<-4>(v.x), value(v.x) >> 4) : result;
      },
      100000);
}

// ---- the types themselves -----------------------------------------------------------------------------------------------

template <class Fixed, int Width, int IntegerBits, bool Signed>
constexpr bool has_format = std::is_same_v<std::decay_t<Fixed>, hls::fixed<format<Width, IntegerBits, Signed>>>;
template <class F>
hls::fixed<F> of();

static_assert(has_format<decltype(of<unit>() + of<unit>()), 17, 3, true>);
static_assert(has_format<decltype(of<unit>() + of<height>()), 25, 5, true>);
static_assert(has_format<decltype(of<nibble>() + of<nibble>()), 5, 5, false>);
static_assert(has_format<decltype(of<nibble>() - of<nibble>()), 5, 5, true>);
static_assert(has_format<decltype(of<nibble>() + of<small_signed>()), 8, 6, true>);
static_assert(has_format<decltype(of<small_signed>() - of<nibble>()), 8, 6, true>);
static_assert(has_format<decltype(of<table_scale>() * of<sample>()), 44, 4, true>);
static_assert(has_format<decltype(of<nibble>() * of<nibble>()), 8, 8, false>);
static_assert(has_format<decltype(-of<nibble>()), 5, 5, true>);
static_assert(has_format<decltype(-of<unit>()), 17, 3, true>);
static_assert(has_format<decltype(hls::times_two_to<3>(of<unit>())), 16, 5, true>);
static_assert(sizeof(hls::fixed<formats::position>) == 4 && sizeof(hls::fixed<formats::index>) == 8 &&
              sizeof(hls::fixed<formats::clip>) == 8);

// Usable in constant expressions: an HLS tool folds constants, and so do the tests.
static_assert(raw(hls::round_to<nibble>(hls::from_raw<small_signed>(-1))) == 0);
static_assert(raw(hls::round_to<small_signed>(hls::from_raw<nibble>(15))) == 15);
static_assert(raw(hls::wrap_to<nibble>(hls::from_raw<format<8, 8, false>>(0x3b))) == 0xb);

}  // namespace
}  // namespace relievo::test

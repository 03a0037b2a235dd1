// verilate: Vdivide
// verilate: Vdivide_mean N=40 NSigned=0 D=25 Q=20 QSigned=0 Shift=4
// verilate: Vdivide_small N=8 D=7 Q=8 Shift=4
// verilate: Vdivide_small_unsigned N=8 NSigned=0 D=7 Q=9 QSigned=0 Shift=3
//
// divide: the circuit equals the kernel in the two formats of the project, at the boundaries between quotients and between clipped and not,
// and for every pair of two small formats; one division a clock, Q + 3 clocks later.
#include <array>

#include "Vdivide.h"
#include "Vdivide_mean.h"
#include "Vdivide_small.h"
#include "Vdivide_small_unsigned.h"
#include "hls/core/divide.hpp"
#include "tests/support/pipeline.hpp"

namespace relievo::test {
namespace {

__extension__ typedef __int128 int128;

template <class N, class D>
struct operands {
  hls::fixed<N> num;
  hls::fixed<D> den;
  RELIEVO_FIELDS(num, den)
};
template <class N, class D>
struct in_only {
  operands<N, D> in;
  RELIEVO_FIELDS(in)
};
template <class To>
struct result {
  hls::fixed<To> quotient;
  bool clipped;
  RELIEVO_FIELDS(quotient, clipped)
};

// The divider's own ports as one word in and one out.
template <class Divider, class To, class N, class D>
struct words {
  explicit words(VerilatedContext* context) : divider(context) {}
  void eval() {
    const auto v = tb::get<operands<N, D>>(in_i);
    divider.num_i = static_cast<std::decay_t<decltype(divider.num_i)>>(raw(v.num) & ((std::int64_t(1) << N::width) - 1));
    divider.den_i = static_cast<std::decay_t<decltype(divider.den_i)>>(raw(v.den));
    divider.clk_i = clk_i;
    divider.eval();
    out_o = divider.quotient_o | static_cast<std::uint64_t>(divider.clipped_o) << To::width;
  }
  Divider divider;
  unsigned char clk_i = 0;
  std::array<std::uint32_t, 3> in_i{};
  std::uint64_t out_o = 0;
};

template <class Divider, class To, class N, class D, class Shape>
void equals_kernel(Shape shape) {
  pipeline_test<words<Divider, To, N, D>, in_only<N, D>>(To::width + 3, shape, [](in_only<N, D> const& v) {
    result<To> out{};
    out.quotient = hls::divide<To>(v.in.num, v.in.den, out.clipped);
    return out;
  });
}

// One in two numerators lies at or beside the boundary between two quotients: (2 q + 1) d / 2^(shift + 1).
template <class To, class N, class D>
struct hard_case {
  void operator()(in_only<N, D>& v, generator& g) const {
    constexpr int shift = To::fraction - N::fraction + D::fraction;
    if (g.chance(2)) return;
    const std::int64_t q = random_word<To>(draw::mixed, g);
    const int128 n = ((2 * static_cast<int128>(q) + 1) * raw(v.in.den) >> (shift + 1)) + g.between(0, 1);
    if (n <= hls::fixed<N>::max_raw && n >= hls::fixed<N>::min_raw) v.in.num = hls::from_raw<N>(static_cast<std::int64_t>(n));
  }
};

TEST(divide, rtl_equals_hls_on_the_screen) {
  equals_kernel<Vdivide, formats::screen, formats::clip, formats::depth>(hard_case<formats::screen, formats::clip, formats::depth>());
}
TEST(divide, rtl_equals_hls_on_means) {
  equals_kernel<Vdivide_mean, formats::sample, formats::table_sum, formats::area>(
      hard_case<formats::sample, formats::table_sum, formats::area>());
}

// Counts through all operands.
template <class Divider, class To, class N, class D>
void every_quotient() {
  constexpr std::uint64_t all = std::uint64_t(1) << (N::width + D::width);
  std::uint64_t number = 0;
  const auto next = [&number](in_only<N, D>& v, generator&) { v.in = tb::get<operands<N, D>>(number++ % all); };
  do equals_kernel<Divider, To, N, D>(next);
  while (number < all && !testing::Test::HasFailure());
}

TEST(divide, every_quotient_of_small_formats) {
  every_quotient<Vdivide_small, format<8, 4, true>, format<8, 4, true>, format<7, 3, false>>();
  every_quotient<Vdivide_small_unsigned, format<9, 6, false>, format<8, 4, false>, format<7, 3, false>>();
}

}  // namespace
}  // namespace relievo::test

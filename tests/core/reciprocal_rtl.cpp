// verilate: Vreciprocal
// verilate: Vreciprocal_small D=6 Q=8 Shift=12
//
// reciprocal: the circuit equals the kernel for every sample, and where the quotient does not fit; Q + 3 clocks later.
#include "Vreciprocal.h"
#include "Vreciprocal_small.h"
#include "hls/core/reciprocal.hpp"
#include "tests/support/pipeline.hpp"

namespace relievo::test {
namespace {

template <class X>
struct operand {
  hls::fixed<X> x;
  RELIEVO_FIELDS(x)
};
template <class X>
struct in_only {
  operand<X> in;
  RELIEVO_FIELDS(in)
};
template <class To>
struct result {
  hls::fixed<To> reciprocal;
  bool clipped;
  RELIEVO_FIELDS(reciprocal, clipped)
};

// The unit's own ports as one word in and one out.
template <class Unit, class To>
struct words {
  explicit words(VerilatedContext* context) : unit(context) {}
  void eval() {
    unit.x_i = static_cast<std::decay_t<decltype(unit.x_i)>>(in_i);
    unit.clk_i = clk_i;
    unit.eval();
    out_o = unit.reciprocal_o | static_cast<std::uint64_t>(unit.clipped_o) << To::width;
  }
  Unit unit;
  unsigned char clk_i = 0;
  std::uint64_t in_i = 0, out_o = 0;
};

// Counts through all operands.
template <class Unit, class To, class X>
void every_word() {
  constexpr std::uint64_t all = std::uint64_t(1) << X::width;
  std::uint64_t number = 0;
  const auto next = [&number](in_only<X>& v, generator&) { v.in.x = hls::from_raw<X>(static_cast<std::int64_t>(number++ % all)); };
  do {
    pipeline_test<words<Unit, To>, in_only<X>>(To::width + 3, next, [](in_only<X> const& v) {
      result<To> out{};
      out.reciprocal = hls::reciprocal<To>(v.in.x, out.clipped);
      return out;
    });
  } while (number < all && !testing::Test::HasFailure());
}

TEST(reciprocal, rtl_equals_hls_on_every_sample) { every_word<Vreciprocal, format<29, 5, false>, formats::sample>(); }
TEST(reciprocal, rtl_equals_hls_where_the_format_ends) { every_word<Vreciprocal_small, format<8, 2, false>, format<6, 0, false>>(); }

}  // namespace
}  // namespace relievo::test

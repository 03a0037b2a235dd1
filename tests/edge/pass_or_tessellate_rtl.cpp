// pass_or_tessellate: the circuit equals the kernel, a clock later, on every combination of tests, switches, generation and limit.
#include "Vpass_or_tessellate.h"
#include "hls/edge/pass_or_tessellate.hpp"
#include "tests/support/pipeline.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::pass_or_tessellate_in, hls::pass_or_tessellate_regs>;

hls::pass_or_tessellate_out kernel(vector const& v) { return hls::pass_or_tessellate(v.in, v.regs); }

TEST(pass_or_tessellate, rtl_equals_hls) { pipeline_test<Vpass_or_tessellate, vector>(1, any_word(), kernel); }

// 6 tests, settled, generation; 6 switches, limit: 2^21. A clock without an answer after each would not be seen: the test above has it.
TEST(pass_or_tessellate, rtl_equals_hls_on_every_combination) {
  VerilatedContext context;
  Vpass_or_tessellate model(&context);
  tb::keep_coverage kept(context);
  std::uint64_t splits = 0;
  vector v{};
  for (std::uint32_t word = 0; word < (1u << 21); ++word) {
    const auto bit = [word](int i) { return (word >> i & 1) != 0; };
    v.in = {bit(0), bit(1), bit(2), bit(3), bit(4), bit(5), hls::from_raw<formats::generation>(word >> 7 & 15), bit(6)};
    v.regs = {bit(11), bit(12), bit(13), bit(14), bit(15), bit(16), hls::from_raw<formats::generation>(word >> 17 & 15), bit(0)};
    tb::put(model.in_i, v.in);
    tb::put(model.regs_i, v.regs);
    model.clk_i = 1;
    model.eval();
    model.clk_i = 0;
    model.eval();
    kept.begin();
    const bool split = kernel(v).split;
    ASSERT_EQ(model.out_o != 0, split) << describe(v);
    splits += split ? 1 : 0;
  }
  EXPECT_GT(splits, 50000u);
}

}  // namespace
}  // namespace relievo::test

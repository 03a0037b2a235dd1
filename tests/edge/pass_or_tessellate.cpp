// pass_or_tessellate: every combination of tests, switches, generation and limit: hls equals golden and the paper's formula. cull too.
#include "hls/edge/pass_or_tessellate.hpp"

#include <gtest/gtest.h>

#include "golden/core/rounding.hpp"
#include "golden/edge/pass_or_tessellate.hpp"
#include "tests/support/words.hpp"

namespace relievo::test {
namespace {

// 6 tests, settled, 6 switches, generation and limit: 2^21.
TEST(pass_or_tessellate, every_combination) {
  std::uint64_t splits = 0;
  for (std::uint32_t word = 0; word < (1u << 21); ++word) {
    const auto bit = [word](int i) { return (word >> i & 1) != 0; };
    const hls::pass_or_tessellate_in in = {
        bit(0), bit(1), bit(2), bit(3), bit(4), bit(5), hls::from_raw<formats::generation>(word >> 13 & 15), bit(6)};
    const hls::pass_or_tessellate_regs regs = {
        bit(7), bit(8), bit(9), bit(10), bit(11), bit(12), hls::from_raw<formats::generation>(word >> 17 & 15), bit(3)};
    const bool wanted = (bit(0) & bit(7)) | (bit(1) & bit(8)) | (bit(2) & bit(9)) | (bit(3) & bit(10));
    const bool stopped = (bit(11) & !bit(4)) | (bit(12) & !bit(5)) | bit(6) | (raw(in.generation) >= raw(regs.max_generation));
    const auto out = hls::pass_or_tessellate(in, regs);
    ASSERT_EQ(out.split, wanted && !stopped) << describe(in) << describe(regs);
    const golden::pass_or_tessellate_in golden_in = {in.nt,     in.sht, in.pt, in.ht, in.vt, in.ct, static_cast<double>(raw(in.generation)),
                                                     in.settled};
    const golden::pass_or_tessellate_regs golden_regs = {
        regs.use_nt, regs.use_sht, regs.use_pt, regs.use_ht, regs.use_vt, regs.use_ct, static_cast<double>(raw(regs.max_generation)),
        regs.cull};
    ASSERT_EQ(out.split, golden::pass_or_tessellate<golden::rounded>(golden_in, golden_regs).split) << describe(in) << describe(regs);
    splits += out.split ? 1 : 0;
  }
  EXPECT_GT(splits, 50000u);
}

TEST(pass_or_tessellate, culls_what_shows_its_back_at_all_three_vertices) {
  for (int word = 0; word < 16; ++word) {
    const bool away[3] = {(word & 1) != 0, (word & 2) != 0, (word & 4) != 0};
    hls::pass_or_tessellate_regs regs{};
    regs.cull = (word & 8) != 0;
    golden::pass_or_tessellate_regs golden_regs;
    golden_regs.cull = regs.cull;
    EXPECT_EQ(hls::cull(away, regs), word == 15) << word;
    EXPECT_EQ(golden::cull<golden::rounded>(away, golden_regs), word == 15) << word;
  }
}

}  // namespace
}  // namespace relievo::test

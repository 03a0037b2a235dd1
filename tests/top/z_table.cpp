// z_table: the entry point builds a table a call.
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

TEST(top_z_table, builds_every_table) {
  generator g = next_generator();
  hls::port<hls::z_table_out> out("out");
  for (int round = 0; round < 100; ++round) {
    const auto kappa = hls::from_raw<formats::kappa>(random_word<formats::kappa>(draw::mixed, g));
    relievo_z_table(hls::pack(hls::top::z_table_regs{kappa}), out);
    ASSERT_EQ(out.size(), hls::z_table_words);
    for (int i = 0; i < hls::z_table_words; ++i)
      ASSERT_TRUE(same_words(hls::unpack<hls::z_table_out>(out.read()), hls::z_table({kappa, hls::from_raw<format<9, 9, false>>(i)}))) << i;
  }
}

}  // namespace
}  // namespace relievo::test

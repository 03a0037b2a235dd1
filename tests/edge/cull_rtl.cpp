// cull: the circuit equals the kernel's function on every combination of the three normals and the switch; nothing else counts.
#include "Vcull.h"
#include "hls/edge/pass_or_tessellate.hpp"
#include "tests/support/pipeline.hpp"

namespace relievo::test {
namespace {

TEST(cull, rtl_equals_hls_on_every_combination) {
  VerilatedContext context;
  Vcull model(&context);
  tb::keep_coverage kept(context);
  model.eval();
  kept.begin();
  generator g("cull");
  hls::pass_or_tessellate_regs regs{};
  for (int word = 0; word < 16; ++word)
    for (int others = 0; others < 100; ++others) {
      draw_vector(regs, draw::uniform, g);
      regs.cull = (word & 8) != 0;
      const bool away[3] = {(word & 1) != 0, (word & 2) != 0, (word & 4) != 0};
      model.away_i = static_cast<unsigned char>(word & 7);
      tb::put(model.regs_i, regs);
      model.eval();
      ASSERT_EQ(model.cull_o != 0, hls::cull(away, regs)) << word;
    }
}

}  // namespace
}  // namespace relievo::test

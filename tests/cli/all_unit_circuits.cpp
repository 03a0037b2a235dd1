// relievo_units_rtl: the command line with the circuits of all units that replay knows. The models are those of the units' own tests.
#include <array>

#include "Vbump.h"
#include "Vcalculate_new_n.h"
#include "Vcalculate_new_p.h"
#include "Vcalculate_new_u.h"
#include "Vdisplace.h"
#include "Vdivide.h"
#include "Vhighlight_test.h"
#include "Vnormal_test.h"
#include "Vnormalize.h"
#include "Vpass_or_tessellate.h"
#include "Vtex_coord_test.h"
#include "Vtransform.h"
#include "Vtransform_normal.h"
#include "Vview_test.h"
#include "hls/core/formats.hpp"
#include "tb/cosim/unit_circuit_of.hpp"

namespace relievo::tb {
namespace {

// The divider has a port for each of its words.
struct divider {
  explicit divider(VerilatedContext* context) : model(context) {}
  void eval() {
    constexpr int numerator = formats::clip::width, denominator = formats::depth::width, quotient = formats::screen::width;
    model.clk_i = clk_i;
    model.num_i = get_bits<64>(in_i, 0, numerator).limb[0];
    model.den_i = static_cast<std::uint32_t>(get_bits<64>(in_i, numerator, denominator).limb[0]);
    model.eval();
    out_o = model.quotient_o | static_cast<std::uint64_t>(model.clipped_o) << quotient;
  }
  Vdivide model;
  unsigned char clk_i = 0;
  std::array<std::uint32_t, 3> in_i{};
  std::uint64_t out_o = 0;
};

template <class Model>
void add(char const* unit, int latency) {
  add_unit_circuit(unit, pipeline_circuit<Model>(unit, latency));
}

// The latencies that the units' tests assert.
const bool all_added = [] {
  add<divider>("divide", 25);
  add<Vnormalize>("normalize", 21);
  add<Vdisplace>("displace", 10);
  add<Vbump>("bump", 31);
  add<Vtransform>("transform", 32);
  add<Vtransform_normal>("transform_normal", 6);
  add<Vcalculate_new_p>("calculate_new_p", 4);
  add<Vcalculate_new_u>("calculate_new_u", 4);
  add<Vcalculate_new_n>("calculate_new_n", 25);
  add<Vnormal_test>("normal_test", 3);
  add<Vview_test>("view_test", 4);
  add<Vtex_coord_test>("tex_coord_test", 2);
  add<Vhighlight_test>("highlight_test", 4);
  add<Vpass_or_tessellate>("pass_or_tessellate", 1);
  return true;
}();

}  // namespace
}  // namespace relievo::tb

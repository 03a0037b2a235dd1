// The model "top" in a build without the engine's register block, of which PeakRDL makes its circuit and the driver's header.
#include "tb/cosim/top_model.hpp"

namespace relievo::tb {

void add_top_model() {
  leave_out_model("top",
                  "needs the engine's register block, which this build does not have: scripts/build.sh release relievo makes one with it");
}
std::unique_ptr<model> make_top_model(scene const&, std::function<void(host_job&)> const&) {
  check_model_name("top");
  return nullptr;
}
void set_top_settings(cosim_settings const&) {}
top_result const& last_top_result() {
  static const top_result none;
  return none;
}

}  // namespace relievo::tb

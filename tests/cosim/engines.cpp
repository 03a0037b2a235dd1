#include "tests/cosim/engines.hpp"

#include "tb/cosim/rtl_model.hpp"

namespace relievo::test {

#if !RELIEVO_CAMPAIGN
void add_campaign_engines() {}
#endif

cosim_run run_circuit(tb::scene const& sc, tb::cosim_settings const& settings) {
  static const bool added = [] {
    tb::add_rtl_model();
    add_small_engine();
    add_wide_engine();
    add_campaign_engines();
    return true;
  }();
  (void)added;
  tb::set_cosim_settings(settings);
  cosim_run result;
  result.run = tb::run_model("rtl", sc);
  result.circuit = tb::last_cosim_result();
  return result;
}

}  // namespace relievo::test

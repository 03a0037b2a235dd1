// relievo_wrong: the model top whose host does what a host may not, for every error of the engine's state register that can be raised from
// outside (an overflow of the queue cannot). The names are those of the errors: host-early-last and so on.
#include "hls/core/formats.hpp"
#include "tb/cosim/top_model.hpp"

namespace relievo::test {
namespace {

using tb::host_job;

template <void Change(host_job&)>
std::unique_ptr<tb::model> make(tb::scene const& sc) {
  return tb::make_top_model(sc, Change);
}

void map_size_zero(host_job& j) { j.regs.map.width = hls::from_raw<formats::map_size>(0); }
void map_size_too_large(host_job& j) { j.regs.map.height = hls::from_raw<formats::map_size>(8193); }
void max_generation_too_large(host_job& j) { j.regs.pass.max_generation = hls::from_raw<formats::generation>(13); }
void early_last(host_job& j) { ++j.expected; }
void missing_last(host_job& j) { j.base.back().last = j.base.back().word.last = false; }
void last_disagrees(host_job& j) { j.base[1].last = true; }
void coordinate_outside_map(host_job& j) {
  j.base[2].word.v[1].u[0] = hls::from_raw<formats::coordinate>(hls::fixed<formats::coordinate>::max_raw);
}
void start_while_busy(host_job& j) {
  j.meanwhile = [](tb::edge_engine_driver& driver) { driver.start(1); };
}
void map_early_last(host_job& j) { j.texels[16].last = true; }
void map_missing_last(host_job& j) { j.texels.back().last = false; }
void stopped(host_job& j) {
  j.meanwhile = [](tb::edge_engine_driver& driver) { driver.stop(); };
}
void memory_error(host_job& j) { j.memory_fails = true; }

const bool added = [] {
  tb::add_model("host-map-size-zero", make<map_size_zero>);
  tb::add_model("host-map-size-too-large", make<map_size_too_large>);
  tb::add_model("host-max-generation-too-large", make<max_generation_too_large>);
  tb::add_model("host-early-last", make<early_last>);
  tb::add_model("host-missing-last", make<missing_last>);
  tb::add_model("host-last-disagrees", make<last_disagrees>);
  tb::add_model("host-coordinate-outside-map", make<coordinate_outside_map>);
  tb::add_model("host-start-while-busy", make<start_while_busy>);
  tb::add_model("host-map-early-last", make<map_early_last>);
  tb::add_model("host-map-missing-last", make<map_missing_last>);
  tb::add_model("host-stopped", make<stopped>);
  tb::add_model("host-memory-error", make<memory_error>);
  return true;
}();

}  // namespace
}  // namespace relievo::test

#include "tb/cosim/engine_bench.hpp"

#include <filesystem>
#include <map>
#include <stdexcept>
#include <systemc>

#include "tb/cosim/waveform.hpp"
#include "tb/host/input_error.hpp"

namespace relievo::tb {

namespace {
std::map<std::string, engine_factory>& variants() {
  static std::map<std::string, engine_factory> all;
  return all;
}
}  // namespace

bool add_engine_variant(std::string const& name, engine_factory const& make) { return variants().emplace(name, make).second; }

std::vector<std::string> engine_variants() {
  std::vector<std::string> names;
  for (auto const& [name, make] : variants()) names.push_back(name);
  return names;
}

std::string gtkwave_name(std::string const& file) { return std::filesystem::path(file).replace_extension(".gtkw").string(); }

engine_bench& the_engine_bench(cosim_settings const& settings) {
  static std::unique_ptr<engine_bench> only;
  static cosim_settings made;
  if (!only) {
    const auto found = variants().find(settings.variant);
    if (found == variants().end()) throw input_error("the circuit was not built as '" + settings.variant + "'");
    sc_core::sc_report_handler::set_actions(sc_core::SC_INFO, sc_core::SC_DO_NOTHING);
    only = found->second(settings);
    made = settings;
  }
  if (!(made == settings)) throw std::logic_error("SystemC elaborates one bench a process, and this one has other settings");
  return *only;
}

}  // namespace relievo::tb

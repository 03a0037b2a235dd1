#include "tb/cosim/top_model.hpp"

#include <string>
#include <vector>

#include "Vedge_engine.h"
#include "tb/cosim/base_words.hpp"
#include "tb/cosim/edge_engine_host.hpp"
#include "tb/cosim/map_ports.hpp"
#include "tb/model/hls_words.hpp"
#include "tb/model/words.hpp"

namespace relievo::tb {

namespace {

cosim_settings& settings() {
  static cosim_settings s;
  return s;
}
top_result& last_result() {
  static top_result r;
  return r;
}

bus_traffic traffic_of(cosim_settings const& s) { return {s.idle, s.stall, s.latency_low, s.latency_high, s.bursty, s.seed, s.reset_seed}; }

// Clocks between two reads of the state: often enough for an error, too seldom to cost anything.
constexpr int poll_clocks = 256;

class top_model : public model {
 public:
  top_model(scene const& sc, std::function<void(host_job&)> const& change)
      : watchdog_(settings().watchdog), host_(traffic_of(settings()), [](std::string const& what) { throw cosim_error(what, "top"); }) {
    bool exact = to_hls(sc.regs, job_.regs) && to_hls(sc.normal_map, job_.normal_regs);
    for (golden::triangle const& t : sc.triangles) {
      hls::triangle converted{};
      exact = to_hls(t, converted) && exact;
      job_.base.push_back({base_of(converted), converted.last});
    }
    if (!exact) throw std::logic_error("a register or a base triangle of the scene is not quantised to its format");
    for (std::uint16_t const t : sc.map.texels) job_.texels.push_back({t, false});
    job_.texels.back().last = true;
    job_.expected = static_cast<std::uint32_t>(job_.base.size());
    if (change) change(job_);

    table_.resize(sc.map.texels.size());
    normals_.resize(sc.map.texels.size());
    host_.memories.load({sc.map.width, sc.map.height, sc.map.texels.data(), table_.data(), normals_.data()});
    const auto into = [this, width = sc.map.width](std::vector<std::uint64_t>& memory, char const* name) {
      return [this, &memory, name, width](int x, int y, std::uint64_t word) {
        const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
        if (x >= width || at >= memory.size())
          throw cosim_error(std::string(name) + ": word (" + std::to_string(x) + ", " + std::to_string(y) + ") is not of the map", "top");
        memory[at] = word;
        ++words_written_;
        last_written_ = host_.clocks;
      };
    };
    host_.table_word = into(table_, "table_write");
    host_.normal_word = into(normals_, "normal_write");
    build_maps();
  }

  golden::counters run(run_hooks const& hooks) override {
    golden::triangle_out converted;
    bool over = false;
    std::uint64_t last_clock = 0;
    host_.triangle = [&](hls::triangle_out const& t) {
      if (over) throw cosim_error("m_axis: a triangle follows the last", "top");
      over = t.last;
      last_clock = host_.clocks;
      if (!hooks.out) return;
      to_golden(t, converted);
      hooks.out(converted);
    };
    host_.driver.set(job_.regs);
    const std::uint64_t begun = host_.clocks;
    host_.driver.start(job_.expected);
    host_.memories.error_next = job_.memory_fails;
    if (job_.meanwhile) job_.meanwhile(host_.driver);
    host_.base.assign(job_.base.begin(), job_.base.end());
    while (!until_quiet("the mesh is not done").done || !over) {
      if (hooks.progress) hooks.progress(job_.base.size() - host_.base.size());
    }
    if (!host_.idle()) throw cosim_error("s_axis: base triangles were left when the mesh was done", "top");
    last_result() = {host_.driver.build(), map_clocks_, last_clock - begun};
    return named_counters(words_of_counters(host_.driver.counters()), host_.driver.normal_saturations());
  }
  bool in_order() const override { return false; }

 private:
  // Lanes, table reads and profile samples a clock of model_Vedge_engine (rtl/CMakeLists.txt).
  using memories = map_ports<Vedge_engine, 1, 3, 1>;

  // Some clocks, and the state after them, without an error.
  edge_engine_state until_quiet(char const* what) {
    host_.clock(poll_clocks);
    const edge_engine_state state = host_.driver.state();
    host_.driver.check(state);
    if (host_.quiet_clocks() > watchdog_)
      throw cosim_error(host_.stopped() + "; nothing moved for " + std::to_string(host_.quiet_clocks()) + " clocks, and " + what + "; " +
                            std::to_string(host_.base.size()) + " base triangles and " + std::to_string(host_.texels.size()) +
                            " texels wait, clock " + std::to_string(host_.clocks),
                        "top");
    return state;
  }

  void build_maps() {
    host_.driver.set(job_.regs);
    host_.driver.set(job_.normal_regs);
    host_.texels = std::move(job_.texels);
    const std::uint64_t begun = host_.clocks;
    while (until_quiet("the maps are not built").map_busy || !host_.texels.empty()) {
    }
    if (words_written_ != table_.size() + normals_.size())
      throw cosim_error(
          "table_write, normal_write: " + std::to_string(words_written_) + " words came of two maps of " + std::to_string(table_.size()),
          "top");
    map_clocks_ = last_written_ - begun;
  }

  host_job job_;
  std::uint64_t watchdog_, map_clocks_ = 0, words_written_ = 0, last_written_ = 0;
  std::vector<std::uint64_t> table_, normals_;
  edge_engine_host<Vedge_engine, memories> host_;
};

}  // namespace

void add_top_model() {
  add_model("top", [](scene const& sc) { return make_top_model(sc, {}); });
}
std::unique_ptr<model> make_top_model(scene const& sc, std::function<void(host_job&)> const& change) {
  return std::make_unique<top_model>(sc, change);
}
void set_top_settings(cosim_settings const& s) { settings() = s; }
top_result const& last_top_result() { return last_result(); }

}  // namespace relievo::tb

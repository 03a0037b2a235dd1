// engine_bench_of: the bench around one Verilated engine; included by one source file a variant, because of what it costs to compile.
#pragma once
#include <algorithm>
#include <stdexcept>

#include "tb/cosim/engine_device.hpp"
#include "tb/cosim/map_lookup.hpp"
#include "tb/cosim/stream_ends.hpp"

namespace relievo::tb {

namespace detail {

template <class Model, int Lanes, int Reads, int Samples>
class bench final : public engine_bench {
  using links_type = engine_links<Lanes, Reads, Samples>;
  using base_word = typename links_type::base_word;
  using out_word = typename links_type::out_word;
  using table_memory = memory<typename links_type::table_requests, typename links_type::table_answers>;
  using quad_memory = memory<typename links_type::quad_requests, typename links_type::quad_answers>;
  using place_memory = memory<quad_request, texel_quad>;
  using normal_memory = memory<quad_request, normal_quad>;

 public:
  explicit bench(cosim_settings const& settings)
      : settings_(settings),
        device_("engine", links_, wires_, settings),
        source_("source", links_.in, wires_, pacer(settings.idle, settings.seed)),
        sink_("sink", links_.out, wires_, pacer(settings.stall, settings.seed + 1)) {
    check("check_in", links_.in, true);
    check("check_out", links_.out, true);
    for (int i = 0; i < Lanes; ++i) add_lane(i);
    sink_.take = [this](out_word const& word) {
      const hls::triangle_out t = hls::unpack<hls::triangle_out>(word);
      if (last_seen_) wires_.fail("output triangles: a record follows the last");
      last_seen_ = t.last;
      if (t.last) last_clock_ = wires_.clocks;
      if (take_) take_(t);
    };
  }

  cosim_result run(cosim_scene const& scene, std::function<void(hls::triangle_out const&)> const& out, bool reset,
                   std::uint64_t abort_after) override {
    take_ = out;
    last_seen_ = false;
    if (reset || !begun_) {
      begun_ = true;
      wires_.running.write(false);
      // As short as the circuit allows.
      advance(2);
      wires_.running.write(true);
      advance(1);
    }
    device_.regs = scene.regs;
    look_.load(contents_of(scene.regs.map, scene.memories));
    source_.load(scene.triangles);
    for (link_observer* o : observers_) o->forget();
    device_.start = true;
    advance(1);
    device_.start = false;
    const std::uint64_t begun = wires_.clocks;
    while (!(last_seen_ && device_.done())) {
      if (abort_after != 0 && wires_.clocks - begun >= abort_after) break;
      advance(abort_after != 0 ? 1 : 16);
      watch(begun);
    }
    cosim_result result;
    result.counters = device_.counters();
    result.clocks = last_clock_ - begun;
    for (link_observer const* o : observers_) {
      link_counts const& c = o->counts();
      const auto clocks = static_cast<double>(c.moved + c.waited + c.idle);
      result.links.push_back(
          {c.name, c.moved, c.waited, c.idle, o->is_answers(), static_cast<double>(c.in_flight_clocks) / clocks, c.most_in_flight});
    }
    if (abort_after == 0) {
      // Nothing may stay behind.
      advance(64);
      if (source_.sent() != scene.triangles->size()) wires_.fail("base triangles: some were not taken");
      for (auto const& empty : memories_empty_)
        if (!empty()) wires_.fail("an answer of a memory was not waited for");
      if (device_.error()) wires_.fail("the triangle queue overflowed");
      throw_failure();
    }
    device_.wave().close();
    if (!device_.wave().begun())
      throw input_error("--trace-from: " + std::to_string(settings_.trace_from) + " is after the last clock of this run, which is " +
                        std::to_string(wires_.clocks));
    return result;
  }

 private:
  void advance(int clocks) {
    sc_core::sc_start(clocks, sc_core::SC_NS);
    throw_failure();
  }
  void throw_failure() {
    if (wires_.failure.empty()) return;
    const std::string what = wires_.failure;
    wires_.failure.clear();
    fail(what);
  }
  // What the waveform has until here is what one wants to see.
  [[noreturn]] void fail(std::string const& what) {
    device_.wave().close();
    throw cosim_error(what);
  }
  // The link where it stopped: a memory that owes an answer; else a word that nobody takes, those behind the circuit first, the
  // base triangles last; else the circuit itself, from which nothing comes any more.
  std::string stopped() const {
    for (link_observer const* o : observers_)
      if (o->counts().in_flight != 0) return o->counts().name + " do not come, " + std::to_string(o->counts().in_flight) + " are awaited";
    for (link_observer const* o : observers_)
      if (o->counts().waiting && o->counts().name != links_.in.name) return o->counts().name + " are not taken";
    return links_.in.valid.read() ? links_.in.name + " are not taken" : links_.out.name + " do not come, and the circuit asks for nothing";
  }
  void watch(std::uint64_t begun) {
    std::uint64_t quiet = wires_.clocks - begun;
    for (link_observer const* o : observers_) quiet = std::min(quiet, o->counts().quiet);
    if (quiet < settings_.watchdog) return;
    std::string text = "nothing moved for " + std::to_string(quiet) + " clocks, and " + stopped() + "; all links:";
    for (link_observer const* o : observers_) {
      link_counts const& c = o->counts();
      text += " " + c.name + (c.waiting ? ": a word waits" : ": idle") + " after " + std::to_string(c.moved) + ";";
    }
    fail(text + " clock " + std::to_string(wires_.clocks));
  }

  template <class Word>
  link_observer const* check(char const* name, link<Word>& l, bool has_ready, link_observer const* requests = nullptr) {
    auto checker = std::make_shared<link_checker<Word>>(sc_core::sc_gen_unique_name(name), l, wires_, has_ready, requests);
    observers_.push_back(checker.get());
    modules_.push_back(checker);
    return checker.get();
  }
  template <class Memory, class Port, class LookUp>
  void add_memory(char const* name, Port& port, int lane, LookUp const& look_up) {
    const std::uint64_t seed = settings_.seed + 10 + static_cast<std::uint64_t>(modules_.size());
    bus_traffic traffic;
    traffic.latency_low = settings_.latency_low, traffic.latency_high = settings_.latency_high;
    traffic.bursty = settings_.bursty;
    traffic.seed = seed * 977;
    auto m = std::make_shared<Memory>(sc_core::sc_gen_unique_name(name), port.requests, port.answers, wires_, pacer(settings_.stall, seed),
                                      answer_times(traffic, static_cast<std::uint64_t>(lane)));
    m->look_up = look_up;
    memories_empty_.push_back([m] { return m->empty(); });
    modules_.push_back(m);
    link_observer const* requests = check("check_requests", port.requests, true);
    check("check_answers", port.answers, false, requests);
  }
  void add_lane(int i) {
    auto& lane = *links_.lanes[static_cast<std::size_t>(i)];
    add_memory<table_memory>("table", lane.table, i, [this](typename links_type::table_requests const& r) { return look_.table_words(r); });
    add_memory<quad_memory>("quad", lane.quad, i, [this](typename links_type::quad_requests const& r) {
      std::uint64_t wanted = 0;
      for (int n = 0; n < Samples; ++n) wanted |= static_cast<std::uint64_t>(r.wanted[n]) << n;
      return look_.wanted_texels(r.quads, wanted);
    });
    add_memory<place_memory>("place", lane.place, i, [this](quad_request const& r) { return look_.texels(r); });
    add_memory<normal_memory>("normal", lane.normal, i, [this](quad_request const& r) { return look_.normals(r); });
  }

  cosim_settings settings_;
  bench_wires wires_;
  links_type links_;
  engine_device<Model, Lanes, Reads, Samples> device_;
  source<base_word> source_;
  sink<out_word> sink_;
  std::vector<std::shared_ptr<sc_core::sc_module>> modules_;
  std::vector<link_observer*> observers_;
  std::vector<std::function<bool()>> memories_empty_;
  map_lookup look_{[this](std::string const& what) { wires_.fail(what); }};
  std::function<void(hls::triangle_out const&)> take_;
  bool begun_ = false;
  bool last_seen_ = false;
  std::uint64_t last_clock_ = 0;
};

}  // namespace detail

template <class Model, int Lanes, int Reads, int Samples>
engine_factory engine_of() {
  return [](cosim_settings const& settings) -> std::unique_ptr<engine_bench> {
    return std::make_unique<detail::bench<Model, Lanes, Reads, Samples>>(settings);
  };
}

}  // namespace relievo::tb

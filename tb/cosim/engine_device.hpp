// engine_device: the Verilated engine as a SystemC module between links.
//   At a rising edge it takes the inputs that stood before the edge, and its outputs are seen after it: every output of the engine comes
//   from a register. That is checked of its valids and readies: one that moves when only inputs do is an error.
#pragma once
#include <verilated.h>

#include <array>
#include <memory>

#include "tb/cosim/coverage.hpp"
#include "tb/cosim/engine_bench.hpp"
#include "tb/cosim/link.hpp"
#include "tb/cosim/map_words.hpp"
#include "tb/cosim/ports.hpp"
#include "tb/cosim/ports_of_lanes.hpp"
#include "tb/cosim/waveform.hpp"

namespace relievo::tb {

// Words of the links of an engine with so many lanes, table reads and profile samples a clock.
template <int Lanes, int Reads, int Samples>
struct engine_links {
  using base_word = hls::port_word<hls::top::base_triangle>;
  using out_word = hls::port_word<hls::triangle_out>;
  using table_requests = group<table_request, Reads>;
  using table_answers = group<table_word, Reads>;
  using quad_requests = wanted_quads<Samples>;
  using quad_answers = group<texel_quad, Samples>;

  template <class Request, class Answer>
  struct port {
    explicit port(std::string const& name) : requests(name + " requests"), answers(name + " answers") {}
    link<hls::port_word<Request>> requests;
    link<hls::port_word<Answer>> answers;
  };
  struct lane {
    explicit lane(std::string const& n)
        : table(n + "summed-area table"), quad(n + "profile samples"), place(n + "displacement"), normal(n + "normal map") {}
    port<table_requests, table_answers> table;
    port<quad_requests, quad_answers> quad;
    port<quad_request, texel_quad> place;
    port<quad_request, normal_quad> normal;
  };

  engine_links() : in("base triangles"), out("output triangles") {
    for (int i = 0; i < Lanes; ++i) lanes.push_back(std::make_unique<lane>(Lanes == 1 ? "" : "lane " + std::to_string(i) + ", "));
  }
  link<base_word> in;
  link<out_word> out;
  std::vector<std::unique_ptr<lane>> lanes;
};

template <class Model, int Lanes, int Reads, int Samples>
class engine_device : public sc_core::sc_module {
 public:
  SC_HAS_PROCESS(engine_device);
  using links = engine_links<Lanes, Reads, Samples>;
  engine_device(sc_core::sc_module_name name, links& l, bench_wires& wires, cosim_settings const& settings)
      : sc_module(name), links_(l), wires_(wires) {
    context_.randReset(2);
    // An assertion of the circuit that fails is a failure of the run, not the end of the program.
    context_.fatalOnError(false);
    context_.randSeed(settings.reset_seed);
    context_.traceEverOn(!settings.trace.empty());
    model_ = std::make_unique<Model>(&context_);
    wave_ = std::make_unique<waveform<Model>>(settings, *model_);
    model_->clk_i = 0;
    model_->rst_ni = 0;
    model_->start_i = 0;
    model_->end_i = 0;
    model_->eval();
    SC_METHOD(edge);
    sensitive << wires.clock.posedge_event();
    dont_initialize();
  }
  // A model's parts look for their context in the thread, where another model's may be the last that was set, and gone.
  ~engine_device() override {
    Verilated::threadContextp(&context_);
    model_->final();
  }

  bool start = false;
  hls::engine_regs regs{};
  bool done() const { return model_->done_o != 0; }
  bool error() const { return model_->error_o != 0; }
  std::vector<std::uint64_t> counters() const {
    std::vector<std::uint64_t> list;
    list.reserve(hls::top::counter_words);
    for (int i = 0; i < hls::top::counter_words; ++i) list.push_back(get_bits<64>(model_->counters_o, 64 * i, 64).limb[0]);
    return list;
  }
  waveform<Model>& wave() { return *wave_; }

 private:
  template <class Request, class Answer, class Port>
  void put_port(typename links::template port<Request, Answer> const& p, int lane, std::uint32_t& ready, std::uint32_t& valid,
                Port& answer) {
    ready |= static_cast<std::uint32_t>(p.requests.ready.read()) << lane;
    const bool comes = p.answers.valid.read();
    valid |= static_cast<std::uint32_t>(comes) << lane;
    constexpr int width = hls::field_width<Answer>::value;
    if (comes) put_bits(answer, lane * width, p.answers.word.read(), width);
  }
  template <class Request, class Answer, class Valid, class Port>
  void get_port(typename links::template port<Request, Answer>& p, int lane, Valid const& valid, Port const& request) {
    const bool asks = ((static_cast<std::uint32_t>(valid) >> lane) & 1) != 0;
    p.requests.valid.write(asks);
    constexpr int width = hls::field_width<Request>::value;
    if (asks) p.requests.word.write(get_bits<(width + 7) / 8 * 8>(request, lane * width, width));
  }

  // The mask of the profile's quads is a port of its own.
  void get_quads(typename links::template port<typename links::quad_requests, typename links::quad_answers>& p, int lane) {
    const bool asks = ((static_cast<std::uint32_t>(model_->quad_req_valid_o) >> lane) & 1) != 0;
    p.requests.valid.write(asks);
    if (!asks) return;
    constexpr int width = Samples * hls::field_width<quad_request>::value;
    hls::port_word<typename links::quad_requests> word = get_bits<(width + Samples + 7) / 8 * 8>(model_->quad_req_o, lane * width, width);
    const std::uint64_t mask = get_bits<64>(model_->quad_req_mask_o, lane * Samples, Samples).limb[0];
    for (int n = 0; n < Samples; ++n) word.limb[(width + n) / 64] |= ((mask >> n) & 1) << ((width + n) % 64);
    p.requests.word.write(word);
  }

  void put_inputs() {
    Model& m = *model_;
    m.rst_ni = wires_.running.read();
    m.start_i = start;
    put(m.regs_i, regs);
    m.in_valid_i = links_.in.valid.read();
    if (m.in_valid_i) put_bits(m.in_i, 0, links_.in.word.read(), hls::field_width<hls::top::base_triangle>::value);
    m.out_ready_i = links_.out.ready.read();
    std::uint32_t ready[4] = {}, valid[4] = {};
    for (int i = 0; i < Lanes; ++i) {
      auto& lane = *links_.lanes[static_cast<std::size_t>(i)];
      put_port(lane.table, i, ready[0], valid[0], m.table_rsp_i);
      put_port(lane.quad, i, ready[1], valid[1], m.quad_rsp_i);
      put_port(lane.place, i, ready[2], valid[2], m.place_rsp_i);
      put_port(lane.normal, i, ready[3], valid[3], m.normal_rsp_i);
    }
    const auto bits = [](std::uint32_t x) { return static_cast<CData>(x); };
    m.table_req_ready_i = bits(ready[0]), m.table_rsp_valid_i = bits(valid[0]);
    m.quad_req_ready_i = bits(ready[1]), m.quad_rsp_valid_i = bits(valid[1]);
    m.place_req_ready_i = bits(ready[2]), m.place_rsp_valid_i = bits(valid[2]);
    m.normal_req_ready_i = bits(ready[3]), m.normal_rsp_valid_i = bits(valid[3]);
  }
  // The handshake outputs in one word, to see them move.
  std::array<CData, 6> handshake() const {
    Model const& m = *model_;
    return {m.in_ready_o, m.out_valid_o, m.table_req_valid_o, m.quad_req_valid_o, m.place_req_valid_o, m.normal_req_valid_o};
  }
  void get_outputs() {
    Model const& m = *model_;
    links_.in.ready.write(m.in_ready_o != 0);
    links_.out.valid.write(m.out_valid_o != 0);
    if (m.out_valid_o) {
      constexpr int width = hls::field_width<hls::triangle_out>::value;
      links_.out.word.write(get_bits<(width + 7) / 8 * 8>(m.out_o, 0, width));
    }
    for (int i = 0; i < Lanes; ++i) {
      auto& lane = *links_.lanes[static_cast<std::size_t>(i)];
      get_port(lane.table, i, m.table_req_valid_o, m.table_req_o);
      get_quads(lane.quad, i);
      get_port(lane.place, i, m.place_req_valid_o, m.place_req_o);
      get_port(lane.normal, i, m.normal_req_valid_o, m.normal_req_o);
    }
  }

  void edge() {
    ++wires_.clocks;
    const auto before = handshake();
    put_inputs();
    model_->eval();
    wave_->before_edge(wires_.clocks);
    static char const* const names[6] = {
        "base triangles: ready",           "output triangles: valid",      "summed-area table requests: valid",
        "profile samples requests: valid", "displacement requests: valid", "normal map requests: valid"};
    const auto now = handshake();
    if (model_->rst_ni && was_running_)
      for (std::size_t i = 0; i < now.size(); ++i)
        if (now[i] != before[i]) wires_.fail(std::string(names[i]) + " follows an input of the same clock");
    was_running_ = model_->rst_ni != 0;
    model_->clk_i = 1;
    model_->eval();
    wave_->after_edge(wires_.clocks);
    model_->clk_i = 0;
    kept_.begin();
    if (context_.gotError()) wires_.fail("an assertion of the circuit failed, which it has printed");
    get_outputs();
  }

  VerilatedContext context_;
  std::unique_ptr<Model> model_;
  std::unique_ptr<waveform<Model>> wave_;
  keep_coverage kept_{context_};
  links& links_;
  bench_wires& wires_;
  bool was_running_ = false;
};

}  // namespace relievo::tb

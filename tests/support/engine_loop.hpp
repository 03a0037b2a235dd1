// engine_loop: the Verilated edge engine, of one lane, in a bare loop of clocks: a source of base triangles, a sink, and a memory behind
// each read port. What the bench of tb/cosim does, without SystemC and without checkers on every link.
//
//   engine_loop<Model, Reads, Samples> loop(reset_seed)   Reads table words and Samples quads of a profile a clock; reset, then running
//   loop.run(scene, traffic, out)   one mesh, with other registers than the last without a reset -> clocks from the one with start_i to
//                                   the one in which the last record leaves, both counted
//   loop.end_input()                what the next run does in the clock after its last base triangle was taken: end_i; for meshes whose
//                                   last base triangle does not say so
//   loop.counters()                 of the last mesh, in the order of hls/edge/counters.hpp
//   Errors: cosim_error when a record does not hold until it is taken, a memory is asked for what it does not hold, something stays
//   behind, the queue overflows, or no record and no base triangle moves for traffic.watchdog clocks.
#pragma once
#include <verilated.h>

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tb/cosim/coverage.hpp"
#include "tb/cosim/engine_bench.hpp"
#include "tb/cosim/map_lookup.hpp"
#include "tb/cosim/pacer.hpp"
#include "tb/cosim/ports.hpp"
#include "tb/cosim/ports_of_lanes.hpp"

namespace relievo::test {

template <class Model, int Reads, int Samples>
class engine_loop {
 public:
  explicit engine_loop(int reset_seed = 1) {
    context_.randReset(2);
    context_.randSeed(reset_seed);
    model_ = std::make_unique<Model>(&context_);
    Model& m = *model_;
    m.clk_i = m.rst_ni = m.start_i = m.end_i = m.in_valid_i = m.out_ready_i = 0;
    m.table_req_ready_i = m.quad_req_ready_i = m.place_req_ready_i = m.normal_req_ready_i = 0;
    m.table_rsp_valid_i = m.quad_rsp_valid_i = m.place_rsp_valid_i = m.normal_rsp_valid_i = 0;
    for (int i = 0; i < 2; ++i) {
      edge();
      kept_.begin();
    }
    m.rst_ni = 1;
    edge();
  }
  ~engine_loop() {
    model_->final();
    Verilated::threadContextp(&context_);
  }
  engine_loop(engine_loop const&) = delete;
  engine_loop& operator=(engine_loop const&) = delete;

  using take_record = std::function<void(hls::triangle_out const&)>;
  std::uint64_t run(tb::cosim_scene const& scene, tb::cosim_settings const& traffic, take_record const& out) {
    scene_ = &scene;
    look_.load(tb::contents_of(scene.regs.map, scene.memories));
    out_ = &out;
    source_ = tb::pacer(traffic.idle, traffic.seed);
    sink_ = tb::pacer(traffic.stall, traffic.seed + 1);
    table_.begin(traffic, 2), quads_.begin(traffic, 3), place_.begin(traffic, 4), normals_.begin(traffic, 5);
    at_ = 0;
    offered_ = last_seen_ = ended_ = false;
    tb::put(model_->regs_i, scene.regs);
    const std::uint64_t begun = clocks_;
    model_->start_i = 1;
    edge();
    model_->start_i = 0;
    for (moved_ = clocks_; !last_seen_; clock())
      if (clocks_ - moved_ > traffic.watchdog)
        fail("no record and no base triangle moved for " + std::to_string(traffic.watchdog) + " clocks");
    const std::uint64_t taken = clocks_ - begun;
    // Nothing may follow, and nothing stay behind.
    for (int i = 0; i < 64; ++i) clock();
    if (!model_->done_o) fail("the last record is out and the engine not done");
    if (model_->error_o) fail("the triangle queue overflowed");
    if (at_ != scene.triangles->size()) fail("base triangles were left");
    if (!table_.pending.empty() || !quads_.pending.empty() || !place_.pending.empty() || !normals_.pending.empty())
      fail("an answer of a memory was not waited for");
    end_input_ = false;
    return taken;
  }
  void end_input() { end_input_ = true; }

  std::vector<std::uint64_t> counters() const {
    std::vector<std::uint64_t> list;
    for (int i = 0; i < hls::top::counter_words; ++i) {
      const auto word = [&](int half) { return static_cast<std::uint64_t>(model_->counters_o[static_cast<std::size_t>(2 * i + half)]); };
      list.push_back(word(0) | word(1) << 32);
    }
    return list;
  }

 private:
  template <class Answer>
  struct memory {
    std::deque<std::pair<std::uint64_t, Answer>> pending;  // the clock from which an answer may come
    tb::pacer pace{0, 0};
    tb::answer_times times{{}, 0};

    void begin(tb::cosim_settings const& traffic, std::uint64_t salt) {
      pace = tb::pacer(traffic.stall, traffic.seed + salt);
      tb::bus_traffic t;
      t.latency_low = traffic.latency_low, t.latency_high = traffic.latency_high;
      t.bursty = traffic.bursty;
      t.seed = traffic.seed * 977;
      times = tb::answer_times(t, salt);
    }
  };

  [[noreturn]] void fail(std::string const& what) const { throw tb::cosim_error(what + ", clock " + std::to_string(clocks_)); }

  // A memory in this clock: what it answers, and what it is asked.
  template <class Answer, class Word, class Ask>
  void serve(memory<Answer>& m, CData asks, CData& ready, CData& answers, Word& answer, Ask ask) {
    answers = m.times.open(clocks_) && !m.pending.empty() && m.pending.front().first <= clocks_;
    if (answers) {
      tb::put(answer, m.pending.front().second);
      m.pending.pop_front();
    }
    ready = m.pace.go();
    if (!asks || !ready) return;
    const std::uint64_t due = m.times.due(clocks_, m.pending.empty() ? 0 : m.pending.back().first);
    m.pending.emplace_back(due, ask());
  }

  void clock() {
    Model& m = *model_;
    // All outputs come from registers: what stands on them now is what the coming edge moves.
    if (!offered_ && at_ < scene_->triangles->size() && source_.go()) {
      tb::put_bits(m.in_i, 0, (*scene_->triangles)[at_], hls::field_width<hls::top::base_triangle>::value);
      offered_ = true;
    }
    m.in_valid_i = offered_;
    m.end_i = end_input_ && !ended_ && at_ == scene_->triangles->size();
    ended_ = ended_ || m.end_i != 0;
    if (offered_ && m.in_ready_o) {
      offered_ = false;
      ++at_;
      moved_ = clocks_;
    }
    m.out_ready_i = sink_.go();
    take_output();
    serve(table_, m.table_req_valid_o, m.table_req_ready_i, m.table_rsp_valid_i, m.table_rsp_i,
          [&] { return look_.table_words(tb::get<tb::group<tb::table_request, Reads>>(m.table_req_o)); });
    serve(quads_, m.quad_req_valid_o, m.quad_req_ready_i, m.quad_rsp_valid_i, m.quad_rsp_i,
          [&] { return look_.wanted_texels(tb::get<tb::group<tb::quad_request, Samples>>(m.quad_req_o), m.quad_req_mask_o); });
    serve(place_, m.place_req_valid_o, m.place_req_ready_i, m.place_rsp_valid_i, m.place_rsp_i,
          [&] { return look_.texels(tb::get<tb::quad_request>(m.place_req_o)); });
    serve(normals_, m.normal_req_valid_o, m.normal_req_ready_i, m.normal_rsp_valid_i, m.normal_rsp_i,
          [&] { return look_.normals(tb::get<tb::quad_request>(m.normal_req_o)); });
    edge();
  }

  void take_output() {
    Model const& m = *model_;
    if (!m.out_valid_o) {
      if (held_) fail("out_valid fell before the record was taken");
      return;
    }
    if (!held_ && !m.out_ready_i) {
      held_ = true;
      held_word_ = hls::pack(tb::get<hls::triangle_out>(m.out_o));
      return;
    }
    const hls::triangle_out t = tb::get<hls::triangle_out>(m.out_o);
    if (held_ && hls::pack(t) != held_word_) fail("the record changed before it was taken");
    if (!m.out_ready_i) return;
    held_ = false;
    if (last_seen_) fail("a record follows the last");
    last_seen_ = t.last;
    moved_ = clocks_;
    (*out_)(t);
  }

  void edge() {
    model_->eval();
    model_->clk_i = 1;
    model_->eval();
    model_->clk_i = 0;
    ++clocks_;
  }

  VerilatedContext context_;
  std::unique_ptr<Model> model_;
  tb::keep_coverage kept_{context_};
  tb::cosim_scene const* scene_ = nullptr;
  tb::map_lookup look_{[this](std::string const& what) { fail(what); }};
  take_record const* out_ = nullptr;
  tb::pacer source_{0, 0}, sink_{0, 0};
  memory<tb::group<tb::table_word, Reads>> table_;
  memory<tb::group<tb::texel_quad, Samples>> quads_;
  memory<tb::texel_quad> place_;
  memory<tb::normal_quad> normals_;
  std::size_t at_ = 0;
  std::uint64_t clocks_ = 0, moved_ = 0;
  bool offered_ = false, last_seen_ = false, end_input_ = false, ended_ = false, held_ = false;
  hls::port_word<hls::triangle_out> held_word_{};
};

}  // namespace relievo::test

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
#include "tb/cosim/map_words.hpp"
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
    traffic_ = traffic;
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
    std::minstd_rand random{};

    void begin(tb::cosim_settings const& traffic, std::uint64_t salt) {
      pace = tb::pacer(traffic.stall, traffic.seed + salt);
      random.seed(static_cast<std::minstd_rand::result_type>(traffic.seed * 977 + salt));
    }
  };

  [[noreturn]] void fail(std::string const& what) const { throw tb::cosim_error(what + ", clock " + std::to_string(clocks_)); }

  std::size_t place_of(hls::fixed<formats::map_size> x, hls::fixed<formats::map_size> y) const {
    hls::map_regs const& map = scene_->regs.map;
    if (raw(x) >= raw(map.width) || raw(y) >= raw(map.height))
      fail("word (" + std::to_string(raw(x)) + ", " + std::to_string(raw(y)) + ") of a map was asked for that has none there");
    return static_cast<std::size_t>(raw(y) * raw(map.width) + raw(x));
  }
  tb::texel_quad texels(tb::quad_request const& r) const {
    tb::texel_quad q{};
    for (int row = 0; row < 2; ++row)
      for (int column = 0; column < 2; ++column)
        q.q[row][column] = hls::from_raw<formats::texel>(scene_->memories.displacement.words[place_of(r.x[column], r.y[row])]);
    return q;
  }
  tb::normal_quad normals(tb::quad_request const& r) const {
    tb::normal_quad q{};
    for (int row = 0; row < 2; ++row)
      for (int column = 0; column < 2; ++column) {
        const std::uint64_t word = scene_->memories.normals.words[place_of(r.x[column], r.y[row])];
        for (int k = 0; k < 3; ++k) q.q[row][column][k] = hls::unpack_normal(word, k);
      }
    return q;
  }

  // A memory in this clock: what it answers, and what it is asked.
  template <class Answer, class Word, class Ask>
  void serve(memory<Answer>& m, CData asks, CData& ready, CData& answers, Word& answer, Ask ask) {
    const bool open = !traffic_.bursty || clocks_ % 64 >= 32;
    answers = open && !m.pending.empty() && m.pending.front().first <= clocks_;
    if (answers) {
      tb::put(answer, m.pending.front().second);
      m.pending.pop_front();
    }
    ready = m.pace.go();
    if (!asks || !ready) return;
    std::uint64_t due = clocks_ + static_cast<std::uint64_t>(traffic_.latency_low);
    const int spread = traffic_.latency_high - traffic_.latency_low;
    if (spread > 0) due += m.random() % static_cast<std::uint64_t>(spread + 1);
    if (!m.pending.empty() && m.pending.back().first >= due) due = m.pending.back().first + 1;
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
    serve(table_, m.table_req_valid_o, m.table_req_ready_i, m.table_rsp_valid_i, m.table_rsp_i, [&] {
      const auto wanted = tb::get<tb::group<tb::table_request, Reads>>(m.table_req_o);
      tb::group<tb::table_word, Reads> a{};
      for (int n = 0; n < Reads; ++n)
        if (wanted.at[n].read)
          a.at[n].word = hls::from_raw<formats::table_sum>(
              static_cast<std::int64_t>(scene_->memories.table.words[place_of(wanted.at[n].x, wanted.at[n].y)]));
      return a;
    });
    serve(quads_, m.quad_req_valid_o, m.quad_req_ready_i, m.quad_rsp_valid_i, m.quad_rsp_i, [&] {
      const auto wanted = tb::get<tb::group<tb::quad_request, Samples>>(m.quad_req_o);
      tb::group<tb::texel_quad, Samples> a{};
      for (int n = 0; n < Samples; ++n)
        if ((m.quad_req_mask_o >> n & 1) != 0) a.at[n] = texels(wanted.at[n]);
      return a;
    });
    serve(place_, m.place_req_valid_o, m.place_req_ready_i, m.place_rsp_valid_i, m.place_rsp_i,
          [&] { return texels(tb::get<tb::quad_request>(m.place_req_o)); });
    serve(normals_, m.normal_req_valid_o, m.normal_req_ready_i, m.normal_rsp_valid_i, m.normal_rsp_i,
          [&] { return normals(tb::get<tb::quad_request>(m.normal_req_o)); });
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
  tb::cosim_settings traffic_;
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

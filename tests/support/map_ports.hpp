// map_ports: the map memories behind the read ports of a Verilated edge engine of one lane, 3 table reads and 1 profile sample a clock.
//   quiet(model)      nothing is answered or taken;  load(scene)  what they hold;  forget()  what was asked before a reset
//   offer(model, traffic, g, clock)   their inputs to the model, before an edge;  take(...)  its requests, at the edge
//   Only words of the map may be asked for.
#pragma once
#include <gtest/gtest.h>

#include <cstdint>
#include <deque>
#include <utility>

#include "tb/cosim/map_words.hpp"
#include "tb/cosim/ports.hpp"
#include "tests/support/engine_scene.hpp"
#include "tests/support/stream_unit.hpp"

namespace relievo::test {

template <class Model>
class map_ports {
 public:
  using table_requests = tb::group<tb::table_request, 3>;
  using table_answers = tb::group<tb::table_word, 3>;

  void quiet(Model& m) {
    m.table_req_ready_i = m.quad_req_ready_i = m.place_req_ready_i = m.normal_req_ready_i = 0;
    m.table_rsp_valid_i = m.quad_rsp_valid_i = m.place_rsp_valid_i = m.normal_rsp_valid_i = 0;
    m.memory_error_i = 0;
  }
  // After a reset.
  void forget() {
    table_ = {};
    quad_ = place_ = {};
    normal_ = {};
  }
  void expect_nothing_asked(Model const& m) const {
    EXPECT_FALSE(m.table_req_valid_o || m.quad_req_valid_o || m.place_req_valid_o || m.normal_req_valid_o) << "in reset";
  }
  void load(engine_scene const& s) {
    scene_ = &s;
    width_ = s.map.width();
    height_ = s.map.height();
  }
  void offer(Model& m, traffic const& t, generator& g, std::uint64_t clock) {
    answer(table_, t, g, clock, m.table_req_ready_i, m.table_rsp_valid_i, m.table_rsp_i);
    answer(quad_, t, g, clock, m.quad_req_ready_i, m.quad_rsp_valid_i, m.quad_rsp_i);
    answer(place_, t, g, clock, m.place_req_ready_i, m.place_rsp_valid_i, m.place_rsp_i);
    answer(normal_, t, g, clock, m.normal_req_ready_i, m.normal_rsp_valid_i, m.normal_rsp_i);
    m.memory_error_i = error_next;
    error_next = false;
  }
  void take(Model& m, traffic const& t, generator& g, std::uint64_t clock) {
    ask<table_requests>(table_, t, g, clock, m.table_req_valid_o, m.table_req_o, [this](auto const& r) { return table_words(r); });
    const bool wanted = m.quad_req_mask_o != 0;
    ask<tb::quad_request>(quad_, t, g, clock, m.quad_req_valid_o, m.quad_req_o,
                          [&](auto const& r) { return wanted ? texel_quad(r) : tb::texel_quad{}; });
    ask<tb::quad_request>(place_, t, g, clock, m.place_req_valid_o, m.place_req_o, [this](auto const& r) { return texel_quad(r); });
    ask<tb::quad_request>(normal_, t, g, clock, m.normal_req_valid_o, m.normal_req_o, [this](auto const& r) { return normal_quad(r); });
  }

  bool error_next = false;  // in the next clock an answer is said to be none

 private:
  template <class Answer>
  struct memory {
    std::deque<std::pair<std::uint64_t, Answer>> answers;
    bool ready = false;
  };

  std::size_t at(tb::quad_request const& r, int row, int column) {
    return place(static_cast<int>(raw(r.x[column])), static_cast<int>(raw(r.y[row])));
  }
  std::size_t place(int x, int y) {
    if (x >= width_ || y >= height_) {
      ADD_FAILURE() << "word (" << x << ", " << y << ") of a map of " << width_ << " x " << height_;
      return 0;
    }
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  tb::texel_quad texel_quad(tb::quad_request const& r) {
    tb::texel_quad q{};
    for (int row = 0; row < 2; ++row)
      for (int column = 0; column < 2; ++column) q.q[row][column] = hls::from_raw<formats::texel>(scene_->map.words()[at(r, row, column)]);
    return q;
  }
  tb::normal_quad normal_quad(tb::quad_request const& r) {
    tb::normal_quad q{};
    for (int row = 0; row < 2; ++row)
      for (int column = 0; column < 2; ++column)
        for (int i = 0; i < 3; ++i) q.q[row][column][i] = hls::unpack_normal(scene_->normals[at(r, row, column)], i);
    return q;
  }
  table_answers table_words(table_requests const& r) {
    table_answers a{};
    for (int i = 0; i < 3; ++i)
      if (r.at[i].read)
        a.at[i].word = hls::from_raw<formats::table_sum>(static_cast<std::int64_t>(
            scene_->map.table().words[place(static_cast<int>(raw(r.at[i].x)), static_cast<int>(raw(r.at[i].y)))]));
    return a;
  }

  template <class Memory, class Ready, class Valid, class Port>
  void answer(Memory& from, traffic const& t, generator& g, std::uint64_t clock, Ready& ready, Valid& valid, Port& rsp) {
    from.ready = g.below(16) >= t.stall;
    ready = from.ready;
    const bool due = !from.answers.empty() && from.answers.front().first <= clock;
    valid = due;
    if (due) {
      tb::put(rsp, from.answers.front().second);
      from.answers.pop_front();
    }
  }
  template <class Request, class Memory, class Valid, class Port, class LookUp>
  void ask(Memory& to, traffic const& t, generator& g, std::uint64_t clock, Valid valid, Port const& req, LookUp look_up) {
    if (!valid || !to.ready) return;
    std::uint64_t due =
        clock + static_cast<std::uint64_t>(g.between(static_cast<std::int64_t>(t.latency_low), static_cast<std::int64_t>(t.latency_high)));
    if (!to.answers.empty() && to.answers.back().first >= due) due = to.answers.back().first + 1;
    to.answers.push_back({due, look_up(tb::get<Request>(req))});
  }

  engine_scene const* scene_ = nullptr;
  int width_ = 0, height_ = 0;
  memory<table_answers> table_;
  memory<tb::texel_quad> quad_, place_;
  memory<tb::normal_quad> normal_;
};

}  // namespace relievo::test

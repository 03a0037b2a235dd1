// map_ports: the map memories behind the read ports of a Verilated top of the edge engine, of any lanes, table reads and profile samples.
//   load(contents)    what they hold;  forget()  what was asked before a reset;  quiet(model)  nothing is answered or taken
//   offer(model, clock)   their inputs to the model, before an edge;  take(model, clock)  its requests, at the edge
//   error_next        in the next clock an answer is said to be none;  answered()  how many words went out
//   stopped()         the port where a run that stands still waits for a memory, empty: none
//   Only words of the map may be asked for: anything else goes to the failure hook, and is answered with word 0.
#pragma once
#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <utility>

#include "tb/cosim/bus_traffic.hpp"
#include "tb/cosim/map_lookup.hpp"
#include "tb/cosim/ports_of_lanes.hpp"

namespace relievo::tb {

template <class Model, int Lanes, int Reads, int Samples>
class map_ports {
 public:
  using contents = map_contents;
  using table_requests = group<table_request, Reads>;
  using table_answers = group<table_word, Reads>;
  using quad_requests = group<quad_request, Samples>;
  using quad_answers = group<texel_quad, Samples>;

  map_ports(bus_traffic const& t, failure_hook fail) : look_(std::move(fail)), table_(t, 1), quad_(t, 2), place_(t, 3), normal_(t, 4) {}

  bool error_next = false;

  void quiet(Model& m) {
    m.table_req_ready_i = m.quad_req_ready_i = m.place_req_ready_i = m.normal_req_ready_i = 0;
    m.table_rsp_valid_i = m.quad_rsp_valid_i = m.place_rsp_valid_i = m.normal_rsp_valid_i = 0;
    m.memory_error_i = 0;
  }
  void forget() {
    table_.forget();
    quad_.forget();
    place_.forget();
    normal_.forget();
  }
  bool asks(Model const& m) const { return m.table_req_valid_o || m.quad_req_valid_o || m.place_req_valid_o || m.normal_req_valid_o; }
  void load(map_contents const& c) { look_.load(c); }
  std::uint64_t answered() const { return table_.answered + quad_.answered + place_.answered + normal_.answered; }

  // An answer that is awaited, else a request that is not taken.
  std::string stopped() const {
    for (const bool awaited : {true, false})
      for (std::string const& text : {table_.stopped("table", awaited), quad_.stopped("quad", awaited), place_.stopped("place", awaited),
                                      normal_.stopped("normal", awaited)})
        if (!text.empty()) return text;
    return {};
  }

  void offer(Model& m, std::uint64_t clock) {
    table_.offer(clock, m.table_req_ready_i, m.table_rsp_valid_i, m.table_rsp_i);
    quad_.offer(clock, m.quad_req_ready_i, m.quad_rsp_valid_i, m.quad_rsp_i);
    place_.offer(clock, m.place_req_ready_i, m.place_rsp_valid_i, m.place_rsp_i);
    normal_.offer(clock, m.normal_req_ready_i, m.normal_rsp_valid_i, m.normal_rsp_i);
    m.memory_error_i = error_next;
    error_next = false;
  }
  void take(Model& m, std::uint64_t clock) {
    table_.take(clock, m.table_req_valid_o, m.table_req_o, [this](table_requests const& r, int) { return look_.table_words(r); });
    quad_.take(clock, m.quad_req_valid_o, m.quad_req_o, [&](quad_requests const& r, int lane) {
      return look_.wanted_texels(r, get_bits<64>(m.quad_req_mask_o, lane * Samples, Samples).limb[0]);
    });
    place_.take(clock, m.place_req_valid_o, m.place_req_o, [this](quad_request const& r, int) { return look_.texels(r); });
    normal_.take(clock, m.normal_req_valid_o, m.normal_req_o, [this](quad_request const& r, int) { return look_.normals(r); });
  }

 private:
  // The memories of a port, one a lane.
  template <class Request, class Answer>
  struct port {
    port(bus_traffic const& t, std::uint64_t salt) : pace(t.stall, t.seed + 10 + salt), times(t, 20 + salt) {}
    struct lane {
      std::deque<std::pair<std::uint64_t, Answer>> answers;
      bool ready = false, waits = false;
    };
    std::array<lane, Lanes> lanes;
    pacer pace;
    answer_times times;
    std::uint64_t answered = 0;

    void forget() { lanes = {}; }
    std::string stopped(std::string const& name, bool awaited) const {
      for (std::size_t i = 0; i < lanes.size(); ++i) {
        const std::string lane_name = Lanes == 1 ? std::string() : " of lane " + std::to_string(i);
        if (awaited && !lanes[i].answers.empty())
          return name + "_rsp" + lane_name + ": an answer does not come, " + std::to_string(lanes[i].answers.size()) + " are awaited";
        if (!awaited && lanes[i].waits) return name + "_req" + lane_name + ": a word is not taken";
      }
      return {};
    }
    template <class Bits, class Port>
    void offer(std::uint64_t clock, Bits& ready, Bits& valid, Port& rsp) {
      std::uint32_t readies = 0, valids = 0;
      for (int i = 0; i < Lanes; ++i) {
        lane& l = lanes[static_cast<std::size_t>(i)];
        l.ready = pace.go();
        readies |= static_cast<std::uint32_t>(l.ready) << i;
        if (l.answers.empty() || l.answers.front().first > clock || !times.open(clock)) continue;
        valids |= std::uint32_t(1) << i;
        constexpr int width = hls::field_width<Answer>::value;
        put_bits(rsp, i * width, hls::pack(l.answers.front().second), width);
        l.answers.pop_front();
        ++answered;
      }
      ready = static_cast<Bits>(readies);
      valid = static_cast<Bits>(valids);
    }
    template <class Bits, class Port, class LookUp>
    void take(std::uint64_t clock, Bits valid, Port const& req, LookUp look_up) {
      for (int i = 0; i < Lanes; ++i) {
        lane& l = lanes[static_cast<std::size_t>(i)];
        const bool asks = ((static_cast<std::uint32_t>(valid) >> i) & 1) != 0;
        l.waits = asks && !l.ready;
        if (!asks || !l.ready) continue;
        constexpr int width = hls::field_width<Request>::value;
        const auto request = hls::unpack<Request>(get_bits<(width + 7) / 8 * 8>(req, i * width, width));
        l.answers.push_back({times.due(clock, l.answers.empty() ? 0 : l.answers.back().first), look_up(request, i)});
      }
    }
  };

  map_lookup look_;
  port<table_requests, table_answers> table_;
  port<quad_requests, quad_answers> quad_;
  port<quad_request, texel_quad> place_;
  port<quad_request, normal_quad> normal_;
};

}  // namespace relievo::tb

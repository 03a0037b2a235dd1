// axi_memory: drives the Verilated model of an AXI4 read master of a map memory from both sides: requests on its port, and a memory on
// its bus that answers in order, after fixed or random clocks, with stalls and error responses.
//
//   axi_run<Model, Request>(settings, requests, words_of)      -> axi_result, all 0 after a failure
//     words_of    Request -> the words it asks for, in the order of the answer's places
//   The memory's bytes follow from their addresses; a burst's beats come one after the other, rlast with the last of them. Checked: every
//   word with read set, answers in order and one for each request, none else; error_o with exactly the answers that a bad beat went into;
//   address, length, size and kind of every burst, none across 4 KB; ar holds while it is not taken; never more beats outstanding than
//   promised; nothing left at the end. The bus has no IDs: one master's one ID, so all is in order.
#pragma once
#include <verilated.h>

#include <algorithm>
#include <deque>
#include <vector>

#include "tb/cosim/coverage.hpp"
#include "tb/cosim/map_words.hpp"
#include "tb/cosim/ports.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {

struct axi_settings {
  int word_bytes, word_bits, data_bytes;
  std::uint64_t outstanding;
  std::uint64_t base;
  std::uint64_t width;
  std::uint64_t idle, stall;               // sixteenths: no request, no address taken, no beat though one is due
  std::int64_t latency_low, latency_high;  // clocks from an address taken to its beat
  std::uint64_t errors;                    // one beat in so many, 0: none
  bool pairs = false;                      // words 2i and 2i + 1 are one burst where they lie beside each other, in one 4 KB
};

// Clocks from the first request taken to the last answer; bursts of one beat, and of two.
struct axi_result {
  std::uint64_t clocks = 0, singles = 0, pairs = 0;
};

namespace detail {

inline std::uint8_t byte_at(std::uint64_t address) { return static_cast<std::uint8_t>(((address + 1) * 0x9e3779b97f4a7c15u) >> 56); }

inline std::uint64_t word_at(std::uint64_t address, int bytes, int bits) {
  std::uint64_t word = 0;
  for (int i = bytes; i-- > 0;) word = word << 8 | byte_at(address + static_cast<std::uint64_t>(i));
  return bits == 64 ? word : word & ((std::uint64_t(1) << bits) - 1);
}

template <class Port>
std::uint64_t port_bits_at(Port const& port, int offset, int width) {
  std::uint64_t word = 0;
  for (int i = width; i-- > 0;) {
    const int bit = offset + i;
    if constexpr (std::is_integral_v<Port>)
      word = word << 1 | (static_cast<std::uint64_t>(port) >> bit & 1);
    else
      word = word << 1 | (port[static_cast<std::size_t>(bit / 32)] >> (bit % 32) & 1);
  }
  return word;
}

template <class Port>
void put_byte(Port& port, int at, std::uint8_t byte) {
  if constexpr (std::is_integral_v<Port>)
    port = static_cast<Port>((static_cast<std::uint64_t>(port) & ~(std::uint64_t(0xff) << (8 * at))) | std::uint64_t(byte) << (8 * at));
  else
    port[static_cast<std::size_t>(at / 4)] =
        (port[static_cast<std::size_t>(at / 4)] & ~(0xffu << (8 * (at % 4)))) | static_cast<std::uint32_t>(byte) << (8 * (at % 4));
}

}  // namespace detail

template <class Model, class Request, class WordsOf>
axi_result axi_run(axi_settings const& s, std::vector<Request> const& requests, WordsOf words_of) {
  struct beat {
    std::uint64_t address, due;
    bool last, bad;
  };
  struct burst {
    std::uint64_t address;
    int beats;
  };
  struct answer {
    std::vector<tb::table_request> words;
    std::size_t beats;  // of these, how many the bus has not taken
    bool bad;
  };
  VerilatedContext context;
  context.randReset(2);
  context.randSeed(static_cast<int>(seed() & 0x7fffffff) + 1);
  Model model(&context);
  tb::keep_coverage kept(context);
  generator g = next_generator();
  std::deque<beat> beats;
  std::deque<answer> answers;
  std::deque<burst> bursts;  // expected on the bus
  axi_result result;
  std::uint64_t clocks = 0, first = 0, last = 0, quiet = 0;
  std::size_t sent = 0, received = 0;
  const auto fail = [&](std::string const& what) {
    ADD_FAILURE() << what << "\nclock " << clocks << ", " << sent << " requests, " << received << " answers, seed " << seed();
    return axi_result{};
  };
  const auto address_of = [&](tb::table_request const& w) {
    return s.base + static_cast<std::uint64_t>(s.word_bytes) *
                        (static_cast<std::uint64_t>(raw(w.y)) * s.width + static_cast<std::uint64_t>(raw(w.x)));
  };
  const auto in_one_page = [&](std::uint64_t address, int count) {
    return address % 4096 + static_cast<std::uint64_t>(count * s.word_bytes) <= 4096;
  };
  const auto one_burst = [&](tb::table_request const& a, tb::table_request const& b) {
    return a.read && b.read && raw(a.y) == raw(b.y) && raw(b.x) == raw(a.x) + 1 && in_one_page(address_of(a), 2);
  };

  model.base_i = static_cast<std::remove_reference_t<decltype(model.base_i)>>(s.base);
  model.width_i = static_cast<std::remove_reference_t<decltype(model.width_i)>>(s.width);
  model.aclk = 0;
  model.aresetn = 0;
  model.req_valid_i = 0;
  model.m_axi_arready = 0;
  model.m_axi_rvalid = 0;
  for (int i = 0; i < 4; ++i) {
    model.aclk = 1;
    model.eval();
    model.aclk = 0;
    model.eval();
    kept.begin();
  }
  model.aresetn = 1;

  bool offered = false, beat_offered = false, ar_held = false;
  std::uint64_t held_address = 0;
  int held_length = 0;
  for (int after = 0; after < 300; after += received == requests.size() ? 1 : 0) {
    // The port's request, and anything when there is none.
    if (!offered && sent < requests.size() && g.below(16) >= s.idle) offered = true;
    Request request{};
    draw_vector(request, draw::uniform, g);
    if (offered) request = requests[sent];
    tb::put(model.req_i, request);
    model.req_valid_i = offered;
    model.m_axi_arready = g.below(16) >= s.stall;
    // The bus's beat, held until it is taken: garbage on the lanes beside the word, and everywhere when there is none.
    if (!beat_offered) {
      for (int i = 0; i < s.data_bytes; ++i) detail::put_byte(model.m_axi_rdata, i, static_cast<std::uint8_t>(g() & 0xff));
      model.m_axi_rresp = static_cast<std::uint8_t>(g.below(4));
      model.m_axi_rlast = g.chance(2);
      if (!beats.empty() && beats.front().due <= clocks && g.below(16) >= s.stall) {
        beat_offered = true;
        beat const& b = beats.front();
        const int lane = static_cast<int>(b.address % static_cast<std::uint64_t>(s.data_bytes));
        for (int i = 0; i < s.word_bytes; ++i)
          detail::put_byte(model.m_axi_rdata, lane + i, detail::byte_at(b.address + static_cast<std::uint64_t>(i)));
        model.m_axi_rresp = static_cast<std::uint8_t>(b.bad ? g.between(1, 3) : 0);
        model.m_axi_rlast = b.last;
      }
    }
    model.m_axi_rvalid = beat_offered;
    model.eval();

    // The answer of this clock.
    if (model.rsp_valid_o) {
      if (answers.empty()) return fail("an answer to nothing");
      answer const a = answers.front();
      answers.pop_front();
      if (a.beats != 0) return fail("an answer before its words came");
      if ((model.error_o != 0) != a.bad) return fail("error_o is " + std::to_string(model.error_o));
      for (std::size_t i = 0; i < a.words.size(); ++i) {
        if (!a.words[i].read) continue;
        const std::uint64_t word = detail::port_bits_at(model.rsp_o, static_cast<int>(i) * s.word_bits, s.word_bits);
        if (word != detail::word_at(address_of(a.words[i]), s.word_bytes, s.word_bits))
          return fail("word " + std::to_string(i) + " (" + std::to_string(raw(a.words[i].x)) + ", " + std::to_string(raw(a.words[i].y)) +
                      ") of an answer differs");
      }
      ++received;
      last = clocks;
    } else if (model.error_o) {
      return fail("error_o without an answer");
    }

    // What moves at the coming edge.
    const bool taken = offered && model.req_ready_o;
    const bool ar_moves = model.m_axi_arvalid && model.m_axi_arready;
    const bool r_moves = beat_offered && model.m_axi_rready;
    if (ar_held && (!model.m_axi_arvalid || model.m_axi_araddr != held_address || model.m_axi_arlen != held_length))
      return fail("ar changed while it was not taken");
    if (model.m_axi_arvalid) {
      if (!in_one_page(model.m_axi_araddr, model.m_axi_arlen + 1)) return fail("a burst crosses 4 KB");
      if (bursts.empty() || bursts.front().address != model.m_axi_araddr) return fail("a wrong address");
      if (model.m_axi_arlen + 1 != bursts.front().beats)
        return fail("a burst of " + std::to_string(model.m_axi_arlen + 1) + " words, where one of " + std::to_string(bursts.front().beats) +
                    " was to come");
      if ((1 << model.m_axi_arsize) != s.word_bytes || model.m_axi_arburst != 1 || model.m_axi_arprot != 0)
        return fail("not a burst of whole words of data");
    }
    ar_held = model.m_axi_arvalid && !ar_moves;
    held_address = model.m_axi_araddr;
    held_length = model.m_axi_arlen;
    if (r_moves) {
      // The beats go into the answers in order.
      const auto a = std::find_if(answers.begin(), answers.end(), [](answer const& x) { return x.beats != 0; });
      --a->beats;
      a->bad |= beats.front().bad;
      beats.pop_front();
      beat_offered = false;
    }
    if (ar_moves) {
      std::uint64_t due = clocks + static_cast<std::uint64_t>(g.between(s.latency_low, s.latency_high));
      burst const& b = bursts.front();
      (b.beats == 2 ? result.pairs : result.singles) += 1;
      for (int i = 0; i < b.beats; ++i) {
        if (!beats.empty()) due = std::max(due, beats.back().due + 1);
        beats.push_back(
            {b.address + static_cast<std::uint64_t>(i * s.word_bytes), due, i + 1 == b.beats, s.errors != 0 && g.chance(s.errors)});
      }
      bursts.pop_front();
      if (beats.size() > s.outstanding) return fail("more beats outstanding than promised");
    }
    if (taken) {
      if (sent == 0) first = clocks;
      const std::vector<tb::table_request> words = words_of(requests[sent]);
      answers.push_back({words, 0, false});
      for (std::size_t i = 0; i < words.size(); ++i) {
        if (!words[i].read) continue;
        const bool pair = s.pairs && i % 2 == 0 && one_burst(words[i], words[i + 1]);
        bursts.push_back({address_of(words[i]), pair ? 2 : 1});
        answers.back().beats += pair ? 2 : 1;
        i += pair ? 1 : 0;
      }
      ++sent;
      offered = false;
    }
    quiet = taken || ar_moves || r_moves || received == requests.size() ? 0 : quiet + 1;
    if (quiet > 10000) return fail("nothing moved for 10,000 clocks");
    model.aclk = 1;
    model.eval();
    model.aclk = 0;
    model.eval();
    ++clocks;
  }
  if (!beats.empty() || !answers.empty() || !bursts.empty()) return fail("something was left");
  result.clocks = last - first + 1;
  return result;
}

// The rates and latencies that every reader is tried with.
inline std::vector<axi_settings> axi_all(axi_settings const& common) {
  std::vector<axi_settings> list;
  for (const std::uint64_t idle : {0, 7})
    for (const std::uint64_t stall : {0, 7})
      for (const std::int64_t latency : {1, 40, 200})
        for (const std::uint64_t errors : {0, 9}) {
          axi_settings s = common;
          s.idle = idle;
          s.stall = stall;
          s.latency_low = latency == 200 ? 200 : 1;
          s.latency_high = latency;
          s.errors = errors;
          list.push_back(s);
        }
  return list;
}

}  // namespace relievo::test

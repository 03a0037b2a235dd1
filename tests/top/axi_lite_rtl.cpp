// axi_lite: every access reaches the block once, with its words, and is answered once, with the block's; whatever waits for how long,
// words stand until they are taken, reads and writes that wait together take turns, and an access takes exactly its clocks.
#include <gtest/gtest.h>

#include <cstdint>
#include <deque>
#include <string>

#include "Vaxi_lite.h"
#include "tests/support/clocked_model.hpp"
#include "tests/support/random.hpp"
#include "tests/support/settings.hpp"

namespace relievo::test {
namespace {

struct access {
  std::uint32_t address, word, strobe;
  bool write;
};

std::uint32_t bits(std::uint32_t strobe) {
  std::uint32_t b = 0;
  for (int i = 0; i < 4; ++i) b |= (strobe >> i & 1u) != 0 ? 0xffu << (8 * i) : 0u;
  return b;
}

// What the block answers to a request: no word that another request would get too.
std::uint32_t answer(std::uint32_t address) { return address * 0x9e3779b1u + 77u; }
bool refused(std::uint32_t address) { return (address >> 2) % 5 == 0; }

// A host that offers accesses and takes answers with given chances of 256 a clock, and a block that takes up to `slowest` clocks.
class bus {
 public:
  bus(std::string const& name, unsigned offer, unsigned take, unsigned slowest)
      : random_(name), offer_(offer), take_(take), slowest_(slowest) {
    m->s_axil_awvalid = m->s_axil_wvalid = m->s_axil_arvalid = m->s_axil_bready = m->s_axil_rready = 0;
    m->rd_ack_i = m->wr_ack_i = 0;
    m.reset();
  }

  void offer(access const& a) {
    if (a.write) {
      writes_.push_back(a);
      data_.push_back(a);
      to_write_.push_back(a);
    } else {
      reads_.push_back(a);
      to_read_.push_back(a);
    }
  }
  bool idle() const { return to_write_.empty() && to_read_.empty() && expected_writes_.empty() && expected_reads_.empty() && !waiting_; }

  void clock() {
    block();
    begin(m->s_axil_awvalid, writes_, [&](access const& a) { m->s_axil_awaddr = static_cast<SData>(a.address); });
    begin(m->s_axil_wvalid, data_, [&](access const& a) {
      m->s_axil_wdata = a.word;
      m->s_axil_wstrb = static_cast<CData>(a.strobe);
    });
    begin(m->s_axil_arvalid, reads_, [&](access const& a) { m->s_axil_araddr = static_cast<SData>(a.address); });
    m->s_axil_bready = chance(take_);
    m->s_axil_rready = chance(take_);
    m.settle();
    stands();
    const bool aw = m->s_axil_awvalid && m->s_axil_awready, w = m->s_axil_wvalid && m->s_axil_wready;
    const bool ar = m->s_axil_arvalid && m->s_axil_arready;
    if (m->s_axil_bvalid && m->s_axil_bready) answered(expected_writes_, m->s_axil_bresp, nullptr);
    if (m->s_axil_rvalid && m->s_axil_rready) {
      const std::uint32_t word = m->s_axil_rdata;
      answered(expected_reads_, m->s_axil_rresp, &word);
    }
    m.clock();
    if (aw) m->s_axil_awvalid = 0;
    if (w) m->s_axil_wvalid = 0;
    if (ar) m->s_axil_arvalid = 0;
    ++clocks;
  }

  clocked_model<Vaxi_lite> m;
  std::uint64_t clocks = 0;
  std::string order;  // of the requests: r, w

 private:
  bool chance(unsigned of_256) { return random_.below(256) < of_256; }

  template <class Set>
  void begin(CData& valid, std::deque<access>& waiting, Set set) {
    if (valid || waiting.empty() || !chance(offer_)) return;
    set(waiting.front());
    waiting.pop_front();
    valid = 1;
  }

  // The block: sees requests and answers them.
  void block() {
    m->rd_ack_i = m->wr_ack_i = 0;
    m.settle();
    if (m->req_o) {
      ASSERT_FALSE(waiting_) << "a request before the answer to the last, clock " << clocks;
      const bool write = m->req_is_wr_o;
      auto& queue = write ? to_write_ : to_read_;
      ASSERT_FALSE(queue.empty()) << "a request that nobody made, clock " << clocks;
      at_ = queue.front();
      queue.pop_front();
      ASSERT_EQ(m->addr_o, at_.address & ~3u);
      if (write) {
        ASSERT_EQ(m->wr_data_o, at_.word);
        ASSERT_EQ(m->wr_biten_o, bits(at_.strobe));
      }
      order += write ? 'w' : 'r';
      waiting_ = true;
      // A write is answered in its clock, too.
      left_ = static_cast<unsigned>(random_.below(slowest_ + 1)) + (write ? 0 : 1);
    }
    if (!waiting_ || left_-- > 0) return;
    waiting_ = false;
    const bool error = refused(at_.address);
    if (at_.write) {
      m->wr_ack_i = 1;
      m->wr_err_i = error;
      expected_writes_.push_back(at_);
    } else {
      m->rd_ack_i = 1;
      m->rd_err_i = error;
      m->rd_data_i = answer(at_.address & ~3u);
      expected_reads_.push_back(at_);
    }
  }

  // What was offered and not taken stands.
  void stands() {
    if (held_b_) {
      ASSERT_TRUE(m->s_axil_bvalid) << "bvalid dropped, clock " << clocks;
      ASSERT_EQ(m->s_axil_bresp, b_);
    }
    if (held_r_) {
      ASSERT_TRUE(m->s_axil_rvalid) << "rvalid dropped, clock " << clocks;
      ASSERT_EQ(m->s_axil_rdata, r_);
      ASSERT_EQ(m->s_axil_rresp, r_resp_);
    }
    held_b_ = m->s_axil_bvalid && !m->s_axil_bready;
    held_r_ = m->s_axil_rvalid && !m->s_axil_rready;
    b_ = m->s_axil_bresp;
    r_ = m->s_axil_rdata;
    r_resp_ = m->s_axil_rresp;
  }

  void answered(std::deque<access>& expected, std::uint32_t response, std::uint32_t const* word) {
    ASSERT_FALSE(expected.empty()) << "an answer to nothing, clock " << clocks;
    const access a = expected.front();
    expected.pop_front();
    ASSERT_EQ(response, refused(a.address) ? 2u : 0u) << "clock " << clocks;
    if (word != nullptr) {
      ASSERT_EQ(*word, answer(a.address & ~3u)) << "clock " << clocks;
    }
  }

  generator random_;
  unsigned offer_, take_, slowest_, left_ = 0;
  std::deque<access> writes_, data_, reads_, to_write_, to_read_, expected_writes_, expected_reads_;
  access at_{};
  bool waiting_ = false, held_b_ = false, held_r_ = false;
  std::uint32_t b_ = 0, r_ = 0, r_resp_ = 0;
};

access some_access(generator& g) {
  return {static_cast<std::uint32_t>(g.below(4096)), static_cast<std::uint32_t>(g()), static_cast<std::uint32_t>(g.below(16)), g.chance(2)};
}

TEST(axi_lite, every_access_reaches_the_block_and_its_answer_the_host) {
  const std::size_t count = vector_count() / 100;
  int run = 0;
  for (const unsigned offer : {256u, 20u})
    for (const unsigned take : {256u, 60u})
      for (const unsigned slowest : {0u, 9u}) {
        generator g("axi_lite " + std::to_string(run));
        bus b("axi_lite bus " + std::to_string(run++), offer, take, slowest);
        for (std::size_t i = 0; i < count; ++i) b.offer(some_access(g));
        while (!b.idle() && b.clocks < 1000 * count && !HasFailure()) b.clock();
        ASSERT_TRUE(b.idle()) << "an access was never answered";
        ASSERT_EQ(b.order.size(), count);
        if (HasFailure()) return;
      }
}

TEST(axi_lite, a_write_takes_4_clocks_and_a_read_5_of_a_block_that_answers_so_early) {
  for (const bool write : {true, false}) {
    bus b("axi_lite clocks", 256, 256, 0);
    for (std::uint32_t i = 1; i < 20; ++i) {
      b.offer({4 * i, i, 15, write});
      const std::uint64_t before = b.clocks;
      while (!b.idle() && b.clocks < before + 100) b.clock();
      ASSERT_EQ(b.clocks - before, write ? 4u : 5u) << i;
    }
  }
}

TEST(axi_lite, reads_and_writes_take_turns) {
  bus b("axi_lite turns", 256, 256, 0);
  for (std::uint32_t i = 1; i < 50; ++i) {
    b.offer({4 * i, i, 15, true});
    b.offer({4 * i, i, 15, false});
  }
  while (!b.idle() && b.clocks < 10000) b.clock();
  for (std::size_t i = 1; i < b.order.size(); ++i) ASSERT_NE(b.order[i], b.order[i - 1]) << i;
}

}  // namespace
}  // namespace relievo::test

// queue_bench: drives a Verilated triangle_queue of numbers, clock by clock, and is the engine around it.
//   queue_bench<Model, Depth> bench(settings)     traffic and meshes are drawn from the seed
//   run()     a mesh to its end; false when something was wrong;  clock()  one clock of it;  reset()
//   Checked in every clock: nothing is lost, doubled or refused, no triangle comes before it was pushed, counts, the largest count and
//   fallbacks are right, no more are in flight than the credit rule allows, and nothing hangs.
#pragma once
#include <gtest/gtest.h>
#include <verilated.h>

#include <memory>
#include <set>

#include "hls/edge/triangle_queue.hpp"
#include "tb/cosim/coverage.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {

struct queue_settings {
  int depth, max_generation;
  bool fifo;
  int capacity;                   // triangles that the engine holds at once, without those read ahead
  int latency_low, latency_high;  // clocks from a triangle's pop to its first child, or to its end
  std::uint64_t idle;             // sixteenths: how often the engine does not pop, not push, not retire, does not take a base triangle
  int splits;                     // sixteenths of the triangles that may split and do
  int triangles;                  // that many born, none splits any more and no base triangle comes
};

// Drives one queue, clock by clock, and is the engine around it. Triangles are numbers; what is below them is drawn when they are met.
template <class Model, int Depth>
class queue_bench {
 public:
  explicit queue_bench(queue_settings const& s) : s_(s), g_(next_generator()) {
    context_.randReset(2);
    context_.randSeed(reset_seed());
    model_ = std::make_unique<Model>(&context_);
    model_->regs_i = s.fifo ? 1 : 0;
    model_->max_generation_i = static_cast<unsigned char>(s.max_generation);
    reset();
  }

  void reset() {
    model_->rst_ni = 0;
    model_->push_valid_i = model_->pop_ready_i = model_->retire_i = model_->take_i = 0;
    for (int i = 0; i < 3; ++i) {
      edge();
      kept_.begin();
    }
    model_->rst_ni = 1;
    held_.clear();
    flights_.clear();
    sequential_->start();
    fallbacks_ = 0;
    pushed_ = popped_ = taken_ = retired_ = 0;
    highest_ = 0;
    shown_ = -1;
  }

  // A chain: every triangle returns one child, for ever.
  void chain() { chain_ = true; }

  // One clock. False when something was wrong.
  bool clock() {
    Model& m = *model_;
    const int count = m.count_o, in_flight = m.in_flight_o;
    std::uint64_t const now = clocks_;

    // The engine: what it does in this clock depends on registers alone.
    m.pop_ready_i = engine_holds() < s_.capacity && works();
    m.push_valid_i = m.retire_i = m.take_i = 0;
    std::size_t pusher = flights_.size(), done = flights_.size();
    if (works()) pusher = pick([&](flight const& f) { return f.due <= now && f.children > 0; });
    if (pusher < flights_.size()) {
      flight& f = flights_[pusher];
      const std::int64_t child = static_cast<std::int64_t>(level_.size());
      level_.push_back(f.level + 1);
      m.push_valid_i = 1;
      m.push_i = static_cast<std::uint32_t>(child);
      --f.children;
    }
    if (works()) done = pick([&](flight const& f) { return f.due <= now && f.children == 0; });
    if (done < flights_.size()) {
      m.retire_i = 1;
      flights_.erase(flights_.begin() + static_cast<std::ptrdiff_t>(done));
    }
    m.eval();
    const bool take = m.may_take_o && !m.pop_valid_o && engine_holds() < s_.capacity && !wants_no_more() && works();
    m.take_i = take;
    m.eval();

    if (count > Depth) return fails("more than it holds");
    if (m.idle_o && (count != 0 || in_flight != 0)) return fails("idle with something inside");
    if (shown_ >= 0 && (!m.pop_valid_o || m.pop_o != shown_)) return fails("a popped triangle changed while it was not taken");
    const bool popped = m.pop_valid_o && m.pop_ready_i;
    shown_ = m.pop_valid_o && !popped ? static_cast<std::int64_t>(m.pop_o) : -1;
    if (popped && !leaves(m.pop_o)) return false;
    if (take) {
      fly(static_cast<std::int64_t>(level_.size()), 0);
      level_.push_back(0);
      ++taken_;
    }
    if (m.push_valid_i) {
      held_.insert(m.push_i);
      if (one_at_a_time_) {
        hls::triangle t{};
        t.index = hls::from_raw<formats::index>(m.push_i);
        sequential_->push(t);
      }
      ++pushed_;
    }
    retired_ += m.retire_i;
    const bool pushes = m.push_valid_i;
    moved_ = popped || take || pushes || m.retire_i;
    popped_now_ = popped;
    pushed_now_ = pushes;
    edge();

    if (m.error_o) return fails("a push was refused");
    // What the queue did in that clock, against its own rule with the numbers of its beginning.
    const int begun = count + (pushes ? 1 : 0) - static_cast<int>(m.count_o), free = Depth - count, limit = 3 * s_.max_generation;
    if (begun < 0 || begun > 1) return fails("the count is wrong");
    const int with_base = in_flight + (take ? 1 : 0);
    if (begun == 1 && with_base != 0 && free + 1 - 4 * (with_base + 1) < limit) return fails("a pop without credit");
    if (take && free - 4 * (in_flight + 1) < limit) return fails("a base triangle without credit");
    if (begun == 1 && count == 0) return fails("a pop from nothing");
    if (m.count_o + m.in_flight_o != pushed_ + taken_ - retired_) return fails("count and in_flight do not add up");
    const std::int64_t ahead = static_cast<std::int64_t>(m.in_flight_o) - static_cast<std::int64_t>(flights_.size());
    if (ahead < 0 || ahead > 3) return fails("not 0 to 3 read ahead");
    highest_ = std::max(highest_, static_cast<int>(m.count_o));
    return true;
  }

  // Until nothing is left; the mesh ends when enough triangles have been born.
  bool run() {
    for (std::uint64_t quiet = 0; !(wants_no_more() && model_->idle_o && flights_.empty());) {
      if (!clock()) return false;
      quiet = moved_ ? 0 : quiet + 1;
      if (quiet > 1000 + static_cast<std::uint64_t>(s_.latency_high)) return fails("nothing moves");
    }
    for (int i = 0; i < 10; ++i)
      if (!clock()) return false;
    if (!held_.empty() || popped_ != pushed_ || retired_ != popped_ + taken_) return fails("not every triangle came out once");
    if (model_->high_water_o != highest_) return fails("high water");
    return true;
  }

  // From here on the kernel's queue is driven beside; true only where never more than one triangle is in flight.
  void compare_with_kernel() { one_at_a_time_ = true; }

  Model& model() { return *model_; }
  bool popped_now() const { return popped_now_; }
  bool pushed_now() const { return pushed_now_; }
  int highest() const { return highest_; }
  std::uint64_t fallbacks() const { return model_->fallbacks_o; }
  std::uint64_t clocks() const { return clocks_; }
  std::size_t most_in_flight() const { return most_; }

 private:
  struct flight {
    std::int64_t number;
    int level, children;
    std::uint64_t due;
  };

  bool works() { return g_.below(16) >= s_.idle; }
  bool wants_no_more() const { return !chain_ && static_cast<int>(level_.size()) >= s_.triangles; }
  int engine_holds() const { return static_cast<int>(flights_.size()); }
  void fly(std::int64_t number, int level) {
    int children = 0;
    if (chain_) {
      children = level == 0 ? 4 : 1;
    } else if (level < s_.max_generation && !wants_no_more() && static_cast<int>(g_.below(16)) < s_.splits) {
      children = static_cast<int>(level_.size()) < s_.triangles / 2 ? 4 : static_cast<int>(g_.between(2, 4));
    }
    flights_.push_back({number, level, children, clocks_ + static_cast<std::uint64_t>(g_.between(s_.latency_low, s_.latency_high))});
    most_ = std::max(most_, flights_.size());
  }
  // Any of those that can, the first one every other time.
  template <class Can>
  std::size_t pick(Can can) {
    const std::size_t from = flights_.empty() || chain_ || g_.chance(2) ? 0 : g_.below(flights_.size());
    for (std::size_t i = from; i < flights_.size(); ++i)
      if (can(flights_[i])) return i;
    for (std::size_t i = 0; i < from; ++i)
      if (can(flights_[i])) return i;
    return flights_.size();
  }
  bool leaves(std::int64_t number) {
    if (held_.erase(number) == 0) return fails("a triangle came out that is not inside");
    ++popped_;
    if (one_at_a_time_) {
      bool fallback = false;
      const hls::triangle t = sequential_->pop({s_.fifo}, hls::from_raw<formats::generation>(s_.max_generation), fallback);
      fallbacks_ += fallback ? 1 : 0;
      if (raw(t.index) != number) return fails("not the triangle that the kernel pops");
      if (model_->fallbacks_o != fallbacks_) return fails("not the fallbacks of the kernel");
    }
    fly(number, level_[static_cast<std::size_t>(number)]);
    return true;
  }
  bool fails(char const* what) {
    ADD_FAILURE() << what << ", clock " << clocks_ << ", count " << static_cast<int>(model_->count_o) << ", in flight "
                  << static_cast<int>(model_->in_flight_o) << "; depth " << Depth << ", max_generation " << s_.max_generation << ", fifo "
                  << s_.fifo << ", capacity " << s_.capacity << ", seed " << seed();
    return false;
  }
  void edge() {
    model_->clk_i = 1;
    model_->eval();
    model_->clk_i = 0;
    model_->eval();
    ++clocks_;
  }

  queue_settings s_;
  generator g_;
  VerilatedContext context_;
  std::unique_ptr<Model> model_;
  tb::keep_coverage kept_{context_};
  std::unique_ptr<hls::triangle_queue<Depth>> sequential_ = std::make_unique<hls::triangle_queue<Depth>>();
  std::vector<int> level_;       // of every triangle ever born
  std::set<std::int64_t> held_;  // pushed and not yet out
  std::vector<flight> flights_;  // in the engine
  std::uint64_t clocks_ = 0, fallbacks_ = 0, pushed_ = 0, popped_ = 0, taken_ = 0, retired_ = 0;
  std::size_t most_ = 0;
  std::int64_t shown_ = -1;
  int highest_ = 0;
  bool chain_ = false, moved_ = false, popped_now_ = false, pushed_now_ = false, one_at_a_time_ = false;
};

}  // namespace relievo::test

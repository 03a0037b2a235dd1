// verilate: Vaxi_read_maps Reads=3 Samples=2
//
// axi_read_maps: the words of every port in order while all four are at work, each from its own bus and map; an error with the answer that
// it belongs to; samples that nobody wants are not fetched; a beat a clock on each bus.
#include "Vaxi_read_maps.h"
#include "tb/cosim/coverage.hpp"
#include "tb/cosim/ports.hpp"
#include "tests/support/map_buses.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

constexpr int reads = 3, samples = 2;
constexpr std::uint64_t width = 37, height = 29;
constexpr std::uint64_t latency = 10;  // clocks besides the memory's and one a beat

// Some bits of an answer.
struct part {
  int offset, width;
  std::uint64_t value;
};
using parts = std::vector<part>;

template <class Request>
struct port {
  std::deque<Request> requests;
  std::deque<parts> expected;  // of those that were taken
  bool offered = false;
  std::uint64_t first = 0, last = 0, answers = 0, errors = 0;

  std::uint64_t clocks() const { return last - first + 1; }
};

class maps_bench {
 public:
  explicit maps_bench(tb::bus_traffic const& t)
      : buses(t, [](std::string const& what) { ADD_FAILURE() << what; }), pace_(t.idle, t.seed + 7) {
    context_.randReset(2);
    context_.randSeed(static_cast<int>(seed() & 0x7fffffff) + 1);
    model_ = std::make_unique<Vaxi_read_maps>(&context_);
    for (std::uint64_t i = 0; i < width * height; ++i) {
      texels_.push_back(static_cast<std::uint16_t>(g_() & 0xffff));
      sums_.push_back(g_() >> 24);
      normals_.push_back(g_() >> 16);
    }
    buses.load({int(width), int(height), texels_.data(), sums_.data(), normals_.data()});
    model_->width_i = width;
    model_->aclk = 0;
    model_->aresetn = 0;
    for (int i = 0; i < 4; ++i) {
      step();
      kept_.begin();
    }
    model_->aresetn = 1;
  }

  port<tb::group<tb::table_request, reads>> table;
  port<tb::wanted_quads<samples>> quad;
  port<tb::quad_request> place, normal;
  map_buses<Vaxi_read_maps> buses;

  // Until all is answered.
  void run() {
    for (int i = 0; i < 20000 && !over(); ++i) step();
    ASSERT_TRUE(over()) << "something is not answered, seed " << seed();
    for (int i = 0; i < 100; ++i) step();
  }

 private:
  template <class... Ports>
  static bool all_over(Ports const&... p) {
    return ((p.requests.empty() && p.expected.empty()) && ...);
  }
  bool over() const { return all_over(table, quad, place, normal); }

  // The port's request, and anything when there is none.
  template <class Request>
  Request ask(port<Request>& p, CData& valid) {
    p.offered = p.offered || (!p.requests.empty() && pace_.go());
    valid = p.offered;
    Request request{};
    draw_vector(request, draw::uniform, g_);
    return p.offered ? p.requests.front() : request;
  }
  template <class Request, class Answer, class PartsOf>
  void look(port<Request>& p, bool ready, bool answered, Answer const& answer, PartsOf parts_of) {
    if (answered) {
      ASSERT_FALSE(p.expected.empty()) << "an answer to nothing, clock " << clock_;
      for (part const& w : p.expected.front())
        ASSERT_EQ(tb::get_bits<64>(answer, w.offset, w.width).limb[0], w.value) << "bit " << w.offset << " of answer " << p.answers;
      p.expected.pop_front();
      ++p.answers;
      p.errors += model_->error_o;
      p.last = clock_;
    }
    if (!p.offered || !ready) return;
    if (p.answers == 0 && p.expected.empty()) p.first = clock_;
    p.expected.push_back(parts_of(p.requests.front()));
    p.requests.pop_front();
    p.offered = false;
  }
  static std::size_t at(hls::fixed<formats::map_size> x, hls::fixed<formats::map_size> y) {
    return static_cast<std::size_t>(raw(y)) * width + static_cast<std::size_t>(raw(x));
  }
  template <class Words>
  static void add_quad(parts& list, tb::quad_request const& q, Words const& words, int offset, int bits) {
    for (int i = 0; i < 4; ++i) list.push_back({offset + i * bits, bits, words[at(q.x[i % 2], q.y[i / 2])]});
  }

  void step() {
    Vaxi_read_maps& m = *model_;
    buses.quiet(m);
    tb::put(m.table_req_i, ask(table, m.table_req_valid_i));
    const auto quads = ask(quad, m.quad_req_valid_i);
    tb::put(m.quad_req_i, quads.quads);
    m.quad_req_mask_i = static_cast<CData>(quads.wanted[0] | quads.wanted[1] << 1);
    tb::put(m.place_req_i, ask(place, m.place_req_valid_i));
    tb::put(m.normal_req_i, ask(normal, m.normal_req_valid_i));
    if (m.aresetn) buses.offer(m, clock_);
    m.eval();
    if (m.aresetn) {
      ASSERT_TRUE(!m.error_o || m.table_rsp_valid_o || m.quad_rsp_valid_o || m.place_rsp_valid_o || m.normal_rsp_valid_o)
          << "error_o without an answer, clock " << clock_;
      look(table, m.table_req_ready_o, m.table_rsp_valid_o, m.table_rsp_o, [this](auto const& r) {
        parts list;
        for (int i = 0; i < reads; ++i)
          if (r.at[i].read) list.push_back({i * 40, 40, sums_[at(r.at[i].x, r.at[i].y)]});
        return list;
      });
      look(quad, m.quad_req_ready_o, m.quad_rsp_valid_o, m.quad_rsp_o, [this](auto const& r) {
        parts list;
        for (int i = 0; i < samples; ++i)
          if (r.wanted[i]) add_quad(list, r.quads.at[i], texels_, i * 64, 16);
        return list;
      });
      const auto quad_of = [](auto const& words, int bits) {
        return [&words, bits](tb::quad_request const& q) {
          parts list;
          add_quad(list, q, words, 0, bits);
          return list;
        };
      };
      look(place, m.place_req_ready_o, m.place_rsp_valid_o, m.place_rsp_o, quad_of(texels_, 16));
      look(normal, m.normal_req_ready_o, m.normal_rsp_valid_o, m.normal_rsp_o, quad_of(normals_, 48));
      buses.take(m, clock_);
    }
    m.aclk = 1;
    m.eval();
    m.aclk = 0;
    m.eval();
    ++clock_;
  }

  generator g_{"axi_read_maps"};
  std::vector<std::uint16_t> texels_;
  std::vector<std::uint64_t> sums_, normals_;
  tb::pacer pace_;
  VerilatedContext context_;
  std::unique_ptr<Vaxi_read_maps> model_;
  tb::keep_coverage kept_{context_};
  std::uint64_t clock_ = 0;
};

hls::fixed<formats::map_size> place_in(generator& g, std::uint64_t size) {
  return hls::from_raw<formats::map_size>(static_cast<std::int64_t>(g.below(size)));
}
// Neighbours mostly; otherwise as a seam or a clamped border has them.
tb::quad_request some_quad(generator& g, bool neighbours) {
  tb::quad_request q{};
  q.x[0] = place_in(g, width - 1);
  q.y[0] = place_in(g, height - 1);
  q.x[1] = hls::from_raw<formats::map_size>(raw(q.x[0]) + 1);
  q.y[1] = hls::from_raw<formats::map_size>(raw(q.y[0]) + 1);
  if (!neighbours && g.chance(4)) q.x[1] = g.chance(2) ? q.x[0] : place_in(g, width);
  if (!neighbours && g.chance(4)) q.y[1] = g.chance(2) ? q.y[0] : place_in(g, height);
  return q;
}
// whole: all words read, all samples wanted, all quads of neighbours.
void fill_ports(maps_bench& bench, generator& g, int count, bool whole) {
  for (int i = 0; i < count; ++i) {
    tb::group<tb::table_request, reads> t{};
    for (tb::table_request& r : t.at) r = {whole || !g.chance(3), place_in(g, width), place_in(g, height)};
    bench.table.requests.push_back(t);
    tb::wanted_quads<samples> q{};
    for (int k = 0; k < samples; ++k) {
      q.wanted[k] = whole || !g.chance(3);
      q.quads.at[k] = some_quad(g, whole);
      // Nobody wants it, so it may lie anywhere.
      if (!q.wanted[k]) q.quads.at[k].x[0] = q.quads.at[k].y[1] = hls::from_raw<formats::map_size>(16383);
    }
    bench.quad.requests.push_back(q);
    bench.place.requests.push_back(some_quad(g, whole));
    bench.normal.requests.push_back(some_quad(g, whole));
  }
}

TEST(axi_read_maps, answers_all_ports_whatever_their_buses_do) {
  generator g("ports");
  const tb::bus_traffic patterns[] = {
      {0, 0, 1, 1, false, 1, 1}, {0, 40, 1, 40, false, 2, 1}, {40, 0, 1, 40, true, 3, 1}, {30, 30, 60, 60, false, 4, 1}};
  for (tb::bus_traffic const& t : patterns) {
    maps_bench bench(t);
    fill_ports(bench, g, 300, false);
    bench.run();
    if (HasFailure()) FAIL() << "seed " << seed();
    EXPECT_EQ(bench.table.errors + bench.quad.errors + bench.place.errors + bench.normal.errors, 0u);
  }
}

TEST(axi_read_maps, a_beat_a_clock_on_each_bus_from_a_memory_of_60_clocks) {
  generator g("rates");
  for (const int count : {1, 200}) {
    maps_bench bench({0, 0, 60, 60, false, 1, 1});
    fill_ports(bench, g, count, true);
    bench.run();
    const auto n = static_cast<std::uint64_t>(count);
    EXPECT_EQ(bench.table.clocks(), reads * n + 60 + latency);
    EXPECT_EQ(bench.quad.clocks(), samples * 4 * n + 60 + latency);
    EXPECT_EQ(bench.place.clocks(), 4 * n + 60 + latency);
    EXPECT_EQ(bench.normal.clocks(), 4 * n + 60 + latency);
  }
}

// Two addresses a quad; the texels of this map lie in one page.
TEST(axi_read_maps, a_row_of_texels_is_a_burst) {
  generator g("bursts");
  maps_bench bench({0, 0, 1, 1, false, 1, 1});
  fill_ports(bench, g, 50, true);
  bench.table.requests.clear();
  bench.normal.requests.clear();
  bench.run();
  EXPECT_EQ(bench.buses.bursts_of_two(), 50u * (samples + 1) * 2);
}

// One bad beat on a bus is one error, with that port's answer.
TEST(axi_read_maps, tells_of_a_bad_beat_on_any_bus) {
  generator g("errors");
  for (int bus = 0; bus < 4; ++bus) {
    maps_bench bench({0, 20, 1, 20, false, 5, 1});
    fill_ports(bench, g, 5, true);
    if (bus != 0) bench.table.requests.clear();
    if (bus != 1) bench.quad.requests.clear();
    if (bus != 2) bench.place.requests.clear();
    if (bus != 3) bench.normal.requests.clear();
    bench.buses.bad_beats = 1;
    bench.run();
    EXPECT_EQ(bench.table.errors, bus == 0 ? 1u : 0u);
    EXPECT_EQ(bench.quad.errors, bus == 1 ? 1u : 0u);
    EXPECT_EQ(bench.place.errors, bus == 2 ? 1u : 0u);
    EXPECT_EQ(bench.normal.errors, bus == 3 ? 1u : 0u);
  }
}

}  // namespace
}  // namespace relievo::test

// verilate: Vaxi_read_quads
// verilate: Vaxi_read_quads_normal WordBytes=8 WordBits=48
// verilate: Vaxi_read_quads_narrow DataBytes=2 Outstanding=8
//
// axi_read_quads: the four texels or normals of a quad in their places, whatever the bus does; a row of neighbours is one burst, none
// crosses 4 KB; four beats a quad, a beat a clock.
#include "Vaxi_read_quads.h"
#include "Vaxi_read_quads_narrow.h"
#include "Vaxi_read_quads_normal.h"
#include "tests/support/axi_memory.hpp"

namespace relievo::test {
namespace {

constexpr std::uint64_t latency = 10;  // clocks besides the memory's and one a beat: 9 to the address, 1 from the beat
constexpr std::uint64_t width = 403, height = 344;

// Neighbours as a sampler asks for them: clamped, around the seam, or anywhere.
std::vector<tb::quad_request> some_quads(std::size_t count) {
  generator g = next_generator();
  std::vector<tb::quad_request> list(count);
  const auto neighbours = [&](hls::fixed<formats::map_size>(&at)[2], std::uint64_t size) {
    const std::uint64_t first = g.chance(4) ? size - 1 : g.below(size);
    const std::uint64_t second = g.chance(4) ? g.below(size) : g.chance(2) ? (first + 1) % size : std::min(first + 1, size - 1);
    at[0] = hls::from_raw<formats::map_size>(static_cast<std::int64_t>(first));
    at[1] = hls::from_raw<formats::map_size>(static_cast<std::int64_t>(second));
  };
  for (tb::quad_request& q : list) {
    neighbours(q.x, width);
    neighbours(q.y, height);
  }
  return list;
}

// Row by row.
constexpr auto words_of = [](tb::quad_request const& q) {
  return std::vector<tb::table_request>{{true, q.x[0], q.y[0]}, {true, q.x[1], q.y[0]}, {true, q.x[0], q.y[1]}, {true, q.x[1], q.y[1]}};
};

constexpr axi_settings texels{2, 16, 8, 128, 0x20000002, width, 0, 0, 1, 1, 0, true};
constexpr axi_settings normals{8, 48, 8, 128, 0x30000000, width, 0, 0, 1, 1, 0, true};
constexpr axi_settings narrow{2, 16, 2, 8, 0x00000006, width, 0, 0, 1, 1, 0, true};

std::size_t quad_count() { return vector_count() / 1000; }

template <class Model>
void expect_quads(axi_settings const& common) {
  for (axi_settings const& s : axi_all(common)) {
    axi_run<Model>(s, some_quads(quad_count()), words_of);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(axi_read_quads, texels) { expect_quads<Vaxi_read_quads>(texels); }
TEST(axi_read_quads, normals) { expect_quads<Vaxi_read_quads_normal>(normals); }
TEST(axi_read_quads, texels_on_a_bus_as_narrow_as_they_are) { expect_quads<Vaxi_read_quads_narrow>(narrow); }

TEST(axi_read_quads, four_clocks_a_quad_from_a_memory_of_60_clocks) {
  for (const std::size_t count : {1, 1000}) {
    axi_settings s = texels;
    s.latency_low = s.latency_high = 60;
    EXPECT_EQ(axi_run<Vaxi_read_quads>(s, some_quads(count), words_of).clocks, 4 * count + 60 + latency);
    s = normals;
    s.latency_low = s.latency_high = 60;
    EXPECT_EQ(axi_run<Vaxi_read_quads_normal>(s, some_quads(count), words_of).clocks, 4 * count + 60 + latency);
  }
}

tb::quad_request quad_at(std::uint64_t x0, std::uint64_t x1, std::uint64_t y0, std::uint64_t y1) {
  const auto size = [](std::uint64_t n) { return hls::from_raw<formats::map_size>(static_cast<std::int64_t>(n)); };
  return {{size(x0), size(x1)}, {size(y0), size(y1)}};
}

// A map whose rows are as long as a page, and begin two texels before one: of neighbours those at columns 1 and 2 lie in two pages.
TEST(axi_read_quads, a_row_is_one_burst_but_across_4_kb) {
  axi_settings s = texels;
  s.width = 2048;
  s.base = 0x20000ffc;
  std::vector<tb::quad_request> quads;
  for (const std::uint64_t y : {0, 1, 2, 342})
    for (const std::uint64_t x : {0, 1, 2, 3, 1023, 2046}) quads.push_back(quad_at(x, x + 1, y, y + 1));
  for (axi_settings t : axi_all(s)) {
    t.errors = 0;
    const axi_result r = axi_run<Vaxi_read_quads>(t, quads, words_of);
    EXPECT_EQ(r.pairs, 4u * 5 * 2);
    EXPECT_EQ(r.singles, 4u * 1 * 4);
    if (HasFailure()) return;
  }
}

// Around the seam and at a clamped border the columns are no neighbours; at a clamped row the rows are the same, each a burst.
TEST(axi_read_quads, columns_that_wrap_or_are_clamped_are_beats_alone) {
  const auto bursts = [](tb::quad_request const& q) {
    return axi_run<Vaxi_read_quads>(texels, std::vector<tb::quad_request>{q}, words_of);
  };
  EXPECT_EQ(bursts(quad_at(width - 1, 0, 5, 6)).singles, 4u);
  EXPECT_EQ(bursts(quad_at(width - 1, width - 1, 5, 6)).singles, 4u);
  EXPECT_EQ(bursts(quad_at(7, 8, height - 1, height - 1)).pairs, 2u);
  EXPECT_EQ(bursts(quad_at(7, 8, height - 1, 0)).pairs, 2u);
  EXPECT_EQ(bursts(quad_at(8, 7, 5, 6)).singles, 4u);
}

}  // namespace
}  // namespace relievo::test

// verilate: Vaxi_read_quads
// verilate: Vaxi_read_quads_normal WordBytes=8 WordBits=48
// verilate: Vaxi_read_quads_narrow DataBytes=2
//
// axi_read_quads: the four texels or normals of a quad in their places, whatever the bus does; four beats a quad, a beat a clock.
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

constexpr axi_settings texels{2, 16, 8, 128, 0x20000002, width, 0, 0, 1, 1, 0};
constexpr axi_settings normals{8, 48, 8, 128, 0x30000000, width, 0, 0, 1, 1, 0};
constexpr axi_settings narrow{2, 16, 2, 128, 0x00000006, width, 0, 0, 1, 1, 0};

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
  constexpr std::size_t count = 1000;
  axi_settings s = texels;
  s.latency_low = s.latency_high = 60;
  EXPECT_EQ(axi_run<Vaxi_read_quads>(s, some_quads(count), words_of), 4 * count + 60 + latency);
}

}  // namespace
}  // namespace relievo::test

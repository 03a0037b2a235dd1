// verilate: Vaxi_read WordBits=40
// verilate: Vaxi_read_4 Words=4 WordBits=40 AddressBits=40 DataBytes=16 Outstanding=16
// verilate: Vaxi_read_3 Words=3 WordBytes=2 WordBits=16 DataBytes=4
//
// axi_read: every word that was asked for, in order, whatever the bus does; errors with the answer that they belong to; never more beats
// outstanding than promised; and a beat a clock from a memory of 60 clocks.
#include "Vaxi_read.h"
#include "Vaxi_read_3.h"
#include "Vaxi_read_4.h"
#include "tests/support/axi_memory.hpp"

namespace relievo::test {
namespace {

constexpr std::uint64_t latency = 10;  // clocks besides the memory's and one a beat: 9 to the address, 1 from the beat

// Random words within the largest map of that width; one request in four reads nothing, a few, or all.
template <int N>
std::vector<tb::group<tb::table_request, N>> some_requests(std::size_t count, std::uint64_t width, bool all) {
  generator g = next_generator();
  std::vector<tb::group<tb::table_request, N>> list(count);
  for (auto& request : list) {
    const std::uint64_t mask = all ? ~std::uint64_t(0) : g.chance(3) ? g() : g.chance(2) ? g() & g() : ~std::uint64_t(0);
    for (int i = 0; i < N; ++i)
      request.at[i] = {(mask >> i & 1) != 0, hls::from_raw<formats::map_size>(static_cast<std::int64_t>(g.below(width))),
                       hls::from_raw<formats::map_size>(static_cast<std::int64_t>(g.chance(8) ? 8191 : g.below(8192)))};
  }
  return list;
}

constexpr auto words_of = [](auto const& request) { return std::vector<tb::table_request>(std::begin(request.at), std::end(request.at)); };

constexpr axi_settings one_word{8, 40, 8, 128, 0x40000008, 403, 0, 0, 1, 1, 0};
constexpr axi_settings four_words{8, 40, 16, 16, 0x7f00000018, 8192, 0, 0, 1, 1, 0};
constexpr axi_settings three_small_words{2, 16, 4, 128, 0x1002, 1, 0, 0, 1, 1, 0};

std::size_t request_count(std::uint64_t words) { return vector_count() / 500 / words; }

TEST(axi_read, one_word_a_request) {
  for (axi_settings const& s : axi_all(one_word)) {
    axi_run<Vaxi_read>(s, some_requests<1>(request_count(1), s.width, false), words_of);
    if (HasFailure()) return;
  }
}

TEST(axi_read, four_words_a_request_and_few_outstanding) {
  for (axi_settings const& s : axi_all(four_words)) {
    axi_run<Vaxi_read_4>(s, some_requests<4>(request_count(2), s.width, false), words_of);
    if (HasFailure()) return;
  }
}

TEST(axi_read, three_small_words_a_request) {
  for (axi_settings const& s : axi_all(three_small_words)) {
    axi_run<Vaxi_read_3>(s, some_requests<3>(request_count(2), s.width, false), words_of);
    if (HasFailure()) return;
  }
}

TEST(axi_read, a_beat_a_clock_from_a_memory_of_60_clocks) {
  axi_settings s = one_word;
  s.latency_low = s.latency_high = 60;
  constexpr std::size_t count = 1000;
  EXPECT_EQ(axi_run<Vaxi_read>(s, some_requests<1>(count, s.width, true), words_of).clocks, count + 60 + latency);
  s = three_small_words;
  s.latency_low = s.latency_high = 60;
  EXPECT_EQ(axi_run<Vaxi_read_3>(s, some_requests<3>(count, s.width, true), words_of).clocks, 3 * count + 60 + latency);
}

// 16 beats outstanding: the bus is used 16 clocks of every turn, no more.
TEST(axi_read, few_outstanding_beats_bound_the_rate) {
  axi_settings s = four_words;
  s.latency_low = s.latency_high = 60;
  constexpr std::size_t count = 1000;
  const std::uint64_t clocks = axi_run<Vaxi_read_4>(s, some_requests<4>(count, s.width, true), words_of).clocks;
  EXPECT_GT(clocks, 4 * count * 60 / 16);
  EXPECT_LT(clocks, 4 * count * 66 / 16);
}

}  // namespace
}  // namespace relievo::test

// verilate: Vsummed_area_lookup_1 ReadsPerClock=1
// verilate: Vsummed_area_lookup_4 ReadsPerClock=4
// verilate: Vsummed_area_lookup_few ReadsPerClock=4 InFlight=8
// summed_area_lookup: the circuit equals the kernel with one and with four words a clock, on every kind of map under all traffic, several
// turns beyond its borders, with tables of any words; four words a pass and no beat more, 48 clocks and the memory's later.
#include "Vsummed_area_lookup_1.h"
#include "Vsummed_area_lookup_4.h"
#include "Vsummed_area_lookup_few.h"
#include "hls/surface/summed_area_lookup.hpp"
#include "tests/support/map_cases.hpp"
#include "tests/support/map_memories.hpp"
#include "tests/support/stream_unit.hpp"

namespace relievo::test {
namespace {

using input = hls::summed_area_lookup_in;
using vector = map_stimulus<input>;

struct one_word {
  using model = Vsummed_area_lookup_1;
  static constexpr int reads = 1;
};
struct four_words {
  using model = Vsummed_area_lookup_4;
  static constexpr int reads = 4;
};
// Places for 8 beats and 12 results only.
struct few_places {
  using model = Vsummed_area_lookup_few;
  static constexpr int reads = 4;
};
template <class T>
class summed_area_lookup : public testing::Test {};
using widths = testing::Types<one_word, four_words>;
TYPED_TEST_SUITE(summed_area_lookup, widths);

template <class Width, class Shape, class Answers>
std::uint64_t clocks_of(traffic const& t, hls::map_regs const& regs, hls::table_memory const& memory, Answers answers_of, Shape shape,
                        std::uint64_t count) {
  using model = typename Width::model;
  using requests = group<table_request, Width::reads>;
  const auto answers = in_group<Width::reads>(answers_of);
  return stream_test<model, vector>(
      t,
      [&](vector& v, generator& g) {
        v.map = regs;
        shape(v.in, g);
      },
      [&](vector const& v) { return hls::summed_area_lookup(v.in, regs, memory); }, {RELIEVO_MEMORY_PORT(model, table, requests, answers)},
      count);
}

void bounds(hls::fixed<formats::bound>& low, hls::fixed<formats::bound>& high, std::int64_t a, std::int64_t b) {
  low = hls::from_raw<formats::bound>(a);
  high = hls::from_raw<formats::bound>(b);
}

// Bounds up to six turns beyond a wrapped axis, often at a border or across one; some texels beyond a clamped one, never all.
void place(hls::fixed<formats::bound>& low, hls::fixed<formats::bound>& high, std::int64_t size, bool wrap, std::int64_t longest,
           generator& g) {
  const std::int64_t first = wrap ? std::max<std::int64_t>(-6 * size, -32768) : -std::min<std::int64_t>(size, 1000);
  const std::int64_t end = wrap ? std::min<std::int64_t>(7 * size, 32767) : size + 1000;
  const std::uint64_t kind = g.below(4);
  std::int64_t a = kind == 0 ? first : kind == 1 ? g.between(0, size - 1) : g.between(first, end - 1);
  if (g.chance(4)) a = g.between(-1, 1) + size * g.between(-1, 1);
  if (!wrap) a = std::min(a, size - 1);
  a = std::clamp(a, first, end - 1);
  std::int64_t b = g.chance(4) ? end : a + g.between(1, g.chance(2) ? size : end - a);
  if (g.chance(4)) b = g.between(-1, 1) + size * g.between(0, 2);
  b = std::clamp(b, a + 1, std::min(end, a + longest));
  if (!wrap && b <= 0) a = 0, b = std::max<std::int64_t>(b, 1);
  bounds(low, high, a, b);
}

void place_both(input& in, hls::map_regs const& regs, generator& g) {
  constexpr std::int64_t texels = std::int64_t(1) << 24;
  place(in.x0, in.x1, raw(regs.width), regs.wrap_u, 65535, g);
  place(in.y0, in.y1, raw(regs.height), regs.wrap_v, texels / (raw(in.x1) - raw(in.x0)), g);
}

TYPED_TEST(summed_area_lookup, rtl_equals_hls) {
  const auto list = all_traffic();
  for_maps([&](test_map const& map, hls::map_regs const& regs) {
    for (traffic const& t : list)
      clocks_of<TypeParam>(
          t, regs, map.table(), table_answers(map), [&](input& in, generator& g) { place_both(in, regs, g); },
          rtl_vector_count() / (map_case_count * list.size()) + 1);
  });
}

// Slower then, but nothing is asked for or answered that has no place. A result a word, as where nothing wraps, fills the places most.
TEST(summed_area_lookup, rtl_equals_hls_where_places_are_few) {
  generator g("few");
  const test_map map(13, 37, fill::random, g);
  for (int mode = 0; mode < 4; ++mode) {
    const hls::map_regs regs = map.regs(mode % 2 != 0, mode / 2 != 0);
    const auto any = [&](input& in, generator& to) { place_both(in, regs, to); };
    for (traffic const& t : all_traffic())
      clocks_of<few_places>(t, regs, map.table(), table_answers(map), any, rtl_vector_count() / (mode == 0 ? 20 : 200) + 1);
  }
}

// The longest axes, and the largest area of which all is on the map.
TYPED_TEST(summed_area_lookup, rtl_equals_hls_on_the_longest_axes_and_the_largest_areas) {
  generator g("large");
  constexpr map_size sizes[] = {{8192, 2}, {2, 8192}, {1300, 1100}};
  for (const map_size size : sizes)
    for (const fill how : {fill::maximum, fill::random}) {
      const test_map map(size.width, size.height, how, g);
      for (int mode = 0; mode < 4; ++mode) {
        const hls::map_regs regs = map.regs(mode % 2 != 0, mode / 2 != 0);
        const auto any = [&](input& in, generator& to) { place_both(in, regs, to); };
        clocks_of<TypeParam>({0, 0, 1, 4}, regs, map.table(), table_answers(map), any, rtl_vector_count() / 100 + 1);
      }
    }
  const test_map map(1300, 1100, fill::maximum, g);
  const hls::map_regs regs = map.regs(true, false);
  const auto largest = [&](input& in, generator&) {
    bounds(in.x0, in.x1, -7800, 9100);
    bounds(in.y0, in.y1, 110, 1102);
  };
  clocks_of<TypeParam>({0, 0, 1, 1}, regs, map.table(), table_answers(map), largest, 4);
}

// Every step is linear in the words and modulo 2^40, so the circuit's choice of words gives the kernel's sums of a table of any words.
TYPED_TEST(summed_area_lookup, rtl_equals_hls_with_a_table_of_any_words) {
  generator g("words");
  for (const map_size size : {map_size{1, 1}, {2, 3}, {7, 5}, {30, 40}})
    for (int mode = 0; mode < 4; ++mode) {
      const test_map map(size.width, size.height, fill::zero, g);
      const hls::map_regs regs = map.regs(mode % 2 != 0, mode / 2 != 0);
      std::vector<std::uint64_t> words;
      for (int i = 0; i < size.width * size.height; ++i) words.push_back(g() >> (g.chance(4) ? 24 + g.below(40) : 24));
      const auto answers = [&](table_request const& request) {
        const std::uint64_t word = request.read ? words[static_cast<std::size_t>(raw(request.y)) * static_cast<std::size_t>(size.width) +
                                                        static_cast<std::size_t>(raw(request.x))]
                                                : g() >> 24;
        return table_word{hls::from_raw<formats::table_sum>(static_cast<std::int64_t>(word))};
      };
      const auto any = [&](input& in, generator& to) { place_both(in, regs, to); };
      clocks_of<TypeParam>({0, 3, 1, 9}, regs, {words.data()}, answers, any, rtl_vector_count() / 200 + 1);
    }
}

// Rectangles of one kind: so many passes of 4/reads beats, so many words, whatever the latency of the memory.
TYPED_TEST(summed_area_lookup, takes_four_words_a_pass_and_a_pass_for_every_border_that_is_crossed) {
  struct kind {
    std::int64_t x0, x1, y0, y1;
    std::uint64_t passes, words;
  };
  // Of a map of 13 x 37 that wraps. Further passes read two words of the last column or row, and its corner.
  constexpr kind kinds[] = {
      {1, 9, 3, 30, 1, 4},          // inside
      {1, 13, 3, 37, 1, 4},         // up to the borders
      {0, 9, 3, 30, 1, 2},          // from a border: SAT(0, y) is 0
      {0, 13, 0, 37, 1, 1},         // all of the map
      {-13, 0, 74, 111, 1, 1},      // all of another copy
      {-10, -3, 40, 60, 1, 4},      // inside another copy
      {-2, 9, 3, 30, 2, 4 + 2},     // across a border of one axis
      {12, 14, 3, 30, 2, 4 + 2},    // the same
      {1, 9, 30, 50, 2, 4 + 2},     // the same
      {-70, 80, 30, 36, 2, 4 + 2},  // and across eleven
      {-2, 9, -4, 5, 4, 4 + 2 + 2 + 1},
      {-26, 1, 0, 38, 4, 1 + 1 + 1 + 1},
  };
  generator g("rate");
  const test_map map(13, 37, fill::random, g);
  constexpr std::uint64_t count = 300;
  for (kind const& k : kinds)
    for (const std::int64_t latency : {1, 60}) {
      std::uint64_t words = 0;
      const auto answers = [&](table_request const& request) {
        words += request.read ? 1 : 0;
        return table_answers(map)(request);
      };
      const auto same = [&](input& in, generator&) {
        bounds(in.x0, in.x1, k.x0, k.x1);
        bounds(in.y0, in.y1, k.y0, k.y1);
      };
      const std::uint64_t clocks = clocks_of<TypeParam>({0, 0, latency, latency}, map.regs(true, true), map.table(), answers, same, count);
      const auto latency_of_all = 48 + static_cast<std::uint64_t>(latency);
      EXPECT_EQ(clocks, count * k.passes * 4 / TypeParam::reads + latency_of_all)
          << "[" << k.x0 << ", " << k.x1 << ") x [" << k.y0 << ", " << k.y1 << ")";
      EXPECT_EQ(words, count * k.words) << "[" << k.x0 << ", " << k.x1 << ") x [" << k.y0 << ", " << k.y1 << ")";
    }
}

}  // namespace
}  // namespace relievo::test

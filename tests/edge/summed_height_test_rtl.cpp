// verilate: Vsummed_height_test_1 ReadsPerClock=1
// verilate: Vsummed_height_test_3 ReadsPerClock=3
// verilate: Vsummed_height_test_4 ReadsPerClock=4
// verilate: Vsummed_height_test_12 ReadsPerClock=12
// summed_height_test: the circuit equals the kernel with 1, 3, 4 and 12 words a clock, on every kind of map under all traffic, and at its
// thresholds; an edge takes twelve words and 12, 4, 3 or 1 clocks, 63 clocks (67 with 3 words) and the memory's later, more across wrapped
// borders.
#include <cstdlib>
#include <memory>
#include <string>

#include "Vsummed_height_test_1.h"
#include "Vsummed_height_test_12.h"
#include "Vsummed_height_test_3.h"
#include "Vsummed_height_test_4.h"
#include "golden/edge/summed_height_test.hpp"
#include "hls/edge/calculate_new_u.hpp"
#include "hls/edge/summed_height_test.hpp"
#include "tests/support/map_cases.hpp"
#include "tests/support/map_memories.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/stream_unit.hpp"

namespace relievo::test {
namespace {

using input = hls::summed_height_test_in;
using vector = map_stimulus<input, hls::summed_height_test_regs>;

template <class Model, int Reads>
struct variant {
  using model = Model;
  static constexpr int reads = Reads;
  static constexpr bool side_by_side = Reads % 3 == 0;
};
template <class T>
class summed_height_test : public testing::Test {};
using variants = testing::Types<variant<Vsummed_height_test_1, 1>, variant<Vsummed_height_test_3, 3>, variant<Vsummed_height_test_4, 4>,
                                variant<Vsummed_height_test_12, 12>>;
TYPED_TEST_SUITE(summed_height_test, variants);

// Edges that came out with sht, and words that were read.
struct tally {
  std::uint64_t seen = 0, positive = 0, words = 0;
};

template <class Variant, class Shape>
std::uint64_t clocks_of(traffic const& t, test_map const& map, hls::map_regs const& regs, Shape shape, std::uint64_t count, tally& counts) {
  using model = typename Variant::model;
  using requests = group<table_request, Variant::reads>;
  const auto answers = in_group<Variant::reads>([&](table_request const& request) {
    counts.words += request.read ? 1 : 0;
    return table_answers(map)(request);
  });
  return stream_test<model, vector>(
      t,
      [&](vector& v, generator& g) {
        v.map = regs;
        shape(v, g);
      },
      [&](vector const& v) {
        const auto out = hls::summed_height_test(v.in, regs, v.regs, map.table());
        ++counts.seen;
        counts.positive += out.sht ? 1 : 0;
        return out;
      },
      {RELIEVO_MEMORY_PORT(model, table, requests, answers)}, count);
}

void set_midpoint(input& in) {
  const auto middle = hls::calculate_new_u({{in.u1[0], in.u1[1]}, {in.u2[0], in.u2[1]}, hls::from_raw<formats::weight>(8)});
  for (int i = 0; i < 2; ++i) in.u12[i] = middle.u[i];
}

void edge_within(input& in, hls::map_regs const& map, generator& g) {
  coordinates_within(in.u1, map, g);
  if (g.chance(2))
    for (int i = 0; i < 2; ++i) near(in.u2[i], in.u1[i], 20000, g);
  coordinates_within(in.u2, map, g);
  set_midpoint(in);
}

// The thresholds that equal the measure of the edge, give or take an LSB.
void threshold_at(vector& v, test_map const& map, std::int64_t off) {
  const auto sides = golden::summed_height_measure<golden::rounded>(as_golden<golden::summed_height_test_in>(v.in),
                                                                    as_golden<golden::map_regs>(v.map), {true, 0, 1}, map.golden_table());
  const auto measure = static_cast<std::int64_t>(sides.measure * 16);
  const std::int64_t sum = measure / 2 + off, average = measure / static_cast<std::int64_t>(sides.threshold) + off;
  v.regs.sum_threshold = hls::from_raw<formats::sum_threshold>(std::max<std::int64_t>(sum, 0));
  v.regs.average_threshold = hls::from_raw<formats::average_threshold>(std::clamp<std::int64_t>(average, 0, (1 << 20) - 1));
}

TYPED_TEST(summed_height_test, rtl_equals_hls) {
  const auto list = all_traffic();
  tally counts;
  for_maps([&](test_map const& map, hls::map_regs const& regs) {
    for (traffic const& t : list) {
      int drawn = 0;  // the first are the registers of all
      clocks_of<TypeParam>(
          t, map, regs,
          [&](vector& v, generator& g) {
            edge_within(v.in, regs, g);
            if (drawn++ == 0) threshold_at(v, map, 0);
          },
          rtl_vector_count() / (map_case_count * list.size() * 8) + 1, counts);
    }
  });
  EXPECT_GT(counts.positive, counts.seen / 10);
  EXPECT_LT(counts.positive, counts.seen * 9 / 10);
}

// Whoever reads the answers is slow for so long that they wait back to the lookups.
TYPED_TEST(summed_height_test, rtl_equals_hls_for_a_slow_reader) {
  generator g("slow");
  tally counts;
  const test_map map(16, 24, fill::random, g);
  const hls::map_regs regs = map.regs(false, false);
  clocks_of<TypeParam>(
      {0, 14, 1, 1}, map, regs, [&](vector& v, generator& to) { edge_within(v.in, regs, to); }, 2000, counts);
}

// One edge again and again, at its own threshold and an LSB beside it, in both modes.
TYPED_TEST(summed_height_test, rtl_equals_hls_at_its_thresholds) {
  generator g("threshold");
  tally counts;
  for (int i = 0; i < 120; ++i) {
    const map_size size = map_sizes[g.below(sizeof map_sizes / sizeof map_sizes[0])];
    const test_map map(size.width, size.height, fill::random, g);
    const hls::map_regs regs = map.regs(g.chance(2), g.chance(2));
    vector edge{};
    draw_vector(edge, static_cast<draw>(i % 4), g);
    edge.map = regs;
    edge_within(edge.in, regs, g);
    threshold_at(edge, map, i % 3 - 1);
    clocks_of<TypeParam>(
        {0, 0, 1, 1}, map, regs, [&](vector& v, generator&) { v = edge; }, 2, counts);
  }
  EXPECT_GT(counts.positive, counts.seen / 10);
  EXPECT_LT(counts.positive, counts.seen * 9 / 10);
}

// The longest edges: extents of 1024 texels where nothing wraps.
TYPED_TEST(summed_height_test, rtl_equals_hls_on_the_longest_edges) {
  generator g("longest");
  tally counts;
  for (const map_size size : {map_size{8192, 2}, map_size{2, 8192}})
    for (int mode = 0; mode < 4; ++mode) {
      const test_map map(size.width, size.height, fill::random, g);
      const hls::map_regs regs = map.regs(mode % 2 != 0, mode / 2 != 0);
      int drawn = 0;
      const auto across = [&](vector& v, generator& to) {
        coordinates_within(v.in.u1, regs, to);
        coordinates_within(v.in.u2, regs, to);
        set_midpoint(v.in);
        if (drawn++ == 0) threshold_at(v, map, 0);
      };
      clocks_of<TypeParam>({0, 0, 1, 4}, map, regs, across, rtl_vector_count() / 1000 + 1, counts);
    }
}

// Across the largest map: an area of 2^24 around the middle, the only one with that bit. The table is of no map, all zeros but for the word
// that the middle's sum begins with, so that the sum is that word; the limit of the mean is met exactly, and missed by one.
TYPED_TEST(summed_height_test, rtl_equals_hls_with_the_largest_area) {
  using model = typename TypeParam::model;
  using requests = group<table_request, TypeParam::reads>;
  constexpr std::size_t size = 8192;
  const std::unique_ptr<std::uint64_t, void (*)(void*)> words(static_cast<std::uint64_t*>(std::calloc(size * size, sizeof(std::uint64_t))),
                                                              std::free);
  ASSERT_NE(words, nullptr);
  const auto place_of = [](std::int64_t x, std::int64_t y) { return static_cast<std::size_t>(y) * size + static_cast<std::size_t>(x); };
  const auto answers = in_group<TypeParam::reads>([&](table_request const& r) {
    const std::uint64_t word = r.read ? words.get()[place_of(raw(r.x), raw(r.y))] : 0;
    return table_word{hls::from_raw<formats::table_sum>(static_cast<std::int64_t>(word))};
  });
  vector edge{};
  edge.map.width = edge.map.height = hls::from_raw<formats::map_size>(size);
  for (int i = 0; i < 2; ++i) edge.in.u2[i] = hls::from_raw<formats::coordinate>(8191 * 2048);
  set_midpoint(edge.in);
  edge.regs.average = true;
  edge.regs.average_threshold = hls::from_raw<formats::average_threshold>(3 * 16);
  std::string seen;
  for (const int off : {-1, 0, 1}) {
    // Of the rectangle [2048, 6144) in both axes the high corner; all others are zero.
    words.get()[place_of(6143, 6143)] = static_cast<std::uint64_t>((std::int64_t(3) << 24) + off);
    stream_test<model, vector>(
        {0, 0, 1, 1}, [&](vector& v, generator&) { v = edge; },
        [&](vector const& v) {
          const auto out = hls::summed_height_test(v.in, v.map, v.regs, {words.get()});
          seen += out.sht ? '1' : '0';
          return out;
        },
        {RELIEVO_MEMORY_PORT(model, table, requests, answers)}, 1);
  }
  EXPECT_EQ(seen, "001") << "the kernel does not stand at the limit";
}

// On small maps, coordinates three turns apart: only there are extents longer than a quarter of a wrapped axis.
TYPED_TEST(summed_height_test, rtl_equals_hls_where_a_wrapped_axis_bounds_the_extents) {
  generator g("quarter");
  tally counts;
  for (const map_size size : {map_size{1, 1}, {2, 3}, {5, 7}, {16, 24}})
    for (int mode = 1; mode < 4; ++mode) {
      const test_map map(size.width, size.height, fill::random, g);
      const hls::map_regs regs = map.regs(mode % 2 != 0, mode / 2 != 0);
      int drawn = 0;
      const auto apart = [&](vector& v, generator& to) {
        for (int axis = 0; axis < 2; ++axis) {
          const bool wrap = axis == 0 ? regs.wrap_u : regs.wrap_v;
          const std::int64_t end = coordinate_limit(axis == 0 ? regs.width : regs.height, wrap) * (wrap ? 3 : 1);
          v.in.u1[axis] = hls::from_raw<formats::coordinate>(to.chance(2) ? 0 : to.between(0, end));
          v.in.u2[axis] = hls::from_raw<formats::coordinate>(to.chance(2) ? end : to.between(0, end));
        }
        set_midpoint(v.in);
        if (drawn++ == 0) threshold_at(v, map, 0);
      };
      clocks_of<TypeParam>({0, 0, 1, 4}, map, regs, apart, rtl_vector_count() / 1000 + 1, counts);
    }
}

void place(input& in, double x1, double y1, double x2, double y2) {
  const auto at = [](double c) { return hls::from_raw<formats::coordinate>(static_cast<std::int64_t>(c * 2048)); };
  in.u1[0] = at(x1), in.u1[1] = at(y1);
  in.u2[0] = at(x2), in.u2[1] = at(y2);
  set_midpoint(in);
}

TYPED_TEST(summed_height_test, takes_twelve_words_an_edge_and_as_many_clocks_as_promised) {
  struct kind {
    double x1, y1, x2, y2;
    std::uint64_t passes[3], words;  // of the three rectangles
  };
  // On a map of 64 x 48 texels that wraps.
  constexpr kind kinds[] = {
      {20.5, 20.5, 40.25, 30.75, {1, 1, 1}, 12},        // nothing crosses
      {0.5, 20.5, 20, 30, {2, 1, 1}, 12 + 2},           // the rectangle around P1 crosses a border
      {20, 30, 0.5, 20.5, {1, 2, 1}, 12 + 2},           // that around P2
      {0.5, 0.5, 20, 30, {4, 1, 1}, 12 + 5},            // P1 both borders
      {0.5, 20.5, 20, 47.5, {2, 2, 1}, 12 + 4},         // P1 one, P2 the other
      {2.5, 20.5, 3.5, 20.5, {1, 1, 1}, 12},            // as close to the border as a rectangle of its size can lie
      {0.25, 20.5, 1.25, 20.5, {1, 1, 2}, 12 - 2 + 2},  // P12 crosses it; that around P1 begins at the border
  };
  generator g("rate");
  const test_map map(64, 48, fill::random, g);
  const hls::map_regs regs = map.regs(true, true);
  constexpr std::uint64_t count = 300;
  // Three rectangles with a word each take turns before and behind their reads.
  constexpr std::uint64_t latency_but_memory = TypeParam::reads == 3 ? 67 : 63;
  for (kind const& k : kinds)
    for (const std::int64_t latency : {1, 60}) {
      tally counts;
      const std::uint64_t clocks = clocks_of<TypeParam>(
          {0, 0, latency, latency}, map, regs, [&](vector& v, generator&) { place(v.in, k.x1, k.y1, k.x2, k.y2); }, count, counts);
      // P1 across u and P2 across v, side by side: all of them make the four passes of an edge that crosses both.
      const bool across_both = k.passes[0] == 2 && k.passes[1] == 2;
      const std::uint64_t beats = TypeParam::side_by_side ? (across_both ? 4 : std::max({k.passes[0], k.passes[1], k.passes[2]})) * 12
                                                          : (k.passes[0] + k.passes[1] + k.passes[2]) * 4;
      EXPECT_EQ(clocks, count * beats / TypeParam::reads + latency_but_memory + static_cast<std::uint64_t>(latency))
          << k.x1 << ", " << k.y1 << " to " << k.x2;
      EXPECT_EQ(counts.words, count * k.words) << k.x1 << ", " << k.y1 << " to " << k.x2;
    }
}

}  // namespace
}  // namespace relievo::test

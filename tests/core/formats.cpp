// formats: every entry of the one table is a usable word, and holds the values that the rest of the project takes for granted.
#include "hls/core/formats.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "hls/core/fixed.hpp"

namespace relievo::test {
namespace {

struct entry {
  std::string name;
  int width, integer_bits, fraction;
  bool is_signed;
};

std::vector<entry> table() {
  std::vector<entry> list;
#define RELIEVO_ENTRY(id, w, i, s)                                                                                     \
  static_assert(formats::id::width == (w) && formats::id::integer_bits == (i) && formats::id::fraction == (w) - (i) && \
                formats::id::is_signed == (s));                                                                        \
  list.push_back({#id, formats::id::width, formats::id::integer_bits, formats::id::fraction, formats::id::is_signed});
  RELIEVO_FORMATS(RELIEVO_ENTRY)
#undef RELIEVO_ENTRY
  return list;
}

TEST(formats, every_name_is_there_once_and_fits_the_double_of_the_golden_model) {
  std::set<std::string> names;
  for (entry const& e : table()) {
    EXPECT_TRUE(names.insert(e.name).second) << e.name;
    EXPECT_LE(e.width, 53) << e.name << ": golden keeps a word in a double";
    EXPECT_EQ(e.fraction, e.width - e.integer_bits) << e.name;
  }
  EXPECT_GE(names.size(), 30u);
}

template <class F>
constexpr bool holds(double x) {
  const double word = x * (F::fraction >= 0 ? static_cast<double>(std::int64_t(1) << F::fraction) : 0.0);
  return static_cast<double>(static_cast<std::int64_t>(word)) == word && word >= static_cast<double>(hls::fixed<F>::min_raw) &&
         word <= static_cast<double>(hls::fixed<F>::max_raw);
}

TEST(formats, values_that_must_be_words) {
  EXPECT_TRUE(holds<formats::unit>(1.0) && holds<formats::unit>(-1.0)) << "components of an axis";
  EXPECT_TRUE(holds<formats::coordinate>(8192)) << "the far side of a wrapped map";
  EXPECT_TRUE(holds<formats::map_size>(8192));
  EXPECT_TRUE(holds<formats::texel>(65535));
  EXPECT_TRUE(holds<formats::sample>(65535)) << "no sample saturates";
  EXPECT_TRUE(holds<formats::position>(-8.0));
  EXPECT_TRUE(holds<formats::weight>(16)) << "the far end of an edge";
  EXPECT_TRUE(holds<formats::generation>(15));
  EXPECT_TRUE(holds<formats::depth>(1.0 / 256)) << "w_min";
  EXPECT_TRUE(holds<formats::area>(4096.0 * 4096));
  // Centre column 8193, half extent 2 * 1024: how far a rectangle may stick out.
  EXPECT_TRUE(holds<formats::bound>(8193 + 2048) && holds<formats::bound>(1 - 2048));
  EXPECT_TRUE(holds<formats::direction>(4.0) && holds<formats::direction>(-4.0)) << "two opposite corners of the unit format, summed";
  EXPECT_FALSE(holds<formats::unit>(2.0));
  EXPECT_FALSE(holds<formats::map_size>(16384));
}

// What the units rely on without saying so.
static_assert(formats::fraction::width == formats::coordinate::fraction, "the place between two texels is the coordinate's fraction");
static_assert(formats::matrix_xy::fraction + formats::position::fraction == formats::offset_xy::fraction,
              "offsets have the sum's fraction");
static_assert(formats::matrix_w::fraction + formats::position::fraction == formats::offset_w::fraction, "offsets have the sum's fraction");
static_assert(formats::depth::width + formats::screen::width <= 52, "the double quotient of the golden model is correctly rounded");
static_assert(formats::area::width + formats::sample::width <= 52, "the double quotient of the golden model is correctly rounded");
static_assert(formats::rectangle_sum::integer_bits > formats::table_sum::width, "a clipped sum is at most the largest full one");
static_assert(formats::rectangle_sum::fraction == formats::sample::fraction, "a clipped sum is a mean times an area");
static_assert(formats::eye::fraction == formats::position::fraction, "P' - E is exact");

}  // namespace
}  // namespace relievo::test

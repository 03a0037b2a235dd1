// packed: fields from bit 0 in their order, signs kept, zeros above; every record comes back as it went in.
#include "hls/core/packed.hpp"

#include <gtest/gtest.h>

#include "hls/edge/engine_regs.hpp"
#include "hls/edge/triangle.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

struct small {
  hls::fixed<format<3, 3, true>> a;
  bool b;
  hls::fixed<format<5, 2, false>> c[2];
  RELIEVO_FIELDS(a, b, c)
};
// Words at and across the borders of 64 bits.
struct wide {
  hls::fixed<format<63, 40, false>> a;
  bool b;
  hls::fixed<format<64, 30, true>> c;
  small d[2];
  hls::fixed<format<64, 64, true>> e;
  RELIEVO_FIELDS(a, b, c, d, e)
};

static_assert(hls::field_width<small>::value == 14 && sizeof(hls::port_word<small>) == 8);
static_assert(hls::field_width<wide>::value == 63 + 1 + 64 + 2 * 14 + 64);
static_assert(std::is_same_v<hls::port_word<wide>, hls::bits<224>>);
static_assert(std::is_same_v<hls::port_word<hls::vertex>, hls::bits<464>> && hls::field_width<hls::vertex>::value == 462);

TEST(packed, fields_lie_from_bit_0_in_their_order) {
  small s{};
  s.a = hls::from_raw<format<3, 3, true>>(-3);
  s.b = true;
  s.c[0] = hls::from_raw<format<5, 2, false>>(17);
  s.c[1] = hls::from_raw<format<5, 2, false>>(30);
  EXPECT_EQ(hls::pack(s).limb[0], 0b11110'10001'1'101u);
}

// The bits of a record, one by one, from its words and their widths.
template <class Record>
std::vector<bool> bits_of(Record const& record) {
  std::vector<bool> bits;
  const std::vector<std::int64_t> words = tb::raw_words(record);
  for (std::size_t i = 0; i < words.size(); ++i)
    for (int bit = 0; bit < tb::layout<Record>()[i].width; ++bit) bits.push_back(((words[i] >> bit) & 1) != 0);
  bits.resize((bits.size() + 7) / 8 * 8);
  return bits;
}

template <class Record>
testing::AssertionResult packs(Record const& record) {
  const auto word = hls::pack(record);
  const std::vector<bool> bits = bits_of(record);
  for (std::size_t i = 0; i < 8 * sizeof word; ++i)
    if (((word.limb[i / 64] >> (i % 64)) & 1) != (i < bits.size() && bits[i] ? 1u : 0u)) return testing::AssertionFailure() << "bit " << i;
  return same_words(hls::unpack<Record>(word), record);
}

TEST(packed, every_bit_is_in_its_place_and_comes_back) {
  for_vectors<small>(any_word(), packs<small>, vector_count() / 20);
  for_vectors<wide>(any_word(), packs<wide>, vector_count() / 20);
  for_vectors<hls::triangle_out>(any_word(), packs<hls::triangle_out>, vector_count() / 200);
  for_vectors<hls::engine_regs>(any_word(), packs<hls::engine_regs>, vector_count() / 200);
}

TEST(packed, words_compare_by_all_their_bits) {
  wide w{};
  const auto zero = hls::pack(w);
  w.e = hls::from_raw<format<64, 64, true>>(std::int64_t(1) << 62);
  EXPECT_TRUE(zero != hls::pack(w));
  EXPECT_TRUE(zero == hls::pack(wide{}));
}

}  // namespace
}  // namespace relievo::test

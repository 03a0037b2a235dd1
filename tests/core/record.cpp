// record: fields are visited once each, in the order of the list, by name, to be read and to be written; sixteen are not too many.
#include "hls/core/record.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace relievo::test {
namespace {

struct one {
  int only = 5;
  RELIEVO_FIELDS(only)
};
struct sixteen {
  int a = 1, b = 2, c = 3, d = 4, e = 5, f = 6, g = 7, h = 8, i = 9, j = 10, k = 11, l = 12, m = 13, n = 14, o = 15, p = 16;
  RELIEVO_FIELDS(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p)
};

struct reader {
  std::string names;
  std::vector<int> values;
  void operator()(char const* name, int const& x) {
    names += name;
    values.push_back(x);
  }
};
struct doubler {
  void operator()(char const*, int& x) { x *= 2; }
};

TEST(record, visits_every_field_once_in_order) {
  reader r;
  const sixteen s;
  s.each_field(r);
  EXPECT_EQ(r.names, "abcdefghijklmnop");
  EXPECT_EQ(r.values, (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16}));
  reader single;
  one().each_field(single);
  EXPECT_EQ(single.names, "only");
  EXPECT_EQ(single.values, std::vector<int>{5});
}

TEST(record, hands_out_the_fields_themselves) {
  sixteen s;
  s.each_field(doubler());
  EXPECT_EQ(s.a, 2);
  EXPECT_EQ(s.p, 32);
}

}  // namespace
}  // namespace relievo::test

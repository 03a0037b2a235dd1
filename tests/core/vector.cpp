// vector: dot and cross against integers, at the ends of their formats too; their widths.
#include "hls/core/vector.hpp"

#include <gtest/gtest.h>

#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

template <class A, class B>
struct operands {
  hls::fixed<A> a[3];
  hls::fixed<B> b[3];
  RELIEVO_FIELDS(a, b)
};

template <class A, class B>
void expect_exact() {
  for_vectors<operands<A, B>>(any_word(), [](operands<A, B> const& v) {
    std::int64_t product[3][3];
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) product[i][k] = raw(v.a[i]) * raw(v.b[k]);
    const auto d = hls::dot(v.a, v.b);
    if (raw(d) != product[0][0] + product[1][1] + product[2][2]) return testing::AssertionFailure() << "dot " << raw(d);
    if (raw(d) > decltype(d)::max_raw || raw(d) < decltype(d)::min_raw) return testing::AssertionFailure() << "dot leaves its type";
    constexpr int next[] = {1, 2, 0}, after[] = {2, 0, 1};
    for (int i = 0; i < 3; ++i) {
      const auto c = hls::cross(v.a, v.b, i);
      if (raw(c) != product[next[i]][after[i]] - product[after[i]][next[i]])
        return testing::AssertionFailure() << "cross " << i << ": " << raw(c);
      if (raw(c) > decltype(c)::max_raw || raw(c) < decltype(c)::min_raw) return testing::AssertionFailure() << "cross leaves its type";
    }
    return testing::AssertionSuccess();
  });
}

TEST(vector, products_of_units_are_exact) { expect_exact<formats::unit, formats::unit>(); }
TEST(vector, products_of_matrix_rows_are_exact) { expect_exact<formats::matrix_w, formats::position>(); }

template <class F>
using triple = hls::fixed<F>[3];
template <class F>
triple<F> const& three();

static_assert(decltype(hls::dot(three<formats::unit>(), three<formats::unit>()))::format_type::width == 34);
static_assert(decltype(hls::cross(three<formats::unit>(), three<formats::unit>(), 0))::format_type::width == 33);
static_assert(decltype(hls::dot(three<formats::direction>(), three<formats::direction>()))::format_type::width == 38);
static_assert(decltype(hls::dot(three<formats::matrix_xy>(), three<formats::position>()))::format_type::fraction ==
              formats::offset_xy::fraction);

}  // namespace
}  // namespace relievo::test

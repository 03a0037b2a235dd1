// vector: the two products of three-component vectors that the units need, exact.
//   dot(a, b)       a.x b.x + a.y b.y + a.z b.z     two bits wider than one product
//   cross(a, b, i)  component i of a x b            one bit wider than one product, signed
#pragma once
#include "hls/core/fixed.hpp"

namespace relievo {
namespace hls {

template <class A, class B>
constexpr auto dot(A const (&a)[3], B const (&b)[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class A, class B>
constexpr auto cross(A const (&a)[3], B const (&b)[3], int i) {
  return a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

}  // namespace hls
}  // namespace relievo

// edge_trace: all that the engine knew and decided about one tested edge, handed to an observer.
//
//   index, path, edge   the triangle (base triangle, path of triangle.hpp) and which of its edges
//   v1, v2              records of the ends, in edge order
//   k, m                place of the new vertex in sixteenths, and its record: P, U, N, T, N' where the tests got that far,
//                       P' and P'_s only where the edge split
//   intervals           n of the profile, 0 without one
//   vt .. ht            evaluated; value; measure and threshold, the two sides of its comparison (ct has none)
#pragma once
#include <cstdint>

#include "golden/surface/vertex.hpp"

namespace relievo {
namespace golden {

struct test_trace {
  bool evaluated = false;
  bool value = false;
  double measure = 0;
  double threshold = 0;
};

struct edge_trace {
  double index = 0;
  std::uint64_t path = 1;
  int edge = 0;
  double generation = 0;
  vertex v1, v2;
  double k = 8;
  vertex m;
  int intervals = 0;
  test_trace vt, ct, nt, sht, pt, ht;
  bool split = false;
};

}  // namespace golden
}  // namespace relievo

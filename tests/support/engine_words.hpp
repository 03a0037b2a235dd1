// engine_words: what goes into a circuit of the edge engine and comes out, as words.
//   base_of(triangle), base_words(triangles)   as tb/cosim/base_words.hpp
//   sorted_words(records)                      output records, in an order of their own
//   expect_same_set(rtl, kernel)               the same records in any order; else the first that only one of them has
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "hls/edge/engine.hpp"
#include "tb/cosim/base_words.hpp"
#include "tb/model/words.hpp"

namespace relievo::test {

using tb::base_of;
using tb::base_words;

// Records as words, in an order of their own; which of them is the last depends on time.
inline std::vector<std::vector<std::int64_t>> sorted_words(std::vector<hls::triangle_out> const& triangles) {
  std::vector<std::vector<std::int64_t>> set;
  for (hls::triangle_out t : triangles) {
    t.last = false;
    set.push_back(tb::raw_words(t));
  }
  std::sort(set.begin(), set.end());
  return set;
}

// The same records in any order; else the first that only one of them has.
inline void expect_same_set(std::vector<hls::triangle_out> const& rtl, std::vector<hls::triangle_out> const& kernel) {
  const auto a = sorted_words(rtl), b = sorted_words(kernel);
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    for (std::size_t k = 0; k < a[i].size(); ++k)
      ASSERT_EQ(a[i][k], b[i][k]) << "record " << i << " of the sorted ones, " << tb::layout<hls::triangle_out>()[k].name
                                  << ": rtl against hls";
  ASSERT_EQ(a.size(), b.size()) << "records, rtl against hls";
}

}  // namespace relievo::test

// base_words: base triangles as the circuits of the edge engine take them.
//   base_of(triangle)         the kernel's base triangle without what the engine adds
//   base_words(triangles)     packed, one word each
#pragma once
#include <vector>

#include "hls/core/packed.hpp"
#include "hls/edge/triangle.hpp"
#include "hls/top/top.hpp"

namespace relievo::tb {

inline hls::top::base_triangle base_of(hls::triangle const& t) {
  hls::top::base_triangle b{};
  for (int i = 0; i < 3; ++i) {
    hls::detail::copy(b.v[i].p, t.v[i].p);
    hls::detail::copy(b.v[i].n, t.v[i].n);
    hls::detail::copy(b.v[i].t, t.v[i].t);
    hls::detail::copy(b.v[i].u, t.v[i].u);
  }
  b.index = t.index;
  b.last = t.last;
  return b;
}

inline std::vector<hls::port_word<hls::top::base_triangle>> base_words(std::vector<hls::triangle> const& triangles) {
  std::vector<hls::port_word<hls::top::base_triangle>> words;
  words.reserve(triangles.size());
  for (hls::triangle const& t : triangles) words.push_back(hls::pack(base_of(t)));
  return words;
}

}  // namespace relievo::tb

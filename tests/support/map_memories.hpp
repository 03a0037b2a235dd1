// map_memories: answers of the map memories' read ports (tb/cosim/map_words.hpp) from a test map.
//
//   texel_answers(map), normal_answers(map), table_answers(map)   request -> answer from a test_map, for RELIEVO_MEMORY_PORT
//   in_group<N>(answers)                                          the same for a group of N
//   map_stimulus<In>, map_stimulus<In, Regs>                      input vectors of a unit that reads a map: in, map and regs
//   A coordinate outside the map is a failure of the test. Table words that are not to be read are answered all the same, with a word of
//   no meaning, whatever their coordinates.
#pragma once
#include <gtest/gtest.h>

#include "tb/cosim/map_lookup.hpp"
#include "tests/support/maps.hpp"

namespace relievo::test {

using tb::group;
using tb::normal_quad;
using tb::quad_request;
using tb::table_request;
using tb::table_word;
using tb::texel_quad;

struct no_regs {};
template <class In, class Regs = no_regs>
struct map_stimulus {
  In in;
  hls::map_regs map;
  Regs regs;
  RELIEVO_FIELDS(in, map, regs)
};
template <class In>
struct map_stimulus<In, no_regs> {
  In in;
  hls::map_regs map;
  RELIEVO_FIELDS(in, map)
};

inline tb::map_lookup lookup(test_map const& map) {
  tb::map_lookup look([](std::string const& what) { ADD_FAILURE() << what; });
  look.load({static_cast<int>(map.width()), static_cast<int>(map.height()), map.texels().words, map.table().words, map.normals().words});
  return look;
}

inline auto texel_answers(test_map const& map) {
  return [&map](quad_request const& request) { return lookup(map).texels(request); };
}
inline auto normal_answers(test_map const& map) {
  return [&map](quad_request const& request) { return lookup(map).normals(request); };
}
inline auto table_answers(test_map const& map) {
  return [&map](table_request const& request) {
    return request.read ? lookup(map).table(request) : table_word{hls::from_raw<formats::table_sum>(0xfedcba9876)};
  };
}

template <int N, class Answers>
auto in_group(Answers answers) {
  return [answers](auto const& requests) {
    group<decltype(answers(requests.at[0])), N> together{};
    for (int i = 0; i < N; ++i) together.at[i] = answers(requests.at[i]);
    return together;
  };
}

}  // namespace relievo::test

// map_memories: answers of the map memories' read ports (tb/cosim/map_words.hpp) from a test map.
//
//   texel_answers(map), normal_answers(map), table_answers(map)   request -> answer from a test_map, for RELIEVO_MEMORY_PORT
//   in_group<N>(answers)                                          the same for a group of N
//   map_stimulus<In>, map_stimulus<In, Regs>                      input vectors of a unit that reads a map: in, map and regs
//   A coordinate outside the map is a failure of the test. Table words that are not to be read are answered all the same, with a word of
//   no meaning, whatever their coordinates.
#pragma once
#include <gtest/gtest.h>

#include "tb/cosim/map_words.hpp"
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

namespace detail {

// The place of texel (x, y), 0 and a failure where there is none.
inline std::size_t word_place(test_map const& map, hls::fixed<formats::map_size> x, hls::fixed<formats::map_size> y) {
  if (raw(x) >= map.width() || raw(y) >= map.height()) {
    ADD_FAILURE() << "word (" << raw(x) << ", " << raw(y) << ") was asked for, of a map of " << map.width() << " x " << map.height();
    return 0;
  }
  return static_cast<std::size_t>(raw(y) * map.width() + raw(x));
}

}  // namespace detail

inline auto texel_answers(test_map const& map) {
  return [&map](quad_request const& request) {
    texel_quad answer{};
    for (int row = 0; row < 2; ++row)
      for (int column = 0; column < 2; ++column)
        answer.q[row][column] =
            hls::from_raw<formats::texel>(map.texels().words[detail::word_place(map, request.x[column], request.y[row])]);
    return answer;
  };
}

inline auto normal_answers(test_map const& map) {
  return [&map](quad_request const& request) {
    normal_quad answer{};
    for (int row = 0; row < 2; ++row)
      for (int column = 0; column < 2; ++column) {
        const std::uint64_t word = map.normals().words[detail::word_place(map, request.x[column], request.y[row])];
        for (int i = 0; i < 3; ++i) answer.q[row][column][i] = hls::unpack_normal(word, i);
      }
    return answer;
  };
}

inline auto table_answers(test_map const& map) {
  return [&map](table_request const& request) {
    const std::uint64_t word = request.read ? map.table().words[detail::word_place(map, request.x, request.y)] : 0xfedcba9876u;
    return table_word{hls::from_raw<formats::table_sum>(static_cast<std::int64_t>(word))};
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

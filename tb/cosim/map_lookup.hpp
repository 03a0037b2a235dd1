// map_lookup: what the memories of the maps answer, for every bench: words of maps that lie row by row.
//   map_lookup look(fail); look.load(contents)
//   texels(request), normals(request)   a quad;  table(request)  a word of the summed-area table
//   table_words(group), wanted_texels(group, bits)   of a group those that are to be read, the others 0
//   Only words of the map may be asked for: anything else goes to the failure hook, with the memory's name, and is answered with word 0.
#pragma once
#include <cstdint>
#include <string>
#include <utility>

#include "hls/edge/engine_regs.hpp"
#include "hls/surface/map_regs.hpp"
#include "tb/cosim/bus_traffic.hpp"
#include "tb/cosim/map_words.hpp"

namespace relievo::tb {

// The maps, row by row; they outlive the runs that read them.
struct map_contents {
  int width = 0, height = 0;
  std::uint16_t const* texels = nullptr;
  std::uint64_t const *table = nullptr, *normals = nullptr;
};

// Those that an engine's kernel reads.
inline map_contents contents_of(hls::map_regs const& map, hls::engine_memories const& memories) {
  return {static_cast<int>(raw(map.width)), static_cast<int>(raw(map.height)), memories.displacement.words, memories.table.words,
          memories.normals.words};
}

class map_lookup {
 public:
  explicit map_lookup(failure_hook fail) : fail_(std::move(fail)) {}
  void load(map_contents const& c) { map_ = c; }

  texel_quad texels(quad_request const& r) const {
    texel_quad q{};
    for (int row = 0; row < 2; ++row)
      for (int column = 0; column < 2; ++column)
        q.q[row][column] = hls::from_raw<formats::texel>(map_.texels[place("displacement", r.x[column], r.y[row])]);
    return q;
  }
  normal_quad normals(quad_request const& r) const {
    normal_quad q{};
    for (int row = 0; row < 2; ++row)
      for (int column = 0; column < 2; ++column) {
        const std::uint64_t word = map_.normals[place("normal map", r.x[column], r.y[row])];
        for (int i = 0; i < 3; ++i) q.q[row][column][i] = hls::unpack_normal(word, i);
      }
    return q;
  }
  table_word table(table_request const& r) const {
    const std::uint64_t word = map_.table[place("summed-area table", r.x, r.y)];
    return {hls::from_raw<formats::table_sum>(static_cast<std::int64_t>(word))};
  }

  template <int N>
  group<table_word, N> table_words(group<table_request, N> const& r) const {
    group<table_word, N> a{};
    for (int i = 0; i < N; ++i)
      if (r.at[i].read) a.at[i] = table(r.at[i]);
    return a;
  }
  // wanted: a bit for each quad.
  template <int N>
  group<texel_quad, N> wanted_texels(group<quad_request, N> const& r, std::uint64_t wanted) const {
    group<texel_quad, N> a{};
    for (int i = 0; i < N; ++i)
      if (((wanted >> i) & 1) != 0) a.at[i] = texels(r.at[i]);
    return a;
  }

 private:
  std::size_t place(char const* memory, hls::fixed<formats::map_size> u, hls::fixed<formats::map_size> v) const {
    const std::int64_t x = raw(u), y = raw(v);
    if (x >= map_.width || y >= map_.height) {
      fail_(std::string(memory) + ": word (" + std::to_string(x) + ", " + std::to_string(y) + ") was asked for, of a map of " +
            std::to_string(map_.width) + " x " + std::to_string(map_.height));
      return 0;
    }
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(map_.width) + static_cast<std::size_t>(x);
  }

  failure_hook fail_;
  map_contents map_;
};

}  // namespace relievo::tb

// world_words: the units before the grid through their entry points, as text.
//   world_vectors(texels, map)   a vector each; texels are the levels too, of a map of one level, and a z table is built from them
#pragma once
#include <cstdint>

#include "tests/portability/records.hpp"

namespace relievo {
namespace {

void world_vectors(std::uint16_t const* texels, hls::map_regs map) {
  hls::near_clip_regs volume = random_record<hls::near_clip_regs>();
  volume.near = hls::from_raw<formats::depth>(hls::raw(volume.near) >> 12);
  volume.far = hls::from_raw<formats::depth>(hls::raw(volume.far) | 1 << 27);
  const auto planes = hls::pack(volume);
  through<hls::near_clip_out>(
      "near_clip", random_record<hls::near_clip_in>(),
      [&](hls::port<hls::near_clip_in>& in, hls::port<hls::near_clip_out>& out) { relievo_near_clip(in, planes, out); });
  hls::base_triangle_clip_regs view = random_record<hls::base_triangle_clip_regs>();
  view.near = volume.near;
  view.far = volume.far;
  const auto bounds = hls::pack(view);
  through<hls::base_triangle_clip_out>("base_triangle_clip", random_record<hls::base_triangle_clip_in>(),
                                       [&](hls::port<hls::base_triangle_clip_in>& in, hls::port<hls::base_triangle_clip_out>& out) {
                                         relievo_base_triangle_clip(in, bounds, out);
                                       });
  // Levels of 5 x 3, 3 x 2, 2 x 1 and 1 texels.
  map.width = hls::from_raw<formats::map_size>(5);
  map.height = hls::from_raw<formats::map_size>(3);
  hls::d_max_of_in box = random_record<hls::d_max_of_in>();
  for (int axis = 0; axis < 2; ++axis) {
    const std::int64_t limit = (axis == 0 ? 4 : 2) * 2048;
    box.low[axis] = hls::from_raw<formats::coordinate>(hls::raw(box.low[axis]) % limit);
    box.high[axis] =
        hls::from_raw<formats::coordinate>(hls::raw(box.low[axis]) + hls::raw(box.high[axis]) % (limit - hls::raw(box.low[axis])));
  }
  const auto heights = hls::pack(random_record<hls::displace_regs>());
  const auto map_word = hls::pack(map);
  through<hls::d_max_of_out>("d_max_of", box, [&](hls::port<hls::d_max_of_in>& in, hls::port<hls::d_max_of_out>& out) {
    relievo_d_max_of(in, map_word, heights, texels, texels + 100, out);
  });

  hls::port<hls::z_table_out> words;
  relievo_z_table(hls::pack(random_record<hls::top::z_table_regs>()), words);
  std::int64_t z[hls::z_table_words];
  for (std::int64_t& word : z) word = hls::raw(hls::unpack<hls::z_table_out>(words.read()).z);
  hls::z_table_out octave = {hls::from_raw<formats::depth_cells>(z[hls::z_table_words - 1])};
  print_record("z_table", octave);
  const auto grid = hls::pack(random_record<hls::grid_transform_regs>());
  through<hls::grid_transform_out>(
      "grid_transform", random_record<hls::grid_transform_in>(),
      [&](hls::port<hls::grid_transform_in>& in, hls::port<hls::grid_transform_out>& out) { relievo_grid_transform(in, grid, z, out); });
}

}  // namespace
}  // namespace relievo

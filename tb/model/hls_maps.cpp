#include "tb/model/hls_maps.hpp"

#include <memory>

#include "hls/surface/normal_map.hpp"
#include "hls/surface/summed_area_table.hpp"
#include "tb/model/words.hpp"

namespace relievo::tb {

namespace {
hls::map_regs map_registers(scene const& sc) {
  hls::map_regs regs;
  to_hls(sc.regs.map, regs);
  return regs;
}
}  // namespace

std::vector<std::uint64_t> build_summed_area_table(scene const& sc) {
  const hls::map_regs map = map_registers(sc);
  const auto builder = std::make_unique<hls::summed_area_table<max_map_size>>();
  std::vector<std::uint64_t> table(sc.map.texels.size());
  for (std::size_t i = 0; i < table.size(); ++i)
    table[i] = static_cast<std::uint64_t>(hls::raw(builder->step(hls::from_raw<formats::texel>(sc.map.texels[i]), map)));
  return table;
}

built_normals build_normal_map(scene const& sc) {
  const hls::map_regs map = map_registers(sc);
  hls::normal_map_regs regs;
  to_hls(sc.normal_map, regs);
  const auto builder = std::make_unique<hls::normal_map<max_map_size>>();
  built_normals normals;
  normals.words.resize(sc.map.texels.size());
  const std::size_t steps = sc.map.texels.size() + static_cast<std::size_t>(sc.map.width) *
                                                       static_cast<std::size_t>(hls::normal_map<max_map_size>::flush_rows(map));
  hls::normal_map_out out{};
  for (std::size_t i = 0; i < steps; ++i) {
    const auto texel = hls::from_raw<formats::texel>(i < sc.map.texels.size() ? sc.map.texels[i] : 0);
    if (!builder->step(texel, map, regs, out)) continue;
    const std::size_t address =
        static_cast<std::size_t>(hls::raw(out.y)) * static_cast<std::size_t>(sc.map.width) + static_cast<std::size_t>(hls::raw(out.x));
    normals.words[address] = hls::pack_normal(out.n);
    normals.saturations += out.saturated ? 1 : 0;
  }
  return normals;
}

}  // namespace relievo::tb

#include "tb/model/hls_words.hpp"

#include <stdexcept>
#include <type_traits>

#include "tb/model/hls_maps.hpp"
#include "tb/model/words.hpp"

namespace relievo::tb {

hls_words::hls_words(scene const& sc) : texels_(sc.map.texels.data()) {
  if (sc.regs.pass.use_sht) table_ = build_summed_area_table(sc);
  built_normals normals = build_normal_map(sc);
  normals_ = std::move(normals.words);
  map_saturations_ = normals.saturations;
  bool exact = to_hls(sc.regs, regs_);
  triangles_.reserve(sc.triangles.size());
  for (golden::triangle const& t : sc.triangles) {
    triangles_.emplace_back();
    exact = to_hls(t, triangles_.back()) && exact;
  }
  if (!exact) throw std::logic_error("a register or a base triangle of the scene is not quantised to its format");
}

golden::counters hls_words::counters(std::vector<std::uint64_t> const& values) const {
  golden::counters counts;
  std::size_t i = 0;
  counts.each_field([&](char const*, auto& x) {
    if constexpr (std::is_array_v<std::remove_reference_t<decltype(x)>>) {
      for (auto& e : x) e = values.at(i++);
    } else {
      x = values.at(i++);
    }
  });
  counts.saturations += map_saturations_;
  return counts;
}

}  // namespace relievo::tb

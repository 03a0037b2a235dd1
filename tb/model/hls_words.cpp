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

std::vector<std::uint64_t> words_of_counters(hls::counters const& counts) {
  std::vector<std::uint64_t> words;
  counts.each_field([&](char const*, auto const& x) {
    if constexpr (std::is_array_v<std::remove_reference_t<decltype(x)>>)
      words.insert(words.end(), std::begin(x), std::end(x));
    else
      words.push_back(x);
  });
  return words;
}

golden::counters named_counters(std::vector<std::uint64_t> const& words, std::uint64_t map_saturations) {
  golden::counters counts;
  std::size_t i = 0;
  counts.each_field([&](char const*, auto& x) {
    if constexpr (std::is_array_v<std::remove_reference_t<decltype(x)>>) {
      for (auto& e : x) e = words.at(i++);
    } else {
      x = words.at(i++);
    }
  });
  counts.saturations += map_saturations;
  return counts;
}

}  // namespace relievo::tb

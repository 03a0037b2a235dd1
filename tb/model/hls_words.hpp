// hls_words: a scene in the words of the kernels and circuits: registers, base triangles and the memories behind them. The maps are built
// by the streaming builders of hls/surface.
#pragma once
#include <cstdint>
#include <vector>

#include "golden/edge/counters.hpp"
#include "hls/edge/engine.hpp"
#include "tb/host/scene.hpp"

namespace relievo::tb {

// A run's counters as a list in the order of hls/edge/counters.hpp, and such a list by its names; map_saturations: what the builder of the
// normal map clipped, which counts among the saturations.
std::vector<std::uint64_t> words_of_counters(hls::counters const& counts);
golden::counters named_counters(std::vector<std::uint64_t> const& words, std::uint64_t map_saturations);

// The scene must outlive it. std::logic_error when the scene holds something that is no word of its format.
class hls_words {
 public:
  explicit hls_words(scene const& sc);
  hls::engine_regs const& regs() const { return regs_; }
  std::vector<hls::triangle> const& triangles() const { return triangles_; }
  hls::engine_memories memories() const { return {{texels_}, {table_.empty() ? nullptr : table_.data()}, {normals_.data()}}; }
  golden::counters counters(std::vector<std::uint64_t> const& words) const { return named_counters(words, map_saturations_); }

 private:
  std::uint16_t const* texels_;
  std::vector<std::uint64_t> table_, normals_;
  std::uint64_t map_saturations_ = 0;
  hls::engine_regs regs_;
  std::vector<hls::triangle> triangles_;
};

}  // namespace relievo::tb

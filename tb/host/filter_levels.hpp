// filter_levels: a displacement map with all its filter levels, made, written and read.   Gumhold & Huettner 1999, 4 and 4.2
//
//   levels[0] is the map; level l has ceil(W / 2^l) x ceil(H / 2^l) texels of 16 bits, texel j at j 2^l of the map; the last has one texel.
//   kind  averaged, maximum, minimum (level_words.hpp), variational (variational_level.hpp)
//   file  one tiled OpenEXR picture with mipmap levels, sizes rounded up, tiles of 64 x 64, one float channel Y: word / 65535, so that the
//         file is a displacement map too (map.hpp). Row 0 of each level is its bottom row, as in a map's picture. Attributes:
//         levelKind     string, the kind
//         wrapmodes     string, OpenEXR's own: clamp or periodic for u, v: what the levels were made for
//         levelChecksum int, CRC-32 of all words, level by level from row 0, the lower byte first
//   Errors: input_error, one line with the file's name: no .exr, no level file, damaged, of another map.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tb/host/map.hpp"

namespace relievo::tb {

enum class level_kind { averaged, maximum, minimum, variational };
constexpr level_kind all_level_kinds[] = {level_kind::averaged, level_kind::maximum, level_kind::minimum, level_kind::variational};
char const* name_of(level_kind kind);
std::optional<level_kind> level_kind_of(std::string const& name);

struct filter_levels {
  level_kind kind = level_kind::averaged;
  std::vector<displacement_map> levels;
};

// How a level was come by: passes of the variational way, volume to the map of the averaged level and of this one (difference_volume.hpp).
struct level_report {
  int passes = 0;
  double averaged_volume = 0.0, volume = 0.0;
};

constexpr int default_level_passes = 1000;

// The address mode is the map's. `reports`, when given, has one for each level; `tick`, when given, is called after each pass.
filter_levels make_levels(displacement_map const& map, level_kind kind, int most_passes = default_level_passes,
                          std::vector<level_report>* reports = nullptr, std::function<void()> const& tick = {});

std::string levels_bytes(filter_levels const& made);
void write_levels(filter_levels const& made, std::string const& path);

// Whether an .exr says of itself that it holds filter levels; damaged ones may.
bool has_levels(std::string_view bytes);
filter_levels read_levels(std::string_view bytes, std::string const& name);
// The levels of this very map; what was made of another one, or for another address mode, is refused.
filter_levels load_levels(std::string const& path, displacement_map const& map);

}  // namespace relievo::tb

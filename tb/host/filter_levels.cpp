#include "tb/host/filter_levels.hpp"

#include "tb/host/difference_volume.hpp"
#include "tb/host/level_words.hpp"
#include "tb/host/variational_level.hpp"

namespace relievo::tb {

namespace {

double volume_of(displacement_map const& map, displacement_map const& level, int number) {
  return difference_volume(map, number).of({level.texels.begin(), level.texels.end()});
}

}  // namespace

char const* name_of(level_kind kind) {
  switch (kind) {
    case level_kind::averaged:
      return "averaged";
    case level_kind::maximum:
      return "maximum";
    case level_kind::minimum:
      return "minimum";
    case level_kind::variational:
      return "variational";
  }
  return "";
}

std::optional<level_kind> level_kind_of(std::string const& name) {
  for (const level_kind kind : all_level_kinds)
    if (name == name_of(kind)) return kind;
  return std::nullopt;
}

filter_levels make_levels(displacement_map const& map, level_kind kind, int most_passes, std::vector<level_report>* reports,
                          std::function<void()> const& tick) {
  filter_levels made{kind, {map}};
  if (reports != nullptr) reports->assign(1, {});
  for (int l = 1; l < levels_of(map.width, map.height); ++l) {
    level_report report;
    if (kind == level_kind::variational) {
      fitted_level fitted = variational_level(map, l, most_passes, [&] {
        if (tick) tick();
      });
      report = {fitted.passes, fitted.before, fitted.after};
      made.levels.push_back(std::move(fitted.level));
    } else {
      made.levels.push_back(kind == level_kind::averaged
                                ? averaged_level(map, l)
                                : extreme_level(map, l, kind == level_kind::maximum ? extreme::maximum : extreme::minimum));
      if (reports != nullptr) {
        report.volume = volume_of(map, made.levels.back(), l);
        report.averaged_volume = kind == level_kind::averaged ? report.volume : volume_of(map, averaged_level(map, l), l);
      }
    }
    if (reports != nullptr) reports->push_back(report);
  }
  return made;
}

}  // namespace relievo::tb

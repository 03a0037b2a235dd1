// told_difference: what compare and replay say of the first triangle that differs: its line, and a command that runs just that again.
//
//   command_text(app, more)                    the command line as it was given, without its outputs, with `more` at its end
//   told_difference(c, sc, app, only, again)   the comparison's line with golden's path of splits, and "replay: COMMAND": with the option
//                                              `only` and the base triangle at its end when that triangle alone differs too (again runs
//                                              it), else for the whole scene: the fault takes other triangles under way
#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "tb/model/compare.hpp"

namespace relievo::tb {

std::string command_text(CLI::App const& app, std::string const& more);

struct told {
  std::string text;     // lines for stdout
  nlohmann::json json;  // unit, field, words, base_triangle, path, replay
};
told told_difference(comparison const& c, scene const& sc, CLI::App const& app, std::string const& only,
                     std::function<comparison(scene const&)> const& run_again);

}  // namespace relievo::tb

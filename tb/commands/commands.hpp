// commands: one function per subcommand of relievo. Each adds its options to a CLI11 app and returns what runs when it is chosen;
// that returns the exit code: 0 done, 1 a comparison or a check failed. Unusable input is an input_error (main: one line, exit code 2).
#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace relievo::tb {

using command = std::function<int()>;

command add_tessellate(CLI::App& app);
command add_compare(CLI::App& app);
command add_check(CLI::App& app);
command add_error(CLI::App& app);
command add_replay(CLI::App& app);
command add_bench(CLI::App& app);
command add_map(CLI::App& app);
command add_map_levels(CLI::App& app);  // of map

}  // namespace relievo::tb

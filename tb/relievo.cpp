// relievo: the command line. Exit codes: 0 done; 1 a comparison or a check failed; 2 the input or the command line is unusable.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <vector>

#include "tb/commands/commands.hpp"
#include "tb/host/input_error.hpp"

int main(int argc, char** argv) {
  using namespace relievo::tb;
  CLI::App app("Relievo: displacement mapping in hardware, its models and its checks");
  app.require_subcommand(1);
  struct entry {
    CLI::App* app;
    command run;
  };
  std::vector<entry> commands;
  const auto add = [&](char const* name, char const* what, command (*make)(CLI::App&)) {
    CLI::App* sub = app.add_subcommand(name, what);
    commands.push_back({sub, make(*sub)});
  };
  add("tessellate", "a scene through one model: mesh, picture, report", add_tessellate);
  add("compare", "a scene through several models, bit for bit", add_compare);
  add("check", "is a mesh watertight? T-vertices, flips, degenerate triangles, borders", add_check);
  add("error", "distance of a mesh to the fully sampled displaced surface", add_error);
  add("replay", "run recorded vectors again", add_replay);
  add("map", "what is done to maps before a scene", add_map);
  add("bench", "rates of every model on this machine", add_bench);
  try {
    app.parse(argc, argv);
    for (entry const& e : commands)
      if (e.app->parsed()) return e.run();
  } catch (CLI::ParseError const& e) {
    if (e.get_exit_code() == 0) return app.exit(e);
    std::fprintf(stderr, "relievo: %s\n", e.what());
    return 2;
  } catch (input_error const& e) {
    std::fprintf(stderr, "relievo: %s\n", e.what());
    return 2;
  } catch (std::bad_alloc const&) {
    std::fprintf(stderr, "relievo: out of memory\n");
    return 2;
  }
  return 0;
}

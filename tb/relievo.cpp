// relievo: the command line. Exit codes:
//
//   0   done
//   1   a comparison or a check failed, those of the bench around the circuit too (it hangs, breaks a handshake, reads beside a map); what
//       failed is on stdout
//   2   the input or the command line is unusable, or the machine has not the memory or the place that they need
//   3   a fault of relievo itself (an exception that no one expected)
//
// With 2 and 3 there is exactly one line on stderr that begins with "relievo: ", but for warnings before it, and no partial file is left.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "tb/commands/commands.hpp"
#include "tb/cosim/rtl_model.hpp"
#include "tb/cosim/top_model.hpp"
#include "tb/host/input_error.hpp"

namespace {

// One line, whatever file names and arguments bring along.
int refuse(int code, std::string message) {
  while (!message.empty() && message.back() == '\n') message.pop_back();
  for (char& c : message)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  std::fprintf(stderr, "relievo: %s\n", message.c_str());
  return code;
}

}  // namespace

// SystemC's library asks for it when it is linked; this program has its own main.
extern "C" int sc_main(int, char**);
int sc_main(int, char**) { return 0; }

int main(int argc, char** argv) {
  using namespace relievo::tb;
  add_rtl_model();
  add_top_model();
  CLI::App app("Relievo: displacement mapping in hardware, its models and its checks");
  app.require_subcommand(1);
  app.footer(
      "Example: relievo tessellate --mesh plane:8 --displacement half-donut -o donut.ply\nEvery command has --help with an example.");
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
    return refuse(2, e.what());
  } catch (input_error const& e) {
    return refuse(2, e.what());
  } catch (cosim_error const& e) {
    std::printf("%s: %s\n", e.model, e.what());
    return 1;
  } catch (std::bad_alloc const&) {
    return refuse(2, "out of memory; a smaller map or fewer generations are needed");
  } catch (std::exception const& e) {
    return refuse(3, std::string("internal error: ") + e.what());
  }
  return 0;
}

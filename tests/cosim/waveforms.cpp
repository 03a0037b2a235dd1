// Waveforms of the circuit: the window is the one that was asked for, to the clock; its signals say what the bench saw; the save file names
// signals that are there, links grouped by unit; a window after the run, and a circuit built without waveforms, are refused; a run that
// fails leaves its waveform.
#include <gtest/gtest.h>
#include <gtkwave/fstapi.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <regex>
#include <set>

#include "tb/cosim/gtkwave_save.hpp"
#include "tb/cosim/waveform.hpp"
#include "tb/host/files.hpp"
#include "tb/host/input_error.hpp"
#include "tb/host/scene.hpp"
#include "tests/cosim/engines.hpp"
#include "tests/support/temporary_folder.hpp"

namespace relievo::test {
namespace {

tb::scene small_scene() {
  tb::scene_options o;
  o.mesh = "plane:2";
  o.displacement = "sine:16";
  o.max_generation = 2;
  return tb::make_scene(o);
}

tb::cosim_settings traced(temporary_folder const& folder, std::uint64_t from, std::uint64_t cycles) {
  tb::cosim_settings s;
  s.stall = 30;
  s.trace = folder.file("out.fst");
  s.trace_from = from;
  s.trace_cycles = cycles;
  return s;
}

// The signals of the engine's own scope by name, and their values as text at every time that something changed.
struct recording {
  tb::fst_contents contents;
  std::map<std::uint64_t, std::map<std::string, std::string>> changes;

  explicit recording(std::string const& file) : contents(tb::read_fst(file)) {
    for (tb::fst_signal const& s : contents.signals)
      if (s.scope == "TOP.engine") names_.emplace(s.handle, s.name);
    const std::unique_ptr<void, void (*)(void*)> reader(fstReaderOpen(file.c_str()), fstReaderClose);
    fstReaderSetFacProcessMaskAll(reader.get());
    fstReaderIterBlocks(
        reader.get(),
        [](void* self, std::uint64_t time, fstHandle handle, unsigned char const* value) {
          auto& r = *static_cast<recording*>(self);
          const auto [first, last] = r.names_.equal_range(handle);
          for (auto n = first; n != last; ++n) r.changes[time][n->second] = reinterpret_cast<char const*>(value);
        },
        this, nullptr);
  }
  // How often a rising edge of clk_i found valid and ready at 1, both as they stood before the edge.
  int words_moved(std::string const& valid, std::string const& ready) const {
    std::map<std::string, std::string> now;
    int moved = 0;
    for (auto const& [time, changed] : changes) {
      const auto clock = changed.find("clk_i");
      if (clock != changed.end() && clock->second == "1" && now["clk_i"] == "0") moved += now[valid] == "1" && now[ready] == "1" ? 1 : 0;
      for (auto const& [name, value] : changed) now[name] = value;
    }
    return moved;
  }
  int rising_edges() const {
    int edges = 0;
    for (auto const& [time, changed] : changes) {
      const auto clock = changed.find("clk_i");
      if (clock == changed.end() || clock->second != "1") continue;
      EXPECT_EQ(time % 1000, 0u);
      ++edges;
    }
    return edges;
  }

 private:
  std::multimap<fstHandle, std::string> names_;
};

TEST(waveforms, a_window_begins_and_ends_at_its_clocks) {
  const temporary_folder folder;
  const tb::cosim_settings s = traced(folder, 300, 77);
  run_circuit(small_scene(), s);
  const recording r(s.trace);
  EXPECT_EQ(r.contents.first, 300'000u - 500u);
  EXPECT_EQ(r.contents.last, (300u + 77u - 1u) * 1000u);
  EXPECT_EQ(r.rising_edges(), 77);
  EXPECT_FALSE(std::filesystem::exists(s.trace + ".part"));
}

TEST(waveforms, a_whole_run_shows_every_word_of_its_links) {
  const temporary_folder folder;
  const tb::cosim_settings s = traced(folder, 1, 1'000'000);
  const cosim_run run = run_circuit(small_scene(), s);
  const recording r(s.trace);
  EXPECT_EQ(r.contents.first, 500u);
  for (tb::link_report const& l : run.circuit.links) {
    static const std::map<std::string, std::pair<char const*, char const*>> links = {
        {"base triangles", {"in_valid_i", "in_ready_o"}},
        {"output triangles", {"out_valid_o", "out_ready_i"}},
        {"normal map requests", {"normal_req_valid_o", "normal_req_ready_i"}}};
    const auto found = links.find(l.name);
    if (found == links.end()) continue;
    EXPECT_GT(l.moved, 0u);
    EXPECT_EQ(r.words_moved(found->second.first, found->second.second), static_cast<int>(l.moved)) << l.name;
  }
}

TEST(waveforms, the_save_file_names_what_is_there) {
  const temporary_folder folder;
  const tb::cosim_settings s = traced(folder, 50, 20);
  run_circuit(small_scene(), s);
  std::set<std::string> known, shown, groups;
  for (tb::fst_signal const& signal : tb::read_fst(s.trace).signals) known.insert(signal.full_name());
  std::istringstream save(tb::read_bytes(folder.file("out.gtkw")));
  int depth = 0;
  for (std::string line; std::getline(save, line);) {
    if (line.rfind("TOP.", 0) == 0) {
      EXPECT_EQ(known.count(line), 1u) << line;
      shown.insert(line);
    } else if (line == "@800200" || line == "@c00200") {
      ++depth;
    } else if (line == "@1000200" || line == "@1401200") {
      EXPECT_GE(--depth, 0);
    } else if (line.rfind('-', 0) == 0) {
      groups.insert(line.substr(1));
    } else {
      EXPECT_TRUE(std::regex_match(line, std::regex(R"(@2[28]|\[\w+\] .*)"))) << line;
    }
  }
  EXPECT_EQ(depth, 0);
  for (char const* unit : {"engine", "engine.i_queue", "engine.gen_lane[0].i_lane", "engine.gen_lane[0].i_lane.i_tests.i_sht",
                           "engine.gen_lane[0].i_lane.i_tests.i_pt", "engine.gen_lane[0].i_lane.i_maps.i_normal", "in", "out", "table_req",
                           "table_rsp", "push", "pop"})
    EXPECT_EQ(groups.count(unit), 1u) << unit;
  // Valid, ready and word of every link of the top, the words with their width.
  for (char const* link : {"in_valid_i", "in_ready_o", "out_valid_o", "out_ready_i", "table_req_valid_o[0:0]", "table_rsp_valid_i[0:0]"})
    EXPECT_EQ(shown.count(std::string("TOP.engine.") + link), 1u) << link;
  EXPECT_EQ(std::count_if(shown.begin(), shown.end(), [](std::string const& n) { return n.rfind("TOP.engine.in_i[", 0) == 0; }), 1);
  // Links between the parts of a unit.
  for (char const* name : {"TOP.engine.ready_valid", "TOP.engine.ready_ready", "TOP.engine.collected_valid", "TOP.engine.collected_ready"})
    EXPECT_EQ(shown.count(name), 1u) << name;
}

TEST(waveforms, a_window_after_the_run_is_refused) {
  const temporary_folder folder;
  const tb::cosim_settings s = traced(folder, 10'000'000, 5);
  try {
    run_circuit(small_scene(), s);
    ADD_FAILURE() << "a window of which nothing was seen";
  } catch (tb::input_error const& e) {
    EXPECT_NE(std::string(e.what()).find("--trace-from: 10000000 is after the last clock"), std::string::npos) << e.what();
  }
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(waveforms, a_run_that_fails_leaves_its_waveform) {
  const temporary_folder folder;
  tb::cosim_settings s = traced(folder, 1, 1'000'000);
  s.watchdog = 300;
  s.latency_low = s.latency_high = 2000;
  std::uint64_t clock = 0;
  try {
    run_circuit(small_scene(), s);
    ADD_FAILURE() << "a memory of 2,000 clocks was waited for";
  } catch (tb::cosim_error const& e) {
    const std::string what = e.what();
    clock = std::stoull(what.substr(what.rfind(' ') + 1));
  }
  EXPECT_GT(clock, 300u);
  EXPECT_EQ(recording(s.trace).contents.last, clock * 1000);
}

TEST(waveforms, a_circuit_built_without_them_is_refused) {
  const temporary_folder folder;
  tb::cosim_settings s = traced(folder, 1, 10);
  s.variant = "small";
  EXPECT_THROW(run_circuit(small_scene(), s), tb::input_error);
  EXPECT_EQ(folder.entries(), 0u);
}

}  // namespace
}  // namespace relievo::test

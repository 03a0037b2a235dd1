// reporting: what tessellate and compare put out of a run: meshes, picture, JSON report, and the table on the terminal.
#pragma once
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tb/analysis/error.hpp"
#include "tb/model/model.hpp"

namespace relievo::tb {

// Output options shared by tessellate and compare.
struct output_arguments {
  std::vector<std::string> meshes;
  std::string report, image;
  bool raw = false, wireframe = false, measure = false;
  void add_to(CLI::App& app);
  // Before the work: input_error when an output has no usable name or place, two have the same, or --raw asks for what `model` has not.
  // `more` are the command's own output files.
  void check(std::string const& model, std::vector<std::string> const& more = {}) const;
};

// Of its engine.
nlohmann::json counts_json(run_result const& run);
nlohmann::json to_json(scene const& sc);

// Error of a mesh, and for a planar base of the uniform grid with as many triangles.
struct measured_error {
  error_report mesh;
  std::optional<uniform_grid_report> uniform;
};
measured_error measure(std::vector<golden::triangle_out> const& triangles, scene const& sc);
nlohmann::json to_json(measured_error const& error);

// Meshes and picture; the report is written by the caller when it is complete.
void write_outputs(output_arguments const& out, run_result const& run, scene const& sc);
void write_report(output_arguments const& out, nlohmann::json const& report);

// A line "label  value" of the table.
void print_row(std::string const& label, std::string const& value);
void print_run(run_result const& run, scene const& sc, std::optional<measured_error> const& error);
std::string grouped(std::uint64_t n);  // 12,345

// A progress bar over base triangles.
std::function<void(std::size_t)> progress_hook(std::string const& label, scene const& sc);

}  // namespace relievo::tb

// scene_arguments: the options that describe a scene and its engine, the same for every subcommand that takes a scene.
// The texts are read by make(), so that each mistake is one input_error that names the option.
#pragma once
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tb/host/scene.hpp"

namespace relievo::tb {

class scene_arguments {
 public:
  void add_to(CLI::App& app);
  // --base-triangle, for commands that can run one alone.
  void add_base_triangle(CLI::App& app);
  // input_error when the whole surface is to be measured and one base triangle was asked for.
  void check_measure(bool measure) const;
  // The options as given; errors name the option.
  scene_options options() const;
  // The scene, its warnings printed to stderr.
  scene make() const;

 private:
  scene_options options_;
  std::optional<std::string> sample_range_, texel_size_, address_, eye_, at_, up_, viewport_, tests_, height_mode_, half_vector_, queue_;
  std::optional<double> near_, far_, height_threshold_, profile_threshold_;
  std::optional<int> max_generation_, base_triangle_;
  std::string engine_ = "edge";
  std::vector<CLI::Option const*> edge_options_, sweep_options_;  // those of one engine alone
};

}  // namespace relievo::tb

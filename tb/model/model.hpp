// model: one face for all models of an engine: a scene goes in, output triangles and counters come out.
//
//   ideal   golden formulas, no rounding
//   golden  golden formulas, rounded at the named registers
//   hls     the synthesizable C++, its maps built by its own streaming builders
//   rtl     the circuit, Verilated, in its SystemC bench (tb/cosim), in programs that bring it; its triangles come in an order of their own
//   top     the circuit among its buses, as a host sees it, likewise: registers, map builders, streams (tb/cosim/top_model.hpp)
//
// Every model puts out golden::triangle_out, in engine units; golden and hls hold words exactly, so that equal words are equal doubles.
// barycentric weights and path are filled in by ideal and golden alone, weights by all models of the sweep engine (sweep_model.hpp).
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "golden/edge/counters.hpp"
#include "golden/edge/edge_trace.hpp"
#include "golden/edge/triangle.hpp"
#include "golden/sweep/engine_data.hpp"
#include "tb/host/scene.hpp"

namespace relievo::tb {

// What a sweep counted; additions of vertices in the walks, which golden does not walk.
struct sweep_count {
  golden::sweep_counters counters;
  std::optional<std::uint64_t> additions;
};

struct run_hooks {
  std::function<void(golden::triangle_out const&)> out;   // every output triangle; empty: none is converted or kept
  std::function<void(golden::edge_trace const&)> traced;  // every tested edge (ideal and golden only)
  std::function<void(std::size_t)> progress;              // base triangles begun so far

  // Of the sweep engine: every piece of a base triangle as it begins, every output triangle whole, and the counters at the end.
  std::function<void(golden::swept_piece const&)> piece;
  std::function<void(golden::swept_triangle const&)> swept;
  std::function<void(sweep_count const&)> sweep_counts;
};

class model {
 public:
  virtual ~model() = default;
  virtual golden::counters run(run_hooks const& hooks) = 0;
  // Whether triangles come in golden's order.
  virtual bool in_order() const { return true; }
};

// A model with the scene's maps built and ready to run, any number of times. The scene must outlive it.
// input_error for an unknown name; its line lists the known ones.
std::unique_ptr<model> make_model(std::string const& name, scene const& sc);
std::vector<std::string> model_names();
void check_model_name(std::string const& name);  // the same input_error, without a scene

// Adds a model: a program that brings a circuit says add_rtl_model() or add_top_model() (tb/cosim).
using model_factory = std::function<std::unique_ptr<model>(scene const&)>;
void add_model(std::string const& name, model_factory const& make);
// A model that this build does not have; why is the end of the line that refuses it.
void leave_out_model(std::string const& name, std::string const& why);

// Room in every model's triangle queue: enough for the paper's FIFO mode on a few thousand base triangles without a fallback.
constexpr int queue_depth = 8192;

// What a run of the sweep engine has besides.
struct sweep_result {
  sweep_count count;
  std::vector<golden::swept_piece> pieces;  // what near_clip left of the base triangles
  std::vector<std::uint64_t> piece_of;      // per output triangle
  std::vector<glm::dvec4> colours;          // three per output triangle
};

struct run_result {
  golden::counters counts;
  std::vector<golden::triangle_out> triangles;  // without the empty record
  double seconds = 0.0;                         // of a run that keeps its output
  bool in_order = true;                         // golden's order
  std::optional<sweep_result> sweep;            // of the sweep engine
};
run_result run_model(std::string const& name, scene const& sc, run_hooks hooks = {});

// Edge tests per second of a model on a scene: the best of several runs that convert and keep nothing.
double edge_tests_per_second(model& m);

}  // namespace relievo::tb

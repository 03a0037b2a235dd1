#include "tb/model/model.hpp"

#include <algorithm>
#include <chrono>
#include <map>

#include "golden/core/rounding.hpp"
#include "golden/edge/engine.hpp"
#include "hls/edge/engine.hpp"
#include "tb/host/input_error.hpp"
#include "tb/model/hls_words.hpp"
#include "tb/model/sweep_model.hpp"
#include "tb/model/words.hpp"

namespace relievo::tb {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <class Rounding>
class golden_model : public model {
 public:
  explicit golden_model(scene const& sc) : scene_(sc) {
    if (sc.regs.pass.use_sht) table_ = golden::summed_area_table(sc.map.texels.data(), sc.map.width, sc.map.height);
  }

  golden::counters run(run_hooks const& hooks) override {
    golden::memories memories;
    memories.texels = scene_.map.texels.data();
    memories.table = table_.empty() ? nullptr : table_.data();
    memories.normal_map = scene_.normal_map;
    golden::engine<Rounding> engine(scene_.regs, memories, queue_depth);
    std::size_t begun = 0;
    const auto next = [&](golden::triangle& t) {
      if (begun == scene_.triangles.size()) return false;
      t = scene_.triangles[begun++];
      if (hooks.progress) hooks.progress(begun);
      return true;
    };
    const auto out = [&](golden::triangle_out const& t) {
      if (hooks.out) hooks.out(t);
    };
    if (!hooks.traced) return engine.run(next, out);
    return engine.run(next, out, [&](golden::edge_trace const& trace) { hooks.traced(trace); });
  }

 private:
  scene const& scene_;
  std::vector<std::uint64_t> table_;
};

class hls_model : public model {
 public:
  explicit hls_model(scene const& sc) : engine_(std::make_unique<hls::engine<queue_depth>>()), words_(sc) {}

  golden::counters run(run_hooks const& hooks) override {
    hls::stream<hls::triangle, 2> in("base triangles");
    hls::stream<hls::triangle_out, 2> out("output triangles");
    golden::triangle_out converted;
    std::size_t begun = 0;
    engine_->start();
    while (!engine_->done()) {
      if (engine_->wants_input() && in.empty() && begun < words_.triangles().size()) {
        in.write(words_.triangles()[begun++]);
        if (hooks.progress) hooks.progress(begun);
      }
      engine_->step(in, out, words_.regs(), words_.memories());
      while (!out.empty()) {
        const hls::triangle_out t = out.read();
        if (!hooks.out) continue;
        to_golden(t, converted);
        hooks.out(converted);
      }
    }
    return words_.counters(words_of_counters(engine_->counts()));
  }

 private:
  std::unique_ptr<hls::engine<queue_depth>> engine_;
  hls_words words_;
};

// Lets a run fill in `kept`; `hooks` are those of the run.
void keep_sweep(run_hooks& hooks, sweep_result& kept) {
  hooks.piece = [&kept](golden::swept_piece const& piece) { kept.pieces.push_back(piece); };
  hooks.swept = [&kept](golden::swept_triangle const& t) {
    if (t.empty) return;
    kept.piece_of.push_back(t.piece);
    for (golden::swept_vertex const& v : t.v) kept.colours.push_back(v.colour);
  };
  hooks.sweep_counts = [&kept](sweep_count const& count) { kept.count = count; };
}

// In the order in which they are named to the user.
using named_factories = std::vector<std::pair<std::string, model_factory>>;
named_factories& factories() {
  static named_factories all = {
      {"ideal", [](scene const& sc) -> std::unique_ptr<model> { return std::make_unique<golden_model<golden::exact>>(sc); }},
      {"golden", [](scene const& sc) -> std::unique_ptr<model> { return std::make_unique<golden_model<golden::rounded>>(sc); }},
      {"hls", [](scene const& sc) -> std::unique_ptr<model> { return std::make_unique<hls_model>(sc); }}};
  return all;
}

std::map<std::string, std::string>& left_out() {
  static std::map<std::string, std::string> why;
  return why;
}

}  // namespace

void leave_out_model(std::string const& name, std::string const& why) { left_out()[name] = why; }

void add_model(std::string const& name, model_factory const& make) { factories().emplace_back(name, make); }

std::vector<std::string> model_names() {
  std::vector<std::string> names;
  for (auto const& [name, make] : factories()) names.push_back(name);
  return names;
}

void check_model_name(std::string const& name) {
  std::string known;
  for (std::string const& n : model_names()) {
    if (n == name) return;
    known += (known.empty() ? "" : ", ") + n;
  }
  if (const auto it = left_out().find(name); it != left_out().end()) throw input_error("--model: " + name + " " + it->second);
  throw input_error("--model: '" + name + "' is no model; known are " + known);
}

std::unique_ptr<model> make_model(std::string const& name, scene const& sc) {
  check_model_name(name);
  if (sc.options.engine == engine_kind::sweep) return make_sweep_model(name, sc);
  for (auto const& [known, make] : factories())
    if (known == name) return make(sc);
  return nullptr;
}

run_result run_model(std::string const& name, scene const& sc, run_hooks hooks) {
  run_result result;
  const std::unique_ptr<model> m = make_model(name, sc);
  hooks.out = [&result](golden::triangle_out const& t) {
    if (!t.empty) result.triangles.push_back(t);
  };
  if (sc.options.engine == engine_kind::sweep) keep_sweep(hooks, result.sweep.emplace());
  const auto start = std::chrono::steady_clock::now();
  result.counts = m->run(hooks);
  result.in_order = m->in_order();
  result.seconds = seconds_since(start);
  return result;
}

double edge_tests_per_second(model& m) {
  double best = 0.0;
  double spent = 0.0;
  for (int i = 0; i < 20 && (i < 3 || spent < 0.2); ++i) {
    const auto start = std::chrono::steady_clock::now();
    const golden::counters counts = m.run({});
    const double seconds = seconds_since(start);
    spent += seconds;
    best = std::max(best, static_cast<double>(counts.edge_tests) / seconds);
  }
  return best;
}

}  // namespace relievo::tb

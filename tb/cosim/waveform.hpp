// waveform: a window of clocks of a Verilated model's signals as an FST file, and a save file for GTKWave beside it.
//
//   waveform<Model> wave(settings, model)   nothing happens where settings.trace is empty; input_error where the model was built without
//     tracing (traceable<Model>)
//   wave.before_edge(clock), after_edge(clock)   around every rising edge: the inputs that it takes, and what it makes of them
//   wave.close()                             the run is over or has failed: the file gets its name; later clocks are not written
//   A nanosecond of the file is a clock: rising edge n stands at n ns, the inputs that it takes half a nanosecond before. Clock n is the
//   one that the bench's messages name, counted from the beginning of the first reset. The window is settings.trace_cycles clocks from
//   settings.trace_from on; while the file grows it is called FILE.part.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>

#include "tb/cosim/engine_bench.hpp"
#include "tb/host/input_error.hpp"

class VerilatedFstC;

namespace relievo::tb {

template <class Model, class = void>
struct traceable : std::false_type {};
template <class Model>
struct traceable<Model, std::void_t<decltype(std::declval<Model&>().trace(static_cast<VerilatedFstC*>(nullptr), 0))>> : std::true_type {};

// FILE.gtkw for FILE.fst.
std::string gtkwave_name(std::string const& file);

// A growing FST file; only programs with a traceable model link what is behind it.
class fst_file {
 public:
  fst_file(std::string const& name, std::function<void(VerilatedFstC*)> const& attach);
  ~fst_file();
  fst_file(fst_file const&) = delete;
  fst_file& operator=(fst_file const&) = delete;
  void dump(std::uint64_t picoseconds);
  // Renames it, and writes the save file.
  void close();

 private:
  std::string name_;
  std::unique_ptr<VerilatedFstC> file_;
};

template <class Model>
class waveform {
 public:
  waveform(cosim_settings const& settings, Model& model) : settings_(settings), model_(model) {
    if (!settings.trace.empty() && !traceable<Model>::value)
      throw input_error("--trace: the circuit '" + settings.variant + "' was built without waveforms");
  }
  ~waveform() { close(); }
  waveform(waveform const&) = delete;
  waveform& operator=(waveform const&) = delete;

  void before_edge(std::uint64_t clock) {
    if constexpr (traceable<Model>::value) {
      if (!in_window(clock)) return;
      if (!file_) {
        begun_ = true;
        file_ = std::make_shared<fst_file>(settings_.trace, [this](VerilatedFstC* f) { model_.trace(f, 99); });
      }
      file_->dump(1000 * clock - 500);
    }
  }
  void after_edge(std::uint64_t clock) {
    if constexpr (traceable<Model>::value) {
      if (!file_) return;
      file_->dump(1000 * clock);
      if (!in_window(clock + 1)) close();
    }
  }
  void close() {
    if constexpr (traceable<Model>::value) {
      if (!file_) return;
      closed_ = true;
      file_->close();
      file_.reset();
    }
  }
  // Whether the window has begun, or none was asked for.
  bool begun() const { return begun_ || settings_.trace.empty(); }

 private:
  bool in_window(std::uint64_t clock) const {
    return !settings_.trace.empty() && !closed_ && clock >= settings_.trace_from && clock - settings_.trace_from < settings_.trace_cycles;
  }

  const cosim_settings settings_;  // its own: who made the bench may be gone
  Model& model_;
  std::shared_ptr<fst_file> file_;  // shared: its deleter is only linked where one is made
  bool begun_ = false, closed_ = false;
};

}  // namespace relievo::tb

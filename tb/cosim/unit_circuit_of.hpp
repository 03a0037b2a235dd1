// unit_circuit_of: the circuit of a pure pipeline among the unit_circuits.
//   pipeline_circuit<Model>(unit, latency)   Model: a Verilated module with clk_i, in_i, out_o and, where it has registers, regs_i. A word
//     goes in every clock, its answer is what stands at out_o exactly latency clocks later.
#pragma once
#include <verilated.h>

#include "tb/cosim/coverage.hpp"
#include "tb/cosim/ports_of_lanes.hpp"
#include "tb/cosim/unit_circuits.hpp"

namespace relievo::tb {

namespace detail {
template <class Model>
auto put_regs(Model& model, hls::bits<widest_record> const& regs, int width, int) -> decltype(model.regs_i, void()) {
  put_bits(model.regs_i, 0, regs, width);
}
template <class Model>
void put_regs(Model&, hls::bits<widest_record> const&, int, long) {}
}  // namespace detail

template <class Model>
unit_circuit pipeline_circuit(std::string const& name, int latency) {
  return [name, latency](std::vector<unit_words> const& in, unit_words const& regs) {
    pure_unit const& unit = *find_unit(name);
    VerilatedContext context;
    context.randReset(2);
    // What registers hold before: one seed, then the other.
    static bool other = false;
    context.randSeed((other = !other) ? 1 : 4711);
    Model model(&context);
    keep_coverage kept(context);
    model.clk_i = 0;
    detail::put_regs(model, packed(regs, unit.regs), packed_width(unit.regs), 0);
    model.eval();
    kept.begin();
    const int in_width = packed_width(unit.in), out_width = packed_width(unit.out);
    std::vector<unit_words> out;
    for (std::size_t clock = 1; out.size() < in.size(); ++clock) {
      if (clock <= in.size()) put_bits(model.in_i, 0, packed(in[clock - 1], unit.in), in_width);
      model.clk_i = 1;
      model.eval();
      model.clk_i = 0;
      model.eval();
      if (clock >= static_cast<std::size_t>(latency)) out.push_back(unpacked(get_bits<widest_record>(model.out_o, 0, out_width), unit.out));
    }
    return out;
  };
}

}  // namespace relievo::tb

// gtkwave_save: the signals of an FST file of a circuit, and a save file that shows them in GTKWave grouped by unit.
//
//   read_fst(file)       all signals with their scopes, and the times of the first and the last dump; input_error when it is no FST file
//   gtkwave_save(file)   the text of the save file: clock and reset, then a group for every unit with links (the top open, the units within
//     it closed): valid, ready and word of each link, then the unit's other ports but for the registers. By the house's rule a link X has
//     X_valid_i, X_ready_o and X_i on the unit it goes into, X_valid_o, X_ready_i and X_o on the one it comes from, and X_valid, X_ready
//     and X (or X_data) between the parts of a unit. All names are read from the file, so that each is there.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace relievo::tb {

struct fst_signal {
  std::string scope;  // TOP.engine.i_queue
  std::string name;   // pop_o
  std::string range;  // [638:0], or nothing
  std::uint32_t bits = 1, handle = 0;

  std::string full_name() const { return scope + "." + name + range; }
};
struct fst_contents {
  std::uint64_t first = 0, last = 0;  // picoseconds
  std::vector<fst_signal> signals;
};
fst_contents read_fst(std::string const& file);

std::string gtkwave_save(std::string const& file);

}  // namespace relievo::tb

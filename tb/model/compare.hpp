// compare: two models' outputs, word by word.
//
//   In order for the sequential C++ models; as multisets for one whose queue reorders. The first difference is told with the field, both
//   words in hex and as numbers, the base triangle and the path of splits that led there (from golden).
//   Counters are compared too: none of them depends on time but those of the queue, which are left out where the order is free.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "tb/model/model.hpp"

namespace relievo::tb {

struct comparison {
  std::uint64_t triangles = 0;        // compared
  std::uint64_t words_different = 0;  // words that differ; a triangle that only one side has counts all its words
  std::vector<std::string> counters_different;
  std::string first_difference;  // one line, empty when there is none

  bool equal() const { return words_different == 0 && counters_different.empty(); }
};

comparison compare_runs(std::string const& first_name, run_result const& first, std::string const& second_name, run_result const& second,
                        bool in_order = true);

}  // namespace relievo::tb

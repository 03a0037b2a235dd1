// compare: two models' outputs, word by word.
//
//   In order for the sequential C++ models; as multisets for one whose queue reorders: what only one side has is then put beside what only
//   the other has of the same base triangle, the likest two first. The first difference is told with the unit whose register the word is,
//   the field, both words in hex and as numbers, the base triangle and the path of splits that led there (golden knows it: path_in).
//   Of several words that differ the one furthest up the data path is told: what follows from it differs too.
//   Of the sweep engine the colours are compared too; a difference of theirs is told beside the counters'.
//   Counters are compared too: none of them depends on time but those of the queue, which are left out where the order is free.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tb/model/model.hpp"
#include "tb/model/words.hpp"

namespace relievo::tb {

// One triangle that differs.
struct found_difference {
  std::array<std::string, 2> names;  // of the runs
  std::string unit;                  // whose register differs; pass_or_tessellate or sweep_line where a run split otherwise
  std::optional<field> at;           // none: only one of the runs has the triangle
  std::int64_t words[2] = {0, 0};    // of that field
  std::size_t words_different = 0;   // in this triangle
  std::size_t place = 0;             // of the triangle in its run
  std::size_t side = 0;              // whose triangle it is: that of the first run unless only the second has it
  std::uint64_t path = 1;            // golden's name of it; 1 for a base triangle, or where no one knows (path_in)
  bool has_path = true;              // of the edge engine
  golden::triangle_out triangle;
};

// name 0x12ab (0.125)
std::string word_text(std::string const& name, std::int64_t word, field const& f);
// All of it in one line.
std::string to_text(found_difference const& d);
// 1 followed by two bits per generation: the place of each ancestor in tessellate's output; "base" where nothing was split.
std::string path_text(std::uint64_t path);
// The path of the triangle with the texture coordinates of `t` in a run of golden; none when it has no such triangle.
std::optional<std::uint64_t> path_in(run_result const& golden, golden::triangle_out const& t);

struct comparison {
  std::uint64_t triangles = 0;            // compared
  std::uint64_t triangles_different = 0;  // of these
  std::uint64_t words_different = 0;      // words that differ; a triangle that only one side has counts all its words
  std::vector<std::string> counters_different;
  std::optional<found_difference> first;
  std::string first_difference;  // one line, empty when there is none

  bool equal() const { return words_different == 0 && counters_different.empty(); }
};

comparison compare_runs(std::string const& first_name, run_result const& first, std::string const& second_name, run_result const& second,
                        bool in_order = true);

}  // namespace relievo::tb

// names: "name:A,B" as meshes and maps of our own making are called.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace relievo::tb {

// The numbers behind `name` in `spec` ("plane:8" gives {8}, "plane" gives {}), or nothing when spec has another name.
// input_error when what follows the colon isn't whole numbers, 1..100000, separated by commas, at most `most` of them.
std::optional<std::vector<int>> numbers_of(std::string const& spec, std::string const& name, std::size_t most);

}  // namespace relievo::tb

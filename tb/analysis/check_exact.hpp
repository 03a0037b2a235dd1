// check_exact: the check of a model's output by its exact barycentric weights (integers, times 2^60).
#pragma once
#include <vector>

#include "tb/analysis/check.hpp"

namespace relievo::tb {

// Whether the output carries weights at all.
bool has_weights(std::vector<golden::triangle_out> const& out);

void check_exact(std::vector<golden::triangle_out> const& out, std::vector<golden::triangle> const& base, golden::map_regs const& map,
                 check_options const& options, check_report& report);

}  // namespace relievo::tb

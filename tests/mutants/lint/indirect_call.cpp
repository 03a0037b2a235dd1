// rejected: indirect call
// The tests of an edge in a table of functions.
#include <cstdint>

namespace {
bool above(std::int32_t measure, std::int32_t threshold) { return measure > threshold; }
bool below(std::int32_t measure, std::int32_t threshold) { return measure < threshold; }
bool (*const tests[2])(std::int32_t, std::int32_t) = {above, below};
}  // namespace

bool edge_test_indirect(std::uint32_t which, std::int32_t measure, std::int32_t threshold) { return tests[which & 1](measure, threshold); }

// rejected: unresolved external
// A root from somebody else's library.
#include <cstdint>

extern "C" std::int64_t integer_square_root(std::int64_t square);

std::int64_t normalize_external(std::int64_t square) { return integer_square_root(square); }

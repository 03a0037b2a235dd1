// rejected: include
// The command line leans on the tests' helpers.
#include "tests/support/vectors.hpp"

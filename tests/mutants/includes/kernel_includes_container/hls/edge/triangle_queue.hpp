// rejected: include
// A kernel with a container of the standard library.
#pragma once
#include <deque>

// rejected: layer
// The lowest layer asks the one above it.
#pragma once
#include "hls/surface/vertex.hpp"

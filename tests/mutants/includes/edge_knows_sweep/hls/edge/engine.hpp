// rejected: layer
// One engine knows another.
#pragma once
#include "hls/sweep/engine.hpp"

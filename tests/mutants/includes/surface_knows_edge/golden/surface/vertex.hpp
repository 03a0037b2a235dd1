// rejected: layer
// A shared unit that knows one engine.
#pragma once
#include "golden/edge/triangle.hpp"

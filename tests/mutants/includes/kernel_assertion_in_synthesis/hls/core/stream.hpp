// rejected: include
// The branches are exchanged: the assertion's header is read by the tools and not by the simulation.
#pragma once
#ifndef RELIEVO_SYNTHESIS
#include <cstdint>
#else
#include <cassert>
#endif

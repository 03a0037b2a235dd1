// additions_only: marks a function whose whole work, that of everything it calls included, is additions and comparisons.
//
//   void step() {
//     RELIEVO_ADDITIONS_ONLY("the inner loop");
//
//   scripts/lint.sh synthesizable compiles with RELIEVO_LINT, where the marker is a call, and refuses a multiplication, a division or a
//   remainder in a marked function and below it; everywhere else it is nothing.
#pragma once

#ifdef RELIEVO_LINT
extern "C" void relievo_additions_only(char const* what);
#define RELIEVO_ADDITIONS_ONLY(what) relievo_additions_only(what)
#else
#define RELIEVO_ADDITIONS_ONLY(what) static_assert(sizeof(what) > 1, "say what it is")
#endif

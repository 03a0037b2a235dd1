// streaming_loop: marks the loops that run as long as their input does, which no static bound can describe.
//
//   for (;;) {
//     RELIEVO_STREAMING_LOOP("one turn per triangle; ends after the record that says last");
//
//   Every other loop of a kernel has a bound that a compiler can prove. scripts/lint.sh compiles with RELIEVO_LINT, where the
//   marker is a call that it finds again inside the loop; everywhere else it is nothing.
#pragma once

#ifdef RELIEVO_LINT
extern "C" void relievo_streaming_loop(char const* reason);
#define RELIEVO_STREAMING_LOOP(reason) relievo_streaming_loop(reason)
#else
#define RELIEVO_STREAMING_LOOP(reason) static_assert(sizeof(reason) > 1, "say why this loop needs no bound")
#endif

// edge_engine_stories: errors of the edge engine, each told on a bench that has run, and that runs a good scene afterwards.
//   session          of the top that the tests of tests/top/edge_engine_rtl*.cpp are compiled for: one lane, or RELIEVO_TOP_LANES of them
//   built_with       what that top was built with
//   tell(story)      story(session, good scene), with and without traffic
//   refused(spoil, code, part)   a start with spoilt registers, whose packet comes or does not; part of the driver's line
#pragma once
#ifndef RELIEVO_TOP_LANES
#define RELIEVO_TOP_LANES 1
#endif
#if RELIEVO_TOP_LANES == 1
#include "Vedge_engine.h"
#else
#include "Vedge_engine_lanes.h"
#endif
#include "tests/support/edge_engine_session.hpp"

namespace relievo::test {

// The parameters of the models, as rtl/CMakeLists.txt and tests/rtl.cmake name them.
#if RELIEVO_TOP_LANES == 1
constexpr tb::edge_engine_build built_with = {1, 3, 1, 1024, 12};
using top = Vedge_engine;
#else
constexpr tb::edge_engine_build built_with = {3, 4, 4, 128, 6};
using top = Vedge_engine_lanes;
#endif
using memories = tb::map_ports<top, int(built_with.lanes), int(built_with.sat_reads_per_clock), int(built_with.profile_samples_per_clock)>;
using session = edge_engine_session<top, memories>;
using code = tb::edge_engine_code;

template <class Story>
void tell(Story story) {
  for (traffic const& t : {traffic{0, 0, 1, 1}, traffic{6, 4, 1, 20}}) {
    session it(t);
    generator g("errors");
    it.run(good_scene(g), true);
    const engine_scene s = good_scene(g);
    story(it, s);
    if (testing::Test::HasFatalFailure()) FAIL() << "seed " << seed();
    it.run(good_scene(g), true);
    if (testing::Test::HasFatalFailure()) FAIL() << "the good scene afterwards, seed " << seed();
  }
}

// A start that is refused, and its packet, which comes or does not.
template <class Spoil>
void refused(Spoil spoil, code wrong, std::string const& part) {
  for (const bool comes : {true, false})
    for (const bool counted : {true, false})
      tell([&](session& it, engine_scene s) {
        spoil(s.regs);
        it.begin(s, counted ? static_cast<std::uint32_t>(s.base.size()) : 0);
        // At once, without a packet: it would be waited for for ever.
        const tb::edge_engine_state state = it.bench.driver.wait(1);
        ASSERT_TRUE(state.busy && state.error && !state.done);
        ASSERT_EQ(state.code, wrong);
        it.expect_line(wrong, part);
        // Who waits for its end all the same is told why there is none.
        try {
          it.bench.driver.drain(10);
          FAIL() << "nothing was swallowed, and the engine is not busy";
        } catch (tb::edge_engine_error const& e) {
          ASSERT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
        }
        if (comes)
          it.send(s);
        else
          it.bench.driver.stop();
        it.expect_mesh(first_of(s, 0), wrong);
        ASSERT_TRUE(it.bench.idle());
      });
}

}  // namespace relievo::test

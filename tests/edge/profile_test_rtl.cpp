// profile_test: the circuit equals the kernel with 1, 4 and 16 samples a clock, on every kind of map under all traffic, where gains and
// thresholds tie too; edges take ceil(samples / samples a clock) clocks, also when the memory answers after 60.
// verilate: Vprofile_test_1 SamplesPerClock=1
// verilate: Vprofile_test_4 SamplesPerClock=4
// verilate: Vprofile_test_16 SamplesPerClock=16
// verilate: Vprofile_test_few SamplesPerClock=4 InFlight=8
#include "Vprofile_test_1.h"
#include "Vprofile_test_16.h"
#include "Vprofile_test_4.h"
#include "Vprofile_test_few.h"
#include "hls/edge/profile_test.hpp"
#include "tests/support/map_cases.hpp"
#include "tests/support/map_memories.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/stream_unit.hpp"

namespace relievo::test {
namespace {

using vector = map_stimulus<hls::profile_test_in, hls::profile_test_regs>;

// Samples that an edge takes.
std::uint64_t samples_of(vector const& v) {
  const int levels = hls::detail::profile_levels(v.in.u1, v.in.u2);
  return levels == 0 ? 0 : (std::uint64_t(1) << levels) + 1;
}

void edge_within(vector& v, hls::map_regs const& map, generator& g) {
  v.map = map;
  coordinates_within(v.in.u1, map, g);
  if (!g.chance(4))
    for (int i = 0; i < 2; ++i) near(v.in.u2[i], v.in.u1[i], std::int64_t(1) << g.between(10, 15), g);
  coordinates_within(v.in.u2, map, g);
}

template <class Model, int S>
class unit {
 public:
  template <class Shape>
  static std::uint64_t clocks_of(traffic const& t, test_map const& map, Shape shape, std::uint64_t count) {
    const auto expected = [&](vector const& v) { return hls::profile_test(v.in, v.map, v.regs, map.texels()); };
    return stream_test<Model, vector>(t, shape, expected, {port(map)}, count);
  }

  static void on_all_maps() {
    const auto list = all_traffic();
    for_maps([&](test_map const& map, hls::map_regs const& regs) {
      for (traffic const& t : list)
        clocks_of(
            t, map, [&](vector& v, generator& g) { edge_within(v, regs, g); }, rtl_vector_count() / (4 * map_case_count * list.size()) + 1);
    });
  }

  // On a checker of 0 and 65535, edges from and to halves of texels: many samples leave the chord by the same amount, and by the
  // threshold exactly.
  static void ties() {
    generator g("ties");
    const test_map map(16, 16, fill::checker, g);
    const std::int64_t peak = 65535 * 16;
    for (const std::int64_t threshold : {peak, peak - 1, peak / 2, peak / 2 - 1, peak * 3 / 8, std::int64_t(0)}) {
      const auto shape = [&](vector& v, generator& words) {
        v.map = map.regs(true, true);
        v.regs.threshold = hls::from_raw<formats::profile_threshold>(threshold);
        const auto place = [&] { return hls::from_raw<formats::coordinate>(words.between(0, 32) * 1024); };
        for (int i = 0; i < 2; ++i) {
          v.in.u1[i] = place();
          v.in.u2[i] = words.chance(4) ? v.in.u1[i] : place();
        }
      };
      clocks_of({0, 2, 1, 20}, map, shape, rtl_vector_count() / 50);
    }
  }

  static void rate() {
    generator g("rate");
    const test_map map(100, 61, fill::random, g);
    const std::uint64_t count = 3000;
    for (const std::int64_t latency : {1, 60}) {
      std::uint64_t drawn = 0, groups = 0, samples = 0;
      quads_asked = 0;
      const auto shape = [&](vector& v, generator& words) {
        edge_within(v, map.regs(true, false), words);
        // The first shape is that of the registers. The last edge reads, so that it does not catch up with those before it.
        if (drawn++ == count) {
          v.in.u1[0] = hls::from_raw<formats::coordinate>(0);
          v.in.u2[0] = hls::from_raw<formats::coordinate>(20 * 2048);
        }
        if (drawn == 1) return;
        samples += samples_of(v);
        groups += std::max<std::uint64_t>((samples_of(v) + S - 1) / S, 1);
      };
      const std::uint64_t clocks = clocks_of({0, 0, latency, latency}, map, shape, count);
      std::uint64_t tree = 0;
      while ((1 << tree) < S) ++tree;
      EXPECT_EQ(drawn, count + 1);
      EXPECT_EQ(quads_asked, samples);
      EXPECT_EQ(clocks, groups + 38 + tree + static_cast<std::uint64_t>(latency)) << "memory latency " << latency;
    }
  }

 private:
  using request = group<quad_request, S>;
  using answer = group<texel_quad, S>;
  inline static std::uint64_t quads_asked = 0;

  // A group is answered together; what is not wanted may lie outside the map and is answered with any word.
  static memory_port<Model> port(test_map const& map) {
    const auto answers = texel_answers(map);
    return {[](Model const& m) { return m.quad_req_valid_o && m.quad_req_ready_i; },
            [](Model& m, bool ready) { m.quad_req_ready_i = ready; },
            [answers](Model const& m) -> std::function<void(Model&)> {
              const auto asked = tb::get<request>(m.quad_req_o);
              answer together{};
              for (int i = 0; i < S; ++i) {
                const bool wanted = (m.quad_req_mask_o >> i) % 2 != 0;
                together.at[i] = wanted ? answers(asked.at[i]) : any_answer();
                quads_asked += wanted ? 1 : 0;
              }
              return [together](Model& to) { tb::put(to.quad_rsp_i, together); };
            },
            [](Model& m, bool valid) { m.quad_rsp_valid_i = valid; },
            [](Model& m, generator& g) {
              answer any{};
              draw_vector(any, draw::uniform, g);
              tb::put(m.quad_rsp_i, any);
            },
            [](Model const& m) { return m.quad_req_valid_o != 0; }};
  }
  static texel_quad any_answer() {
    texel_quad any{};
    for (auto& row : any.q)
      for (auto& texel : row) texel = hls::from_raw<formats::texel>(0xbeef);
    return any;
  }
};

using one = unit<Vprofile_test_1, 1>;
using four = unit<Vprofile_test_4, 4>;
using sixteen = unit<Vprofile_test_16, 16>;
using few = unit<Vprofile_test_few, 4>;

TEST(profile_test, rtl_equals_hls_a_sample_a_clock) { one::on_all_maps(); }
TEST(profile_test, rtl_equals_hls_four_samples_a_clock) { four::on_all_maps(); }
TEST(profile_test, rtl_equals_hls_sixteen_samples_a_clock) { sixteen::on_all_maps(); }

// Places run out all the time.
TEST(profile_test, rtl_equals_hls_with_few_places) { few::on_all_maps(); }

TEST(profile_test, ties_and_thresholds_met_exactly) {
  one::ties();
  four::ties();
  sixteen::ties();
}

TEST(profile_test, an_edge_takes_its_samples_clocks) { one::rate(); }
TEST(profile_test, an_edge_takes_a_quarter_of_its_samples_clocks) { four::rate(); }
TEST(profile_test, an_edge_takes_a_sixteenth_of_its_samples_clocks) { sixteen::rate(); }

}  // namespace
}  // namespace relievo::test

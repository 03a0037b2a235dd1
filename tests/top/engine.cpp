// engine: the entry point gives the triangles and the counters of the engine, word by word, mesh after mesh.
#include <memory>
#include <vector>

#include "tests/support/golden_scene.hpp"
#include "tests/support/maps.hpp"
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

struct source {
  std::vector<hls::triangle> const& triangles;
  std::size_t next = 0;
  hls::triangle read() { return triangles[next++]; }
};
struct sink {
  std::vector<hls::triangle_out> triangles;
  void write(hls::triangle_out const& t) { triangles.push_back(t); }
};

struct case_of_engine {
  hls::engine_regs regs{};
  std::vector<hls::triangle> base;
};

// A rough plane of six quads, every test on; four generations are at most 3,072 triangles, which the port holds at once.
case_of_engine rough_plane(bool wrap, bool fifo, bool cull, double profile_threshold) {
  golden_scene scene(61, 47, wrap, [](int x, int y) { return 30000 + 20000 * std::sin(0.4 * x) * std::cos(0.3 * y); });
  scene.plane(3, 2);
  scene.regs.pass = {true, true, true, true, true, true, 4, cull};
  scene.regs.normal.threshold = golden::rounded::at<formats::normal_threshold>(0.2);
  scene.regs.summed_height = {false, 100000, 800};
  scene.regs.profile.threshold = profile_threshold;
  scene.regs.view.threshold = 3;
  scene.regs.queue.fifo = fifo;
  case_of_engine made;
  EXPECT_TRUE(tb::to_hls(scene.regs, made.regs));
  for (golden::triangle const& t : scene.base) {
    hls::triangle word{};
    EXPECT_TRUE(tb::to_hls(t, word));
    word.last = made.base.size() + 1 == scene.base.size();
    made.base.push_back(word);
  }
  return made;
}

hls::top::base_triangle on_the_port(hls::triangle const& t) {
  hls::top::base_triangle base{};
  for (int i = 0; i < 3; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      base.v[i].p[axis] = t.v[i].p[axis];
      base.v[i].n[axis] = t.v[i].n[axis];
      base.v[i].t[axis] = t.v[i].t[axis];
    }
    for (int axis = 0; axis < 2; ++axis) base.v[i].u[axis] = t.v[i].u[axis];
  }
  base.index = t.index;
  base.last = t.last;
  return base;
}

TEST(top_engine, equals_the_engine_mesh_after_mesh) {
  generator g("map");
  const test_map map(61, 47, fill::random, g);
  const auto in = std::make_unique<hls::port<hls::top::base_triangle>>("in");
  const auto out = std::make_unique<hls::port<hls::triangle_out>>("out");
  for (int number = 0; number < 16; ++number) {
    const case_of_engine c = rough_plane(number % 2 != 0, number / 2 % 2 != 0, number / 4 % 2 != 0, number < 8 ? 400 : 65535);
    const auto unit = std::make_unique<hls::engine<hls::top::queue_depth>>();
    source base{c.base};
    sink expected;
    unit->start();
    while (!unit->done()) unit->step(base, expected, c.regs, {map.texels(), map.table(), map.normals()});

    for (hls::triangle const& t : c.base) in->write(hls::pack(on_the_port(t)));
    std::vector<std::uint64_t> counts(hls::top::counter_words + 1, 0xdead);
    relievo_engine(*in, hls::pack(c.regs), map.texels().words, map.table().words, map.normals().words, *out, counts.data());
    ASSERT_TRUE(in->empty());
    ASSERT_EQ(static_cast<std::size_t>(out->size()), expected.triangles.size());
    for (hls::triangle_out const& t : expected.triangles) ASSERT_TRUE(same_words(hls::unpack<hls::triangle_out>(out->read()), t));

    std::vector<std::uint64_t> expected_counts;
    unit->counts().each_field([&](char const*, auto const& count) {
      if constexpr (std::is_array_v<std::remove_reference_t<decltype(count)>>)
        expected_counts.insert(expected_counts.end(), std::begin(count), std::end(count));
      else
        expected_counts.push_back(count);
    });
    ASSERT_EQ(expected_counts.size(), static_cast<std::size_t>(hls::top::counter_words));
    expected_counts.push_back(0xdead);
    EXPECT_EQ(counts, expected_counts) << "and nothing beyond the last counter";
    EXPECT_GT(unit->counts().splits[3], 0u) << "a case that tests something";
  }
}

}  // namespace
}  // namespace relievo::test

// Units: samplers, lookups, builders and every edge test, on a map of 512 x 512 texels and edges of a few texels.
#include <memory>

#include "golden/surface/summed_area_table.hpp"
#include "hls/edge/engine.hpp"
#include "hls/surface/normal_map.hpp"
#include "hls/surface/summed_area_table.hpp"
#include "tests/bench/vectors.hpp"

namespace relievo::bench {
namespace {

constexpr int size = 512;
const hls::map_regs map = {hls::from_raw<formats::map_size>(size), hls::from_raw<formats::map_size>(size), false, false};

struct memories {
  std::vector<std::uint16_t> texels;
  std::vector<std::uint64_t> table, normals;
};
memories const& maps() {
  static const memories m = [] {
    memories made;
    std::mt19937_64 g(2);
    for (int i = 0; i < size * size; ++i) {
      made.texels.push_back(static_cast<std::uint16_t>(g() & 0xffff));
      made.normals.push_back(g() & 0xffffffffffffu);
    }
    made.table = golden::summed_area_table(made.texels.data(), size, size);
    return made;
  }();
  return m;
}

struct edge {
  hls::fixed<formats::coordinate> u1[2], u2[2], u12[2];
};
std::vector<edge> edges() {
  std::mt19937_64 g(3);
  const auto between = [&](std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(g() % static_cast<std::uint64_t>(high - low + 1));
  };
  std::vector<edge> list(batch);
  for (edge& e : list)
    for (int i = 0; i < 2; ++i) {
      const std::int64_t a = between(20 * 2048, 490 * 2048), b = a + between(-16 * 2048, 16 * 2048);
      e.u1[i] = hls::from_raw<formats::coordinate>(a);
      e.u2[i] = hls::from_raw<formats::coordinate>(b);
      e.u12[i] = hls::from_raw<formats::coordinate>((a + b + 1) >> 1);
    }
  return list;
}

void map_sampler(benchmark::State& state) {
  run(state, edges(), [](edge const& e) { return hls::map_sampler({{e.u1[0], e.u1[1]}}, map, {maps().texels.data()}); });
}
BENCHMARK(map_sampler);

void normal_sampler(benchmark::State& state) {
  run(state, edges(), [](edge const& e) { return hls::normal_sampler({{e.u1[0], e.u1[1]}}, map, {maps().normals.data()}); });
}
BENCHMARK(normal_sampler);

void bump(benchmark::State& state) {
  run(state, draw<hls::bump_in>(1), [](hls::bump_in const& in) { return hls::bump(in); });
}
BENCHMARK(bump);

void transform(benchmark::State& state) {
  hls::transform_regs regs = draw<hls::transform_regs>(4)[0];
  regs.offset_w = hls::from_raw<formats::offset_w>(std::int64_t(20) << formats::offset_w::fraction);
  regs.w_min = hls::from_raw<formats::depth>(1 << 12);
  run(state, draw<hls::transform_in>(), [&](hls::transform_in const& in) { return hls::transform(in, regs); });
}
BENCHMARK(transform);

void summed_height_test(benchmark::State& state) {
  const hls::summed_height_test_regs regs = {false, hls::from_raw<formats::sum_threshold>(100000), {}};
  run(state, edges(), [&](edge const& e) {
    return hls::summed_height_test({{e.u1[0], e.u1[1]}, {e.u2[0], e.u2[1]}, {e.u12[0], e.u12[1]}}, map, regs, {maps().table.data()});
  });
}
BENCHMARK(summed_height_test);

void profile_test(benchmark::State& state) {
  const hls::profile_test_regs regs = {hls::from_raw<formats::profile_threshold>(100000)};
  run(state, edges(), [&](edge const& e) {
    return hls::profile_test({{e.u1[0], e.u1[1]}, {e.u2[0], e.u2[1]}, true}, map, regs, {maps().texels.data()});
  });
}
BENCHMARK(profile_test);

void tex_coord_test(benchmark::State& state) {
  run(state, edges(), [](edge const& e) { return hls::tex_coord_test({{e.u1[0], e.u1[1]}, {e.u2[0], e.u2[1]}, {e.u12[0], e.u12[1]}}); });
}
BENCHMARK(tex_coord_test);

void normal_test(benchmark::State& state) {
  const hls::normal_test_regs regs = {hls::from_raw<formats::normal_threshold>(30000)};
  run(state, draw<hls::normal_test_in>(1), [&](hls::normal_test_in const& in) { return hls::normal_test(in, regs); });
}
BENCHMARK(normal_test);

void highlight_test(benchmark::State& state) {
  const auto regs = draw<hls::highlight_test_regs>(1)[0];
  run(state, draw<hls::highlight_test_in>(1), [&](hls::highlight_test_in const& in) { return hls::highlight_test(in, regs); });
}
BENCHMARK(highlight_test);

void view_test(benchmark::State& state) {
  const hls::view_test_regs regs = {hls::from_raw<formats::view_threshold>(1 << 20)};
  run(state, draw<hls::view_test_in>(1), [&](hls::view_test_in const& in) { return hls::view_test(in, regs); });
}
BENCHMARK(view_test);

void summed_area_table(benchmark::State& state) {
  const auto builder = std::make_unique<hls::summed_area_table<size>>();
  for (auto _ : state)
    for (const std::uint16_t texel : maps().texels) benchmark::DoNotOptimize(builder->step(hls::from_raw<formats::texel>(texel), map));
  state.SetItemsProcessed(state.iterations() * size * size);
}
BENCHMARK(summed_area_table);

void normal_map(benchmark::State& state) {
  const auto builder = std::make_unique<hls::normal_map<size>>();
  const hls::normal_map_regs regs = {hls::from_raw<formats::gradient>(40), hls::from_raw<formats::gradient>(50), {}};
  hls::normal_map_out out{};
  for (auto _ : state) {
    for (const std::uint16_t texel : maps().texels) {
      benchmark::DoNotOptimize(builder->step(hls::from_raw<formats::texel>(texel), map, regs, out));
      benchmark::DoNotOptimize(out);
    }
    for (int i = 0; i < hls::normal_map<size>::flush_rows(map) * size; ++i) builder->step({}, map, regs, out);
  }
  state.SetItemsProcessed(state.iterations() * size * size);
}
BENCHMARK(normal_map);

}  // namespace
}  // namespace relievo::bench

// sweep_scene: small scenes for the sweep engine, and the two models run on them.
//
//   sweep_scene      registers, map (texels, normals of the map itself), z table and base triangles
//   random_sweep(g)  a camera of world_words, a coarse grid of any shape, displacement from none to beyond all positions; triangles from a
//                    few LSB to beyond the view volume, some in pairs at an edge, some with corners that are one; coordinates at both
//                    ends of the map often, so that edges lie along its seam
//   run_hls(e, s)    start() and a whole mesh through an engine; its streams must be empty at the end
//   run_golden(s)    the same through golden
//   equal_runs(a, b) every output word in order, then every counter by name
#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "golden/sweep/engine.hpp"
#include "hls/surface/normal_map.hpp"
#include "hls/sweep/engine.hpp"
#include "hls/sweep/z_table.hpp"
#include "tests/support/map_cases.hpp"
#include "tests/support/world_words.hpp"

namespace relievo::test {

struct sweep_scene {
  test_map map;
  view_camera camera;
  hls::sweep_regs regs{};
  hls::normal_map_regs normal_regs{};
  std::vector<std::uint64_t> normals{};
  std::vector<std::int64_t> z{};
  std::vector<hls::base_triangle> base{};
  int largest = 1;  // a triangle's size, a power of two

  explicit sweep_scene(test_map m) : map(std::move(m)) {}

  // The memories that the registers ask for.
  void build_memories() {
    const auto golden_map = as_golden<golden::map_regs>(regs.map);
    const auto golden_normals = as_golden<golden::normal_map_regs>(normal_regs);
    for (int y = 0; y < map.height(); ++y)
      for (int x = 0; x < map.width(); ++x) {
        const glm::dvec3 n = golden::normal_map<golden::rounded>({x, y}, golden_map, golden_normals, map.golden_texels()).n;
        hls::fixed<formats::unit> words[3];
        for (int i = 0; i < 3; ++i) words[i] = hls::from_raw<formats::unit>(static_cast<std::int64_t>(n[i] * 16384));
        normals.push_back(hls::pack_normal(words));
      }
    for (int i = 0; i < hls::z_table_words; ++i) z.push_back(raw(hls::z_table({regs.kappa, hls::from_raw<format<9, 9, false>>(i)}).z));
    regs.grid.octave = hls::from_raw<formats::depth_cells>(z.back());
    regs.grid.near_cells = hls::depth_cells_of(regs.near, regs.grid.octave, {z.data()});
  }
  hls::sweep_memories memories() const { return {map.texels(), {normals.data()}, {z.data()}}; }

  void add(hls::base_vertex const& a, hls::base_vertex const& b, hls::base_vertex const& c) {
    hls::base_triangle t{};
    t.v[0] = a;
    t.v[1] = b;
    t.v[2] = c;
    t.index = hls::from_raw<formats::index>(static_cast<std::int64_t>(base.size()));
    if (!base.empty()) base.back().last = false;
    t.last = true;
    base.push_back(t);
  }
};

inline void draw_sweep_regs(sweep_scene& s, generator& g) {
  hls::sweep_regs& r = s.regs;
  draw_vector(r, draw::magnitude, g);
  r.map = s.map.regs(g.chance(2), g.chance(2));
  r.limit[0] = hls::from_raw<formats::coordinate>(coordinate_limit(r.map.width, r.map.wrap_u));
  r.limit[1] = hls::from_raw<formats::coordinate>(coordinate_limit(r.map.height, r.map.wrap_v));
  draw_vector(s.normal_regs, draw::magnitude, g);
  s.normal_regs.normal_shift = hls::from_raw<formats::shift>(g.between(0, 5));
  const int calmer = g.chance(4) ? 0 : static_cast<int>(g.between(8, 20));
  r.displace.scale = hls::from_raw<formats::scale>(raw(r.displace.scale) >> calmer);
  r.displace.bias = hls::from_raw<formats::height>(raw(r.displace.bias) >> calmer);

  s.camera = draw_camera(g);
  r.transform = s.camera.regs;
  r.near = s.camera.near;
  r.far = s.camera.far;
  r.guard = !g.chance(8);
  r.viewport[0] = nearest<formats::screen>(s.camera.width);
  r.viewport[1] = nearest<formats::screen>(s.camera.height);
  if (raw(r.d_scale) < 0) r.d_scale = hls::from_raw<formats::matrix_w>(1);
  // 16 to 64 cells across the guard band, or up to 256, with smaller triangles; as many again in z.
  const bool fine = g.chance(2);
  s.largest = fine ? -2 : 1;
  r.grid.cells_per_pixel = hls::from_raw<formats::cells>(fine ? g.between(1 << 15, 1 << 17) : g.between(1 << 13, 1 << 15));
  r.kappa = hls::from_raw<formats::kappa>(g.between(1, 20 << formats::kappa::fraction));
}

inline hls::base_vertex draw_sweep_corner(sweep_scene const& s, generator& g, place const& around, long double size) {
  hls::base_vertex v = draw_corner(g, around, size);
  coordinates_within(v.u, s.regs.map, g);
  if (g.chance(4)) v.u[g.below(2)] = s.regs.limit[0];
  coordinates_within(v.u, s.regs.map, g);
  if (g.chance(16))
    for (int i = 0; i < 3; ++i) v.n[i] = v.t[i] = hls::from_raw<formats::unit>(0);
  return v;
}

inline sweep_scene random_sweep(generator& g) {
  constexpr map_size sizes[] = {{1, 1}, {2, 2}, {1, 9}, {7, 3}, {16, 16}, {23, 40}};
  const map_size size = sizes[g.below(6)];
  sweep_scene s(test_map(size.width, size.height, g.chance(2) ? fill::random : all_fills[g.below(7)], g));
  draw_sweep_regs(s, g);
  s.build_memories();
  if (g.chance(16))
    s.regs.grid.near_cells = hls::from_raw<formats::depth_cells>(g.chance(2) ? -(std::int64_t(1) << 32) : std::int64_t(1) << 32);
  for (std::int64_t left = g.between(1, 4); left > 0; --left) {
    const long double near = value(s.regs.near), far = value(s.regs.far);
    const long double w = near + (std::min(far, 16 * near) - near) * static_cast<long double>(g.between(0, 16)) / 16;
    const place around = s.camera.at(s.camera.width * static_cast<long double>(g.between(0, 8)) / 8,
                                     s.camera.height * static_cast<long double>(g.between(0, 8)) / 8, w);
    const long double extent = g.chance(8) ? 8 : std::ldexp(1.0L, static_cast<int>(g.between(-20, s.largest)));
    hls::base_vertex v[4];
    for (auto& corner : v) corner = draw_sweep_corner(s, g, around, extent);
    if (g.chance(6)) v[1] = v[0];
    s.add(v[0], v[1], v[2]);
    if (g.chance(2)) s.add(v[2], v[1], v[3]);
  }
  return s;
}

struct hls_sweep_run {
  std::vector<hls::swept_triangle> triangles;
  hls::sweep_counters counts;
  std::uint64_t additions = 0;
};
struct golden_sweep_run {
  std::vector<golden::swept_triangle> triangles;
  golden::sweep_counters counts;
};

inline hls_sweep_run run_hls(hls::sweep_engine& engine, sweep_scene const& s) {
  hls_sweep_run run;
  hls::stream<hls::base_triangle, 1> in("engine.in");
  hls::stream<hls::swept_triangle, 2> out("engine.out");
  std::size_t next = 0;
  engine.start();
  while (!engine.done()) {
    if (engine.wants_input()) {
      if (next == s.base.size()) {
        ADD_FAILURE() << "the engine asks for more than the mesh has";
        break;
      }
      in.write(s.base[next++]);
    }
    engine.step(in, out, s.regs, s.memories());
    while (!out.empty()) run.triangles.push_back(out.read());
  }
  run.counts = engine.counts();
  run.additions = engine.additions();
  EXPECT_TRUE(in.empty() && out.empty());
  EXPECT_EQ(next, s.base.size()) << "base triangles were left";
  return run;
}

inline golden_sweep_run run_golden(sweep_scene const& s) {
  golden_sweep_run run;
  golden::memories maps;
  maps.texels = s.map.texels().words;
  maps.normal_map = as_golden<golden::normal_map_regs>(s.normal_regs);
  golden::sweep_engine<golden::rounded> engine(as_golden<golden::sweep_regs>(s.regs), maps);
  std::size_t next = 0;
  run.counts = engine.run(
      [&](golden::base_triangle& t) {
        if (next == s.base.size()) return false;
        t = as_golden<golden::base_triangle>(s.base[next++]);
        return true;
      },
      [&](golden::swept_triangle const& t) { run.triangles.push_back(t); });
  return run;
}

using sweep_counter_list = std::vector<std::pair<std::string, std::uint64_t>>;
template <class Counters>
sweep_counter_list sweep_counts(Counters const& counts) {
  sweep_counter_list list;
  counts.each_field([&](char const* name, std::uint64_t x) { list.push_back({name, x}); });
  return list;
}

inline testing::AssertionResult equal_runs(hls_sweep_run const& hls, golden_sweep_run const& golden) {
  for (std::size_t i = 0; i < hls.triangles.size() && i < golden.triangles.size(); ++i)
    if (const auto same = equal_words(hls.triangles[i], golden.triangles[i]); !same)
      return testing::AssertionFailure() << "triangle " << i << ": " << same.message();
  if (hls.triangles.size() != golden.triangles.size())
    return testing::AssertionFailure() << hls.triangles.size() << " triangles in hls, " << golden.triangles.size() << " in golden";
  const sweep_counter_list h = sweep_counts(hls.counts), g = sweep_counts(golden.counts);
  for (std::size_t i = 0; i < h.size(); ++i)
    if (h[i] != g[i]) return testing::AssertionFailure() << h[i].first << ": " << h[i].second << " in hls, " << g[i].second << " in golden";
  return testing::AssertionSuccess();
}

}  // namespace relievo::test

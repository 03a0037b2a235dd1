// engine_scene: small scenes for the edge engine, and the two models run on them.
//
//   engine_scene     registers, map (texels, table, normals of the map itself) and base triangles
//   random_scene(g)  a plane of quads or loose triangles, some degenerate, some with opposite normals, over a small map; registers
//                    from a calm camera to random words; every test switched at random; at most max_generation generations
//   run_hls(e, s)    start() and a whole mesh through an engine; its streams must be empty at the end
//   run_golden(s, d) the same through golden with room for d triangles
//   equal_runs(a, b) every output word in order, then every counter by name
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <utility>
#include <vector>

#include "golden/edge/engine.hpp"
#include "hls/edge/engine.hpp"
#include "hls/surface/normal_map.hpp"
#include "tests/support/map_cases.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {

struct engine_scene {
  test_map map;
  hls::engine_regs regs{};
  hls::normal_map_regs normal_regs{};
  std::vector<std::uint64_t> normals{};
  std::vector<hls::triangle> base{};

  explicit engine_scene(test_map m) : map(std::move(m)) {}

  // The normal map that the registers ask for, each texel by its definition.
  void build_normals() {
    normals.clear();
    for (int y = 0; y < map.height(); ++y)
      for (int x = 0; x < map.width(); ++x) {
        const glm::dvec3 n = golden::normal_map<golden::rounded>({x, y}, as_golden<golden::map_regs>(regs.map),
                                                                 as_golden<golden::normal_map_regs>(normal_regs), map.golden_texels())
                                 .n;
        hls::fixed<formats::unit> words[3];
        for (int i = 0; i < 3; ++i) words[i] = hls::from_raw<formats::unit>(static_cast<std::int64_t>(n[i] * 16384));
        normals.push_back(hls::pack_normal(words));
      }
  }
  void add(hls::vertex const& a, hls::vertex const& b, hls::vertex const& c) {
    hls::triangle t{};
    t.v[0] = a;
    t.v[1] = b;
    t.v[2] = c;
    t.index = hls::from_raw<formats::index>(static_cast<std::int64_t>(base.size()));
    if (!base.empty()) base.back().last = false;
    t.last = true;
    base.push_back(t);
  }
  // columns x rows quads in z = 0 over [-1, 1]^2, texture coordinates across the whole map.
  void add_plane(int columns, int rows) {
    const auto at = [&](int i, int k) {
      hls::vertex v{};
      v.p[0] = hls::from_raw<formats::position>((2 * i - columns) * (std::int64_t(1) << 20) / columns);
      v.p[1] = hls::from_raw<formats::position>((2 * k - rows) * (std::int64_t(1) << 20) / rows);
      v.n[2] = v.t[0] = hls::from_raw<formats::unit>(16384);
      v.u[0] = hls::from_raw<formats::coordinate>(coordinate_limit(regs.map.width, regs.map.wrap_u) * i / columns);
      v.u[1] = hls::from_raw<formats::coordinate>(coordinate_limit(regs.map.height, regs.map.wrap_v) * k / rows);
      return v;
    };
    for (int k = 0; k < rows; ++k)
      for (int i = 0; i < columns; ++i) {
        add(at(i, k), at(i + 1, k), at(i + 1, k + 1));
        add(at(i, k), at(i + 1, k + 1), at(i, k + 1));
      }
  }
  // Looks down on the plane: pixels = 100 p, w = 2.
  void calm_camera() {
    regs.transform.row_x[0] = regs.transform.row_y[1] =
        hls::from_raw<formats::matrix_xy>(std::int64_t(200) << formats::matrix_xy::fraction);
    regs.transform.offset_w = hls::from_raw<formats::offset_w>(std::int64_t(2) << formats::offset_w::fraction);
    regs.transform.w_min = hls::from_raw<formats::depth>(1 << 12);
    for (int i = 0; i < 3; ++i) regs.transform_normal.rotation[i][i] = hls::from_raw<formats::unit>(16384);
    regs.transform_normal.eye[2] = hls::from_raw<formats::eye>(std::int64_t(2) << formats::eye::fraction);
  }
};

inline void add_loose_triangle(engine_scene& s, generator& g) {
  hls::vertex v[3] = {};
  for (auto& w : v) {
    draw_vector(w, draw::uniform, g);
    unit_vector(w.n, g);
    unit_vector(w.t, g);
    coordinates_within(w.u, s.regs.map, g);
    if (!g.chance(4))
      for (auto& p : w.p) p = hls::from_raw<formats::position>(raw(p) >> 3);
    w.displaced = w.transformed = false;
  }
  const std::uint64_t kind = g.below(6);
  if (kind == 0) v[1] = v[0];
  if (kind == 1)
    for (int i = 0; i < 3; ++i) {
      v[1].n[i] = hls::from_raw<formats::unit>(std::min<std::int64_t>(32767, -raw(v[0].n[i])));
      v[1].t[i] = hls::from_raw<formats::unit>(std::min<std::int64_t>(32767, -raw(v[0].t[i])));
    }
  s.add(v[0], v[1], v[2]);
}

inline engine_scene random_scene(generator& g, int max_generation) {
  constexpr map_size sizes[] = {{1, 1}, {2, 2}, {1, 9}, {7, 3}, {16, 16}, {23, 40}};
  const map_size size = sizes[g.below(6)];
  engine_scene s(test_map(size.width, size.height, g.chance(2) ? fill::random : all_fills[g.below(7)], g));
  draw_vector(s.regs, draw::magnitude, g);
  s.regs.map = s.map.regs(g.chance(2), g.chance(2));
  draw_vector(s.normal_regs, draw::magnitude, g);
  s.normal_regs.normal_shift = hls::from_raw<formats::shift>(g.between(0, 5));
  s.regs.pass.max_generation = hls::from_raw<formats::generation>(max_generation);
  s.regs.pass.cull = g.chance(4);
  // Stopping tests are rarer, and thresholds low enough that something happens.
  s.regs.pass.use_vt = g.chance(3);
  s.regs.pass.use_ct = g.chance(3);
  s.regs.summed_height.sum_threshold = hls::from_raw<formats::sum_threshold>(raw(s.regs.summed_height.sum_threshold) >> 20);
  s.regs.profile.threshold = hls::from_raw<formats::profile_threshold>(raw(s.regs.profile.threshold) >> 2);
  if (!g.chance(3)) s.calm_camera();
  if (raw(s.regs.transform.w_min) == 0) s.regs.transform.w_min = hls::from_raw<formats::depth>(1);
  s.regs.view.threshold = hls::from_raw<formats::view_threshold>(g.between(0, 20000));
  if (!g.chance(8)) {
    s.regs.displace.scale = hls::from_raw<formats::scale>(raw(s.regs.displace.scale) >> 4);
    s.regs.displace.bias = hls::from_raw<formats::height>(raw(s.regs.displace.bias) >> 4);
  }
  s.build_normals();
  if (g.chance(2)) {
    s.add_plane(static_cast<int>(g.between(1, 2)), static_cast<int>(g.between(1, 2)));
  } else {
    for (std::int64_t i = g.between(1, 4); i > 0; --i) add_loose_triangle(s, g);
  }
  return s;
}

struct hls_run {
  std::vector<hls::triangle_out> triangles;
  hls::counters counts;
};
struct golden_run {
  std::vector<golden::triangle_out> triangles;
  golden::counters counts;
};

template <int Depth>
hls_run run_hls(hls::engine<Depth>& engine, engine_scene const& s) {
  hls_run run;
  hls::stream<hls::triangle, 1> in("engine.in");
  hls::stream<hls::triangle_out, 2> out("engine.out");
  const hls::engine_memories memories = {s.map.texels(), s.map.table(), {s.normals.data()}};
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
    engine.step(in, out, s.regs, memories);
    while (!out.empty()) run.triangles.push_back(out.read());
  }
  run.counts = engine.counts();
  EXPECT_TRUE(in.empty() && out.empty());
  EXPECT_EQ(next, s.base.size()) << "base triangles were left";
  return run;
}

inline golden_run run_golden(engine_scene const& s, std::size_t depth) {
  golden_run run;
  const golden::memories maps = {s.map.texels().words, s.map.table().words, as_golden<golden::normal_map_regs>(s.normal_regs)};
  golden::engine<golden::rounded> engine(as_golden<golden::engine_regs>(s.regs), maps, depth);
  std::size_t next = 0;
  run.counts = engine.run(
      [&](golden::triangle& t) {
        if (next == s.base.size()) return false;
        t = as_golden<golden::triangle>(s.base[next++]);
        return true;
      },
      [&](golden::triangle_out const& t) { run.triangles.push_back(t); });
  return run;
}

using counter_list = std::vector<std::pair<std::string, std::uint64_t>>;
template <class Counters>
counter_list list_of(Counters const& counts) {
  counter_list list;
  struct lister {
    counter_list& list;
    void operator()(char const* name, std::uint64_t const& x) { list.push_back({name, x}); }
    void operator()(char const* name, std::uint64_t const (&x)[4]) {
      for (int i = 0; i < 4; ++i) list.push_back({name + ("[" + std::to_string(i) + "]"), x[i]});
    }
  };
  lister visitor{list};
  counts.each_field(visitor);
  return list;
}

inline testing::AssertionResult equal_runs(hls_run const& hls, golden_run const& golden) {
  for (std::size_t i = 0; i < std::min(hls.triangles.size(), golden.triangles.size()); ++i) {
    const auto result = equal_words(hls.triangles[i], golden.triangles[i]);
    if (!result) return testing::AssertionFailure() << "output " << i << ": " << result.message() << "\n" << describe(hls.triangles[i]);
  }
  if (hls.triangles.size() != golden.triangles.size())
    return testing::AssertionFailure() << "hls put out " << hls.triangles.size() << " records, golden " << golden.triangles.size();
  const counter_list a = list_of(hls.counts), b = list_of(golden.counts);
  if (a.size() != b.size()) return testing::AssertionFailure() << "the counters are not the same list";
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] != b[i])
      return testing::AssertionFailure() << a[i].first << ": hls " << a[i].second << ", golden " << b[i].first << " " << b[i].second;
  return testing::AssertionSuccess();
}

}  // namespace relievo::test

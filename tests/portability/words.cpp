// words: what the units answer to seeded random inputs, as text, one line a vector. scripts/portability.sh builds it three times, with
// the simulation's fixed, over ap_fixed and over ac_fixed, and every line must be the same.
//
//   words VECTORS      conversions and operators between formats, each unit, each port, then the engine on a small scene
#include <cstdlib>
#include <memory>
#include <vector>

#include "tests/portability/records.hpp"
#include "tests/portability/sweep_words.hpp"
#include "tests/portability/world_words.hpp"

namespace relievo {
namespace {

// ---- fixed ---------------------------------------------------------------------------------------------------------------

template <class A, class B>
void operators_of(char const* name) {
  const auto a = random_record<hls::fixed<A>>();
  const auto b = random_record<hls::fixed<B>>();
  std::printf("%s", name);
  printer p;
  p.print(a + b);
  p.print(a - b);
  p.print(a * b);
  p.print(-a);
  p.print(hls::magnitude(a - b));
  p.print(hls::times_two_to<3>(a));
  std::printf(" %d%d%d%d%d%d %" PRId64, a<b, a> b, a <= b, a >= b, a == b, a != b, hls::floor_int(a));
  bool clipped = false;
  p.print(hls::round_to<B>(a));
  p.print(hls::round_to<B>(a, clipped));
  p.print(hls::floor_to<B>(a));
  p.print(hls::wrap_to<B>(a));
  std::printf(" %d\n", clipped);
}

void fixed_vectors() {
  using namespace formats;
  operators_of<position, height>("position height");
  operators_of<position, unit>("position unit");
  operators_of<unit, direction>("unit direction");
  operators_of<direction, unit>("direction unit");
  operators_of<coordinate, map_size>("coordinate map_size");
  operators_of<sample, texel>("sample texel");
  operators_of<sample, scale>("sample scale");
  operators_of<gradient, texel>("gradient texel");
  operators_of<depth, screen>("depth screen");
  operators_of<screen, view_threshold>("screen view_threshold");
  operators_of<eye, position>("eye position");
  operators_of<format<7, 3, true>, format<5, 4, false>>("7.3 5.4u");
  operators_of<format<5, 4, false>, format<7, 3, true>>("5.4u 7.3");
  operators_of<format<9, 9, false>, format<6, 2, false>>("9.9u 6.2u");
  operators_of<format<12, 2, true>, format<4, 4, true>>("12.2 4.4");
}

// ---- units and their ports --------------------------------------------------------------------------------------------------

constexpr int map_width = 23, map_height = 17;
struct memories {
  std::vector<std::uint16_t> texels;
  std::vector<std::uint64_t> table, normals;
  memories() {
    std::vector<std::uint64_t> column(map_width, 0);
    for (int y = 0; y < map_height; ++y) {
      std::uint64_t row = 0;
      for (int x = 0; x < map_width; ++x) {
        texels.push_back(static_cast<std::uint16_t>(next_random() >> 48));
        row += texels.back();
        column[static_cast<std::size_t>(x)] += row;
        table.push_back(column[static_cast<std::size_t>(x)]);
        normals.push_back(next_random() >> 16);
      }
    }
  }
};

hls::map_regs random_map() {
  hls::map_regs map = random_record<hls::map_regs>();
  map.width = hls::from_raw<formats::map_size>(map_width);
  map.height = hls::from_raw<formats::map_size>(map_height);
  return map;
}
void within(hls::fixed<formats::coordinate> (&u)[2], hls::map_regs const& map) {
  const std::int64_t size[2] = {map_width - (map.wrap_u ? 0 : 1), map_height - (map.wrap_v ? 0 : 1)};
  for (int i = 0; i < 2; ++i) u[i] = hls::from_raw<formats::coordinate>(hls::raw(u[i]) % (size[i] * 2048 + 1));
}

void unit_vectors(memories const& m) {
  const hls::map_regs map = random_map();
  const auto map_word = hls::pack(map);
  through<hls::top::divide_out>("divide", random_record<hls::top::divide_in>(), relievo_divide);
  through<hls::normalize_out>("normalize", random_record<hls::normalize_in>(), relievo_normalize);
  through<hls::bump_out>("bump", random_record<hls::bump_in>(), relievo_bump);
  through<hls::tex_coord_test_out>("tex_coord_test", random_record<hls::tex_coord_test_in>(), relievo_tex_coord_test);
  through<hls::interpolants>("perspective_preparation", random_record<hls::perspective_preparation_in>(), relievo_perspective_preparation);
  const auto correction = hls::pack(random_record<hls::perspective_correction_regs>());
  through<hls::perspective_correction_out>(
      "perspective_correction", random_record<hls::perspective_correction_in>(),
      [&](hls::port<hls::perspective_correction_in>& in, hls::port<hls::perspective_correction_out>& out) {
        relievo_perspective_correction(in, correction, out);
      });
  const auto displace = hls::pack(random_record<hls::displace_regs>());
  through<hls::displace_out>(
      "displace", random_record<hls::displace_in>(),
      [&](hls::port<hls::displace_in>& in, hls::port<hls::displace_out>& out) { relievo_displace(in, displace, out); });
  const auto transform = hls::pack(random_record<hls::transform_regs>());
  through<hls::transform_out>(
      "transform", random_record<hls::transform_in>(),
      [&](hls::port<hls::transform_in>& in, hls::port<hls::transform_out>& out) { relievo_transform(in, transform, out); });
  const auto rotation = hls::pack(random_record<hls::transform_normal_regs>());
  through<hls::transform_normal_out>("transform_normal", random_record<hls::transform_normal_in>(),
                                     [&](hls::port<hls::transform_normal_in>& in, hls::port<hls::transform_normal_out>& out) {
                                       relievo_transform_normal(in, rotation, out);
                                     });
  const auto normal = hls::pack(random_record<hls::normal_test_regs>());
  through<hls::normal_test_out>(
      "normal_test", random_record<hls::normal_test_in>(),
      [&](hls::port<hls::normal_test_in>& in, hls::port<hls::normal_test_out>& out) { relievo_normal_test(in, normal, out); });
  const auto view = hls::pack(random_record<hls::view_test_regs>());
  through<hls::view_test_out>(
      "view_test", random_record<hls::view_test_in>(),
      [&](hls::port<hls::view_test_in>& in, hls::port<hls::view_test_out>& out) { relievo_view_test(in, view, out); });
  const auto highlight = hls::pack(random_record<hls::highlight_test_regs>());
  through<hls::highlight_test_out>(
      "highlight_test", random_record<hls::highlight_test_in>(),
      [&](hls::port<hls::highlight_test_in>& in, hls::port<hls::highlight_test_out>& out) { relievo_highlight_test(in, highlight, out); });

  world_vectors(m.texels.data(), map);

  auto at = random_record<hls::map_sampler_in>();
  within(at.u, map);
  through<hls::map_sampler_out>("map_sampler", at, [&](hls::port<hls::map_sampler_in>& in, hls::port<hls::map_sampler_out>& out) {
    relievo_map_sampler(in, map_word, m.texels.data(), out);
  });
  through<hls::normal_sampler_out>("normal_sampler", hls::normal_sampler_in{{at.u[0], at.u[1]}},
                                   [&](hls::port<hls::normal_sampler_in>& in, hls::port<hls::normal_sampler_out>& out) {
                                     relievo_normal_sampler(in, map_word, m.normals.data(), out);
                                   });
  auto edge = random_record<hls::profile_test_in>();
  within(edge.u1, map);
  within(edge.u2, map);
  const auto profile = hls::pack(random_record<hls::profile_test_regs>());
  through<hls::profile_test_out>("profile_test", edge, [&](hls::port<hls::profile_test_in>& in, hls::port<hls::profile_test_out>& out) {
    relievo_profile_test(in, map_word, profile, m.texels.data(), out);
  });
  const hls::calculate_new_u_out middle =
      hls::calculate_new_u({{edge.u1[0], edge.u1[1]}, {edge.u2[0], edge.u2[1]}, hls::from_raw<formats::weight>(8)});
  const auto summed = hls::pack(random_record<hls::summed_height_test_regs>());
  const hls::summed_height_test_in ends = {{edge.u1[0], edge.u1[1]}, {edge.u2[0], edge.u2[1]}, {middle.u[0], middle.u[1]}};
  through<hls::summed_height_test_out>("summed_height_test", ends,
                                       [&](hls::port<hls::summed_height_test_in>& in, hls::port<hls::summed_height_test_out>& out) {
                                         relievo_summed_height_test(in, map_word, summed, m.table.data(), out);
                                       });
  const std::int64_t x = hls::floor_int(at.u[0]) + 1, y = hls::floor_int(at.u[1]) + 1, e = 1 + static_cast<std::int64_t>(next_random() % 8);
  const hls::summed_area_lookup_in rectangle = {hls::from_raw<formats::bound>(x - e), hls::from_raw<formats::bound>(y - e),
                                                hls::from_raw<formats::bound>(x + e), hls::from_raw<formats::bound>(y + e)};
  through<hls::summed_area_lookup_out>("summed_area_lookup", rectangle,
                                       [&](hls::port<hls::summed_area_lookup_in>& in, hls::port<hls::summed_area_lookup_out>& out) {
                                         relievo_summed_area_lookup(in, map_word, m.table.data(), out);
                                       });
}

// ---- whole maps and a mesh ------------------------------------------------------------------------------------------------------

void builders(memories const& m, hls::map_regs const& map) {
  hls::port<hls::top::texel_word> in;
  hls::port<hls::top::table_word> table;
  hls::port<hls::normal_map_out> normals;
  for (const std::uint16_t texel : m.texels) in.write(hls::pack(hls::top::texel_word{hls::from_raw<formats::texel>(texel)}));
  relievo_summed_area_table(in, hls::pack(map), table);
  for (std::size_t i = 0; i < m.texels.size(); ++i) print_record("summed_area_table", hls::unpack<hls::top::table_word>(table.read()));
  hls::normal_map_regs regs;
  regs.gradient_u = hls::from_raw<formats::gradient>(700);
  regs.gradient_v = hls::from_raw<formats::gradient>(-300);
  regs.normal_shift = hls::from_raw<formats::shift>(3);
  for (const std::uint16_t texel : m.texels) in.write(hls::pack(hls::top::texel_word{hls::from_raw<formats::texel>(texel)}));
  relievo_normal_map(in, hls::pack(map), hls::pack(regs), normals);
  for (std::size_t i = 0; i < m.texels.size(); ++i) print_record("normal_map", hls::unpack<hls::normal_map_out>(normals.read()));
}

template <class F>
void set(hls::fixed<F>& x, std::int64_t numerator, std::int64_t denominator = 1) {
  x = hls::from_raw<F>(numerator * (std::int64_t(1) << F::fraction) / denominator);
}

// Two triangles over the whole map, seen from z = 3; all tests on.
void engine(memories const& m, hls::map_regs const& map) {
  hls::engine_regs regs = random_record<hls::engine_regs>();
  regs.map = map;
  regs.displace.scale = hls::from_raw<formats::scale>((std::int64_t(1) << formats::scale::fraction) / 4 / 65535);
  set(regs.displace.bias, 0);
  for (int i = 0; i < 3; ++i) {
    set(regs.transform.row_x[i], i == 0 ? 200 : 0);
    set(regs.transform.row_y[i], i == 1 ? 200 : 0);
    set(regs.transform.row_w[i], i == 2 ? -1 : 0);
    for (int j = 0; j < 3; ++j) set(regs.transform_normal.rotation[i][j], i == j ? 1 : 0);
    set(regs.transform_normal.eye[i], i == 2 ? 3 : 0);
    set(regs.highlight.half_vector[i], i == 2 ? 1 : 0);
  }
  set(regs.transform.offset_x, 0);
  set(regs.transform.offset_y, 0);
  set(regs.transform.offset_w, 3);
  set(regs.transform.w_min, 1, 256);
  set(regs.normal.threshold, 1, 4);
  set(regs.summed_height.sum_threshold, 100000);
  set(regs.summed_height.average_threshold, 800);
  set(regs.view.threshold, 5);
  set(regs.highlight.threshold, 9, 10);
  set(regs.profile.threshold, 4000);
  set(regs.pass.max_generation, 5);
  regs.pass.use_nt = regs.pass.use_sht = regs.pass.use_pt = regs.pass.use_ht = regs.pass.use_vt = regs.pass.use_ct = true;

  hls::port<hls::top::base_triangle> in;
  // On the heap: in simulation it holds thousands of words.
  const auto out = std::make_unique<hls::port<hls::triangle_out>>();
  const int corner[2][3][2] = {{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 1}}};
  for (int t = 0; t < 2; ++t) {
    hls::top::base_triangle base;
    for (int i = 0; i < 3; ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        set(base.v[i].p[axis], axis == 2 ? 0 : 2 * corner[t][i][axis] - 1);
        set(base.v[i].n[axis], axis == 2 ? 1 : 0);
        set(base.v[i].t[axis], axis == 0 ? 1 : 0);
      }
      set(base.v[i].u[0], corner[t][i][0] * (map_width - (map.wrap_u ? 0 : 1)));
      set(base.v[i].u[1], corner[t][i][1] * (map_height - (map.wrap_v ? 0 : 1)));
    }
    base.index = hls::from_raw<formats::index>(t);
    base.last = t == 1;
    in.write(hls::pack(base));
  }
  std::uint64_t counts[hls::top::counter_words];
  relievo_engine(in, hls::pack(regs), m.texels.data(), m.table.data(), m.normals.data(), *out, counts);
  for (bool last = false; !last;) {
    const hls::triangle_out t = hls::unpack<hls::triangle_out>(out->read());
    print_record("engine", t);
    last = t.last;
  }
  std::printf("counters");
  for (const std::uint64_t count : counts) std::printf(" %" PRIu64, count);
  std::printf("\n");
}

void speak(long vectors) {
  const memories m;
  for (long i = 0; i < vectors; ++i) fixed_vectors();
  for (long i = 0; i < vectors; ++i) unit_vectors(m);
  for (long i = 0; i < vectors; ++i) sweep(i % 16 == 0);
  for (int mode = 0; mode < 4; ++mode) {
    hls::map_regs map = random_map();
    map.wrap_u = mode % 2 != 0;
    map.wrap_v = mode / 2 != 0;
    builders(m, map);
    engine(m, map);
  }
}

}  // namespace
}  // namespace relievo

int main(int argc, char** argv) {
  relievo::speak(argc > 1 ? std::strtol(argv[1], nullptr, 10) : 1000);
  return 0;
}

// error_budget: docs/error_budget.md stays true. Its table of formats holds the numbers of hls/core/formats.hpp, and golden stays
// within each bound of its table of units against the ideal, given the same seeded random inputs. The measured maxima are printed.
#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "golden/edge/calculate_new_n.hpp"
#include "golden/edge/calculate_new_p.hpp"
#include "golden/edge/displace_vertex.hpp"
#include "golden/edge/highlight_test.hpp"
#include "golden/edge/normal_test.hpp"
#include "golden/edge/profile_test.hpp"
#include "golden/edge/summed_height_test.hpp"
#include "golden/edge/tex_coord_test.hpp"
#include "golden/edge/view_test.hpp"
#include "golden/surface/bump.hpp"
#include "golden/surface/normal_sampler.hpp"
#include "golden/surface/transform.hpp"
#include "golden/surface/transform_normal.hpp"
#include "tests/support/document_table.hpp"
#include "tests/support/draw.hpp"
#include "tests/support/settings.hpp"
#include "tests/support/sweep_errors.hpp"
#include "tests/support/world_errors.hpp"

namespace {

using namespace relievo;
using namespace relievo::golden;
using test::draw;
using test::random_map;

std::string const document = RELIEVO_SOURCE_DIR "/docs/error_budget.md";

template <class F>
double lsb(double a, double b) {
  return std::abs(a - b) / range_of<F>::lsb;
}
template <class F, int N>
double lsb(glm::vec<N, double> const& a, glm::vec<N, double> const& b) {
  double most = 0;
  for (int i = 0; i < N; ++i) most = std::max(most, lsb<F>(a[i], b[i]));
  return most;
}

// Any rectangle that the test may ask for around a place on the map.
summed_area_lookup_in rectangle(draw& d) {
  const int x = d.integer(1, 37), y = d.integer(1, 23), w = d.integer(1, 10), h = d.integer(1, 6);
  return {x - w, y - h, x + w, y + h};
}

transform_regs camera(draw& d) {
  transform_regs r;
  r.row_x = d.words<formats::matrix_xy>(-500, 500);
  r.row_y = d.words<formats::matrix_xy>(-500, 500);
  r.row_w = d.words<formats::matrix_w>(-1, 1);
  r.offset_x = d.word<formats::offset_xy>(-500, 500);
  r.offset_y = d.word<formats::offset_xy>(-500, 500);
  r.offset_w = d.word<formats::offset_w>(1, 20);
  r.w_min = 1;
  return r;
}

// One random vector of a unit: the error of golden against ideal, in LSB.
using measurement = std::function<double(draw&, random_map const& rough, random_map const& smooth)>;

double measure_transform(draw& d, bool of_depth) {
  const transform_in in{d.words<formats::position>(-2, 2)};
  const transform_regs regs = camera(d);
  const auto g = transform<rounded>(in, regs), i = transform<exact>(in, regs);
  if (g.behind || i.behind || g.saturated || glm::any(glm::greaterThan(glm::abs(i.screen), glm::dvec2(4095)))) return 0;
  return of_depth ? lsb<formats::depth>(g.w, i.w) : lsb<formats::screen>(g.screen, i.screen);
}

double measure_bump(draw& d) {
  const glm::dvec3 n = d.direction(), t = glm::normalize(glm::cross(n, d.direction()));
  const bump_in in{draw::to_unit(n), draw::to_unit(t), d.unit()};
  return lsb<formats::unit>(bump<rounded>(in).n, bump<exact>(in).n);
}

double measure_calculate_new_n(draw& d) {
  calculate_new_n_in in{d.unit(), d.unit(), static_cast<double>(d.integer(0, 16)), d.coin()};
  if (glm::dot(in.n1, in.n2) < -0.5) return 0;
  return lsb<formats::unit>(calculate_new_n<rounded>(in).n, calculate_new_n<exact>(in).n);
}

double measure_normal_map(draw& d, random_map const& map) {
  // Slopes up to 2, where the direction does not saturate.
  const normal_map_regs regs{d.word<formats::gradient>(-2, 2) / 128, d.word<formats::gradient>(-2, 2) / 128, 0};
  const normal_map_regs words{rounded::at<formats::gradient>(regs.gradient_u), rounded::at<formats::gradient>(regs.gradient_v), 0};
  const normal_map_in in{d.integer(0, 36), d.integer(0, 22)};
  const auto g = normal_map<rounded>(in, map.regs, words, map.texels());
  return g.saturated ? 0 : lsb<formats::unit>(g.n, normal_map<exact>(in, map.regs, words, map.texels()).n);
}

double measure_lookup(draw& d, random_map const& map) {
  const summed_area_lookup_in in = rectangle(d);
  const double area = static_cast<double>((in.x1 - in.x0) * (in.y1 - in.y0));
  return lsb<formats::sample>(summed_area_lookup<rounded>(in, map.regs, map.table()).s / area,
                              summed_area_lookup<exact>(in, map.regs, map.table()).s / area);
}

double measure_summed_height(draw& d, random_map const& map) {
  const glm::dvec2 u1 = map.coordinate(d), u2 = map.coordinate(d);
  const summed_height_test_in in{u1, u2, calculate_new_u<rounded>({u1, u2, 8}).u};
  const glm::ivec2 e = summed_height_extent(u1, u2, map.regs);
  const double area = 16.0 * e.x * e.y;
  return lsb<formats::sample>(summed_height_measure<rounded>(in, map.regs, {}, map.table()).measure / area,
                              summed_height_measure<exact>(in, map.regs, {}, map.table()).measure / area);
}

double measure_profile(draw& d, random_map const& map) {
  const profile_test_in in{map.coordinate(d), map.coordinate(d), d.coin()};
  const auto g = profile_of<rounded>(in, map.regs, map.texels()), i = profile_of<exact>(in, map.regs, map.texels());
  return g.n == 0 ? 0 : lsb<formats::sample>(g.measure() / g.n, i.measure() / g.n);
}

double measure_displace_vertex(draw& d, random_map const& map) {
  const displace_vertex_in in{d.words<formats::position>(-2, 2), d.unit(), map.coordinate(d)};
  const displace_regs regs{(d.coin() ? 1 : -1) * d.word<formats::scale>(0.9 / 8192, 1.0 / 8192) / 2, 0};
  const displace_regs words{rounded::at<formats::scale>(regs.scale * 2), d.word<formats::height>(-0.1, 0.1)};
  const auto g = displace_vertex<rounded>(in, map.regs, words, map.texels());
  return g.saturated ? 0 : lsb<formats::position>(g.p, displace_vertex<exact>(in, map.regs, words, map.texels()).p);
}

std::map<std::string, measurement> const& measurements() {
  using map = random_map const&;
  static const std::map<std::string, measurement> own = {
      {"normalize unit",
       [](draw& d, map, map) {
         const normalize_in in{d.words<formats::direction>(-8, 8), false};
         return lsb<formats::unit>(normalize<rounded>(in).n, normalize<exact>(in).n);
       }},
      {"quotient screen",
       [](draw& d, map, map) {
         const double a = d.word<formats::clip>(-1000, 1000), b = d.word<formats::depth>(1, 256);
         bool clipped = false;
         return lsb<formats::screen>(quotient<rounded, formats::screen, formats::depth::width>(a, b, clipped), a / b);
       }},
      {"map_address coordinate",
       [](draw& d, map rough, map) {
         const map_address_in in{rough.coordinate(d)};
         const auto g = map_address<rounded>(in, rough.regs), i = map_address<exact>(in, rough.regs);
         return lsb<formats::coordinate>(g.f.x, i.f.x) + lsb<formats::coordinate>(g.f.y, i.f.y);
       }},
      {"map_sampler sample",
       [](draw& d, map rough, map) {
         const map_sampler_in in{rough.coordinate(d)};
         return lsb<formats::sample>(map_sampler<rounded>(in, rough.regs, rough.texels()).d,
                                     map_sampler<exact>(in, rough.regs, rough.texels()).d);
       }},
      {"normal_sampler unit",
       [](draw& d, map rough, map) {
         const normal_sampler_in in{rough.coordinate(d)};
         return lsb<formats::unit>(normal_sampler<rounded>(in, rough.regs, rough).n, normal_sampler<exact>(in, rough.regs, rough).n);
       }},
      {"displace position",
       [](draw& d, map, map) {
         const displace_in in{d.words<formats::position>(-4, 4), d.unit(), d.word<formats::sample>(0, 65535)};
         const displace_regs regs{d.word<formats::scale>(-3e-5, 3e-5), d.word<formats::height>(-1, 1)};
         return lsb<formats::position>(displace<rounded>(in, regs).p, displace<exact>(in, regs).p);
       }},
      {"bump unit", [](draw& d, map, map) { return measure_bump(d); }},
      {"transform depth", [](draw& d, map, map) { return measure_transform(d, true); }},
      {"transform screen", [](draw& d, map, map) { return measure_transform(d, false); }},
      {"transform_normal unit",
       [](draw& d, map, map) {
         const transform_normal_in in{d.words<formats::position>(-2, 2), d.unit()};
         const transform_normal_regs regs{{d.unit(), d.unit(), d.unit()}, d.words<formats::eye>(-20, 20)};
         const auto g = transform_normal<rounded>(in, regs), i = transform_normal<exact>(in, regs);
         return lsb<formats::unit>(g.n, i.n) + (g.away == i.away ? 0 : 1);
       }},
      {"summed_area_lookup sample", [](draw& d, map rough, map) { return measure_lookup(d, rough); }},
      {"normal_map unit", [](draw& d, map, map smooth) { return measure_normal_map(d, smooth); }},
      {"calculate_new_p position",
       [](draw& d, map, map) {
         const calculate_new_p_in in{d.words<formats::position>(-8, 8), d.words<formats::position>(-8, 8),
                                     static_cast<double>(d.integer(0, 16))};
         return lsb<formats::position>(calculate_new_p<rounded>(in).p, calculate_new_p<exact>(in).p);
       }},
      {"calculate_new_u coordinate",
       [](draw& d, map rough, map) {
         const calculate_new_u_in in{rough.coordinate(d), rough.coordinate(d), static_cast<double>(d.integer(0, 16))};
         return lsb<formats::coordinate>(calculate_new_u<rounded>(in).u, calculate_new_u<exact>(in).u);
       }},
      {"calculate_new_n unit", [](draw& d, map, map) { return measure_calculate_new_n(d); }},
      {"displace_vertex position", [](draw& d, map rough, map) { return measure_displace_vertex(d, rough); }},
      {"normal_test unit",
       [](draw& d, map, map) {
         const normal_test_in in{d.unit(), d.unit(), d.unit()};
         const normal_test_regs regs{rounded::at<formats::normal_threshold>(normal_test_measure(in)) - d.integer(0, 1) / 16384.0};
         return normal_test<rounded>(in, regs).nt == normal_test<exact>(in, regs).nt ? 0.0 : 1.0;
       }},
      {"highlight_test unit",
       [](draw& d, map, map) {
         const highlight_test_in in{d.unit(), d.unit(), d.unit()};
         highlight_test_regs regs{d.unit(), 0};
         regs.threshold = rounded::at<formats::unit>(highlight_test_measure(in, regs));
         return highlight_test<rounded>(in, regs).ht == highlight_test<exact>(in, regs).ht ? 0.0 : 1.0;
       }},
      {"view_test screen",
       [](draw& d, map, map) {
         const auto at = [&d] { return glm::dvec2(d.word<formats::screen>(-8000, 8000), d.word<formats::screen>(-8000, 8000)); };
         const view_test_in in{at(), at(), false, d.integer(0, 9) == 0};
         const view_test_regs regs{view_test_measure(in) - d.integer(0, 1) / 256.0};
         return view_test<rounded>(in, regs).vt == view_test<exact>(in, regs).vt ? 0.0 : 1.0;
       }},
      {"tex_coord_test coordinate",
       [](draw& d, map rough, map) {
         const tex_coord_test_in in{rough.coordinate(d), rough.coordinate(d), rough.coordinate(d)};
         return tex_coord_test<rounded>(in).ct == tex_coord_test<exact>(in).ct ? 0.0 : 1.0;
       }},
      {"summed_height_test sample", [](draw& d, map rough, map) { return measure_summed_height(d, rough); }},
      {"profile_test sample", [](draw& d, map, map smooth) { return measure_profile(d, smooth); }},
  };
  static const std::map<std::string, measurement> all = [] {
    std::map<std::string, measurement> both = own;
    for (auto const& list : {test::sweep_measurements(), test::world_measurements()})
      for (auto const& m : list) both[m.first] = [one = m.second](draw& d, random_map const&, random_map const&) { return one(d); };
    return both;
  }();
  return all;
}

TEST(error_budget, the_document_lists_the_formats_of_the_table) {
  std::map<std::string, std::vector<std::string>> listed;
  for (auto const& row : test::rows_below(document, "## Formats")) {
    ASSERT_GE(row.size(), 6U) << row[0];
    ASSERT_TRUE(listed.emplace(row[0], row).second) << row[0] << " is listed twice";
  }
  const auto expect = [&listed](char const* name, int width, int fraction, bool is_signed) {
    ASSERT_EQ(listed.count(name), 1U) << name << " is not in " << document;
    EXPECT_EQ(listed[name][1], std::to_string(width)) << name;
    EXPECT_EQ(listed[name][2], std::to_string(fraction)) << name;
    EXPECT_EQ(listed[name][3], is_signed ? "yes" : "no") << name;
    EXPECT_FALSE(listed[name][5].empty()) << name << " has no reason";
    listed.erase(name);
  };
#define RELIEVO_EXPECT_LISTED(name, width, integer_bits, is_signed) expect(#name, width, (width) - (integer_bits), is_signed);
  RELIEVO_FORMATS(RELIEVO_EXPECT_LISTED)
#undef RELIEVO_EXPECT_LISTED
  for (auto const& extra : listed) ADD_FAILURE() << extra.first << " is no format";
}

TEST(error_budget, golden_stays_within_each_bound_of_the_document) {
  std::set<std::string> bounded;
  for (auto const& row : test::rows_below(document, "## Units")) {
    ASSERT_GE(row.size(), 4U) << row[0];
    const std::string key = row[0] + " " + row[1];
    const double bound = std::stod(row[2]);
    ASSERT_TRUE(bounded.insert(key).second) << key << " is bounded twice";
    ASSERT_EQ(measurements().count(key), 1U) << key << " is not measured";
    draw d(test::seed());
    double most = 0;
    // A new pair of maps now and then: axes and slopes change, building them stays cheap.
    const std::uint64_t rounds = test::vector_count() / 5000 + 1;
    for (std::uint64_t round = 0; round < rounds; ++round) {
      const random_map rough(d, false), smooth(d, true);
      for (int i = 0; i < 1000; ++i) most = std::max(most, measurements().at(key)(d, rough, smooth));
    }
    std::printf("%-28s %7.4f of %g LSB\n", key.c_str(), most, bound);
    EXPECT_LE(most, bound * (1 + 1e-6)) << key;
    EXPECT_GE(most, bound / 4) << key << ": the vectors do not come near the bound";
  }
  for (auto const& m : measurements()) EXPECT_EQ(bounded.count(m.first), 1U) << m.first << " has no row in " << document;
}

// The example of a double that is not enough, and others nearest to a rounding boundary.
TEST(error_budget, the_last_bit_of_a_unit_vector_is_decided_exactly) {
  const double lsb_in = range_of<formats::direction>::lsb;
  const auto n = normalize<rounded>({glm::dvec3(6354, 2707, 9352) * lsb_in, false});
  EXPECT_EQ(n.n.x / range_of<formats::unit>::lsb, 8954);
  // |v| = 2^16: v_x / |v| = 1 / 2^15 is a tie and goes up, to one; its negative goes up too, to zero.
  EXPECT_EQ((detail::rounded_ratio<14>(2, std::int64_t{1} << 32)), 1);
  EXPECT_EQ((detail::rounded_ratio<14>(-2, std::int64_t{1} << 32)), 0);
  EXPECT_EQ((detail::rounded_ratio<14>(-131072, std::int64_t{1} << 34)), -16384);
}

}  // namespace

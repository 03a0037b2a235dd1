// mirror: every record that hls and golden both have names the same fields in the same order, down to the last record inside a record.
//   to_golden and to_hls copy words by place: two fields of one width, swapped in one tree, would otherwise go unnoticed.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "golden/core/normalize.hpp"
#include "golden/edge/counters.hpp"
#include "golden/edge/engine.hpp"
#include "golden/edge/engine_regs.hpp"
#include "golden/edge/get_triangle.hpp"
#include "golden/surface/normal_map.hpp"
#include "golden/sweep/difference_vertices.hpp"
#include "golden/sweep/engine_data.hpp"
#include "golden/sweep/perspective_correction.hpp"
#include "golden/sweep/perspective_preparation.hpp"
#include "golden/sweep/sweep_line.hpp"
#include "golden/sweep/view_volume_clip.hpp"
#include "golden/sweep/world_data.hpp"
#include "hls/core/normalize.hpp"
#include "hls/edge/engine.hpp"
#include "hls/surface/normal_map.hpp"
#include "hls/sweep/difference_vertices.hpp"
#include "hls/sweep/engine_data.hpp"
#include "hls/sweep/perspective_correction.hpp"
#include "hls/sweep/perspective_preparation.hpp"
#include "hls/sweep/sweep_line.hpp"
#include "hls/sweep/view_volume_clip.hpp"
#include "hls/sweep/world_data.hpp"
#include "tb/model/words.hpp"

namespace relievo::test {
namespace {

// Dotted names of the fields, those of a record inside a record or an array of records after its own. The lengths of arrays are not
// part of a name: golden holds vectors where hls holds arrays. `words` counts the scalars.
struct name_walker {
  std::vector<std::string> names{};
  std::size_t words = 0;
  std::string path{};

  template <class T>
  void operator()(char const* name, T const& x) {
    const std::size_t length = path.size();
    path += (path.empty() ? "" : ".") + std::string(name);
    names.push_back(path);
    inside(x, 0);
    path.resize(length);
  }

  template <class T>
  auto inside(T const& x, int) -> decltype(x.each_field(*this)) {
    x.each_field(*this);
  }
  template <class T, std::size_t N>
  void inside(T const (&x)[N], int) {
    elements(x, N);
  }
  template <class T, std::size_t N>
  void inside(std::array<T, N> const& x, int) {
    elements(x, N);
  }
  template <int N>
  void inside(glm::vec<N, double> const&, int) {
    words += static_cast<std::size_t>(N);
  }
  template <class T>
  void inside(T const&, long) {
    ++words;
  }

  // The names inside all elements of an array are those of its first.
  template <class Array>
  void elements(Array const& x, std::size_t count) {
    inside(x[0], 0);
    const std::vector<std::string> named = names;
    for (std::size_t i = 1; i < count; ++i) inside(x[i], 0);
    names = named;
  }
};

template <class Record>
name_walker walked() {
  name_walker w;
  const Record record{};
  record.each_field(w);
  return w;
}

template <class H, class G>
testing::AssertionResult same_fields() {
  const name_walker h = walked<H>(), g = walked<G>();
  for (std::size_t i = 0; i < h.names.size() || i < g.names.size(); ++i) {
    const std::string in_hls = i < h.names.size() ? h.names[i] : "none", in_golden = i < g.names.size() ? g.names[i] : "none";
    if (in_hls != in_golden)
      return testing::AssertionFailure() << "field " << i << ": " << in_hls << " in hls, " << in_golden << " in golden";
  }
  if (h.words != g.words) return testing::AssertionFailure() << h.words << " words in hls, " << g.words << " in golden";
  return testing::AssertionSuccess();
}

#define RELIEVO_EXPECT_MIRRORED(record) EXPECT_TRUE((same_fields<hls::record, golden::record>())) << #record

TEST(mirror, records_of_the_surface) {
  RELIEVO_EXPECT_MIRRORED(normalize_in);
  RELIEVO_EXPECT_MIRRORED(normalize_out);
  RELIEVO_EXPECT_MIRRORED(bump_in);
  RELIEVO_EXPECT_MIRRORED(bump_out);
  RELIEVO_EXPECT_MIRRORED(displace_in);
  RELIEVO_EXPECT_MIRRORED(displace_regs);
  RELIEVO_EXPECT_MIRRORED(displace_out);
  RELIEVO_EXPECT_MIRRORED(map_regs);
  RELIEVO_EXPECT_MIRRORED(map_address_in);
  RELIEVO_EXPECT_MIRRORED(map_address_out);
  RELIEVO_EXPECT_MIRRORED(map_sampler_in);
  RELIEVO_EXPECT_MIRRORED(map_sampler_out);
  RELIEVO_EXPECT_MIRRORED(normal_map_regs);
  RELIEVO_EXPECT_MIRRORED(normal_map_out);
  RELIEVO_EXPECT_MIRRORED(normal_sampler_in);
  RELIEVO_EXPECT_MIRRORED(normal_sampler_out);
  RELIEVO_EXPECT_MIRRORED(summed_area_lookup_in);
  RELIEVO_EXPECT_MIRRORED(summed_area_lookup_out);
  RELIEVO_EXPECT_MIRRORED(transform_in);
  RELIEVO_EXPECT_MIRRORED(transform_regs);
  RELIEVO_EXPECT_MIRRORED(transform_out);
  RELIEVO_EXPECT_MIRRORED(transform_normal_in);
  RELIEVO_EXPECT_MIRRORED(transform_normal_regs);
  RELIEVO_EXPECT_MIRRORED(transform_normal_out);
  RELIEVO_EXPECT_MIRRORED(vertex);
}

TEST(mirror, records_of_the_edge_engine) {
  RELIEVO_EXPECT_MIRRORED(calculate_new_n_in);
  RELIEVO_EXPECT_MIRRORED(calculate_new_n_out);
  RELIEVO_EXPECT_MIRRORED(calculate_new_p_in);
  RELIEVO_EXPECT_MIRRORED(calculate_new_p_out);
  RELIEVO_EXPECT_MIRRORED(calculate_new_u_in);
  RELIEVO_EXPECT_MIRRORED(calculate_new_u_out);
  RELIEVO_EXPECT_MIRRORED(counters);
  RELIEVO_EXPECT_MIRRORED(displace_vertex_in);
  RELIEVO_EXPECT_MIRRORED(displace_vertex_out);
  RELIEVO_EXPECT_MIRRORED(engine_regs);
  RELIEVO_EXPECT_MIRRORED(get_triangle_out);
  RELIEVO_EXPECT_MIRRORED(highlight_test_in);
  RELIEVO_EXPECT_MIRRORED(highlight_test_regs);
  RELIEVO_EXPECT_MIRRORED(highlight_test_out);
  RELIEVO_EXPECT_MIRRORED(normal_test_in);
  RELIEVO_EXPECT_MIRRORED(normal_test_regs);
  RELIEVO_EXPECT_MIRRORED(normal_test_out);
  RELIEVO_EXPECT_MIRRORED(out_vertex);
  RELIEVO_EXPECT_MIRRORED(pass_or_tessellate_in);
  RELIEVO_EXPECT_MIRRORED(pass_or_tessellate_regs);
  RELIEVO_EXPECT_MIRRORED(pass_or_tessellate_out);
  RELIEVO_EXPECT_MIRRORED(profile_test_in);
  RELIEVO_EXPECT_MIRRORED(profile_test_regs);
  RELIEVO_EXPECT_MIRRORED(profile_test_out);
  RELIEVO_EXPECT_MIRRORED(summed_height_test_in);
  RELIEVO_EXPECT_MIRRORED(summed_height_test_regs);
  RELIEVO_EXPECT_MIRRORED(summed_height_test_out);
  RELIEVO_EXPECT_MIRRORED(tessellate_in);
  RELIEVO_EXPECT_MIRRORED(tessellate_out);
  RELIEVO_EXPECT_MIRRORED(tex_coord_test_in);
  RELIEVO_EXPECT_MIRRORED(tex_coord_test_out);
  RELIEVO_EXPECT_MIRRORED(triangle);
  RELIEVO_EXPECT_MIRRORED(triangle_out);
  RELIEVO_EXPECT_MIRRORED(triangle_queue_regs);
  RELIEVO_EXPECT_MIRRORED(view_test_in);
  RELIEVO_EXPECT_MIRRORED(view_test_regs);
  RELIEVO_EXPECT_MIRRORED(view_test_out);
}

TEST(mirror, records_of_the_sweep_engine) {
  RELIEVO_EXPECT_MIRRORED(remeshed_vertex);
  RELIEVO_EXPECT_MIRRORED(primitive);
  RELIEVO_EXPECT_MIRRORED(main_direction_in);
  RELIEVO_EXPECT_MIRRORED(main_direction_out);
  RELIEVO_EXPECT_MIRRORED(primary_edge_in);
  RELIEVO_EXPECT_MIRRORED(primary_edge_out);
  RELIEVO_EXPECT_MIRRORED(remeshing_plane_in);
  RELIEVO_EXPECT_MIRRORED(remeshing_plane_out);
  RELIEVO_EXPECT_MIRRORED(case_selection_in);
  RELIEVO_EXPECT_MIRRORED(case_selection_out);
  RELIEVO_EXPECT_MIRRORED(sub_triangle);
  RELIEVO_EXPECT_MIRRORED(sub_triangle_remeshing_in);
  RELIEVO_EXPECT_MIRRORED(sweep_line_in);
  RELIEVO_EXPECT_MIRRORED(base_vertex);
  RELIEVO_EXPECT_MIRRORED(interpolants);
  RELIEVO_EXPECT_MIRRORED(vertex_steps);
  RELIEVO_EXPECT_MIRRORED(perspective_preparation_in);
  RELIEVO_EXPECT_MIRRORED(difference_vertices_in);
  RELIEVO_EXPECT_MIRRORED(difference_vertices_out);
  RELIEVO_EXPECT_MIRRORED(perspective_correction_in);
  RELIEVO_EXPECT_MIRRORED(perspective_correction_regs);
  RELIEVO_EXPECT_MIRRORED(perspective_correction_out);
  RELIEVO_EXPECT_MIRRORED(base_triangle);
  RELIEVO_EXPECT_MIRRORED(swept_vertex);
  RELIEVO_EXPECT_MIRRORED(swept_triangle);
  RELIEVO_EXPECT_MIRRORED(sweep_regs);
  RELIEVO_EXPECT_MIRRORED(sweep_counters);
  RELIEVO_EXPECT_MIRRORED(view_volume_clip_in);
  RELIEVO_EXPECT_MIRRORED(view_volume_clip_regs);
  RELIEVO_EXPECT_MIRRORED(view_volume_clip_out);
}

TEST(mirror, the_units_before_the_grid_name_the_same_fields_in_the_same_order) {
  RELIEVO_EXPECT_MIRRORED(grid_transform_in);
  RELIEVO_EXPECT_MIRRORED(grid_transform_regs);
  RELIEVO_EXPECT_MIRRORED(grid_transform_out);
  RELIEVO_EXPECT_MIRRORED(z_table_in);
  RELIEVO_EXPECT_MIRRORED(z_table_out);
  RELIEVO_EXPECT_MIRRORED(near_clip_in);
  RELIEVO_EXPECT_MIRRORED(near_clip_regs);
  RELIEVO_EXPECT_MIRRORED(near_clip_out);
  RELIEVO_EXPECT_MIRRORED(base_triangle_clip_in);
  RELIEVO_EXPECT_MIRRORED(base_triangle_clip_regs);
  RELIEVO_EXPECT_MIRRORED(base_triangle_clip_out);
  RELIEVO_EXPECT_MIRRORED(d_max_of_in);
  RELIEVO_EXPECT_MIRRORED(d_max_of_out);
}

// What the test is there to find: two fields swapped, one renamed, one missing, one longer, and the same within a record.
struct in_order {
  hls::fixed<formats::bound> x0, y0, x1, y1;
  RELIEVO_FIELDS(x0, y0, x1, y1)
};
struct swapped {
  int x0 = 0, x1 = 0, y0 = 0, y1 = 0;
  RELIEVO_FIELDS(x0, x1, y0, y1)
};
struct renamed {
  int x0 = 0, y0 = 0, x1 = 0, top = 0;
  RELIEVO_FIELDS(x0, y0, x1, top)
};
struct shorter {
  int x0 = 0, y0 = 0, x1 = 0;
  RELIEVO_FIELDS(x0, y0, x1)
};
struct wider {
  int x0 = 0, y0 = 0, x1 = 0;
  glm::dvec2 y1{0};
  RELIEVO_FIELDS(x0, y0, x1, y1)
};
struct mirrored {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  RELIEVO_FIELDS(x0, y0, x1, y1)
};
template <class Record>
struct pair_of {
  Record ends[2];
  RELIEVO_FIELDS(ends)
};

TEST(mirror, a_difference_is_reported) {
  EXPECT_TRUE((same_fields<in_order, mirrored>()));
  EXPECT_TRUE((same_fields<pair_of<in_order>, pair_of<mirrored>>()));
  EXPECT_FALSE((same_fields<in_order, swapped>()));
  EXPECT_FALSE((same_fields<in_order, renamed>()));
  EXPECT_FALSE((same_fields<in_order, shorter>()));
  EXPECT_FALSE((same_fields<shorter, mirrored>()));
  EXPECT_FALSE((same_fields<in_order, wider>()));
  EXPECT_FALSE((same_fields<pair_of<in_order>, pair_of<swapped>>()));
}

}  // namespace
}  // namespace relievo::test

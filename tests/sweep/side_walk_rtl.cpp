// side_walk: the circuit puts out the kernel's primitives strip after strip, with any waits at strips, edge vertices and out, and after a
// reset in the middle of a strip; a primitive a clock. What it is fed with comes from golden's lists.
#include "Vside_walk.h"
#include "golden/sweep/sub_triangle_remeshing.hpp"
#include "tests/support/clocked_model.hpp"
#include "tests/support/walked.hpp"

namespace relievo::test {
namespace {

struct walk_words {
  std::deque<walked_strip> strips;
  std::deque<walked_vertex_word> vertices;
  std::deque<walked> out;
};

walked_border border_of(golden::remeshed_vertex const& v) {
  return {hls::from_raw<formats::steps>(static_cast<std::int64_t>(v.i)), hls::detail::two(v.number), v.kind == golden::kind_edge};
}
hls::fixed<formats::grid> grid_of(std::int64_t x) { return hls::from_raw<formats::grid>(x); }

void add_sub_triangle(walk_words& words, hls::sub_triangle_remeshing& kernel, hls::sub_triangle_remeshing_in const& in_words, bool ends) {
  const auto in = as_golden<golden::sub_triangle_remeshing_in>(in_words);
  golden::sub_triangle const& sub = in.sub;
  const golden::sweep_frame frame = golden::frame_of(in.plane, sub.backward);
  const int start = sub.backward ? in.plane.b : in.plane.a, end = sub.backward ? in.plane.a : in.plane.b;
  const auto k0 = static_cast<std::int64_t>(sub.k0), k1 = static_cast<std::int64_t>(sub.k1);

  // ---- the list of the side edges
  const std::vector<golden::place> primary = golden::edge_places(in, frame, start, end);
  std::vector<golden::place> side = golden::edge_places(in, frame, sub.from, sub.to), upright;
  for (golden::place& place : side) place.on_last_edge = true;
  if (sub.corner_list) {
    const std::vector<golden::place> vertical = golden::edge_places(in, frame, start, sub.from);
    side.insert(side.begin(), vertical.begin(), vertical.end() - 1);
  }
  for (golden::place& place : side) place.column = std::min(place.column, k1 - 1);
  side.back().column = k1;
  if (sub.ends_on_edge) upright = golden::edge_places(in, frame, sub.end_corner, sub.to);
  const std::size_t first = sub.starts_at_corner ? 1 : 0, n = side.size() - 1;
  for (std::size_t i = first; i < std::max(n, first + 1); ++i) {
    walked_vertex_word v{};
    v.name = border_of(side[i].vertex);
    v.last = side[i].on_last_edge;
    v.only_end = i == n;
    v.before_end = i + 1 == n;
    if (i < n) {
      v.row = side[i + 1].row != side[i].row;
      v.column = side[i + 1].column != side[i].column;
    }
    if (i == 1) {
      v.first_row = side[1].row != side[0].row;
      v.first_column = side[1].column != side[0].column;
    }
    words.vertices.push_back(v);
  }

  // ---- the strips
  for (std::int64_t k = k0; k < k1; ++k) {
    const auto foot = static_cast<std::size_t>(k - primary.front().column);
    golden::place const &left = primary[foot], &right = primary[foot + 1];
    const std::int64_t t = in.plane.mirrored ? -1 : 1, s = sub.backward ? -1 : 1;
    walked_strip strip{};
    strip.kind = {sub.backward == ((in.plane.a + 1) % 3 == in.plane.b),
                  in.plane.mirrored,
                  sub.backward,
                  sub.ends_on_edge && k + 1 == k1,
                  sub.pointed && k + 1 == k1,
                  ends,
                  k + 1 == k1,
                  k == k0 && sub.starts_at_corner,
                  k == k0,
                  false};
    strip.rows = hls::from_raw<format<2, 2, true>>(right.row - left.row);
    strip.to = hls::detail::two(sub.to);
    strip.left = border_of(left.vertex);
    strip.right = border_of(right.vertex);
    strip.left_s = grid_of(s * k);
    strip.right_s = grid_of(s * (k + 1));
    strip.left_t = grid_of(t * (left.row + 1));
    strip.right_t = grid_of(t * (right.row + 1));
    if (sub.ends_on_edge) {
      strip.upright = {hls::detail::two((sub.end_corner + 1) % 3 == sub.to ? sub.end_corner : sub.to),
                       upright.size() < 4 || upright[1].vertex.i < upright[2].vertex.i};
      strip.upright_n = hls::from_raw<formats::steps>(static_cast<std::int64_t>(upright.size()) - 1);
    }
    words.strips.push_back(strip);
  }

  // ---- what the kernel makes of them
  kernel.start(in_words);
  do {
    const int column = kernel.column();
    walked w{};
    w.sub_last = kernel.step(w.out);
    w.strip_last = w.sub_last || kernel.column() != column;
    w.last = w.sub_last && ends;
    words.out.push_back(w);
  } while (!words.out.back().sub_last);
}
void add_triangle(walk_words& words, grid_triangle const& p) {
  const hls::sweep_line_in corners = corners_of(p);
  const hls::sweep_setup setup = hls::set_up(corners);
  hls::sub_triangle_remeshing kernel;
  hls::sub_triangle_remeshing_in in;
  for (int i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis) in.p[i][axis] = corners.p[i][axis];
  in.plane = setup.plane;
  for (int i = 0; i < 2; ++i) {
    in.sub = setup.cases.sub[i];
    if (in.sub.valid) add_sub_triangle(words, kernel, in, i == 1 || !setup.cases.sub[1].valid);
  }
}
walk_words drawn(std::uint64_t triangles) {
  walk_words words;
  generator g = next_generator();
  for (std::uint64_t i = 0; i < triangles; ++i) {
    const std::uint64_t kind = g.below(8);
    add_triangle(words, kind < 4 ? pair_of(g.below(pairs_within(3)), 3) : kind < 6 ? draw_triangle(g, 12) : draw_sliver(g, 40));
  }
  return words;
}

void reset(clocked_model<Vside_walk>& m) {
  m->strip_valid_i = 0;
  m->edge_valid_i = 0;
  m->out_ready_i = 0;
  m.reset();
}

// A source or a sink that waits now and then, in sixteenths; clocks from the first word taken to the last one out. At the clock reset_at
// all that is inside is thrown away, and the words begin anew.
std::uint64_t walk(clocked_model<Vside_walk>& m, walk_words const& all, std::uint64_t idle, std::uint64_t stall,
                   std::uint64_t reset_at = 0) {
  generator g = next_generator();
  walk_words words = all;
  std::uint64_t clocks = 0, last = 0, first = 0, quiet = 0;
  bool strip_offered = false, vertex_offered = false, held = false, begun = false;
  walked held_out{};
  for (std::uint64_t after = 0; after < 50; after += words.out.empty() ? 1 : 0) {
    if (reset_at != 0 && clocks == reset_at) {
      reset(m);
      words = all;
      strip_offered = vertex_offered = held = begun = false;
    }
    strip_offered = strip_offered || (!words.strips.empty() && g.below(16) >= idle);
    vertex_offered = vertex_offered || (!words.vertices.empty() && g.below(16) >= idle);
    m->strip_valid_i = strip_offered;
    m->edge_valid_i = vertex_offered;
    m->out_ready_i = g.below(16) >= stall;
    walked_strip strip{};
    walked_vertex_word vertex{};
    draw_vector(strip, draw::uniform, g);
    draw_vector(vertex, draw::uniform, g);
    tb::put(m->strip_i, strip_offered ? words.strips.front() : strip);
    tb::put(m->edge_i, vertex_offered ? words.vertices.front() : vertex);
    m.settle();
    const auto said = [&] { return std::array<bool, 3>{m->strip_ready_o != 0, m->edge_ready_o != 0, m->out_valid_o != 0}; };
    const auto before = said();
    m->strip_valid_i = !strip_offered;
    m->edge_valid_i = !vertex_offered;
    m->out_ready_i = !m->out_ready_i;
    m.settle();
    if (said() != before) {
      ADD_FAILURE() << "a ready or a valid reaches another within the clock, clock " << clocks;
      return 0;
    }
    m->strip_valid_i = strip_offered;
    m->edge_valid_i = vertex_offered;
    m->out_ready_i = !m->out_ready_i;
    m.settle();

    quiet = held || words.out.empty() ? 0 : quiet + 1;
    if (m->out_valid_o) {
      const auto out = tb::get<walked>(m->out_o);
      const auto result =
          words.out.empty() ? testing::AssertionFailure() << "nothing more is expected" : same_names(out, words.out.front());
      if (!result || (held && !same_words(out, held_out))) {
        ADD_FAILURE() << "rtl against hls, clock " << clocks << ": " << (result ? "out changed while it was not taken" : result.message());
        return 0;
      }
      held_out = out;
      held = !m->out_ready_i;
      if (!held) {
        words.out.pop_front();
        last = clocks;
        quiet = 0;
      }
    } else if (held || quiet > 2000) {
      ADD_FAILURE() << (held ? "out_valid fell before the word was taken" : "nothing moved for 2,000 clocks") << ", clock " << clocks;
      return 0;
    }
    if (strip_offered && m->strip_ready_o) {
      words.strips.pop_front();
      strip_offered = false;
    }
    if (vertex_offered && m->edge_ready_o) {
      words.vertices.pop_front();
      vertex_offered = false;
      if (!begun) first = clocks;
      begun = true;
    }
    m.clock();
    ++clocks;
  }
  EXPECT_TRUE(words.strips.empty() && words.vertices.empty());
  return last - first + 1;
}

TEST(side_walk, rtl_equals_hls) {
  const walk_words words = drawn(rtl_vector_count() / 100 + 16);
  EXPECT_GT(words.strips.size(), rtl_vector_count() / 100);
  clocked_model<Vside_walk> m;
  reset(m);
  for (const std::uint64_t idle : {0, 7})
    for (const std::uint64_t stall : {0, 7}) walk(m, words, idle, stall);
}
TEST(side_walk, a_reset_in_the_middle) {
  clocked_model<Vside_walk> m;
  reset(m);
  for (std::uint64_t at = 5; at < 60; at += 3) walk(m, drawn(6), at % 2 == 0 ? 0 : 5, at % 4 < 2 ? 0 : 5, at);
}
TEST(side_walk, a_primitive_a_clock) {
  constexpr std::uint64_t latency = 11;
  clocked_model<Vside_walk> m;
  reset(m);
  for (const std::uint64_t triangles : {1, 2, 5, 1000}) {
    const walk_words words = drawn(triangles);
    EXPECT_EQ(walk(m, words, 0, 0), latency + words.out.size());
  }
}

}  // namespace
}  // namespace relievo::test

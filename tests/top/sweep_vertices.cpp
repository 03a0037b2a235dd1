// sweep_vertices: the entry point gives the primitives of one triangle a call with the data of their vertices, `last` with the last one.
#include <memory>

#include "tests/support/swept_data.hpp"
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

TEST(top_sweep_vertices, equals_the_unit) {
  const auto in = std::make_unique<hls::port<hls::sweep_line_in>>("in");
  const auto corners = std::make_unique<hls::port<hls::interpolants>>("corners");
  const auto out = std::make_unique<hls::port<hls::top::swept_vertices>>("out");
  generator g = next_generator();
  hls::sweep_line_of<hls::vertex_steps> walk;
  for (std::uint64_t round = 0; round < vector_count() / 1000; ++round) {
    const grid_triangle p = round == 0 ? grid_triangle{} : draw_triangle(g, round % 2 == 0 ? 4 : 30);
    const swept_triangle triangle = draw_swept(g, p);
    in->write(hls::pack(corners_of(p)));
    write_corners(*corners, triangle.in);
    relievo_sweep_vertices(*in, *corners, *out);
    ASSERT_TRUE(in->empty() && corners->empty());
    walk.start(corners_of(p), triangle.setup, hls::walk_data_of(triangle.in, hls::difference_vertices(triangle.in)));
    for (bool last = false; !last;) {
      hls::top::swept_vertices right{};
      last = right.last = walk.step(right.p, right.data);
      ASSERT_FALSE(out->empty()) << text_of(p);
      ASSERT_TRUE(same_words(hls::unpack<hls::top::swept_vertices>(out->read()), right)) << text_of(p);
    }
    ASSERT_TRUE(out->empty()) << text_of(p);
  }
}

}  // namespace
}  // namespace relievo::test

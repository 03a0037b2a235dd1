// sweep_line: the entry point gives the primitives of one triangle a call, `last` with the last one.
#include <memory>

#include "tests/support/remeshed_mesh.hpp"
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

TEST(top_sweep_line, equals_the_unit) {
  const auto in = std::make_unique<hls::port<hls::sweep_line_in>>("in");
  const auto out = std::make_unique<hls::port<hls::top::swept_primitive>>("out");
  generator g = next_generator();
  hls::sweep_line kernel;
  primitive_list list;
  for (std::uint64_t round = 0; round < vector_count() / 200; ++round) {
    const grid_triangle p = round == 0 ? grid_triangle{} : draw_triangle(g, round % 2 == 0 ? 4 : 30);
    remesh(kernel, p, list, remeshed_mesh(p).most_primitives());
    in->write(hls::pack(corners_of(p)));
    relievo_sweep_line(*in, *out);
    ASSERT_TRUE(in->empty());
    ASSERT_EQ(static_cast<std::size_t>(out->size()), list.size()) << text_of(p);
    for (std::size_t i = 0; i < list.size(); ++i) {
      const auto word = hls::unpack<hls::top::swept_primitive>(out->read());
      ASSERT_TRUE(same_words(word.p, list[i])) << text_of(p) << " primitive " << i;
      ASSERT_EQ(word.last, i + 1 == list.size()) << text_of(p);
    }
  }
}

}  // namespace
}  // namespace relievo::test

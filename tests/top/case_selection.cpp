// case_selection: the entry point gives the words of the unit.
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

TEST(top_case_selection, equals_the_unit) {
  for_vectors<hls::case_selection_in>(
      [](hls::case_selection_in& in, generator& g) {
        for (auto& corner : in.p)
          for (auto& x : corner)
            if (raw(x) == -32768) x = hls::from_raw<formats::grid>(-32767);
        const int s = static_cast<int>(g.below(3)), a = static_cast<int>(g.below(3));
        in.plane.s = hls::detail::two(s);
        in.plane.t = hls::detail::two(hls::detail::after(s));
        in.plane.a = hls::detail::two(a);
        in.plane.b = hls::detail::two(hls::detail::after(a));
        in.plane.c = hls::detail::two(hls::detail::after(hls::detail::after(a)));
      },
      [](auto const& v) { return same_words(through<hls::case_selection_out>(v, relievo_case_selection), hls::case_selection(v)); },
      port_vectors());
}

}  // namespace
}  // namespace relievo::test

#include "tb/model/units.hpp"

#include "golden/core/normalize.hpp"
#include "golden/core/quotient.hpp"
#include "golden/edge/calculate_new_n.hpp"
#include "golden/edge/calculate_new_p.hpp"
#include "golden/edge/calculate_new_u.hpp"
#include "golden/edge/highlight_test.hpp"
#include "golden/edge/normal_test.hpp"
#include "golden/edge/pass_or_tessellate.hpp"
#include "golden/edge/tex_coord_test.hpp"
#include "golden/edge/view_test.hpp"
#include "golden/surface/bump.hpp"
#include "golden/surface/displace.hpp"
#include "golden/surface/transform.hpp"
#include "golden/surface/transform_normal.hpp"
#include "hls/core/divide.hpp"
#include "hls/edge/calculate_new_n.hpp"
#include "hls/edge/calculate_new_u.hpp"
#include "hls/edge/highlight_test.hpp"
#include "hls/edge/normal_test.hpp"
#include "hls/edge/pass_or_tessellate.hpp"
#include "hls/edge/tex_coord_test.hpp"
#include "hls/edge/view_test.hpp"
#include "hls/surface/bump.hpp"
#include "hls/surface/displace.hpp"
#include "hls/surface/transform.hpp"
#include "hls/surface/transform_normal.hpp"
#include "hls/top/top.hpp"

namespace relievo::tb {

namespace {

using golden::rounded;

struct no_regs {
  template <class Visitor>
  void each_field(Visitor&&) {}
  template <class Visitor>
  void each_field(Visitor&&) const {}
};

// HIn and HRegs are the hls records, GIn and GRegs golden's; both functions take (in, regs).
template <class HIn, class HRegs, class GIn, class GRegs, class HlsFunction, class GoldenFunction>
pure_unit make_unit(char const* name, HlsFunction hls_function, GoldenFunction golden_function) {
  using hls_out = decltype(hls_function(HIn{}, HRegs{}));
  pure_unit unit;
  unit.name = name;
  unit.in = layout<HIn>();
  unit.regs = layout<HRegs>();
  unit.out = layout<hls_out>();
  unit.hls = [hls_function](pure_unit::words const& in, pure_unit::words const& regs) {
    HIn i{};
    HRegs r{};
    set_raw_words(i, in);
    set_raw_words(r, regs);
    return raw_words(hls_function(i, r));
  };
  unit.golden = [golden_function](pure_unit::words const& in, pure_unit::words const& regs) {
    HIn hi{};
    HRegs hr{};
    set_raw_words(hi, in);
    set_raw_words(hr, regs);
    GIn i{};
    GRegs r{};
    to_golden(hi, i);
    to_golden(hr, r);
    bool exact = true;
    pure_unit::words out = golden_words<hls_out>(golden_function(i, r), exact);
    if (!exact) out.push_back(0);  // a list of another length equals nothing
    return out;
  };
  return unit;
}

template <class HIn, class GIn, class HlsFunction, class GoldenFunction>
pure_unit make_unit_without_regs(char const* name, HlsFunction hls_function, GoldenFunction golden_function) {
  return make_unit<HIn, no_regs, GIn, no_regs>(
      name, [hls_function](HIn const& in, no_regs const&) { return hls_function(in); },
      [golden_function](GIn const& in, no_regs const&) { return golden_function(in); });
}

// The divider of hls/top; golden has the quotient alone, and what lies beyond every quotient where the denominator is zero.
struct golden_divide_in {
  double numerator = 0, denominator = 0;
  RELIEVO_FIELDS(numerator, denominator)
};
struct golden_divide_out {
  double quotient = 0;
  bool clipped = false;
  RELIEVO_FIELDS(quotient, clipped)
};
hls::top::divide_out divide_in_hls(hls::top::divide_in const& in) {
  hls::top::divide_out out{};
  out.quotient = hls::divide<formats::screen>(in.numerator, in.denominator, out.clipped);
  return out;
}
golden_divide_out divide_in_golden(golden_divide_in const& in) {
  golden_divide_out out;
  if (in.denominator == 0)
    out.quotient = rounded::at<formats::screen>(in.numerator < 0 ? -1e9 : 1e9, out.clipped);
  else
    out.quotient = golden::quotient<rounded, formats::screen, formats::depth::width>(in.numerator, in.denominator, out.clipped);
  return out;
}

std::vector<pure_unit> make_units() {
  std::vector<pure_unit> units;
  units.push_back(make_unit_without_regs<hls::top::divide_in, golden_divide_in>("divide", divide_in_hls, divide_in_golden));
  units.push_back(make_unit_without_regs<hls::normalize_in, golden::normalize_in>(
      "normalize", [](auto const& in) { return hls::normalize(in); }, [](auto const& in) { return golden::normalize<rounded>(in); }));
  units.push_back(make_unit<hls::displace_in, hls::displace_regs, golden::displace_in, golden::displace_regs>(
      "displace", [](auto const& in, auto const& regs) { return hls::displace(in, regs); },
      [](auto const& in, auto const& regs) { return golden::displace<rounded>(in, regs); }));
  units.push_back(make_unit_without_regs<hls::bump_in, golden::bump_in>(
      "bump", [](auto const& in) { return hls::bump(in); }, [](auto const& in) { return golden::bump<rounded>(in); }));
  units.push_back(make_unit<hls::transform_in, hls::transform_regs, golden::transform_in, golden::transform_regs>(
      "transform", [](auto const& in, auto const& regs) { return hls::transform(in, regs); },
      [](auto const& in, auto const& regs) { return golden::transform<rounded>(in, regs); }));
  units.push_back(
      make_unit<hls::transform_normal_in, hls::transform_normal_regs, golden::transform_normal_in, golden::transform_normal_regs>(
          "transform_normal", [](auto const& in, auto const& regs) { return hls::transform_normal(in, regs); },
          [](auto const& in, auto const& regs) { return golden::transform_normal<rounded>(in, regs); }));
  units.push_back(make_unit_without_regs<hls::calculate_new_p_in, golden::calculate_new_p_in>(
      "calculate_new_p", [](auto const& in) { return hls::calculate_new_p(in); },
      [](auto const& in) { return golden::calculate_new_p<rounded>(in); }));
  units.push_back(make_unit_without_regs<hls::calculate_new_u_in, golden::calculate_new_u_in>(
      "calculate_new_u", [](auto const& in) { return hls::calculate_new_u(in); },
      [](auto const& in) { return golden::calculate_new_u<rounded>(in); }));
  units.push_back(make_unit_without_regs<hls::calculate_new_n_in, golden::calculate_new_n_in>(
      "calculate_new_n", [](auto const& in) { return hls::calculate_new_n(in); },
      [](auto const& in) { return golden::calculate_new_n<rounded>(in); }));
  units.push_back(make_unit<hls::normal_test_in, hls::normal_test_regs, golden::normal_test_in, golden::normal_test_regs>(
      "normal_test", [](auto const& in, auto const& regs) { return hls::normal_test(in, regs); },
      [](auto const& in, auto const& regs) { return golden::normal_test<rounded>(in, regs); }));
  units.push_back(make_unit<hls::view_test_in, hls::view_test_regs, golden::view_test_in, golden::view_test_regs>(
      "view_test", [](auto const& in, auto const& regs) { return hls::view_test(in, regs); },
      [](auto const& in, auto const& regs) { return golden::view_test<rounded>(in, regs); }));
  units.push_back(make_unit_without_regs<hls::tex_coord_test_in, golden::tex_coord_test_in>(
      "tex_coord_test", [](auto const& in) { return hls::tex_coord_test(in); },
      [](auto const& in) { return golden::tex_coord_test<rounded>(in); }));
  units.push_back(make_unit<hls::highlight_test_in, hls::highlight_test_regs, golden::highlight_test_in, golden::highlight_test_regs>(
      "highlight_test", [](auto const& in, auto const& regs) { return hls::highlight_test(in, regs); },
      [](auto const& in, auto const& regs) { return golden::highlight_test<rounded>(in, regs); }));
  units.push_back(
      make_unit<hls::pass_or_tessellate_in, hls::pass_or_tessellate_regs, golden::pass_or_tessellate_in, golden::pass_or_tessellate_regs>(
          "pass_or_tessellate", [](auto const& in, auto const& regs) { return hls::pass_or_tessellate(in, regs); },
          [](auto const& in, auto const& regs) { return golden::pass_or_tessellate<rounded>(in, regs); }));
  return units;
}

}  // namespace

std::vector<pure_unit> const& pure_units() {
  static const std::vector<pure_unit> units = make_units();
  return units;
}

pure_unit const* find_unit(std::string const& name) {
  for (pure_unit const& unit : pure_units())
    if (unit.name == name) return &unit;
  return nullptr;
}

}  // namespace relievo::tb

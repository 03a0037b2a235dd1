#include <nlohmann/json.hpp>
#include <sstream>

#include "tb/analysis/check.hpp"

namespace relievo::tb {

void check_report::found(std::string const& kind, std::string const& where) {
  constexpr int per_kind = 3;
  if (kept_[kind]++ < per_kind) findings.push_back(kind + ": " + where);
}

nlohmann::json to_json(check_report const& r) {
  return {
      {"clean", r.clean()},
      {"watertight", r.watertight()},
      {"exact", r.exact},
      {"with_base", r.with_base},
      {"with_areas", r.with_areas},
      {"triangles", r.triangles},
      {"edges", {{"shared", r.shared_edges}, {"boundary", r.boundary_edges}, {"border", r.border_edges}, {"undecided", r.undecided_edges}}},
      {"cracks", {{"total", r.cracks()}, {"open", r.open_edges}, {"overused", r.overused_edges}, {"parted", r.parted}}},
      {"t_vertices", r.t_vertices},
      {"flips", r.flips},
      {"degenerate", r.degenerate},
      {"collapsed", r.collapsed},
      {"missing_area", r.missing_area},
      {"excess_area", r.excess_area},
      {"outside", r.outside},
      {"findings", r.findings},
      {"warnings", r.warnings}};
}

std::string to_text(check_report const& r) {
  std::ostringstream text;
  text << r.triangles << " triangles; " << (r.watertight() ? "watertight" : "NOT watertight");
  if (r.undecided_edges > 0) text << " as far as can be told";
  text << "\nedges: " << r.shared_edges << " shared, " << r.boundary_edges << " boundary, " << r.border_edges << " border";
  if (r.undecided_edges > 0) text << ", " << r.undecided_edges << " used once (boundary or hole: a base mesh would tell)";
  text << "\ncracks: " << r.cracks() << " (" << r.open_edges << " open, " << r.overused_edges << " overused, " << r.parted
       << " parted); T-vertices: " << r.t_vertices;
  if (r.with_areas) {
    text << "\nareas " << (r.exact ? "(exact)" : "(in U, within its rounding)") << ": " << r.flips << " flipped, ";
    if (r.exact) text << r.degenerate << " degenerate, ";
    text << r.missing_area << " base triangles with area missing, " << r.excess_area << " with too much";
    if (r.outside > 0) text << ", " << r.outside << " triangles outside";
  }
  if (r.collapsed > 0) text << "\ncollapsed to less than a word: " << r.collapsed << " triangles";
  for (auto const& finding : r.findings) text << "\n  " << finding;
  text << "\n";
  return text.str();
}

}  // namespace relievo::tb

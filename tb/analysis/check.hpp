// check: is a tessellated mesh whole?
//
//   edge      used exactly twice, once in each direction; or once where the base mesh has its boundary or a border
//   border    the base mesh's positions agree there but N, T or U don't (poles, folds, patches): displaced surfaces may part
//   crack     an edge used once inside (open), three or more times or twice in one direction (overused), or shared while its ends'
//             P, T, U, P' or N' differ (parted)
//   T-vertex  a vertex that lies inside an open edge
//   flip, degenerate, missing, excess   by areas inside each base triangle
//   collapsed a triangle with two corners of the same words: legal where a base triangle is only a few words wide; it is left out
//             of the topology by words, and reported
//
// check_output looks at a model's output. With barycentric weights (golden, ideal) everything is exact: vertices are told apart by
// their weights, topology and areas are integers, and vertices that should be one must agree in every word. Without them (rtl), and
// for files, vertices are told apart by their words and areas are taken in U within the bound that the rounding of U implies
// (check_words.hpp). A file without the base's help gets what can be said: edges used once are then boundary or hole, undecided, and a
// fold where N alone differs, which files don't hold, looks like a crack.
#pragma once
#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "golden/edge/triangle.hpp"
#include "golden/surface/map_regs.hpp"
#include "tb/host/mesh.hpp"
#include "tb/host/read_mesh.hpp"
#include "tb/host/scene.hpp"

namespace relievo::tb {

struct check_report {
  bool exact = false;      // barycentric weights were there
  bool with_base = false;  // boundary and borders are known
  bool with_areas = false;

  std::uint64_t triangles = 0;
  std::uint64_t shared_edges = 0;
  std::uint64_t boundary_edges = 0;
  std::uint64_t border_edges = 0;
  std::uint64_t undecided_edges = 0;  // used once, without a base to tell why

  std::uint64_t open_edges = 0;
  std::uint64_t overused_edges = 0;
  std::uint64_t parted = 0;  // edges, or vertices inside a base triangle
  std::uint64_t t_vertices = 0;

  std::uint64_t flips = 0;
  std::uint64_t degenerate = 0;  // no area in exact weights
  std::uint64_t collapsed = 0;
  std::uint64_t missing_area = 0;  // base triangles that are not covered whole
  std::uint64_t excess_area = 0;   // base triangles that are covered more than once
  std::uint64_t outside = 0;       // triangles that name no base triangle or leave it

  std::vector<std::string> findings;  // the first places of each kind
  std::vector<std::string> warnings;  // about the base mesh

  std::uint64_t cracks() const { return open_edges + overused_edges + parted; }
  bool watertight() const { return cracks() == 0 && t_vertices == 0; }
  bool clean() const { return watertight() && flips == 0 && degenerate == 0 && missing_area == 0 && excess_area == 0 && outside == 0; }

  // Keeps the text of the first few of each kind.
  void found(std::string const& kind, std::string const& where);

 private:
  std::map<std::string, int> kept_;
};

struct check_options {
  bool culled = false;           // triangles were culled on purpose: edges used once and missing area are no faults
  std::vector<bool> loose = {};  // the same for single base triangles (exact check alone); empty: for none
};

check_report check_output(std::vector<golden::triangle_out> const& out, std::vector<golden::triangle> const& base,
                          golden::map_regs const& map, check_options const& options = {});

// A file, alone, with the scene it was made from, or with its base mesh.
check_report check_file(loose_mesh const& file);
check_report check_file(loose_mesh const& file, scene const& made_from, check_options const& options = {});
check_report check_file(loose_mesh const& file, mesh const& base, check_options const& options = {});

// Positions at which vertices of a base mesh have different normals: the displaced surface parts there.
std::vector<std::string> base_warnings(std::vector<golden::triangle> const& base);
std::vector<std::string> base_warnings(mesh const& base);

nlohmann::json to_json(check_report const& report);
// Several lines for people; the warnings are left to the caller.
std::string to_text(check_report const& report);

}  // namespace relievo::tb

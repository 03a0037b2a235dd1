// print_packages: the SystemVerilog packages that follow from the C++ headers, so that no width and no record is written twice.
//   print_packages FOLDER    writes FOLDER/core/formats_pkg.sv from hls/core/formats.hpp, and the records of the units, as their headers
//                            declare them, into core/core_pkg.sv, surface/surface_pkg.sv, edge/edge_pkg.sv and sweep/sweep_pkg.sv
//   The committed files are compared with a fresh print by the test lint.packages. A packed struct begins at its top bit, so the fields
//   stand from last to first: the first field lies at bit 0, and a record's bits are those of hls/core/packed.hpp without its padding.
//   Formats of the same shape are one type in C++: a field has the format that its name ends with where there is one, else the
//   one of its shape that the package prefers, else the first.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <typeindex>
#include <vector>

#include "hls/core/normalize.hpp"
#include "hls/edge/engine_regs.hpp"
#include "hls/edge/get_triangle.hpp"
#include "hls/edge/tessellate.hpp"
#include "hls/edge/tex_coord_test.hpp"
#include "hls/surface/bump.hpp"
#include "hls/surface/normal_map.hpp"
#include "hls/surface/normal_sampler.hpp"
#include "hls/sweep/sweep_line.hpp"
#include "hls/top/top.hpp"

namespace relievo::tb {
namespace {

struct format_name {
  char const* name;
  int width, fraction;
  bool is_signed;
};
const std::vector<format_name> format_names = {
#define RELIEVO_FORMAT_NAME(name, width, integer_bits, is_signed) {#name, width, (width) - (integer_bits), is_signed},
    RELIEVO_FORMATS(RELIEVO_FORMAT_NAME)
#undef RELIEVO_FORMAT_NAME
};

// displace_in -> DisplaceIn
std::string camel_case(std::string const& name) {
  std::string out;
  bool upper = true;
  for (const char c : name) {
    if (c == '_') {
      upper = true;
      continue;
    }
    out += static_cast<char>(upper && c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
    upper = false;
  }
  return out;
}

// Names of fields that SystemVerilog keeps for itself: they get an underscore behind them.
bool is_keyword(std::string const& field) { return field == "edge"; }

template <class F>
std::string format_type(std::string const& field, std::vector<std::string> const& preferred) {
  format_name const* first = nullptr;
  for (format_name const& f : format_names) {
    if (f.width != F::width || f.fraction != F::fraction || f.is_signed != F::is_signed) continue;
    const std::string name = f.name;
    const bool ends_with_it =
        field.size() > name.size() && field.compare(field.size() - name.size() - 1, std::string::npos, "_" + name) == 0;
    if (field == name || ends_with_it) return name + "_t";
    if (std::find(preferred.begin(), preferred.end(), name) != preferred.end()) return name + "_t";
    if (first == nullptr) first = &f;
  }
  if (first != nullptr) return std::string(first->name) + "_t";
  return std::string("logic ") + (F::is_signed ? "signed " : "") + "[" + std::to_string(F::width - 1) + ":0]";
}

class package {
 public:
  explicit package(std::map<std::type_index, std::string>& known, std::vector<std::string> preferred = {})
      : known_(known), preferred_(std::move(preferred)) {}

  template <class Record>
  void record(std::string const& name) {
    std::vector<std::string> lines;
    const Record r{};
    r.each_field(
        [&](char const* field, auto const& x) { lines.push_back("    " + declaration(field, x) + (is_keyword(field) ? "_;\n" : ";\n")); });
    text_ << "\n  typedef struct packed {\n";
    for (std::size_t i = lines.size(); i-- > 0;) text_ << lines[i];
    text_ << "  } " << name << "_t;\n";
    known_[typeid(Record)] = name + "_t";
  }
  std::string text() const { return text_.str(); }

 private:
  template <class T>
  std::string declaration(std::string const& field, T const& x) const {
    return type(field, x) + " " + field;
  }
  template <class T, std::size_t N>
  std::string declaration(std::string const& field, T const (&x)[N]) const {
    return type(field, x) + " " + field;
  }
  std::string type(std::string const&, bool const&) const { return "logic"; }
  template <class F>
  std::string type(std::string const& field, hls::fixed<F> const&) const {
    return format_type<F>(field, preferred_);
  }
  template <class T>
  std::string type(std::string const&, T const& x) const {
    return known_.at(typeid(x));
  }
  template <class T, std::size_t N>
  std::string type(std::string const& field, T const (&x)[N]) const {
    const std::string element = type(field, x[0]);
    const std::string range = "[" + std::to_string(N - 1) + ":0]";
    // An array of arrays, or of words without a named format: the outer range comes first.
    const std::size_t inner = element.rfind(" [");
    if (inner != std::string::npos) return element.substr(0, inner) + " " + range + element.substr(inner + 1);
    return element + " " + range;
  }

  std::map<std::type_index, std::string>& known_;
  std::vector<std::string> preferred_;
  std::ostringstream text_;
};

constexpr char const* notice = "// Printed by tb/cosim/print_packages.cpp from the C++ headers; not to be edited.\n";

void write(std::string const& path, std::string const& text) {
  std::ofstream file(path);
  file << text;
  if (!file.flush()) {
    std::fprintf(stderr, "print_packages: %s: cannot be written\n", path.c_str());
    std::exit(2);
  }
}

std::string formats_package() {
  std::ostringstream text;
  text << "// formats_pkg: every fixed-point format, a type and its fraction bits.\n" << notice << "package formats_pkg;\n";
  for (format_name const& f : format_names) {
    text << "  typedef logic " << (f.is_signed ? "signed " : "");
    if (f.width > 1) text << "[" << f.width - 1 << ":0] ";
    text << f.name << "_t;\n  localparam int " << camel_case(f.name) << "Fraction = " << f.fraction << ";\n";
  }
  text << "\n  // The most intervals that a profile divides an edge into.\n  localparam int unsigned ProfileIntervalsMax = "
       << profile_intervals_max << ";\nendpackage\n";
  return text.str();
}

std::string records_package(std::string const& name, std::string const& says, std::string const& imports, package const& p) {
  return "// " + name + ": " + says + "\n" + notice + "package " + name + ";\n" + imports + p.text() + "endpackage\n";
}

void print(std::string const& folder) {
  std::map<std::type_index, std::string> known;
  write(folder + "/core/formats_pkg.sv", formats_package());

  package core(known);
  core.record<hls::normalize_in>("normalize_in");
  core.record<hls::normalize_out>("normalize_out");
  core.record<hls::top::divide_in>("divide_in");
  core.record<hls::top::divide_out>("divide_out");
  const std::string formats = "  import formats_pkg::*;\n";
  write(folder + "/core/core_pkg.sv", records_package("core_pkg", "records of the units of core", formats, core));

  package surface(known);
#define RELIEVO_RECORD(p, name) p.record<hls::name>(#name);
  RELIEVO_RECORD(surface, map_regs)
  RELIEVO_RECORD(surface, map_address_in)
  RELIEVO_RECORD(surface, map_address_out)
  RELIEVO_RECORD(surface, map_sampler_in)
  RELIEVO_RECORD(surface, map_sampler_out)
  RELIEVO_RECORD(surface, normal_sampler_in)
  RELIEVO_RECORD(surface, normal_sampler_out)
  RELIEVO_RECORD(surface, summed_area_lookup_in)
  RELIEVO_RECORD(surface, summed_area_lookup_out)
  RELIEVO_RECORD(surface, displace_in)
  RELIEVO_RECORD(surface, displace_regs)
  RELIEVO_RECORD(surface, displace_out)
  RELIEVO_RECORD(surface, bump_in)
  RELIEVO_RECORD(surface, bump_out)
  RELIEVO_RECORD(surface, transform_in)
  RELIEVO_RECORD(surface, transform_regs)
  RELIEVO_RECORD(surface, transform_out)
  RELIEVO_RECORD(surface, transform_normal_in)
  RELIEVO_RECORD(surface, transform_normal_regs)
  RELIEVO_RECORD(surface, transform_normal_out)
  RELIEVO_RECORD(surface, normal_map_regs)
  RELIEVO_RECORD(surface, normal_map_out)
  RELIEVO_RECORD(surface, vertex)
  write(folder + "/surface/surface_pkg.sv", records_package("surface_pkg", "records of the units of surface", formats, surface));

  package edge(known);
  RELIEVO_RECORD(edge, calculate_new_p_in)
  RELIEVO_RECORD(edge, calculate_new_p_out)
  RELIEVO_RECORD(edge, calculate_new_u_in)
  RELIEVO_RECORD(edge, calculate_new_u_out)
  RELIEVO_RECORD(edge, calculate_new_n_in)
  RELIEVO_RECORD(edge, calculate_new_n_out)
  RELIEVO_RECORD(edge, displace_vertex_in)
  RELIEVO_RECORD(edge, displace_vertex_out)
  RELIEVO_RECORD(edge, normal_test_in)
  RELIEVO_RECORD(edge, normal_test_regs)
  RELIEVO_RECORD(edge, normal_test_out)
  RELIEVO_RECORD(edge, summed_height_test_in)
  RELIEVO_RECORD(edge, summed_height_test_regs)
  RELIEVO_RECORD(edge, summed_height_test_out)
  RELIEVO_RECORD(edge, profile_test_in)
  RELIEVO_RECORD(edge, profile_test_regs)
  RELIEVO_RECORD(edge, profile_test_out)
  RELIEVO_RECORD(edge, view_test_in)
  RELIEVO_RECORD(edge, view_test_regs)
  RELIEVO_RECORD(edge, view_test_out)
  RELIEVO_RECORD(edge, tex_coord_test_in)
  RELIEVO_RECORD(edge, tex_coord_test_out)
  RELIEVO_RECORD(edge, highlight_test_in)
  RELIEVO_RECORD(edge, highlight_test_regs)
  RELIEVO_RECORD(edge, highlight_test_out)
  RELIEVO_RECORD(edge, pass_or_tessellate_in)
  RELIEVO_RECORD(edge, pass_or_tessellate_regs)
  RELIEVO_RECORD(edge, pass_or_tessellate_out)
  RELIEVO_RECORD(edge, triangle)
  RELIEVO_RECORD(edge, out_vertex)
  RELIEVO_RECORD(edge, triangle_out)
  RELIEVO_RECORD(edge, get_triangle_out)
  RELIEVO_RECORD(edge, tessellate_in)
  RELIEVO_RECORD(edge, tessellate_out)
  RELIEVO_RECORD(edge, triangle_queue_regs)
  RELIEVO_RECORD(edge, engine_regs)
  edge.record<hls::top::base_vertex>("base_vertex");
  edge.record<hls::top::base_triangle>("base_triangle");
  write(folder + "/edge/edge_pkg.sv",
        records_package("edge_pkg", "records of the units of edge", formats + "  import surface_pkg::*;\n", edge));

  package sweep(known, {"grid", "steps"});
  RELIEVO_RECORD(sweep, main_direction_in)
  RELIEVO_RECORD(sweep, main_direction_out)
  RELIEVO_RECORD(sweep, primary_edge_in)
  RELIEVO_RECORD(sweep, primary_edge_out)
  RELIEVO_RECORD(sweep, remeshing_plane_in)
  RELIEVO_RECORD(sweep, remeshing_plane_out)
  RELIEVO_RECORD(sweep, case_selection_in)
  RELIEVO_RECORD(sweep, sub_triangle)
  RELIEVO_RECORD(sweep, case_selection_out)
  RELIEVO_RECORD(sweep, sub_triangle_remeshing_in)
  RELIEVO_RECORD(sweep, sweep_line_in)
  RELIEVO_RECORD(sweep, remeshed_vertex)
  RELIEVO_RECORD(sweep, primitive)
#undef RELIEVO_RECORD
  write(folder + "/sweep/sweep_pkg.sv", records_package("sweep_pkg", "records of the units of sweep", formats, sweep));
}

}  // namespace
}  // namespace relievo::tb

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: print_packages FOLDER\n");
    return 2;
  }
  relievo::tb::print(argv[1]);
}

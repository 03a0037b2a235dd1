#include "tb/analysis/check_sweep.hpp"

#include "golden/sweep/sweep_line.hpp"

namespace relievo::tb {

namespace {

// Triangles that the walk of a piece has.
std::uint64_t triangles_of(golden::swept_piece const& piece) {
  std::uint64_t count = 0;
  for (golden::primitive const& walked : golden::sweep_line({{piece.p[0], piece.p[1], piece.p[2]}})) count += walked.quad ? 2 : 1;
  return count;
}

golden::triangle base_of(golden::swept_piece const& piece, std::size_t number) {
  golden::triangle t;
  for (int i = 0; i < 3; ++i) {
    t.v[i].p = piece.v[i].p;
    t.v[i].n = piece.v[i].n;
    t.v[i].t = piece.v[i].t;
    t.v[i].u = piece.v[i].u;
  }
  t.index = static_cast<double>(number);
  return t;
}

}  // namespace

check_report check_sweep(run_result const& run, golden::map_regs const& map) {
  sweep_result const& sweep = *run.sweep;
  std::vector<golden::triangle_out> out = run.triangles;
  std::vector<std::uint64_t> got(sweep.pieces.size(), 0);
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i].index = static_cast<double>(sweep.piece_of.at(i));
    ++got.at(sweep.piece_of[i]);
  }
  std::vector<golden::triangle> base;
  check_options options;
  std::uint64_t left_out = 0;
  for (std::size_t b = 0; b < sweep.pieces.size(); ++b) {
    base.push_back(base_of(sweep.pieces[b], b));
    const std::uint64_t walked = sweep.pieces[b].walked ? triangles_of(sweep.pieces[b]) : 0;
    options.loose.push_back(got[b] != walked || !sweep.pieces[b].walked);
    left_out += walked - got[b];
  }
  check_report report = check_output(out, base, map, options);
  if (left_out != sweep.count.counters.unseen) {
    ++report.missing_area;
    report.found("missing area", std::to_string(left_out) + " triangles are missing, of which the engine left " +
                                     std::to_string(sweep.count.counters.unseen) + " out");
  }
  return report;
}

}  // namespace relievo::tb

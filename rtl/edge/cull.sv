// cull: is a finished triangle dropped?
//   cull = regs.cull and the displaced normals of all three vertices point away from the eye
//   contract: hls/edge/pass_or_tessellate.hpp, function cull
//
//   in    away_i  of the three vertices
//   out   cull_o  the triangle is dropped
//
//   latency 0, initiation interval 1; combinational: one gate of four inputs, for use between registers
module cull
  import edge_pkg::*;
(
  input  pass_or_tessellate_regs_t regs_i,
  input  logic [2:0]               away_i,
  output logic                     cull_o
);
  assign cull_o = regs_i.cull && (&away_i);

  logic unused_regs;
  assign unused_regs = ^regs_i;
endmodule

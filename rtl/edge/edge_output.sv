// edge_output: puts finished triangles out, one record late so that the last of a mesh can say so.
//   clear_i  before a mesh;  over_i  nothing of the mesh will arrive any more
//   in       in_valid_i, in_ready_o, in_i   a finished triangle; it is dropped where cull says so
//   out      out_valid_o, out_ready_i, out_o
//            arrives_o, culled_o  a triangle goes on, or is dropped;  finish_o  the last record of the mesh is on its way;  empty_o  all
//            records were taken
//   contract: pass and finish of hls/edge/engine.hpp; a mesh of which all is culled gives one empty record
//
//   latency 3 from the triangle behind it, or from over_i; initiation interval 1. Registered: the record that is held, out and all that goes
//   with it; in_ready_o depends on the triangle at in_i, and on registers
//
//   in --[cull]--[held]--[stream_fifo]-- out
module edge_output
  import edge_pkg::*;
  import engine_pkg::*;
(
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic                     clear_i,
  input  pass_or_tessellate_regs_t regs_i,
  input  logic                     over_i,
  input  logic                     in_valid_i,
  output logic                     in_ready_o,
  input  triangle_t                in_i,
  output logic                     out_valid_o,
  input  logic                     out_ready_i,
  output triangle_out_t            out_o,
  output logic                     arrives_o,
  output logic                     culled_o,
  output logic                     finish_o,
  output logic                     empty_o
);
  logic cull_it, hold_ready, holding_q, write;
  logic [2:0] count;
  triangle_out_t held_q, word;
  cull i_cull (
    .away_i({in_i.v[2].away, in_i.v[1].away, in_i.v[0].away}),
    .regs_i,
    .cull_o(cull_it)
  );
  assign in_ready_o = !holding_q || hold_ready || cull_it;
  assign arrives_o = in_valid_i && in_ready_o && !cull_it;
  assign culled_o = in_valid_i && cull_it;
  assign finish_o = over_i && hold_ready;
  assign write = (arrives_o && holding_q) || finish_o;
  // Before its first triangle a mesh holds a record of zeros.
  always_comb begin
    word = held_q;
    word.empty = !holding_q;
    word.last = finish_o;
  end
  stream_fifo #(.T(triangle_out_t), .Depth(4)) i_out (
    .clk_i,
    .rst_ni,
    .in_valid_i(write),
    .in_ready_o(hold_ready),
    .in_i(word),
    .out_valid_o,
    .out_ready_i,
    .out_o,
    .count_o(count)
  );
  assign empty_o = count == '0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni || clear_i) begin
      holding_q <= 1'b0;
      held_q <= '0;
    end else if (arrives_o) begin
      holding_q <= 1'b1;
      held_q <= to_output(in_i);
    end
  end
endmodule

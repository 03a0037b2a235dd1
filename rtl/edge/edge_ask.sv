// edge_ask: what is asked of a triangle in this round: the edges that are not settled, or of a base triangle its vertices.
//   in    in_valid_i, in_ready_o, in_i
//   out   out_valid_o, out_ready_i, out_o  the triangle, its edges settled as get_triangle says, and what is asked
//   contract: get_triangle in step() of hls/edge/engine.hpp
//
//   latency 4, initiation interval 1; registered: all outputs; no path from out_ready_i to in_ready_o
//
//   in --+--[stream_fifo]----------------+-- out
//        +--[get_triangle]--[its FIFO]---+
module edge_ask
  import formats_pkg::*;
  import edge_pkg::*;
  import engine_pkg::*;
  import latency_pkg::*;
(
  input  logic        clk_i,
  input  logic        rst_ni,
  input  generation_t max_generation_i,
  input  logic        in_valid_i,
  output logic        in_ready_o,
  input  triangle_t   in_i,
  output logic        out_valid_o,
  input  logic        out_ready_i,
  output flight_t     out_o
);
  // The triangle waits beside what is found about it: both are taken in one clock and leave in one.
  localparam int unsigned Depth = GetTriangle + 5;
  triangle_t triangle;
  logic triangle_valid, leave, unused_ready;
  logic [$clog2(Depth+1)-1:0] unused_count;
  stream_fifo #(.T(triangle_t), .Depth(Depth)) i_triangle (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .in_i,
    .out_valid_o(triangle_valid),
    .out_ready_i(leave),
    .out_o(triangle),
    .count_o(unused_count)
  );
  get_triangle_out_t found, got;
  get_triangle i_get_triangle (.clk_i, .max_generation_i, .in_i, .out_o(found));
  stream_pipe #(.T(get_triangle_out_t), .Latency(GetTriangle), .Depth(Depth)) i_got (
    .clk_i,
    .rst_ni,
    .in_valid_i(in_valid_i && in_ready_o),
    .in_ready_o(unused_ready),
    .data_i(found),
    .out_valid_o,
    .out_ready_i,
    .out_o(got)
  );
  assign leave = out_valid_o && out_ready_i;

  always_comb begin
    out_o.t = triangle;
    out_o.t.settled = got.settled;
    out_o.place = |got.new_surface;
    out_o.ask = out_o.place ? 3'b111 : ~got.settled;
  end

  // The triangle is there a clock earlier; which normals are new makes no difference here.
  logic unused_triangle;
  assign unused_triangle = ^{triangle_valid, triangle.settled, got.new_normal};
endmodule

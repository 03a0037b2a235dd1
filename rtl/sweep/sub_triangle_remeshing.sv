// sub_triangle_remeshing: all primitives of a sub-triangle, strip after strip; the outer loop.
//   Gumhold & Huettner 1999, 3.4.4, Figures 14 and 15                contract: hls/sweep/sub_triangle_remeshing.hpp
//   in    in_valid_i, in_ready_o, in_i     corners, plane, sub-triangle; the main directions of the edges, which the set-up has; ends: no other
//                                          of the triangle follows. One that is not valid is the triangle of three equal corners.
//   out   out_valid_o, out_ready_i, out_o  as side_walk.sv
//
//   latency 21 to the first primitive, then one a clock, also from sub-triangle to sub-triangle: initiation interval its primitives.
//   What follows is set up while the one before is walked. Registered: all outputs, but for a gate behind out_o; no path from out_ready_i
//   to in_ready_o
//
//   in --[walk_frame]--[stream_fifo]--+--[walk_strips]--+--[side_walk]-- out
//                                     +--[walk_edges]---+
module sub_triangle_remeshing
  import walk_pkg::*;
(
  input  logic     clk_i,
  input  logic     rst_ni,
  input  logic     in_valid_i,
  output logic     in_ready_o,
  input  walk_in_t in_i,
  output logic     out_valid_o,
  input  logic     out_ready_i,
  output walked_t  out_o
);
  localparam int unsigned FrameLatency = 6;
  frame_t made, frame;
  logic frame_valid, frame_ready;
  walk_frame i_frame (.clk_i, .in_i, .out_o(made));
  stream_pipe #(.T(frame_t), .Latency(FrameLatency)) i_frames (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .data_i(made),
    .out_valid_o(frame_valid),
    .out_ready_i(frame_ready),
    .out_o(frame)
  );

  // Each takes the frame when it can.
  logic strips_ready, strips_have_q, edges_ready, edges_have_q;
  assign frame_ready = (strips_have_q || strips_ready) && (edges_have_q || edges_ready);
  always_ff @(posedge clk_i) begin
    if (!rst_ni || (frame_valid && frame_ready)) begin
      strips_have_q <= 1'b0;
      edges_have_q <= 1'b0;
    end else if (frame_valid) begin
      if (strips_ready) strips_have_q <= 1'b1;
      if (edges_ready) edges_have_q <= 1'b1;
    end
  end

  strip_t strip;
  edge_vertex_t vertex;
  logic strip_valid, strip_ready, vertex_valid, vertex_ready;
  walk_strips i_strips (
    .clk_i,
    .rst_ni,
    .in_valid_i(frame_valid && !strips_have_q),
    .in_ready_o(strips_ready),
    .in_i(frame),
    .out_valid_o(strip_valid),
    .out_ready_i(strip_ready),
    .out_o(strip)
  );
  walk_edges i_edges (
    .clk_i,
    .rst_ni,
    .in_valid_i(frame_valid && !edges_have_q),
    .in_ready_o(edges_ready),
    .in_i(frame),
    .out_valid_o(vertex_valid),
    .out_ready_i(vertex_ready),
    .out_o(vertex)
  );
  side_walk i_walk (
    .clk_i,
    .rst_ni,
    .strip_valid_i(strip_valid),
    .strip_ready_o(strip_ready),
    .strip_i(strip),
    .edge_valid_i(vertex_valid),
    .edge_ready_o(vertex_ready),
    .edge_i(vertex),
    .out_valid_o,
    .out_ready_i,
    .out_o
  );
endmodule

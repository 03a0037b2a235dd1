// sweep_line: all primitives of a triangle, in order.
//   Gumhold & Huettner 1999, 3.4, Figure 5 (the core of the remeshing), Figure 10      contract: hls/sweep/sweep_line.hpp
//   in    in_valid_i, in_ready_o, in_i     p, from -32767 to 32767
//   out   out_valid_o, out_ready_i, out_o  as side_walk.sv
//
//   latency 45 to the first primitive, then one a clock without a pause, also from triangle to triangle: initiation interval the triangle's
//   primitives. Triangles are set up while those before them are walked, 16 in flight. Registered: all outputs, but for a gate behind out_o;
//   no path from out_ready_i to in_ready_o
//
//   in --[main_direction x 3]--[primary_edge]--[remeshing_plane]--[case_selection]--[stream_fifo]--[sub_triangle_remeshing]-- out
module sweep_line
  import formats_pkg::*;
  import sweep_pkg::*;
  import walk_pkg::*;
(
  input  logic           clk_i,
  input  logic           rst_ni,
  input  logic           in_valid_i,
  output logic           in_ready_o,
  input  sweep_line_in_t in_i,
  output logic           out_valid_o,
  input  logic           out_ready_i,
  output walked_t        out_o
);
  localparam int unsigned MainLatency = 4;
  localparam int unsigned EdgeLatency = 3;
  localparam int unsigned PlaneLatency = 10;
  localparam int unsigned CaseLatency = 4;
  localparam int unsigned Latency = MainLatency + EdgeLatency + PlaneLatency + CaseLatency;

  // ---- the set-up
  typedef grid_t [2:0][2:0] corners_t;
  typedef main_direction_out_t [2:0] directions_t;
  corners_t main_p, edge_p, plane_p, case_p;
  directions_t main, edge_main, case_main;
  primary_edge_in_t edge_in;
  primary_edge_out_t primary;
  remeshing_plane_in_t plane_in;
  remeshing_plane_out_t plane, case_plane;
  case_selection_in_t case_in;
  case_selection_out_t cases;
  for (genvar i = 0; i < 3; i++) begin : gen_edge
    main_direction_in_t ends;
    assign ends.p = {in_i.p[(i+1)%3], in_i.p[i]};
    main_direction i_main (.clk_i, .in_i(ends), .out_o(main[i]));
    assign edge_in.axis[i] = main[i].axis;
    assign edge_in.n[i] = main[i].n;
  end
  delay #(.T(corners_t), .Stages(MainLatency)) i_main_p (.clk_i, .x_i(in_i.p), .y_o(main_p));
  assign edge_in.p = main_p;
  primary_edge i_edge (.clk_i, .in_i(edge_in), .out_o(primary));
  delay #(.T(corners_t), .Stages(EdgeLatency)) i_edge_p (.clk_i, .x_i(main_p), .y_o(edge_p));
  delay #(.T(directions_t), .Stages(EdgeLatency)) i_edge_main (
    .clk_i, .x_i(main), .y_o(edge_main)
  );
  assign plane_in = '{axis: edge_main[primary.edge_].axis, edge_: primary.edge_, p: edge_p};
  remeshing_plane i_plane (.clk_i, .in_i(plane_in), .out_o(plane));
  delay #(.T(corners_t), .Stages(PlaneLatency)) i_plane_p (.clk_i, .x_i(edge_p), .y_o(plane_p));
  assign case_in = '{plane: plane, p: plane_p};
  case_selection i_cases (.clk_i, .in_i(case_in), .out_o(cases));
  delay #(.T(corners_t), .Stages(CaseLatency)) i_case_p (.clk_i, .x_i(plane_p), .y_o(case_p));
  delay #(.T(remeshing_plane_out_t), .Stages(CaseLatency)) i_case_plane (
    .clk_i, .x_i(plane), .y_o(case_plane)
  );
  delay #(.T(directions_t), .Stages(PlaneLatency + CaseLatency)) i_case_main (
    .clk_i, .x_i(edge_main), .y_o(case_main)
  );

  // ---- its sub-triangles, one after the other; what nobody needs any more stays behind
  typedef struct packed {
    directions_t          main_;
    corners_t             p;
    remeshing_plane_out_t plane;
    sub_triangle_t [1:0]  sub;
  } set_up_t;
  set_up_t made, ready;
  logic set_up, second_q, two, sub_ready;
  always_comb begin
    made = '{main_: case_main, p: case_p, plane: case_plane, sub: cases.sub};
    // The walk finds its columns in the corners.
    made.plane.det = '0;
    made.plane.c = '0;
    for (int i = 0; i < 2; i++) begin
      made.sub[i].k0 = '0;
      made.sub[i].k1 = '0;
    end
  end
  stream_pipe #(.T(set_up_t), .Latency(Latency), .Depth(16)) i_set_up (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .data_i(made),
    .out_valid_o(set_up),
    .out_ready_i(sub_ready && (second_q || !two)),
    .out_o(ready)
  );
  walk_in_t sub;
  assign two = ready.sub[0].valid && ready.sub[1].valid;
  always_comb begin
    sub.main_ = ready.main_;
    sub.ends = second_q || !two;
    sub.sub.p = ready.p;
    sub.sub.plane = ready.plane;
    sub.sub.sub = second_q || !ready.sub[0].valid ? ready.sub[1] : ready.sub[0];
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) second_q <= 1'b0;
    else if (set_up && sub_ready) second_q <= two && !second_q;
  end
  sub_triangle_remeshing i_remeshing (
    .clk_i,
    .rst_ni,
    .in_valid_i(set_up),
    .in_ready_o(sub_ready),
    .in_i(sub),
    .out_valid_o,
    .out_ready_i,
    .out_o
  );
  logic unused_kind;
  assign unused_kind = ^cases.kind;
endmodule

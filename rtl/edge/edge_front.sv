// edge_front: what a lane asks of an edge before it reads a map: the middle in texture coordinates, vt, ct, the orientation by value and
// how many samples a profile of it takes.
//   contract: test_edge of hls/edge/engine.hpp, up to the tests that read memories
//
//   latency 6, initiation interval 1; registered: every unit's stages; a pure pipeline of calculate_new_u, view_test, tex_coord_test, vertex_order, profile_levels
//
//   a, b --[calculate_new_u 1/2]--+--[tex_coord_test]-- ct
//        --[view_test]-- vt       +-- u12
module edge_front
  import formats_pkg::*;
  import surface_pkg::*;
  import edge_pkg::*;
  import lane_pkg::*;
  import latency_pkg::*;
#(
  localparam int unsigned Latency = CalculateNewU + TexCoordTest
) (
  input  logic            clk_i,
  input  map_regs_t       map_i,
  input  view_test_regs_t regs_i,
  input  lane_in_t        in_i,
  output tested_t         out_o
);
  edge_end_t a, b;
  assign a = in_i.a;
  assign b = in_i.b;

  calculate_new_u_out_t s0_u12;
  calculate_new_u i_middle (.clk_i, .in_i('{k: 5'd8, u2: b.u, u1: a.u}), .out_o(s0_u12));

  coordinate_t [1:0] s0_u1, s0_u2;
  delay #(.T(coordinate_t [1:0]), .Stages(CalculateNewU)) i_u1 (.clk_i, .x_i(a.u), .y_o(s0_u1));
  delay #(.T(coordinate_t [1:0]), .Stages(CalculateNewU)) i_u2 (.clk_i, .x_i(b.u), .y_o(s0_u2));
  tex_coord_test_out_t s1_ct;
  tex_coord_test i_ct (.clk_i, .in_i('{u12: s0_u12.u, u2: s0_u2, u1: s0_u1}), .out_o(s1_ct));
  typedef struct packed {
    coordinate_t [1:0] u12;
    coordinate_t [1:0] u2;
    coordinate_t [1:0] u1;
  } coordinates_t;
  coordinates_t s1_u;
  delay #(.T(coordinates_t), .Stages(TexCoordTest)) i_u12 (
    .clk_i, .x_i('{u12: s0_u12.u, u2: s0_u2, u1: s0_u1}), .y_o(s1_u)
  );

  view_test_out_t s0_vt, s1_vt;
  view_test i_vt (
    .clk_i,
    .regs_i,
    .in_i('{behind2: b.behind, behind1: a.behind, screen2: b.screen, screen1: a.screen}),
    .out_o(s0_vt)
  );
  delay #(.T(view_test_out_t), .Stages(Latency - ViewTest)) i_vt_later (
    .clk_i, .x_i(s0_vt), .y_o(s1_vt)
  );

  logic s0_forward, s1_forward;
  vertex_order i_order (
    .clk_i,
    .map_i,
    .a_i('{u: a.u, t: a.t, n: a.n, p: a.p, default: '0}),
    .b_i('{u: b.u, t: b.t, n: b.n, p: b.p, default: '0}),
    .precedes_o(s0_forward)
  );
  delay #(.Stages(Latency - VertexOrder)) i_forward (.clk_i, .x_i(s0_forward), .y_o(s1_forward));

  logic              [2:0]  s0_levels, s1_levels;
  logic signed       [1:0][25:0] unused_extent;
  profile_levels i_levels (
    .clk_i, .u1_i(a.u), .u2_i(b.u), .levels_o(s0_levels), .extent_o(unused_extent)
  );
  delay #(.T(logic [2:0]), .Stages(Latency - ProfileLevels)) i_levels_later (
    .clk_i, .x_i(s0_levels), .y_o(s1_levels)
  );

  logic place;
  delay #(.Stages(Latency)) i_place (.clk_i, .x_i(in_i.place), .y_o(place));

  assign out_o = '{
      samples: s1_levels == '0 ? 5'd0 : (5'd1 << s1_levels) + 5'd1,
      forward: s1_forward,
      ct: s1_ct.ct,
      vt: s1_vt.vt,
      place: place,
      u12: s1_u.u12,
      u2: s1_u.u2,
      u1: s1_u.u1
  };
endmodule

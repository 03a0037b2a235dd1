// case_selection: the two sub-triangles of a triangle, one after the other, each walked so that its side edge climbs.
//   kind  0 point, 1 roof, 2 increasing, 3 decreasing                     Gumhold & Huettner 1999, 3.4.3, Figure 13
//   in    p      grid[3][3];  plane  from remeshing_plane
//   out   kind, sub[2]; a sub-triangle of no width is not valid, and all its fields are 0
//   contract: hls/sweep/case_selection.hpp; exact
//
//   latency 4, initiation interval 1; a pure pipeline: never stalls, no reset on data
//   registered: the corners along s and t, A, B and C among them, their order, the sub-triangles
//
//   p by axis --[s0]-- by corner --[s1]-- order --[s2]-- choose --[out]
module case_selection
  import formats_pkg::*;
  import sweep_pkg::*;
(
  input  logic                clk_i,
  input  case_selection_in_t  in_i,
  output case_selection_out_t out_o
);
  typedef struct packed {
    logic [1:0] c;
    logic [1:0] b;
    logic [1:0] a;
  } corners_t;

  grid_t [2:0] s0_s_q, s0_t_q;
  logic [1:0] s0_same_q;
  logic s0_mirrored_q, s1_mirrored_q;
  corners_t s0_corners_q, s1_corners_q, s2_corners_q;
  always_ff @(posedge clk_i) begin
    for (int corner = 0; corner < 3; corner++) begin
      s0_s_q[corner] <= in_i.p[corner][in_i.plane.s];
      s0_t_q[corner] <= in_i.p[corner][in_i.plane.t];
    end
    s0_same_q <= {in_i.p[2] == in_i.p[0], in_i.p[1] == in_i.p[0]};
    s0_corners_q <= '{c: in_i.plane.c, b: in_i.plane.b, a: in_i.plane.a};
    s0_mirrored_q <= in_i.plane.mirrored;
    s1_mirrored_q <= s0_mirrored_q;
    s1_corners_q <= s0_corners_q;
    s2_corners_q <= s1_corners_q;
  end
  logic unused_det;
  assign unused_det = ^in_i.plane.det;

  // Along s: A, B, C; along t likewise.
  grid_t s1_a_s_q, s1_b_s_q, s1_c_s_q, s1_a_t_q, s1_b_t_q, s1_c_t_q;
  logic s1_same_q;
  always_ff @(posedge clk_i) begin
    s1_a_s_q <= s0_s_q[s0_corners_q.a];
    s1_b_s_q <= s0_s_q[s0_corners_q.b];
    s1_c_s_q <= s0_s_q[s0_corners_q.c];
    s1_a_t_q <= s0_t_q[s0_corners_q.a];
    s1_b_t_q <= s0_t_q[s0_corners_q.b];
    s1_c_t_q <= s0_t_q[s0_corners_q.c];
    s1_same_q <= &s0_same_q;
  end

  // t' of A is not above that of C; t' of C is below that of B; C stands over A, over B.
  logic s2_a_below_c_q, s2_c_below_b_q, s2_over_a_q, s2_over_b_q, s2_same_q;
  grid_t s2_a_s_q, s2_b_s_q, s2_c_s_q, s2_a_back_q, s2_b_back_q, s2_c_back_q;
  always_ff @(posedge clk_i) begin
    s2_a_below_c_q <= s1_mirrored_q ? s1_a_t_q >= s1_c_t_q : s1_a_t_q <= s1_c_t_q;
    s2_c_below_b_q <= s1_mirrored_q ? s1_c_t_q > s1_b_t_q : s1_c_t_q < s1_b_t_q;
    s2_over_a_q <= s1_a_s_q == s1_c_s_q;
    s2_over_b_q <= s1_b_s_q == s1_c_s_q;
    s2_same_q <= s1_same_q;
    s2_a_s_q <= s1_a_s_q;
    s2_b_s_q <= s1_b_s_q;
    s2_c_s_q <= s1_c_s_q;
    s2_a_back_q <= -s1_a_s_q;
    s2_b_back_q <= -s1_b_s_q;
    s2_c_back_q <= -s1_c_s_q;
  end

  sub_triangle_t roof_ahead, roof_back, first, second;
  logic backward, vertical;
  assign backward = !s2_a_below_c_q;
  assign vertical = backward ? s2_over_b_q : s2_over_a_q;
  always_comb begin
    // A -> C, and B -> C with s' = -s; one without width ends on a vertical side edge of the other.
    roof_ahead = '0;
    roof_ahead.valid = 1'b1;
    roof_ahead.k0 = s2_a_s_q;
    roof_ahead.k1 = s2_c_s_q;
    roof_ahead.from = s2_corners_q.a;
    roof_ahead.to = s2_corners_q.c;
    roof_ahead.starts_at_corner = 1'b1;
    roof_ahead.ends_on_edge = s2_over_b_q;
    roof_ahead.end_corner = s2_over_b_q ? s2_corners_q.b : 2'd0;
    roof_back = '0;
    roof_back.valid = 1'b1;
    roof_back.backward = 1'b1;
    roof_back.k0 = s2_b_back_q;
    roof_back.k1 = s2_c_back_q;
    roof_back.from = s2_corners_q.b;
    roof_back.to = s2_corners_q.c;
    roof_back.starts_at_corner = 1'b1;
    roof_back.ends_on_edge = s2_over_a_q;
    roof_back.end_corner = s2_over_a_q ? s2_corners_q.a : 2'd0;
    // To the line s = C.s, and on from it; decreasing: from B, with s' = -s.
    first = '0;
    first.valid = 1'b1;
    first.backward = backward;
    first.k0 = backward ? s2_b_back_q : s2_a_s_q;
    first.k1 = backward ? s2_c_back_q : s2_c_s_q;
    first.from = backward ? s2_corners_q.b : s2_corners_q.a;
    first.to = s2_corners_q.c;
    first.starts_at_corner = 1'b1;
    second = '0;
    second.valid = 1'b1;
    second.backward = backward;
    second.k0 = backward ? s2_c_back_q : s2_c_s_q;
    second.k1 = backward ? s2_a_back_q : s2_b_s_q;
    second.from = s2_corners_q.c;
    second.to = backward ? s2_corners_q.a : s2_corners_q.b;
    second.starts_at_corner = vertical;
    second.pointed = 1'b1;
    second.corner_list = vertical;
  end

  always_ff @(posedge clk_i) begin
    if (s2_same_q) begin
      out_o <= '0;
    end else if (s2_a_below_c_q && !s2_c_below_b_q) begin
      out_o.kind <= 2'd1;
      out_o.sub[0] <= s2_over_a_q ? '0 : roof_ahead;
      out_o.sub[1] <= s2_over_b_q ? '0 : roof_back;
    end else begin
      out_o.kind <= backward ? 2'd3 : 2'd2;
      out_o.sub[0] <= vertical ? '0 : first;
      out_o.sub[1] <= second;
    end
  end
endmodule

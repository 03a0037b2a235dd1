// remeshing_plane: the coordinate plane in which a triangle is remeshed, and its corners by their part in the sweep.
//   s        sweep direction: the main direction of the primary edge AB; A is its end with the lower s
//   t        side direction: the other axis with the larger |det|, the earlier one on ties     Gumhold & Huettner 1999, 3.4.1, Figure 10
//   det      (B - A) x (C - A) in (s, t), twice the area of the projection
//   mirrored t' = -t where det < 0, else t
//   in    p     grid[3][3];  edge, axis  the primary edge and its main direction
//   out   s, t;  a, b, c  corners;  det  signed, 35 bits;  mirrored
//   contract: hls/sweep/remeshing_plane.hpp; exact
//
//   latency 10, initiation interval 1; a pure pipeline: never stalls, no reset on data
//   registered: corners by their place at the edge, then by axis, A and B, differences, two stages of products, determinants, their
//   magnitudes, which is larger, the choice
//
//   p by corner --[s0]-- by axis --[s1]-- A, B --[s2]-- - --[s3]-- x --[s4, s5]-- - --[s6_det]-- || --[s7]-- larger --[s8]-- choose --[out]
module remeshing_plane
  import formats_pkg::*;
  import sweep_pkg::*;
(
  input  logic                 clk_i,
  input  remeshing_plane_in_t  in_i,
  output remeshing_plane_out_t out_o
);
  function automatic logic [1:0] after(logic [1:0] corner);
    after = corner == 2'd2 ? 2'd0 : corner + 2'd1;
  endfunction
  // The other axes, in order.
  function automatic logic [1:0] earlier(logic [1:0] s);
    earlier = s == 2'd0 ? 2'd1 : 2'd0;
  endfunction
  function automatic logic [1:0] later(logic [1:0] s);
    later = s == 2'd2 ? 2'd1 : 2'd2;
  endfunction

  // Ends of the edge, and the corner opposite.
  grid_t [2:0] s0_first_q, s0_second_q, s0_c_q;
  logic [1:0] s0_s_q, s0_edge_q;
  always_ff @(posedge clk_i) begin
    s0_first_q <= in_i.p[in_i.edge_];
    s0_second_q <= in_i.p[after(in_i.edge_)];
    s0_c_q <= in_i.p[after(after(in_i.edge_))];
    s0_s_q <= in_i.axis;
    s0_edge_q <= in_i.edge_;
  end

  // Along s, and along the earlier and the later one of the others.
  typedef struct packed {
    grid_t       s;
    grid_t [1:0] t;
  } place_t;
  function automatic place_t along(grid_t [2:0] corner, logic [1:0] s);
    along = '{s: corner[s], t: {corner[later(s)], corner[earlier(s)]}};
  endfunction
  place_t s1_first_q, s1_second_q, s1_c_q;
  always_ff @(posedge clk_i) begin
    s1_first_q <= along(s0_first_q, s0_s_q);
    s1_second_q <= along(s0_second_q, s0_s_q);
    s1_c_q <= along(s0_c_q, s0_s_q);
  end

  place_t s2_a_q, s2_b_q, s2_c_q;
  logic rising, s2_rising_q;
  assign rising = signed'(s1_first_q.s) <= signed'(s1_second_q.s);
  always_ff @(posedge clk_i) begin
    s2_rising_q <= rising;
    s2_a_q <= rising ? s1_first_q : s1_second_q;
    s2_b_q <= rising ? s1_second_q : s1_first_q;
    s2_c_q <= s1_c_q;
  end

  function automatic logic signed [16:0] difference(grid_t to, grid_t from);
    difference = 17'(to) - 17'(from);
  endfunction
  logic signed [16:0] s3_b_s_q, s3_c_s_q;
  always_ff @(posedge clk_i) begin
    s3_b_s_q <= difference(s2_b_q.s, s2_a_q.s);
    s3_c_s_q <= difference(s2_c_q.s, s2_a_q.s);
  end
  logic signed [1:0][34:0] s6_det_q, s8_det_q;
  logic [1:0][33:0] s7_magnitude_q;
  for (genvar t = 0; t < 2; t++) begin : gen_plane
    logic signed [16:0] s3_b_t_q, s3_c_t_q;
    logic signed [33:0] s5_forward, s5_back;
    logic signed [34:0] s7_det_q;
    always_ff @(posedge clk_i) begin
      s3_b_t_q <= difference(s2_b_q.t[t], s2_a_q.t[t]);
      s3_c_t_q <= difference(s2_c_q.t[t], s2_a_q.t[t]);
    end
    multiply #(.A(17), .B(17)) i_forward (
      .clk_i, .a_i(s3_b_s_q), .b_i(s3_c_t_q), .y_o(s5_forward)
    );
    multiply #(.A(17), .B(17)) i_back (.clk_i, .a_i(s3_b_t_q), .b_i(s3_c_s_q), .y_o(s5_back));
    logic signed [34:0] det;
    assign det = s6_det_q[t];
    always_ff @(posedge clk_i) begin
      s6_det_q[t] <= 35'(s5_forward) - 35'(s5_back);
      // Twice the area of a triangle in a square of 65535 x 65535 fits 33 bits.
      s7_magnitude_q[t] <= det[34] ? 34'(-det) : 34'(det);
      s7_det_q <= det;
      s8_det_q[t] <= s7_det_q;
    end
  end
  logic s8_later_q;
  always_ff @(posedge clk_i) s8_later_q <= s7_magnitude_q[1] > s7_magnitude_q[0];

  // What only travels.
  logic [1:0] s8_s, s8_edge;
  logic       s8_rising;
  delay #(.T(logic [3:0]), .Stages(8)) i_edge (
    .clk_i, .x_i({s0_s_q, s0_edge_q}), .y_o({s8_s, s8_edge})
  );
  delay #(.Stages(6)) i_rising (.clk_i, .x_i(s2_rising_q), .y_o(s8_rising));

  always_ff @(posedge clk_i) begin
    out_o.s <= s8_s;
    out_o.t <= s8_later_q ? later(s8_s) : earlier(s8_s);
    out_o.a <= s8_rising ? s8_edge : after(s8_edge);
    out_o.b <= s8_rising ? after(s8_edge) : s8_edge;
    out_o.c <= after(after(s8_edge));
    out_o.det <= s8_det_q[s8_later_q];
    out_o.mirrored <= s8_det_q[s8_later_q][34];
  end
endmodule

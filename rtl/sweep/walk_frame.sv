// walk_frame: what the walk of a sub-triangle adds and counts, from its corners.
//   rows and columns in the frame (s', t'); of each edge 2 delta, n, and whether it is walked from its canonical end; the first step of
//   a side edge, so that a list can begin with its second vertex
//   in    in_i   corners, plane and sub as hls/sweep/sub_triangle_remeshing.hpp; main directions of the edges
//   out   out_o
//
//   latency 6, initiation interval 1; a pure pipeline: never stalls, no reset on data
//   registered: corners by axis, in the frame and the edges' directions, by their part, differences, first steps, the choice
//
//   p --[s0]-- +- --[s1]-- by part --[s2]-- - --[s3]-- first step --[s4]-- choose --[out]
module walk_frame
  import formats_pkg::*;
  import sweep_pkg::*;
  import walk_pkg::*;
(
  input  logic     clk_i,
  input  walk_in_t in_i,
  output frame_t   out_o
);
  function automatic logic [1:0] after(logic [1:0] corner);
    after = corner == 2'd2 ? 2'd0 : corner + 2'd1;
  endfunction
  // The edge that joins two corners.
  function automatic logic [1:0] edge_of(logic [1:0] from, logic [1:0] to);
    edge_of = after(from) == to ? from : to;
  endfunction

  // ---- s0: along s and t, and along each edge's own axis
  grid_t [2:0] s0_s_q, s0_t_q, s0_low_q, s0_high_q;
  steps_t [2:0] s0_n_q;
  frame_t s0_q;
  logic s0_corner_list_q;
  logic [1:0] s0_end_corner_q;
  always_ff @(posedge clk_i) begin
    for (int c = 0; c < 3; c++) begin
      s0_s_q[c] <= in_i.sub.p[c][in_i.sub.plane.s];
      s0_t_q[c] <= in_i.sub.p[c][in_i.sub.plane.t];
      s0_low_q[c] <= in_i.sub.p[c][in_i.main_[c].axis];
      s0_high_q[c] <= in_i.sub.p[(c+1)%3][in_i.main_[c].axis];
      s0_n_q[c] <= in_i.main_[c].n;
    end
    s0_q <= '0;
    s0_q.ends <= in_i.ends;
    s0_q.point <= !in_i.sub.sub.valid;
    s0_q.backward <= in_i.sub.sub.backward;
    s0_q.mirrored <= in_i.sub.plane.mirrored;
    s0_q.pointed <= in_i.sub.sub.pointed;
    s0_q.ends_on_edge <= in_i.sub.sub.ends_on_edge;
    s0_q.from_corner <= in_i.sub.sub.starts_at_corner || !in_i.sub.sub.valid;
    s0_q.flip <= in_i.sub.sub.valid &&
                 in_i.sub.sub.backward == (after(in_i.sub.plane.a) == in_i.sub.plane.b);
    s0_q.start <= in_i.sub.sub.backward ? in_i.sub.plane.b : in_i.sub.plane.a;
    s0_q.goal <= in_i.sub.sub.backward ? in_i.sub.plane.a : in_i.sub.plane.b;
    s0_q.from <= in_i.sub.sub.from;
    s0_q.to <= in_i.sub.sub.valid ? in_i.sub.sub.to : 2'd2;
    s0_corner_list_q <= in_i.sub.sub.corner_list;
    s0_end_corner_q <= in_i.sub.sub.end_corner;
  end

  // ---- s1: in the frame; the edges
  grid_t [2:0] s1_s_q, s1_t_q, s1_column_q, s1_row_q;
  logic [2:0] s1_rising_q;
  steps_t [2:0] s1_n_q;
  frame_t s1_q;
  logic s1_corner_list_q;
  always_ff @(posedge clk_i) begin
    for (int c = 0; c < 3; c++) begin
      s1_column_q[c] <= s0_q.backward ? -signed'(s0_s_q[c]) : s0_s_q[c];
      s1_row_q[c] <= s0_q.mirrored ? -signed'(s0_t_q[c]) : s0_t_q[c];
      s1_rising_q[c] <= signed'(s0_low_q[c]) <= signed'(s0_high_q[c]);
    end
    s1_s_q <= s0_s_q;
    s1_t_q <= s0_t_q;
    s1_n_q <= s0_n_q;
    s1_q <= s0_q;
    s1_q.primary.number <= edge_of(s0_q.start, s0_q.goal);
    s1_q.side.number <= edge_of(s0_q.from, s0_q.to);
    s1_q.first.number <= edge_of(s0_q.start, s0_q.from);
    s1_q.upright.number <= edge_of(s0_end_corner_q, s0_q.to);
    // Whether these go from corner i to corner i + 1.
    s1_q.primary.rising <= after(s0_q.start) == s0_q.goal;
    s1_q.side.rising <= after(s0_q.from) == s0_q.to;
    s1_q.first.rising <= after(s0_q.start) == s0_q.from;
    s1_q.upright.rising <= after(s0_end_corner_q) == s0_q.to;
    s1_corner_list_q <= s0_corner_list_q;
  end

  // ---- s2: by their part. Two equal corners are one step apart.
  function automatic steps_t at_least_one(steps_t n);
    at_least_one = n == '0 ? 16'd1 : n;
  endfunction
  grid_t s2_from_column_q, s2_to_column_q, s2_start_column_q;
  grid_t s2_from_row_q, s2_to_row_q, s2_start_row_q, s2_goal_row_q;
  frame_t s2_q;
  logic s2_corner_list_q, s2_first_empty_q;
  always_ff @(posedge clk_i) begin
    s2_from_column_q <= s1_column_q[s1_q.from];
    s2_to_column_q <= s1_column_q[s1_q.to];
    s2_start_column_q <= s1_q.from_corner ? s1_column_q[s1_q.start] : s1_column_q[s1_q.from];
    s2_from_row_q <= s1_row_q[s1_q.from];
    s2_to_row_q <= s1_row_q[s1_q.to];
    s2_start_row_q <= s1_row_q[s1_q.start];
    s2_goal_row_q <= s1_row_q[s1_q.goal];
    s2_q <= s1_q;
    s2_q.s <= s1_s_q[s1_q.start];
    s2_q.t <= s1_t_q[s1_q.start];
    s2_q.primary_n <= s1_n_q[s1_q.primary.number];
    s2_q.side_n <= at_least_one(s1_n_q[s1_q.side.number]);
    s2_q.first_n <= s1_n_q[s1_q.first.number];
    s2_q.upright_n <= at_least_one(s1_n_q[s1_q.upright.number]);
    s2_q.primary.rising <= s1_q.primary.rising == s1_rising_q[s1_q.primary.number];
    s2_q.side.rising <= s1_q.side.rising == s1_rising_q[s1_q.side.number];
    s2_q.first.rising <= s1_q.first.rising == s1_rising_q[s1_q.first.number];
    s2_q.upright.rising <= s1_q.upright.rising == s1_rising_q[s1_q.upright.number];
    s2_corner_list_q <= s1_corner_list_q;
    s2_first_empty_q <= s1_n_q[s1_q.first.number] == '0;
  end

  // ---- s3: differences; those of a side edge are not negative
  function automatic logic [15:0] difference(grid_t to, grid_t from);
    difference = to - from;
  endfunction
  frame_t s3_q;
  logic s3_corner_list_q, s3_first_empty_q;
  logic signed [16:0] s3_primary_row;
  assign s3_primary_row = 17'(signed'(s2_goal_row_q)) - 17'(signed'(s2_start_row_q));
  always_ff @(posedge clk_i) begin
    s3_q <= s2_q;
    s3_q.width <= difference(s2_to_column_q, s2_start_column_q);
    s3_q.side_column <= {difference(s2_to_column_q, s2_from_column_q), 1'b0};
    s3_q.side_row <= {difference(s2_to_row_q, s2_from_row_q), 1'b0};
    s3_q.primary_row <= {s3_primary_row, 1'b0};
    s3_q.has_first <= s2_corner_list_q && s2_q.first_n > 16'd1;
    s3_corner_list_q <= s2_corner_list_q;
    s3_first_empty_q <= s2_first_empty_q;
  end

  // ---- s4: the first step from the corner: e = n + 2 delta, or 2 delta - n where that is not below 2 n
  frame_t s4_q;
  logic signed [17:0] s4_column_over_q, s4_row_over_q;
  logic [16:0] s4_column_on_q, s4_row_on_q;
  logic s4_corner_list_q, s4_first_empty_q, s4_one_q, s4_narrow_q;
  always_ff @(posedge clk_i) begin
    s4_column_over_q <= signed'({1'b0, s3_q.side_column}) - signed'({2'b0, s3_q.side_n});
    s4_row_over_q <= signed'({1'b0, s3_q.side_row}) - signed'({2'b0, s3_q.side_n});
    s4_column_on_q <= s3_q.side_column + {1'b0, s3_q.side_n};
    s4_row_on_q <= s3_q.side_row + {1'b0, s3_q.side_n};
    s4_one_q <= s3_q.side_n == 16'd1;
    s4_narrow_q <= s3_q.width == 16'd1;
    s4_corner_list_q <= s3_corner_list_q;
    s4_first_empty_q <= s3_first_empty_q;
    s4_q <= s3_q;
  end

  // ---- out
  logic column_step, row_step;
  assign column_step = !s4_column_over_q[17];
  assign row_step = !s4_row_over_q[17];
  always_ff @(posedge clk_i) begin
    out_o <= s4_q;
    if (s4_corner_list_q || !s4_q.from_corner) begin
      out_o.column_e <= {1'b0, s4_q.side_n};
      out_o.row_e <= {1'b0, s4_q.side_n};
      out_o.columns <= s4_q.width;
      out_o.from_zero <= 1'b1;
      out_o.only_end <= 1'b0;
      out_o.first_row <= !s4_first_empty_q;
      out_o.first_column <= 1'b0;
    end else begin
      out_o.column_e <= column_step ? s4_column_over_q[16:0] : s4_column_on_q;
      out_o.row_e <= row_step ? s4_row_over_q[16:0] : s4_row_on_q;
      out_o.columns <= s4_q.width - 16'(column_step);
      out_o.from_zero <= 1'b0;
      out_o.only_end <= s4_one_q;
      out_o.first_row <= row_step;
      out_o.first_column <= s4_one_q || (column_step && !s4_narrow_q);
    end
  end
  logic unused;
  assign unused = ^{in_i.sub.plane.det, in_i.sub.plane.c, in_i.sub.sub.k0, in_i.sub.sub.k1};
endmodule

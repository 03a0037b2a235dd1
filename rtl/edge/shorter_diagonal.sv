// shorter_diagonal: which diagonal of the quad a b p q is the shorter one, a-p or b-q, exact; of two that are equal, that of the vertex
// that precedes. Figure 6 of the paper, two splits; contract: hls/edge/tessellate.hpp
//
//   in    start_i  a_i, b_i, p_i, q_i are there; at most every third clock
//   out   first_o  a-p is taken
//
//   latency 9, initiation interval 3; never stalls; registered: every stage
//
//   The sign of |a-p|^2 - |b-q|^2 decides: with x = a-p and y = b-q it is the sum of (x-y)(x+y) over the axes, three products in the place
//   of six squares. They go one after the other through one multiplier: a quad has two new vertices, which took their clocks too.
//   in --[s0]--[s1_first, second]--[s2_less, more]--x--[s3_product]--(+)--[s4_sum]--[s5_first]
module shorter_diagonal
  import formats_pkg::*;
  import surface_pkg::*;
(
  input  logic      clk_i,
  input  map_regs_t map_i,
  input  logic      start_i,
  input  vertex_t   a_i,
  input  vertex_t   b_i,
  input  vertex_t   p_i,
  input  vertex_t   q_i,
  output logic      first_o
);
  // s0: the axis at the bottom is the one that goes. The order is asked for by a and b as they are a clock after start_i.
  position_t [2:0] s0_a_q, s0_b_q, s0_p_q, s0_q_q;
  vertex_t s0_a_order_q, s0_b_order_q, s0_a, s0_b;
  always_comb begin
    s0_a = s0_a_order_q;
    s0_b = s0_b_order_q;
    s0_a.p = s0_a_q;
    s0_b.p = s0_b_q;
  end
  always_ff @(posedge clk_i) begin
    s0_a_order_q <= a_i;
    s0_b_order_q <= b_i;
    s0_a_q <= start_i ? a_i.p : {position_t'(0), s0_a_q[2:1]};
    s0_b_q <= start_i ? b_i.p : {position_t'(0), s0_b_q[2:1]};
    s0_p_q <= start_i ? p_i.p : {position_t'(0), s0_p_q[2:1]};
    s0_q_q <= start_i ? q_i.p : {position_t'(0), s0_q_q[2:1]};
  end

  // s1 to s3: a product of two words of 26 bits has 52, three of them 54.
  logic signed [24:0] s1_first_q, s1_second_q;
  logic signed [25:0] s2_less_q, s2_more_q;
  logic signed [51:0] s3_product;
  always_ff @(posedge clk_i) begin
    s1_first_q  <= 25'(signed'(s0_a_q[0])) - 25'(signed'(s0_p_q[0]));
    s1_second_q <= 25'(signed'(s0_b_q[0])) - 25'(signed'(s0_q_q[0]));
    s2_less_q   <= 26'(s1_first_q) - 26'(s1_second_q);
    s2_more_q   <= 26'(s1_first_q) + 26'(s1_second_q);
  end
  multiply #(.A(26), .B(26)) i_product (
    .clk_i, .a_i(s2_less_q), .b_i(s2_more_q), .y_o(s3_product)
  );

  // s4: the sum begins anew with each quad.
  logic started;
  logic signed [53:0] s4_sum_q, so_far;
  delay #(.Stages(5)) i_started (.clk_i, .x_i(start_i), .y_o(started));
  assign so_far = started ? '0 : s4_sum_q;
  always_ff @(posedge clk_i) s4_sum_q <= so_far + 54'(s3_product);

  // s5
  logic precedes, s4_precedes;
  vertex_order i_order (
    .clk_i, .map_i, .a_i(s0_a), .b_i(s0_b), .precedes_o(precedes)
  );
  delay #(.Stages(5)) i_precedes (.clk_i, .x_i(precedes), .y_o(s4_precedes));
  always_ff @(posedge clk_i) first_o <= s4_sum_q[53] || (s4_sum_q == '0 && s4_precedes);

  // Of p and q only the places count; the order has those of a and b from the registers of the axes.
  logic unused_computed;
  assign unused_computed = ^{p_i, q_i, s0_a_order_q.p, s0_b_order_q.p};
endmodule

// primary_edge: the edge along which the sweep line moves.
//   primary   edge p1 p2 with main direction s is primary when min(p1.s, p2.s) <= p3.s <= max(p1.s, p2.s)
//   edge      the longest of them by n, the first on ties                 Gumhold & Huettner 1999, definition 2, theorem 1, 3.4.1
//   in    p     grid[3][3];  axis, n  of each edge, from main_direction; edge i joins p[i] and p[(i+1) mod 3]
//   out   edge  by theorem 1 there is one; 0 where axis and n are not those of the corners and no edge is primary
//   contract: hls/sweep/primary_edge.hpp; exact
//
//   latency 3, initiation interval 1; a pure pipeline: never stalls, no reset on data
//   registered: the corners on each edge's axis, their order and that of the lengths, the choice
//
//   p by axis --[s0]-- order --[s1]-- choose --[out]
module primary_edge
  import formats_pkg::*;
  import sweep_pkg::*;
(
  input  logic              clk_i,
  input  primary_edge_in_t  in_i,
  output primary_edge_out_t out_o
);
  steps_t [2:0] s0_n_q;
  always_ff @(posedge clk_i) s0_n_q <= in_i.n;

  logic [2:0] s1_primary_q;
  for (genvar edge_ = 0; edge_ < 3; edge_++) begin : gen_edge
    localparam int unsigned Next = (edge_ + 1) % 3;
    localparam int unsigned Third = (edge_ + 2) % 3;
    grid_t s0_p1_q, s0_p2_q, s0_p3_q;
    always_ff @(posedge clk_i) begin
      s0_p1_q <= in_i.p[edge_][in_i.axis[edge_]];
      s0_p2_q <= in_i.p[Next][in_i.axis[edge_]];
      s0_p3_q <= in_i.p[Third][in_i.axis[edge_]];
      s1_primary_q[edge_] <= (s0_p1_q <= s0_p3_q && s0_p3_q <= s0_p2_q) ||
                             (s0_p2_q <= s0_p3_q && s0_p3_q <= s0_p1_q);
    end
  end

  logic s1_1_above_0_q, s1_2_above_0_q, s1_2_above_1_q;
  always_ff @(posedge clk_i) begin
    s1_1_above_0_q <= s0_n_q[1] > s0_n_q[0];
    s1_2_above_0_q <= s0_n_q[2] > s0_n_q[0];
    s1_2_above_1_q <= s0_n_q[2] > s0_n_q[1];
  end

  logic take_1, take_2;
  assign take_1 = s1_primary_q[1] && (!s1_primary_q[0] || s1_1_above_0_q);
  assign take_2 = s1_primary_q[2] && (take_1 ? s1_2_above_1_q : !s1_primary_q[0] || s1_2_above_0_q);
  always_ff @(posedge clk_i) out_o.edge_ <= take_2 ? 2'd2 : take_1 ? 2'd1 : 2'd0;
endmodule

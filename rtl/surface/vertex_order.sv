// vertex_order: the one order by value, precedes(a, b).
//   lexicographic order of the words P, N, T, then v and u modulo the wrap
//   contract: hls/surface/vertex.hpp
//
//   in    a_i, b_i
//   out   precedes_o  a precedes b
//
//   latency 2, initiation interval 1; a pure pipeline: never stalls, no reset on data
//   registered: for each of the eleven words which of the two is less; the answer
//
//   No word is less in both, so the first word that differs decides exactly as the highest bit does in which two numbers differ: with
//   the words as bits, the first on top, a precedes b when the number of a's is the greater one. One carry chain of eleven bits.
module vertex_order
  import formats_pkg::*;
  import surface_pkg::*;
(
  input  logic      clk_i,
  input  map_regs_t map_i,
  input  vertex_t   a_i,
  input  vertex_t   b_i,
  output logic      precedes_o
);
  // s0: words 10..2 in order, p[0] first; v and u as they stand, and what the wrap makes of them.
  logic [10:2] s0_less_q, s0_greater_q;
  for (genvar i = 0; i < 3; i++) begin : gen_axis
    position_t pa, pb;
    unit_t     na, nb, ta, tb;
    assign pa = a_i.p[i];
    assign pb = b_i.p[i];
    assign na = a_i.n[i];
    assign nb = b_i.n[i];
    assign ta = a_i.t[i];
    assign tb = b_i.t[i];
    always_ff @(posedge clk_i) begin
      s0_less_q[10-i]    <= pa < pb;
      s0_greater_q[10-i] <= pa > pb;
      s0_less_q[7-i]     <= na < nb;
      s0_greater_q[7-i]  <= na > nb;
      s0_less_q[4-i]     <= ta < tb;
      s0_greater_q[4-i]  <= ta > tb;
    end
  end

  // A coordinate at the far end of an axis that wraps counts as zero.
  logic      [1:0] s1_less, s1_greater;
  map_size_t [1:0] size;
  logic      [1:0] wrap;
  assign size = {map_i.height, map_i.width};
  assign wrap = {map_i.wrap_v, map_i.wrap_u};
  for (genvar i = 0; i < 2; i++) begin : gen_coordinate
    coordinate_t [1:0] u;
    logic        [1:0] s0_seam_q, s0_some_q;
    logic              s0_u_less_q, s0_u_greater_q;
    assign u = {b_i.u[i], a_i.u[i]};
    always_ff @(posedge clk_i) begin
      s0_u_less_q    <= u[0] < u[1];
      s0_u_greater_q <= u[0] > u[1];
      for (int k = 0; k < 2; k++) begin
        s0_seam_q[k] <= wrap[i] && u[k] == {size[i], FractionFraction'(0)};
        s0_some_q[k] <= u[k] != '0;
      end
    end
    always_comb begin
      unique case (s0_seam_q)
        2'b00: {s1_less[i], s1_greater[i]} = {s0_u_less_q, s0_u_greater_q};
        2'b01: {s1_less[i], s1_greater[i]} = {s0_some_q[1], 1'b0};
        2'b10: {s1_less[i], s1_greater[i]} = {1'b0, s0_some_q[0]};
        default: {s1_less[i], s1_greater[i]} = 2'b00;
      endcase
    end
  end

  always_ff @(posedge clk_i) precedes_o <= {s0_less_q, s1_less} > {s0_greater_q, s1_greater};

  // What was computed of a vertex does not count.
  logic unused_computed;
  assign unused_computed = ^{a_i, b_i};
endmodule

// tex_coord_test: has the edge reached the resolution of the map?
//   ct = the integer texel pair of U12 is neither that of U1 nor that of U2
//   contract: hls/edge/tex_coord_test.hpp
//
//   latency 2, initiation interval 1; a pure pipeline: never stalls, no reset on data
//   registered: the four comparisons, the answer
module tex_coord_test
  import formats_pkg::*;
  import edge_pkg::*;
(
  input  logic                clk_i,
  input  tex_coord_test_in_t  in_i,
  output tex_coord_test_out_t out_o
);
  logic [1:0] s0_like_first_q, s0_like_second_q;
  for (genvar i = 0; i < 2; i++) begin : gen_axis
    coordinate_t u1, u2, u12;
    assign u1 = in_i.u1[i];
    assign u2 = in_i.u2[i];
    assign u12 = in_i.u12[i];
    always_ff @(posedge clk_i) begin
      s0_like_first_q[i]  <= u12[CoordinateFraction+:14] == u1[CoordinateFraction+:14];
      s0_like_second_q[i] <= u12[CoordinateFraction+:14] == u2[CoordinateFraction+:14];
    end
    logic unused_fractions;
    assign unused_fractions = ^{u1, u2, u12};
  end
  always_ff @(posedge clk_i) out_o.ct <= !(&s0_like_first_q) && !(&s0_like_second_q);
endmodule

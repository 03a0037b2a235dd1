// calculate_new_p: the point at k/16 of an edge; k = 8 is the paper's midpoint.
//   P12 = (P1 (16 - k) + P2 k) / 16          contract: hls/edge/calculate_new_p.hpp
//
//   latency 4, initiation interval 1; a pure pipeline: never stalls, no reset on data; registered: every stage and the output
module calculate_new_p
  import formats_pkg::*;
  import edge_pkg::*;
(
  input  logic                 clk_i,
  input  calculate_new_p_in_t  in_i,
  output calculate_new_p_out_t out_o
);
  for (genvar i = 0; i < 3; i++) begin : gen_axis
    position_t p;
    point_between #(.Width($bits(position_t))) i_p (
      .clk_i, .a_i(in_i.p1[i]), .b_i(in_i.p2[i]), .k_i(in_i.k), .y_o(p)
    );
    assign out_o.p[i] = p;
  end
endmodule

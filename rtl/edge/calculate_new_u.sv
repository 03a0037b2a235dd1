// calculate_new_u: the texture coordinate at k/16 of an edge; k = 8 is the paper's midpoint.
//   U12 = (U1 (16 - k) + U2 k) / 16          contract: hls/edge/calculate_new_u.hpp
//
//   latency 4, initiation interval 1; a pure pipeline: never stalls, no reset on data; registered: every stage and the output
module calculate_new_u
  import formats_pkg::*;
  import edge_pkg::*;
(
  input  logic                 clk_i,
  input  calculate_new_u_in_t  in_i,
  output calculate_new_u_out_t out_o
);
  for (genvar i = 0; i < 2; i++) begin : gen_axis
    coordinate_t u;
    point_between #(.Width($bits(coordinate_t)), .Signed(1'b0)) i_u (
      .clk_i, .a_i(in_i.u1[i]), .b_i(in_i.u2[i]), .k_i(in_i.k), .y_o(u)
    );
    assign out_o.u[i] = u;
  end
endmodule

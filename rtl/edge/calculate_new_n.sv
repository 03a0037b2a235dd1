// calculate_new_n: the unit vector at k/16 of an edge, for normals and tangents.
//   N12 = normalize((N1 (16 - k) + N2 k) / 16)          contract: hls/edge/calculate_new_n.hpp
//
//   latency 25, initiation interval 1; a pure pipeline: never stalls, no reset on data; registered: every stage and the output
//   16 multipliers, those of normalize
//
//   N1, N2, k --[s0_direction, twice the mean]--[normalize]-- n
module calculate_new_n
  import formats_pkg::*;
  import core_pkg::*;
  import edge_pkg::*;
(
  input  logic                 clk_i,
  input  calculate_new_n_in_t  in_i,
  output calculate_new_n_out_t out_o
);
  normalize_in_t s0_direction;
  for (genvar i = 0; i < 3; i++) begin : gen_axis
    // Twice a unit has 17 bits, a direction 18.
    logic signed [$bits(unit_t):0] v;
    point_between #(.Width($bits(unit_t)), .Drop(3)) i_v (
      .clk_i, .a_i(in_i.n1[i]), .b_i(in_i.n2[i]), .k_i(in_i.k), .y_o(v)
    );
    assign s0_direction.v[i] = $bits(direction_t)'(v);
  end
  delay #(.Stages(4)) i_tangent (
    .clk_i, .x_i(in_i.tangent), .y_o(s0_direction.tangent)
  );

  normalize_out_t s1_unit;
  normalize i_normalize (.clk_i, .in_i(s0_direction), .out_o(s1_unit));
  assign out_o.n = s1_unit.n;
  assign out_o.zero = s1_unit.zero;
endmodule

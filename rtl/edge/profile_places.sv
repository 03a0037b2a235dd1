// profile_places: the quads that a group of a profile's samples needs.
//   u_j = floor((16 u1 + k (u2 - u1) + 8) / 16), k = 16 j / n: calculate_new_u's weighted sum and rounding, u1 (16 - k) + u2 k, gathered
//   contract: hls/edge/profile_test.hpp, hls/edge/calculate_new_u.hpp, hls/surface/map_address.hpp
//   in    u1_i, extent_i (u2 - u1), levels_i (n = 2^levels), group_i   which samples: see place_multiple
//   out   address_o  for each lane;  wanted_o  the lane's sample is one of the profile
//
//   latency 7, initiation interval 1; a pure pipeline: never stalls, no reset on data; registered: every stage
//
//   extent --[<< 4 - levels]--[x 3]--[s2 terms]--[s3 j x]--+ 16 u1 + 8--[s4_u]--[map_address, 2]
module profile_places
  import formats_pkg::*;
  import surface_pkg::*;
#(
  parameter int unsigned SamplesPerClock = 1
) (
  input  logic                                    clk_i,
  input  map_regs_t                               map_i,
  input  coordinate_t      [1:0]                  u1_i,
  input  logic signed      [1:0][25:0]            extent_i,
  input  logic             [2:0]                  levels_i,
  input  logic             [4:0]                  group_i,
  output map_address_out_t [SamplesPerClock-1:0]  address_o,
  output logic             [SamplesPerClock-1:0]  wanted_o
);
  // In sixteenths of a coordinate's LSB: the extent is below 2^25, j / n at most 1.
  logic signed [29:0] s0_step_q [2], s1_step_q [2], s1_triple_q [2];
  for (genvar i = 0; i < 2; i++) begin : gen_axis
    always_ff @(posedge clk_i) begin
      s0_step_q[i] <= 30'(signed'(extent_i[i])) <<< (3'd4 - levels_i);
      s1_step_q[i] <= s0_step_q[i];
      s1_triple_q[i] <= s0_step_q[i] + (s0_step_q[i] <<< 1);
    end
  end

  logic [4:0] s1_group, s3_group, s5_group;
  delay #(.T(logic [4:0]), .Stages(2)) i_group_1 (.clk_i, .x_i(group_i), .y_o(s1_group));
  delay #(.T(logic [4:0]), .Stages(2)) i_group_3 (.clk_i, .x_i(s1_group), .y_o(s3_group));
  delay #(.T(logic [4:0]), .Stages(2)) i_group_5 (.clk_i, .x_i(s3_group), .y_o(s5_group));
  coordinate_t [1:0] s3_u1;
  logic signed [1:0][25:0] s3_extent;
  delay #(.T(coordinate_t [1:0]), .Stages(4)) i_u1 (.clk_i, .x_i(u1_i), .y_o(s3_u1));
  delay #(.T(logic [1:0][25:0]), .Stages(4)) i_extent (
    .clk_i, .x_i(extent_i), .y_o(s3_extent)
  );
  logic [2:0] s5_levels;
  delay #(.T(logic [2:0]), .Stages(6)) i_levels (.clk_i, .x_i(levels_i), .y_o(s5_levels));

  for (genvar l = 0; l < SamplesPerClock; l++) begin : gen_lane
    // The last end is sample 1: 16 (u2 - u1) from u1.
    logic s3_end;
    assign s3_end = SamplesPerClock == 1 ? s3_group == 5'd1 : l == 1 && s3_group == '0;
    map_address_in_t s4_address_q;
    for (genvar i = 0; i < 2; i++) begin : gen_u
      logic signed [29:0] s3_multiple, s3_offset, s4_sum;
      place_multiple #(.Width(30), .SamplesPerClock(SamplesPerClock), .Lane(l)) i_multiple (
        .clk_i,
        .x_i(s1_step_q[i]),
        .triple_i(s1_triple_q[i]),
        .group_i(s1_group),
        .y_o(s3_multiple)
      );
      assign s3_offset = s3_end ? {s3_extent[i], 4'b0} : s3_multiple;
      // Between 0 and 16 times the largest coordinate, so that the sum's sign is free.
      assign s4_sum = signed'({1'b0, s3_u1[i], 4'b1000}) + s3_offset;
      always_ff @(posedge clk_i) s4_address_q.u[i] <= s4_sum[28:4];
      logic unused_cut;
      assign unused_cut = ^{s4_sum[29], s4_sum[3:0]};
    end
    map_address i_address (.clk_i, .map_i, .in_i(s4_address_q), .out_o(address_o[l]));
    always_ff @(posedge clk_i) begin
      wanted_o[l] <= 6'(s5_group) * 6'(SamplesPerClock) + 6'(l) <= 6'd1 << s5_levels;
    end
  end
endmodule

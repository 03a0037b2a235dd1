// summed_area_sum: what the passes over a rectangle come to.
//   s = the sum over its passes of turns x their words, modulo 2^40; of a clipped rectangle round(s / kept) x full
//   contract: the second half of hls/surface/summed_area_lookup.hpp
//   parameter  Slots  rectangles that take turns, a clock each: 1, 2 .. Slots, then the next pass of the first
//   in    valid_i, first_i  a pass; of a rectangle the first
//         sum_i, weight_i   its words, and its turns
//         areas_i           of the last pass: the rectangle is clipped; texels on the map, and in all
//   out   s_o, area_o       the full area beside its sum
//
//   latency 29 from the last pass; initiation interval 1; a pure pipeline: never stalls, no reset on data. Registered: outputs, every stage
//
//   sum --x weight--[a4]--+-->[s1_sum]--+--/ kept--[s2_mean]--x full--+-->[s]
//                         +-----<-------+-----------------------------+
module summed_area_sum
  import formats_pkg::*;
  import memory_pkg::*;
#(
  parameter int unsigned Slots = 1
) (
  input  logic           clk_i,
  input  logic           valid_i,
  input  logic           first_i,
  input  table_sum_t     sum_i,
  input  logic [7:0]     weight_i,
  input  table_areas_t         areas_i,
  output rectangle_sum_t s_o,
  output area_t          area_o
);
  localparam int unsigned DivideLatency = 23;

  // a4: times the turns; modulo 2^40 it does not matter whether a sum is taken for signed.
  logic signed [48:0] a4_product;
  multiply #(.A(40), .B(9)) i_turns (
    .clk_i, .a_i(signed'(sum_i)), .b_i(signed'({1'b0, weight_i})), .y_o(a4_product)
  );

  // s1: the sum of the passes, the newest rectangle's in front; between two of them all hold.
  logic       a4_valid, a4_first;
  table_sum_t s1_sum_q[Slots];
  delay #(.T(logic [1:0]), .Stages(2)) i_valid (
    .clk_i, .x_i({valid_i, first_i}), .y_o({a4_valid, a4_first})
  );
  always_ff @(posedge clk_i) begin
    if (a4_valid) begin
      s1_sum_q[0] <= (a4_first ? '0 : s1_sum_q[Slots-1]) + a4_product[39:0];
      for (int s = 1; s < Slots; s++) s1_sum_q[s] <= s1_sum_q[s-1];
    end
  end

  // s2: the mean of what is on the map
  area_t   s1_kept, s2_full;
  sample_t s2_mean;
  logic    unused_saturated;
  delay #(.T(area_t), .Stages(3)) i_kept (.clk_i, .x_i(areas_i.kept), .y_o(s1_kept));
  divide #(.N(40), .NSigned(1'b0), .D(25), .Q(20), .QSigned(1'b0), .Shift(4)) i_mean (
    .clk_i,
    .num_i(s1_sum_q[0]),
    .den_i(s1_kept),
    .quotient_o(s2_mean),
    .clipped_o(unused_saturated)
  );

  // s: the sum itself, or the mean times the full area
  typedef struct packed {
    logic       clipped;
    table_sum_t sum;
  } whole_t;
  logic signed [46:0] s3_product;
  whole_t             s1_whole, s3_whole;
  area_t              s3_full;
  delay #(.T(area_t), .Stages(3 + DivideLatency)) i_full (
    .clk_i, .x_i(areas_i.full), .y_o(s2_full)
  );
  multiply #(.A(21), .B(26)) i_product (
    .clk_i, .a_i(signed'({1'b0, s2_mean})), .b_i(signed'({1'b0, s2_full})), .y_o(s3_product)
  );
  delay #(.Stages(3)) i_clipped (.clk_i, .x_i(areas_i.clipped), .y_o(s1_whole.clipped));
  assign s1_whole.sum = s1_sum_q[0];
  delay #(.T(whole_t), .Stages(DivideLatency + 2)) i_whole (
    .clk_i, .x_i(s1_whole), .y_o(s3_whole)
  );
  delay #(.T(area_t), .Stages(2)) i_area (.clk_i, .x_i(s2_full), .y_o(s3_full));
  always_ff @(posedge clk_i) begin
    s_o    <= s3_whole.clipped ? s3_product[44:0] : {1'b0, s3_whole.sum, 4'b0};
    area_o <= s3_full;
  end

  logic unused_top;
  assign unused_top = ^{a4_product[48:40], s3_product[46:45]};
endmodule

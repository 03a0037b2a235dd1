// summed_area_sum: what the words of a rectangle come to.
//   s = the sum over its beats of weight x signed words, modulo 2^40; of a clipped rectangle round(s / kept) x full
//   contract: the second half of hls/surface/summed_area_lookup.hpp
//   in    valid_i, first_i           a beat; of a rectangle the first
//         word_i, read_i             its words; those without read count as 0
//         negative_i                 with one word a beat its sign; four have the signs + - - +
//         weight_i                   turns
//         clipped_i, kept_i, full_i  of the last beat: the rectangle is clipped; texels on the map, and in all
//   out   s_o, area_o                full_i beside its sum
//
//   latency 31 from the last beat; initiation interval 1; a pure pipeline: never stalls, no reset on data. Registered: outputs, every stage
//
//   words --[a1]--[a2: signed sum]--x weight--[a4]--+-->[s1_sum]--+--/ kept--[s2_mean]--x full--+-->[s]
//                                                   +-----<-------+-----------------------------+
module summed_area_sum
  import formats_pkg::*;
#(
  parameter int unsigned ReadsPerClock = 4
) (
  input  logic                           clk_i,
  input  logic                           valid_i,
  input  logic                           first_i,
  input  table_sum_t [ReadsPerClock-1:0] word_i,
  input  logic       [ReadsPerClock-1:0] read_i,
  input  logic                           negative_i,
  input  logic       [7:0]               weight_i,
  input  logic                           clipped_i,
  input  area_t                          kept_i,
  input  area_t                          full_i,
  output rectangle_sum_t                 s_o,
  output area_t                          area_o
);
  localparam int unsigned DivideLatency = 23;

  // a1, a2: the words of a beat, with their signs
  table_sum_t                     a2_sum_q;
  table_sum_t [ReadsPerClock-1:0] word;
  for (genvar r = 0; r < ReadsPerClock; r++) begin : gen_word
    assign word[r] = word_i[r] & {40{read_i[r]}};
  end
  if (ReadsPerClock == 4) begin : gen_corners
    table_sum_t a1_high_q, a1_low_q;
    always_ff @(posedge clk_i) begin
      a1_high_q <= word[0] - word[1];
      a1_low_q  <= word[2] - word[3];
      a2_sum_q  <= a1_high_q - a1_low_q;
    end
    logic unused_negative;
    assign unused_negative = negative_i;
  end else begin : gen_corner
    table_sum_t a1_word_q;
    logic       a1_negative_q;
    always_ff @(posedge clk_i) begin
      a1_word_q     <= word[0];
      a1_negative_q <= negative_i;
      a2_sum_q      <= a1_negative_q ? -a1_word_q : a1_word_q;
    end
  end

  // a4: times the turns; modulo 2^40 it does not matter whether a sum is taken for signed.
  logic        [7:0]  a2_weight;
  logic signed [48:0] a4_product;
  delay #(.T(logic [7:0]), .Stages(2)) i_weight (.clk_i, .x_i(weight_i), .y_o(a2_weight));
  multiply #(.A(40), .B(9)) i_turns (
    .clk_i, .a_i(signed'(a2_sum_q)), .b_i(signed'({1'b0, a2_weight})), .y_o(a4_product)
  );

  // s1: the sum of the beats; between two of them it holds.
  logic       a4_valid, a4_first;
  table_sum_t s1_sum_q;
  delay #(.T(logic [1:0]), .Stages(4)) i_valid (
    .clk_i, .x_i({valid_i, first_i}), .y_o({a4_valid, a4_first})
  );
  always_ff @(posedge clk_i) begin
    if (a4_valid) s1_sum_q <= (a4_first ? '0 : s1_sum_q) + a4_product[39:0];
  end

  // s2: the mean of what is on the map
  area_t   s1_kept, s2_full;
  sample_t s2_mean;
  logic    unused_saturated;
  delay #(.T(area_t), .Stages(5)) i_kept (.clk_i, .x_i(kept_i), .y_o(s1_kept));
  divide #(.N(40), .NSigned(1'b0), .D(25), .Q(20), .QSigned(1'b0), .Shift(4)) i_mean (
    .clk_i,
    .num_i(s1_sum_q),
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
  delay #(.T(area_t), .Stages(5 + DivideLatency)) i_full (.clk_i, .x_i(full_i), .y_o(s2_full));
  multiply #(.A(21), .B(26)) i_product (
    .clk_i, .a_i(signed'({1'b0, s2_mean})), .b_i(signed'({1'b0, s2_full})), .y_o(s3_product)
  );
  delay #(.Stages(5)) i_clipped (.clk_i, .x_i(clipped_i), .y_o(s1_whole.clipped));
  assign s1_whole.sum = s1_sum_q;
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

// summed_area_words: the signed sum of the words that a pass over a rectangle's corners reads.
//   sum = word(high, high) - word(low, high) - word(high, low) + word(low, low), modulo 2^40; words without read count as 0
//   contract: the part of hls/surface/summed_area_lookup.hpp that reads
//   in    valid_i, begins_i  a beat; the first of its pass
//         word_i, read_i     its words;  negative_i  with one word a beat its sign; four have the signs + - - +
//   out   sum_o              holds until the next beat
//
//   latency 2 from the last beat of the pass; initiation interval 1 beat; a pure pipeline: never stalls, no reset on data.
//   Registered: the words, and their sum
module summed_area_words
  import formats_pkg::*;
#(
  parameter int unsigned ReadsPerClock = 4
) (
  input  logic                           clk_i,
  input  logic                           valid_i,
  input  logic                           begins_i,
  input  table_sum_t [ReadsPerClock-1:0] word_i,
  input  logic       [ReadsPerClock-1:0] read_i,
  input  logic                           negative_i,
  output table_sum_t                     sum_o
);
  table_sum_t [ReadsPerClock-1:0] word;
  for (genvar r = 0; r < ReadsPerClock; r++) begin : gen_word
    assign word[r] = word_i[r] & {40{read_i[r]}};
  end
  if (ReadsPerClock == 4) begin : gen_corners
    table_sum_t high_q, low_q;
    always_ff @(posedge clk_i) begin
      high_q <= word[0] - word[1];
      low_q  <= word[2] - word[3];
      sum_o  <= high_q - low_q;
    end
    logic unused_beat;
    assign unused_beat = ^{valid_i, begins_i, negative_i};
  end else begin : gen_corner
    table_sum_t word_q, so_far;
    logic       valid_q, begins_q, negative_q;
    assign so_far = begins_q ? '0 : sum_o;
    always_ff @(posedge clk_i) begin
      word_q     <= word[0];
      valid_q    <= valid_i;
      begins_q   <= begins_i;
      negative_q <= negative_i;
      if (valid_q) sum_o <= negative_q ? so_far - word_q : so_far + word_q;
    end
  end
endmodule

// multiply_rows: the low bits of the product of two unsigned words, from rows and adders: where a multiplier is a waste.
//   y = a b modulo 2^Y
//   in    a_i  A bits, a row for each;  b_i  B bits
//
//   latency log2(A) rounded up, initiation interval 1; registered: every level of the tree of adders, the last is the output
module multiply_rows #(
  parameter int unsigned A = 9,
  parameter int unsigned B = 32,
  parameter int unsigned Y = 32
) (
  input  logic         clk_i,
  input  logic [A-1:0] a_i,
  input  logic [B-1:0] b_i,
  output logic [Y-1:0] y_o
);
  localparam int unsigned Levels = $clog2(A);

  // Half as many words on every level; a last one without a partner is added to nothing.
  logic [Y-1:0] row[2**Levels];
  for (genvar i = 0; i < 2 ** Levels; i++) begin : gen_row
    if (i < A) begin : gen_bit
      assign row[i] = a_i[i] ? Y'(b_i) << i : '0;
    end else begin : gen_none
      assign row[i] = '0;
    end
  end
  for (genvar l = 0; l < Levels; l++) begin : gen_level
    localparam int unsigned Words = 2 ** (Levels - l - 1);
    logic [Y-1:0] word_q[Words];
    for (genvar i = 0; i < Words; i++) begin : gen_word
      if (l == 0) begin : gen_first
        always_ff @(posedge clk_i) word_q[i] <= row[2*i] + row[2*i+1];
      end else begin : gen_next
        always_ff @(posedge clk_i) begin
          word_q[i] <= gen_level[l-1].word_q[2*i] + gen_level[l-1].word_q[2*i+1];
        end
      end
    end
  end
  assign y_o = gen_level[Levels-1].word_q[0];
endmodule

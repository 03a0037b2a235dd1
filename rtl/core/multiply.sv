// multiply: the exact product of two signed words.
//   in    a_i  signed, A bits;  b_i  signed, B bits (an unsigned operand gets a zero bit on top)
//   out   y_o  signed, A + B bits
//
//   latency 2, initiation interval 1; registered: the partial products, and their sum. The operands come from registers.
//
//   Operands wider than 18 bits are cut into limbs of 17 bits, the highest signed, so that every partial product is one 18 x 18
//   multiplier that stands alone between two registers.
module multiply #(
  parameter int unsigned A = 18,
  parameter int unsigned B = 18
) (
  input  logic                  clk_i,
  input  logic signed [A-1:0]   a_i,
  input  logic signed [B-1:0]   b_i,
  output logic signed [A+B-1:0] y_o
);
  localparam int unsigned LimbsA = A <= 18 ? 1 : (A - 2) / 17 + 1;
  localparam int unsigned LimbsB = B <= 18 ? 1 : (B - 2) / 17 + 1;

  logic signed [A+B-1:0] partial_q [LimbsA][LimbsB];

  for (genvar i = 0; i < LimbsA; i++) begin : gen_a
    // The highest limb is what is left, with its sign; the others are 17 bits without one.
    localparam int unsigned WidthA = i == LimbsA - 1 ? A - 17 * i : 18;
    logic signed [WidthA-1:0] a;
    if (i == LimbsA - 1) begin : gen_top
      assign a = a_i[A-1:17*i];
    end else begin : gen_low
      assign a = {1'b0, a_i[17*i+:17]};
    end
    for (genvar j = 0; j < LimbsB; j++) begin : gen_b
      localparam int unsigned WidthB = j == LimbsB - 1 ? B - 17 * j : 18;
      logic signed [WidthB-1:0] b;
      if (j == LimbsB - 1) begin : gen_top
        assign b = b_i[B-1:17*j];
      end else begin : gen_low
        assign b = {1'b0, b_i[17*j+:17]};
      end
      logic signed [WidthA+WidthB-1:0] product;
      assign product = a * b;
      always_ff @(posedge clk_i) partial_q[i][j] <= (A + B)'(product) <<< (17 * (i + j));
    end
  end

  logic signed [A+B-1:0] sum;
  always_comb begin
    sum = '0;
    for (int i = 0; i < LimbsA; i++) begin
      for (int j = 0; j < LimbsB; j++) sum += partial_q[i][j];
    end
  end
  always_ff @(posedge clk_i) y_o <= sum;
endmodule

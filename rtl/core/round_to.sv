// round_to: round half up to a coarser fraction, then saturate: round_to of hls/core/fixed.hpp.
//   in    x_i        signed, In bits
//   out   y_o        floor(x / 2^Shift + 1/2), clipped to Out bits, signed or unsigned
//         clipped_o  it was clipped
//
//   latency 2, initiation interval 1; registered: the rounded word, and the clipped one
module round_to #(
  parameter int unsigned In = 24,
  parameter int unsigned Shift = 4,
  parameter int unsigned Out = 16,
  parameter bit Signed = 1'b1
) (
  input  logic                 clk_i,
  input  logic signed [In-1:0] x_i,
  output logic [Out-1:0]       y_o,
  output logic                 clipped_o
);
  // One bit more than the word needs for the carry of the half, and enough to hold the ends of the output.
  localparam int unsigned Kept = In - Shift + 1;
  localparam int unsigned Wide = (Kept > Out + 1 ? Kept : Out + 1) + 1;
  localparam logic signed [Wide-1:0] Top = Wide'((65'd1 << (Signed ? Out - 1 : Out)) - 65'd1);
  localparam logic signed [Wide-1:0] Bottom = Signed ? -Top - Wide'(1) : '0;

  logic signed [Wide-1:0] s0_rounded_q;
  if (Shift == 0) begin : gen_exact
    always_ff @(posedge clk_i) s0_rounded_q <= Wide'(x_i);
  end else begin : gen_half
    logic signed [In:0] sum;
    assign sum = (In + 1)'(x_i) + (In + 1)'(signed'({1'b0, 1'b1, {(Shift - 1) {1'b0}}}));
    always_ff @(posedge clk_i) s0_rounded_q <= Wide'(signed'(sum[In:Shift]));
    if (Shift > 1) begin : gen_cut
      logic unused_cut;
      assign unused_cut = ^sum[Shift-1:0];
    end else begin : gen_cut_one
      logic unused_cut;
      assign unused_cut = sum[0];
    end
  end

  always_ff @(posedge clk_i) begin
    clipped_o <= 1'b0;
    y_o <= s0_rounded_q[Out-1:0];
    if (s0_rounded_q > Top) begin
      clipped_o <= 1'b1;
      y_o <= Top[Out-1:0];
    end else if (s0_rounded_q < Bottom) begin
      clipped_o <= 1'b1;
      y_o <= Bottom[Out-1:0];
    end
  end
endmodule

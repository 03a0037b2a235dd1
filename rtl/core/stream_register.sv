// stream_register: cuts a valid/ready link in two: neither valid nor ready goes through it within a clock.
//   parameter  T
//   in    in_valid_i, in_ready_o, in_i
//   out   out_valid_o, out_ready_i, out_o
//
//   latency 1, initiation interval 1; all outputs registered. A second register holds the word that comes while the first can't leave.
module stream_register #(
  parameter type T = logic
) (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic in_valid_i,
  output logic in_ready_o,
  input  T     in_i,
  output logic out_valid_o,
  input  logic out_ready_i,
  output T     out_o
);
  T first_q, second_q;
  logic valid_q, ready_q;  // ready_q: the second register is empty

  assign in_ready_o = ready_q;
  assign out_valid_o = valid_q;
  assign out_o = first_q;

  logic moves;
  assign moves = out_ready_i || !valid_q;
  always_ff @(posedge clk_i) begin
    if (moves) first_q <= ready_q ? in_i : second_q;
    if (ready_q) second_q <= in_i;
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_q <= 1'b0;
      ready_q <= 1'b1;
    end else begin
      if (moves) valid_q <= in_valid_i || !ready_q;
      ready_q <= moves || (ready_q && !in_valid_i);
    end
  end
endmodule

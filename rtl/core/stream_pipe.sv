// stream_pipe: gives a pure pipeline of fixed latency the valid/ready handshake.
//   parameters  T, what the pipeline puts out; Latency of the pipeline; Depth of the FIFO behind it
//   in    in_valid_i, in_ready_o      the word itself goes straight into the pipeline
//         data_i                      what the pipeline puts out, Latency clocks after its word was taken
//   out   out_valid_o, out_ready_i, out_o
//
//   latency Latency + 3, initiation interval 1 where Depth >= Latency + 5; no path from out_ready_i to in_ready_o.
//   A word is taken only when a place in the FIFO is reserved for its result, so the pipeline never stalls and nothing is lost. Whether
//   there is one is a register.
module stream_pipe #(
  parameter type T = logic,
  parameter int unsigned Latency = 1,
  parameter int unsigned Depth = Latency + 5
) (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic in_valid_i,
  output logic in_ready_o,
  input  T     data_i,
  output logic out_valid_o,
  input  logic out_ready_i,
  output T     out_o
);
  localparam int unsigned CountBits = $clog2(Depth + 1);

  logic take, leave, ready_q;
  logic [CountBits-1:0] reserved_q;
  logic [Latency-1:0] travelling_q;

  assign in_ready_o = ready_q;
  assign take = in_valid_i && in_ready_o;
  assign leave = out_valid_o && out_ready_i;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      reserved_q <= '0;
      ready_q <= 1'b1;
      travelling_q <= '0;
    end else begin
      reserved_q <= reserved_q + CountBits'(take) - CountBits'(leave);
      ready_q <= leave || (ready_q && !(take && reserved_q == CountBits'(Depth - 1)));
      travelling_q <= Latency'({travelling_q, take});
    end
  end

  logic unused_ready;
  logic [CountBits-1:0] unused_count;
  stream_fifo #(.T(T), .Depth(Depth)) i_fifo (
    .clk_i,
    .rst_ni,
    .in_valid_i(travelling_q[Latency-1]),
    .in_ready_o(unused_ready),
    .in_i(data_i),
    .out_valid_o,
    .out_ready_i,
    .out_o,
    .count_o(unused_count)
  );
endmodule

// stream_fifo: words wait in order between two valid/ready links.
//   parameters  T, Depth >= 2 words
//   in    in_valid_i, in_ready_o, in_i
//   out   out_valid_o, out_ready_i, out_o
//         count_o  words held, of 0..Depth
//
//   latency 3, initiation interval 1; all outputs registered: no path from out_ready_i to in_ready_o, none from in_valid_i to out_valid_o.
//   The words lie in a memory with a registered read port. What it puts out goes into the head's register and nowhere else: a block
//   memory's output is slow. So that a word can leave every clock, the word behind the head moves on, and the next one is read, in the
//   clock in which the head leaves; out_ready_i enables those registers and the read port.
//   memory -> read_q -> head_q -> out
module stream_fifo #(
  parameter type T = logic,
  parameter int unsigned Depth = 4,
  localparam int unsigned CountBits = $clog2(Depth + 1)
) (
  input  logic                 clk_i,
  input  logic                 rst_ni,
  input  logic                 in_valid_i,
  output logic                 in_ready_o,
  input  T                     in_i,
  output logic                 out_valid_o,
  input  logic                 out_ready_i,
  output T                     out_o,
  output logic [CountBits-1:0] count_o
);
  localparam int unsigned PlaceBits = Depth > 1 ? $clog2(Depth) : 1;

  // Read and write never meet at a place: nothing is read from an empty memory nor written to a full one. No bypass is wanted.
  (* no_rw_check *) T memory_q [Depth];
  T read_q;
  logic read_valid_q;

  logic [PlaceBits-1:0] write_place_q, read_place_q;
  logic [CountBits-1:0] count_q;    // words held in all
  logic [CountBits-1:0] stored_q;   // words in the memory that have not been read
  T head_q;
  logic head_valid_q;

  function automatic logic [PlaceBits-1:0] after(logic [PlaceBits-1:0] place);
    return place == PlaceBits'(Depth - 1) ? '0 : place + PlaceBits'(1);
  endfunction

  logic write, leave, follow, read;
  assign in_ready_o = count_q != CountBits'(Depth);
  assign write = in_valid_i && in_ready_o;
  assign leave = head_valid_q && out_ready_i;
  // The head is free for the word behind it; a read needs read_q free, or moving on.
  assign follow = leave || !head_valid_q;
  assign read = stored_q != '0 && (follow || !read_valid_q);

  assign out_valid_o = head_valid_q;
  assign out_o = head_q;
  assign count_o = count_q;

  always_ff @(posedge clk_i) begin
    if (write) memory_q[write_place_q] <= in_i;
    if (read) read_q <= memory_q[read_place_q];
    if (follow) head_q <= read_q;
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      write_place_q <= '0;
      read_place_q <= '0;
      count_q <= '0;
      stored_q <= '0;
      read_valid_q <= 1'b0;
      head_valid_q <= 1'b0;
    end else begin
      if (write) write_place_q <= after(write_place_q);
      if (read) read_place_q <= after(read_place_q);
      count_q <= count_q + CountBits'(write) - CountBits'(leave);
      stored_q <= stored_q + CountBits'(write) - CountBits'(read);
      read_valid_q <= read || (read_valid_q && !follow);
      if (follow) head_valid_q <= read_valid_q;
    end
  end
endmodule

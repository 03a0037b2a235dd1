// stream_fifo: words wait in order between two valid/ready links.
//   parameters  T, Depth >= 2 words
//   in    in_valid_i, in_ready_o, in_i
//   out   out_valid_o, out_ready_i, out_o
//         count_o  words held, of 0..Depth
//
//   latency 3, initiation interval 1; registered: all outputs but count_o, a sum of registers. No path from out_ready_i to in_ready_o, none
//   from in_valid_i to out_valid_o. Whether the memory is full or holds a word are registers too, not comparisons of a count. out_ready_i
//   enables the head's register; counters hear of it a clock later, so that it comes to no carry.
//
//   memory -> read_q -> head_q -> out    The memory has a registered read port, which a block memory is slow behind: what it puts out goes
//                                        into the head's register and nowhere else. So that a word can leave every clock, the word behind
//                                        the head moves on, and the next one is read, in the clock in which the head leaves.
//   memory -> head_q -> out              To 16 words: an FPGA's small memories read at once, and need no register between. What is written
//                                        is seen a clock later, so that the latency is the same.
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
  localparam bit Small = Depth <= 16;

  logic [PlaceBits-1:0] write_place_q, read_place_q;
  // Words held in all, and words in the memory that can be read: as they were a clock ago, and what has happened since.
  logic [CountBits-1:0] counted_q, stored_q, stored;
  logic wrote_q, left_q, added_q, taken_q;
  logic ready_q;                    // count_o is less than Depth
  logic some_q;                     // stored is not 0
  T head_q, behind;                 // behind: what goes into the head
  logic head_valid_q, behind_valid;

  function automatic logic [PlaceBits-1:0] after(logic [PlaceBits-1:0] place);
    return place == PlaceBits'(Depth - 1) ? '0 : place + PlaceBits'(1);
  endfunction

  logic write, written, leave, follow, read;
  assign in_ready_o = ready_q;
  assign write = in_valid_i && ready_q;
  assign leave = head_valid_q && out_ready_i;
  // The head is free for the word behind it.
  assign follow = leave || !head_valid_q;

  assign out_valid_o = head_valid_q;
  assign out_o = head_q;
  assign count_o = counted_q + CountBits'(wrote_q) - CountBits'(left_q);
  assign stored = stored_q + CountBits'(added_q) - CountBits'(taken_q);

  // Read and write never meet at a place: nothing is read from an empty memory nor written to a full one. No bypass is wanted.
  if (Small) begin : gen_small
    (* ram_style = "distributed" *) T memory_q [Depth];
    logic written_q;
    assign written = written_q;
    assign read = some_q && follow;
    assign behind = memory_q[read_place_q];
    assign behind_valid = some_q;
    always_ff @(posedge clk_i) begin
      if (write) memory_q[write_place_q] <= in_i;
      if (!rst_ni) written_q <= 1'b0;
      else written_q <= write;
    end
  end else begin : gen_large
    (* no_rw_check *) T memory_q [Depth];
    T read_q;
    logic read_valid_q;
    assign written = write;
    // A read needs read_q free, or moving on.
    assign read = some_q && (follow || !read_valid_q);
    assign behind = read_q;
    assign behind_valid = read_valid_q;
    always_ff @(posedge clk_i) begin
      if (write) memory_q[write_place_q] <= in_i;
      if (read) read_q <= memory_q[read_place_q];
      if (!rst_ni) read_valid_q <= 1'b0;
      else read_valid_q <= read || (read_valid_q && !follow);
    end
  end

  always_ff @(posedge clk_i) begin
    if (follow) head_q <= behind;
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      write_place_q <= '0;
      read_place_q <= '0;
      counted_q <= '0;
      wrote_q <= 1'b0;
      left_q <= 1'b0;
      stored_q <= '0;
      added_q <= 1'b0;
      taken_q <= 1'b0;
      ready_q <= 1'b1;
      some_q <= 1'b0;
      head_valid_q <= 1'b0;
    end else begin
      if (write) write_place_q <= after(write_place_q);
      if (read) read_place_q <= after(read_place_q);
      counted_q <= count_o;
      wrote_q <= write;
      left_q <= leave;
      stored_q <= stored;
      added_q <= written;
      taken_q <= read;
      ready_q <= leave || (ready_q && !(write && count_o == CountBits'(Depth - 1)));
      some_q <= written || (some_q && !(read && stored == CountBits'(1)));
      if (follow) head_valid_q <= behind_valid;
    end
  end
endmodule

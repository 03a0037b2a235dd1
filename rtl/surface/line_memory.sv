// line_memory: one row of a map, read at one column and written at another every clock.
//   parameters  T; MaxWidth columns
//   in    write_i, write_x_i, data_i   stored at the coming edge
//         read_x_i                     any column; the word is data_o two clocks later
//
//   latency 2 (the memory's own registered read port and a register behind it), initiation interval 1;
//   no reset. A column that is read at the edge at which it is written gives either word: who uses
//   it reads earlier, or at least a clock later.
module line_memory #(
  parameter type T = logic,
  parameter int unsigned MaxWidth = 8192,
  localparam int unsigned ColumnBits = $clog2(MaxWidth)
) (
  input  logic                  clk_i,
  input  logic                  write_i,
  input  logic [ColumnBits-1:0] write_x_i,
  input  T                      data_i,
  input  logic [ColumnBits-1:0] read_x_i,
  output T                      data_o
);
  T memory_q [MaxWidth];
  T read_q;
  always_ff @(posedge clk_i) begin
    if (write_i) memory_q[write_x_i] <= data_i;
    read_q <= memory_q[read_x_i];
    data_o <= read_q;
  end
endmodule

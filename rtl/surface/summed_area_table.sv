// summed_area_table: builds the table of Crow's summed areas from a stream of texels.
//   SAT(x+1, y+1) = sum of D(i, j), i <= x, j <= y, modulo 2^40
//                                                    contract: hls/surface/summed_area_table.hpp
//   in    in_i    texels row by row from v = 0, x fastest; map after map without a pause
//         map_i   may change while busy_o is low
//   out   out_o   one word for every texel, in the same order: sum, and where it goes
//         busy_o  part of a map or one of its words is inside
//
//   latency 7, initiation interval 1: a map takes width * height clocks and 7; all outputs registered
//   or a few gates from registers; no path from out_ready_i to in_ready_o.
//
//   The texels are summed down their column first, and the columns along the row. That is the same
//   sum, and a column has only 30 bits (2^14 texels), so the line is a quarter narrower than a line
//   of sums.
//
//         +------ line -------+
//         v                   |
//   D -->(+)--[s2_column]-----+-->(+)--[s3_sum]--> FIFO
//                                  ^------'
module summed_area_table
  import formats_pkg::*;
  import surface_pkg::*;
  import memory_pkg::*;
#(
  parameter int unsigned MaxWidth = 8192
) (
  input  logic         clk_i,
  input  logic         rst_ni,
  input  map_regs_t    map_i,
  output logic         busy_o,
  input  logic         in_valid_i,
  output logic         in_ready_o,
  input  texel_t       in_i,
  output logic         out_valid_o,
  input  logic         out_ready_i,
  output table_write_t out_o
);
  localparam int unsigned Latency = 4;
  localparam int unsigned Depth = Latency + 5;
  localparam int unsigned InsideBits = $clog2(Depth + 1);
  localparam int unsigned ColumnBits = $clog2(MaxWidth);
  typedef logic [29:0] column_t;

  // Where the next texel belongs.
  map_size_t x_q, y_q;
  logic      first_row_q, started_q;
  logic      take, leave, last_column, last_row;
  assign take = in_valid_i && in_ready_o;
  assign leave = out_valid_o && out_ready_i;
  assign last_column = x_q + 14'd1 == map_i.width;
  assign last_row = y_q + 14'd1 == map_i.height;

  logic [InsideBits-1:0] inside_q;
  assign busy_o = started_q || inside_q != '0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      x_q <= '0;
      y_q <= '0;
      first_row_q <= 1'b1;
      started_q <= 1'b0;
      inside_q <= '0;
    end else begin
      inside_q <= inside_q + InsideBits'(take) - InsideBits'(leave);
      if (take) begin
        started_q <= !(last_column && last_row);
        x_q <= last_column ? '0 : x_q + 14'd1;
        if (last_column) begin
          first_row_q <= last_row;
          y_q <= last_row ? '0 : y_q + 14'd1;
        end
      end
    end
  end

  // s0, s1: beside the read of the line.
  logic [2:0] valid_q;
  texel_t     s0_texel_q, s1_texel_q;
  map_size_t  s0_x_q, s0_y_q, s1_x_q, s1_y_q;
  logic       s0_first_row_q, s1_first_row_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else valid_q <= 3'({valid_q, take});
    s0_texel_q <= in_i;
    s0_x_q <= x_q;
    s0_y_q <= y_q;
    s0_first_row_q <= first_row_q;
    s1_texel_q <= s0_texel_q;
    s1_x_q <= s0_x_q;
    s1_y_q <= s0_y_q;
    s1_first_row_q <= s0_first_row_q;
  end

  // s2: the sum of the column down to this texel. From the read of a column to the clock after its
  // write are four clocks: rows of up to three texels find theirs in the last three sums.
  column_t   s2_column_q, line_column, s1_above;
  column_t   older_q [2];
  map_size_t s2_x_q, s2_y_q;
  always_comb begin
    unique case (map_i.width)
      14'd1:   s1_above = s2_column_q;
      14'd2:   s1_above = older_q[0];
      14'd3:   s1_above = older_q[1];
      default: s1_above = line_column;
    endcase
    if (s1_first_row_q) s1_above = '0;
  end
  always_ff @(posedge clk_i) begin
    if (valid_q[1]) begin
      s2_column_q <= s1_above + 30'(s1_texel_q);
      older_q[0] <= s2_column_q;
      older_q[1] <= older_q[0];
    end
    s2_x_q <= s1_x_q;
    s2_y_q <= s1_y_q;
  end
  line_memory #(.T(column_t), .MaxWidth(MaxWidth)) i_line (
    .clk_i,
    .write_i(valid_q[2]),
    .write_x_i(s2_x_q[ColumnBits-1:0]),
    .data_i(s2_column_q),
    .read_x_i(x_q[ColumnBits-1:0]),
    .data_o(line_column)
  );

  // s3: the sum of the row's columns up to this one.
  table_sum_t   s3_sum_q;
  map_size_t    s3_x_q, s3_y_q;
  table_write_t s3_word;
  always_ff @(posedge clk_i) begin
    if (valid_q[2]) s3_sum_q <= (s2_x_q == '0 ? '0 : s3_sum_q) + 40'(s2_column_q);
    s3_x_q <= s2_x_q;
    s3_y_q <= s2_y_q;
  end
  assign s3_word = '{sum: s3_sum_q, y: s3_y_q, x: s3_x_q};
  stream_pipe #(.T(table_write_t), .Latency(Latency), .Depth(Depth)) i_pipe (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .data_i(s3_word),
    .out_valid_o,
    .out_ready_i,
    .out_o
  );

  logic unused_wrap;
  assign unused_wrap = map_i.wrap_u ^ map_i.wrap_v;
endmodule

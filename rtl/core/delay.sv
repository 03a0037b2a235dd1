// delay: a word some clocks later, for what travels beside a pipeline.
//   in    x_i  any type
//   out   y_o  x_i of Stages clocks ago
//
//   latency Stages, initiation interval 1; no reset. Short delays are shift registers; longer ones a small memory written and read at
//   one place a clock, which costs memory cells instead of registers and next to nothing in simulation. What is too long for the small
//   memories of an FPGA lies in a block memory: read a place before it is written, as such a memory does not promise what it reads of
//   one that is being written; and with a register behind it, as its output is slow.
module delay #(
  parameter type T = logic,
  parameter int unsigned Stages = 1
) (
  input  logic clk_i,
  input  T     x_i,
  output T     y_o
);
  if (Stages == 0) begin : gen_wire
    assign y_o = x_i;
    logic unused_clk;
    assign unused_clk = clk_i;
  end else if (Stages < 4) begin : gen_shift
    T stage_q [Stages];
    always_ff @(posedge clk_i) begin
      stage_q[0] <= x_i;
      for (int i = 1; i < Stages; i++) stage_q[i] <= stage_q[i-1];
    end
    assign y_o = stage_q[Stages-1];
  end else if (Stages < 18) begin : gen_memory
    localparam int unsigned Depth = Stages - 1;
    localparam int unsigned Bits = $clog2(Depth);
    T memory_q [Depth];
    // Wherever the place starts, it walks round all of them after one turn.
    logic [Bits-1:0] place_q = '0;
    always_ff @(posedge clk_i) begin
      place_q <= place_q >= Bits'(Depth - 1) ? '0 : place_q + Bits'(1);
      memory_q[place_q] <= x_i;
      y_o <= memory_q[place_q];
    end
  end else begin : gen_block
    localparam int unsigned Depth = Stages - 1;
    localparam int unsigned Bits = $clog2(Depth);
    (* no_rw_check *) T memory_q [Depth];
    T read_q;
    logic [Bits-1:0] read_place_q = '0;
    logic [Bits-1:0] write_place_q = Bits'(Depth - 1);
    always_ff @(posedge clk_i) begin
      read_place_q <= read_place_q >= Bits'(Depth - 1) ? '0 : read_place_q + Bits'(1);
      write_place_q <= read_place_q;
      memory_q[write_place_q] <= x_i;
      read_q <= memory_q[read_place_q];
      y_o <= read_q;
    end
  end
endmodule

// edge_results: hands out what became of a triangle: children to the queue, finished triangles out, one of each a clock.
//   in     result_t; to_queue and to_out say which of the four are meant, at least one is
//   push   to the queue, which never refuses;  retire_o with the last of a result: the triangle is no longer in flight
//   out    triangle_t, finished
//   contract: pass and the pushes in step() of hls/edge/engine.hpp
//   latency 0: a choice from the word at its input; initiation interval: the larger of those bound for the queue and those bound for out,
//   a clock at least. in_ready_o depends on out_ready_i, which is a register's.
module edge_results
  import edge_pkg::*;
  import engine_pkg::*;
(
  input  logic      clk_i,
  input  logic      rst_ni,
  input  logic      in_valid_i,
  output logic      in_ready_o,
  input  result_t   in_i,
  output logic      push_valid_o,
  output triangle_t push_o,
  output logic      retire_o,
  output logic      out_valid_o,
  input  logic      out_ready_i,
  output triangle_t out_o
);
  function automatic triangle_t pick(triangle_t [3:0] t, logic [3:0] which);
    return which[0] ? t[0] : which[1] ? t[1] : which[2] ? t[2] : t[3];
  endfunction

  logic [3:0] gone_q, queue_left, out_left, queue_now, out_now, gone;
  assign queue_left = in_i.to_queue & ~gone_q;
  assign out_left = in_i.to_out & ~gone_q;
  assign queue_now = queue_left & (~queue_left + 4'd1);
  assign out_now = out_left & (~out_left + 4'd1);

  assign push_valid_o = in_valid_i && queue_left != '0;
  assign push_o = pick(in_i.t, queue_now);
  assign out_valid_o = in_valid_i && out_left != '0;
  assign out_o = pick(in_i.t, out_now);

  assign gone = gone_q | queue_now | (out_ready_i ? out_now : 4'd0);
  assign in_ready_o = ((in_i.to_queue | in_i.to_out) & ~gone) == '0;
  assign retire_o = in_valid_i && in_ready_o;

  always_ff @(posedge clk_i) begin
    if (!rst_ni || retire_o) gone_q <= '0;
    else if (in_valid_i) gone_q <= gone;
  end
endmodule

// edge_results: hands out what became of a triangle: unfinished ones to the queue, finished ones out, one of each a clock.
//   split  split_i: children; to_queue and to_out say which of the four are meant, at least two are
//   whole  whole_i: a triangle that did not split, or a base triangle that got its vertices; finished when all its edges are settled
//   push   to the queue, which never refuses;  retire_o: one triangle is no longer in flight, its children were pushed
//   out    triangle_t, finished; born_o: nobody looked at it, it was finished when it was born
//   contract: pass and the pushes in step() of hls/edge/engine.hpp
//
//   A split takes as many clocks as children go one way; whole triangles go past it, children first where both want the same way.
//   Two that end in one clock are retired one after the other: the queue only learns later of the place they leave.
//   latency 0: a choice from the words at its inputs; initiation interval: the larger of those bound for the queue and those bound for out.
//   Nothing is registered: the readies depend on out_ready_i, which in the engine is a register's and a gate of the word at out_o.
module edge_results
  import edge_pkg::*;
  import engine_pkg::*;
#(
  parameter int unsigned InFlight = 512
) (
  input  logic      clk_i,
  input  logic      rst_ni,
  input  logic      split_valid_i,
  output logic      split_ready_o,
  input  children_t split_i,
  input  logic      whole_valid_i,
  output logic      whole_ready_o,
  input  whole_t    whole_i,
  output logic      push_valid_o,
  output triangle_t push_o,
  output logic      retire_o,
  output logic      out_valid_o,
  input  logic      out_ready_i,
  output triangle_t out_o,
  output logic      born_o
);
  function automatic triangle_t pick(triangle_t [3:0] t, logic [3:0] which);
    return which[0] ? t[0] : which[1] ? t[1] : which[2] ? t[2] : t[3];
  endfunction

  // ---- children: those that are still here, and which go now
  logic [3:0] gone_q, queue_left, out_left, queue_now, out_now, gone;
  logic child_push, child_out;
  assign queue_left = split_i.to_queue & ~gone_q;
  assign out_left = split_i.to_out & ~gone_q;
  assign queue_now = queue_left & (~queue_left + 4'd1);
  assign out_now = out_left & (~out_left + 4'd1);
  assign child_push = split_valid_i && queue_left != '0;
  assign child_out = split_valid_i && out_left != '0;

  assign gone = gone_q | queue_now | (out_ready_i ? out_now : 4'd0);
  assign split_ready_o = ((split_i.to_queue | split_i.to_out) & ~gone) == '0;

  // ---- whole triangles: where no child goes
  logic finished;
  assign finished = &whole_i.t.settled;
  assign whole_ready_o = finished ? out_ready_i && !child_out : !child_push;

  assign push_valid_o = child_push || (whole_valid_i && !finished);
  assign push_o = child_push ? pick(split_i.t, queue_now) : whole_i.t;
  assign out_valid_o = child_out || (whole_valid_i && finished);
  assign out_o = child_out ? pick(split_i.t, out_now) : whole_i.t;
  assign born_o = child_out || whole_i.placed;

  // ---- retirements
  logic split_ends, whole_ends;
  logic [$clog2(InFlight+1)-1:0] owed_q;
  assign split_ends = split_valid_i && split_ready_o;
  assign whole_ends = whole_valid_i && whole_ready_o;
  assign retire_o = split_ends || whole_ends || owed_q != '0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      gone_q <= '0;
      owed_q <= '0;
    end else begin
      gone_q <= split_ends ? '0 : split_valid_i ? gone : gone_q;
      owed_q <= owed_q + $bits(owed_q)'(split_ends) + $bits(owed_q)'(whole_ends)
              - $bits(owed_q)'(retire_o);
    end
  end
endmodule

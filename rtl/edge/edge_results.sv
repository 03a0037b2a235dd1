// edge_results: hands out what became of triangles: unfinished ones to the queue, finished ones out, one of each a clock.
//   in     in_i, of each tessellate: a triangle, finished when all its edges are settled
//   push   to the queue, which never refuses;  retire_o: a triangle is no longer in flight, all that comes of it was pushed
//   out    triangle_t, finished; born_o: nobody looked at it, it was finished when it was born
//   contract: pass and the pushes in step() of hls/edge/engine.hpp
//
//   Where two of them want the same way the first one goes. Two triangles that end in one clock are retired one after the other: the queue
//   only learns later of the places that they leave.
//   latency 0: a choice from the words at its inputs; initiation interval: the larger of those bound for the queue and those bound for out.
//   Registered: retirements that are owed; no output. The readies depend on out_ready_i, which in the engine is a register's and a gate of
//   the word at out_o.
module edge_results
  import edge_pkg::*;
  import engine_pkg::*;
#(
  parameter int unsigned Ways = 1,
  parameter int unsigned InFlight = 512
) (
  input  logic              clk_i,
  input  logic              rst_ni,
  input  logic   [Ways-1:0] in_valid_i,
  output logic   [Ways-1:0] in_ready_o,
  input  child_t [Ways-1:0] in_i,
  output logic              push_valid_o,
  output triangle_t         push_o,
  output logic              retire_o,
  output logic              out_valid_o,
  input  logic              out_ready_i,
  output triangle_t         out_o,
  output logic              born_o
);
  localparam int unsigned OwedBits = $clog2(InFlight + 1);

  logic [Ways-1:0] for_queue, for_out, queue_now, out_now, ends;
  always_comb begin
    for (int i = 0; i < Ways; i++) begin
      for_queue[i] = in_valid_i[i] && !(&in_i[i].t.settled);
      for_out[i] = in_valid_i[i] && (&in_i[i].t.settled);
      ends[i] = in_valid_i[i] && in_ready_o[i] && in_i[i].ends;
    end
  end
  assign queue_now = for_queue & (~for_queue + Ways'(1));
  assign out_now = for_out & (~for_out + Ways'(1));
  assign in_ready_o = queue_now | (out_now & {Ways{out_ready_i}});

  assign push_valid_o = for_queue != '0;
  assign out_valid_o = for_out != '0;
  if (Ways == 1) begin : gen_one
    assign push_o = in_i[0].t;
    assign out_o = in_i[0].t;
    assign born_o = in_i[0].born;
  end else begin : gen_more
    always_comb begin
      push_o = '0;
      out_o = '0;
      born_o = 1'b0;
      for (int i = 0; i < Ways; i++) begin
        push_o |= {$bits(triangle_t){queue_now[i]}} & in_i[i].t;
        out_o |= {$bits(triangle_t){out_now[i]}} & in_i[i].t;
        born_o |= out_now[i] && in_i[i].born;
      end
    end
  end

  // ---- retirements
  logic [OwedBits-1:0] owed_q;
  assign retire_o = ends != '0 || owed_q != '0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) owed_q <= '0;
    else owed_q <= owed_q + OwedBits'($countones(ends)) - OwedBits'(retire_o);
  end
endmodule

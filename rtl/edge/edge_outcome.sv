// edge_outcome: what becomes of a triangle that the lanes have answered: its children, or it itself, to the queue or out.
//   in     in_valid_i, in_ready_o, in_i   the triangle, which edges split and where
//   push, retire, out, born               as edge_results
//   map_i, max_generation_i               constant while a mesh runs
//   contract: what follows the loop over the edges in step() of hls/edge/engine.hpp
//
//   Lanes = 1  one tessellate, a triangle put out a clock;  Lanes = 3  three of them take turns, one goes to the queue and one out a clock
//   latency 5, as tessellate; initiation interval: the triangles put out, over the lanes. Registered: as tessellate; what edge_results
//   chooses is not
//
//                    +--[tessellate]--+
//   in --[in turns]--+--[tessellate]--+--[edge_results]--+-- push
//                    +--[tessellate]--+                  +-- out
module edge_outcome
  import formats_pkg::*;
  import surface_pkg::*;
  import edge_pkg::*;
  import engine_pkg::*;
#(
  parameter int unsigned Lanes = 1,
  parameter int unsigned InFlight = 512
) (
  input  logic        clk_i,
  input  logic        rst_ni,
  input  map_regs_t   map_i,
  input  generation_t max_generation_i,
  input  logic        in_valid_i,
  output logic        in_ready_o,
  input  collected_t  in_i,
  output logic        push_valid_o,
  output triangle_t   push_o,
  output logic        retire_o,
  output logic        out_valid_o,
  input  logic        out_ready_i,
  output triangle_t   out_o,
  output logic        born_o
);
  // Whose turn it is: one bit is set.
  logic [Lanes-1:0] turn, ready;
  if (Lanes == 1) begin : gen_one
    assign turn = 1'b1;
  end else begin : gen_turns
    logic [Lanes-1:0] turn_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) turn_q <= Lanes'(1);
      else if (in_valid_i && in_ready_o) turn_q <= {turn_q[Lanes-2:0], turn_q[Lanes-1]};
    end
    assign turn = turn_q;
  end
  assign in_ready_o = (turn & ready) != '0;

  logic   [Lanes-1:0] child_valid, child_ready;
  child_t [Lanes-1:0] child;
  for (genvar i = 0; i < Lanes; i++) begin : gen_tessellate
    tessellate i_tessellate (
      .clk_i,
      .rst_ni,
      .map_i,
      .max_generation_i,
      .in_valid_i(in_valid_i && turn[i]),
      .in_ready_o(ready[i]),
      .in_i,
      .out_valid_o(child_valid[i]),
      .out_ready_i(child_ready[i]),
      .out_o(child[i])
    );
  end

  edge_results #(.Ways(Lanes), .InFlight(InFlight)) i_results (
    .clk_i,
    .rst_ni,
    .in_valid_i(child_valid),
    .in_ready_o(child_ready),
    .in_i(child),
    .push_valid_o,
    .push_o,
    .retire_o,
    .out_valid_o,
    .out_ready_i,
    .out_o,
    .born_o
  );
endmodule

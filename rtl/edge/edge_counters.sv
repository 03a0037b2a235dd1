// edge_counters: what the engine counts while a mesh runs.
//   clear_i   all to zero, before a mesh
//   lane_*    an answer of a lane was taken, with what it adds
//   in_i      a base triangle came in;  tested_i a triangle was looked at, with its settled and split edges
//   born_i    a triangle leaves that was finished when it was born: nobody looked at it
//   out_i, culled_i  a triangle went out, or was dropped for its back
//
//   contract: hls/edge/counters.hpp
//   latency 2, initiation interval 1; what an event adds is registered before it is added.
module edge_counters
  import edge_pkg::*;
  import lane_pkg::*;
  import engine_pkg::*;
#(
  parameter int unsigned Lanes = 1
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic                     clear_i,
  input  logic                     in_i,
  input  logic         [Lanes-1:0] lane_valid_i,
  input  lane_counts_t [Lanes-1:0] lane_i,
  input  logic                     tested_i,
  input  logic         [2:0]       settled_i,
  input  logic         [2:0]       split_i,
  input  logic                     born_i,
  input  logic                     out_i,
  input  logic                     culled_i,
  input  logic         [15:0]      high_water_i,
  input  logic         [63:0]      fallbacks_i,
  output counters_t                counters_o
);
  // At most three lanes with 17 samples each a clock.
  typedef logic [5:0] step_t;
  step_t     [CounterWords-1:0] step, step_q;
  counters_t                    counters_q;

  always_comb begin
    step = '0;
    step[CountTrianglesIn] = step_t'(in_i);
    step[CountTrianglesOut] = step_t'(out_i);
    step[CountCulled] = step_t'(culled_i);
    for (int i = 0; i < Lanes; i++) begin
      if (lane_valid_i[i]) begin
        step[CountEdgeTests] += step_t'(lane_i[i].edge_test);
        step[CountVt] += step_t'(lane_i[i].vt);
        step[CountCt] += step_t'(lane_i[i].ct);
        step[CountNt] += step_t'(lane_i[i].nt);
        step[CountSht] += step_t'(lane_i[i].sht);
        step[CountPt] += step_t'(lane_i[i].pt);
        step[CountHt] += step_t'(lane_i[i].ht);
        step[CountVertices] += step_t'(lane_i[i].vertex);
        step[CountSaturations] += step_t'(lane_i[i].saturations);
        step[CountScreenSaturations] += step_t'(lane_i[i].screen_saturation);
        step[CountZeroVectors] += step_t'(lane_i[i].zero_vectors);
        step[CountTableReads] += lane_i[i].table_read ? step_t'(12) : step_t'(0);
        step[CountProfileSamples] += step_t'(lane_i[i].profile_samples);
      end
    end
    if (tested_i) begin
      step[CountSettledSkips] += step_t'($countones(settled_i));
      step[CountSplits+$countones(split_i)] += step_t'(1);
    end
    // A triangle born finished was not split, and its three edges were settled.
    step[CountSettledSkips] += born_i ? step_t'(3) : step_t'(0);
    step[CountSplits] += step_t'(born_i);
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni || clear_i) begin
      step_q <= '0;
      counters_q <= '0;
    end else begin
      step_q <= step;
      for (int i = 0; i < CounterWords; i++) counters_q[i] <= counters_q[i] + 64'(step_q[i]);
    end
  end

  always_comb begin
    counters_o = counters_q;
    counters_o[CountQueueHighWater] = 64'(high_water_i);
    counters_o[CountFifoFallbacks] = fallbacks_i;
  end
endmodule

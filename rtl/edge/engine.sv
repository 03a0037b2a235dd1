// engine: base triangles in, adaptively tessellated and displaced triangles out.
//   Doggett & Hirche 2000, Figures 7 and 8; contract: hls/edge/engine.hpp, which puts out the same triangles in another order
//
//   parameters  Lanes, ReadsPerClock, SamplesPerClock, QueueDepth, InFlight as rtl/top/edge_engine.sv has them; MaxGeneration, the most that
//               regs_i may ask for: the queue's credit rule is proven for 3 MaxGeneration + 4 entries at least
//   start_i   begins a mesh; the registers hold until done_o. in_i: base triangles, the last one says so; out_o: triangles, the last says so
//   end_i     the input is over although no last came: the mesh ends with what was taken
//   regs_i    engine_regs;  memories: read ports of each lane, see edge_lane
//   done_o    no mesh is running: all of the last one has left; error_o: the queue overflowed, which its rule makes impossible
//
//   A triangle goes round: queue, get_triangle, the lanes, tessellate, and its children to the queue. A child whose edges are all settled
//   is finished when it is born and goes out at once: settled edges cost nothing. A base triangle goes round once more, for its vertices.
//   latency of one round 185 clocks with memories of latency 1, to the first of what comes of a triangle; initiation interval: one unsettled
//   edge a clock and lane. Registered: all outputs; within, dispatch, collect and results are gates between FIFOs, and wait until all that
//   they need is there
//
//   in --+------[ask]------[dispatch]--+--[edge_lane]----+--[collect]--[outcome]--+--[output]-- out
//        |                              +--[flight FIFO]--+                        |
//        +----------------------------[triangle_queue]-----------------------------+
module engine
  import formats_pkg::*;
  import memory_pkg::*;
  import edge_pkg::*;
  import lane_pkg::*;
  import engine_pkg::*;
#(
  parameter int unsigned Lanes = 1,
  parameter int unsigned ReadsPerClock = 12,
  parameter int unsigned SamplesPerClock = 4,
  parameter int unsigned QueueDepth = 4096,
  parameter int unsigned MaxGeneration = 15,
  parameter int unsigned InFlight = 128
) (
  input  logic         clk_i,
  input  logic         rst_ni,
  input  logic         start_i,
  input  logic         end_i,
  output logic         done_o,
  output logic         error_o,
  input  engine_regs_t regs_i,
  output counters_t    counters_o,

  input  logic           in_valid_i,
  output logic           in_ready_o,
  input  base_triangle_t in_i,

  output logic           [Lanes-1:0]                    table_req_valid_o,
  input  logic           [Lanes-1:0]                    table_req_ready_i,
  output table_request_t [Lanes-1:0][ReadsPerClock-1:0] table_req_o,
  input  logic           [Lanes-1:0]                    table_rsp_valid_i,
  input  table_sum_t     [Lanes-1:0][ReadsPerClock-1:0] table_rsp_i,

  output logic          [Lanes-1:0]                      quad_req_valid_o,
  input  logic          [Lanes-1:0]                      quad_req_ready_i,
  output quad_request_t [Lanes-1:0][SamplesPerClock-1:0] quad_req_o,
  output logic          [Lanes-1:0][SamplesPerClock-1:0] quad_req_mask_o,
  input  logic          [Lanes-1:0]                      quad_rsp_valid_i,
  input  texel_quad_t   [Lanes-1:0][SamplesPerClock-1:0] quad_rsp_i,

  output logic          [Lanes-1:0] place_req_valid_o,
  input  logic          [Lanes-1:0] place_req_ready_i,
  output quad_request_t [Lanes-1:0] place_req_o,
  input  logic          [Lanes-1:0] place_rsp_valid_i,
  input  texel_quad_t   [Lanes-1:0] place_rsp_i,

  output logic          [Lanes-1:0] normal_req_valid_o,
  input  logic          [Lanes-1:0] normal_req_ready_i,
  output quad_request_t [Lanes-1:0] normal_req_o,
  input  logic          [Lanes-1:0] normal_rsp_valid_i,
  input  normal_quad_t  [Lanes-1:0] normal_rsp_i,

  output logic          out_valid_o,
  input  logic          out_ready_i,
  output triangle_out_t out_o
);
  if (Lanes != 1 && Lanes != 3) begin : gen_lanes
    $error("Lanes is 1 or 3");
  end
  if (MaxGeneration > 15) begin : gen_max_generation
    $error("MaxGeneration is 15 at most");
  end
  if (QueueDepth < 3 * MaxGeneration + 4) begin : gen_queue_depth
    $error("QueueDepth is 3 MaxGeneration + 4 at least");
  end
  if (InFlight < 8) begin : gen_in_flight
    $error("InFlight is 8 at least");
  end
  // Triangles between their pop and their children: those of two maps' latencies and of all pipelines.
  localparam int unsigned FlightDepth = 2 * InFlight + 256;

  generation_t max_generation;
  assign max_generation = regs_i.pass.max_generation;

  // ---- the mesh: begun by start_i, its input over with the last base triangle
  logic running_q, input_done_q, finish, out_empty;
  assign done_o = !running_q && out_empty;

  // ---- the next triangle: from the queue, or from outside when the queue has none
  logic pop_valid, pop_ready, may_take, take, push_valid, retire, queue_idle;
  triangle_t popped, pushed;
  logic [15:0] high_water;
  logic [$clog2(QueueDepth+1)-1:0] unused_count, unused_in_flight;
  logic [63:0] fallbacks;
  triangle_queue #(
    .T(triangle_t), .Depth(QueueDepth), .InFlight(FlightDepth), .FifoReserve(QueueDepth / 2)
  ) i_queue (
    .clk_i,
    .rst_ni(rst_ni && !start_i),
    .regs_i(regs_i.queue),
    .max_generation_i(max_generation),
    .push_valid_i(push_valid),
    .push_i(pushed),
    .pop_valid_o(pop_valid),
    .pop_ready_i(pop_ready),
    .pop_o(popped),
    .retire_i(retire),
    .take_i(take),
    .may_take_o(may_take),
    .count_o(unused_count),
    .in_flight_o(unused_in_flight),
    .high_water_o(high_water),
    .fallbacks_o(fallbacks),
    .idle_o(queue_idle),
    .error_o
  );

  triangle_t next;
  logic take_open, got_ready;
  assign take_open = running_q && !input_done_q && may_take && !pop_valid;
  assign in_ready_o = take_open && got_ready;
  assign take = in_valid_i && in_ready_o;
  assign pop_ready = got_ready;
  assign next = pop_valid ? popped : to_triangle(in_i);

  // ---- what is asked of it
  flight_t ready_flight;
  logic ready_valid, ready_ready;
  edge_ask i_ask (
    .clk_i,
    .rst_ni,
    .max_generation_i(max_generation),
    .in_valid_i(pop_valid || (take_open && in_valid_i)),
    .in_ready_o(got_ready),
    .in_i(next),
    .out_valid_o(ready_valid),
    .out_ready_i(ready_ready),
    .out_o(ready_flight)
  );

  // ---- into the lanes
  logic flight_in_valid, flight_in_ready, flight_valid, flight_ready;
  flight_t flight_in, flight;
  logic [Lanes-1:0] lane_in_valid, lane_in_ready, lane_valid, lane_ready;
  lane_in_t [Lanes-1:0] lane_in;
  lane_out_t [Lanes-1:0] lane_out;
  edge_dispatch #(.Lanes(Lanes)) i_dispatch (
    .clk_i,
    .rst_ni,
    .in_valid_i(ready_valid),
    .in_ready_o(ready_ready),
    .in_i(ready_flight),
    .flight_valid_o(flight_in_valid),
    .flight_ready_i(flight_in_ready),
    .flight_o(flight_in),
    .lane_valid_o(lane_in_valid),
    .lane_ready_i(lane_in_ready),
    .lane_o(lane_in)
  );
  logic [$clog2(FlightDepth+1)-1:0] unused_flight_count;
  stream_fifo #(.T(flight_t), .Depth(FlightDepth)) i_flight (
    .clk_i,
    .rst_ni,
    .in_valid_i(flight_in_valid),
    .in_ready_o(flight_in_ready),
    .in_i(flight_in),
    .out_valid_o(flight_valid),
    .out_ready_i(flight_ready),
    .out_o(flight),
    .count_o(unused_flight_count)
  );
  for (genvar i = 0; i < Lanes; i++) begin : gen_lane
    edge_lane #(
      .ReadsPerClock(ReadsPerClock),
      .SamplesPerClock(SamplesPerClock),
      .InFlight(InFlight)
    ) i_lane (
      .clk_i,
      .rst_ni,
      .regs_i,
      .in_valid_i(lane_in_valid[i]),
      .in_ready_o(lane_in_ready[i]),
      .in_i(lane_in[i]),
      .table_req_valid_o(table_req_valid_o[i]),
      .table_req_ready_i(table_req_ready_i[i]),
      .table_req_o(table_req_o[i]),
      .table_rsp_valid_i(table_rsp_valid_i[i]),
      .table_rsp_i(table_rsp_i[i]),
      .quad_req_valid_o(quad_req_valid_o[i]),
      .quad_req_ready_i(quad_req_ready_i[i]),
      .quad_req_o(quad_req_o[i]),
      .quad_req_mask_o(quad_req_mask_o[i]),
      .quad_rsp_valid_i(quad_rsp_valid_i[i]),
      .quad_rsp_i(quad_rsp_i[i]),
      .place_req_valid_o(place_req_valid_o[i]),
      .place_req_ready_i(place_req_ready_i[i]),
      .place_req_o(place_req_o[i]),
      .place_rsp_valid_i(place_rsp_valid_i[i]),
      .place_rsp_i(place_rsp_i[i]),
      .normal_req_valid_o(normal_req_valid_o[i]),
      .normal_req_ready_i(normal_req_ready_i[i]),
      .normal_req_o(normal_req_o[i]),
      .normal_rsp_valid_i(normal_rsp_valid_i[i]),
      .normal_rsp_i(normal_rsp_i[i]),
      .out_valid_o(lane_valid[i]),
      .out_ready_i(lane_ready[i]),
      .out_o(lane_out[i])
    );
  end

  // ---- the answers, and the children
  logic collected_valid, collected_ready;
  collected_t collected;
  edge_collect #(.Lanes(Lanes)) i_collect (
    .clk_i,
    .rst_ni,
    .flight_valid_i(flight_valid),
    .flight_ready_o(flight_ready),
    .flight_i(flight),
    .lane_valid_i(lane_valid),
    .lane_ready_o(lane_ready),
    .lane_i(lane_out),
    .out_valid_o(collected_valid),
    .out_ready_i(collected_ready),
    .out_o(collected)
  );
  logic finished_valid, finished_ready, finished_born;
  triangle_t finished;
  edge_outcome #(.Lanes(Lanes), .InFlight(FlightDepth)) i_outcome (
    .clk_i,
    .rst_ni,
    .map_i(regs_i.map),
    .max_generation_i(max_generation),
    .in_valid_i(collected_valid),
    .in_ready_o(collected_ready),
    .in_i(collected),
    .push_valid_o(push_valid),
    .push_o(pushed),
    .retire_o(retire),
    .out_valid_o(finished_valid),
    .out_ready_i(finished_ready),
    .out_o(finished),
    .born_o(finished_born)
  );

  // ---- out; the mesh is over when its last triangle is
  logic over, arrives, culled;
  assign over = running_q && input_done_q && queue_idle;
  edge_output i_output (
    .clk_i,
    .rst_ni,
    .clear_i(start_i),
    .regs_i(regs_i.pass),
    .over_i(over),
    .in_valid_i(finished_valid),
    .in_ready_o(finished_ready),
    .in_i(finished),
    .out_valid_o,
    .out_ready_i,
    .out_o,
    .arrives_o(arrives),
    .culled_o(culled),
    .finish_o(finish),
    .empty_o(out_empty)
  );

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      running_q <= 1'b0;
      input_done_q <= 1'b0;
    end else if (start_i) begin
      running_q <= 1'b1;
      input_done_q <= 1'b0;
    end else begin
      if (end_i || (take && in_i.last)) input_done_q <= 1'b1;
      if (finish) running_q <= 1'b0;
    end
  end

  // ---- counters
  logic tested;
  lane_counts_t [Lanes-1:0] lane_counts;
  for (genvar i = 0; i < Lanes; i++) begin : gen_counts
    assign lane_counts[i] = lane_out[i].counts;
  end
  assign tested = collected_valid && collected_ready && !collected.place;
  edge_counters #(.Lanes(Lanes)) i_counters (
    .clk_i,
    .rst_ni,
    .clear_i(start_i),
    .in_i(take),
    .lane_valid_i(lane_valid & lane_ready),
    .lane_i(lane_counts),
    .tested_i(tested),
    .settled_i(collected.t.t.settled),
    .split_i(collected.t.split),
    .born_i(finished_valid && finished_ready && finished_born),
    .out_i(arrives),
    .culled_i(culled),
    .high_water_i(high_water),
    .fallbacks_i(fallbacks),
    .counters_o
  );
endmodule

// engine: base triangles in, adaptively tessellated and displaced triangles out.
//   Doggett & Hirche 2000, Figures 7 and 8; contract: hls/edge/engine.hpp, which puts out the same triangles in another order
//
//   start_i   begins a mesh; the registers hold until done_o. in_i: base triangles, the last one says so; out_o: triangles, the last says so
//   end_i     the input is over although no last came: the mesh ends with what was taken
//   regs_i    engine_regs;  memories: read ports of each lane, see edge_lane
//   done_o    no mesh is running: all of the last one has left; error_o: the queue overflowed, which its rule makes impossible
//
//   A triangle goes round: queue, get_triangle, the lanes, tessellate, and its children to the queue. A child whose edges are all settled
//   is finished when it is born and goes out at once: settled edges cost nothing. A base triangle goes round once more, for its vertices.
//   latency of one round 182 clocks for a triangle that stays whole and 190 for one that splits, with memories of latency 1; initiation
//   interval: one unsettled edge a clock and lane. Registered: all outputs; within, dispatch, collect and results are gates between FIFOs,
//   and wait until all that they need is there
//
//   in --+--[get_triangle]--[dispatch]--+--[edge_lane]----+--[collect]--+--[tessellate]--+--[results]--+-- out
//        |                              +--[flight FIFO]--+             +--[whole FIFO]--+             |
//        +--------------------------------------[triangle_queue]---------------------------------------+
module engine
  import formats_pkg::*;
  import surface_pkg::*;
  import memory_pkg::*;
  import edge_pkg::*;
  import lane_pkg::*;
  import engine_pkg::*;
  import latency_pkg::*;
#(
  parameter int unsigned Lanes = 1,
  parameter int unsigned ReadsPerClock = 12,
  parameter int unsigned SamplesPerClock = 4,
  parameter int unsigned QueueDepth = 4096,
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
  // Triangles between their pop and their children: those of two maps' latencies and of all pipelines.
  localparam int unsigned FlightDepth = 2 * InFlight + 256;
  // Whole triangles leave at one a clock and splits at one in two to four; each must be able to wait for a run of the other kind to end.
  // One lane answers a triangle in two clocks or three, and the runs are short: 16 places, which an FPGA's small memories have. Of block
  // memories the children of 32 splits would take 160.
  localparam int unsigned WholeDepth = Lanes == 1 ? 16 : 32;
  localparam int unsigned ChildrenDepth = Lanes == 1 ? 16 : 32;

  generation_t max_generation;
  assign max_generation = regs_i.pass.max_generation;

  // ---- the mesh: begun by start_i, its input over with the last base triangle
  logic running_q, input_done_q, finish;
  logic [2:0] out_count;
  assign done_o = !running_q && out_count == '0;

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

  triangle_t base, next;
  always_comb begin
    base = '0;
    for (int i = 0; i < 3; i++) begin
      base.v[i].p = in_i.v[i].p;
      base.v[i].n = in_i.v[i].n;
      base.v[i].t = in_i.v[i].t;
      base.v[i].u = in_i.v[i].u;
    end
    base.index = in_i.index;
  end
  logic take_open, got_ready;
  assign take_open = running_q && !input_done_q && may_take && !pop_valid;
  assign in_ready_o = take_open && got_ready;
  assign take = in_valid_i && in_ready_o;
  assign pop_ready = got_ready;
  assign next = pop_valid ? popped : base;

  // ---- get_triangle: what is asked of it
  get_triangle_out_t got_data;
  triangle_t         got_triangle;
  get_triangle i_get_triangle (
    .clk_i, .max_generation_i(max_generation), .in_i(next), .out_o(got_data)
  );
  delay #(.T(triangle_t), .Stages(GetTriangle)) i_got (.clk_i, .x_i(next), .y_o(got_triangle));
  flight_t got, ready_flight;
  always_comb begin
    got.t = got_triangle;
    got.t.settled = got_data.settled;
    got.place = |got_data.new_surface;
    got.ask = got.place ? 3'b111 : ~got_data.settled;
  end
  logic ready_valid, ready_ready;
  stream_pipe #(.T(flight_t), .Latency(GetTriangle)) i_get_pipe (
    .clk_i,
    .rst_ni,
    .in_valid_i(pop_valid || (take_open && in_valid_i)),
    .in_ready_o(got_ready),
    .data_i(got),
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
  logic collected_valid, collected_ready, collected_place;
  tessellate_in_t collected;
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
    .out_o(collected),
    .place_o(collected_place)
  );

  // A triangle without a split stays as it is, a base triangle gets its vertices: both pass by tessellate.
  logic   split, whole_in_ready, whole_valid, whole_ready;
  whole_t whole_in, whole;
  assign split = |collected.split;
  always_comb begin
    whole_in.t = collected.t;
    if (collected_place) whole_in.t.v = collected.m;
    else whole_in.t.settled = '1;
    whole_in.placed = collected_place;
  end
  logic [$clog2(WholeDepth+1)-1:0] unused_whole_count;
  stream_fifo #(.T(whole_t), .Depth(WholeDepth)) i_whole (
    .clk_i,
    .rst_ni,
    .in_valid_i(collected_valid && !split),
    .in_ready_o(whole_in_ready),
    .in_i(whole_in),
    .out_valid_o(whole_valid),
    .out_ready_i(whole_ready),
    .out_o(whole),
    .count_o(unused_whole_count)
  );

  tessellate_out_t tessellated;
  tessellate i_tessellate (
    .clk_i,
    .map_i(regs_i.map),
    .max_generation_i(max_generation),
    .in_i(collected),
    .out_o(tessellated)
  );
  logic split_in_ready, children_valid, children_ready;
  children_t children_in, children;
  always_comb begin
    children_in.t = tessellated.t;
    for (int i = 0; i < 4; i++) begin
      logic there, finished;
      there = 3'(i) < tessellated.count;
      finished = &tessellated.t[i].settled;
      children_in.to_out[i] = there && finished;
      children_in.to_queue[i] = there && !finished;
    end
  end
  stream_pipe #(.T(children_t), .Latency(Tessellate), .Depth(ChildrenDepth)) i_tessellate_pipe (
    .clk_i,
    .rst_ni,
    .in_valid_i(collected_valid && split),
    .in_ready_o(split_in_ready),
    .data_i(children_in),
    .out_valid_o(children_valid),
    .out_ready_i(children_ready),
    .out_o(children)
  );
  assign collected_ready = split ? split_in_ready : whole_in_ready;

  logic finished_valid, finished_ready, finished_born;
  triangle_t finished;
  edge_results #(.InFlight(FlightDepth)) i_results (
    .clk_i,
    .rst_ni,
    .split_valid_i(children_valid),
    .split_ready_o(children_ready),
    .split_i(children),
    .whole_valid_i(whole_valid),
    .whole_ready_o(whole_ready),
    .whole_i(whole),
    .push_valid_o(push_valid),
    .push_o(pushed),
    .retire_o(retire),
    .out_valid_o(finished_valid),
    .out_ready_i(finished_ready),
    .out_o(finished),
    .born_o(finished_born)
  );

  // ---- out, one record late so that the last of the mesh can say so
  logic hold_ready, holding_q, out_write, culled, arrives;
  triangle_out_t held_q, out_word;
  cull i_cull (
    .away_i({finished.v[2].away, finished.v[1].away, finished.v[0].away}),
    .regs_i(regs_i.pass),
    .cull_o(culled)
  );
  assign finished_ready = !holding_q || hold_ready || culled;
  assign arrives = finished_valid && finished_ready && !culled;
  assign finish = running_q && input_done_q && queue_idle && hold_ready;
  assign out_write = (arrives && holding_q) || finish;
  always_comb begin
    out_word = held_q;
    if (finish) begin
      if (!holding_q) begin
        out_word = '0;
        out_word.empty = 1'b1;
      end
      out_word.last = 1'b1;
    end
  end
  stream_fifo #(.T(triangle_out_t), .Depth(4)) i_out (
    .clk_i,
    .rst_ni,
    .in_valid_i(out_write),
    .in_ready_o(hold_ready),
    .in_i(out_word),
    .out_valid_o,
    .out_ready_i,
    .out_o,
    .count_o(out_count)
  );

  always_ff @(posedge clk_i) begin
    if (arrives) held_q <= to_output(finished);
    if (!rst_ni) begin
      running_q <= 1'b0;
      input_done_q <= 1'b0;
      holding_q <= 1'b0;
    end else if (start_i) begin
      running_q <= 1'b1;
      input_done_q <= 1'b0;
      holding_q <= 1'b0;
    end else begin
      if (end_i || (take && in_i.last)) input_done_q <= 1'b1;
      if (arrives) holding_q <= 1'b1;
      if (finish) running_q <= 1'b0;
    end
  end

  // ---- counters
  logic tested;
  lane_counts_t [Lanes-1:0] lane_counts;
  for (genvar i = 0; i < Lanes; i++) begin : gen_counts
    assign lane_counts[i] = lane_out[i].counts;
  end
  assign tested = collected_valid && collected_ready && !collected_place;
  edge_counters #(.Lanes(Lanes)) i_counters (
    .clk_i,
    .rst_ni,
    .clear_i(start_i),
    .in_i(take),
    .lane_valid_i(lane_valid & lane_ready),
    .lane_i(lane_counts),
    .tested_i(tested),
    .settled_i(collected.t.settled),
    .split_i(collected.split),
    .born_i(finished_valid && finished_ready && finished_born),
    .out_i(arrives),
    .culled_i(finished_valid && culled),
    .high_water_i(high_water),
    .fallbacks_i(fallbacks),
    .counters_o
  );
endmodule

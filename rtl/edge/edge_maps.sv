// edge_maps: what the maps say at a new vertex, where one is needed: its normal, and where it is displaced to. Whoever needs none waits here
// in order.
//   Doggett & Hirche 2000, Figure 8; contract: place of hls/edge/engine.hpp, as far as it reads the maps
//   in    in_*       new_vertex_t
//         place      the map's quad at the vertex;  normal  the normal map's quad there
//   out   waiting_o, normal_o, displaced_o  in the order of in_*; the last two hold anything where waiting_o.needed is 0
//         base_o     the base of what went in, one after the other, apart: the next when base_leaves_i
//
//   latency 36 clocks and that of the memories where one is asked, 6 where none is; initiation interval 1 where the memories deliver.
//   in_ready_o from an AND of four registers, out_valid_o of three. What is forked goes to all ends of the device and what is joined
//   comes from there, so there is a register for each. Nothing is dropped.
//
//   in --+--[normal_sampler]---+-- out
//        +--[displace_vertex]--+
//        +--[FIFO]-------------+
//        +--[FIFO: its base]------ base
module edge_maps
  import formats_pkg::*;
  import surface_pkg::*;
  import memory_pkg::*;
  import edge_pkg::*;
  import lane_pkg::*;
#(
  parameter int unsigned InFlight = 128,
  parameter int unsigned WaitingDepth = InFlight + 64,
  parameter int unsigned BaseDepth = WaitingDepth + 72
) (
  input  logic           clk_i,
  input  logic           rst_ni,
  input  map_regs_t      map_i,
  input  displace_regs_t displace_i,

  input  logic        in_valid_i,
  output logic        in_ready_o,
  input  new_vertex_t in_i,

  output logic          place_req_valid_o,
  input  logic          place_req_ready_i,
  output quad_request_t place_req_o,
  input  logic          place_rsp_valid_i,
  input  texel_quad_t   place_rsp_i,

  output logic          normal_req_valid_o,
  input  logic          normal_req_ready_i,
  output quad_request_t normal_req_o,
  input  logic          normal_rsp_valid_i,
  input  normal_quad_t  normal_rsp_i,

  output logic                 out_valid_o,
  input  logic                 out_ready_i,
  output waiting_t             waiting_o,
  output normal_sampler_out_t  normal_o,
  output displace_vertex_out_t displaced_o,

  input  logic        base_leaves_i,
  output base_frame_t base_o
);
  // ---- the fork
  logic ask_maps, fire, far_normal_ready, far_displace_ready, far_waiting_ready, far_base_ready;
  assign ask_maps = in_i.needed;
  assign in_ready_o = far_waiting_ready && far_base_ready
                      && ((far_normal_ready && far_displace_ready) || !ask_maps);
  assign fire = in_valid_i && in_ready_o;

  normal_sampler_in_t far_normal;
  logic far_normal_valid, normal_in_ready;
  stream_register #(.T(normal_sampler_in_t)) i_far_normal (
    .clk_i, .rst_ni,
    .in_valid_i(fire && ask_maps), .in_ready_o(far_normal_ready), .in_i('{u: in_i.base.u}),
    .out_valid_o(far_normal_valid), .out_ready_i(normal_in_ready), .out_o(far_normal)
  );
  displace_vertex_in_t far_displace;
  logic far_displace_valid, displace_in_ready;
  stream_register #(.T(displace_vertex_in_t)) i_far_displace (
    .clk_i, .rst_ni,
    .in_valid_i(fire && ask_maps), .in_ready_o(far_displace_ready),
    .in_i('{u: in_i.base.u, n: in_i.base.n, p: in_i.base.p}),
    .out_valid_o(far_displace_valid), .out_ready_i(displace_in_ready), .out_o(far_displace)
  );
  waiting_t far_waiting;
  logic far_waiting_valid, waiting_ready;
  stream_register #(.T(waiting_t)) i_far_waiting (
    .clk_i, .rst_ni,
    .in_valid_i(fire), .in_ready_o(far_waiting_ready),
    .in_i('{needed: in_i.needed, zeros: in_i.zeros, t: in_i.base.t, n: in_i.base.n}),
    .out_valid_o(far_waiting_valid), .out_ready_i(waiting_ready), .out_o(far_waiting)
  );
  base_frame_t far_base;
  logic far_base_valid, base_ready;
  stream_register #(.T(base_frame_t)) i_far_base (
    .clk_i, .rst_ni,
    .in_valid_i(fire), .in_ready_o(far_base_ready), .in_i(in_i.base),
    .out_valid_o(far_base_valid), .out_ready_i(base_ready), .out_o(far_base)
  );

  // ---- the maps
  logic normal_valid, normal_ready, displaced_valid, displaced_ready;
  normal_sampler_out_t normal;
  normal_sampler #(.InFlight(InFlight)) i_normal (
    .clk_i,
    .rst_ni,
    .map_i,
    .in_valid_i(far_normal_valid),
    .in_ready_o(normal_in_ready),
    .in_i(far_normal),
    .normal_req_valid_o,
    .normal_req_ready_i,
    .normal_req_o,
    .normal_rsp_valid_i,
    .normal_rsp_i,
    .out_valid_o(normal_valid),
    .out_ready_i(normal_ready),
    .out_o(normal)
  );
  displace_vertex_out_t displaced;
  displace_vertex #(.InFlight(InFlight)) i_displace_vertex (
    .clk_i,
    .rst_ni,
    .map_i,
    .regs_i(displace_i),
    .in_valid_i(far_displace_valid),
    .in_ready_o(displace_in_ready),
    .in_i(far_displace),
    .quad_req_valid_o(place_req_valid_o),
    .quad_req_ready_i(place_req_ready_i),
    .quad_req_o(place_req_o),
    .quad_rsp_valid_i(place_rsp_valid_i),
    .quad_rsp_i(place_rsp_i),
    .out_valid_o(displaced_valid),
    .out_ready_i(displaced_ready),
    .out_o(displaced)
  );
  waiting_t waiting;
  logic     waiting_valid, waiting_leaves;
  logic [$clog2(WaitingDepth+1)-1:0] unused_waiting_count;
  stream_fifo #(.T(waiting_t), .Depth(WaitingDepth)) i_waiting (
    .clk_i, .rst_ni,
    .in_valid_i(far_waiting_valid), .in_ready_o(waiting_ready), .in_i(far_waiting),
    .out_valid_o(waiting_valid), .out_ready_i(waiting_leaves), .out_o(waiting),
    .count_o(unused_waiting_count)
  );
  // Its reader comes long after it, from the lane's far end.
  base_frame_t base;
  logic        base_valid, base_leaves, unused_base_valid;
  logic [$clog2(BaseDepth+1)-1:0] unused_base_count;
  stream_fifo #(.T(base_frame_t), .Depth(BaseDepth)) i_base (
    .clk_i, .rst_ni,
    .in_valid_i(far_base_valid), .in_ready_o(base_ready), .in_i(far_base),
    .out_valid_o(base_valid), .out_ready_i(base_leaves), .out_o(base),
    .count_o(unused_base_count)
  );
  stream_register #(.T(base_frame_t)) i_near_base (
    .clk_i, .rst_ni, .in_valid_i(base_valid), .in_ready_o(base_leaves), .in_i(base),
    .out_valid_o(unused_base_valid), .out_ready_i(base_leaves_i), .out_o(base_o)
  );

  // ---- the join
  logic near_waiting_valid, near_normal_valid, near_displaced_valid, leaves, uses;
  stream_register #(.T(waiting_t)) i_near_waiting (
    .clk_i, .rst_ni, .in_valid_i(waiting_valid), .in_ready_o(waiting_leaves), .in_i(waiting),
    .out_valid_o(near_waiting_valid), .out_ready_i(leaves), .out_o(waiting_o)
  );
  stream_register #(.T(normal_sampler_out_t)) i_near_normal (
    .clk_i, .rst_ni, .in_valid_i(normal_valid), .in_ready_o(normal_ready), .in_i(normal),
    .out_valid_o(near_normal_valid), .out_ready_i(uses), .out_o(normal_o)
  );
  stream_register #(.T(displace_vertex_out_t)) i_near_displaced (
    .clk_i, .rst_ni, .in_valid_i(displaced_valid), .in_ready_o(displaced_ready), .in_i(displaced),
    .out_valid_o(near_displaced_valid), .out_ready_i(uses), .out_o(displaced_o)
  );
  assign out_valid_o = near_waiting_valid
                       && ((near_normal_valid && near_displaced_valid) || !waiting_o.needed);
  assign leaves = out_valid_o && out_ready_i;
  assign uses = leaves && waiting_o.needed;
endmodule

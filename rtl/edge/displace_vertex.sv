// displace_vertex: a vertex onto the displaced surface: P' = P + (s D(U) + b) N.
//   contract: hls/edge/displace_vertex.hpp
//   port  quad_*   read port of the displacement map: quad_request_t, texel_quad_t; the answer comes from registers
//
//   latency 31 + that of the memory (1 when it answers in the next clock), initiation interval 1 while the memory takes and gives a
//   quad a clock and answers within InFlight - 20 clocks; outputs registered, in_ready_o the AND of comparisons of registers
//
//   in.u --[map_sampler]--+--[displace]--> out
//   in.p, in.n --[FIFO]---+
module displace_vertex
  import formats_pkg::*;
  import surface_pkg::*;
  import memory_pkg::*;
  import edge_pkg::*;
#(
  parameter int unsigned InFlight = 128
) (
  input  logic                 clk_i,
  input  logic                 rst_ni,
  input  map_regs_t            map_i,
  input  displace_regs_t       regs_i,
  input  logic                 in_valid_i,
  output logic                 in_ready_o,
  input  displace_vertex_in_t  in_i,
  output logic                 out_valid_o,
  input  logic                 out_ready_i,
  output displace_vertex_out_t out_o,
  output logic                 quad_req_valid_o,
  input  logic                 quad_req_ready_i,
  output quad_request_t        quad_req_o,
  input  logic                 quad_rsp_valid_i,
  input  texel_quad_t          quad_rsp_i
);
  // P and N; a word leaves with its sample.
  typedef struct packed {
    unit_t [2:0] n;
    position_t [2:0] p;
  } beside_t;
  localparam int unsigned CountBits = $clog2(InFlight + 1);

  logic beside_ready, sampler_ready;
  assign in_ready_o = beside_ready && sampler_ready;

  map_sampler_out_t s0_sample;
  logic sample_valid, moves;
  map_sampler #(.InFlight(InFlight)) i_sampler (
    .clk_i,
    .rst_ni,
    .map_i,
    .in_valid_i(in_valid_i && beside_ready),
    .in_ready_o(sampler_ready),
    .in_i(map_sampler_in_t'(in_i.u)),
    .out_valid_o(sample_valid),
    .out_ready_i(moves),
    .out_o(s0_sample),
    .quad_req_valid_o,
    .quad_req_ready_i,
    .quad_req_o,
    .quad_rsp_valid_i,
    .quad_rsp_i
  );

  // What waits here was taken with a sample that comes later than three clocks: it is there when the sample is.
  beside_t beside_in, beside;
  assign beside_in = '{n: in_i.n, p: in_i.p};
  logic unused_valid;
  logic [CountBits-1:0] unused_count;
  stream_fifo #(.T(beside_t), .Depth(InFlight)) i_beside (
    .clk_i,
    .rst_ni,
    .in_valid_i(in_valid_i && sampler_ready),
    .in_ready_o(beside_ready),
    .in_i(beside_in),
    .out_valid_o(unused_valid),
    .out_ready_i(sample_valid && moves),
    .out_o(beside),
    .count_o(unused_count)
  );

  displace_in_t s1_in;
  displace_out_t s1_moved;
  assign s1_in = '{d: s0_sample.d, n: beside.n, p: beside.p};
  displace i_displace (.clk_i, .regs_i, .in_i(s1_in), .out_o(s1_moved));
  stream_pipe #(.T(displace_vertex_out_t), .Latency(latency_pkg::Displace)) i_out (
    .clk_i,
    .rst_ni,
    .in_valid_i(sample_valid),
    .in_ready_o(moves),
    .data_i(displace_vertex_out_t'(s1_moved)),
    .out_valid_o,
    .out_ready_i,
    .out_o
  );
endmodule

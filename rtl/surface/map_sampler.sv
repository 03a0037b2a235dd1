// map_sampler: bilinear sample of the displacement map, D(U).
//   contract: hls/surface/map_sampler.hpp
//   port  quad_*   read port of the displacement map: quad_request_t, texel_quad_t; the answer comes from registers
//
//   latency 18 + that of the memory (1 when it answers in the next clock), initiation interval 1 while the memory takes and gives a
//   quad a clock and answers within InFlight - 20 clocks; all outputs registered, in_ready_o the AND of two comparisons of registers
//
//   in --[quad_reader]--> quad_req ... quad_rsp --[bilinear]--[FIFO of InFlight]--> out
module map_sampler
  import formats_pkg::*;
  import surface_pkg::*;
  import memory_pkg::*;
#(
  parameter int unsigned InFlight = 128
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  map_regs_t        map_i,
  input  logic             in_valid_i,
  output logic             in_ready_o,
  input  map_sampler_in_t  in_i,
  output logic             out_valid_o,
  input  logic             out_ready_i,
  output map_sampler_out_t out_o,
  output logic             quad_req_valid_o,
  input  logic             quad_req_ready_i,
  output quad_request_t    quad_req_o,
  input  logic             quad_rsp_valid_i,
  input  texel_quad_t      quad_rsp_i
);
  fraction_t [1:0] s1_fraction;
  quad_reader #(.InFlight(InFlight)) i_reader (
    .clk_i,
    .rst_ni,
    .map_i,
    .in_valid_i,
    .in_ready_o,
    .in_i(map_address_in_t'(in_i)),
    .req_valid_o(quad_req_valid_o),
    .req_ready_i(quad_req_ready_i),
    .req_o(quad_req_o),
    .rsp_valid_i(quad_rsp_valid_i),
    .fraction_o(s1_fraction),
    .done_i(out_valid_o && out_ready_i)
  );

  map_sampler_out_t sample;
  bilinear #(.Width(16), .Signed(1'b0), .Kept(SampleFraction)) i_bilinear (
    .clk_i, .q_i(quad_rsp_i), .f_i(s1_fraction), .y_o(sample.d)
  );

  // The reader holds words back while all places here are spoken for: the pipe is always ready.
  logic unused_ready;
  stream_pipe #(.T(map_sampler_out_t), .Latency(BilinearLatency), .Depth(InFlight)) i_out (
    .clk_i,
    .rst_ni,
    .in_valid_i(quad_rsp_valid_i),
    .in_ready_o(unused_ready),
    .data_i(sample),
    .out_valid_o,
    .out_ready_i,
    .out_o
  );
endmodule

// normal_sampler: bilinear sample of the normal map, N_D(U), not normalised.
//   contract: hls/surface/normal_sampler.hpp
//   port  normal_*   read port of the normal map: quad_request_t, normal_quad_t; the answer comes from registers
//
//   latency 18 + that of the memory (1 when it answers in the next clock), initiation interval 1 while the memory takes and gives a
//   quad a clock and answers within InFlight - 20 clocks; all outputs registered, in_ready_o the AND of two comparisons of registers
//
//   in --[quad_reader]--> normal_req ... normal_rsp --[3 bilinear]--[FIFO of InFlight]--> out
module normal_sampler
  import formats_pkg::*;
  import surface_pkg::*;
  import memory_pkg::*;
#(
  parameter int unsigned InFlight = 128
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  input  map_regs_t           map_i,
  input  logic                in_valid_i,
  output logic                in_ready_o,
  input  normal_sampler_in_t  in_i,
  output logic                out_valid_o,
  input  logic                out_ready_i,
  output normal_sampler_out_t out_o,
  output logic                normal_req_valid_o,
  input  logic                normal_req_ready_i,
  output quad_request_t       normal_req_o,
  input  logic                normal_rsp_valid_i,
  input  normal_quad_t        normal_rsp_i
);
  fraction_t [1:0] s1_fraction;
  quad_reader #(.InFlight(InFlight)) i_reader (
    .clk_i,
    .rst_ni,
    .map_i,
    .in_valid_i,
    .in_ready_o,
    .in_i(map_address_in_t'(in_i)),
    .req_valid_o(normal_req_valid_o),
    .req_ready_i(normal_req_ready_i),
    .req_o(normal_req_o),
    .rsp_valid_i(normal_rsp_valid_i),
    .fraction_o(s1_fraction),
    .done_i(out_valid_o && out_ready_i)
  );

  normal_sampler_out_t normal;
  for (genvar i = 0; i < 3; i++) begin : gen_component
    unit_t [1:0][1:0] quad;
    for (genvar row = 0; row < 2; row++) begin : gen_row
      assign quad[row] = {normal_rsp_i[row][1][i], normal_rsp_i[row][0][i]};
    end
    bilinear #(.Width(16), .Signed(1'b1), .Kept(0)) i_bilinear (
      .clk_i, .q_i(quad), .f_i(s1_fraction), .y_o(normal.n[i])
    );
  end

  // The reader holds words back while all places here are spoken for: the pipe is always ready.
  logic unused_ready;
  stream_pipe #(.T(normal_sampler_out_t), .Latency(BilinearLatency), .Depth(InFlight)) i_out (
    .clk_i,
    .rst_ni,
    .in_valid_i(normal_rsp_valid_i),
    .in_ready_o(unused_ready),
    .data_i(normal),
    .out_valid_o,
    .out_ready_i,
    .out_o
  );
endmodule

// relievo_engine: the whole engine as somebody else would hand it over (docs/foreign_rtl.md): the ports of rtl/edge/engine.sv at the widths of
// one lane, 12 table reads and 4 samples of a profile a clock, as plain vectors, and a FIFO at either end, so that no clock is that of ours.
// Within it is the house's own circuit.
`timescale 1 ns / 1 ps
module relievo_engine (
  input  wire          clk_i,
  input  wire          rst_ni,
  input  wire          start_i,
  input  wire          end_i,
  output wire          done_o,
  output wire          error_o,
  input  wire [924:0]  regs_i,
  output wire [1471:0] counters_o,

  input  wire          in_valid_i,
  output wire          in_ready_o,
  input  wire [686:0]  in_i,

  output wire          table_req_valid_o,
  input  wire          table_req_ready_i,
  output wire [347:0]  table_req_o,
  input  wire          table_rsp_valid_i,
  input  wire [479:0]  table_rsp_i,

  output wire          quad_req_valid_o,
  input  wire          quad_req_ready_i,
  output wire [223:0]  quad_req_o,
  output wire [3:0]    quad_req_mask_o,
  input  wire          quad_rsp_valid_i,
  input  wire [255:0]  quad_rsp_i,

  output wire          place_req_valid_o,
  input  wire          place_req_ready_i,
  output wire [55:0]   place_req_o,
  input  wire          place_rsp_valid_i,
  input  wire [63:0]   place_rsp_i,

  output wire          normal_req_valid_o,
  input  wire          normal_req_ready_i,
  output wire [55:0]   normal_req_o,
  input  wire          normal_rsp_valid_i,
  input  wire [191:0]  normal_rsp_i,

  output wire          out_valid_o,
  input  wire          out_ready_i,
  output wire [1269:0] out_o
);
  wire base_valid, base_ready, made_valid, made_ready;
  wire [686:0] base;
  wire [1269:0] made;
  stream_fifo #(.T(logic [686:0]), .Depth(4)) regslice_in_U (
    .clk_i(clk_i),
    .rst_ni(rst_ni),
    .in_valid_i(in_valid_i),
    .in_ready_o(in_ready_o),
    .in_i(in_i),
    .out_valid_o(base_valid),
    .out_ready_i(base_ready),
    .out_o(base),
    .count_o()
  );
  engine grp_engine_fu (
    .clk_i(clk_i),
    .rst_ni(rst_ni),
    .start_i(start_i),
    .end_i(end_i),
    .done_o(done_o),
    .error_o(error_o),
    .regs_i(regs_i),
    .counters_o(counters_o),
    .in_valid_i(base_valid),
    .in_ready_o(base_ready),
    .in_i(base),
    .table_req_valid_o(table_req_valid_o),
    .table_req_ready_i(table_req_ready_i),
    .table_req_o(table_req_o),
    .table_rsp_valid_i(table_rsp_valid_i),
    .table_rsp_i(table_rsp_i),
    .quad_req_valid_o(quad_req_valid_o),
    .quad_req_ready_i(quad_req_ready_i),
    .quad_req_o(quad_req_o),
    .quad_req_mask_o(quad_req_mask_o),
    .quad_rsp_valid_i(quad_rsp_valid_i),
    .quad_rsp_i(quad_rsp_i),
    .place_req_valid_o(place_req_valid_o),
    .place_req_ready_i(place_req_ready_i),
    .place_req_o(place_req_o),
    .place_rsp_valid_i(place_rsp_valid_i),
    .place_rsp_i(place_rsp_i),
    .normal_req_valid_o(normal_req_valid_o),
    .normal_req_ready_i(normal_req_ready_i),
    .normal_req_o(normal_req_o),
    .normal_rsp_valid_i(normal_rsp_valid_i),
    .normal_rsp_i(normal_rsp_i),
    .out_valid_o(made_valid),
    .out_ready_i(made_ready),
    .out_o(made)
  );
  stream_fifo #(.T(logic [1269:0]), .Depth(4)) regslice_out_U (
    .clk_i(clk_i),
    .rst_ni(rst_ni),
    .in_valid_i(made_valid),
    .in_ready_o(made_ready),
    .in_i(made),
    .out_valid_o(out_valid_o),
    .out_ready_i(out_ready_i),
    .out_o(out_o),
    .count_o()
  );
endmodule

// relievo_view_test: view_test as an HLS tool hands it over without the pragmas of hls/top/view_test.cpp for registers and block control,
// written by hand: ap_ctrl_hs around the calls, the registers on a port, reset active high. Within it is the house's own circuit.
//   in_r, out_r   AXI4-Stream, 96 and 8 bits;  regs   24 bits, constant while calls run
//   ap_start      calls may begin;  ap_ready: one has taken its word;  ap_done: one has put out its word;  ap_idle: none is under way
//   latency 7, initiation interval 1
`timescale 1 ns / 1 ps
module relievo_view_test (
  input  wire        ap_clk,
  input  wire        ap_rst,
  input  wire        ap_start,
  output wire        ap_done,
  output wire        ap_idle,
  output wire        ap_ready,
  input  wire [95:0] in_r_TDATA,
  input  wire        in_r_TVALID,
  output wire        in_r_TREADY,
  input  wire [23:0] regs,
  output wire [7:0]  out_r_TDATA,
  output wire        out_r_TVALID,
  input  wire        out_r_TREADY
);
  wire vt, pipe_ready;
  view_test grp_view_test_fu (
    .clk_i(ap_clk), .regs_i(regs), .in_i(in_r_TDATA[89:0]), .out_o(vt)
  );
  stream_pipe #(.T(logic), .Latency(4)) regslice_both_U (
    .clk_i(ap_clk),
    .rst_ni(!ap_rst),
    .in_valid_i(in_r_TVALID && ap_start),
    .in_ready_o(pipe_ready),
    .data_i(vt),
    .out_valid_o(out_r_TVALID),
    .out_ready_i(out_r_TREADY),
    .out_o(out_r_TDATA[0])
  );
  assign out_r_TDATA[7:1] = 7'd0;
  assign in_r_TREADY = pipe_ready && ap_start;

  reg [7:0] under_way;
  assign ap_ready = in_r_TVALID && in_r_TREADY;
  assign ap_done = out_r_TVALID && out_r_TREADY;
  assign ap_idle = !ap_start && under_way == 8'd0;
  always @(posedge ap_clk) begin
    if (ap_rst) under_way <= 8'd0;
    else under_way <= under_way + {7'd0, ap_ready} - {7'd0, ap_done};
  end
endmodule

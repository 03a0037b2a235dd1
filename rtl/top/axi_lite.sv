// axi_lite: AXI4-Lite of 32 bits in front of a register block with PeakRDL's passthrough interface, one access after the other.
//   PeakRDL has an AXI4-Lite of its own, which decides between read and write and decodes the address in one clock: 89 MHz in front of
//   these registers. Here the block sees a request that comes from registers.
//   in    s_axil   addresses in bytes; the lowest two bits are ignored, as AXI4-Lite has it
//   out   req_o    for one clock, with everything of the request; the block's *_ack_i answer it, in the same clock or any later
//         An error of the block is SLVERR. Reads and writes that wait together take turns.
//
//   latency 2 to the request and 1 from its answer; initiation interval: the next access begins when the answer is taken, so with a
//   block that answers a write in its clock and a read in the next, 4 and 5 clocks. Registered: all outputs.
module axi_lite #(
  parameter int unsigned AddressBits = 12
) (
  input  logic                   clk_i,
  input  logic                   rst_ni,

  // verilog_lint: waive-start port-name-suffix  the bus standard's own names
  input  logic [AddressBits-1:0] s_axil_awaddr,
  input  logic                   s_axil_awvalid,
  output logic                   s_axil_awready,
  input  logic [31:0]            s_axil_wdata,
  input  logic [3:0]             s_axil_wstrb,
  input  logic                   s_axil_wvalid,
  output logic                   s_axil_wready,
  output logic [1:0]             s_axil_bresp,
  output logic                   s_axil_bvalid,
  input  logic                   s_axil_bready,
  input  logic [AddressBits-1:0] s_axil_araddr,
  input  logic                   s_axil_arvalid,
  output logic                   s_axil_arready,
  output logic [31:0]            s_axil_rdata,
  output logic [1:0]             s_axil_rresp,
  output logic                   s_axil_rvalid,
  input  logic                   s_axil_rready,
  // verilog_lint: waive-stop port-name-suffix

  output logic                   req_o,
  output logic                   req_is_wr_o,
  output logic [AddressBits-1:0] addr_o,
  output logic [31:0]            wr_data_o,
  output logic [31:0]            wr_biten_o,
  input  logic                   rd_ack_i,
  input  logic                   rd_err_i,
  input  logic [31:0]            rd_data_i,
  input  logic                   wr_ack_i,
  input  logic                   wr_err_i
);
  localparam logic [1:0] Okay = 2'b00, SlaveError = 2'b10;

  // A channel's register takes a word when it is empty.
  logic aw_ready_q, w_ready_q, ar_ready_q, b_valid_q, r_valid_q, busy_q, req_q, is_wr_q;
  logic [AddressBits-1:2] aw_q, ar_q, addr_q;
  logic [3:0] unused_low;
  assign unused_low = {s_axil_awaddr[1:0], s_axil_araddr[1:0]};
  logic [31:0] w_q, data_q;
  logic [3:0]  strb_q, biten_q;
  logic [1:0]  b_resp_q, r_resp_q;
  logic [31:0] r_data_q;

  logic can_write, can_read, write, read, answered;
  assign can_write = !aw_ready_q && !w_ready_q;
  assign can_read = !ar_ready_q;
  // is_wr_q is what came last.
  assign write = !busy_q && can_write && !(can_read && is_wr_q);
  assign read = !busy_q && can_read && !write;
  assign answered = (b_valid_q && s_axil_bready) || (r_valid_q && s_axil_rready);

  always_ff @(posedge clk_i) begin
    if (s_axil_awvalid && aw_ready_q) aw_q <= s_axil_awaddr[AddressBits-1:2];
    if (s_axil_wvalid && w_ready_q) begin
      w_q <= s_axil_wdata;
      strb_q <= s_axil_wstrb;
    end
    if (s_axil_arvalid && ar_ready_q) ar_q <= s_axil_araddr[AddressBits-1:2];
    if (write || read) begin
      addr_q <= write ? aw_q : ar_q;
      data_q <= w_q;
      biten_q <= strb_q;
    end
    if (wr_ack_i) b_resp_q <= wr_err_i ? SlaveError : Okay;
    if (rd_ack_i) begin
      r_resp_q <= rd_err_i ? SlaveError : Okay;
      r_data_q <= rd_data_i;
    end
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      aw_ready_q <= 1'b1;
      w_ready_q <= 1'b1;
      ar_ready_q <= 1'b1;
      b_valid_q <= 1'b0;
      r_valid_q <= 1'b0;
      busy_q <= 1'b0;
      req_q <= 1'b0;
      is_wr_q <= 1'b0;
    end else begin
      aw_ready_q <= aw_ready_q ? !s_axil_awvalid : write;
      w_ready_q <= w_ready_q ? !s_axil_wvalid : write;
      ar_ready_q <= ar_ready_q ? !s_axil_arvalid : read;
      req_q <= write || read;
      if (write || read) is_wr_q <= write;
      busy_q <= write || read || (busy_q && !answered);
      b_valid_q <= wr_ack_i || (b_valid_q && !s_axil_bready);
      r_valid_q <= rd_ack_i || (r_valid_q && !s_axil_rready);
    end
  end

  assign s_axil_awready = aw_ready_q;
  assign s_axil_wready = w_ready_q;
  assign s_axil_arready = ar_ready_q;
  assign s_axil_bvalid = b_valid_q;
  assign s_axil_bresp = b_resp_q;
  assign s_axil_rvalid = r_valid_q;
  assign s_axil_rresp = r_resp_q;
  assign s_axil_rdata = r_data_q;
  assign req_o = req_q;
  assign req_is_wr_o = is_wr_q;
  assign addr_o = {addr_q, 2'b00};
  assign wr_data_o = data_q;
  always_comb for (int i = 0; i < 32; ++i) wr_biten_o[i] = biten_q[i/8];
endmodule

// relievo_displace: displace as an HLS tool hands it over, written by hand: the ports that Vitis HLS makes of hls/top/displace.cpp, whose
// pragmas say axis for the words, s_axilite for the registers and ap_ctrl_none. Within it is the house's own circuit.
//   in_r, out_r     AXI4-Stream, 144 and 80 bits, words packed as the entry point's header says, padded with zeros
//   s_axi_control   AXI4-Lite: regs, 48 bits, at 0x10 (bits 31..0) and 0x14 (bits 47..32)
//   reset active low; latency 13, initiation interval 1
`timescale 1 ns / 1 ps
module relievo_displace (
  input  wire         ap_clk,
  input  wire         ap_rst_n,
  input  wire [143:0] in_r_TDATA,
  input  wire         in_r_TVALID,
  output wire         in_r_TREADY,
  output wire [79:0]  out_r_TDATA,
  output wire         out_r_TVALID,
  input  wire         out_r_TREADY,
  input  wire         s_axi_control_AWVALID,
  output wire         s_axi_control_AWREADY,
  input  wire [4:0]   s_axi_control_AWADDR,
  input  wire         s_axi_control_WVALID,
  output wire         s_axi_control_WREADY,
  input  wire [31:0]  s_axi_control_WDATA,
  input  wire [3:0]   s_axi_control_WSTRB,
  input  wire         s_axi_control_ARVALID,
  output wire         s_axi_control_ARREADY,
  input  wire [4:0]   s_axi_control_ARADDR,
  output wire         s_axi_control_RVALID,
  input  wire         s_axi_control_RREADY,
  output wire [31:0]  s_axi_control_RDATA,
  output wire [1:0]   s_axi_control_RRESP,
  output wire         s_axi_control_BVALID,
  input  wire         s_axi_control_BREADY,
  output wire [1:0]   s_axi_control_BRESP
);
  wire [63:0] regs;
  relievo_displace_control_s_axi control_s_axi_U (
    .ACLK(ap_clk),
    .ARESETN(ap_rst_n),
    .AWVALID(s_axi_control_AWVALID),
    .AWREADY(s_axi_control_AWREADY),
    .AWADDR(s_axi_control_AWADDR),
    .WVALID(s_axi_control_WVALID),
    .WREADY(s_axi_control_WREADY),
    .WDATA(s_axi_control_WDATA),
    .WSTRB(s_axi_control_WSTRB),
    .ARVALID(s_axi_control_ARVALID),
    .ARREADY(s_axi_control_ARREADY),
    .ARADDR(s_axi_control_ARADDR),
    .RVALID(s_axi_control_RVALID),
    .RREADY(s_axi_control_RREADY),
    .RDATA(s_axi_control_RDATA),
    .RRESP(s_axi_control_RRESP),
    .BVALID(s_axi_control_BVALID),
    .BREADY(s_axi_control_BREADY),
    .BRESP(s_axi_control_BRESP),
    .regs(regs)
  );

  wire [72:0] data;
  displace grp_displace_fu (
    .clk_i(ap_clk), .regs_i(regs[47:0]), .in_i(in_r_TDATA[139:0]), .out_o(data)
  );
  stream_pipe #(.T(logic [72:0]), .Latency(10)) regslice_both_U (
    .clk_i(ap_clk),
    .rst_ni(ap_rst_n),
    .in_valid_i(in_r_TVALID),
    .in_ready_o(in_r_TREADY),
    .data_i(data),
    .out_valid_o(out_r_TVALID),
    .out_ready_i(out_r_TREADY),
    .out_o(out_r_TDATA[72:0])
  );
  assign out_r_TDATA[79:73] = 7'd0;
endmodule

// The register file: one write and one read at a time, all of them taken a clock after they are offered.
module relievo_displace_control_s_axi (
  input  wire         ACLK,
  input  wire         ARESETN,
  input  wire         AWVALID,
  output wire         AWREADY,
  input  wire [4:0]   AWADDR,
  input  wire         WVALID,
  output wire         WREADY,
  input  wire [31:0]  WDATA,
  input  wire [3:0]   WSTRB,
  input  wire         ARVALID,
  output wire         ARREADY,
  input  wire [4:0]   ARADDR,
  output wire         RVALID,
  input  wire         RREADY,
  output wire [31:0]  RDATA,
  output wire [1:0]   RRESP,
  output wire         BVALID,
  input  wire         BREADY,
  output wire [1:0]   BRESP,
  output wire [63:0]  regs
);
  localparam [4:0] ADDR_REGS_0 = 5'h10;
  localparam [4:0] ADDR_REGS_1 = 5'h14;
  localparam [1:0] WRIDLE = 2'd0, WRDATA = 2'd1, WRRESP = 2'd2;

  reg [1:0]  wstate;
  reg [4:0]  waddr;
  reg [63:0] int_regs;
  assign AWREADY = wstate == WRIDLE;
  assign WREADY = wstate == WRDATA;
  assign BVALID = wstate == WRRESP;
  assign BRESP = 2'b00;
  assign regs = int_regs;
  wire [31:0] mask = {{8{WSTRB[3]}}, {8{WSTRB[2]}}, {8{WSTRB[1]}}, {8{WSTRB[0]}}};
  always @(posedge ACLK) begin
    if (!ARESETN) begin
      wstate <= WRIDLE;
      int_regs <= 64'd0;
    end else begin
      case (wstate)
        WRIDLE:
        if (AWVALID) begin
          wstate <= WRDATA;
          waddr <= AWADDR;
        end
        WRDATA:
        if (WVALID) begin
          wstate <= WRRESP;
          if (waddr == ADDR_REGS_0) int_regs[31:0] <= (WDATA & mask) | (int_regs[31:0] & ~mask);
          if (waddr == ADDR_REGS_1) int_regs[63:32] <= (WDATA & mask) | (int_regs[63:32] & ~mask);
        end
        default: if (BREADY) wstate <= WRIDLE;
      endcase
    end
  end

  reg        rvalid;
  reg [31:0] rdata;
  assign ARREADY = !rvalid;
  assign RVALID = rvalid;
  assign RDATA = rdata;
  assign RRESP = 2'b00;
  always @(posedge ACLK) begin
    if (!ARESETN) rvalid <= 1'b0;
    else if (ARVALID && ARREADY) rvalid <= 1'b1;
    else if (RREADY) rvalid <= 1'b0;
    if (ARVALID && ARREADY) rdata <= ARADDR == ADDR_REGS_0 ? int_regs[31:0] : ARADDR == ADDR_REGS_1 ? int_regs[63:32] : 32'd0;
  end
endmodule

// spoilt_displace: relievo_displace, and with +spoil=KIND a broken copy of it, each of which the bench has to refuse:
//   word      now and then the lowest bit of p[1] is wrong (where a word of the normal and one of the displacement are zero)
//   regs      the upper half of the registers is never written
//   padding   a bit beside the word is not zero
//   drop      TVALID falls when a word has waited for three clocks
//   change    a word changes while it waits
//   lost      every 100th word is taken and never comes out
//   twice     the 100th word comes out twice
//   hang      after 200 words none is taken any more
//   reset     TVALID is 1 in reset
//   slow      a word is taken every other clock
//   axi       a write is answered with an error
// None: what comes in goes through.
`timescale 1 ns / 1 ps
module spoilt_displace (
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
  reg word, regs, padding, drop, change, lost, twice, hang, in_reset, slow, axi;
  initial begin
    word = $test$plusargs("spoil=word") != 0;
    regs = $test$plusargs("spoil=regs") != 0;
    padding = $test$plusargs("spoil=padding") != 0;
    drop = $test$plusargs("spoil=drop") != 0;
    change = $test$plusargs("spoil=change") != 0;
    lost = $test$plusargs("spoil=lost") != 0;
    twice = $test$plusargs("spoil=twice") != 0;
    hang = $test$plusargs("spoil=hang") != 0;
    in_reset = $test$plusargs("spoil=reset") != 0;
    slow = $test$plusargs("spoil=slow") != 0;
    axi = $test$plusargs("spoil=axi") != 0;
  end

  reg [15:0] taken, left;
  reg [1:0]  waited;
  reg        phase;
  wire       open = !(hang && taken == 16'd200) && !(slow && phase);
  wire       skip = lost && taken % 100 == 99;
  wire       again = twice && left == 16'd99;
  wire       dropped = drop && waited == 2'd3;
  wire       inner_in_ready, inner_out_valid;
  wire [79:0] inner_out;
  wire [1:0] inner_bresp;
  relievo_displace inner (
    .ap_clk(ap_clk),
    .ap_rst_n(ap_rst_n),
    .in_r_TDATA(in_r_TDATA),
    .in_r_TVALID(in_r_TVALID && open && !skip),
    .in_r_TREADY(inner_in_ready),
    .out_r_TDATA(inner_out),
    .out_r_TVALID(inner_out_valid),
    .out_r_TREADY(out_r_TREADY && !dropped && !again),
    .s_axi_control_AWVALID(s_axi_control_AWVALID),
    .s_axi_control_AWREADY(s_axi_control_AWREADY),
    .s_axi_control_AWADDR(regs && s_axi_control_AWADDR == 5'h14 ? 5'h18 : s_axi_control_AWADDR),
    .s_axi_control_WVALID(s_axi_control_WVALID),
    .s_axi_control_WREADY(s_axi_control_WREADY),
    .s_axi_control_WDATA(s_axi_control_WDATA),
    .s_axi_control_WSTRB(s_axi_control_WSTRB),
    .s_axi_control_ARVALID(s_axi_control_ARVALID),
    .s_axi_control_ARREADY(s_axi_control_ARREADY),
    .s_axi_control_ARADDR(s_axi_control_ARADDR),
    .s_axi_control_RVALID(s_axi_control_RVALID),
    .s_axi_control_RREADY(s_axi_control_RREADY),
    .s_axi_control_RDATA(s_axi_control_RDATA),
    .s_axi_control_RRESP(s_axi_control_RRESP),
    .s_axi_control_BVALID(s_axi_control_BVALID),
    .s_axi_control_BREADY(s_axi_control_BREADY),
    .s_axi_control_BRESP(inner_bresp)
  );
  assign s_axi_control_BRESP = axi ? 2'b10 : inner_bresp;
  assign in_r_TREADY = inner_in_ready && open;
  assign out_r_TVALID = (inner_out_valid && !dropped) || (in_reset && !ap_rst_n);
  wire wrong = word && inner_out[28:24] == 5'd9 && inner_out[52:48] == 5'd3;
  assign out_r_TDATA = inner_out ^ {6'd0, padding, 48'd0, wrong || (change && waited != 2'd0), 24'd0};

  always @(posedge ap_clk) begin
    phase <= !phase;
    if (!ap_rst_n) begin
      taken <= 16'd0;
      left <= 16'd0;
      waited <= 2'd0;
      phase <= 1'b0;
    end else begin
      if (in_r_TVALID && in_r_TREADY) taken <= taken + 16'd1;
      if (out_r_TVALID && out_r_TREADY) left <= left + 16'd1;
      waited <= out_r_TVALID && !out_r_TREADY ? waited + {1'b0, waited != 2'd3} : 2'd0;
    end
  end
endmodule

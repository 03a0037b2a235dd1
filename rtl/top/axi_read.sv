// axi_read: serves one read port of a map memory from memory behind an AXI4 bus.
//   word (x, y) lies at base + WordBytes (y width + x), row by row from v = 0, x fastest
//   parameters  Words a request asks for together; WordBytes in memory, a power of two, of which the
//               lowest WordBits are answered; AddressBits up to 48; DataBytes of the bus, a power of
//               two not below WordBytes; Outstanding beats on the bus, more than its latency and 8
//               for a beat every clock; Pairs: words 2i and 2i + 1 of a request are mostly
//               neighbours in a row, and one burst then
//   in    base_i, width_i   constant while requests are inside; base_i is a multiple of WordBytes
//         req_i[i]          words within the map; one without read is not fetched, and its place in
//                           the answer holds anything
//   out   rsp_o[i]          answers in the order of the requests; cannot be refused (memory_pkg.sv)
//         error_o           for one clock with an answer's last word: a beat came with rresp other
//                           than OKAY. The word is what the bus gave.
//   m_axi                   INCR bursts with beats of WordBytes, all with the same ID: answered in
//                           order. arlen is 1 for two words of a pair, both read, of which the
//                           second lies behind the first in memory and not in the next 4 KB; 0, one
//                           beat, for any other: columns that wrap or are clamped, a page's end.
//                           arprot is 0: data, secure, unprivileged. AXI4 lets a master leave out
//                           arid, arlock, arcache, arqos and arregion; the bus takes them as 0:
//                           one ID, no exclusive access, device memory, no priority, one region
//
//   latency 10 and the memory's: 9 clocks from the request to arvalid, 1 from the last beat to
//   rsp_valid_o; initiation interval: a clock for each word with read set, at least one a request,
//   as each is a beat. A burst saves an address, not a beat.
//   Registered: all outputs, but for a gate at arvalid and rready; no path from a ready input to a
//   ready output. A reset is one for the bus too: beats of before are not expected after it.
//
//   req --> [pick] --> [s0 y width] --> [s1 + x] --> [s2 base +] --> FIFO --+--> ar
//                                                                           |
//   rsp <-- [words] <---------------- r, in the order of the -------------FIFO
module axi_read
  import formats_pkg::*;
  import memory_pkg::*;
#(
  parameter int unsigned Words = 1,
  parameter int unsigned WordBytes = 8,
  parameter int unsigned WordBits = 8 * WordBytes,
  parameter int unsigned AddressBits = 32,
  parameter int unsigned DataBytes = 8,
  parameter int unsigned Outstanding = 128,
  parameter bit          Pairs = 1'b0
) (
  // verilog_lint: waive-start port-name-suffix  the bus standard's own names
  input  logic aclk,
  input  logic aresetn,

  input  logic [AddressBits-1:0] base_i,
  input  map_size_t              width_i,
  output logic                   error_o,

  input  logic                            req_valid_i,
  output logic                            req_ready_o,
  input  table_request_t [Words-1:0]      req_i,
  output logic                            rsp_valid_o,
  output logic [Words-1:0][WordBits-1:0]  rsp_o,

  output logic [AddressBits-1:0] m_axi_araddr,
  output logic [7:0]             m_axi_arlen,
  output logic [2:0]             m_axi_arsize,
  output logic [1:0]             m_axi_arburst,
  output logic [2:0]             m_axi_arprot,
  output logic                   m_axi_arvalid,
  input  logic                   m_axi_arready,
  input  logic [8*DataBytes-1:0] m_axi_rdata,
  input  logic [1:0]             m_axi_rresp,
  input  logic                   m_axi_rlast,
  input  logic                   m_axi_rvalid,
  output logic                   m_axi_rready
  // verilog_lint: waive-stop port-name-suffix
);
  if (DataBytes < WordBytes) begin : gen_data_bytes
    $error("DataBytes is WordBytes at least");
  end
  if (Pairs && Words % 2 != 0) begin : gen_pairs
    $error("with Pairs Words is even");
  end
  localparam int unsigned PlaceBits = Words > 1 ? $clog2(Words) : 1;
  localparam int unsigned WordShift = $clog2(WordBytes);
  localparam int unsigned LaneBits = DataBytes > WordBytes ? $clog2(DataBytes / WordBytes) : 1;

  // Which word of its request a beat is. A request that reads nothing takes a turn without a beat.
  typedef struct packed {
    logic                 beat;
    logic                 last;
    logic [PlaceBits-1:0] place;
  } order_t;
  typedef struct packed {
    order_t                 order;
    logic                   asks;   // an address goes out: this beat begins a burst
    logic                   burst;  // of two beats
    logic [AddressBits-1:0] address;
  } issue_t;
  // Its part in a pair of neighbours, if it has one.
  typedef struct packed {
    logic first;
    logic second;
  } pair_t;
  typedef struct packed {
    order_t              order;
    logic [LaneBits-1:0] lane;
  } beat_t;

  // pick: the lowest word of the request that has not been asked for.
  table_request_t [Words-1:0] request_q;
  logic [Words-1:0]           left_q, left_after, reads, paired, paired_q;
  logic                       held_q, pipe_ready, pick, take;
  order_t                     order;
  pair_t                      pair;
  always_comb begin
    order.place = '0;
    for (int i = Words - 1; i >= 0; i--) begin
      if (left_q[i]) order.place = PlaceBits'(i);
    end
    left_after = left_q & (left_q - Words'(1));
    order.beat = left_q != '0;
    order.last = left_after == '0;
    for (int i = 0; i < Words; i++) reads[i] = req_i[i].read;
    pair.first = order.beat && paired_q[order.place] && !order.place[0];
    pair.second = order.beat && paired_q[order.place] && order.place[0];
  end
  // Columns beside each other in one row.
  if (Pairs) begin : gen_paired
    for (genvar i = 0; i < Words; i += 2) begin : gen_pair
      logic beside;
      assign beside = reads[i] && reads[i+1] && req_i[i].y == req_i[i+1].y &&
                      {1'b0, req_i[i+1].x} == {1'b0, req_i[i].x} + 15'd1;
      assign paired[i+:2] = {2{beside}};
    end
  end else begin : gen_single
    assign paired = '0;
  end
  assign pick = held_q && pipe_ready;
  assign req_ready_o = !held_q || (pipe_ready && order.last);
  assign take = req_valid_i && req_ready_o;
  always_ff @(posedge aclk) begin
    if (!aresetn) begin
      held_q <= 1'b0;
    end else begin
      if (take) held_q <= 1'b1;
      else if (pick && order.last) held_q <= 1'b0;
    end
    if (take) begin
      request_q <= req_i;
      left_q <= reads;
      paired_q <= paired;
    end else if (pick) begin
      left_q <= left_after;
    end
  end

  // s0: y width. s1: + x. s2: base + WordBytes times that.
  map_size_t              s0_x_q, s0_y_q, s0_x_later;
  order_t                 s0_order_q;
  logic signed [29:0]     s0_row;
  logic [28:0]            s1_index_q;
  logic [AddressBits-1:0] s2_address_q;
  pair_t                  s0_pair_q, s2_pair;
  order_t                 s2_order;
  issue_t                 issue, ar;
  always_ff @(posedge aclk) begin
    s0_x_q <= request_q[order.place].x;
    s0_y_q <= request_q[order.place].y;
    s0_order_q <= order;
    s0_pair_q <= pair;
    s1_index_q <= s0_row[28:0] + 29'(s0_x_later);
    s2_address_q <= base_i + (AddressBits'(s1_index_q) << WordShift);
  end
  multiply #(.A(15), .B(15)) i_row (
    .clk_i(aclk), .a_i(signed'({1'b0, s0_y_q})), .b_i(signed'({1'b0, width_i})), .y_o(s0_row)
  );
  delay #(.T(map_size_t), .Stages(2)) i_x (.clk_i(aclk), .x_i(s0_x_q), .y_o(s0_x_later));
  delay #(.T(order_t), .Stages(4)) i_order (
    .clk_i(aclk), .x_i(s0_order_q), .y_o(s2_order)
  );
  delay #(.T(pair_t), .Stages(4)) i_pair (.clk_i(aclk), .x_i(s0_pair_q), .y_o(s2_pair));
  // No burst crosses 4 KB: a pair that does is two of one beat. The first word knows it by being a
  // page's last, the second by being one's first.
  logic [11:WordShift] in_page;
  assign in_page = s2_address_q[11:WordShift];
  assign issue = '{
      order: s2_order,
      asks: s2_order.beat && !(s2_pair.second && in_page != '0),
      burst: s2_pair.first && in_page != '1,
      address: s2_address_q
  };
  logic ar_valid, ar_leaves, beats_ready;
  stream_pipe #(.T(issue_t), .Latency(5)) i_pipe (
    .clk_i(aclk),
    .rst_ni(aresetn),
    .in_valid_i(held_q),
    .in_ready_o(pipe_ready),
    .data_i(issue),
    .out_valid_o(ar_valid),
    .out_ready_i(ar_leaves),
    .out_o(ar)
  );

  // An address goes out when there is a place for its beat; beats_ready falls only when one went.
  // A burst's second beat follows behind it without an address and finds its place when it comes
  // there: of all places one is kept for it, so that no more beats are outstanding than promised.
  assign m_axi_araddr = ar.address;
  assign m_axi_arlen = {7'd0, ar.burst};
  assign m_axi_arsize = 3'(WordShift);
  assign m_axi_arburst = 2'b01;
  assign m_axi_arprot = 3'b000;
  assign m_axi_arvalid = ar_valid && ar.asks && beats_ready;
  assign ar_leaves = beats_ready && (m_axi_arready || !ar.asks);

  // The beats that are to come, in order.
  beat_t                              beat_in, beat;
  logic                               beat_valid, beat_leaves;
  localparam int unsigned Places = Outstanding - 32'(Pairs);
  logic [$clog2(Places + 1)-1:0]      unused_count;
  assign beat_in.order = ar.order;
  if (DataBytes > WordBytes) begin : gen_lane
    assign beat_in.lane = ar.address[WordShift+:LaneBits];
  end else begin : gen_no_lane
    assign beat_in.lane = '0;
  end
  stream_fifo #(.T(beat_t), .Depth(Places)) i_beats (
    .clk_i(aclk),
    .rst_ni(aresetn),
    .in_valid_i(ar_valid && ar_leaves),
    .in_ready_o(beats_ready),
    .in_i(beat_in),
    .out_valid_o(beat_valid),
    .out_ready_i(beat_leaves),
    .out_o(beat),
    .count_o(unused_count)
  );
  assign m_axi_rready = beat_valid && beat.order.beat;
  assign beat_leaves = m_axi_rvalid || !beat.order.beat;

  // The answer: whole with its last beat, for one clock.
  logic failed, failed_q;
  assign failed = (m_axi_rready && m_axi_rresp != 2'b00) || failed_q;
  always_ff @(posedge aclk) begin
    if (!aresetn) begin
      rsp_valid_o <= 1'b0;
      error_o <= 1'b0;
      failed_q <= 1'b0;
    end else begin
      rsp_valid_o <= beat_valid && beat_leaves && beat.order.last;
      error_o <= beat_valid && beat_leaves && beat.order.last && failed;
      if (beat_valid && beat_leaves) failed_q <= failed && !beat.order.last;
    end
    if (m_axi_rready) begin
      rsp_o[beat.order.place] <= m_axi_rdata[8*WordBytes*beat.lane+:WordBits];
    end
  end

  logic unused_bits;
  assign unused_bits = ^{m_axi_rlast, s0_row[29]};
endmodule

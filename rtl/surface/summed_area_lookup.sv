// summed_area_lookup: the sums of the map over rectangles, by four words of its summed-area table each.
//   S = SAT(x1, y1) - SAT(x0, y1) - SAT(x1, y0) + SAT(x0, y0), modulo 2^40       contract: hls/surface/summed_area_lookup.hpp
//   parameters  ReadsPerClock  1 or 4 words a clock for each rectangle
//               Lookups        so many rectangles side by side, asked for and answered together
//               InFlight       clocks that requests and results may be under way at full rate
//   in    in_i[]    rectangles [x0, x1) x [y0, y1), at most 6 turns beyond a wrapped axis
//   out   out_o[]   their sums;  area_o  texels of the last one, clipped or not
//   table one beat: ReadsPerClock words of each rectangle, its corners in the order (high, high), (low, high), (high, low), (low, low)
//
//   latency 48 + that of the memory, from the last beat on; initiation interval 4/ReadsPerClock beats a pass. Passes: 1; 2 for a rectangle
//   that crosses a border of an axis that wraps, 4 for both; rectangles side by side count as one that crosses all they cross.
//   Registered: requests, answers and every stage; no path from a ready input to in_ready_o or to a valid output.
//
//   in --[summed_area_axis x 2]--[FIFO]--[pass, beat]--req--> memory
//        |                                   +--[beside]--------+--rsp--[a0]--[summed_area_sum]--[FIFO]-- out
//        +--[areas]-----[FIFO]----------------------------------------------------+
//
//   Of a rectangle with t turns in u between its bounds, SAT(x1, y) - SAT(x0, y) = word(x1, y) - word(x0, y) + t SAT(W, y). So the
//   second pass reads the corners of the column W, once each and with the sign of x1, and weighs their sum by t; the third the row H;
//   the fourth the corner (W, H), by the product of the turns. What a pass has no need of it asks for with read = 0.
module summed_area_lookup
  import formats_pkg::*;
  import surface_pkg::*;
  import memory_pkg::*;
#(
  parameter int unsigned ReadsPerClock = 4,
  parameter int unsigned Lookups = 1,
  parameter int unsigned InFlight = 128,
  localparam int unsigned Words = Lookups * ReadsPerClock
) (
  input  logic      clk_i,
  input  logic      rst_ni,
  input  map_regs_t map_i,

  input  logic                                 in_valid_i,
  output logic                                 in_ready_o,
  input  summed_area_lookup_in_t [Lookups-1:0] in_i,

  output logic                       table_req_valid_o,
  input  logic                       table_req_ready_i,
  output table_request_t [Words-1:0] table_req_o,
  input  logic                       table_rsp_valid_i,
  input  table_sum_t     [Words-1:0] table_rsp_i,

  output logic                                  out_valid_o,
  input  logic                                  out_ready_i,
  output summed_area_lookup_out_t [Lookups-1:0] out_o,
  output area_t                                 area_o
);
  if (InFlight < 2) begin : gen_in_flight
    $error("InFlight is 2 at least");
  end
  localparam int unsigned Beats = 4 / ReadsPerClock;
  localparam int unsigned Results = InFlight / Beats + 5;
  if (ReadsPerClock != 1 && ReadsPerClock != 4) begin : gen_bad
    $error("ReadsPerClock is 1 or 4");
  end

  typedef struct packed {
    logic  clipped;
    area_t kept;  // of the full area, what is on the map
    area_t full;
  } areas_t;
  // Pairs: [0] in u, [1] in v.
  typedef struct packed {
    logic      [7:0]      turns_uv;  // the product
    logic      [1:0][3:0] turns;
    logic      [1:0]      read_low;
    map_size_t [1:0]      low;
    map_size_t [1:0]      high;
  } region_t;
  typedef struct packed {
    logic    [1:0]         passes;  // any of them has turns
    region_t [Lookups-1:0] at;
  } regions_t;

  map_size_t [1:0] size, last_q;
  logic      [1:0] wrap;
  assign size = {map_i.height, map_i.width};
  assign wrap = {map_i.wrap_v, map_i.wrap_u};
  always_ff @(posedge clk_i) last_q <= {map_i.height - 14'd1, map_i.width - 14'd1};

  // ---- Regions: s0 to s7 -------------------------------------------------------------------------
  localparam int unsigned RegionLatency = 8;
  regions_t s7_q, region;
  areas_t [Lookups-1:0] s7_areas_q, a0_areas;
  logic     region_valid, region_ready;
  logic [1:0][Lookups-1:0] turning;
  for (genvar l = 0; l < Lookups; l++) begin : gen_region
    bound_t    [1:0]       low, high;
    map_size_t [1:0]       s6_low, s6_high;
    logic      [1:0]       s6_read_low, s2_clipped;
    logic      [1:0][3:0]  s6_turns;
    logic      [1:0][15:0] s2_full, s2_kept;
    assign low  = {in_i[l].y0, in_i[l].x0};
    assign high = {in_i[l].y1, in_i[l].x1};
    for (genvar i = 0; i < 2; i++) begin : gen_axis
      summed_area_axis i_axis (
        .clk_i,
        .size_i(size[i]),
        .last_i(last_q[i]),
        .wrap_i(wrap[i]),
        .low_i(low[i]),
        .high_i(high[i]),
        .word_low_o(s6_low[i]),
        .read_low_o(s6_read_low[i]),
        .word_high_o(s6_high[i]),
        .turns_o(s6_turns[i]),
        .full_o(s2_full[i]),
        .kept_o(s2_kept[i]),
        .clipped_o(s2_clipped[i])
      );
      assign turning[i][l] = s6_turns[i] != '0;
    end

    logic signed [33:0] s4_full, s4_kept;
    logic               s4_clipped;
    areas_t             s6_areas;
    multiply #(.A(17), .B(17)) i_full (
      .clk_i, .a_i(signed'({1'b0, s2_full[0]})), .b_i(signed'({1'b0, s2_full[1]})), .y_o(s4_full)
    );
    multiply #(.A(17), .B(17)) i_kept (
      .clk_i, .a_i(signed'({1'b0, s2_kept[0]})), .b_i(signed'({1'b0, s2_kept[1]})), .y_o(s4_kept)
    );
    delay #(.Stages(2)) i_clipped (.clk_i, .x_i(|s2_clipped), .y_o(s4_clipped));
    delay #(.T(areas_t), .Stages(2)) i_areas (
      .clk_i, .x_i({s4_clipped, s4_kept[24:0], s4_full[24:0]}), .y_o(s6_areas)
    );
    logic unused_area;
    assign unused_area = ^{s4_full[33:25], s4_kept[33:25]};

    always_ff @(posedge clk_i) begin
      s7_q.at[l].turns_uv <= 8'(s6_turns[0]) * 8'(s6_turns[1]);
      s7_q.at[l].turns    <= s6_turns;
      s7_q.at[l].read_low <= s6_read_low;
      s7_q.at[l].low      <= s6_low;
      s7_q.at[l].high     <= s6_high;
      s7_areas_q[l]       <= s6_areas;
    end
  end
  always_ff @(posedge clk_i) s7_q.passes <= {|turning[1], |turning[0]};

  logic [RegionLatency-1:0] s7_valid_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) s7_valid_q <= '0;
    else s7_valid_q <= {s7_valid_q[RegionLatency-2:0], in_valid_i && in_ready_o};
  end

  stream_pipe #(.T(regions_t), .Latency(RegionLatency)) i_regions (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .data_i(s7_q),
    .out_valid_o(region_valid),
    .out_ready_i(region_ready),
    .out_o(region)
  );

  // ---- Requests: the passes that there are of 00, u, v, uv; of each its beats --------------------
  typedef struct packed {
    logic                    first;
    logic                    last;
    logic                    negative;
    logic [Words-1:0]        read;
    logic [Lookups-1:0][7:0] weight;
  } beside_t;

  localparam int unsigned AskedBits = $clog2(InFlight + 1);
  localparam int unsigned PlacedBits = $clog2(Results + 1);
  localparam int unsigned PlaceBits = $clog2(InFlight);
  logic [AskedBits-1:0]  asked_q;   // beats without an answer
  logic [PlacedBits-1:0] placed_q;  // results that are promised a place, or lie in theirs
  logic [PlaceBits-1:0]  write_place_q, read_place_q;
  logic [1:0] pass_q, beat_q;
  logic       rooms_q;  // a clock old, so one more may have been asked for since
  logic       free, room, ask, last_beat, last, leave;
  table_request_t [Words-1:0] request;
  beside_t beside;

  function automatic logic [PlaceBits-1:0] after(logic [PlaceBits-1:0] place);
    return place == PlaceBits'(InFlight - 1) ? '0 : place + PlaceBits'(1);
  endfunction

  assign free = !table_req_valid_o || table_req_ready_i;
  assign room = rooms_q && free;
  assign ask = region_valid && room;
  assign last_beat = beat_q == 2'(Beats - 1);
  assign last = last_beat && pass_q == region.passes;
  assign region_ready = room && last;
  assign leave = out_valid_o && out_ready_i;

  always_comb begin
    logic [1:0] corner;  // [i]: the low one
    map_size_t [1:0] place;
    logic read;
    beside.first = pass_q == '0 && beat_q == '0;
    beside.last = last;
    beside.negative = ^beat_q;
    for (int l = 0; l < Lookups; l++) begin
      unique case (pass_q)
        2'b00: beside.weight[l] = 8'd1;
        2'b01: beside.weight[l] = 8'(region.at[l].turns[0]);
        2'b10: beside.weight[l] = 8'(region.at[l].turns[1]);
        2'b11: beside.weight[l] = region.at[l].turns_uv;
      endcase
      for (int r = 0; r < ReadsPerClock; r++) begin
        corner = ReadsPerClock == 1 ? beat_q : 2'(r);
        read = 1'b1;
        for (int i = 0; i < 2; i++) begin
          place[i] = corner[i] ? region.at[l].low[i] : pass_q[i] ? last_q[i] : region.at[l].high[i];
          if (corner[i] && (pass_q[i] || !region.at[l].read_low[i])) read = 1'b0;
          if (pass_q[i] && region.at[l].turns[i] == '0) read = 1'b0;
        end
        request[l*ReadsPerClock+r] = '{read: read, x: place[0], y: place[1]};
        beside.read[l*ReadsPerClock+r] = read;
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (free) table_req_o <= request;
    if (!rst_ni) begin
      table_req_valid_o <= 1'b0;
      pass_q <= '0;
      beat_q <= '0;
      asked_q <= '0;
      placed_q <= '0;
      rooms_q <= 1'b0;
      write_place_q <= '0;
      read_place_q <= '0;
    end else begin
      if (free) table_req_valid_o <= ask;
      if (ask) begin
        beat_q <= last_beat ? '0 : beat_q + 2'd1;
        if (last) begin
          pass_q <= '0;
        end else if (last_beat) begin
          // Without a pass in u the one in v comes next.
          pass_q <= region.passes[0] ? pass_q + 2'd1 : 2'b10;
        end
        write_place_q <= after(write_place_q);
      end
      if (table_rsp_valid_i) read_place_q <= after(read_place_q);
      asked_q <= asked_q + AskedBits'(ask) - AskedBits'(table_rsp_valid_i);
      placed_q <= placed_q + PlacedBits'(ask && last) - PlacedBits'(leave);
      rooms_q <= asked_q < AskedBits'(InFlight - 1) && placed_q < PlacedBits'(Results - 1);
    end
  end

  // ---- Answers: what was laid aside comes with them, in order ------------------------------------
  localparam int unsigned SumLatency = 31;
  // A beat is never answered in the clock in which it is laid aside, so no bypass is wanted.
  (* no_rw_check *) beside_t beside_q[InFlight];
  beside_t                answer_q, a0_q;  // the first is a memory's, which is slow
  table_sum_t [Words-1:0] answer_word_q, a0_word_q;
  logic                   answer_valid_q, a0_valid_q;
  logic [SumLatency-1:0]  result_valid_q;
  always_ff @(posedge clk_i) begin
    if (ask) beside_q[write_place_q] <= beside;
    if (table_rsp_valid_i) answer_q <= beside_q[read_place_q];
    answer_word_q <= table_rsp_i;
    a0_q      <= answer_q;
    a0_word_q <= answer_word_q;
    if (!rst_ni) begin
      answer_valid_q <= 1'b0;
      a0_valid_q <= 1'b0;
      result_valid_q <= '0;
    end else begin
      answer_valid_q <= table_rsp_valid_i;
      a0_valid_q <= answer_valid_q;
      result_valid_q <= {result_valid_q[SumLatency-2:0], a0_valid_q && a0_q.last};
    end
  end

  // The areas wait from s7 on for the answer to the last beat: there are never more than regions waiting and results promised.
  localparam int unsigned Areas = RegionLatency + 5 + Results;
  logic unused_areas_ready, unused_areas_valid;
  logic [$clog2(Areas+1)-1:0] unused_areas_count;
  stream_fifo #(.T(areas_t [Lookups-1:0]), .Depth(Areas)) i_areas (
    .clk_i,
    .rst_ni,
    .in_valid_i(s7_valid_q[RegionLatency-1]),
    .in_ready_o(unused_areas_ready),
    .in_i(s7_areas_q),
    .out_valid_o(unused_areas_valid),
    .out_ready_i(a0_valid_q && a0_q.last),
    .out_o(a0_areas),
    .count_o(unused_areas_count)
  );

  typedef struct packed {
    area_t                                 area;
    summed_area_lookup_out_t [Lookups-1:0] s;
  } result_t;
  result_t result, out;
  for (genvar l = 0; l < Lookups; l++) begin : gen_sum
    area_t area;
    summed_area_sum #(.ReadsPerClock(ReadsPerClock)) i_sum (
      .clk_i,
      .valid_i(a0_valid_q),
      .first_i(a0_q.first),
      .word_i(a0_word_q[l*ReadsPerClock+:ReadsPerClock]),
      .read_i(a0_q.read[l*ReadsPerClock+:ReadsPerClock]),
      .negative_i(a0_q.negative),
      .weight_i(a0_q.weight[l]),
      .clipped_i(a0_areas[l].clipped),
      .kept_i(a0_areas[l].kept),
      .full_i(a0_areas[l].full),
      .s_o(result.s[l].s),
      .area_o(area)
    );
    if (l == Lookups - 1) begin : gen_last
      assign result.area = area;
    end else begin : gen_other
      logic unused_area;
      assign unused_area = ^area;
    end
  end

  logic unused_ready;
  logic [PlacedBits-1:0] unused_count;
  stream_fifo #(.T(result_t), .Depth(Results)) i_results (
    .clk_i,
    .rst_ni,
    .in_valid_i(result_valid_q[SumLatency-1]),
    .in_ready_o(unused_ready),
    .in_i(result),
    .out_valid_o,
    .out_ready_i,
    .out_o(out),
    .count_o(unused_count)
  );
  assign out_o  = out.s;
  assign area_o = out.area;
endmodule

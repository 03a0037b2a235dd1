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
//   that crosses a border of an axis that wraps, 4 for both; rectangles side by side count as one that crosses all they cross. Rectangles
//   side by side with a word each, which take four beats, share what looks at them and what sums them up, one after the other: latency 52.
//   Registered: requests, answers and every stage; no path from a ready input to in_ready_o or to a valid output.
//
//   in --[summed_area_regions]--[FIFO]--[pass, beat]--req--> memory
//                  |                       +--[beside]-----rsp--[a0]--[summed_area_sums]--[FIFO]-- out
//                  +--areas-----------------------------------------------+
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

  // Where beats leave the time, rectangles take turns: so many chains, so many slots on each.
  localparam int unsigned Slots = Beats >= Lookups ? Lookups : 1;
  localparam int unsigned Chains = Lookups / Slots;

  typedef struct packed {
    logic          [1:0]         passes;  // any of them has turns
    table_region_t [Lookups-1:0] at;
  } regions_t;

  map_size_t [1:0] last_q;
  always_ff @(posedge clk_i) last_q <= {map_i.height - 14'd1, map_i.width - 14'd1};

  // ---- Regions -----------------------------------------------------------------------------------
  localparam int unsigned RegionLatency = 7 + Slots;
  table_region_t [Lookups-1:0] regions;
  logic [1:0] passes;
  regions_t   region;
  logic     region_valid, region_ready, regions_ready, slots_free, take, areas_valid;
  table_areas_t [Chains-1:0] areas;
  assign in_ready_o = regions_ready && slots_free;
  assign take = in_valid_i && in_ready_o;
  summed_area_regions #(.Chains(Chains), .Slots(Slots)) i_look (
    .clk_i,
    .rst_ni,
    .map_i,
    .last_i(last_q),
    .valid_i(take),
    .in_i,
    .region_o(regions),
    .areas_valid_o(areas_valid),
    .areas_o(areas)
  );
  always_comb begin
    passes = '0;
    for (int l = 0; l < Lookups; l++) passes |= regions[l].turning;
  end
  if (Slots == 1) begin : gen_every_clock
    assign slots_free = 1'b1;
  end else begin : gen_slots
    logic [Slots-2:0] taken_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) taken_q <= '0;
      else taken_q <= (Slots - 1)'({taken_q, take});
    end
    assign slots_free = taken_q == '0;
  end
  stream_pipe #(.T(regions_t), .Latency(RegionLatency)) i_regions (
    .clk_i,
    .rst_ni,
    .in_valid_i(in_valid_i && slots_free),
    .in_ready_o(regions_ready),
    .data_i({passes, regions}),
    .out_valid_o(region_valid),
    .out_ready_i(region_ready),
    .out_o(region)
  );

  // ---- Requests: the passes that there are of 00, u, v, uv; of each its beats --------------------
  typedef struct packed {
    logic                    first;     // pass of its rectangles
    logic                    last;
    logic                    begins;    // its pass
    logic                    ends;
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
    beside.first = pass_q == '0;
    beside.last = last;
    beside.begins = beat_q == '0;
    beside.ends = last_beat;
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
          if (pass_q[i] && !region.at[l].turning[i]) read = 1'b0;
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
  // A beat is never answered in the clock in which it is laid aside, so no bypass is wanted.
  (* no_rw_check *) beside_t beside_q[InFlight];
  beside_t                answer_q, a0_q;  // the first is a memory's, which is slow
  table_sum_t [Words-1:0] answer_word_q, a0_word_q;
  logic                   answer_valid_q, a0_valid_q;
  always_ff @(posedge clk_i) begin
    if (ask) beside_q[write_place_q] <= beside;
    if (table_rsp_valid_i) answer_q <= beside_q[read_place_q];
    answer_word_q <= table_rsp_i;
    a0_q      <= answer_q;
    a0_word_q <= answer_word_q;
    if (!rst_ni) begin
      answer_valid_q <= 1'b0;
      a0_valid_q <= 1'b0;
    end else begin
      answer_valid_q <= table_rsp_valid_i;
      a0_valid_q <= answer_valid_q;
    end
  end

  typedef struct packed {
    area_t                                 area;
    summed_area_lookup_out_t [Lookups-1:0] s;
  } result_t;
  result_t result, out;
  logic    result_valid;
  summed_area_sums #(
    .ReadsPerClock(ReadsPerClock),
    .Chains(Chains),
    .Slots(Slots),
    .AreasDepth(Slots * (RegionLatency + 5 + Results))
  ) i_sums (
    .clk_i,
    .rst_ni,
    .areas_valid_i(areas_valid),
    .areas_i(areas),
    .valid_i(a0_valid_q),
    .begins_i(a0_q.begins),
    .ends_i(a0_q.ends),
    .first_i(a0_q.first),
    .last_i(a0_q.last),
    .word_i(a0_word_q),
    .read_i(a0_q.read),
    .negative_i(a0_q.negative),
    .weight_i(a0_q.weight),
    .valid_o(result_valid),
    .s_o(result.s),
    .area_o(result.area)
  );

  logic unused_ready;
  logic [PlacedBits-1:0] unused_count;
  stream_fifo #(.T(result_t), .Depth(Results)) i_results (
    .clk_i,
    .rst_ni,
    .in_valid_i(result_valid),
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

// summed_height_test: does the height around the middle of an edge differ from that around its ends?
//   sht = |S12 - 2 (S1 + S2)| > 2 sum_threshold, or > 16 e_u e_v average_threshold     contract: hls/edge/summed_height_test.hpp
//   parameters  ReadsPerClock  words of the table a clock: 1, one lookup with one word; 3, three of them side by side (the four cycles of
//                              Doggett & Hirche 2000); 4, one lookup with four words; 12, three of those
//               InFlight       see summed_area_lookup
//   table [4 r + c] or, with one word each, [r] is of rectangle r: around P1, around P2, around P12
//
//   latency 63 + that of the memory, from the last beat on, 67 with three words; initiation interval 12/ReadsPerClock, times the passes of
//   summed_area_lookup where rectangles cross wrapped borders. Registered: every stage; no path from a ready input to in_ready_o or to a
//   valid output.
//
//   in --[s0: extents]--[bounds]--[FIFO]--[one by one, or three at once]--[summed_area_lookup]-- memory
//   out --[FIFO]--[compare]--[s2: |difference|, limit]--[S1 + S2]--[gathered]--------+
//
//   The area of the rectangle around P12 is 16 e_u e_v, clipped or not, and comes beside its sum.
module summed_height_test
  import formats_pkg::*;
  import surface_pkg::*;
  import memory_pkg::*;
  import edge_pkg::*;
#(
  parameter int unsigned ReadsPerClock = 12,
  parameter int unsigned InFlight = 128
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  map_regs_t                map_i,
  input  summed_height_test_regs_t regs_i,

  input  logic                   in_valid_i,
  output logic                   in_ready_o,
  input  summed_height_test_in_t in_i,

  output logic                               table_req_valid_o,
  input  logic                               table_req_ready_i,
  output table_request_t [ReadsPerClock-1:0] table_req_o,
  input  logic                               table_rsp_valid_i,
  input  table_sum_t     [ReadsPerClock-1:0] table_rsp_i,

  output logic                    out_valid_o,
  input  logic                    out_ready_i,
  output summed_height_test_out_t out_o
);
  localparam int unsigned Lookups = ReadsPerClock % 3 == 0 ? 3 : 1;
  localparam int unsigned Reads = ReadsPerClock / Lookups;
  if (ReadsPerClock != 1 && ReadsPerClock != 3 && ReadsPerClock != 4 && ReadsPerClock != 12)
  begin : gen_bad
    $error("ReadsPerClock is 1, 3, 4 or 12");
  end

  // ---- Rectangles --------------------------------------------------------------------------------
  localparam int unsigned FrontLatency = 5;
  typedef logic [11:0] extent_t;
  summed_area_lookup_in_t [2:0] bounds_q, rectangle;
  logic rectangle_valid, rectangle_ready;
  map_size_t [1:0] size;
  logic      [1:0] wrap;
  bound_t [2:0][1:0] low_q, high_q;
  assign size = {map_i.height, map_i.width};
  assign wrap = {map_i.wrap_v, map_i.wrap_u};
  for (genvar i = 0; i < 2; i++) begin : gen_axis
    // s0: e = max(1, round(|u1 - u2| / 8)), on a wrapped axis at most max(1, size / 4)
    logic signed [25:0] s0_difference_q;
    coordinate_t        s0_distance_q;
    extent_t            s0_eighth_q, s0_most_q, s0_extent_q;
    logic        [25:0] half_up;
    assign half_up = 26'(s0_distance_q) + 26'h2000;
    always_ff @(posedge clk_i) begin
      s0_difference_q <= signed'({1'b0, in_i.u1[i]}) - signed'({1'b0, in_i.u2[i]});
      s0_distance_q   <= 25'(s0_difference_q < 0 ? -s0_difference_q : s0_difference_q);
      s0_eighth_q     <= half_up[25:14];
      s0_most_q       <= wrap[i] ? size[i][13:2] : '1;
      if (s0_eighth_q > s0_most_q) s0_extent_q <= s0_most_q;
      else s0_extent_q <= s0_eighth_q;
      // At least one texel, also where a quarter of the axis is none.
      if (s0_eighth_q == '0 || s0_most_q == '0) s0_extent_q <= 12'd1;
    end
    logic unused_half;
    assign unused_half = ^half_up[13:0];

    // Texel t fills [t, t + 1): the centre column of U is floor(U) + 1.
    for (genvar r = 0; r < 3; r++) begin : gen_rectangle
      coordinate_t u;
      logic [13:0] floor_q;
      bound_t      centre, extent;
      if (r == 0) begin : gen_first
        assign u = in_i.u1[i];
      end else if (r == 1) begin : gen_second
        assign u = in_i.u2[i];
      end else begin : gen_middle
        assign u = in_i.u12[i];
      end
      bound_t centre_q;
      always_ff @(posedge clk_i) begin
        floor_q  <= u[24:11];
        centre_q <= bound_t'({2'b0, floor_q}) + 16'sd1;
      end
      delay #(.T(bound_t), .Stages(FrontLatency - 3)) i_centre (
        .clk_i, .x_i(centre_q), .y_o(centre)
      );
      assign extent = r == 2 ? {3'b0, s0_extent_q, 1'b0} : {4'b0, s0_extent_q};
      always_ff @(posedge clk_i) begin
        low_q[r][i]  <= centre - extent;
        high_q[r][i] <= centre + extent;
      end
      logic unused_fraction;
      assign unused_fraction = ^u[10:0];
    end
  end
  for (genvar r = 0; r < 3; r++) begin : gen_bounds
    assign bounds_q[r] = {high_q[r][1], high_q[r][0], low_q[r][1], low_q[r][0]};
  end
  stream_pipe #(.T(summed_area_lookup_in_t [2:0]), .Latency(FrontLatency)) i_rectangles (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .data_i(bounds_q),
    .out_valid_o(rectangle_valid),
    .out_ready_i(rectangle_ready),
    .out_o(rectangle)
  );

  // ---- Lookups -----------------------------------------------------------------------------------
  summed_area_lookup_in_t  [Lookups-1:0] ask;
  summed_area_lookup_out_t [Lookups-1:0] sum;
  logic  ask_ready, sum_valid, sum_ready;
  area_t area;
  summed_area_lookup #(.ReadsPerClock(Reads), .Lookups(Lookups), .InFlight(InFlight)) i_lookup (
    .clk_i,
    .rst_ni,
    .map_i,
    .in_valid_i(rectangle_valid),
    .in_ready_o(ask_ready),
    .in_i(ask),
    .table_req_valid_o,
    .table_req_ready_i,
    .table_req_o,
    .table_rsp_valid_i,
    .table_rsp_i,
    .out_valid_o(sum_valid),
    .out_ready_i(sum_ready),
    .out_o(sum),
    .area_o(area)
  );

  // An edge's three sums at once: those of the ends added, that of the middle.
  logic        sums_valid, sums_ready;
  logic [45:0] ends;
  logic [44:0] middle;
  if (Lookups == 3) begin : gen_at_once
    assign ask = rectangle;
    assign rectangle_ready = ask_ready;
    assign sums_valid = sum_valid;
    assign sum_ready  = sums_ready;
    assign ends = 46'(sum[0].s) + 46'(sum[1].s);
    assign middle = sum[2].s;
  end else begin : gen_one_by_one
    logic [1:0]  asked_q, summed_q;
    logic [45:0] ends_q;
    assign ask = rectangle[asked_q];
    assign rectangle_ready = ask_ready && asked_q == 2'd2;
    assign sums_valid = sum_valid && summed_q == 2'd2;
    assign sum_ready  = sums_ready || summed_q != 2'd2;
    assign ends = ends_q;
    assign middle = sum[0].s;
    always_ff @(posedge clk_i) begin
      if (sum_valid && summed_q != 2'd2) ends_q <= (summed_q == '0 ? '0 : ends_q) + 46'(sum[0].s);
      if (!rst_ni) begin
        asked_q  <= '0;
        summed_q <= '0;
      end else begin
        if (rectangle_valid && ask_ready) asked_q <= asked_q == 2'd2 ? '0 : asked_q + 2'd1;
        if (sum_valid && sum_ready) summed_q <= summed_q == 2'd2 ? '0 : summed_q + 2'd1;
      end
    end
  end

  // ---- s2: the difference and what it is held against --------------------------------------------
  localparam int unsigned BackLatency = 4;
  logic        [45:0] s1_ends_q;
  logic        [44:0] s1_middle_q;
  logic signed [47:0] s2_signed_q;
  logic        [46:0] s2_difference_q;
  logic signed [46:0] s1_product;
  logic        [44:0] s2_limit_q;
  summed_height_test_out_t sht_q;
  multiply #(.A(21), .B(26)) i_limit (
    .clk_i,
    .a_i(signed'({1'b0, regs_i.average_threshold})),
    .b_i(signed'({1'b0, area})),
    .y_o(s1_product)
  );
  always_ff @(posedge clk_i) begin
    s1_ends_q       <= ends;
    s1_middle_q     <= middle;
    s2_signed_q     <= signed'(48'(s1_middle_q)) - signed'({1'b0, s1_ends_q, 1'b0});
    s2_difference_q <= 47'(s2_signed_q < 0 ? -s2_signed_q : s2_signed_q);
    s2_limit_q      <= regs_i.average ? s1_product[44:0] : {regs_i.sum_threshold, 1'b0};
    sht_q.sht       <= s2_difference_q > 47'(s2_limit_q);
  end
  logic unused_product;
  assign unused_product = ^s1_product[46:45];

  stream_pipe #(.T(summed_height_test_out_t), .Latency(BackLatency)) i_answers (
    .clk_i,
    .rst_ni,
    .in_valid_i(sums_valid),
    .in_ready_o(sums_ready),
    .data_i(sht_q),
    .out_valid_o,
    .out_ready_i,
    .out_o
  );
endmodule

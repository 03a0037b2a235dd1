// summed_area_regions: where the corners of rectangles lie in the summed-area table, how many turns of the map are between them, and their
// areas.
//   contract: the part of hls/surface/summed_area_lookup.hpp before its reads
//   parameters  Chains  rectangles side by side;  Slots  so many one after the other on each: in_i[Slots chain + slot]
//   in    valid_i, in_i[]           rectangles, all at once; the next at the earliest Slots clocks later
//   out   region_o[]                all at once
//         areas_valid_o, areas_o[]  of each chain, slot by slot, the first 8 clocks after valid_i
//
//   latency 7 + Slots, of the areas 8 and on; initiation interval Slots; the words are a pure pipeline without reset. Registered: every
//   stage
//
//   rectangle --[summed_area_axis x 2]--+--[s7]-- region
//                                       +--x--[areas]
module summed_area_regions
  import formats_pkg::*;
  import surface_pkg::*;
  import memory_pkg::*;
#(
  parameter int unsigned Chains = 1,
  parameter int unsigned Slots = 1,
  localparam int unsigned Lookups = Chains * Slots
) (
  input  logic                                 clk_i,
  input  logic                                 rst_ni,
  input  map_regs_t                            map_i,
  input  map_size_t              [1:0]         last_i,
  input  logic                                 valid_i,
  input  summed_area_lookup_in_t [Lookups-1:0] in_i,
  output table_region_t                [Lookups-1:0] region_o,
  output logic                                 areas_valid_o,
  output table_areas_t                 [Chains-1:0]  areas_o
);
  localparam int unsigned AreasLatency = 8;
  map_size_t [1:0] size;
  logic      [1:0] wrap;
  assign size = {map_i.height, map_i.width};
  assign wrap = {map_i.wrap_v, map_i.wrap_u};

  // [i]: valid_i of i clocks ago.
  logic [AreasLatency+Slots-1:0] valid;
  logic [AreasLatency+Slots-2:0] valid_q;
  assign valid = {valid_q, valid_i};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else valid_q <= valid[AreasLatency+Slots-2:0];
  end
  assign areas_valid_o = |valid[AreasLatency+:Slots];

  for (genvar l = 0; l < Chains; l++) begin : gen_chain
    summed_area_lookup_in_t [Slots-1:0] waiting;
    summed_area_lookup_in_t             now;
    for (genvar s = 0; s < Slots; s++) begin : gen_waiting
      delay #(.T(summed_area_lookup_in_t), .Stages(s)) i_waiting (
        .clk_i, .x_i(in_i[l*Slots+s]), .y_o(waiting[s])
      );
    end
    always_comb begin
      now = waiting[0];
      for (int s = 1; s < Slots; s++) if (valid[s]) now = waiting[s];
    end

    bound_t    [1:0]       low, high;
    map_size_t [1:0]       s6_low, s6_high;
    logic      [1:0]       s6_read_low, s6_turning, s2_clipped;
    logic      [1:0][3:0]  s6_turns;
    logic      [1:0][15:0] s2_full, s2_kept;
    assign low  = {now.y0, now.x0};
    assign high = {now.y1, now.x1};
    for (genvar i = 0; i < 2; i++) begin : gen_axis
      summed_area_axis i_axis (
        .clk_i,
        .size_i(size[i]),
        .last_i(last_i[i]),
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
      assign s6_turning[i] = s6_turns[i] != '0;
    end

    logic signed [33:0] s4_full, s4_kept;
    logic               s4_clipped;
    multiply #(.A(17), .B(17)) i_full (
      .clk_i, .a_i(signed'({1'b0, s2_full[0]})), .b_i(signed'({1'b0, s2_full[1]})), .y_o(s4_full)
    );
    multiply #(.A(17), .B(17)) i_kept (
      .clk_i, .a_i(signed'({1'b0, s2_kept[0]})), .b_i(signed'({1'b0, s2_kept[1]})), .y_o(s4_kept)
    );
    delay #(.Stages(2)) i_clipped (.clk_i, .x_i(|s2_clipped), .y_o(s4_clipped));
    delay #(.T(table_areas_t), .Stages(3)) i_areas (
      .clk_i, .x_i({s4_clipped, s4_kept[24:0], s4_full[24:0]}), .y_o(areas_o[l])
    );
    logic unused_area;
    assign unused_area = ^{s4_full[33:25], s4_kept[33:25]};

    table_region_t s7_q;
    always_ff @(posedge clk_i) begin
      s7_q.turns_uv <= 8'(s6_turns[0]) * 8'(s6_turns[1]);
      s7_q.turns    <= s6_turns;
      s7_q.turning  <= s6_turning;
      s7_q.read_low <= s6_read_low;
      s7_q.low      <= s6_low;
      s7_q.high     <= s6_high;
    end
    for (genvar s = 0; s < Slots; s++) begin : gen_gathered
      delay #(.T(table_region_t), .Stages(Slots - 1 - s)) i_region (
        .clk_i, .x_i(s7_q), .y_o(region_o[l*Slots+s])
      );
    end
  end
endmodule

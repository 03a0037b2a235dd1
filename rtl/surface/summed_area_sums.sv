// summed_area_sums: the beats that a table answers, and what they come to for each of the rectangles that are asked for together.
//   contract: the second half of hls/surface/summed_area_lookup.hpp
//   parameters  ReadsPerClock  words of a beat for each rectangle
//               Chains, Slots  as in summed_area_regions;  AreasDepth  areas that may wait for their rectangles
//   in    areas_valid_i, areas_i[]  of rectangles that will be answered, slot by slot
//         valid_i                   a beat; begins_i, ends_i: of its pass, first_i, last_i: a pass of its rectangles
//         word_i, read_i            its words;  negative_i, weight_i[]  their sign, and turns: see the parts
//   out   valid_o, s_o[]            the sums, all together;  area_o  texels of the last rectangle, clipped or not
//
//   latency 30 + Slots from the last beat; initiation interval Slots beats a pass; never stalls. Registered: every stage
//
//   words --[summed_area_words]--a2--[slot by slot]--[summed_area_sum]--[all together]-- s
//   areas --[FIFO]-----------------------+
module summed_area_sums
  import formats_pkg::*;
  import surface_pkg::*;
  import memory_pkg::*;
#(
  parameter int unsigned ReadsPerClock = 4,
  parameter int unsigned Chains = 1,
  parameter int unsigned Slots = 1,
  parameter int unsigned AreasDepth = 8,
  localparam int unsigned Lookups = Chains * Slots
) (
  input  logic                                                    clk_i,
  input  logic                                                    rst_ni,
  input  logic                                                    areas_valid_i,
  input  table_areas_t            [Chains-1:0]                    areas_i,
  input  logic                                                    valid_i,
  input  logic                                                    begins_i,
  input  logic                                                    ends_i,
  input  logic                                                    first_i,
  input  logic                                                    last_i,
  input  table_sum_t              [Lookups-1:0][ReadsPerClock-1:0] word_i,
  input  logic                    [Lookups-1:0][ReadsPerClock-1:0] read_i,
  input  logic                                                    negative_i,
  input  logic                    [Lookups-1:0][7:0]              weight_i,
  output logic                                                    valid_o,
  output summed_area_lookup_out_t [Lookups-1:0]                   s_o,
  output area_t                                                   area_o
);
  // a2: the words of a pass, with the turns that they count for.
  typedef struct packed {
    logic [7:0] weight;
    table_sum_t sum;
  } pass_t;
  pass_t [Lookups-1:0] a2_pass;
  for (genvar l = 0; l < Lookups; l++) begin : gen_words
    summed_area_words #(.ReadsPerClock(ReadsPerClock)) i_words (
      .clk_i,
      .valid_i,
      .begins_i,
      .word_i(word_i[l]),
      .read_i(read_i[l]),
      .negative_i,
      .sum_o(a2_pass[l].sum)
    );
    delay #(.T(logic [7:0]), .Stages(2)) i_weight (
      .clk_i, .x_i(weight_i[l]), .y_o(a2_pass[l].weight)
    );
  end

  // The slots of a pass from a2 on, each with its rectangle's areas when it is the last pass.
  localparam int unsigned SumLatency = 29;
  typedef struct packed {
    logic last;
    logic first;
    logic valid;
  } slot_t;
  slot_t                     a0_slot, now;
  slot_t [Slots:0]           slot_q;  // [1 + slot]
  logic [SumLatency+Slots:0] valid_q;
  assign a0_slot = '{last: last_i, first: first_i, valid: valid_i && ends_i};
  always_ff @(posedge clk_i) begin
    slot_q <= {slot_q[Slots-1:0], a0_slot};
    valid_q <= {valid_q[SumLatency+Slots-1:0], a0_slot.valid && last_i};
    if (!rst_ni) begin
      for (int s = 0; s <= Slots; s++) slot_q[s].valid <= 1'b0;
      valid_q <= '0;
    end
  end
  assign valid_o = valid_q[SumLatency+Slots];
  always_comb begin
    now = slot_q[1];
    for (int s = 1; s < Slots; s++) if (slot_q[1+s].valid) now = slot_q[1+s];
  end

  // The areas are always there before the last answer.
  table_areas_t [Chains-1:0] a2_areas;
  logic unused_areas_ready, unused_areas_valid;
  logic [$clog2(AreasDepth+1)-1:0] unused_areas_count;
  stream_fifo #(.T(table_areas_t [Chains-1:0]), .Depth(AreasDepth)) i_areas (
    .clk_i,
    .rst_ni,
    .in_valid_i(areas_valid_i),
    .in_ready_o(unused_areas_ready),
    .in_i(areas_i),
    .out_valid_o(unused_areas_valid),
    .out_ready_i(now.valid && now.last),
    .out_o(a2_areas),
    .count_o(unused_areas_count)
  );

  for (genvar c = 0; c < Chains; c++) begin : gen_chain
    pass_t [Slots-1:0] waiting;
    pass_t             pass;
    for (genvar s = 0; s < Slots; s++) begin : gen_waiting
      delay #(.T(pass_t), .Stages(s)) i_waiting (
        .clk_i, .x_i(a2_pass[c*Slots+s]), .y_o(waiting[s])
      );
    end
    always_comb begin
      pass = waiting[0];
      for (int s = 1; s < Slots; s++) if (slot_q[1+s].valid) pass = waiting[s];
    end

    rectangle_sum_t sum;
    area_t          area;
    summed_area_sum #(.Slots(Slots)) i_sum (
      .clk_i,
      .valid_i(now.valid),
      .first_i(now.first),
      .sum_i(pass.sum),
      .weight_i(pass.weight),
      .areas_i(a2_areas[c]),
      .s_o(sum),
      .area_o(area)
    );
    for (genvar s = 0; s < Slots; s++) begin : gen_gathered
      delay #(.T(rectangle_sum_t), .Stages(Slots - 1 - s)) i_gathered (
        .clk_i, .x_i(sum), .y_o(s_o[c*Slots+s].s)
      );
    end
    if (c == Chains - 1) begin : gen_last
      assign area_o = area;
    end else begin : gen_other
      logic unused_area;
      assign unused_area = ^area;
    end
  end
endmodule

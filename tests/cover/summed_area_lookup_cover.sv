// summed_area_lookup_cover: rectangles beyond each border of a map, cut where it is clamped and carried on where it wraps; every number of
// passes; and every place that can be full.
//   bound into summed_area_lookup; the points see words that move, or wait, at the clock
module summed_area_lookup_cover
  import formats_pkg::*;
  import surface_pkg::*;
#(
  parameter int unsigned Lookups = 1
) (
  input logic                                 clk_i,
  input logic                                 rst_ni,
  input map_regs_t                            map_i,
  input logic                                 in_valid_i,
  input logic                                 in_ready_o,
  input summed_area_lookup_in_t [Lookups-1:0] in_i,
  input logic                                 region_valid,
  input logic                                 region_ready,
  input logic                           [1:0] passes_i,
  input logic                                 rooms_q,
  input logic                                 answers_full_i,
  input logic                                 results_full_i,
  input logic                                 table_req_valid_o,
  input logic                                 table_req_ready_i,
  input logic                                 out_valid_o,
  input logic                                 out_ready_i
);
  logic moves, left, right, bottom, top, far_u, far_v;
  logic [1:0] wrap;
  assign moves = rst_ni && in_valid_i && in_ready_o;
  assign wrap = {map_i.wrap_v, map_i.wrap_u};
  bound_t width, height;
  assign width = bound_t'({2'b0, map_i.width});
  assign height = bound_t'({2'b0, map_i.height});
  always_comb begin
    {left, right, bottom, top, far_u, far_v} = '0;
    for (int l = 0; l < Lookups; l++) begin
      left |= moves && in_i[l].x0 < 0;
      right |= moves && in_i[l].x1 > width;
      bottom |= moves && in_i[l].y0 < 0;
      top |= moves && in_i[l].y1 > height;
      far_u |= moves && in_i[l].x1 - in_i[l].x0 > width;
      far_v |= moves && in_i[l].y1 - in_i[l].y0 > height;
    end
  end
  cut_left: cover property (@(posedge clk_i) left && !wrap[0]);
  cut_right: cover property (@(posedge clk_i) right && !wrap[0]);
  cut_bottom: cover property (@(posedge clk_i) bottom && !wrap[1]);
  cut_top: cover property (@(posedge clk_i) top && !wrap[1]);
  wrapped_left: cover property (@(posedge clk_i) left && wrap[0]);
  wrapped_right: cover property (@(posedge clk_i) right && wrap[0]);
  wrapped_bottom: cover property (@(posedge clk_i) bottom && wrap[1]);
  wrapped_top: cover property (@(posedge clk_i) top && wrap[1]);
  wider_than_the_map: cover property (@(posedge clk_i) far_u && wrap[0]);
  higher_than_the_map: cover property (@(posedge clk_i) far_v && wrap[1]);

  logic asked;
  assign asked = rst_ni && region_valid && region_ready;
  one_pass: cover property (@(posedge clk_i) asked && passes_i == 2'b00);
  two_passes_in_u: cover property (@(posedge clk_i) asked && passes_i == 2'b01);
  two_passes_in_v: cover property (@(posedge clk_i) asked && passes_i == 2'b10);
  four_passes: cover property (@(posedge clk_i) asked && passes_i == 2'b11);

  regions_full: cover property (@(posedge clk_i) rst_ni && in_valid_i && !in_ready_o);
  answers_full: cover property (@(posedge clk_i) rst_ni && region_valid && !rooms_q
                                && answers_full_i);
  results_full: cover property (@(posedge clk_i) rst_ni && region_valid && !rooms_q
                                && results_full_i);
  request_waits: cover property (@(posedge clk_i) rst_ni && table_req_valid_o
                                 && !table_req_ready_i);
  out_waits: cover property (@(posedge clk_i) rst_ni && out_valid_o && !out_ready_i);
endmodule

bind summed_area_lookup summed_area_lookup_cover #(
  .Lookups(Lookups)
) i_cover (
  .passes_i(region.passes),
  .answers_full_i(asked_q >= AskedBits'(InFlight - 1)),
  .results_full_i(placed_q >= PlacedBits'(Results - 1)),
  .*
);

// engine_cover: what scenes are to reach in the engine: every pattern of splits, every way in which a mesh begins and ends, and every
// place where a word can be kept waiting.
//   bound into engine; the points see words that move, or wait, at the clock, never what lies in a pipeline between words
module engine_cover
  import surface_pkg::*;
  import edge_pkg::*;
#(
  parameter int unsigned Lanes = 1
) (
  input logic             clk_i,
  input logic             rst_ni,
  // a triangle was looked at: which edges split
  input logic             tested,
  input logic [2:0]       split_i,
  // the mesh
  input logic             end_i,
  input logic             take,
  input logic             last_i,
  input logic             finish,
  input logic             holding_i,
  input logic             culled,
  // links
  input logic             in_valid_i,
  input logic             in_ready_o,
  input logic             out_valid_o,
  input logic             out_ready_i,
  input logic [Lanes-1:0] table_req_valid_o,
  input logic [Lanes-1:0] table_req_ready_i,
  input logic [Lanes-1:0] quad_req_valid_o,
  input logic [Lanes-1:0] quad_req_ready_i,
  input logic [Lanes-1:0] place_req_valid_o,
  input logic [Lanes-1:0] place_req_ready_i,
  input logic [Lanes-1:0] normal_req_valid_o,
  input logic [Lanes-1:0] normal_req_ready_i,
  // inside
  input logic             pop_valid,
  input logic             may_take,
  input logic             got_ready,
  input logic             ready_valid,
  input logic             flight_in_ready,
  input logic [Lanes-1:0] lane_in_valid,
  input logic [Lanes-1:0] lane_in_ready,
  input logic [Lanes-1:0] lane_valid,
  input logic [Lanes-1:0] lane_ready,
  input logic             collected_valid,
  input logic             collected_ready,
  input logic             finished_valid,
  input logic             finished_ready,
  input logic             hold_ready_i,
  input logic             running_q,
  input logic             input_done_q
);
  // ---- patterns of splits, as bits of the edges 2, 1, 0
  split_000: cover property (@(posedge clk_i) rst_ni && tested && split_i == 3'b000);
  split_001: cover property (@(posedge clk_i) rst_ni && tested && split_i == 3'b001);
  split_010: cover property (@(posedge clk_i) rst_ni && tested && split_i == 3'b010);
  split_100: cover property (@(posedge clk_i) rst_ni && tested && split_i == 3'b100);
  split_011: cover property (@(posedge clk_i) rst_ni && tested && split_i == 3'b011);
  split_110: cover property (@(posedge clk_i) rst_ni && tested && split_i == 3'b110);
  split_101: cover property (@(posedge clk_i) rst_ni && tested && split_i == 3'b101);
  split_111: cover property (@(posedge clk_i) rst_ni && tested && split_i == 3'b111);

  // ---- the mesh
  last_triangle_taken: cover property (@(posedge clk_i) rst_ni && take && last_i);
  ended_without_a_last: cover property (@(posedge clk_i) rst_ni && end_i && !input_done_q);
  empty_mesh: cover property (@(posedge clk_i) rst_ni && finish && !holding_i);
  triangle_culled: cover property (@(posedge clk_i) rst_ni && culled);

  // ---- links that wait
  in_waits: cover property (@(posedge clk_i) rst_ni && in_valid_i && !in_ready_o);
  in_is_waited_for: cover property (@(posedge clk_i) rst_ni && !in_valid_i && in_ready_o);
  out_waits: cover property (@(posedge clk_i) rst_ni && out_valid_o && !out_ready_i);
  table_waits: cover property (@(posedge clk_i) rst_ni
                              && |(table_req_valid_o & ~table_req_ready_i));
  quad_waits: cover property (@(posedge clk_i) rst_ni && |(quad_req_valid_o & ~quad_req_ready_i));
  place_waits: cover property (@(posedge clk_i) rst_ni
                              && |(place_req_valid_o & ~place_req_ready_i));
  normal_waits: cover property (@(posedge clk_i) rst_ni
                               && |(normal_req_valid_o & ~normal_req_ready_i));

  // ---- inside: what a triangle may wait for on its round
  in_waits_for_credit: cover property (@(posedge clk_i) rst_ni && in_valid_i && running_q
                                                        && !may_take);
  in_waits_for_a_pop: cover property (@(posedge clk_i) rst_ni && in_valid_i && may_take
                                                       && pop_valid);
  pop_waits: cover property (@(posedge clk_i) rst_ni && pop_valid && !got_ready);
  flight_full: cover property (@(posedge clk_i) rst_ni && ready_valid && !flight_in_ready);
  lane_refuses: cover property (@(posedge clk_i) rst_ni && |(lane_in_valid & ~lane_in_ready));
  lane_waits: cover property (@(posedge clk_i) rst_ni && |(lane_valid & ~lane_ready));
  collected_waits: cover property (@(posedge clk_i) rst_ni && collected_valid && !collected_ready);
  finished_waits: cover property (@(posedge clk_i) rst_ni && finished_valid && !finished_ready);
  out_full: cover property (@(posedge clk_i) rst_ni && !hold_ready_i);
endmodule

bind engine engine_cover #(
  .Lanes(Lanes)
) i_cover (
  .split_i(collected.t.split),
  .last_i(in_i.last),
  .holding_i(i_output.holding_q),
  .hold_ready_i(i_output.hold_ready),
  .*
);

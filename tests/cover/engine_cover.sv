// engine_cover: what scenes are to reach in the engine: every pattern of splits, both diagonals and the tie between them, every way in
// which a mesh begins and ends, and every place where a word can be kept waiting.
//   bound into engine; the points see words that move, or wait, at the clock, never what lies in a pipeline between words
module engine_cover
  import surface_pkg::*;
  import edge_pkg::*;
  import latency_pkg::*;
#(
  parameter int unsigned Lanes = 1
) (
  input logic             clk_i,
  input logic             rst_ni,
  // a triangle was looked at: which edges split, and tessellate's difference of the squared diagonals
  input logic             tested,
  input logic [2:0]       split_i,
  input logic             equal_i,
  input logic             first_i,
  input logic [Tessellate-1:0] travelling_i,
  // the mesh
  input logic             end_i,
  input logic             take,
  input logic             last_i,
  input logic             finish,
  input logic             holding_q,
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
  input logic             split,
  input logic             whole_in_ready,
  input logic             split_in_ready,
  input logic             whole_valid,
  input logic             whole_ready,
  input logic             children_valid,
  input logic             children_ready,
  input logic             finished_valid,
  input logic             finished_ready,
  input logic             hold_ready,
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

  // ---- diagonals of two splits: the choice is made in the last stage but one, of what was taken so many clocks ago
  localparam int unsigned Choice = Tessellate - 1;
  logic [2:0] split_later;
  logic       equal_q, two;
  delay #(.T(logic [2:0]), .Stages(Choice)) i_split (.clk_i, .x_i(split_i), .y_o(split_later));
  always_ff @(posedge clk_i) equal_q <= equal_i;
  assign two = rst_ni && travelling_i[Choice-1] && $countones(split_later) == 2;
  first_diagonal_of_011: cover property (@(posedge clk_i) two && first_i && split_later == 3'b011);
  first_diagonal_of_110: cover property (@(posedge clk_i) two && first_i && split_later == 3'b110);
  first_diagonal_of_101: cover property (@(posedge clk_i) two && first_i && split_later == 3'b101);
  other_diagonal_of_011: cover property (@(posedge clk_i) two && !first_i && split_later == 3'b011);
  other_diagonal_of_110: cover property (@(posedge clk_i) two && !first_i && split_later == 3'b110);
  other_diagonal_of_101: cover property (@(posedge clk_i) two && !first_i && split_later == 3'b101);
  tie_for_the_first: cover property (@(posedge clk_i) two && equal_q && first_i);
  tie_for_the_other: cover property (@(posedge clk_i) two && equal_q && !first_i);

  // ---- the mesh
  last_triangle_taken: cover property (@(posedge clk_i) rst_ni && take && last_i);
  ended_without_a_last: cover property (@(posedge clk_i) rst_ni && end_i && !input_done_q);
  empty_mesh: cover property (@(posedge clk_i) rst_ni && finish && !holding_q);
  triangle_culled: cover property (@(posedge clk_i) rst_ni && finished_valid && culled);

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
  whole_full: cover property (@(posedge clk_i) rst_ni && collected_valid && !split
                                               && !whole_in_ready);
  children_full: cover property (@(posedge clk_i) rst_ni && collected_valid && split
                                                  && !split_in_ready);
  whole_waits: cover property (@(posedge clk_i) rst_ni && whole_valid && !whole_ready);
  children_wait: cover property (@(posedge clk_i) rst_ni && children_valid && !children_ready);
  finished_waits: cover property (@(posedge clk_i) rst_ni && finished_valid && !finished_ready);
  out_full: cover property (@(posedge clk_i) rst_ni && !hold_ready);
endmodule

bind engine engine_cover #(
  .Lanes(Lanes)
) i_cover (
  .split_i(collected.split),
  .equal_i(i_tessellate.s4_difference_q == '0),
  .first_i(i_tessellate.s5_first_q),
  .travelling_i(i_tessellate_pipe.travelling_q),
  .last_i(in_i.last),
  .*
);

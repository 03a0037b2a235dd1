// edge_output_cover: the record that is held back waits for the one behind it, or for room; what is culled passes a full output.
//   bound into edge_output; the points see words that wait at the clock
module edge_output_cover (
  input logic clk_i,
  input logic rst_ni,
  input logic over_i,
  input logic in_valid_i,
  input logic in_ready_o,
  input logic cull_it,
  input logic holding_q,
  input logic hold_ready,
  input logic out_valid_o,
  input logic out_ready_i
);
  held_waits_for_the_next: cover property (@(posedge clk_i) rst_ni && holding_q && !over_i
                                           && !in_valid_i && !out_valid_o);
  in_waits: cover property (@(posedge clk_i) rst_ni && in_valid_i && !in_ready_o);
  culled_passes_a_full_output: cover property (@(posedge clk_i) rst_ni && in_valid_i && cull_it
                                               && holding_q && !hold_ready);
  last_waits_for_room: cover property (@(posedge clk_i) rst_ni && over_i && !hold_ready);
  out_waits: cover property (@(posedge clk_i) rst_ni && out_valid_o && !out_ready_i);
endmodule

bind edge_output edge_output_cover i_cover (.*);

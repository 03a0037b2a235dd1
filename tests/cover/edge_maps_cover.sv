// edge_maps_cover: what scenes are to reach where a new vertex waits for the maps: every branch of the fork and of the join.
//   bound into edge_maps; the points see words that wait at the clock
module edge_maps_cover
  import lane_pkg::*;
(
  input logic     clk_i,
  input logic     rst_ni,
  // the fork
  input logic     in_valid_i,
  input logic     ask_maps,
  input logic     far_normal_ready,
  input logic     far_displace_ready,
  input logic     far_waiting_ready,
  // the join
  input logic     near_waiting_valid,
  input waiting_t waiting_o,
  input logic     near_normal_valid,
  input logic     near_displaced_valid
);
  normal_refuses: cover property (@(posedge clk_i) rst_ni && in_valid_i && ask_maps
                                  && !far_normal_ready);
  displace_refuses: cover property (@(posedge clk_i) rst_ni && in_valid_i && ask_maps
                                    && !far_displace_ready);
  waiting_full: cover property (@(posedge clk_i) rst_ni && in_valid_i && !far_waiting_ready);
  waits_for_normal: cover property (@(posedge clk_i) rst_ni && near_waiting_valid && waiting_o.needed
                                    && !near_normal_valid);
  waits_for_displaced: cover property (@(posedge clk_i) rst_ni && near_waiting_valid && waiting_o.needed
                                       && !near_displaced_valid);
endmodule

bind edge_maps edge_maps_cover i_cover (.*);

// edge_dispatch_cover: what keeps a triangle at the dispatch, and with three lanes a lane that waits for another.
//   bound into edge_dispatch; the points see words that wait at the clock
module edge_dispatch_cover
  import engine_pkg::*;
#(
  parameter int unsigned Lanes = 1
) (
  input logic             clk_i,
  input logic             rst_ni,
  input logic             in_valid_i,
  input logic             in_ready_o,
  input flight_t          in_i,
  input logic [Lanes-1:0] lane_ready_i
);
  logic waits, one_waits;
  assign waits = rst_ni && in_valid_i && !in_ready_o;
  assign one_waits = |(lane_ready_i & Lanes'(in_i.ask)) && |(~lane_ready_i & Lanes'(in_i.ask));
  in_waits: cover property (@(posedge clk_i) waits);
  a_lane_waits_for_another: cover property (@(posedge clk_i) waits && Lanes == 3 && one_waits);
endmodule

bind edge_dispatch edge_dispatch_cover #(
  .Lanes(Lanes)
) i_cover (.*);

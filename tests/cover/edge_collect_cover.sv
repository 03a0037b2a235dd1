// edge_collect_cover: what an answer may wait for at the join of the lanes with the flight.
//   bound into edge_collect; the points see words that wait at the clock
module edge_collect_cover
  import engine_pkg::*;
#(
  parameter int unsigned Lanes = 1
) (
  input logic             clk_i,
  input logic             rst_ni,
  input logic             flight_valid_i,
  input flight_t          flight_i,
  input logic [Lanes-1:0] lane_valid_i,
  input logic             out_valid_o,
  input logic             out_ready_i
);
  logic gathers;
  logic [Lanes-1:0] asked;
  assign gathers = rst_ni && flight_valid_i && !out_valid_o;
  assign asked = Lanes'(flight_i.ask);
  flight_waits: cover property (@(posedge clk_i) gathers && lane_valid_i == '0);
  a_lane_waits_for_another: cover property (@(posedge clk_i) gathers && Lanes == 3
                                            && |(lane_valid_i & asked));
  a_lane_is_not_asked: cover property (@(posedge clk_i) rst_ni && flight_valid_i && Lanes == 3
                                       && |(lane_valid_i & ~asked));
  out_waits: cover property (@(posedge clk_i) rst_ni && out_valid_o && !out_ready_i);
endmodule

bind edge_collect edge_collect_cover #(
  .Lanes(Lanes)
) i_cover (.*);

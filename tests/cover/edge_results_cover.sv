// edge_results_cover: two children that want the same way, and retirements that are owed.
//   bound into edge_results; the points see words that move, or wait, at the clock
module edge_results_cover #(
  parameter int unsigned Ways = 1
) (
  input logic            clk_i,
  input logic            rst_ni,
  input logic [Ways-1:0] for_queue,
  input logic [Ways-1:0] for_out,
  input logic [Ways-1:0] ends,
  input logic            owed_i,
  input logic            push_valid_o,
  input logic            out_valid_o,
  input logic            out_ready_i
);
  two_for_the_queue: cover property (@(posedge clk_i) rst_ni && $countones(for_queue) > 1);
  two_for_out: cover property (@(posedge clk_i) rst_ni && $countones(for_out) > 1);
  one_of_each: cover property (@(posedge clk_i) rst_ni && push_valid_o && out_valid_o
                               && out_ready_i);
  out_waits: cover property (@(posedge clk_i) rst_ni && out_valid_o && !out_ready_i);
  two_end_at_once: cover property (@(posedge clk_i) rst_ni && $countones(ends) > 1);
  retirement_owed: cover property (@(posedge clk_i) rst_ni && owed_i && ends == '0);
  retirement_owed_and_another: cover property (@(posedge clk_i) rst_ni && owed_i && ends != '0);
endmodule

bind edge_results edge_results_cover #(
  .Ways(Ways)
) i_cover (.owed_i(owed_q != '0), .*);

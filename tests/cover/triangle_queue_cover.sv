// triangle_queue_cover: the queue at its limits: the last pops and base triangles that the credit rule allows, the pop of last resort, fifo
// mode and its fallback, ends of the memory, and everything read ahead.
//   bound into triangle_queue
module triangle_queue_cover
  import edge_pkg::*;
#(
  parameter int unsigned Depth = 64,
  localparam int unsigned CountBits = $clog2(Depth + 1),
  localparam int unsigned PlaceBits = $clog2(Depth)
) (
  input logic                        clk_i,
  input logic                        rst_ni,
  input triangle_queue_regs_t        regs_i,
  input logic                        push,
  input logic                        pop,
  input logic                        take_i,
  input logic                        retire_i,
  input logic                        oldest,
  input logic                        free_running,
  input logic                        alone_q,
  input logic                        below_q,
  input logic                        may_take_q,
  input logic        [1:0]           ahead_q,
  input logic        [CountBits-1:0] count_q,
  input logic signed [CountBits+3:0] slack_q,
  input logic                        exchanged_q,
  input logic        [PlaceBits-1:0] write_place,
  input logic        [PlaceBits-1:0] read_place,
  input logic                        pop_valid_o,
  input logic                        pop_ready_i
);
  logic held;
  assign held = rst_ni && count_q != '0 && ahead_q != 2'd3;

  // ---- credit
  pop_with_the_last_credit: cover property (@(posedge clk_i) rst_ni && pop && slack_q == 0);
  pop_without_credit_when_alone: cover property (@(posedge clk_i) rst_ni && pop && !free_running);
  pop_waits_for_credit: cover property (@(posedge clk_i) held && !free_running && !alone_q);
  pop_waits_for_fewer_in_flight: cover property (@(posedge clk_i) held && free_running && !below_q);
  base_with_the_least_credit: cover property (@(posedge clk_i) rst_ni && take_i && slack_q < 15);
  base_and_pop_at_once: cover property (@(posedge clk_i) rst_ni && take_i && pop);
  base_has_no_credit: cover property (@(posedge clk_i) rst_ni && !may_take_q && slack_q < 1);
  as_full_as_the_proof_allows: cover property (@(posedge clk_i) rst_ni
                                               && count_q >= CountBits'(Depth - 3));
  push_and_pop_and_retire: cover property (@(posedge clk_i) rst_ni && push && pop && retire_i);

  // ---- which end
  newest: cover property (@(posedge clk_i) rst_ni && pop && !regs_i.fifo);
  oldest_in_fifo_mode: cover property (@(posedge clk_i) rst_ni && pop && oldest);
  fallback_in_fifo_mode: cover property (@(posedge clk_i) rst_ni && pop && regs_i.fifo && !oldest);
  fallback_waits_for_a_push: cover property (@(posedge clk_i) held && regs_i.fifo && !oldest && push
                                             && (alone_q || (free_running && below_q)));
  exchanged: cover property (@(posedge clk_i) rst_ni && exchanged_q);

  // ---- ends of the memory, and what is read ahead
  written_last_place: cover property (@(posedge clk_i) push
                                                       && write_place == PlaceBits'(Depth - 1));
  read_last_place: cover property (@(posedge clk_i) pop && read_place == PlaceBits'(Depth - 1));
  read_first_place: cover property (@(posedge clk_i) pop && read_place == '0);
  three_read_ahead: cover property (@(posedge clk_i) rst_ni && ahead_q == 2'd3);
  pop_refused: cover property (@(posedge clk_i) rst_ni && pop_valid_o && !pop_ready_i);
endmodule

bind triangle_queue triangle_queue_cover #(
  .Depth(Depth)
) i_cover (.*);

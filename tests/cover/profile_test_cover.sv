// profile_test_cover: profiles of every length, at each border of a map, and every place that can be full.
//   bound into profile_test; the points see words that move, or wait, at the clock
module profile_test_cover
  import formats_pkg::*;
  import surface_pkg::*;
  import memory_pkg::*;
  import edge_pkg::*;
#(
  parameter int unsigned SamplesPerClock = 4
) (
  input logic                                clk_i,
  input logic                                rst_ni,
  input map_regs_t                           map_i,
  input logic                                in_valid_i,
  input logic                                in_ready_o,
  input logic                                head_valid,
  input logic                                head_leaves,
  input logic                          [2:0] levels_i,
  input logic                                forward_i,
  input logic                                ask,
  input logic                                request_ready,
  input logic                                order_ready,
  input logic                                asked_all_i,
  input logic                                quad_req_valid_o,
  input logic                                quad_req_ready_i,
  input quad_request_t [SamplesPerClock-1:0] quad_req_o,
  input logic          [SamplesPerClock-1:0] quad_req_mask_o,
  input logic                                out_valid_o,
  input logic                                out_ready_i,
  input logic                                out_leaves,
  input profile_test_out_t                   out_o
);
  logic leaves;
  assign leaves = rst_ni && head_valid && head_leaves;
  no_samples: cover property (@(posedge clk_i) leaves && levels_i == 3'd0);
  samples_3: cover property (@(posedge clk_i) leaves && levels_i == 3'd1);
  samples_5: cover property (@(posedge clk_i) leaves && levels_i == 3'd2);
  samples_9: cover property (@(posedge clk_i) leaves && levels_i == 3'd3);
  samples_17: cover property (@(posedge clk_i) leaves && levels_i == 3'd4);
  backward: cover property (@(posedge clk_i) leaves && levels_i != 3'd0 && !forward_i);
  forward: cover property (@(posedge clk_i) leaves && levels_i != 3'd0 && forward_i);
  before_the_middle: cover property (@(posedge clk_i) rst_ni && out_leaves && out_o.k < 5'd8);
  behind_the_middle: cover property (@(posedge clk_i) rst_ni && out_leaves && out_o.k > 5'd8);
  below_the_threshold: cover property (@(posedge clk_i) rst_ni && out_leaves && !out_o.pt);

  // ---- borders
  logic [SamplesPerClock-1:0] wanted, left, right, bottom, top;
  map_size_t last_u, last_v;
  assign wanted =
      quad_req_mask_o & {SamplesPerClock{rst_ni && quad_req_valid_o && quad_req_ready_i}};
  assign last_u = map_i.width - 14'd1;
  assign last_v = map_i.height - 14'd1;
  for (genvar i = 0; i < SamplesPerClock; i++) begin : gen_sample
    assign left[i] = wanted[i] && quad_req_o[i].x[0] == '0;
    assign right[i] = wanted[i] && quad_req_o[i].x[0] == last_u
                   && quad_req_o[i].x[1] == (map_i.wrap_u ? '0 : last_u);
    assign bottom[i] = wanted[i] && quad_req_o[i].y[0] == '0;
    assign top[i] = wanted[i] && quad_req_o[i].y[0] == last_v
                 && quad_req_o[i].y[1] == (map_i.wrap_v ? '0 : last_v);
  end
  clamped_left: cover property (@(posedge clk_i) |left && !map_i.wrap_u);
  clamped_right: cover property (@(posedge clk_i) |right && !map_i.wrap_u);
  clamped_bottom: cover property (@(posedge clk_i) |bottom && !map_i.wrap_v);
  clamped_top: cover property (@(posedge clk_i) |top && !map_i.wrap_v);
  wrapped_left: cover property (@(posedge clk_i) |left && map_i.wrap_u);
  wrapped_right: cover property (@(posedge clk_i) |right && map_i.wrap_u);
  wrapped_bottom: cover property (@(posedge clk_i) |bottom && map_i.wrap_v);
  wrapped_top: cover property (@(posedge clk_i) |top && map_i.wrap_v);

  // ---- waiting
  edges_full: cover property (@(posedge clk_i) rst_ni && in_valid_i && !in_ready_o);
  requests_full: cover property (@(posedge clk_i) rst_ni && ask && !request_ready);
  answers_full: cover property (@(posedge clk_i) rst_ni && head_valid && asked_all_i);
  order_full: cover property (@(posedge clk_i) rst_ni && head_valid && !order_ready);
  request_waits: cover property (@(posedge clk_i) rst_ni && quad_req_valid_o && !quad_req_ready_i);
  out_waits: cover property (@(posedge clk_i) rst_ni && out_valid_o && !out_ready_i);
endmodule

bind profile_test profile_test_cover #(
  .SamplesPerClock(SamplesPerClock)
) i_cover (
  .levels_i(head.levels),
  .forward_i(head.forward),
  .asked_all_i(asked_q == CountBits'(InFlight)),
  .*
);

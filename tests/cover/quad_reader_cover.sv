// quad_reader_cover: quads at each border of a map, clamped and wrapped, and what makes the reader wait.
//   bound into quad_reader; the points see requests that move
module quad_reader_cover
  import formats_pkg::*;
  import surface_pkg::*;
  import memory_pkg::*;
(
  input logic          clk_i,
  input logic          rst_ni,
  input map_regs_t     map_i,
  input logic          in_valid_i,
  input logic          free,
  input logic          pipe_ready,
  input logic          req_valid_o,
  input logic          req_ready_i,
  input quad_request_t req_o
);
  // x[0], x[1] are the columns of a quad.
  logic moves, left, right, bottom, top;
  map_size_t last_u, last_v;
  assign moves = rst_ni && req_valid_o && req_ready_i;
  assign last_u = map_i.width - 14'd1;
  assign last_v = map_i.height - 14'd1;
  assign left = moves && req_o.x[0] == '0;
  assign right = moves && req_o.x[0] == last_u;
  assign bottom = moves && req_o.y[0] == '0;
  assign top = moves && req_o.y[0] == last_v;
  clamped_left: cover property (@(posedge clk_i) left && !map_i.wrap_u);
  clamped_right: cover property (@(posedge clk_i) right && !map_i.wrap_u && req_o.x[1] == last_u);
  clamped_bottom: cover property (@(posedge clk_i) bottom && !map_i.wrap_v);
  clamped_top: cover property (@(posedge clk_i) top && !map_i.wrap_v && req_o.y[1] == last_v);
  wrapped_left: cover property (@(posedge clk_i) left && map_i.wrap_u);
  wrapped_right: cover property (@(posedge clk_i) right && map_i.wrap_u && req_o.x[1] == '0);
  wrapped_bottom: cover property (@(posedge clk_i) bottom && map_i.wrap_v);
  wrapped_top: cover property (@(posedge clk_i) top && map_i.wrap_v && req_o.y[1] == '0);
  corner_of_both: cover property (@(posedge clk_i) right && top);

  all_places_taken: cover property (@(posedge clk_i) rst_ni && in_valid_i && !free);
  requests_full: cover property (@(posedge clk_i) rst_ni && in_valid_i && free && !pipe_ready);
  request_waits: cover property (@(posedge clk_i) rst_ni && req_valid_o && !req_ready_i);
endmodule

bind quad_reader quad_reader_cover i_cover (.*);

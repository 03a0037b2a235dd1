// engine_links: link_properties at every link between the stages of the engine, and between those of a lane. The links at the engine's own
// ports have their checkers in SystemC (tb/cosim/link.hpp).
//   No links are: what goes into the FIFOs of a join, where the others' ready is a part of valid; a base triangle before edge_ask, which a
//   pop may go before; pushes, which are never refused.
//   Of what edge_collect hands on, the vertices of edges that don't split are anything. Where three tessellates choose which child goes out
//   the choice may fall on another while it waits; each child by itself waits as a link must.

bind engine link_properties #(
  .Name("triangle_queue, pop"), .Width($bits(edge_pkg::triangle_t))
) i_link_pop (
  .clk_i, .rst_ni(rst_ni && !start_i), .valid_i(pop_valid), .ready_i(pop_ready), .word_i(popped)
);

bind edge_ask link_properties #(
  .Name("edge_ask, out"), .Width($bits(engine_pkg::flight_t))
) i_link_out (
  .clk_i, .rst_ni, .valid_i(out_valid_o), .ready_i(out_ready_i), .word_i(out_o)
);

bind edge_dispatch link_properties #(
  .Name("edge_dispatch, flight"), .Width($bits(engine_pkg::flight_t))
) i_link_flight (
  .clk_i, .rst_ni, .valid_i(flight_valid_o), .ready_i(flight_ready_i), .word_i(flight_o)
);

bind edge_collect link_properties #(
  .Name("edge_collect, flight"), .Width($bits(engine_pkg::flight_t))
) i_link_flight (
  .clk_i, .rst_ni, .valid_i(flight_valid_i), .ready_i(flight_ready_o), .word_i(flight_i)
);

bind edge_collect link_properties #(
  .Name("edge_collect, out"), .Width($bits(edge_pkg::triangle_t) + 4)
) i_link_out (
  .clk_i,
  .rst_ni,
  .valid_i(out_valid_o),
  .ready_i(out_ready_i),
  .word_i({out_o.place, out_o.t.split, out_o.t.t})
);

bind tessellate link_properties #(
  .Name("tessellate, out"), .Width($bits(engine_pkg::child_t))
) i_link_out (
  .clk_i, .rst_ni, .valid_i(out_valid_o), .ready_i(out_ready_i), .word_i(out_o)
);

bind edge_results link_properties #(
  .Name("edge_results, out"), .Width($bits(edge_pkg::triangle_t))
) i_link_out (
  .clk_i, .rst_ni, .valid_i(out_valid_o), .ready_i(out_ready_i), .word_i(Ways == 1 ? out_o : '0)
);

bind edge_lane link_properties #(
  .Name("edge_lane, in"), .Width($bits(lane_pkg::lane_in_t))
) i_link_in (
  .clk_i, .rst_ni, .valid_i(in_valid_i), .ready_i(in_ready_o), .word_i(in_i)
);

bind edge_lane link_properties #(
  .Name("edge_lane, joined"), .Width($bits(lane_pkg::weighted_t) + $bits(lane_pkg::judged_t))
) i_link_joined (
  .clk_i,
  .rst_ni,
  .valid_i(joined_valid),
  .ready_i(joined_ready),
  .word_i({joined, joined_judged})
);

bind edge_lane link_properties #(
  .Name("edge_lane, made"), .Width($bits(lane_pkg::new_vertex_t))
) i_link_made (
  .clk_i, .rst_ni, .valid_i(made_valid), .ready_i(made_ready), .word_i(made)
);

bind edge_maps link_properties #(
  .Name("edge_maps, normal"), .Width($bits(surface_pkg::normal_sampler_out_t))
) i_link_normal (
  .clk_i, .rst_ni, .valid_i(normal_valid), .ready_i(normal_ready), .word_i(normal)
);

bind edge_maps link_properties #(
  .Name("edge_maps, displaced"), .Width($bits(edge_pkg::displace_vertex_out_t))
) i_link_displaced (
  .clk_i, .rst_ni, .valid_i(displaced_valid), .ready_i(displaced_ready), .word_i(displaced)
);

bind edge_maps link_properties #(
  .Name("edge_maps, waiting"), .Width($bits(lane_pkg::waiting_t))
) i_link_waiting (
  .clk_i, .rst_ni, .valid_i(waiting_valid), .ready_i(waiting_leaves), .word_i(waiting)
);

bind edge_lane link_properties #(
  .Name("edge_lane, last"), .Width($bits(lane_pkg::waiting_t))
) i_link_last (
  .clk_i, .rst_ni, .valid_i(last_valid), .ready_i(last_ready), .word_i(waiting)
);

bind edge_lane link_properties #(
  .Name("edge_lane, out"), .Width($bits(lane_pkg::lane_out_t))
) i_link_out (
  .clk_i, .rst_ni, .valid_i(out_valid_o), .ready_i(out_ready_i), .word_i(out_o)
);

bind edge_tests link_properties #(
  .Name("edge_tests, front"), .Width($bits(lane_pkg::tested_t))
) i_link_front (
  .clk_i, .rst_ni, .valid_i(front_valid), .ready_i(front_ready), .word_i(front)
);

bind edge_tests link_properties #(
  .Name("edge_tests, ends"), .Width($bits(lane_pkg::base_edge_t))
) i_link_ends (
  .clk_i, .rst_ni, .valid_i(ends_valid), .ready_i(leave), .word_i(ends)
);

bind edge_tests link_properties #(
  .Name("edge_tests, beside"), .Width($bits(beside))
) i_link_beside (
  .clk_i, .rst_ni, .valid_i(beside_valid), .ready_i(beside_leaves), .word_i(beside)
);

bind edge_tests link_properties #(
  .Name("edge_tests, sht"), .Width($bits(edge_pkg::summed_height_test_out_t))
) i_link_sht (
  .clk_i, .rst_ni, .valid_i(sht_valid), .ready_i(sht_ready), .word_i(sht)
);

bind edge_tests link_properties #(
  .Name("edge_tests, pt"), .Width($bits(edge_pkg::profile_test_out_t))
) i_link_pt (
  .clk_i, .rst_ni, .valid_i(pt_valid), .ready_i(pt_ready), .word_i(pt)
);

bind edge_tests link_properties #(
  .Name("edge_tests, said"), .Width($bits(said))
) i_link_said (
  .clk_i, .rst_ni, .valid_i(complete), .ready_i(said_ready), .word_i(said_in)
);

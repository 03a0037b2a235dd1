// edge_ask: what is asked of a triangle in this round: the edges that are not settled, or of a base triangle its vertices.
//   in    in_valid_i, in_ready_o, in_i
//   out   out_valid_o, out_ready_i, out_o  the triangle, its edges settled as get_triangle says, and what is asked
//   contract: get_triangle in step() of hls/edge/engine.hpp
//
//   latency 1, initiation interval 1; registered: all of out. in_ready_o depends on out_ready_i: what is behind is a gate of registers, and
//   what is before, the queue, takes it to registers alone
//
//   in --+--[triangle]------+-- out
//        +--[get_triangle]--+
module edge_ask
  import formats_pkg::*;
  import edge_pkg::*;
  import engine_pkg::*;
(
  input  logic        clk_i,
  input  logic        rst_ni,
  input  generation_t max_generation_i,
  input  logic        in_valid_i,
  output logic        in_ready_o,
  input  triangle_t   in_i,
  output logic        out_valid_o,
  input  logic        out_ready_i,
  output flight_t     out_o
);
  logic valid_q;
  triangle_t triangle_q;
  assign in_ready_o = !valid_q || out_ready_i;
  assign out_valid_o = valid_q;
  always_ff @(posedge clk_i) begin
    if (in_ready_o) triangle_q <= in_i;
    if (!rst_ni) valid_q <= 1'b0;
    else if (in_ready_o) valid_q <= in_valid_i;
  end

  // get_triangle never stalls: of a triangle that waits it says the same again.
  get_triangle_out_t got;
  get_triangle i_get_triangle (
    .clk_i, .max_generation_i, .in_i(in_ready_o ? in_i : triangle_q), .out_o(got)
  );

  always_comb begin
    out_o.t = triangle_q;
    out_o.t.settled = got.settled;
    out_o.place = |got.new_surface;
    out_o.ask = out_o.place ? 3'b111 : ~got.settled;
  end

  // Which normals are new makes no difference here.
  logic unused_normal;
  assign unused_normal = ^{got.new_normal, triangle_q.settled};
endmodule

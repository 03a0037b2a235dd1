// new_vertex: P, U, N and T at k/16 of an edge; a base vertex keeps its own.
//   contract: new_vertex of hls/edge/engine.hpp, what comes before the normal map is read
//
//   parameter  Clocks  that a vertex takes, 1 or 3: with three N and T take turns
//   in         first_i with three clocks: a vertex comes in; the next at the earliest three clocks later
//
//   latency CalculateNewN, with three clocks one more; initiation interval Clocks; registered: every unit's stages; a pure pipeline of
//   calculate_new_p, _u and two of _n, or one
module new_vertex
  import formats_pkg::*;
  import edge_pkg::*;
  import lane_pkg::*;
  import latency_pkg::*;
#(
  parameter int unsigned Clocks = 1,
  localparam int unsigned Latency = latency_pkg::new_vertex(Clocks)
) (
  input  logic        clk_i,
  input  logic        first_i,
  input  weighted_t   in_i,
  output new_vertex_t out_o
);
  base_end_t a, b;
  assign a = in_i.work.a;
  assign b = in_i.work.b;

  // At k = 0 positions and coordinates are those of end a to the bit; normals would be normalised once more.
  calculate_new_p_out_t s0_p, s1_p;
  calculate_new_p i_p (.clk_i, .in_i('{k: in_i.k, p2: b.p, p1: a.p}), .out_o(s0_p));
  delay #(.T(calculate_new_p_out_t), .Stages(Latency - CalculateNewP)) i_p_later (
    .clk_i, .x_i(s0_p), .y_o(s1_p)
  );
  calculate_new_u_out_t s0_u, s1_u;
  calculate_new_u i_u (.clk_i, .in_i('{k: in_i.k, u2: b.u, u1: a.u}), .out_o(s0_u));
  delay #(.T(calculate_new_u_out_t), .Stages(Latency - CalculateNewU)) i_u_later (
    .clk_i, .x_i(s0_u), .y_o(s1_u)
  );
  calculate_new_n_out_t s1_n, s1_t;
  calculate_new_n_in_t normals, tangents;
  assign normals  = '{tangent: 1'b0, k: in_i.k, n2: b.n, n1: a.n};
  assign tangents = '{tangent: 1'b1, k: in_i.k, n2: b.t, n1: a.t};
  if (Clocks == 1) begin : gen_both
    calculate_new_n i_n (.clk_i, .in_i(normals), .out_o(s1_n));
    calculate_new_n i_t (.clk_i, .in_i(tangents), .out_o(s1_t));
    logic unused_first;
    assign unused_first = first_i;
  end else begin : gen_in_turns
    calculate_new_n_in_t  tangents_q;
    calculate_new_n_out_t s1_either;
    always_ff @(posedge clk_i) begin
      tangents_q <= tangents;
      s1_n <= s1_either;
    end
    calculate_new_n i_either (
      .clk_i, .in_i(first_i ? normals : tangents_q), .out_o(s1_either)
    );
    assign s1_t = s1_either;
  end

  // A base vertex keeps its normal and tangent.
  typedef struct packed {
    unit_t [2:0] t;
    unit_t [2:0] n;
    logic        place;
    logic        needed;
  } own_t;
  own_t own;
  delay #(.T(own_t), .Stages(Latency)) i_own (
    .clk_i, .x_i('{t: a.t, n: a.n, place: in_i.work.place, needed: in_i.needed}), .y_o(own)
  );

  always_comb begin
    out_o.base.p = s1_p.p;
    out_o.base.u = s1_u.u;
    out_o.base.n = own.place ? own.n : s1_n.n;
    out_o.base.t = own.place ? own.t : s1_t.n;
    out_o.zeros = own.place ? 2'd0 : 2'(s1_n.zero) + 2'(s1_t.zero);
    out_o.needed = own.needed;
  end
endmodule

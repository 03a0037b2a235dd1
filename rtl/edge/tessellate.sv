// tessellate: builds the two, three or four triangles of a triangle with one, two or three split edges.
//   the patterns, their order, generations and settled edges: contract: hls/edge/tessellate.hpp
//
//   in    in_i   at least one edge is split
//   out   out_o  t[i] says something where i < count
//
//   latency 8, initiation interval 1; a pure pipeline: never stalls, no reset on data; registered: every stage
//
//   in --[s0_turned]--+--[s1_first, second]--[s2_less, more]--x--[s3_product]-- + + --[s4_difference]--+
//     a b c m p q     +--[vertex_order]----------------------------------------------------------------+--[s5_first]--+
//                     +------------------------------------------------------------------------------------------------+--[t]
//
//   The triangle is turned first, so that its one split edge, or its one whole edge, runs from a to b: one pattern each remains,
//       1 split              2 splits              3 splits
//          c                     c                     c             m is the new vertex of a-b,
//         /|\                  q/_\p                 q/_\p           p of b-c, q of c-a
//        / | \                 /   \                 /\ /\           t[0] t[1] t[2] t[3] in the order of the contract
//      a/__m__\b             a/_____\b             a/__m__\b
//   Which diagonal of the quad a b p q is shorter is the sign of |a-p|^2 - |b-q|^2, exact: with x = a-p and y = b-q it is the sum of
//   (x-y)(x+y) over the axes, three products in the place of six squares.
module tessellate
  import formats_pkg::*;
  import surface_pkg::*;
  import edge_pkg::*;
(
  input  logic            clk_i,
  input  map_regs_t       map_i,
  input  generation_t     max_generation_i,
  input  tessellate_in_t  in_i,
  output tessellate_out_t out_o
);
  typedef struct packed {
    logic        settled;
    generation_t generation;
  } edge_state_t;
  // A triangle turned so that vertex 0 is a; m[i] is the new vertex of edge i.
  typedef struct packed {
    edge_state_t       inner;
    edge_state_t [2:0] half;
    edge_state_t [2:0] whole;
    index_t            index;
    vertex_t     [2:0] m;
    vertex_t     [2:0] v;
    logic        [1:0] splits;
  } turned_t;

  function automatic edge_state_t child_edge(generation_t parent, generation_t limit);
    generation_t generation;
    generation = parent + 4'd1;
    return '{generation: generation, settled: generation >= limit};
  endfunction
  function automatic generation_t larger(generation_t a, generation_t b);
    return a > b ? a : b;
  endfunction
  function automatic triangle_t triangle(index_t index, vertex_t a, vertex_t b, vertex_t c,
                                         edge_state_t ab, edge_state_t bc, edge_state_t ca);
    return '{
      v: {c, b, a},
      index: index,
      generation: {ca.generation, bc.generation, ab.generation},
      settled: {ca.settled, bc.settled, ab.settled},
      last: 1'b0
    };
  endfunction

  // ---- s0: turned
  localparam int unsigned Pattern [8] = '{0, 1, 1, 2, 1, 2, 2, 3};
  logic [1:0] turn;
  always_comb begin
    unique case (in_i.split)
      3'b010, 3'b101: turn = 2'd1;
      3'b100, 3'b011: turn = 2'd2;
      default: turn = 2'd0;
    endcase
  end
  generation_t [2:0] asked;
  always_comb begin
    for (int i = 0; i < 3; i++) asked[i] = in_i.split[i] ? in_i.t.generation[i] : '0;
  end

  logic [2:0][1:0] from;
  always_comb begin
    for (int i = 0; i < 3; i++) from[i] = 2'((i + int'(turn)) % 3);
  end

  turned_t s0_turned_q;
  always_ff @(posedge clk_i) begin
    s0_turned_q.splits <= 2'(Pattern[in_i.split]);
    s0_turned_q.index <= in_i.t.index;
    s0_turned_q.inner <= child_edge(larger(larger(asked[0], asked[1]), asked[2]), max_generation_i);
    for (int i = 0; i < 3; i++) begin
      s0_turned_q.v[i] <= in_i.t.v[from[i]];
      s0_turned_q.m[i] <= in_i.m[from[i]];
      s0_turned_q.whole[i] <= '{generation: in_i.t.generation[from[i]], settled: 1'b1};
      s0_turned_q.half[i] <= child_edge(in_i.t.generation[from[i]], max_generation_i);
    end
  end

  // ---- s1 to s4: the difference of the squared diagonals. A product of two words of 26 bits has 52, three of them 54.
  logic signed [2:0][51:0] s3_product;
  for (genvar i = 0; i < 3; i++) begin : gen_axis
    position_t a, b, p, q;
    assign a = s0_turned_q.v[0].p[i];
    assign b = s0_turned_q.v[1].p[i];
    assign p = s0_turned_q.m[1].p[i];
    assign q = s0_turned_q.m[2].p[i];
    logic signed [24:0] s1_first_q, s1_second_q;
    logic signed [25:0] s2_less_q, s2_more_q;
    always_ff @(posedge clk_i) begin
      s1_first_q  <= 25'(a) - 25'(p);
      s1_second_q <= 25'(b) - 25'(q);
      s2_less_q   <= 26'(s1_first_q) - 26'(s1_second_q);
      s2_more_q   <= 26'(s1_first_q) + 26'(s1_second_q);
    end
    multiply #(.A(26), .B(26)) i_product (
      .clk_i, .a_i(s2_less_q), .b_i(s2_more_q), .y_o(s3_product[i])
    );
  end
  logic signed [53:0] s4_difference_q;
  always_ff @(posedge clk_i) begin
    s4_difference_q <= 54'(signed'(s3_product[0])) + 54'(signed'(s3_product[1]))
                     + 54'(signed'(s3_product[2]));
  end

  // ---- s5: a-p is the diagonal
  logic precedes, s4_precedes, s5_first_q;
  vertex_order i_order (
    .clk_i, .map_i, .a_i(s0_turned_q.v[0]), .b_i(s0_turned_q.v[1]), .precedes_o(precedes)
  );
  delay #(.Stages(3)) i_precedes (.clk_i, .x_i(precedes), .y_o(s4_precedes));
  always_ff @(posedge clk_i) begin
    s5_first_q <= s4_difference_q[53] || (s4_difference_q == '0 && s4_precedes);
  end

  // ---- the triangles
  turned_t s5;
  delay #(.T(turned_t), .Stages(6)) i_turned (.clk_i, .x_i(s0_turned_q), .y_o(s5));
  vertex_t a, b, c, m, p, q;
  assign {c, b, a} = s5.v;
  assign {q, p, m} = s5.m;
  edge_state_t [2:0] whole, half;
  edge_state_t       inner;
  assign whole = s5.whole;
  assign half = s5.half;
  assign inner = s5.inner;
  always_ff @(posedge clk_i) begin
    out_o.count <= 3'(s5.splits) + 3'd1;
    // Of three splits, and of the other two patterns as far as they reach.
    out_o.t[0] <= triangle(s5.index, a, m, q, half[0], inner, half[2]);
    out_o.t[1] <= triangle(s5.index, m, b, p, half[0], half[1], inner);
    out_o.t[2] <= triangle(s5.index, q, p, c, inner, half[1], half[2]);
    out_o.t[3] <= triangle(s5.index, m, p, q, inner, inner, inner);
    if (s5.splits == 2'd1) begin
      out_o.t[0] <= triangle(s5.index, a, m, c, half[0], inner, whole[2]);
      out_o.t[1] <= triangle(s5.index, m, b, c, half[0], whole[1], inner);
    end else if (s5.splits == 2'd2) begin
      out_o.t[0] <= triangle(s5.index, q, p, c, inner, half[1], half[2]);
      if (s5_first_q) begin
        out_o.t[1] <= triangle(s5.index, a, b, p, whole[0], half[1], inner);
        out_o.t[2] <= triangle(s5.index, a, p, q, inner, inner, half[2]);
      end else begin
        out_o.t[1] <= triangle(s5.index, a, b, q, whole[0], inner, half[2]);
        out_o.t[2] <= triangle(s5.index, b, p, q, half[1], inner, inner);
      end
    end
  end

  // Where the triangle was last of its mesh, or which of its edges were settled, its children do not say.
  logic unused_last;
  assign unused_last = ^{in_i.t.last, in_i.t.settled};
endmodule

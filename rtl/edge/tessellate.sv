// tessellate: builds the two, three or four triangles of a triangle with one, two or three split edges, one after the other.
//   the patterns, their order, generations and settled edges: contract: hls/edge/tessellate.hpp
//
//   in    in_valid_i, in_ready_o, in_i   a triangle, which of its edges split, and where; one that does not split passes as it is, settled;
//                                        a base triangle (place) gets its vertices
//   out   out_valid_o, out_ready_i, out_o
//   max_generation_i, map_i              constant while triangles are inside
//
//   latency 5, of the second triangle of two splits 14; initiation interval: the triangles that are
//   put out, and 3 behind two splits. Registered: all outputs; no path from out_ready_i to in_ready_o
//
//   in --+--[stream_fifo: six vertices]-------------------+--[t]-- out
//        +--[stream_fifo: what to do]-----------+--[plan]-+
//        +--[shorter_diagonal]--[stream_fifo]---+
//
//   Six vertices wait and not the twelve of the children: a child's are chosen when it leaves, by bits that are registers. With a, b, c turned so that the
//   one split edge, or the one whole edge, runs from a to b,
//       1 split              2 splits              3 splits
//          c                     c                     c             m is the new vertex of a-b,
//         /|\                  q/_\p                 q/_\p           p of b-c, q of c-a
//        / | \                 /   \                 /\ /\           the children in the order of the contract
//      a/__m__\b             a/_____\b             a/__m__\b
module tessellate
  import formats_pkg::*;
  import surface_pkg::*;
  import edge_pkg::*;
  import engine_pkg::*;
  import latency_pkg::*;
#(
  parameter int unsigned Depth = 16
) (
  input  logic        clk_i,
  input  logic        rst_ni,
  input  map_regs_t   map_i,
  input  generation_t max_generation_i,
  input  logic        in_valid_i,
  output logic        in_ready_o,
  input  collected_t  in_i,
  output logic        out_valid_o,
  input  logic        out_ready_i,
  output child_t      out_o
);
  typedef struct packed {
    logic        settled;
    generation_t generation;
  } edge_state_t;
  // What is to be done with six vertices: settled speaks of a base triangle alone; highest is the largest generation of a split edge.
  typedef struct packed {
    logic              place;
    logic        [2:0] split;
    logic        [2:0] settled;
    generation_t       highest;
    generation_t [2:0] generation;
    index_t            index;
  } order_t;
  typedef struct packed {
    vertex_t [2:0] m;
    vertex_t [2:0] v;
  } six_t;
  // A vertex of a child: one of a, b, c, m, p, q, turned back to those of six_t; one bit is set.
  typedef struct packed {
    logic [2:0] m;
    logic [2:0] v;
  } choice_t;

  function automatic edge_state_t child_edge(generation_t parent, generation_t limit);
    generation_t generation;
    generation = parent + 4'd1;
    return '{generation: generation, settled: generation >= limit};
  endfunction
  function automatic generation_t larger(generation_t a, generation_t b);
    return a > b ? a : b;
  endfunction
  // What is called a, b, c (m, p, q) as the place among v (m): a is v[turn].
  function automatic logic [1:0] turn_of(logic [2:0] split);
    unique case (split)
      3'b010, 3'b101: return 2'd1;
      3'b100, 3'b011: return 2'd2;
      default: return 2'd0;
    endcase
  endfunction
  function automatic logic [2:0] place_of(logic [1:0] turn, int unsigned name);
    unique case (turn)
      2'd1: return 3'b001 << ((name + 1) % 3);
      2'd2: return 3'b001 << ((name + 2) % 3);
      default: return 3'b001 << name;
    endcase
  endfunction
  function automatic vertex_t choose(six_t six, choice_t which);
    vertex_t chosen;
    chosen = '0;
    for (int i = 0; i < 3; i++) begin
      chosen |= {$bits(vertex_t){which.v[i]}} & six.v[i];
      chosen |= {$bits(vertex_t){which.m[i]}} & six.m[i];
    end
    return chosen;
  endfunction

  // ---- in: of two splits the diagonals are asked for, which takes three clocks
  logic take, two_in, asking, places_left, unused_orders_ready, unused_decisions_ready;
  logic [1:0] asked_q;
  assign asking = asked_q != '0;
  assign in_ready_o = places_left && !asking;
  assign take = in_valid_i && in_ready_o;
  assign two_in = $countones(in_i.t.split) == 2;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) asked_q <= '0;
    else asked_q <= {asked_q[0], take && two_in};
  end

  generation_t [2:0] split_generation;
  order_t order_in, order;
  six_t six_in, six;
  always_comb begin
    for (int i = 0; i < 3; i++) begin
      split_generation[i] = in_i.t.split[i] ? in_i.t.t.generation[i] : '0;
    end
    order_in = '{
        place: in_i.place,
        split: in_i.t.split,
        settled: in_i.t.t.settled,
        highest: larger(larger(split_generation[0], split_generation[1]), split_generation[2]),
        generation: in_i.t.t.generation,
        index: in_i.t.t.index
    };
    six_in = '{m: in_i.t.m, v: in_i.t.t.v};
  end
  logic order_valid, order_ready, unused_six_valid, six_ready;
  logic [$clog2(Depth+1)-1:0] unused_count, unused_six_count;
  stream_fifo #(.T(order_t), .Depth(Depth)) i_orders (
    .clk_i,
    .rst_ni,
    .in_valid_i(take),
    .in_ready_o(unused_orders_ready),
    .in_i(order_in),
    .out_valid_o(order_valid),
    .out_ready_i(order_ready),
    .out_o(order),
    .count_o(unused_count)
  );
  // The vertices leave after their order: where there is a place for them there is one for it.
  stream_fifo #(.T(six_t), .Depth(Depth)) i_six (
    .clk_i,
    .rst_ni,
    .in_valid_i(take),
    .in_ready_o(places_left),
    .in_i(six_in),
    .out_valid_o(unused_six_valid),
    .out_ready_i(six_ready),
    .out_o(six),
    .count_o(unused_six_count)
  );

  // ---- of two splits, whether the diagonal a-p is taken; a decision leaves with its order, so there is always a place for it
  logic [2:0][1:0] from;
  logic decision, decided, decision_ready, first;
  always_comb begin
    for (int i = 0; i < 3; i++) from[i] = 2'((i + int'(turn_of(in_i.t.split))) % 3);
  end
  shorter_diagonal i_diagonal (
    .clk_i,
    .map_i,
    .start_i(take && two_in),
    .a_i(in_i.t.t.v[from[0]]),
    .b_i(in_i.t.t.v[from[1]]),
    .p_i(in_i.t.m[from[1]]),
    .q_i(in_i.t.m[from[2]]),
    .first_o(decision)
  );
  stream_pipe #(.T(logic), .Latency(ShorterDiagonal), .Depth(Depth)) i_decisions (
    .clk_i,
    .rst_ni,
    .in_valid_i(take && two_in),
    .in_ready_o(unused_decisions_ready),
    .data_i(decision),
    .out_valid_o(decided),
    .out_ready_i(decision_ready),
    .out_o(first)
  );

  // ---- the next child of the order at the head, and what it is made of
  typedef struct packed {
    logic              ends;
    logic              born;
    index_t            index;
    edge_state_t [2:0] edges;
    choice_t     [2:0] vertices;
  } plan_t;
  plan_t plan, plan_q;
  logic [1:0] splits, child_q;
  logic known, plan_valid_q, plan_free, go, ends, out_free;
  assign splits = 2'($countones(order.split));
  assign ends = child_q == splits;
  assign known = splits != 2'd2 || child_q == '0 || decided;
  assign out_free = !out_valid_o || out_ready_i;
  assign plan_free = !plan_valid_q || out_free;
  assign go = order_valid && known && plan_free;
  assign order_ready = known && plan_free && ends;
  assign decision_ready = order_valid && splits == 2'd2 && ends && plan_free;
  assign six_ready = plan_valid_q && out_free && plan_q.ends;

  logic    [2:0] a, b, c;
  choice_t [2:0] choice;
  always_comb begin
    a = place_of(turn_of(order.split), 0);
    b = place_of(turn_of(order.split), 1);
    c = place_of(turn_of(order.split), 2);
    // m lies on the edge that begins at a: its place among m is that of a among v, and so p's is b's and q's is c's.
    choice = '0;
    unique case ({splits, child_q})
      4'b01_00: {choice[0].v, choice[1].m, choice[2].v} = {a, a, c};
      4'b01_01: {choice[0].m, choice[1].v, choice[2].v} = {a, b, c};
      4'b10_00, 4'b11_10: {choice[0].m, choice[1].m, choice[2].v} = {c, b, c};
      4'b10_01: {choice[0].v, choice[1].v, choice[2].m} = {a, b, first ? b : c};
      4'b10_10: {choice[0].v, choice[1].m, choice[2].m} = {first ? a : b, b, c};
      4'b11_00: {choice[0].v, choice[1].m, choice[2].m} = {a, a, c};
      4'b11_01: {choice[0].m, choice[1].v, choice[2].m} = {a, b, b};
      4'b11_11: {choice[0].m, choice[1].m, choice[2].m} = {a, b, c};
      default: begin
        if (order.place) {choice[0].m, choice[1].m, choice[2].m} = {a, b, c};
        else {choice[0].v, choice[1].v, choice[2].v} = {a, b, c};
      end
    endcase
  end

  // Edges of a child: an inner one, or a half or whole edge of the triangle.
  edge_state_t       inner;
  edge_state_t [2:0] half, whole, edges;
  always_comb begin
    inner = child_edge(order.highest, max_generation_i);
    for (int i = 0; i < 3; i++) begin
      automatic logic [1:0] place = 2'((i + int'(turn_of(order.split))) % 3);
      half[i] = child_edge(order.generation[place], max_generation_i);
      whole[i] = '{generation: order.generation[place], settled: !order.place || order.settled[i]};
    end
    unique case ({splits, child_q})
      4'b01_00: edges = {whole[2], inner, half[0]};
      4'b01_01: edges = {inner, whole[1], half[0]};
      4'b10_00, 4'b11_10: edges = {half[2], half[1], inner};
      4'b10_01: edges = first ? {inner, half[1], whole[0]} : {half[2], inner, whole[0]};
      4'b10_10: edges = first ? {half[2], inner, inner} : {inner, inner, half[1]};
      4'b11_00: edges = {half[2], inner, half[0]};
      4'b11_01: edges = {inner, half[1], half[0]};
      4'b11_11: edges = {inner, inner, inner};
      default: edges = whole;
    endcase
  end

  assign plan = '{
      ends: ends,
      born: splits != '0 || order.place,
      index: order.index,
      edges: edges,
      vertices: choice
  };

  // ---- out
  always_ff @(posedge clk_i) begin
    if (plan_free) plan_q <= plan;
    if (out_free) begin
      for (int i = 0; i < 3; i++) begin
        out_o.t.v[i] <= choose(six, plan_q.vertices[i]);
        {out_o.t.settled[i], out_o.t.generation[i]} <= plan_q.edges[i];
      end
      out_o.t.index <= plan_q.index;
      out_o.t.last <= 1'b0;
      out_o.born <= plan_q.born;
      out_o.ends <= plan_q.ends;
    end
    if (!rst_ni) begin
      plan_valid_q <= 1'b0;
      out_valid_o <= 1'b0;
      child_q <= '0;
    end else begin
      if (plan_free) plan_valid_q <= order_valid && known;
      if (out_free) out_valid_o <= plan_valid_q;
      if (go) child_q <= ends ? '0 : child_q + 2'd1;
    end
  end

  // What was last of its mesh does not say so.
  logic unused_last;
  assign unused_last = in_i.t.t.last;
endmodule

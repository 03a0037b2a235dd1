// walk_names: the primitives of a walk by the names of their vertices, from what the walk decided.
//   v_bl, v_br, v_tl, v_tr of Gumhold & Huettner 1999, 3.4.4: left, right, top_left, top_right
//   in    in_valid_i, in_i   a step: its moves, the strip's first vertices, the edge's two, the one of a vertical edge at the end
//   out   out_o              a vertex of 34 bits: kind, s and t or i and number
//
//   latency 1, initiation interval 1; a pure pipeline: no reset, the registers are written by a strip's first step
//   registered: out_o, and the vertices that the next step begins with
module walk_names
  import formats_pkg::*;
  import sweep_pkg::*;
  import walk_pkg::*;
(
  input  logic   clk_i,
  input  logic   in_valid_i,
  input  step_t  in_i,
  output named_t out_o
);
  function automatic name_t border(border_t b);
    border = '{kind: {1'b0, b.on_edge}, x: b.i, y: 16'(b.number)};
  endfunction
  function automatic name_t grid(grid_t s, grid_t t);
    grid = '{kind: 2'd2, x: s, y: t};
  endfunction

  // What stands above the grid vertices of the two sides, as a row.
  name_t left_q, right_q, left, right, top_left, top_right, edge_, next, upright;
  grid_t left_t_q, right_t_q, left_t, right_t;
  moves_t m;
  grid_t above;
  assign above = m.mirrored ? -16'sd1 : 16'sd1;
  assign m = in_i.moves;
  assign left = m.first ? border(in_i.left) : left_q;
  assign right = m.first ? border(in_i.right) : right_q;
  assign left_t = m.first ? in_i.left_t : left_t_q;
  assign right_t = m.first ? in_i.right_t : right_t_q;
  assign edge_ = border(in_i.edge_);
  assign next = border(in_i.next);
  assign upright = border(in_i.upright);
  assign top_left = m.edge_here ? edge_ : grid(in_i.left_s, left_t);
  assign top_right = !m.edge_there ? grid(in_i.right_s, right_t) : m.on_edge ? upright :
                     m.edge_here ? next : edge_;

  // Of a triangle the second and third vertex, counter-clockwise in the frame; of a quad right and top_left.
  name_t second, third;
  logic quad;
  assign quad = m.go_left && m.go_right;
  assign second = m.fan ? next : right;
  assign third = m.fan || m.double_ ? edge_ : m.go_left ? top_left : top_right;

  always_ff @(posedge clk_i) begin
    out_o.quad <= quad;
    out_o.v[0] <= left;
    out_o.v[1] <= m.flip ? third : second;
    out_o.v[2] <= quad ? top_right : m.flip ? second : third;
    out_o.v[3] <= !quad ? '0 : m.flip ? second : third;
    out_o.moves <= m;
    out_o.strip_last <= in_i.strip_last;
    out_o.sub_last <= in_i.sub_last;
    out_o.last <= in_i.last;
    if (in_valid_i) begin
      left_q <= m.double_ ? edge_ : m.go_left ? top_left : left;
      right_q <= m.go_right ? top_right : right;
      left_t_q <= m.go_left && !m.edge_here ? left_t + above : left_t;
      right_t_q <= m.go_right && !m.edge_there ? right_t + above : right_t;
    end
  end
endmodule

// side_walk: the strips of a remeshing, one after the other; the inner loop, a primitive a clock.
//   Gumhold & Huettner 1999, 3.4.4, Figures 14 and 15                         contract: hls/sweep/side_walk.hpp
//   in    strip_valid_i, strip_ready_o, strip_i   a strip's first vertices, from walk_strips
//         edge_valid_i, edge_ready_o, edge_i      vertices of the side edges, from walk_edges
//   out   out_valid_o, out_ready_i, out_o         the kernel's primitive, whether it is the last of its strip, its sub-triangle, its triangle,
//                                                 and what a data path does to have its vertices
//
//   latency 11 from the first vertex of an edge to the first primitive, 9 from its strip; then initiation interval 1, from strip to strip and
//   from triangle to triangle too, as long as strips and vertices are there. Registered: all outputs, but for a gate behind out_o; no path
//   from a ready or a valid to another.
//
//   The kernel's decisions ask for the difference of rows alone: dl from the left to E, dr from the right, and left - right. Consecutive
//   edge vertices are 0 or 1 rows and columns apart and a grid vertex a row above the one below it, so the answers of the next
//   clock are comparisons of this clock's differences with small numbers, chosen by what is decided now: they are registers too.
//     edge_here  (near, and E in column k)      near: the left stands on the edge, or dl <= 1
//     base       from P_k to E, from which those of the next strip begin
//   strips ---[stream_fifo]--+
//   edge ---[stream_fifo]--[next]--[edge]--[decide]--[walk_output]-- out
module side_walk
  import formats_pkg::*;
  import sweep_pkg::*;
  import walk_pkg::*;
(
  input  logic         clk_i,
  input  logic         rst_ni,
  input  logic         strip_valid_i,
  output logic         strip_ready_o,
  input  strip_t       strip_i,
  input  logic         edge_valid_i,
  output logic         edge_ready_o,
  input  edge_vertex_t edge_i,
  output logic         out_valid_o,
  input  logic         out_ready_i,
  output walked_t      out_o
);
  typedef logic signed [17:0] rows_t;
  // Bit m + 3: x <= m, for m of -3 to 3.
  typedef logic [6:0] order_t;
  function automatic order_t order(rows_t x);
    automatic logic none = x[16:3] == '0;
    automatic logic all = &x[16:3];
    for (int m = 0; m < 4; m++) order[m+3] = x[17] || (none && x[2:0] <= 3'(m));
    order[2] = x[17];
    order[1] = x[17] && !(all && x[2:0] == 3'd7);
    order[0] = x[17] && !(all && x[2:0] >= 3'd6);
  endfunction
  // ---- the next strip; E and the vertex after it
  // A decision needs little of a strip; its names wait in walk_output.
  logic control_ready, names_ready;
  strip_control_t coming, strip_q, control_in;
  assign control_in = '{
      point: strip_i.point,
      from_corner: strip_i.from_corner,
      last: strip_i.last,
      pointed: strip_i.pointed,
      on_edge: strip_i.on_edge,
      rows: strip_i.rows,
      upright_n: strip_i.upright_n,
      upright_rising: strip_i.upright.rising
  };
  assign strip_ready_o = control_ready && names_ready;
  edge_vertex_t head, next_q, edge_q;
  logic coming_valid, head_valid, next_valid_q, edge_valid_q, start, pop;
  logic [3:0] unused_strips, unused_vertices;
  stream_fifo #(.T(strip_control_t), .Depth(8)) i_strips (
    .clk_i,
    .rst_ni,
    .in_valid_i(strip_valid_i && names_ready),
    .in_ready_o(control_ready),
    .in_i(control_in),
    .out_valid_o(coming_valid),
    .out_ready_i(start),
    .out_o(coming),
    .count_o(unused_strips)
  );
  stream_fifo #(.T(edge_vertex_t), .Depth(8)) i_vertices (
    .clk_i,
    .rst_ni,
    .in_valid_i(edge_valid_i),
    .in_ready_o(edge_ready_o),
    .in_i(edge_i),
    .out_valid_o(head_valid),
    .out_ready_i(pop || !(edge_valid_q && next_valid_q)),
    .out_o(head),
    .count_o(unused_vertices)
  );
  always_ff @(posedge clk_i) begin
    if (pop || !edge_valid_q) edge_q <= next_q;
    if (pop || !edge_valid_q || !next_valid_q) next_q <= head;
    if (!rst_ni) begin
      edge_valid_q <= 1'b0;
      next_valid_q <= 1'b0;
    end else begin
      if (pop || !edge_valid_q) edge_valid_q <= next_valid_q;
      if (pop || !edge_valid_q || !next_valid_q) next_valid_q <= head_valid;
    end
  end

  // ---- one step
  // at_end: E is the end of the list, which is not among the vertices; here: E is in column k.
  logic active_q, first_q, left_on_q, right_on_q, here_q, at_end_q, upright_last_q;
  rows_t dl_q, dr_q, base_q, left_right_q;
  logic dl_0_q, dl_1_q, dr_0_q, dr_1_q, below_q, above_q;
  logic edge_here, edge_there, fan, double_, go_left, go_right, advance, room, go;
  logic left_on, right_on, here, done;
  assign edge_here = here_q && (left_on_q || dl_1_q);
  assign fan = strip_q.pointed && edge_here && edge_q.last;
  assign double_ = edge_here && !fan && !edge_q.column && !edge_q.row;
  always_comb begin
    go_left = !fan && !double_ && (edge_here || !left_on_q);
    go_right = !fan && !double_ && !right_on_q;
    if (go_left && go_right) begin
      if ((edge_here && dl_0_q) || below_q) go_right = 1'b0;
      else if (above_q) go_left = 1'b0;
    end
    // The right sees what the left leaves.
    if (strip_q.on_edge) edge_there = 1'b1;
    else if (!edge_here) edge_there = !here_q && dr_1_q;
    else edge_there = go_left && edge_q.column && (edge_q.row ? dr_0_q : dr_1_q);
  end
  assign advance = fan || double_ || (go_left && edge_here);
  assign left_on = left_on_q || double_ || (go_left && edge_here);
  assign right_on = right_on_q || (go_right && edge_there && (!strip_q.on_edge || upright_last_q));
  assign here = here_q && !(advance && edge_q.column);
  assign done = fan ? edge_q.before_end : left_on && right_on && !here;
  assign go = active_q && room &&
              (at_end_q || edge_q.before_end || edge_q.only_end || next_valid_q);
  assign pop = go && (advance || (done && strip_q.last && edge_q.only_end && !at_end_q));

  // ---- the next strip begins in the clock in which this one ends
  logic free, begin_row, begin_column;
  assign free = !active_q || (go && done);
  assign start = free && coming_valid && (coming.point || (pop ? next_valid_q : edge_valid_q));
  assign begin_row = !coming.point && (pop ? next_q.first_row : edge_q.first_row);
  assign begin_column = !coming.point && (pop ? next_q.first_column : edge_q.first_column);

  // Differences after a strip that ends without an advance that climbs, and with one: from P_k to that after the coming strip.
  logic climb, take_edge, take_grid;
  order_t dl_order, dr_order, base_order, left_right_order;
  logic [1:0] begin_dl_0, begin_dl_1, begin_dr_0, begin_dr_1;
  rows_t [1:0] begin_dl, begin_dr;
  logic signed [2:0] rows_to, rows_over;
  assign climb = advance && edge_q.row;
  assign take_edge = go_left && edge_here;
  assign take_grid = go_left && !edge_here;
  assign dl_order = order(dl_q);
  assign dr_order = order(dr_q);
  assign base_order = order(base_q);
  assign left_right_order = order(left_right_q);
  assign rows_to = 3'(strip_q.rows);
  assign rows_over = 3'(strip_q.rows) + 3'(coming.rows);
  always_comb begin
    for (int c = 0; c < 2; c++) begin
      automatic logic signed [3:0] by_dl, by_dr;
      by_dl = 4'(c) - 4'(rows_to);
      by_dr = 4'(c) - 4'(rows_over);
      begin_dl[c] = base_q + rows_t'(by_dl);
      begin_dr[c] = base_q + rows_t'(by_dr);
      begin_dl_0[c] = base_order[3'(4'sd3+4'(rows_to)-4'(c))];
      begin_dl_1[c] = base_order[3'(4'sd4+4'(rows_to)-4'(c))];
      begin_dr_0[c] = base_order[3'(4'sd3+4'(rows_over)-4'(c))];
      begin_dr_1[c] = base_order[3'(4'sd4+4'(rows_over)-4'(c))];
    end
  end

  always_ff @(posedge clk_i) begin
    if (start) begin
      strip_q <= coming;
      first_q <= 1'b1;
      left_on_q <= coming.from_corner;
      right_on_q <= coming.pointed;
      here_q <= coming.from_corner ? !begin_column && !coming.point : 1'b1;
      at_end_q <= coming.point;
      left_right_q <= -rows_t'(coming.rows);
      below_q <= coming.rows == 2'sd1;
      above_q <= coming.rows == -2'sd1;
      if (coming.from_corner) begin
        dl_q <= rows_t'(begin_row);
        base_q <= rows_t'(begin_row);
        dr_q <= rows_t'(begin_row) - rows_t'(coming.rows);
        dl_0_q <= !begin_row;
        dl_1_q <= 1'b1;
        dr_0_q <= begin_row ? coming.rows == 2'sd1 : coming.rows != -2'sd1;
        dr_1_q <= !(begin_row && coming.rows == -2'sd1);
      end else begin
        dl_q <= begin_dl[go&&climb];
        base_q <= begin_dl[go&&climb];
        dr_q <= begin_dr[go&&climb];
        dl_0_q <= begin_dl_0[go&&climb];
        dl_1_q <= begin_dl_1[go&&climb];
        dr_0_q <= begin_dr_0[go&&climb];
        dr_1_q <= begin_dr_1[go&&climb];
      end
    end else if (go) begin
      first_q <= 1'b0;
      left_on_q <= left_on;
      right_on_q <= right_on;
      here_q <= here;
      if (advance && edge_q.before_end) at_end_q <= 1'b1;
      if (climb) base_q <= base_q + 18'sd1;
      // E is taken and the next one stands there; the left goes up; E moves on.
      if (take_edge) begin
        dl_q <= rows_t'(edge_q.row);
        {dl_1_q, dl_0_q} <= {1'b1, !edge_q.row};
      end else if (take_grid) begin
        dl_q <= dl_q - 18'sd1;
        {dl_1_q, dl_0_q} <= dl_order[5:4];
      end else if (climb) begin
        dl_q <= dl_q + 18'sd1;
        {dl_1_q, dl_0_q} <= dl_order[3:2];
      end
      unique case ({climb, go_right})
        2'b10: begin
          dr_q <= dr_q + 18'sd1;
          {dr_1_q, dr_0_q} <= dr_order[3:2];
        end
        2'b01: begin
          dr_q <= dr_q - 18'sd1;
          {dr_1_q, dr_0_q} <= dr_order[5:4];
        end
        default: ;
      endcase
      unique case ({take_edge, take_grid, go_right})
        3'b100: begin
          left_right_q <= dr_q;
          {above_q, below_q} <= {!dr_order[3], dr_order[2]};
        end
        3'b101: begin
          left_right_q <= dr_q - 18'sd1;
          {above_q, below_q} <= {!dr_order[4], dr_order[3]};
        end
        3'b010: begin
          left_right_q <= left_right_q + 18'sd1;
          {above_q, below_q} <= {!left_right_order[2], left_right_order[1]};
        end
        3'b001: begin
          left_right_q <= left_right_q - 18'sd1;
          {above_q, below_q} <= {!left_right_order[4], left_right_order[3]};
        end
        default: ;
      endcase
    end
    if (!rst_ni) active_q <= 1'b0;
    else active_q <= start || !free;
  end

  // ---- the vertical edge at the end
  steps_t upright_left_q, upright_i_q;
  always_ff @(posedge clk_i) begin
    if (start) begin
      upright_left_q <= coming.upright_n;
      upright_last_q <= coming.upright_n == 16'd1;
      upright_i_q <= coming.upright_rising ? 16'd1 : coming.upright_n - 16'd1;
    end else if (go && go_right) begin
      upright_left_q <= upright_left_q - 16'd1;
      upright_last_q <= upright_left_q == 16'd2;
      upright_i_q <= strip_q.upright_rising ? upright_i_q + 16'd1 : upright_i_q - 16'd1;
    end
  end

  // ---- what was decided, and the names that it is about
  decided_t decided_q;
  logic step_valid_q;
  always_ff @(posedge clk_i) begin
    step_valid_q <= rst_ni && go;
    decided_q <= '{
        first: first_q,
        done: done,
        last: strip_q.last,
        fan: fan,
        double_: double_,
        go_left: go_left,
        go_right: go_right,
        edge_here: edge_here,
        edge_there: edge_there,
        advance: advance,
        at_end: at_end_q,
        edge_: edge_q,
        next: next_q.name,
        upright_last: upright_last_q,
        upright_i: upright_i_q
    };
  end
  walk_output i_output (
    .clk_i,
    .rst_ni,
    .strip_valid_i(strip_valid_i && control_ready),
    .strip_ready_o(names_ready),
    .strip_i,
    .go_i(go),
    .room_o(room),
    .in_valid_i(step_valid_q),
    .in_i(decided_q),
    .out_valid_o,
    .out_ready_i,
    .out_o
  );
  logic unused;
  assign unused = ^{strip_q, next_q, dl_order, dr_order, left_right_order};
endmodule

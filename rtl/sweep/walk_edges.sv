// walk_edges: the vertices of the side edges, one after the other, list after list.
//   e += 2 delta; e >= 2 n: e -= 2 n and the row, or the column, steps         as hls/sweep/walked_edge.hpp
//   in    in_valid_i, in_ready_o, in_i     a sub-triangle's frame, taken with its last list
//   out   out_valid_o, out_ready_i, out_o  its vertices but the end; where there is none before it, one that says so
//
//   A side edge climbs and goes on in s': no step is negative. All but the end stay before the last column.
//
//   latency 1, initiation interval 1, also from list to list; out_o follows registers, in_ready_o follows out_ready_i within the clock:
//   between FIFOs
module walk_edges
  import formats_pkg::*;
  import sweep_pkg::*;
  import walk_pkg::*;
(
  input  logic         clk_i,
  input  logic         rst_ni,
  input  logic         in_valid_i,
  output logic         in_ready_o,
  input  frame_t       in_i,
  output logic         out_valid_o,
  input  logic         out_ready_i,
  output edge_vertex_t out_o
);
  // The edge: 2 delta, and 2 delta - 2 n; its way and its ends.
  typedef struct packed {
    logic [16:0]        column;
    logic signed [17:0] column_back;
    logic [16:0]        row;
    logic signed [17:0] row_back;
    way_t               way;
    logic [1:0]         from;
    logic [1:0]         to;
    logic               last;
    logic               only_end;
  } edge_t;
  // The vertex: steps and columns left to the end, and what its successor's place on the edge is.
  typedef struct packed {
    logic        begins;
    logic [16:0] column_e;
    logic [16:0] row_e;
    steps_t      i;
    steps_t      left;
    logic        before_end;
    steps_t      columns;
    logic        before_last_column;
    logic        first_row;
    logic        first_column;
  } vertex_t;
  edge_t edge_q, edge_next;
  vertex_t at_q, at_next, at_first;
  logic active_q, second_q, move, finish, load, load_first;

  // ---- one step along each axis
  logic signed [18:0] column_on, column_over, row_on, row_over;
  logic column_step, row_step, column;
  assign column_on = signed'({2'b0, at_q.column_e}) + signed'({2'b0, edge_q.column});
  assign column_over = signed'({2'b0, at_q.column_e}) + 19'(edge_q.column_back);
  assign row_on = signed'({2'b0, at_q.row_e}) + signed'({2'b0, edge_q.row});
  assign row_over = signed'({2'b0, at_q.row_e}) + 19'(edge_q.row_back);
  assign column_step = !column_over[18];
  assign row_step = !row_over[18];
  assign column = edge_q.last && at_q.before_end || column_step && !at_q.before_last_column;

  assign out_valid_o = active_q;
  assign out_o = '{
      name: at_q.begins     ? '{on_edge: 1'b0, number: edge_q.from, i: '0} :
            edge_q.only_end ? '{on_edge: 1'b0, number: edge_q.to, i: '0} :
                              '{on_edge: 1'b1, number: edge_q.way.number, i: at_q.i},
      along: edge_q.way,
      begins: at_q.begins,
      last: edge_q.last,
      before_end: edge_q.last && at_q.before_end && !edge_q.only_end,
      only_end: edge_q.only_end,
      row: row_step,
      column: column,
      first_row: at_q.first_row,
      first_column: at_q.first_column
  };
  assign move = active_q && out_ready_i;
  assign finish = move && (at_q.before_end || edge_q.only_end);

  // ---- what comes next: the vertex after this one, or the next list
  assign load = in_valid_i && (finish || !active_q);
  assign load_first = in_i.has_first && !second_q;
  assign in_ready_o = (finish || !active_q) && !load_first;
  logic [16:0] first_two_n, side_two_n;
  assign first_two_n = {in_i.first_n, 1'b0};
  assign side_two_n = {in_i.side_n, 1'b0};
  always_comb begin
    at_next = at_q;
    at_next.begins = 1'b0;
    at_next.column_e = column_step ? column_over[16:0] : column_on[16:0];
    at_next.row_e = row_step ? row_over[16:0] : row_on[16:0];
    at_next.i = edge_q.way.rising ? at_q.i + 16'd1 : at_q.i - 16'd1;
    at_next.left = at_q.left - 16'd1;
    at_next.before_end = at_q.left == 16'd2;
    if (column_step) begin
      at_next.columns = at_q.columns - 16'd1;
      at_next.before_last_column = at_q.columns == 16'd2;
    end

    edge_next = '{
        column: in_i.side_column,
        column_back: signed'({1'b0, in_i.side_column}) - signed'({1'b0, side_two_n}),
        row: in_i.side_row,
        row_back: signed'({1'b0, in_i.side_row}) - signed'({1'b0, side_two_n}),
        way: in_i.side,
        from: in_i.from,
        to: in_i.to,
        last: 1'b1,
        only_end: in_i.only_end
    };
    at_first = '{
        begins: in_i.from_zero,
        column_e: in_i.column_e,
        row_e: in_i.row_e,
        i: in_i.side.rising ? 16'(!in_i.from_zero) : in_i.side_n - 16'(!in_i.from_zero),
        left: in_i.side_n - 16'(!in_i.from_zero),
        before_end: in_i.side_n == (in_i.from_zero ? 16'd1 : 16'd2),
        columns: in_i.columns,
        before_last_column: in_i.columns == 16'd1,
        first_row: in_i.first_row,
        first_column: in_i.first_column
    };
    // The vertical edge: a row a step, and no column.
    if (load_first) begin
      edge_next.column = '0;
      edge_next.column_back = -signed'({1'b0, first_two_n});
      edge_next.row = first_two_n;
      edge_next.row_back = '0;
      edge_next.way = in_i.first;
      edge_next.last = 1'b0;
      at_first.begins = 1'b0;
      at_first.row_e = {1'b0, in_i.first_n};
      at_first.column_e = {1'b0, in_i.first_n};
      at_first.i = in_i.first.rising ? 16'd1 : in_i.first_n - 16'd1;
      at_first.left = in_i.first_n - 16'd1;
      at_first.before_end = in_i.first_n == 16'd2;
    end
  end
  always_ff @(posedge clk_i) begin
    if (load) edge_q <= edge_next;
    if (load) at_q <= at_first;
    else if (move) at_q <= at_next;
    if (!rst_ni) begin
      active_q <= 1'b0;
      second_q <= 1'b0;
    end else begin
      if (load) begin
        active_q <= load_first || !in_i.point;
        second_q <= load_first;
      end else if (finish) begin
        active_q <= 1'b0;
      end
    end
  end
  logic unused_frame;
  assign unused_frame = ^{in_i, column_on[18:17], column_over[17], row_on[18:17], row_over[17]};
endmodule

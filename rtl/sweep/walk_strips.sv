// walk_strips: the strips of the sub-triangles, one after the other: P_k on the primary edge, and its grid points.
//   P_(k+1) = P_k + D_primary; the grid point goes on in s' and as the row of P_k goes, 0 or 1 up or down
//   in    in_valid_i, in_ready_o, in_i     a sub-triangle's frame; one that starts on the line s = C.s goes on where the last one ended
//   out   out_valid_o, out_ready_i, out_o
//
//   latency 3, initiation interval 1, also from one sub-triangle to the next; out_o is a register, in_ready_o follows out_ready_i within the
//   clock: between FIFOs
//   registered: the place on the primary edge, its rows, the grid points
//
//   frame --[place]-- e + 2 delta --[a: rows]-- t --[out]
module walk_strips
  import formats_pkg::*;
  import sweep_pkg::*;
  import walk_pkg::*;
(
  input  logic   clk_i,
  input  logic   rst_ni,
  input  logic   in_valid_i,
  output logic   in_ready_o,
  input  frame_t in_i,
  output logic   out_valid_o,
  input  logic   out_ready_i,
  output strip_t out_o
);
  // ---- the place on the primary edge
  frame_t frame_q;
  logic active_q, begins_q, last_q, move, finish, load;
  logic signed [18:0] row_back_q, row_fore_q, on, over, under;
  logic [16:0] e_q;
  steps_t strips_q, left_q, i_q;
  logic before_end_q;
  border_t here_q, there;
  grid_t s_q, s_next;
  logic up, down, a_free, b_free, a_valid_q;
  assign on = signed'({2'b0, e_q}) + 19'(frame_q.primary_row);
  assign over = signed'({2'b0, e_q}) + row_back_q;
  assign under = signed'({2'b0, e_q}) + row_fore_q;
  assign up = !over[18];
  assign down = on[18];
  assign there = before_end_q ? '{on_edge: 1'b0, number: frame_q.goal, i: '0}
                              : '{on_edge: 1'b1, number: frame_q.primary.number, i: i_q};
  assign s_next = frame_q.backward ? s_q - 16'sd1 : s_q + 16'sd1;
  assign move = active_q && a_free;
  assign finish = move && last_q;
  assign in_ready_o = finish || !active_q;
  assign load = in_valid_i && in_ready_o;

  // What a sub-triangle on the line takes over: the place after this clock's step.
  logic [16:0] e_next, two_n;
  assign e_next = up ? over[16:0] : down ? under[16:0] : on[16:0];
  assign two_n = {in_i.primary_n, 1'b0};
  always_ff @(posedge clk_i) begin
    if (move && !frame_q.point) begin
      e_q <= e_next;
      here_q <= there;
      s_q <= s_next;
      i_q <= frame_q.primary.rising ? i_q + 16'd1 : i_q - 16'd1;
      left_q <= left_q - 16'd1;
      before_end_q <= left_q == 16'd2;
    end
    if (move) begin
      begins_q <= 1'b0;
      strips_q <= strips_q - 16'd1;
      last_q <= strips_q == 16'd2;
    end
    if (load) begin
      frame_q <= in_i;
      begins_q <= 1'b1;
      strips_q <= in_i.width;
      last_q <= in_i.point || in_i.width == 16'd1;
      row_back_q <= 19'(in_i.primary_row) - signed'({2'b0, two_n});
      row_fore_q <= 19'(in_i.primary_row) + signed'({2'b0, two_n});
      if (in_i.from_corner) begin
        e_q <= {1'b0, in_i.primary_n};
        here_q <= '{on_edge: 1'b0, number: in_i.start, i: '0};
        s_q <= in_i.s;
        i_q <= in_i.primary.rising ? 16'd1 : in_i.primary_n - 16'd1;
        left_q <= in_i.primary_n;
        before_end_q <= in_i.primary_n == 16'd1;
      end
    end
    if (!rst_ni) active_q <= 1'b0;
    else active_q <= load || (active_q && !finish);
  end

  // ---- a: the strip without its grid points' t
  strip_t a_q;
  grid_t a_t_q;
  assign a_free = !a_valid_q || b_free;
  always_ff @(posedge clk_i) begin
    if (a_free) begin
      a_q <= '{
          point: frame_q.point,
          begins: begins_q,
          from_corner: begins_q && frame_q.from_corner,
          last: last_q,
          ends: frame_q.ends,
          pointed: frame_q.pointed && last_q,
          on_edge: frame_q.ends_on_edge && last_q,
          backward: frame_q.backward,
          mirrored: frame_q.mirrored,
          flip: frame_q.flip,
          rows: frame_q.point ? 2'sd0 : up ? 2'sd1 : down ? -2'sd1 : 2'sd0,
          primary: frame_q.primary,
          to: frame_q.to,
          left: frame_q.point ? '0 : here_q,
          right: frame_q.point ? '{on_edge: 1'b0, number: 2'd1, i: '0} : there,
          left_s: s_q,
          left_t: '0,
          right_s: s_next,
          right_t: '0,
          upright: frame_q.upright,
          upright_n: frame_q.upright_n
      };
      a_t_q <= frame_q.t;
    end
    if (!rst_ni) a_valid_q <= 1'b0;
    else if (a_free) a_valid_q <= active_q;
  end

  // ---- out: and with it; what stands above is a row higher
  grid_t t_q, t;
  logic signed [1:0] rows;
  assign b_free = !out_valid_o || out_ready_i;
  assign t = a_q.from_corner ? a_t_q : t_q;
  assign rows = a_q.mirrored ? -a_q.rows : a_q.rows;
  always_ff @(posedge clk_i) begin
    if (b_free) begin
      out_o <= a_q;
      out_o.left_t <= t + (a_q.mirrored ? -16'sd1 : 16'sd1);
      out_o.right_t <= t + (a_q.mirrored ? 16'(rows) - 16'sd1 : 16'(rows) + 16'sd1);
      if (a_valid_q && !a_q.point) t_q <= t + 16'(rows);
    end
    if (!rst_ni) out_valid_o <= 1'b0;
    else if (b_free) out_valid_o <= a_valid_q;
  end
  logic unused_frame;
  assign unused_frame = ^{in_i, frame_q, over[17], on[17], under[18:17]};
endmodule

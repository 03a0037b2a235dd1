// walk_output: what was decided becomes primitives, with the names that it is about, the strip's own among them.
//   in    strip_valid_i, strip_ready_o, strip_i   the strips, in order; one waits here until its first step comes
//         go_i, room_o                            a step is decided in this clock, and whether it may be
//         in_valid_i, in_i                        the same a clock later, and what was decided
//   out   out_valid_o, out_ready_i, out_o
//
//   latency 5 from go_i, initiation interval 1. Registered: all outputs, but for a gate behind out_o
//
//   strips --[stream_fifo]--+--[walk_names]--[stream_fifo]-- out
//   decided ----------------+
module walk_output
  import formats_pkg::*;
  import sweep_pkg::*;
  import walk_pkg::*;
(
  input  logic     clk_i,
  input  logic     rst_ni,
  input  logic     strip_valid_i,
  output logic     strip_ready_o,
  input  strip_t   strip_i,
  input  logic     go_i,
  output logic     room_o,
  input  logic     in_valid_i,
  input  decided_t in_i,
  output logic     out_valid_o,
  input  logic     out_ready_i,
  output walked_t  out_o
);
  step_t step;
  named_t named, put_out;
  strip_names_t names_in, names_head, names_q, names;
  logic names_take, unused_valid;
  logic [3:0] unused_count;
  assign names_in = '{
      begins: strip_i.begins,
      from_corner: strip_i.from_corner,
      ends: strip_i.ends,
      on_edge: strip_i.on_edge,
      backward: strip_i.backward,
      mirrored: strip_i.mirrored,
      flip: strip_i.flip,
      rows: strip_i.rows,
      primary: strip_i.primary,
      upright: strip_i.upright,
      to: strip_i.to,
      left: strip_i.left,
      right: strip_i.right,
      left_s: strip_i.left_s,
      left_t: strip_i.left_t,
      right_s: strip_i.right_s,
      right_t: strip_i.right_t
  };
  stream_fifo #(.T(strip_names_t), .Depth(8)) i_strip_names (
    .clk_i,
    .rst_ni,
    .in_valid_i(strip_valid_i),
    .in_ready_o(strip_ready_o),
    .in_i(names_in),
    .out_valid_o(unused_valid),
    .out_ready_i(names_take),
    .out_o(names_head),
    .count_o(unused_count)
  );
  always_ff @(posedge clk_i) if (names_take) names_q <= names_head;
  assign names_take = in_valid_i && in_i.first;
  assign names = in_i.first ? names_head : names_q;
  border_t to;
  assign to = '{on_edge: 1'b0, number: names.to, i: '0};
  assign step = '{
      last: in_i.done && in_i.last && names.ends,
      sub_last: in_i.done && in_i.last,
      strip_last: in_i.done,
      moves: '{
          first: in_i.first,
          begins: in_i.first && names.begins,
          from_corner: in_i.first && names.from_corner,
          rows: names.rows,
          backward: names.backward,
          mirrored: names.mirrored,
          flip: names.flip,
          primary: names.primary,
          edge_way: in_i.edge_.along,
          edge_begins: in_i.edge_.begins && !in_i.at_end,
          upright: names.upright,
          on_edge: names.on_edge,
          fan: in_i.fan,
          double_: in_i.double_,
          go_left: in_i.go_left,
          go_right: in_i.go_right,
          edge_here: in_i.edge_here,
          edge_there: in_i.edge_there,
          advance: in_i.advance
      },
      left: names_head.left,
      right: names_head.right,
      left_s: names.left_s,
      left_t: names_head.left_t,
      right_s: names.right_s,
      right_t: names_head.right_t,
      edge_: in_i.at_end ? to : in_i.edge_.name,
      next: in_i.edge_.before_end ? to : in_i.next,
      upright: in_i.upright_last
          ? to : '{on_edge: 1'b1, number: names.upright.number, i: in_i.upright_i}
  };
  walk_names i_names (.clk_i, .in_valid_i, .in_i(step), .out_o(named));
  stream_pipe #(.T(named_t), .Latency(2)) i_out (
    .clk_i,
    .rst_ni,
    .in_valid_i(go_i),
    .in_ready_o(room_o),
    .data_i(named),
    .out_valid_o,
    .out_ready_i,
    .out_o(put_out)
  );

  always_comb begin
    out_o.last = put_out.last;
    out_o.sub_last = put_out.sub_last;
    out_o.strip_last = put_out.strip_last;
    out_o.moves = put_out.moves;
    out_o.out.quad = put_out.quad;
    for (int i = 0; i < 4; i++) begin
      automatic name_t v = put_out.v[i];
      out_o.out.v[i].kind = v.kind;
      out_o.out.v[i].number = v.kind[1] ? '0 : v.y[1:0];
      out_o.out.v[i].i = v.kind[0] ? v.x : '0;
      out_o.out.v[i].s = v.kind[1] ? v.x : '0;
      out_o.out.v[i].t = v.kind[1] ? v.y : '0;
    end
  end
  logic unused;
  assign unused = ^{in_i, names, strip_i};
endmodule

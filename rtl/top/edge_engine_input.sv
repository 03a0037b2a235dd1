// edge_engine_input: the base triangles of a mesh, from the bus to the engine; what is wrong with a packet is found here.
//   in    begin_i, refuse_i  a mesh begins, for one clock; refuse_i: all of its packet is swallowed
//         close_i            nothing more is swallowed of a packet that is over
//         stop_i             ends the packet of the mesh that is running, for one clock
//         expected_i         base triangles to come, 0: until the last; limit_i: the largest coordinates; constant while a mesh runs
//         s_axis             last, a bit of the record, and tlast say the same
//   out   out_*              triangles to the engine; the last one says so
//         end_o              for one clock: the engine's input is over, with what it got until now
//         over_o             nothing more of the packet is to come;  swallowing_o  and yet it is waited for, for the bin
//         error_o            what is wrong, for one clock
//
//   latency 1 to out_o, 2 to end_o and error_o; initiation interval 2: a mesh has many more triangles than base triangles. All outputs
//   registered, or a gate from registers.
//
//   A packet is over with its tlast or with the expected count, whichever comes first. A record with a wrong coordinate, tlast before the
//   count, or a stop leaves the rest to be swallowed; the engine's input is over then. When the count is there and tlast is not, or the
//   record says last and no count tells more, the mesh may end, and what follows is swallowed until tlast or close_i.
module edge_engine_input
  import formats_pkg::*;
  import edge_pkg::*;
  import edge_engine_pkg::*;
(
  input  logic              clk_i,
  input  logic              rst_ni,
  input  logic              begin_i,
  input  logic              refuse_i,
  input  logic              close_i,
  input  logic              stop_i,
  input  logic [31:0]       expected_i,
  input  coordinate_t [1:0] limit_i,

  input  logic              in_valid_i,
  output logic              in_ready_o,
  input  base_triangle_t    in_i,
  input  logic              in_last_i,
  output logic              out_valid_o,
  input  logic              out_ready_i,
  output base_triangle_t    out_o,

  output logic              end_o,
  output logic              over_o,
  output logic              swallowing_o,
  output error_code_e       error_o
);
  // Closed: no packet. Open: to the engine. Rest: swallowed, and the mesh waits for it. Beyond: swallowed after the end.
  typedef enum logic [1:0] {
    Closed,
    Open,
    Rest,
    Beyond
  } mode_e;
  mode_e mode_q, next_mode;
  logic  full_q;
  assign over_o = (mode_q == Closed || mode_q == Beyond) && !full_q;
  assign swallowing_o = mode_q == Beyond;

  // The record that came last, and what is to be known of it.
  logic           tlast_q, outside_q, stop_q, outside;
  logic           counted_q, at_end_q;  // a count is kept; this record is the last by it
  logic    [31:0] left_q;
  base_triangle_t word_q;
  always_comb begin
    outside = 1'b0;
    for (int i = 0; i < 3; i++) begin
      for (int k = 0; k < 2; k++) outside |= in_i.v[i].u[k] > limit_i[k];
    end
  end

  logic take, go, ends, stops;
  assign in_ready_o = mode_q != Closed && !full_q && !stop_q;
  assign take = in_valid_i && in_ready_o;
  assign ends = word_q.last || tlast_q || at_end_q;
  assign out_valid_o = full_q && mode_q == Open && !outside_q;
  assign go = full_q && (!out_valid_o || out_ready_i);
  assign stops = stop_q && !full_q;
  always_comb begin
    out_o = word_q;
    out_o.last = ends;
  end

  // What follows the record.
  error_code_e error;
  always_comb begin
    next_mode = mode_q;
    error = None;
    if (go && mode_q != Closed) begin
      if (tlast_q) next_mode = Closed;
      else if (at_end_q) next_mode = Beyond;
      if (mode_q == Open) begin
        if (outside_q) begin
          error = CoordinateOutsideMap;
          if (!tlast_q && !at_end_q) next_mode = Rest;
        end else if (word_q.last != tlast_q) begin
          error = LastDisagrees;
          if (word_q.last && !at_end_q) next_mode = counted_q ? Rest : Beyond;
        end else if (counted_q && word_q.last && !at_end_q) begin
          error = EarlyLast;
        end else if (at_end_q && !word_q.last) begin
          error = MissingLast;
        end
      end
    end else if (stops) begin
      if (mode_q == Open) error = Stopped;
      if (mode_q == Open || mode_q == Rest) next_mode = Beyond;
    end
    if (close_i && mode_q == Beyond) next_mode = Closed;
    if (begin_i) next_mode = refuse_i ? Rest : Open;
  end

  always_ff @(posedge clk_i) begin
    if (take) begin
      word_q <= in_i;
      tlast_q <= in_last_i;
      outside_q <= outside;
    end
    at_end_q <= counted_q && left_q == 32'd1;
    if (begin_i) begin
      left_q <= expected_i;
      counted_q <= expected_i != '0;
      at_end_q <= expected_i == 32'd1;
    end else if (go) begin
      left_q <= left_q - 32'd1;
    end
    if (!rst_ni) begin
      mode_q <= Closed;
      full_q <= 1'b0;
      stop_q <= 1'b0;
      end_o <= 1'b0;
      error_o <= None;
    end else begin
      mode_q <= next_mode;
      full_q <= take || (full_q && !go);
      stop_q <= stop_i || (stop_q && !stops);
      // A packet that is refused ends the engine's input at once.
      end_o <= begin_i ? refuse_i : mode_q == Open && ((go && outside_q) || stops);
      error_o <= error;
    end
  end
endmodule

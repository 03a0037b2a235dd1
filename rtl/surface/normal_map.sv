// normal_map: builds the map of normals from a stream of texels, for one scale of the displacement.
//   n = normalize(-dD/du s, -dD/dv s, 1)                    contract: hls/surface/normal_map.hpp
//   in    in_i    texels row by row from v = 0, x fastest
//         map_i, regs_i  may change while busy_o is low
//   out   out_o   a normal and where it goes, row by row; when v wraps rows H-1 and 0 come last
//         busy_o  part of a map or one of its normals is inside
//
//   latency 32, initiation interval 1: a map takes width * (height + flush rows) clocks and
//   the latency; in_ready_o is low in the flush rows (2 where v wraps and the map has more than one
//   row, else 1). All outputs come from registers with a few gates; no path from out_ready_i to
//   in_ready_o.
//
//   D --+-> even, odd line --+
//       +-> row 0, row 1 ----+--> window --> differences --x s--[s1_direction]--normalize--> FIFO
//       +--------------------+
//
//   Row y-1 lies complete in one of the two lines; the other holds row y-2 from here on and row y up
//   to here. The lines are read first; the window follows two clocks later.
module normal_map
  import formats_pkg::*;
  import core_pkg::*;
  import surface_pkg::*;
#(
  parameter int unsigned MaxWidth = 8192
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  map_regs_t        map_i,
  input  normal_map_regs_t regs_i,
  output logic             busy_o,
  input  logic             in_valid_i,
  output logic             in_ready_o,
  input  texel_t           in_i,
  output logic             out_valid_o,
  input  logic             out_ready_i,
  output normal_map_out_t  out_o
);
  localparam int unsigned NormalizeLatency = 21;
  localparam int unsigned Latency = 8 + NormalizeLatency;
  localparam int unsigned Depth = Latency + 5;
  localparam int unsigned InsideBits = $clog2(Depth + 1);
  localparam int unsigned ColumnBits = $clog2(MaxWidth);

  // The step: a texel of the map while it is read, then the last row, then row 0 when v wraps.
  typedef enum logic [1:0] {
    Reading,
    LastRow,
    RowZero
  } phase_e;
  phase_e    phase_q, next_phase;
  map_size_t x_q, y_q;
  logic      row_is_0_q, row_is_1_q, started_q;
  logic      yields, pipe_ready, step, leave, first_column, last_column, last_step;
  assign first_column = x_q == '0;
  assign last_column = x_q + 14'd1 == map_i.width;
  assign yields = phase_q != Reading || !(row_is_0_q || (row_is_1_q && map_i.wrap_v));
  assign in_ready_o = phase_q == Reading && (pipe_ready || !yields);
  assign step = phase_q == Reading ? in_valid_i && in_ready_o : pipe_ready;
  assign leave = out_valid_o && out_ready_i;
  assign last_step = last_column && phase_q != Reading && next_phase == Reading;
  always_comb begin
    next_phase = Reading;
    unique case (phase_q)
      Reading: if (y_q + 14'd1 == map_i.height) next_phase = LastRow;
      LastRow: if (map_i.wrap_v && map_i.height != 14'd1) next_phase = RowZero;
      default: ;
    endcase
  end

  logic [InsideBits-1:0] inside_q;
  assign busy_o = started_q || inside_q != '0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      phase_q <= Reading;
      x_q <= '0;
      y_q <= '0;
      row_is_0_q <= 1'b1;
      row_is_1_q <= 1'b0;
      started_q <= 1'b0;
      inside_q <= '0;
    end else begin
      inside_q <= inside_q + InsideBits'(step && yields) - InsideBits'(leave);
      if (step) begin
        started_q <= !last_step;
        x_q <= last_column ? '0 : x_q + 14'd1;
        if (last_column) begin
          phase_q <= next_phase;
          y_q <= last_step ? '0 : y_q + 14'd1;
          row_is_0_q <= last_step;
          row_is_1_q <= row_is_0_q;
        end
      end
    end
  end

  // s0, s1: beside the reads of the lines. Texels are written a clock after the line's read at the
  // same place, and no sooner read than two clocks later.
  typedef struct packed {
    logic      step;
    phase_e    phase;
    logic      first_column, last_column, before_last;
    logic      row_is_0, row_is_1;
    map_size_t x, y;
    texel_t    texel;
  } place_t;
  place_t                place, s0_q, s1_q;
  logic [ColumnBits-1:0] column, next, s0_column;
  assign place = '{
    step: step, phase: phase_q, first_column: first_column, last_column: last_column,
    before_last: x_q + 14'd2 == map_i.width, row_is_0: row_is_0_q, row_is_1: row_is_1_q,
    x: x_q, y: y_q, texel: in_i
  };
  assign column = x_q[ColumnBits-1:0];
  assign next = column + ColumnBits'(1);
  assign s0_column = s0_q.x[ColumnBits-1:0];
  always_ff @(posedge clk_i) begin
    s0_q <= place;
    s1_q <= s0_q;
    if (!rst_ni) begin
      s0_q.step <= 1'b0;
      s1_q.step <= 1'b0;
    end
  end

  logic   even_is_older, s0_write;
  texel_t from_even, from_odd, from_zero, from_one;
  assign even_is_older = !y_q[0];
  assign s0_write = s0_q.step && s0_q.phase == Reading;
  line_memory #(.T(texel_t), .MaxWidth(MaxWidth)) i_even (
    .clk_i, .write_i(s0_write && !s0_q.y[0]), .write_x_i(s0_column), .data_i(s0_q.texel),
    .read_x_i(even_is_older ? column : next), .data_o(from_even)
  );
  line_memory #(.T(texel_t), .MaxWidth(MaxWidth)) i_odd (
    .clk_i, .write_i(s0_write && s0_q.y[0]), .write_x_i(s0_column), .data_i(s0_q.texel),
    .read_x_i(even_is_older ? next : column), .data_o(from_odd)
  );
  line_memory #(.T(texel_t), .MaxWidth(MaxWidth)) i_zero (
    .clk_i, .write_i(s0_write && s0_q.row_is_0), .write_x_i(s0_column), .data_i(s0_q.texel),
    .read_x_i(phase_q == RowZero ? next : column), .data_o(from_zero)
  );
  line_memory #(.T(texel_t), .MaxWidth(MaxWidth)) i_one (
    .clk_i, .write_i(s0_write && s0_q.row_is_1), .write_x_i(s0_column), .data_i(s0_q.texel),
    .read_x_i(column), .data_o(from_one)
  );

  // s2: the window, and the ends of each row, which are needed at once when the next row begins.
  // The column before the last takes its neighbour from them too: a line of two would be read too
  // soon after it was written.
  typedef struct packed {
    texel_t first, last;
  } ends_t;
  ends_t  newer_ends_q, zero_ends_q, ends, whole_ends;
  texel_t reading_first_q;
  texel_t s2_west_q, s2_here_q, s2_east_q, s2_south_q, s2_north_q, here, west, east, below, above;
  logic   one_sided_u_q, one_sided_v_q, row_is_first, row_is_last, single;
  always_comb begin
    ends = s1_q.phase == RowZero ? zero_ends_q : newer_ends_q;
    here = s1_q.first_column ? ends.first : s2_east_q;
    west = s2_here_q;
    if (s1_q.first_column) west = map_i.wrap_u ? ends.last : ends.first;
    if (s1_q.last_column) east = map_i.wrap_u ? ends.first : here;
    else if (s1_q.before_last) east = ends.last;
    else if (s1_q.phase == RowZero) east = from_zero;
    else east = s1_q.y[0] ? from_even : from_odd;

    below = s1_q.y[0] ? from_odd : from_even;
    unique case (s1_q.phase)
      LastRow: above = from_zero;
      RowZero: above = from_one;
      default: above = s1_q.texel;
    endcase
    // Row y-1 comes out; a single row comes out as the last, with y = 1 too.
    single = map_i.height == 14'd1;
    row_is_first = s1_q.row_is_1;
    row_is_last = s1_q.phase == LastRow && !map_i.wrap_v;

    whole_ends = '{
      first: s1_q.first_column ? s1_q.texel : reading_first_q,
      last: s1_q.texel
    };
  end
  always_ff @(posedge clk_i) begin
    if (s1_q.step) begin
      s2_west_q <= west;
      s2_here_q <= here;
      s2_east_q <= east;
      s2_south_q <= row_is_first ? here : below;
      s2_north_q <= row_is_last || single ? here : above;
      if (s1_q.phase == Reading) begin
        reading_first_q <= whole_ends.first;
        if (s1_q.last_column) newer_ends_q <= whole_ends;
        if (s1_q.last_column && s1_q.row_is_0) zero_ends_q <= whole_ends;
      end
    end
    one_sided_u_q <= !map_i.wrap_u && (s1_q.first_column || s1_q.last_column);
    one_sided_v_q <= row_is_first || row_is_last;
  end

  // s3: the differences, negative ones of the slopes; twice where they are one-sided.
  typedef logic signed [17:0] delta_t;
  function automatic delta_t delta(texel_t ahead, texel_t behind, logic one_sided);
    logic signed [16:0] d;
    d = signed'({1'b0, behind}) - signed'({1'b0, ahead});
    return one_sided ? {d, 1'b0} : 18'(d);
  endfunction
  delta_t s3_minus_delta_q [2];
  always_ff @(posedge clk_i) begin
    s3_minus_delta_q[0] <= delta(s2_east_q, s2_west_q, one_sided_u_q);
    s3_minus_delta_q[1] <= delta(s2_north_q, s2_south_q, one_sided_v_q);
  end

  // s1_direction: the product has 22 fractional bits, the direction 14.
  normalize_in_t s1_direction;
  logic [1:0]    s1_clipped;
  logic [16:0]   third_q, third_twice;
  gradient_t     gradient [2];
  assign gradient[0] = regs_i.gradient_u;
  assign gradient[1] = regs_i.gradient_v;
  for (genvar i = 0; i < 2; i++) begin : gen_axis
    logic signed [41:0] product;
    multiply #(.A(24), .B(18)) i_product (
      .clk_i, .a_i(gradient[i]), .b_i(s3_minus_delta_q[i]), .y_o(product)
    );
    round_to #(.In(42), .Shift(8), .Out(18)) i_direction (
      .clk_i, .x_i(product), .y_o(s1_direction.v[i]), .clipped_o(s1_clipped[i])
    );
  end
  // 2^-normal_shift, rounded like every register.
  assign third_twice = (17'd32768 >> regs_i.normal_shift) + 17'd1;
  always_ff @(posedge clk_i) third_q <= third_twice >> 1;
  assign s1_direction.v[2] = {1'b0, third_q};
  assign s1_direction.tangent = 1'b0;

  // s2_unit, and the place beside all of it.
  typedef struct packed {
    map_size_t y, x;
  } address_t;
  normalize_out_t s2_unit;
  address_t       address;
  assign address.x = s1_q.x;
  assign address.y = s1_q.phase == RowZero ? '0 : s1_q.y - 14'd1;
  normalize i_normalize (.clk_i, .in_i(s1_direction), .out_o(s2_unit));
  normal_map_out_t data;
  logic            saturated;
  address_t        address_later;
  delay #(.T(address_t), .Stages(Latency - 2)) i_address (
    .clk_i, .x_i(address), .y_o(address_later)
  );
  delay #(.Stages(NormalizeLatency)) i_saturated (
    .clk_i, .x_i(|s1_clipped), .y_o(saturated)
  );
  assign data = '{
    x: address_later.x, y: address_later.y, n: s2_unit.n, saturated: saturated, zero: s2_unit.zero
  };
  stream_pipe #(.T(normal_map_out_t), .Latency(Latency), .Depth(Depth)) i_pipe (
    .clk_i,
    .rst_ni,
    .in_valid_i(yields && (phase_q != Reading || in_valid_i)),
    .in_ready_o(pipe_ready),
    .data_i(data),
    .out_valid_o,
    .out_ready_i,
    .out_o
  );
endmodule

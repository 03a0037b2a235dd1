// normalize: v / |v|, every component correctly rounded.
//   n_i = v_i / |v|                   contract: hls/core/normalize.hpp, equal words from another method
//
//   latency 21, initiation interval 1; a pure pipeline: never stalls, no reset on data; registered: every stage and the output
//   16 multipliers: 3 squares, 1 for the reciprocal root, 4 a component; a table of 512 words of 36 bits
//
//   v --x v--[square]--+--[m = square 4^j]--(table)--[r]--+
//     --|v|--[a]-------+--[a 2^j]-------------------------x--[q]--[k]--x square--[difference]--[q or q + 1]-- n
//
//   For x = a 2^14 / |v|, the exact magnitude in LSB, the table gives q = floor(x') with 0 < x - x' < 1/4, so that the rounded
//   one is q or q + 1: on which side of t/2, t = 2q + 1, x lies is the sign of t^2 |v|^2 - 2^30 a^2. No x is at t/2 exactly
//   (tests/core/normalize.cpp proves it). The difference is below 2^52, so it is computed modulo 2^53; and t^2 = 8k + 1 with
//   k = q (q + 1) / 2.
module normalize
  import formats_pkg::*;
  import core_pkg::*;
(
  input  logic           clk_i,
  input  normalize_in_t  in_i,
  output normalize_out_t out_o
);
  // s0: |v|^2, at most 3 2^34, and the magnitudes.
  logic signed [35:0] v_square_q[3];
  logic        [35:0] s0_square_q;
  logic        [17:0] s0_a[3];
  for (genvar i = 0; i < 3; i++) begin : gen_square
    direction_t  v;
    logic [17:0] a_q;
    assign v = in_i.v[i];
    always_ff @(posedge clk_i) begin
      v_square_q[i] <= v * v;
      a_q <= v[17] ? -v : v;
    end
    delay #(.T(logic [17:0]), .Stages(1)) i_a (.clk_i, .x_i(a_q), .y_o(s0_a[i]));
  end
  always_ff @(posedge clk_i) s0_square_q <= v_square_q[0] + v_square_q[1] + v_square_q[2];

  // s1: m = |v|^2 4^j in [2^34, 2^36), and a 2^j below 2^18; steps of 16, 8, 4, 2, 1. A zero vector takes any way through.
  logic [35:0] m_q[6];
  logic [17:0] a_q[6][3];
  assign m_q[0] = s0_square_q;
  assign a_q[0] = s0_a;
  for (genvar l = 0; l < 5; l++) begin : gen_shift
    localparam int unsigned Step = 16 >> l;
    logic less;
    assign less = m_q[l][35-:2*Step] == '0;
    always_ff @(posedge clk_i) begin
      m_q[l+1] <= less ? m_q[l] << (2 * Step) : m_q[l];
      for (int i = 0; i < 3; i++) a_q[l+1][i] <= less ? a_q[l][i] << Step : a_q[l][i];
    end
  end
  logic unused_m;
  assign unused_m = ^m_q[5][9:0];

  // s2: r = 2^35 / sqrt(m) from below, 17 or 18 bits: the chord over a 128th to a 512th of m, less what it lies above the root.
  typedef struct packed {
    logic [21:0] base;   // 4 fractional bits
    logic [13:0] slope;
  } entry_t;
  function automatic logic [63:0] integer_root(logic [63:0] x);
    logic [63:0] root, trial;
    root = '0;
    for (int b = 31; b >= 0; b--) begin
      trial = root | (64'd1 << b);
      if (trial * trial <= x) root = trial;
    end
    return root;
  endfunction
  typedef entry_t root_table_t[512];
  function automatic root_table_t make_root_table();
    root_table_t t;
    for (int i = 0; i < 512; i++) t[i] = '0;
    for (longint i = 128; i < 512; i++) begin
      logic [63:0] root, next;
      root = integer_root((64'd1 << 51) / i);
      next = integer_root((64'd1 << 51) / (i + 1));
      t[int'(i)].base = 22'(root - 3 * root / (32 * i * i) - 3);
      t[int'(i)].slope = 14'(root - next);
    end
    return t;
  endfunction
  entry_t root_table[512] = make_root_table();
  // A memory is slow to read: its word waits a clock before the multiplier.
  entry_t             read_q, entry_q;
  logic        [16:0] read_place_q, place_q;
  logic signed [32:0] descent;
  logic        [21:0] base;
  logic        [17:0] r_q;
  logic        [21:0] r_fine;
  always_ff @(posedge clk_i) begin
    read_q <= root_table[m_q[5][35:27]];
    read_place_q <= m_q[5][26:10];
    entry_q <= read_q;
    place_q <= read_place_q;
  end
  multiply #(.A(15), .B(18)) i_descent (
    .clk_i, .a_i(signed'({1'b0, entry_q.slope})), .b_i(signed'({1'b0, place_q})), .y_o(descent)
  );
  delay #(.T(logic [21:0]), .Stages(2)) i_base (.clk_i, .x_i(entry_q.base), .y_o(base));
  assign r_fine = base - 22'(descent[30:17]);
  always_ff @(posedge clk_i) r_q <= r_fine[21:4];
  logic unused_r;
  assign unused_r = ^{r_fine[3:0], descent[32:31], descent[16:0]};

  // What the components share: |v|^2 for s4, and whether it is 0.
  logic [35:0] square, square_later_q;
  logic        zero_q;
  typedef struct packed {
    logic zero;
    logic tangent;
  } fallback_t;
  fallback_t fallback;
  delay #(.T(logic [35:0]), .Stages(13)) i_square (.clk_i, .x_i(s0_square_q), .y_o(square));
  always_ff @(posedge clk_i) begin
    zero_q <= s0_square_q == '0;
    square_later_q <= square;
  end
  delay #(.T(logic), .Stages(17)) i_zero (.clk_i, .x_i(zero_q), .y_o(fallback.zero));
  delay #(.T(logic), .Stages(20)) i_tangent (.clk_i, .x_i(in_i.tangent), .y_o(fallback.tangent));

  for (genvar i = 0; i < 3; i++) begin : gen_component
    // s3: the candidate q, 14 bits: x' stays below 2^14.
    logic [17:0] a;
    logic [35:0] product_q;
    logic [13:0] q_q;
    logic [14:0] next_q;
    logic [28:0] twice_k_q;
    delay #(.T(logic [17:0]), .Stages(5)) i_a (.clk_i, .x_i(a_q[5][i]), .y_o(a));
    always_ff @(posedge clk_i) begin
      product_q <= a * r_q;
      q_q <= product_q[34:21];
      next_q <= 15'(product_q[34:21]) + 15'd1;
      twice_k_q <= q_q * next_q;
    end
    logic unused_product;
    assign unused_product = ^{product_q[35], product_q[20:0], twice_k_q[0], twice_k_q[28]};

    // s4: the difference 8 k |v|^2 + |v|^2 - 2^30 a^2 modulo 2^53. Of k |v|^2 the 18 low bits of k take multipliers, the 9 high
    // ones, of whose product only 32 bits count, rows.
    logic [26:0] k;
    logic [22:0] a_square;
    logic [35:0] low_q, middle_q;
    logic [31:0] high;
    logic [49:0] s4_sum_q;
    logic [52:0] s4_rest_q, s4_partial_q, s4_later_q;
    logic [31:0] s4_difference_q;
    assign k = twice_k_q[27:1];
    delay #(.T(logic [22:0]), .Stages(15)) i_a_square (
      .clk_i, .x_i(v_square_q[i][22:0]), .y_o(a_square)
    );
    multiply_rows #(.A(9), .B(32), .Y(32)) i_high (
      .clk_i, .a_i(k[26:18]), .b_i(square[31:0]), .y_o(high)
    );
    always_ff @(posedge clk_i) begin
      low_q <= k[17:0] * square[17:0];
      middle_q <= k[17:0] * square[35:18];
      s4_sum_q <= 50'(low_q) + {middle_q[31:0], 18'b0};
      s4_rest_q <= 53'(square_later_q) - {a_square, 30'b0};
      s4_partial_q <= {s4_sum_q, 3'b0} + s4_rest_q;
      s4_later_q <= s4_partial_q;
      s4_difference_q <= s4_later_q[52:21] + high;
    end
    logic unused_s4;
    assign unused_s4 = ^{middle_q[35:32], s4_later_q[20:0], s4_difference_q[30:0]};

    // s5: q + 1 where the difference is negative, then the sign: -q is ~q + 1, -(q + 1) is ~q.
    logic        negative, up, increment;
    logic [13:0] q;
    unit_t       n_q;
    delay #(.T(logic), .Stages(20)) i_negative (
      .clk_i, .x_i(in_i.v[i][17]), .y_o(negative)
    );
    delay #(.T(logic [13:0]), .Stages(6)) i_q (.clk_i, .x_i(q_q), .y_o(q));
    assign up = s4_difference_q[31];
    assign increment = up ^ negative;
    localparam int unsigned Fallback = i == 0 ? 1 : i == 2 ? 0 : 2;  // for a tangent, else, never
    always_ff @(posedge clk_i) begin
      n_q <= signed'({2'b0, q} ^ {16{negative}}) + signed'(16'(increment));
      if (fallback.zero) n_q <= 32'(fallback.tangent) == Fallback ? 16'sd1 <<< UnitFraction : '0;
    end
    assign out_o.n[i] = n_q;
  end
  logic was_zero_q;
  always_ff @(posedge clk_i) was_zero_q <= fallback.zero;
  assign out_o.zero = was_zero_q;
endmodule

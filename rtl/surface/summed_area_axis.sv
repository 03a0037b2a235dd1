// summed_area_axis: one axis of a rectangle: which words of the table lie at its bounds, and how many turns of the map are between them.
//   contract: the part of hls/surface/summed_area_lookup.hpp that is done for each axis
//   in    low_i, high_i      bounds, [low, high); at most 8 turns before the map and 7 behind it where the axis wraps
//         size_i, last_i     texels of the axis, and one less;  wrap_i
//   out   word_low_o         column of the stored word that holds SAT(low, .), of use where read_low_o: SAT(0, .) is 0
//         word_high_o        and of SAT(high, .), which is always read
//         turns_o            borders of the map between low and high, times which SAT(W, .) is to be added: 0..15
//         full_o, kept_o     high - low, and what of it lies on the map;  clipped_o  they differ on a clamped axis
//
//   latency 7, the last line of outputs 3; initiation interval 1; a pure pipeline: never stalls, no reset on data. Registered: outputs
//   and every stage
//
//   bounds --[s0 beyond?]--[s1 clip, or + 8 W]--[- 8 W?]--[- 4 W?]--[- 2 W?]--[- W?]--[s6 words, turns]
//                               +--[s2 extents]
//
//   SAT(x + W, y) = SAT(x, y) + SAT(W, y) holds at x = 0 too, so a bound on the border may count as either side of it, and the two
//   bounds are brought to where they are of use: low into [0, W), high into (0, W]. A rectangle that ends at the border or begins there has
//   no turns then. High is kept one less, which is the column of its word. The words that the sums are made of need not be the kernel's
//   therefore; the sums are, modulo 2^40.
module summed_area_axis
  import formats_pkg::*;
(
  input  logic        clk_i,
  input  map_size_t   size_i,
  input  map_size_t   last_i,
  input  logic        wrap_i,
  input  bound_t      low_i,
  input  bound_t      high_i,
  output map_size_t   word_low_o,
  output logic        read_low_o,
  output map_size_t   word_high_o,
  output logic [3:0]  turns_o,
  output logic [15:0] full_o,
  output logic [15:0] kept_o,
  output logic        clipped_o
);
  localparam int unsigned Steps = 4;

  // s0: beyond a clamped border
  bound_t s0_low_q, s0_high_q;
  logic   s0_below_q, s0_above_q;
  always_ff @(posedge clk_i) begin
    s0_low_q   <= low_i;
    s0_high_q  <= high_i;
    s0_below_q <= !wrap_i && low_i < 0;
    s0_above_q <= !wrap_i && high_i > bound_t'({2'b0, size_i});
  end

  // s1: a clamped bound is cut to the map, and the steps leave it alone; a wrapped one moves by 8 turns and is positive then.
  localparam int unsigned Bits = 17;
  bound_t s1_low, s1_high;
  bound_t s1_low_q, s1_high_q;
  logic   s1_clipped_q;
  logic [15:0] s1_full_q;
  logic [Bits-1:0] low_q[Steps+1], high_q[Steps+1];
  logic [Steps-1:0] turns_low_q[Steps+1], turns_high_q[Steps+1];
  assign s1_low  = s0_below_q ? '0 : s0_low_q;
  assign s1_high = s0_above_q ? bound_t'({2'b0, size_i}) : s0_high_q;
  always_ff @(posedge clk_i) begin
    s1_low_q     <= s1_low;
    s1_high_q    <= s1_high;
    s1_clipped_q <= s0_below_q || s0_above_q;
    s1_full_q    <= s0_high_q - s0_low_q;
    low_q[Steps] <= Bits'(s1_low) + (wrap_i ? {size_i, 3'b000} : '0);
    // 8 W - 1 is {last, 111}; - 1 is all ones.
    high_q[Steps] <= Bits'(s1_high) + (wrap_i ? {last_i, 3'b111} : '1);
  end
  assign turns_low_q[Steps]  = '0;
  assign turns_high_q[Steps] = '0;

  // s2: extents
  always_ff @(posedge clk_i) begin
    full_o    <= s1_full_q;
    kept_o  <= s1_high_q - s1_low_q;
    clipped_o <= s1_clipped_q;
  end

  // s2 to s5: what is left after the step of 2^i turns is below W 2^i <= 2^(13+i).
  for (genvar i = Steps - 1; i >= 0; i--) begin : gen_step
    logic [Bits:0] low, high;
    assign low  = {1'b0, low_q[i+1]} - ((Bits + 1)'(size_i) << i);
    assign high = {1'b0, high_q[i+1]} - ((Bits + 1)'(size_i) << i);
    always_ff @(posedge clk_i) begin
      low_q[i]  <= low[Bits] ? Bits'(low_q[i+1][12+i:0]) : Bits'(low[12+i:0]);
      high_q[i] <= high[Bits] ? Bits'(high_q[i+1][12+i:0]) : Bits'(high[12+i:0]);
      turns_low_q[i]  <= turns_low_q[i+1] | (Steps'(!low[Bits]) << i);
      turns_high_q[i] <= turns_high_q[i+1] | (Steps'(!high[Bits]) << i);
    end
    logic unused_high_bits;
    assign unused_high_bits = ^{low[Bits-1:13+i], high[Bits-1:13+i], low_q[i+1], high_q[i+1]};
  end

  // s6: words, and the turns between them
  always_ff @(posedge clk_i) begin
    word_low_o  <= low_q[0][13:0] - 14'd1;
    read_low_o  <= low_q[0] != '0;
    word_high_o <= high_q[0][13:0];
    turns_o     <= turns_high_q[0] - turns_low_q[0];
  end
  logic unused_top;
  assign unused_top = ^high_q[0][Bits-1:14];
endmodule

// profile_error: how far the samples of an edge leave its chord, and the best place among the middle third.
//   In sixteenths, with k = 16 j / n:  E_j = 16 n e_j / n = |16 (D_j - D_0) - k (D_n - D_0)|, which is (16 / n) |n D_j - (n-j) D_0 - j D_n|,
//   the contract's exact error times a power of two that is the same for all samples of an edge: the same samples are above the
//   threshold (times 16), the same is the largest.
//   gain = E_j k (16 - k), j (n - j) times another such power: E_j times 60, 63, 64, 63, 60 for k = 6 .. 10, without a multiplier
//   E (64 - 4), E (64 - 1), E 64. Of two or four intervals only the middle is in the middle third.
//   Ties: below the gain lies a rank: the middle first, then the end that precedes; no two places have the same.
//   contract: hls/edge/profile_test.hpp
//   in    valid_i with sample_i[SamplesPerClock], group_i, levels_i, forward_i, last_i (the edge's last group); order as in place_multiple
//   out   valid_o with out_o, once an edge
//
//   latency 9 + log2 SamplesPerClock from the last group, initiation interval 1 group; registered: every stage and level of the tree, valid_o
//   and the best place, a choice behind which is out_o.k
//
//   D --[s0 D_0, rise]--[s1 step; D - D_0]--[s2 x 3]--[s4 k rise]--[s5 difference]--[s6 magnitude]--[s7 key]--[tree]--[best]
module profile_error
  import formats_pkg::*;
  import edge_pkg::*;
#(
  parameter int unsigned SamplesPerClock = 1
) (
  input  logic                                     clk_i,
  input  logic                                     rst_ni,
  input  profile_test_regs_t                       regs_i,
  input  logic                                     valid_i,
  input  sample_t            [SamplesPerClock-1:0] sample_i,
  input  logic               [4:0]                 group_i,
  input  logic               [2:0]                 levels_i,
  input  logic                                     forward_i,
  input  logic                                     last_i,
  output logic                                     valid_o,
  output profile_test_out_t                        out_o
);
  localparam int unsigned TreeLevels = $clog2(SamplesPerClock);
  localparam int unsigned Stages = 8 + TreeLevels;

  typedef struct packed {
    logic       last;
    logic       forward;
    logic [2:0] levels;
    logic [4:0] group;
  } group_t;
  // The larger key is the better place.
  typedef struct packed {
    logic [29:0] gain;
    logic [2:0]  rank;
  } key_t;
  typedef struct packed {
    logic above;
    key_t key;
  } found_t;

  group_t group_q [Stages];  // after stage i
  logic [Stages-1:0] valid_q;
  always_ff @(posedge clk_i) begin
    group_q[0] <= '{last: last_i, forward: forward_i, levels: levels_i, group: group_i};
    for (int i = 1; i < Stages; i++) group_q[i] <= group_q[i-1];
    if (!rst_ni) valid_q <= '0;
    else valid_q <= Stages'({valid_q, valid_i});
  end

  // s0: the ends come with or before all other samples, and stay until those of the next edge.
  sample_t s0_first_q;
  logic signed [20:0] s0_rise_q;
  sample_t [SamplesPerClock-1:0] s0_sample_q;
  always_ff @(posedge clk_i) begin
    s0_sample_q <= sample_i;
    if (valid_i && group_i == '0) s0_first_q <= sample_i[0];
  end
  if (SamplesPerClock == 1) begin : gen_rise_one
    always_ff @(posedge clk_i) begin
      if (valid_i && group_i == 5'd1) begin
        s0_rise_q <= signed'({1'b0, sample_i[0]}) - signed'({1'b0, s0_first_q});
      end
    end
  end else begin : gen_rise
    always_ff @(posedge clk_i) begin
      if (valid_i && group_i == '0) begin
        s0_rise_q <= signed'({1'b0, sample_i[1]}) - signed'({1'b0, sample_i[0]});
      end
    end
  end

  // s1, s2: the chord's rise over one place, and three times that; below 2^24 over all places.
  logic signed [24:0] s1_step_q, s2_step_q, s2_triple_q;
  always_ff @(posedge clk_i) begin
    s1_step_q <= 25'(s0_rise_q) <<< (3'd4 - group_q[0].levels);
    s2_step_q <= s1_step_q;
    s2_triple_q <= s1_step_q + (s1_step_q <<< 1);
  end

  found_t found [1:2*SamplesPerClock-1];  // a tree: 1 is the root, the lanes are the last
  for (genvar l = 0; l < SamplesPerClock; l++) begin : gen_lane
    logic signed [20:0] s1_relative_q, s4_relative;
    logic signed [24:0] s4_chord;
    always_ff @(posedge clk_i) begin
      s1_relative_q <= signed'({1'b0, s0_sample_q[l]}) - signed'({1'b0, s0_first_q});
    end
    delay #(.T(logic [20:0]), .Stages(3)) i_relative (
      .clk_i, .x_i(s1_relative_q), .y_o(s4_relative)
    );
    place_multiple #(.Width(25), .SamplesPerClock(SamplesPerClock), .Lane(l)) i_chord (
      .clk_i,
      .x_i(s2_step_q),
      .triple_i(s2_triple_q),
      .group_i(group_q[2].group),
      .y_o(s4_chord)
    );

    logic signed [25:0] s5_difference_q;
    logic        [23:0] s6_error_q;
    logic        [25:0] negated;
    assign negated = 26'(-s5_difference_q);
    always_ff @(posedge clk_i) begin
      s5_difference_q <= 26'(signed'({s4_relative, 4'b0})) - 26'(s4_chord);
      s6_error_q <= s5_difference_q[25] ? negated[23:0] : s5_difference_q[23:0];
    end
    logic unused_sign;
    assign unused_sign = ^{negated[25:24], s5_difference_q[24]};

    // Beside s6: which place the sample has, 0..16 in sixteenths, and what it is worth.
    logic [5:0] sample;
    logic [4:0] intervals;
    logic [5:0] places;
    logic [4:0] k;
    logic s6_inner_q, s6_middle_q;
    logic [4:0] s6_k_q;
    logic s6_forward_q;
    assign sample = 6'(group_q[5].group) * 6'(SamplesPerClock) + 6'(l);
    assign intervals = 5'd1 << group_q[5].levels;
    assign places = sample - 6'd1;
    assign k = places[4:0] << (3'd4 - group_q[5].levels);
    always_ff @(posedge clk_i) begin
      s6_inner_q <= sample >= 6'd2 && sample <= 6'(intervals);
      s6_middle_q <= sample >= 6'd2 && group_q[5].levels >= 3'd3 && k >= 5'd6 && k <= 5'd10;
      s6_k_q <= k;
      s6_forward_q <= group_q[5].forward;
    end
    logic unused_place;
    assign unused_place = places[5];

    logic [25:0] s7_cut;
    logic [2:0]  s7_rank;
    always_comb begin
      unique case (s6_k_q)
        5'd8: begin
          s7_cut = '0;
          s7_rank = 3'd4;
        end
        5'd7, 5'd9: begin
          s7_cut = 26'(s6_error_q);
          s7_rank = s6_forward_q == (s6_k_q == 5'd7) ? 3'd3 : 3'd2;
        end
        default: begin
          s7_cut = {s6_error_q, 2'b0};
          s7_rank = s6_forward_q == (s6_k_q == 5'd6) ? 3'd1 : 3'd0;
        end
      endcase
    end
    always_ff @(posedge clk_i) begin
      found[SamplesPerClock+l].above <= s6_inner_q && s6_error_q > {regs_i.threshold, 4'b0};
      found[SamplesPerClock+l].key <= '0;
      if (s6_middle_q) begin
        found[SamplesPerClock+l].key <= '{gain: {s6_error_q, 6'b0} - 30'(s7_cut), rank: s7_rank};
      end
    end
  end

  function automatic found_t better(found_t a, found_t b);
    return '{above: a.above || b.above, key: a.key > b.key ? a.key : b.key};
  endfunction
  for (genvar i = 1; i < SamplesPerClock; i++) begin : gen_tree
    always_ff @(posedge clk_i) found[i] <= better(found[2*i], found[2*i+1]);
  end

  // The best of the groups so far; the first group begins anew.
  found_t best_q;
  logic done_q, forward_q, middle_q;
  group_t group;
  assign group = group_q[Stages-1];
  always_ff @(posedge clk_i) begin
    if (valid_q[Stages-1]) best_q <= group.group == '0 ? found[1] : better(found[1], best_q);
    forward_q <= group.forward;
    middle_q <= group.levels < 3'd3;
    if (!rst_ni) done_q <= 1'b0;
    else done_q <= valid_q[Stages-1] && group.last;
  end

  assign valid_o = done_q;
  assign out_o.pt = best_q.above;
  always_comb begin
    unique case (best_q.key.rank)
      3'd3: out_o.k = forward_q ? 5'd7 : 5'd9;
      3'd2: out_o.k = forward_q ? 5'd9 : 5'd7;
      3'd1: out_o.k = forward_q ? 5'd6 : 5'd10;
      3'd0: out_o.k = forward_q ? 5'd10 : 5'd6;
      default: out_o.k = 5'd8;
    endcase
    if (middle_q) out_o.k = 5'd8;
  end
endmodule

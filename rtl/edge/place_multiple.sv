// place_multiple: j x, where j is the place of a lane's sample among the intervals of a profile.
//   Lane l of group g holds sample i = g SamplesPerClock + l of: the first end, the last end, then the
//   places 1 .. n-1 in order, so that j = i - 1 for i >= 2. The first end gives 0; the last end's multiple is of no use.
//   in    x_i, triple_i  x and 3 x;  group_i  g
//   out   y_o            j x, modulo 2^Width
//
//   latency 2, initiation interval 1; registered: the two terms, and their sum; no multiplier. Where a lane has one place the terms are
//   constant multiples.
module place_multiple #(
  parameter int unsigned Width = 30,
  parameter int unsigned SamplesPerClock = 1,
  parameter int unsigned Lane = 0
) (
  input  logic                    clk_i,
  input  logic signed [Width-1:0] x_i,
  input  logic signed [Width-1:0] triple_i,
  input  logic        [4:0]       group_i,
  output logic signed [Width-1:0] y_o
);
  logic [3:0] place;
  assign place = 4'(group_i) * 4'(SamplesPerClock) + 4'(Lane) - 4'd1;

  function automatic logic signed [Width-1:0] term(
    logic [1:0] times, logic signed [Width-1:0] x, logic signed [Width-1:0] triple
  );
    unique case (times)
      2'd1: return x;
      2'd2: return x <<< 1;
      2'd3: return triple;
      default: return '0;
    endcase
  endfunction

  logic signed [Width-1:0] low_q, high_q;
  always_ff @(posedge clk_i) begin
    low_q <= term(place[1:0], x_i, triple_i);
    high_q <= term(place[3:2], x_i, triple_i);
    if (Lane == 0 && group_i == '0) begin
      low_q <= '0;
      high_q <= '0;
    end
    y_o <= low_q + (high_q <<< 2);
  end
endmodule

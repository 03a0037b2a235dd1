// transform_normal: the displaced normal into the eye's frame, and whether it points away from the eye.
//   N'_s = R N';  away = N' . (P' - E) > 0, exact          contract: hls/surface/transform_normal.hpp
//   parameter  Clocks  that a normal takes, 1 or 3: with three the rows of R, and the axes of P' - E, take turns
//   in         first_i with three clocks: a normal comes in; the next at the earliest three clocks later
//
//   latency 6, or 8 with three clocks; initiation interval Clocks; a pure pipeline: never stalls, no reset on data; registered: every stage
//   and the outputs
//   15 multipliers: nine products of 16 x 16 bits, three of 29 x 16; or 5, a third
//
//   N' ----------x R--[sum]--[n]
//   P' - E --x N'--[s0_facing]-- > 0 --[away]
module transform_normal
  import formats_pkg::*;
  import surface_pkg::*;
#(
  parameter int unsigned Clocks = 1
) (
  input  logic                   clk_i,
  input  logic                   first_i,
  input  transform_normal_regs_t regs_i,
  input  transform_normal_in_t   in_i,
  output transform_normal_out_t  out_o
);
  if (Clocks != 1 && Clocks != 3) begin : gen_bad
    $error("Clocks is 1 or 3");
  end
  localparam int unsigned Rows = Clocks == 1 ? 3 : 1;

  // N' a clock later, beside P' - E. With three clocks its axes walk down by one a clock, and the rows and the eye with them.
  unit_t     [2:0]           n_q;
  unit_t     [Rows-1:0][2:0] rotation;
  position_t [Rows-1:0]      p;
  eye_t      [Rows-1:0]      eye;
  if (Clocks == 1) begin : gen_rows
    assign rotation = regs_i.rotation;
    assign p = in_i.p;
    assign eye = regs_i.eye;
    always_ff @(posedge clk_i) n_q <= in_i.n;
    logic unused_first;
    assign unused_first = first_i;
  end else begin : gen_row_by_row
    // Row r is of use when axis r is in front: its own axes begin there.
    unit_t [2:0][2:0] walking;
    for (genvar r = 0; r < 3; r++) begin : gen_walking
      for (genvar i = 0; i < 3; i++) begin : gen_axis
        assign walking[r][i] = regs_i.rotation[r][(r+i)%3];
      end
    end
    unit_t     [2:0] row_q;
    position_t [1:0] p_q;
    logic            second_q;
    always_ff @(posedge clk_i) begin
      second_q <= first_i;
      row_q <= first_i ? walking[0] : second_q ? walking[1] : walking[2];
      n_q   <= first_i ? in_i.n : {n_q[0], n_q[2:1]};
      p_q   <= first_i ? in_i.p[2:1] : {p_q[0], p_q[1]};
    end
    assign rotation[0] = row_q;
    assign p[0] = first_i ? in_i.p[0] : p_q[0];
    assign eye[0] = first_i ? regs_i.eye[0] : second_q ? regs_i.eye[1] : regs_i.eye[2];
  end

  // 28 fractional bits to 14; the host's rotations do not clip, and nobody counts when others do.
  unit_t [2:0]      n_s;
  logic  [Rows-1:0] unused_clipped;
  for (genvar r = 0; r < Rows; r++) begin : gen_row
    logic signed [31:0] product[3];
    logic signed [32:0] sum_q;
    for (genvar i = 0; i < 3; i++) begin : gen_axis
      multiply #(.A(16), .B(16)) i_product (
        .clk_i, .a_i(rotation[r][i]), .b_i(n_q[i]), .y_o(product[i])
      );
    end
    always_ff @(posedge clk_i) sum_q <= 33'(product[0]) + 33'(product[1]) + 33'(product[2]);
    round_to #(.In(33), .Shift(14), .Out(16)) i_n (
      .clk_i, .x_i(sum_q), .y_o(n_s[3-Rows+r]), .clipped_o(unused_clipped[r])
    );
  end

  // s0: both differences have 20 fractional bits.
  logic signed [44:0] product[Rows];
  logic signed [45:0] s0_facing_q;
  for (genvar i = 0; i < Rows; i++) begin : gen_facing
    logic signed [28:0] difference_q;
    always_ff @(posedge clk_i) difference_q <= 29'(signed'(p[i])) - 29'(signed'(eye[i]));
    multiply #(.A(29), .B(16)) i_product (
      .clk_i, .a_i(difference_q), .b_i(n_q[i]), .y_o(product[i])
    );
  end
  logic positive_q, away_q;
  if (Clocks == 1) begin : gen_sum
    always_ff @(posedge clk_i) s0_facing_q <= 46'(product[0]) + 46'(product[1]) + 46'(product[2]);
  end else begin : gen_sums
    logic first_product;
    delay #(.Stages(3)) i_first (.clk_i, .x_i(first_i), .y_o(first_product));
    always_ff @(posedge clk_i) begin
      s0_facing_q <= (first_product ? '0 : s0_facing_q) + 46'(product[0]);
    end
    delay #(.T(unit_t [1:0])) i_n_s (.clk_i, .x_i(n_s[2:1]), .y_o(n_s[1:0]));
  end
  always_ff @(posedge clk_i) begin
    positive_q <= s0_facing_q > 0;
    away_q <= positive_q;
  end
  assign out_o.n = n_s;
  assign out_o.away = away_q;
endmodule

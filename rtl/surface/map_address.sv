// map_address: the 2 x 2 texels around a texture coordinate, and the weights between them.
//   clamp: x0 = min(floor u, W-1), x1 = min(x0+1, W-1);  wrap: x0 = floor u mod W, x1 = (x0+1) mod W
//   contract: hls/surface/map_address.hpp; a wrapped coordinate is at most W
//
//   latency 2, initiation interval 1; a pure pipeline: never stalls, no reset on data; registered: every stage
//
//   u --[s0_low: min or - W]--[x, y: low, low + 1 or the border]
module map_address
  import formats_pkg::*;
  import surface_pkg::*;
(
  input  logic             clk_i,
  input  map_regs_t        map_i,
  input  map_address_in_t  in_i,
  output map_address_out_t out_o
);
  map_size_t [1:0] size;
  logic      [1:0] wrap;
  assign size = {map_i.height, map_i.width};
  assign wrap = {map_i.wrap_v, map_i.wrap_u};

  map_size_t [1:0][1:0] cell_q;  // [axis][low, high]
  fraction_t [1:0] s0_fraction_q, fraction_q;

  for (genvar i = 0; i < 2; i++) begin : gen_axis
    map_size_t whole, s0_low_q, s0_last_q;
    assign whole = in_i.u[i][CoordinateFraction+:14];
    always_ff @(posedge clk_i) begin
      s0_last_q <= size[i] - 14'd1;
      s0_low_q <= whole < size[i] ? whole : wrap[i] ? whole - size[i] : size[i] - 14'd1;
      s0_fraction_q[i] <= in_i.u[i][CoordinateFraction-1:0];
    end

    // low is within the map, so that low + 1 is beyond it only from the last texel.
    always_ff @(posedge clk_i) begin
      cell_q[i][0] <= s0_low_q;
      cell_q[i][1] <= s0_low_q != s0_last_q ? s0_low_q + 14'd1 : wrap[i] ? '0 : s0_last_q;
      fraction_q[i] <= s0_fraction_q[i];
    end
  end
  assign out_o = '{f: fraction_q, y: cell_q[1], x: cell_q[0]};
endmodule

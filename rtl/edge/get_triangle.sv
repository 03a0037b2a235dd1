// get_triangle: which vertices of a triangle still have to be displaced and transformed, and which normals only transformed.
//   new_surface = not displaced, new_normal = not transformed, settled = settled or at the largest generation
//   contract: hls/edge/get_triangle.hpp
//
//   latency 1, initiation interval 1; a pure pipeline: never stalls, no reset on data; registered: the answer
module get_triangle
  import formats_pkg::*;
  import edge_pkg::*;
(
  input  logic              clk_i,
  input  generation_t       max_generation_i,
  input  triangle_t         in_i,
  output get_triangle_out_t out_o
);
  always_ff @(posedge clk_i) begin
    for (int i = 0; i < 3; i++) begin
      out_o.new_surface[i] <= !in_i.v[i].displaced;
      out_o.new_normal[i]  <= !in_i.v[i].transformed;
      out_o.settled[i]     <= in_i.settled[i] || in_i.generation[i] >= max_generation_i;
    end
  end

  // Of the wide record only flags and generations are asked.
  logic unused_rest;
  assign unused_rest = ^in_i;
endmodule

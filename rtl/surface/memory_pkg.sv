// memory_pkg: what the read ports of the map memories carry, and what is looked for in the summed-area table.
//
//   A read port asks with req_valid/req_ready, req, and is answered in order with rsp_valid, rsp, after any number of clocks. An answer
//   cannot be refused: who asks has a place for it. Requests give coordinates, not addresses, so that a memory may lay out its words
//   as it likes (banks, tiles); they are always within the map.
//   A reset ends what was asked: whoever answers is reset too, and no answer of before comes after it.
//   A port that reads several words a clock asks for them together and is answered together.
package memory_pkg;
  import formats_pkg::*;

  // The four texels at columns x[0], x[1] and rows y[0], y[1]; at a border two of them may be the same.
  typedef struct packed {
    map_size_t [1:0] y;
    map_size_t [1:0] x;
  } quad_request_t;
  // [row][column]
  typedef texel_t [1:0][1:0] texel_quad_t;
  typedef unit_t [2:0] normal_t;
  typedef normal_t [1:0][1:0] normal_quad_t;
  // Clocks from a quad to its mean: bilinear.sv.
  localparam int unsigned BilinearLatency = 10;

  // Word (x, y) of the summed-area table, SAT(x+1, y+1), where read is set; the answer to the others is not looked at.
  typedef struct packed {
    map_size_t y;
    map_size_t x;
    logic      read;
  } table_request_t;

  // What a builder of the summed-area table writes: word (x, y) of it.
  typedef struct packed {
    table_sum_t sum;
    map_size_t  y;
    map_size_t  x;
  } table_write_t;

  // Where a rectangle's corners lie in the table; pairs: [0] in u, [1] in v.
  typedef struct packed {
    logic      [7:0]      turns_uv;  // the product
    logic      [1:0][3:0] turns;     // of the map, between low and high
    logic      [1:0]      turning;   // there are any
    logic      [1:0]      read_low;
    map_size_t [1:0]      low;
    map_size_t [1:0]      high;
  } table_region_t;
  // A rectangle's texels.
  typedef struct packed {
    logic  clipped;
    area_t kept;  // of the full area, what is on the map
    area_t full;
  } table_areas_t;
endpackage

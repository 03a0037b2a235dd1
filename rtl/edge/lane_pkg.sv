// lane_pkg: what the stages of a lane hand to each other: one edge at a time, or one base vertex.
package lane_pkg;
  import formats_pkg::*;
  import surface_pkg::*;

  // What an edge needs of a vertex at its end.
  typedef struct packed {
    logic              behind;
    screen_t     [1:0] screen;
    unit_t       [2:0] displaced_n;
    coordinate_t [1:0] u;
    unit_t       [2:0] t;
    unit_t       [2:0] n;
    position_t   [2:0] p;
  } edge_end_t;

  // place: not an edge to be tested but a base vertex, end a, to be displaced and transformed.
  typedef struct packed {
    edge_end_t   b;
    edge_end_t   a;
    generation_t generation;
    logic        place;
  } lane_in_t;

  // After the tests that read no memory.
  typedef struct packed {
    logic     [4:0]    samples;
    logic              forward;
    logic              ct;
    logic              vt;
    coordinate_t [1:0] u12;
    lane_in_t          work;
  } tested_t;

  // After the tests that read the maps: where the new vertex comes to stand.
  typedef struct packed {
    weight_t  k;
    logic     pt;
    logic     sht;
    logic     ct;
    logic     vt;
    logic [4:0] samples;
    lane_in_t work;
  } weighted_t;

  // What the new vertex still needs, and what the last tests ask of the ends.
  typedef struct packed {
    logic        [1:0] zeros;
    coordinate_t [1:0] u;
    unit_t       [2:0] t;
    unit_t       [2:0] n;
    position_t   [2:0] p;
    unit_t       [2:0] n2;
    unit_t       [2:0] n1;
    logic              pt;
    logic              sht;
    logic              ct;
    logic              vt;
    logic        [4:0] samples;
    generation_t       generation;
    logic              place;
  } new_vertex_t;

  // What one edge or base vertex adds to the counters of hls/edge/counters.hpp.
  typedef struct packed {
    logic [4:0] profile_samples;
    logic       table_read;
    logic [1:0] zero_vectors;
    logic       screen_saturation;
    logic [1:0] saturations;
    logic       vertex;
    logic       ht;
    logic       pt;
    logic       sht;
    logic       nt;
    logic       ct;
    logic       vt;
    logic       edge_test;
  } lane_counts_t;

  typedef struct packed {
    lane_counts_t counts;
    logic         split;
    vertex_t      m;
  } lane_out_t;
endpackage

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

  // What waits in a lane until the new vertex is made of it.
  typedef struct packed {
    unit_t       [2:0] displaced_n;
    coordinate_t [1:0] u;
    unit_t       [2:0] t;
    unit_t       [2:0] n;
    position_t   [2:0] p;
  } base_end_t;
  typedef struct packed {
    base_end_t   b;
    base_end_t   a;
    generation_t generation;
    logic        place;
  } base_edge_t;

  // After the tests that read no memory.
  typedef struct packed {
    logic        [4:0] samples;
    logic              forward;
    logic              ct;
    logic              vt;
    logic              place;
    coordinate_t [1:0] u12;
    coordinate_t [1:0] u2;
    coordinate_t [1:0] u1;
  } tested_t;

  // After the tests that read the maps: where the new vertex comes to stand, and whether it is needed.
  typedef struct packed {
    logic       needed;
    weight_t    k;
    base_edge_t work;
  } weighted_t;

  // What the last tests ask of the edge.
  typedef struct packed {
    unit_t       [2:0] n2;
    unit_t       [2:0] n1;
    logic              pt;
    logic              sht;
    logic              ct;
    logic              vt;
    logic        [4:0] samples;
    generation_t       generation;
    logic              place;
  } judged_t;

  // The new vertex on the base surface; and what of it waits for the maps.
  typedef struct packed {
    coordinate_t [1:0] u;
    unit_t       [2:0] t;
    unit_t       [2:0] n;
    position_t   [2:0] p;
  } base_frame_t;
  typedef struct packed {
    logic               needed;
    logic         [1:0] zeros;
    base_frame_t        base;
  } new_vertex_t;
  typedef struct packed {
    logic        needed;
    logic  [1:0] zeros;
    unit_t [2:0] t;
    unit_t [2:0] n;
  } waiting_t;

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

  // All but its base.
  typedef struct packed {
    lane_counts_t    counts;
    logic            split;
    logic            away;
    unit_t     [2:0] screen_n;
    logic            behind;
    depth_t          w;
    screen_t   [1:0] screen;
    unit_t     [2:0] displaced_n;
    position_t [2:0] displaced_p;
  } seen_vertex_t;

  typedef struct packed {
    lane_counts_t counts;
    logic         split;
    vertex_t      m;
  } lane_out_t;
endpackage

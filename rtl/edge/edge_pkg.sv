// edge_pkg: records of the units of edge
// Printed by tb/cosim/print_packages.cpp from the C++ headers; not to be edited.
package edge_pkg;
  import formats_pkg::*;
  import surface_pkg::*;

  typedef struct packed {
    weight_t k;
    position_t [2:0] p2;
    position_t [2:0] p1;
  } calculate_new_p_in_t;

  typedef struct packed {
    position_t [2:0] p;
  } calculate_new_p_out_t;

  typedef struct packed {
    weight_t k;
    coordinate_t [1:0] u2;
    coordinate_t [1:0] u1;
  } calculate_new_u_in_t;

  typedef struct packed {
    coordinate_t [1:0] u;
  } calculate_new_u_out_t;

  typedef struct packed {
    logic tangent;
    weight_t k;
    unit_t [2:0] n2;
    unit_t [2:0] n1;
  } calculate_new_n_in_t;

  typedef struct packed {
    logic zero;
    unit_t [2:0] n;
  } calculate_new_n_out_t;

  typedef struct packed {
    coordinate_t [1:0] u;
    unit_t [2:0] n;
    position_t [2:0] p;
  } displace_vertex_in_t;

  typedef struct packed {
    logic saturated;
    position_t [2:0] p;
  } displace_vertex_out_t;

  typedef struct packed {
    unit_t [2:0] n12;
    unit_t [2:0] n2;
    unit_t [2:0] n1;
  } normal_test_in_t;

  typedef struct packed {
    normal_threshold_t threshold;
  } normal_test_regs_t;

  typedef struct packed {
    logic nt;
  } normal_test_out_t;

  typedef struct packed {
    coordinate_t [1:0] u12;
    coordinate_t [1:0] u2;
    coordinate_t [1:0] u1;
  } summed_height_test_in_t;

  typedef struct packed {
    average_threshold_t average_threshold;
    sum_threshold_t sum_threshold;
    logic average;
  } summed_height_test_regs_t;

  typedef struct packed {
    logic sht;
  } summed_height_test_out_t;

  typedef struct packed {
    logic forward;
    coordinate_t [1:0] u2;
    coordinate_t [1:0] u1;
  } profile_test_in_t;

  typedef struct packed {
    sample_t threshold;
  } profile_test_regs_t;

  typedef struct packed {
    weight_t k;
    logic pt;
  } profile_test_out_t;

  typedef struct packed {
    logic behind2;
    logic behind1;
    screen_t [1:0] screen2;
    screen_t [1:0] screen1;
  } view_test_in_t;

  typedef struct packed {
    view_threshold_t threshold;
  } view_test_regs_t;

  typedef struct packed {
    logic vt;
  } view_test_out_t;

  typedef struct packed {
    coordinate_t [1:0] u12;
    coordinate_t [1:0] u2;
    coordinate_t [1:0] u1;
  } tex_coord_test_in_t;

  typedef struct packed {
    logic ct;
  } tex_coord_test_out_t;

  typedef struct packed {
    unit_t [2:0] n12;
    unit_t [2:0] n2;
    unit_t [2:0] n1;
  } highlight_test_in_t;

  typedef struct packed {
    unit_t threshold;
    unit_t [2:0] half_vector;
  } highlight_test_regs_t;

  typedef struct packed {
    logic ht;
  } highlight_test_out_t;

  typedef struct packed {
    logic settled;
    generation_t generation;
    logic ct;
    logic vt;
    logic ht;
    logic pt;
    logic sht;
    logic nt;
  } pass_or_tessellate_in_t;

  typedef struct packed {
    logic cull;
    generation_t max_generation;
    logic use_ct;
    logic use_vt;
    logic use_ht;
    logic use_pt;
    logic use_sht;
    logic use_nt;
  } pass_or_tessellate_regs_t;

  typedef struct packed {
    logic split;
  } pass_or_tessellate_out_t;

  typedef struct packed {
    logic last;
    logic [2:0] settled;
    generation_t [2:0] generation;
    index_t index;
    vertex_t [2:0] v;
  } triangle_t;

  typedef struct packed {
    logic away;
    unit_t [2:0] screen_n;
    logic behind;
    depth_t w;
    screen_t [1:0] screen;
    unit_t [2:0] displaced_n;
    position_t [2:0] displaced_p;
    coordinate_t [1:0] u;
    unit_t [2:0] t;
    position_t [2:0] p;
  } out_vertex_t;

  typedef struct packed {
    logic last;
    logic empty;
    index_t index;
    out_vertex_t [2:0] v;
  } triangle_out_t;

  typedef struct packed {
    logic [2:0] settled;
    logic [2:0] new_normal;
    logic [2:0] new_surface;
  } get_triangle_out_t;

  typedef struct packed {
    vertex_t [2:0] m;
    logic [2:0] split;
    triangle_t t;
  } tessellate_in_t;

  typedef struct packed {
    logic [2:0] count;
    triangle_t [3:0] t;
  } tessellate_out_t;

  typedef struct packed {
    logic fifo;
  } triangle_queue_regs_t;

  typedef struct packed {
    triangle_queue_regs_t queue;
    pass_or_tessellate_regs_t pass;
    profile_test_regs_t profile;
    highlight_test_regs_t highlight;
    view_test_regs_t view;
    summed_height_test_regs_t summed_height;
    normal_test_regs_t normal;
    transform_normal_regs_t transform_normal;
    transform_regs_t transform;
    displace_regs_t displace;
    map_regs_t map;
  } engine_regs_t;

  typedef struct packed {
    coordinate_t [1:0] u;
    unit_t [2:0] t;
    unit_t [2:0] n;
    position_t [2:0] p;
  } base_vertex_t;

  typedef struct packed {
    logic last;
    index_t index;
    base_vertex_t [2:0] v;
  } base_triangle_t;
endpackage

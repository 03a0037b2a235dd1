// sweep_pkg: records of the units of sweep
// Printed by tb/cosim/print_packages.cpp from the C++ headers; not to be edited.
package sweep_pkg;
  import formats_pkg::*;

  typedef struct packed {
    grid_t [1:0][2:0] p;
  } main_direction_in_t;

  typedef struct packed {
    steps_t n;
    logic [1:0] axis;
  } main_direction_out_t;

  typedef struct packed {
    steps_t [2:0] n;
    logic [2:0][1:0] axis;
    grid_t [2:0][2:0] p;
  } primary_edge_in_t;

  typedef struct packed {
    logic [1:0] edge_;
  } primary_edge_out_t;

  typedef struct packed {
    logic [1:0] axis;
    logic [1:0] edge_;
    grid_t [2:0][2:0] p;
  } remeshing_plane_in_t;

  typedef struct packed {
    logic mirrored;
    logic signed [34:0] det;
    logic [1:0] c;
    logic [1:0] b;
    logic [1:0] a;
    logic [1:0] t;
    logic [1:0] s;
  } remeshing_plane_out_t;

  typedef struct packed {
    remeshing_plane_out_t plane;
    grid_t [2:0][2:0] p;
  } case_selection_in_t;

  typedef struct packed {
    logic [1:0] end_corner;
    logic ends_on_edge;
    logic corner_list;
    logic pointed;
    logic starts_at_corner;
    logic [1:0] to;
    logic [1:0] from;
    grid_t k1;
    grid_t k0;
    logic backward;
    logic valid;
  } sub_triangle_t;

  typedef struct packed {
    sub_triangle_t [1:0] sub;
    logic [1:0] kind;
  } case_selection_out_t;

  typedef struct packed {
    sub_triangle_t sub;
    remeshing_plane_out_t plane;
    grid_t [2:0][2:0] p;
  } sub_triangle_remeshing_in_t;

  typedef struct packed {
    grid_t [2:0][2:0] p;
  } sweep_line_in_t;

  typedef struct packed {
    grid_t t;
    grid_t s;
    steps_t i;
    logic [1:0] number;
    logic [1:0] kind;
  } remeshed_vertex_t;

  typedef struct packed {
    remeshed_vertex_t [3:0] v;
    logic quad;
  } primitive_t;
endpackage

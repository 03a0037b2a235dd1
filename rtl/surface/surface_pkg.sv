// surface_pkg: records of the units of surface
// Printed by tb/cosim/print_packages.cpp from the C++ headers; not to be edited.
package surface_pkg;
  import formats_pkg::*;

  typedef struct packed {
    logic wrap_v;
    logic wrap_u;
    map_size_t height;
    map_size_t width;
  } map_regs_t;

  typedef struct packed {
    coordinate_t [1:0] u;
  } map_address_in_t;

  typedef struct packed {
    fraction_t [1:0] f;
    map_size_t [1:0] y;
    map_size_t [1:0] x;
  } map_address_out_t;

  typedef struct packed {
    coordinate_t [1:0] u;
  } map_sampler_in_t;

  typedef struct packed {
    sample_t d;
  } map_sampler_out_t;

  typedef struct packed {
    coordinate_t [1:0] u;
  } normal_sampler_in_t;

  typedef struct packed {
    unit_t [2:0] n;
  } normal_sampler_out_t;

  typedef struct packed {
    bound_t y1;
    bound_t x1;
    bound_t y0;
    bound_t x0;
  } summed_area_lookup_in_t;

  typedef struct packed {
    rectangle_sum_t s;
  } summed_area_lookup_out_t;

  typedef struct packed {
    sample_t d;
    unit_t [2:0] n;
    position_t [2:0] p;
  } displace_in_t;

  typedef struct packed {
    position_t bias;
    scale_t scale;
  } displace_regs_t;

  typedef struct packed {
    logic saturated;
    position_t [2:0] p;
  } displace_out_t;

  typedef struct packed {
    unit_t [2:0] m;
    unit_t [2:0] t;
    unit_t [2:0] n;
  } bump_in_t;

  typedef struct packed {
    logic zero;
    logic saturated;
    unit_t [2:0] n;
  } bump_out_t;

  typedef struct packed {
    position_t [2:0] p;
  } transform_in_t;

  typedef struct packed {
    depth_t w_min;
    offset_w_t offset_w;
    offset_xy_t offset_y;
    offset_xy_t offset_x;
    matrix_w_t [2:0] row_w;
    matrix_xy_t [2:0] row_y;
    matrix_xy_t [2:0] row_x;
  } transform_regs_t;

  typedef struct packed {
    logic saturated;
    logic behind;
    depth_t w;
    screen_t [1:0] screen;
  } transform_out_t;

  typedef struct packed {
    unit_t [2:0] n;
    position_t [2:0] p;
  } transform_normal_in_t;

  typedef struct packed {
    eye_t [2:0] eye;
    unit_t [2:0][2:0] rotation;
  } transform_normal_regs_t;

  typedef struct packed {
    logic away;
    unit_t [2:0] n;
  } transform_normal_out_t;

  typedef struct packed {
    shift_t normal_shift;
    gradient_t gradient_v;
    gradient_t gradient_u;
  } normal_map_regs_t;

  typedef struct packed {
    logic zero;
    logic saturated;
    unit_t [2:0] n;
    map_size_t y;
    map_size_t x;
  } normal_map_out_t;

  typedef struct packed {
    logic transformed;
    logic displaced;
    logic away;
    unit_t [2:0] screen_n;
    logic behind;
    depth_t w;
    screen_t [1:0] screen;
    unit_t [2:0] displaced_n;
    position_t [2:0] displaced_p;
    coordinate_t [1:0] u;
    unit_t [2:0] t;
    unit_t [2:0] n;
    position_t [2:0] p;
  } vertex_t;
endpackage

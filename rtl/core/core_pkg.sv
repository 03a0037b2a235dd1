// core_pkg: records of the units of core
// Printed by tb/cosim/print_packages.cpp from the C++ headers; not to be edited.
package core_pkg;
  import formats_pkg::*;

  typedef struct packed {
    logic tangent;
    direction_t [2:0] v;
  } normalize_in_t;

  typedef struct packed {
    logic zero;
    unit_t [2:0] n;
  } normalize_out_t;

  typedef struct packed {
    depth_t denominator;
    clip_t numerator;
  } divide_in_t;

  typedef struct packed {
    logic clipped;
    screen_t quotient;
  } divide_out_t;
endpackage

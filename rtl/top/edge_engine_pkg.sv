// edge_engine_pkg: what the registers of the edge engine say of a mesh; rtl/top/edge_engine.rdl documents it.
package edge_engine_pkg;
  import formats_pkg::*;

  localparam map_size_t MapSizeLimit = 14'd8192;

  // What went wrong first.
  typedef enum logic [3:0] {
    None = 0,
    MapSizeZero = 1,
    MapSizeTooLarge = 2,
    MaxGenerationTooLarge = 3,
    EarlyLast = 4,
    MissingLast = 5,
    LastDisagrees = 6,
    CoordinateOutsideMap = 7,
    StartWhileBusy = 8,
    QueueOverflow = 9,
    MapEarlyLast = 10,
    MapMissingLast = 11,
    Stopped = 12,
    MemoryError = 13
  } error_code_e;

  // What the host asks for, each for one clock.
  typedef struct packed {
    logic clear_error;
    logic stop;
    logic start;
  } control_t;

  typedef struct packed {
    error_code_e error_code;
    logic        map_busy;
    logic        swallowing;
    logic        done;
    logic        busy;
  } state_t;

  // The parameters of the build, as the host reads them.
  typedef struct packed {
    logic [31:0] lanes;
    logic [31:0] sat_reads_per_clock;
    logic [31:0] profile_samples_per_clock;
    logic [31:0] queue_depth;
    logic [31:0] max_generation;
  } build_t;

  function automatic error_code_e map_error(map_size_t width, map_size_t height);
    if (width == '0 || height == '0) return MapSizeZero;
    if (width > MapSizeLimit || height > MapSizeLimit) return MapSizeTooLarge;
    return None;
  endfunction

  // The largest coordinate on an axis.
  function automatic coordinate_t coordinate_limit(map_size_t size, logic wrap);
    map_size_t texels;
    texels = wrap ? size : size - 14'd1;
    return {texels, {CoordinateFraction{1'b0}}};
  endfunction
endpackage

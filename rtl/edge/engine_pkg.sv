// engine_pkg: what circulates in the edge engine, and the places of its counters.
package engine_pkg;
  import formats_pkg::*;
  import surface_pkg::*;
  import edge_pkg::*;
  import lane_pkg::*;

  // A triangle in flight: what is asked of it, edges or (base triangles on their first pass) vertices.
  typedef struct packed {
    logic            place;
    logic      [2:0] ask;
    triangle_t       t;
  } flight_t;

  // What the lanes answered about a triangle; place: it is a base triangle, and m are its vertices.
  typedef struct packed {
    logic           place;
    tessellate_in_t t;
  } collected_t;

  // What comes of it, one triangle after the other: its children, or what was not split, itself.
  //   born  nobody has looked at it yet;  ends  it is the last of them
  typedef struct packed {
    logic      ends;
    logic      born;
    triangle_t t;
  } child_t;

  // Places of the counters, in the order of hls/edge/counters.hpp.
  localparam int unsigned CounterWords = 23;
  typedef logic [CounterWords-1:0][63:0] counters_t;
  localparam int unsigned CountTrianglesIn = 0;
  localparam int unsigned CountTrianglesOut = 1;
  localparam int unsigned CountCulled = 2;
  localparam int unsigned CountEdgeTests = 3;
  localparam int unsigned CountSettledSkips = 4;
  localparam int unsigned CountVt = 5;
  localparam int unsigned CountCt = 6;
  localparam int unsigned CountNt = 7;
  localparam int unsigned CountSht = 8;
  localparam int unsigned CountPt = 9;
  localparam int unsigned CountHt = 10;
  localparam int unsigned CountSplits = 11;  // and the three that follow
  localparam int unsigned CountVertices = 15;
  localparam int unsigned CountQueueHighWater = 16;
  localparam int unsigned CountFifoFallbacks = 17;
  localparam int unsigned CountSaturations = 18;
  localparam int unsigned CountScreenSaturations = 19;
  localparam int unsigned CountZeroVectors = 20;
  localparam int unsigned CountTableReads = 21;
  localparam int unsigned CountProfileSamples = 22;

  function automatic edge_end_t edge_end(vertex_t v);
    return '{
        behind: v.behind,
        screen: v.screen,
        displaced_n: v.displaced_n,
        u: v.u,
        t: v.t,
        n: v.n,
        p: v.p
    };
  endfunction

  // A base triangle as it comes in: of generation 0, nothing settled or computed.
  function automatic triangle_t to_triangle(base_triangle_t base);
    triangle_t t;
    t = '0;
    for (int i = 0; i < 3; i++) begin
      t.v[i].p = base.v[i].p;
      t.v[i].n = base.v[i].n;
      t.v[i].t = base.v[i].t;
      t.v[i].u = base.v[i].u;
    end
    t.index = base.index;
    return t;
  endfunction

  function automatic triangle_out_t to_output(triangle_t t);
    triangle_out_t out;
    for (int i = 0; i < 3; i++) begin
      out.v[i] = '{
          away: t.v[i].away,
          screen_n: t.v[i].screen_n,
          behind: t.v[i].behind,
          w: t.v[i].w,
          screen: t.v[i].screen,
          displaced_n: t.v[i].displaced_n,
          displaced_p: t.v[i].displaced_p,
          u: t.v[i].u,
          t: t.v[i].t,
          p: t.v[i].p
      };
    end
    out.index = t.index;
    out.empty = 1'b0;
    out.last = 1'b0;
    return out;
  endfunction
endpackage

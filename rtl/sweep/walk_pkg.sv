// walk_pkg: what the walk's circuits hand on to each other; the kernel has it in its registers.
package walk_pkg;
  import formats_pkg::*;
  import sweep_pkg::*;

  // An edge, and whether it is walked from its canonical end.
  typedef struct packed {
    logic       rising;
    logic [1:0] number;
  } way_t;
  // A vertex of the border: number of a corner, or of an edge, and i, the place on it.
  typedef struct packed {
    logic       on_edge;
    logic [1:0] number;
    steps_t     i;
  } border_t;

  // A sub-triangle to be walked; main_ of the triangle's edges. One that is not valid is a triangle of three equal corners.
  //   ends  no other of this triangle follows
  typedef struct packed {
    main_direction_out_t [2:0] main_;
    logic                      ends;
    sub_triangle_remeshing_in_t sub;
  } walk_in_t;

  // The same with the walk's directions and counts, from walk_frame. Widths, rows and columns along s' and t'.
  //   a list of edges begins with first where it has two of which the vertical one has vertices within, else with side
  //   first_row, first_column  the step from the corner to the first vertex of the list; from_zero: side's list begins with vertex 0
  //   only_end                 no vertex of the list before its end
  typedef struct packed {
    logic               ends;
    logic               point;
    logic               backward;
    logic               mirrored;
    logic               flip;
    logic               pointed;
    logic               ends_on_edge;
    logic               from_corner;
    logic [1:0]         start;
    logic [1:0]         goal;           // the other end of the primary edge
    logic [1:0]         from;
    logic [1:0]         to;
    steps_t             width;          // columns: strips
    way_t               primary;
    steps_t             primary_n;
    logic signed [17:0] primary_row;    // 2 delta
    grid_t              s;              // of the corner `start`
    grid_t              t;
    way_t               upright;
    steps_t             upright_n;
    logic               has_first;
    way_t               first;
    steps_t             first_n;
    way_t               side;
    steps_t             side_n;
    logic [16:0]        side_column;    // 2 delta
    logic [16:0]        side_row;
    logic [16:0]        column_e;       // of the first vertex
    logic [16:0]        row_e;
    steps_t             columns;        // from the first vertex to the end
    logic               from_zero;
    logic               only_end;
    logic               first_row;
    logic               first_column;
  } frame_t;

  // A vertex of the side edges, from walk_edges.
  //   row, column              steps to the next one, 0 or 1; first_ as in frame_t, of the first of a list alone
  //   begins                   the corner at which its edge begins;  last  on the last edge, its first vertex included
  //   before_end               what follows is the end of the list, which is not sent;  only_end  that is it
  typedef struct packed {
    border_t name;
    way_t    along;
    logic    begins;
    logic    last;
    logic    before_end;
    logic    only_end;
    logic    row;
    logic    column;
    logic    first_row;
    logic    first_column;
  } edge_vertex_t;

  // A strip, from walk_strips; P_k and P_(k+1), and the grid vertices above the ones nearest to them.
  typedef struct packed {
    logic              point;         // none, but a triangle of three equal corners
    logic              begins;        // the first of a sub-triangle
    logic              from_corner;   // and that starts at a corner
    logic              last;          // the last one
    logic              ends;          // of the last sub-triangle
    logic              pointed;
    logic              on_edge;       // it ends on a vertical edge
    logic              backward;
    logic              mirrored;
    logic              flip;
    logic signed [1:0] rows;          // from P_k to P_(k+1)
    way_t              primary;
    logic [1:0]        to;
    border_t           left;
    border_t           right;
    grid_t             left_s;
    grid_t             left_t;
    grid_t             right_s;
    grid_t             right_t;
    way_t              upright;
    steps_t            upright_n;
  } strip_t;

  // How a step comes to the data of its vertices. A data path has registers start, base, left, right, left_grid, right_grid, edge,
  // upright; D of an edge with its sign along the way, D_side with that of t', D_sweep with that of s'.
  //   first      of a strip: left = start, left_grid = base; start += D_primary, base += D_sweep + rows D_side; right = start,
  //              right_grid = base. Where from_corner, start and base first become those of the corner.
  //   begins     of a sub-triangle: edge is the first vertex of a list, the begin of its edge where edge_begins, else that + D_edge
  //   fan        (left, edge + D_edge, edge)
  //   double     (left, right, edge); left = edge
  //   go_left    top_left is edge where edge_here, else left_grid = left_grid + D_side; left = top_left
  //   go_right   top_right is right_grid + D_side likewise; or, where edge_there, upright + D on_edge, next where edge_here, else edge
  //   flip       a primitive is put out the other way round
  //   advance    edge += D_edge, and where edge_begins in the next step the begin of its edge
  typedef struct packed {
    logic              first;
    logic              begins;
    logic              from_corner;
    logic signed [1:0] rows;
    logic              backward;
    logic              mirrored;
    logic              flip;
    way_t              primary;
    way_t              edge_way;
    logic              edge_begins;
    way_t              upright;
    logic              on_edge;
    logic              fan;
    logic              double_;
    logic              go_left;
    logic              go_right;
    logic              edge_here;
    logic              edge_there;
    logic              advance;
  } moves_t;

  // A primitive, and whether it is the last of its strip, its sub-triangle, its triangle.
  typedef struct packed {
    logic       last;
    logic       sub_last;
    logic       strip_last;
    moves_t     moves;
    primitive_t out;
  } walked_t;

  // ---- within side_walk: of a strip what decides, and the names; what was decided; what walk_names gets, and what comes of it
  typedef struct packed {
    logic              point;
    logic              from_corner;
    logic              last;
    logic              pointed;
    logic              on_edge;
    logic signed [1:0] rows;
    steps_t            upright_n;
    logic              upright_rising;
  } strip_control_t;
  typedef struct packed {
    logic              begins;
    logic              from_corner;
    logic              ends;
    logic              on_edge;
    logic              backward;
    logic              mirrored;
    logic              flip;
    logic signed [1:0] rows;
    way_t              primary;
    way_t              upright;
    logic [1:0]        to;
    border_t           left;
    border_t           right;
    grid_t             left_s;
    grid_t             left_t;
    grid_t             right_s;
    grid_t             right_t;
  } strip_names_t;
  typedef struct packed {
    logic         first;
    logic         done;
    logic         last;
    logic         fan;
    logic         double_;
    logic         go_left;
    logic         go_right;
    logic         edge_here;
    logic         edge_there;
    logic         advance;
    logic         at_end;
    edge_vertex_t edge_;
    border_t      next;
    logic         upright_last;
    steps_t       upright_i;
  } decided_t;
  // A step: left, right, and the grid above them are of the strip's beginning and looked at in its first step.
  typedef struct packed {
    logic    last;
    logic    sub_last;
    logic    strip_last;
    moves_t  moves;
    border_t left;
    border_t right;
    grid_t   left_s;
    grid_t   left_t;
    grid_t   right_s;
    grid_t   right_t;
    border_t edge_;
    border_t next;
    border_t upright;
  } step_t;

  // A vertex: x, y are s, t of the grid, or i and number of the border.
  typedef struct packed {
    logic [1:0]  kind;
    logic [15:0] x;
    logic [15:0] y;
  } name_t;
  typedef struct packed {
    logic        last;
    logic        sub_last;
    logic        strip_last;
    moves_t      moves;
    logic        quad;
    name_t [3:0] v;
  } named_t;
endpackage

// edge_engine_maps: a map of texels from the bus into both builders, the summed-area table's and the normal map's.
//   in    regs_i, normal_regs_i  as the host wrote them; taken over with the first texel of a map, constant until the last word is out
//         close_i                the host has seen an error: ends the swallowing;  stop_i  ends the map, or the swallowing; both for
//                                one clock. A mesh that begins is no reason to end it: the rest of a map is no map.
//         in_*                   texels row by row from v = 0, x fastest; in_last_i on the last one
//   out   table_*, normal_*      words (x, y) of the table and of the map of normals, in the builders' order
//         busy_o                 a map is being built;  swallowing_o  what comes is of no map
//         error_o                what is wrong, for one clock
//         saturations_o          texels of this map whose slope was beyond the range
//
//   latency that of the builders, 7 and 32; the first texel of a map is taken 2 clocks after it is offered, and busy_o falls 2 clocks after
//   the last word came; initiation interval 1 where normal_map's is. Outputs are registers or a few gates from them; no path from a ready
//   input to in_ready_o.
//   A map that ends early is filled up with zeros, so that its words still come out whole. A map of a wrong size, and what follows a map
//   whose last texel does not say so, is swallowed up to its tlast; there its error is told again, as a start may have cleared it.
module edge_engine_maps
  import formats_pkg::*;
  import surface_pkg::*;
  import memory_pkg::*;
  import edge_engine_pkg::*;
(
  input  logic             clk_i,
  input  logic             rst_ni,
  input  map_regs_t        regs_i,
  input  normal_map_regs_t normal_regs_i,
  input  logic             close_i,
  input  logic             stop_i,

  input  logic             in_valid_i,
  output logic             in_ready_o,
  input  texel_t           in_i,
  input  logic             in_last_i,

  output logic             table_valid_o,
  input  logic             table_ready_i,
  output table_write_t     table_o,
  output logic             normal_valid_o,
  input  logic             normal_ready_i,
  output normal_map_out_t  normal_o,

  output logic             busy_o,
  output logic             swallowing_o,
  output error_code_e      error_o,
  output logic [31:0]      saturations_o
);
  // Idle: registers are followed. Build: texels; Fill: zeros; Flush: the builders empty themselves. Swallow: up to tlast.
  typedef enum logic [2:0] {
    Idle,
    Load,
    Build,
    Fill,
    Flush,
    Swallow
  } phase_e;
  phase_e phase_q, next_phase;
  logic   beyond_q, next_beyond;  // what follows this map is swallowed
  assign busy_o = phase_q != Idle && phase_q != Swallow;
  assign swallowing_o = phase_q == Swallow;

  map_regs_t        map_q;
  normal_map_regs_t normal_regs_q;
  always_ff @(posedge clk_i) begin
    if (phase_q == Idle) begin
      map_q <= regs_i;
      normal_regs_q <= normal_regs_i;
    end
  end

  // Both builders take a texel at once. stop_q: no more of them from outside.
  logic table_ready, normal_ready, table_busy, normal_busy, both_ready, stop_q;
  logic take, step, last_column_q, last_row_q, last_step;
  assign both_ready = table_ready && normal_ready;
  assign in_ready_o = (phase_q == Build && both_ready && !stop_q) || phase_q == Swallow;
  assign take = in_valid_i && in_ready_o;
  assign step = both_ready && (phase_q == Fill || (phase_q == Build && in_valid_i && !stop_q));
  assign last_step = step && last_column_q && last_row_q;

  // Texels of the row and rows that are left, this one too.
  map_size_t columns_q, rows_q;
  always_ff @(posedge clk_i) begin
    if (phase_q == Load) begin
      columns_q <= map_q.width;
      rows_q <= map_q.height;
      last_column_q <= map_q.width == 14'd1;
      last_row_q <= map_q.height == 14'd1;
    end else if (step) begin
      columns_q <= last_column_q ? map_q.width : columns_q - 14'd1;
      last_column_q <= last_column_q ? map_q.width == 14'd1 : columns_q == 14'd2;
      if (last_column_q) begin
        rows_q <= rows_q - 14'd1;
        last_row_q <= rows_q == 14'd2;
      end
    end
  end

  error_code_e error, why_q;  // why_q: of the map that is swallowed
  always_comb begin
    next_phase = phase_q;
    next_beyond = beyond_q;
    error = None;
    unique case (phase_q)
      Idle: begin
        next_beyond = 1'b0;
        if (in_valid_i) next_phase = Load;
      end
      Load: begin
        error = map_error(map_q.width, map_q.height);
        next_phase = error == None ? Build : Swallow;
      end
      Build: begin
        if (last_step) begin
          next_phase = Flush;
          if (!in_last_i) begin
            error = MapMissingLast;
            next_beyond = 1'b1;
          end
        end else if (take && in_last_i) begin
          error = MapEarlyLast;
          next_phase = Fill;
        end else if (stop_q) begin
          error = Stopped;
          next_phase = Fill;
          next_beyond = 1'b1;
        end
      end
      Fill: if (last_step) next_phase = Flush;
      Flush: if (!table_busy && !normal_busy) next_phase = beyond_q ? Swallow : Idle;
      Swallow: begin
        if ((take && in_last_i) || close_i || stop_q) next_phase = Idle;
        if (take && in_last_i && !close_i) error = why_q;
      end
      default: next_phase = Idle;
    endcase
    // The host has seen the error before the map was flushed.
    if (close_i) next_beyond = 1'b0;
  end
  always_ff @(posedge clk_i) begin
    if (phase_q != Swallow && error != None) why_q <= error;
    if (!rst_ni) begin
      phase_q <= Idle;
      beyond_q <= 1'b0;
      stop_q <= 1'b0;
      error_o <= None;
    end else begin
      phase_q <= next_phase;
      beyond_q <= next_beyond;
      stop_q <= stop_i && (phase_q == Build || phase_q == Load || phase_q == Swallow);
      error_o <= error;
    end
  end

  texel_t texel;
  assign texel = phase_q == Fill ? '0 : in_i;
  summed_area_table i_table (
    .clk_i,
    .rst_ni,
    .map_i(map_q),
    .busy_o(table_busy),
    .in_valid_i(step),
    .in_ready_o(table_ready),
    .in_i(texel),
    .out_valid_o(table_valid_o),
    .out_ready_i(table_ready_i),
    .out_o(table_o)
  );
  normal_map i_normals (
    .clk_i,
    .rst_ni,
    .map_i(map_q),
    .regs_i(normal_regs_q),
    .busy_o(normal_busy),
    .in_valid_i(step),
    .in_ready_o(normal_ready),
    .in_i(texel),
    .out_valid_o(normal_valid_o),
    .out_ready_i(normal_ready_i),
    .out_o(normal_o)
  );

  always_ff @(posedge clk_i) begin
    if (!rst_ni || phase_q == Load) saturations_o <= '0;
    else if (normal_valid_o && normal_ready_i && normal_o.saturated)
      saturations_o <= saturations_o + 32'd1;
  end
endmodule

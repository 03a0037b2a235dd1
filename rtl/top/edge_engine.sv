// edge_engine: the edge engine among buses: base triangles in, adaptively tessellated and displaced triangles out.
//   Doggett & Hirche 2000; the engine itself is rtl/edge/engine.sv, its registers are rtl/top/edge_engine.rdl
//   parameters  LANES, 1 or 3; SAT_READS_PER_CLOCK, 1, 3, 4 or 12 words of the summed-area table a clock and lane;
//               PROFILE_SAMPLES_PER_CLOCK, 1, 4 or 16; QUEUE_DEPTH, 3 MAX_GENERATION + 4 at least;
//               IN_FLIGHT, edges that wait for memories, 8 at least, more than their latency for full rate
//   aresetn           low for two clocks at least; the memories' too: no answer of before may come after it
//   s_axil_*          AXI4-Lite: parameters, start, state, counters
//   s_axis_*          base_triangle_t from bit 0, padded with zeros to bytes; tlast with the last of a mesh
//   m_axis_*          triangle_out_t likewise
//   s_axis_map_*      texels row by row, for both builders of maps; tlast with the last of a map
//   table_write_*     words (x, y) of the summed-area table for its memory;  normal_write_*  of the map of normals
//   table_*, quad_*, place_*, normal_*   read ports, lane 0 at bit 0, as memory_pkg.sv says; edge_engine_axi.sv serves them from AXI4
//   map_width_o       of the map that the running mesh reads, for who makes addresses of coordinates
//   memory_error_i    for one clock: an answer at a read port was none; the host is told, the mesh goes on
//
//   Parameters are taken over at start. Bad input is refused with an error code, and the next start works: edge_engine_input.sv.
//   latency of a mesh: its own; initiation interval: that of the engine, a base triangle every other clock at most. All outputs are
//   registered or a few gates from registers.
//
//   s_axil --[registers]--+
//   s_axis ---------------+--[mesh]--[engine]-- m_axis
//   s_axis_map --[maps]-- writes          |
//                                     read ports
module edge_engine
  import formats_pkg::*;
  import surface_pkg::*;
  import memory_pkg::*;
  import edge_pkg::*;
  import engine_pkg::*;
  import edge_engine_pkg::*;
#(
  parameter int unsigned LANES = 1,
  parameter int unsigned SAT_READS_PER_CLOCK = 12,
  parameter int unsigned PROFILE_SAMPLES_PER_CLOCK = 4,
  parameter int unsigned QUEUE_DEPTH = 4096,
  parameter int unsigned MAX_GENERATION = 15,
  parameter int unsigned IN_FLIGHT = 128,
  localparam int unsigned InBits = ($bits(base_triangle_t) + 7) / 8 * 8,
  localparam int unsigned OutBits = ($bits(triangle_out_t) + 7) / 8 * 8
) (
  // verilog_lint: waive-start port-name-suffix  the bus standard's own names
  input  logic aclk,
  input  logic aresetn,

  input  logic [11:0] s_axil_awaddr,
  input  logic [2:0]  s_axil_awprot,
  input  logic        s_axil_awvalid,
  output logic        s_axil_awready,
  input  logic [31:0] s_axil_wdata,
  input  logic [3:0]  s_axil_wstrb,
  input  logic        s_axil_wvalid,
  output logic        s_axil_wready,
  output logic [1:0]  s_axil_bresp,
  output logic        s_axil_bvalid,
  input  logic        s_axil_bready,
  input  logic [11:0] s_axil_araddr,
  input  logic [2:0]  s_axil_arprot,
  input  logic        s_axil_arvalid,
  output logic        s_axil_arready,
  output logic [31:0] s_axil_rdata,
  output logic [1:0]  s_axil_rresp,
  output logic        s_axil_rvalid,
  input  logic        s_axil_rready,

  input  logic [InBits-1:0] s_axis_tdata,
  input  logic              s_axis_tlast,
  input  logic              s_axis_tvalid,
  output logic              s_axis_tready,

  output logic [OutBits-1:0] m_axis_tdata,
  output logic               m_axis_tlast,
  output logic               m_axis_tvalid,
  input  logic               m_axis_tready,

  input  logic [15:0] s_axis_map_tdata,
  input  logic        s_axis_map_tlast,
  input  logic        s_axis_map_tvalid,
  output logic        s_axis_map_tready,
  // verilog_lint: waive-stop port-name-suffix

  output logic       table_write_valid_o,
  input  logic       table_write_ready_i,
  output map_size_t  table_write_x_o,
  output map_size_t  table_write_y_o,
  output table_sum_t table_write_word_o,
  output logic       normal_write_valid_o,
  input  logic       normal_write_ready_i,
  output map_size_t  normal_write_x_o,
  output map_size_t  normal_write_y_o,
  output normal_t    normal_write_word_o,

  output logic           [LANES-1:0]                          table_req_valid_o,
  input  logic           [LANES-1:0]                          table_req_ready_i,
  output table_request_t [LANES-1:0][SAT_READS_PER_CLOCK-1:0] table_req_o,
  input  logic           [LANES-1:0]                          table_rsp_valid_i,
  input  table_sum_t     [LANES-1:0][SAT_READS_PER_CLOCK-1:0] table_rsp_i,

  output logic          [LANES-1:0]                                quad_req_valid_o,
  input  logic          [LANES-1:0]                                quad_req_ready_i,
  output quad_request_t [LANES-1:0][PROFILE_SAMPLES_PER_CLOCK-1:0] quad_req_o,
  output logic          [LANES-1:0][PROFILE_SAMPLES_PER_CLOCK-1:0] quad_req_mask_o,
  input  logic          [LANES-1:0]                                quad_rsp_valid_i,
  input  texel_quad_t   [LANES-1:0][PROFILE_SAMPLES_PER_CLOCK-1:0] quad_rsp_i,

  output logic          [LANES-1:0] place_req_valid_o,
  input  logic          [LANES-1:0] place_req_ready_i,
  output quad_request_t [LANES-1:0] place_req_o,
  input  logic          [LANES-1:0] place_rsp_valid_i,
  input  texel_quad_t   [LANES-1:0] place_rsp_i,

  output logic          [LANES-1:0] normal_req_valid_o,
  input  logic          [LANES-1:0] normal_req_ready_i,
  output quad_request_t [LANES-1:0] normal_req_o,
  input  logic          [LANES-1:0] normal_rsp_valid_i,
  input  normal_quad_t  [LANES-1:0] normal_rsp_i,

  output map_size_t map_width_o,
  input  logic      memory_error_i
);
  if (LANES != 1 && LANES != 3) begin : gen_lanes
    $error("LANES is 1 or 3");
  end
  if (QUEUE_DEPTH < 3 * MAX_GENERATION + 4) begin : gen_queue_depth
    $error("QUEUE_DEPTH is 3 MAX_GENERATION + 4 at least");
  end
  if (MAX_GENERATION > 15) begin : gen_max_generation
    $error("MAX_GENERATION is 15 at most");
  end
  if (SAT_READS_PER_CLOCK != 1 && SAT_READS_PER_CLOCK != 3 && SAT_READS_PER_CLOCK != 4 &&
      SAT_READS_PER_CLOCK != 12) begin : gen_sat_reads
    $error("SAT_READS_PER_CLOCK is 1, 3, 4 or 12");
  end
  if (PROFILE_SAMPLES_PER_CLOCK != 1 && PROFILE_SAMPLES_PER_CLOCK != 4 &&
      PROFILE_SAMPLES_PER_CLOCK != 16) begin : gen_profile_samples
    $error("PROFILE_SAMPLES_PER_CLOCK is 1, 4 or 16");
  end
  if (IN_FLIGHT < 8) begin : gen_in_flight
    $error("IN_FLIGHT is 8 at least");
  end

  logic rst_nq;
  always_ff @(posedge aclk) rst_nq <= aresetn;

  // ---- registers
  control_t         control;
  state_t           state;
  counters_t        counters;
  engine_regs_t     written_regs, regs;
  normal_map_regs_t normal_regs;
  logic [31:0]      written_expected, saturations;
  logic             generation_beyond;
  build_t           build;
  assign build = '{
    lanes: LANES,
    sat_reads_per_clock: SAT_READS_PER_CLOCK,
    profile_samples_per_clock: PROFILE_SAMPLES_PER_CLOCK,
    queue_depth: QUEUE_DEPTH,
    max_generation: MAX_GENERATION
  };
  edge_engine_registers i_registers (
    .clk_i(aclk),
    .rst_ni(rst_nq),
    .s_axil_awaddr, .s_axil_awprot, .s_axil_awvalid, .s_axil_awready, .s_axil_wdata,
    .s_axil_wstrb, .s_axil_wvalid, .s_axil_wready, .s_axil_bresp, .s_axil_bvalid, .s_axil_bready,
    .s_axil_araddr, .s_axil_arprot, .s_axil_arvalid, .s_axil_arready, .s_axil_rdata,
    .s_axil_rresp, .s_axil_rvalid, .s_axil_rready,
    .state_i(state),
    .counters_i(counters),
    .saturations_i(saturations),
    .build_i(build),
    .control_o(control),
    .regs_o(written_regs),
    .generation_beyond_o(generation_beyond),
    .normal_regs_o(normal_regs),
    .expected_o(written_expected)
  );

  // ---- a mesh from start to done
  logic           engine_done, overflow, begins, ends, mesh_swallowing, map_swallowing;
  error_code_e    map_error_code;
  logic           in_valid, in_ready;
  base_triangle_t in_word;
  edge_engine_mesh i_mesh (
    .clk_i(aclk),
    .rst_ni(rst_nq),
    .max_generation_i(generation_t'(MAX_GENERATION)),
    .control_i(control),
    .regs_i(written_regs),
    .generation_beyond_i(generation_beyond),
    .expected_i(written_expected),
    .engine_done_i(engine_done),
    .overflow_i(overflow),
    .map_error_i(map_error_code),
    .memory_error_i,
    .in_valid_i(s_axis_tvalid),
    .in_ready_o(s_axis_tready),
    .in_i(s_axis_tdata[$bits(base_triangle_t)-1:0]),
    .in_last_i(s_axis_tlast),
    .regs_o(regs),
    .begin_o(begins),
    .end_o(ends),
    .out_valid_o(in_valid),
    .out_ready_i(in_ready),
    .out_o(in_word),
    .busy_o(state.busy),
    .done_o(state.done),
    .swallowing_o(mesh_swallowing),
    .error_code_o(state.error_code)
  );
  assign state.swallowing = mesh_swallowing || map_swallowing;
  assign map_width_o = regs.map.width;

  if (InBits > $bits(base_triangle_t)) begin : gen_padding
    logic unused_padding;
    assign unused_padding = ^s_axis_tdata[InBits-1:$bits(base_triangle_t)];
  end

  triangle_out_t out_word;
  engine #(
    .Lanes(LANES),
    .ReadsPerClock(SAT_READS_PER_CLOCK),
    .SamplesPerClock(PROFILE_SAMPLES_PER_CLOCK),
    .QueueDepth(QUEUE_DEPTH),
    .MaxGeneration(MAX_GENERATION),
    .InFlight(IN_FLIGHT)
  ) i_engine (
    .clk_i(aclk),
    .rst_ni(rst_nq),
    .start_i(begins),
    .end_i(ends),
    .done_o(engine_done),
    .error_o(overflow),
    .regs_i(regs),
    .counters_o(counters),
    .in_valid_i(in_valid),
    .in_ready_o(in_ready),
    .in_i(in_word),
    .table_req_valid_o,
    .table_req_ready_i,
    .table_req_o,
    .table_rsp_valid_i,
    .table_rsp_i,
    .quad_req_valid_o,
    .quad_req_ready_i,
    .quad_req_o,
    .quad_req_mask_o,
    .quad_rsp_valid_i,
    .quad_rsp_i,
    .place_req_valid_o,
    .place_req_ready_i,
    .place_req_o,
    .place_rsp_valid_i,
    .place_rsp_i,
    .normal_req_valid_o,
    .normal_req_ready_i,
    .normal_req_o,
    .normal_rsp_valid_i,
    .normal_rsp_i,
    .out_valid_o(m_axis_tvalid),
    .out_ready_i(m_axis_tready),
    .out_o(out_word)
  );
  assign m_axis_tdata = OutBits'(out_word);
  assign m_axis_tlast = out_word.last;

  // ---- the maps
  table_write_t    table_word;
  normal_map_out_t normal_word;
  logic            map_close;
  assign map_close = control.clear_error;
  edge_engine_maps i_maps (
    .clk_i(aclk),
    .rst_ni(rst_nq),
    .regs_i(written_regs.map),
    .normal_regs_i(normal_regs),
    .close_i(map_close),
    .stop_i(control.stop),
    .in_valid_i(s_axis_map_tvalid),
    .in_ready_o(s_axis_map_tready),
    .in_i(s_axis_map_tdata),
    .in_last_i(s_axis_map_tlast),
    .table_valid_o(table_write_valid_o),
    .table_ready_i(table_write_ready_i),
    .table_o(table_word),
    .normal_valid_o(normal_write_valid_o),
    .normal_ready_i(normal_write_ready_i),
    .normal_o(normal_word),
    .busy_o(state.map_busy),
    .swallowing_o(map_swallowing),
    .error_o(map_error_code),
    .saturations_o(saturations)
  );
  assign table_write_x_o = table_word.x;
  assign table_write_y_o = table_word.y;
  assign table_write_word_o = table_word.sum;
  assign normal_write_x_o = normal_word.x;
  assign normal_write_y_o = normal_word.y;
  assign normal_write_word_o = normal_word.n;
  logic unused_normal;
  assign unused_normal = normal_word.saturated ^ normal_word.zero;
endmodule

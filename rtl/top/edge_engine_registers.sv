// edge_engine_registers: the register block that scripts/registers.sh makes of edge_engine.rdl, with the engine's records as its ports.
//   in    s_axil               AXI4-Lite, 32 bits; an address without a register, and a write to one that is only read, give SLVERR
//         state_i, counters_i, saturations_i, build_i  what the host reads
//   out   control_o            for one clock each
//         regs_o, normal_regs_o, expected_o              what the host wrote last; a map size that has no room there is the largest
//         generation_beyond_o  max_generation has no room in regs_o
//
//   latency 4 of a write and 5 of a read; initiation interval the same, one after the other. Registered: all outputs.
module edge_engine_registers
  import formats_pkg::*;
  import surface_pkg::*;
  import edge_pkg::*;
  import engine_pkg::*;
  import edge_engine_pkg::*;
  import edge_engine_regblock_pkg::*;
(
  input  logic             clk_i,
  input  logic             rst_ni,

  // verilog_lint: waive-start port-name-suffix  the bus standard's own names
  input  logic [11:0]      s_axil_awaddr,
  input  logic [2:0]       s_axil_awprot,
  input  logic             s_axil_awvalid,
  output logic             s_axil_awready,
  input  logic [31:0]      s_axil_wdata,
  input  logic [3:0]       s_axil_wstrb,
  input  logic             s_axil_wvalid,
  output logic             s_axil_wready,
  output logic [1:0]       s_axil_bresp,
  output logic             s_axil_bvalid,
  input  logic             s_axil_bready,
  input  logic [11:0]      s_axil_araddr,
  input  logic [2:0]       s_axil_arprot,
  input  logic             s_axil_arvalid,
  output logic             s_axil_arready,
  output logic [31:0]      s_axil_rdata,
  output logic [1:0]       s_axil_rresp,
  output logic             s_axil_rvalid,
  input  logic             s_axil_rready,
  // verilog_lint: waive-stop port-name-suffix

  input  state_t           state_i,
  input  counters_t        counters_i,
  input  logic [31:0]      saturations_i,
  input  build_t           build_i,
  output control_t         control_o,
  output engine_regs_t     regs_o,
  output logic             generation_beyond_o,
  output normal_map_regs_t normal_regs_o,
  output logic [31:0]      expected_o
);
  edge_engine__in_t  from_engine;
  edge_engine__out_t to_engine;
  logic        req, req_is_wr, rd_ack, rd_err, wr_ack, wr_err;
  logic [11:0] addr;
  logic [31:0] wr_data, wr_biten, rd_data;
  axi_lite #(.AddressBits(12)) i_axi_lite (
    .clk_i, .rst_ni,
    .s_axil_awaddr, .s_axil_awvalid, .s_axil_awready,
    .s_axil_wdata, .s_axil_wstrb, .s_axil_wvalid, .s_axil_wready,
    .s_axil_bresp, .s_axil_bvalid, .s_axil_bready,
    .s_axil_araddr, .s_axil_arvalid, .s_axil_arready,
    .s_axil_rdata, .s_axil_rresp, .s_axil_rvalid, .s_axil_rready,
    .req_o(req), .req_is_wr_o(req_is_wr), .addr_o(addr), .wr_data_o(wr_data), .wr_biten_o(wr_biten),
    .rd_ack_i(rd_ack), .rd_err_i(rd_err), .rd_data_i(rd_data), .wr_ack_i(wr_ack), .wr_err_i(wr_err)
  );
  // Nothing here asks for privileges. The block puts a write off that comes in the clock after a read; none does.
  logic [1:0] unused_stall;
  logic [5:0] unused_prot;
  assign unused_prot = {s_axil_awprot, s_axil_arprot};
  edge_engine_regblock i_regblock (
    .clk(clk_i),
    .rst_n(rst_ni),
    .s_cpuif_req(req),
    .s_cpuif_req_is_wr(req_is_wr),
    .s_cpuif_addr(addr),
    .s_cpuif_wr_data(wr_data),
    .s_cpuif_wr_biten(wr_biten),
    .s_cpuif_req_stall_wr(unused_stall[1]),
    .s_cpuif_req_stall_rd(unused_stall[0]),
    .s_cpuif_rd_ack(rd_ack),
    .s_cpuif_rd_err(rd_err),
    .s_cpuif_rd_data(rd_data),
    .s_cpuif_wr_ack(wr_ack),
    .s_cpuif_wr_err(wr_err),
    .hwif_in(from_engine),
    .hwif_out(to_engine)
  );

  // ---- what the host reads
  assign from_engine.state.busy.next = state_i.busy;
  assign from_engine.state.done.next = state_i.done;
  assign from_engine.state.error.next = state_i.error_code != None;
  assign from_engine.state.swallowing.next = state_i.swallowing;
  assign from_engine.state.map_busy.next = state_i.map_busy;
  assign from_engine.state.error_code.next = state_i.error_code;
  assign from_engine.build_lanes.value.next = build_i.lanes;
  assign from_engine.build_sat_reads_per_clock.value.next = build_i.sat_reads_per_clock;
  assign from_engine.build_profile_samples_per_clock.value.next = build_i.profile_samples_per_clock;
  assign from_engine.build_queue_depth.value.next = build_i.queue_depth;
  assign from_engine.build_max_generation.value.next = build_i.max_generation;
  assign from_engine.normal_saturations.value.next = saturations_i;

  edge_engine__counters__in_t count;
  assign from_engine.counters = count;
  always_comb begin
    {count.triangles_in.high.next, count.triangles_in.low.next} = counters_i[CountTrianglesIn];
    {count.triangles_out.high.next, count.triangles_out.low.next} = counters_i[CountTrianglesOut];
    {count.culled.high.next, count.culled.low.next} = counters_i[CountCulled];
    {count.edge_tests.high.next, count.edge_tests.low.next} = counters_i[CountEdgeTests];
    {count.settled_skips.high.next, count.settled_skips.low.next} = counters_i[CountSettledSkips];
    {count.vt.high.next, count.vt.low.next} = counters_i[CountVt];
    {count.ct.high.next, count.ct.low.next} = counters_i[CountCt];
    {count.nt.high.next, count.nt.low.next} = counters_i[CountNt];
    {count.sht.high.next, count.sht.low.next} = counters_i[CountSht];
    {count.pt.high.next, count.pt.low.next} = counters_i[CountPt];
    {count.ht.high.next, count.ht.low.next} = counters_i[CountHt];
    {count.splits_0.high.next, count.splits_0.low.next} = counters_i[CountSplits];
    {count.splits_1.high.next, count.splits_1.low.next} = counters_i[CountSplits+1];
    {count.splits_2.high.next, count.splits_2.low.next} = counters_i[CountSplits+2];
    {count.splits_3.high.next, count.splits_3.low.next} = counters_i[CountSplits+3];
    {count.vertices.high.next, count.vertices.low.next} = counters_i[CountVertices];
    {count.queue_high_water.high.next, count.queue_high_water.low.next} =
        counters_i[CountQueueHighWater];
    {count.fifo_fallbacks.high.next, count.fifo_fallbacks.low.next} =
        counters_i[CountFifoFallbacks];
    {count.saturations.high.next, count.saturations.low.next} = counters_i[CountSaturations];
    {count.screen_saturations.high.next, count.screen_saturations.low.next} =
        counters_i[CountScreenSaturations];
    {count.zero_vectors.high.next, count.zero_vectors.low.next} = counters_i[CountZeroVectors];
    {count.table_reads.high.next, count.table_reads.low.next} = counters_i[CountTableReads];
    {count.profile_samples.high.next, count.profile_samples.low.next} =
        counters_i[CountProfileSamples];
  end

  function automatic map_size_t map_size(logic [31:0] written);
    return written > 32'd8192 ? '1 : written[13:0];
  endfunction

  // ---- what the host wrote
  edge_engine__engine_regs__out_t wrote;
  assign wrote = to_engine.engine_regs;
  always_comb begin
    control_o.start = to_engine.control.start.value;
    control_o.stop = to_engine.control.stop.value;
    control_o.clear_error = to_engine.control.clear_error.value;
    expected_o = to_engine.expected_triangles.value.value;
    normal_regs_o.gradient_u = to_engine.normal_map_regs.gradient_u.value.value;
    normal_regs_o.gradient_v = to_engine.normal_map_regs.gradient_v.value.value;
    normal_regs_o.normal_shift = to_engine.normal_map_regs.normal_shift.value.value;
  end
  always_comb begin
    regs_o.map.width = map_size(wrote.map.width.value.value);
    regs_o.map.height = map_size(wrote.map.height.value.value);
    regs_o.map.wrap_u = wrote.map.wrap_u.value.value;
    regs_o.map.wrap_v = wrote.map.wrap_v.value.value;
    regs_o.displace.scale = wrote.displace.scale.value.value;
    regs_o.displace.bias = wrote.displace.bias.value.value;
    regs_o.transform.row_x[0] = wrote.transform.row_x_0.value.value;
    regs_o.transform.row_x[1] = wrote.transform.row_x_1.value.value;
    regs_o.transform.row_x[2] = wrote.transform.row_x_2.value.value;
    regs_o.transform.row_y[0] = wrote.transform.row_y_0.value.value;
    regs_o.transform.row_y[1] = wrote.transform.row_y_1.value.value;
    regs_o.transform.row_y[2] = wrote.transform.row_y_2.value.value;
    regs_o.transform.row_w[0] = wrote.transform.row_w_0.value.value;
    regs_o.transform.row_w[1] = wrote.transform.row_w_1.value.value;
    regs_o.transform.row_w[2] = wrote.transform.row_w_2.value.value;
    regs_o.transform.offset_x = {
      wrote.transform.offset_x.high.value, wrote.transform.offset_x.low.value
    };
    regs_o.transform.offset_y = {
      wrote.transform.offset_y.high.value, wrote.transform.offset_y.low.value
    };
    regs_o.transform.offset_w = {
      wrote.transform.offset_w.high.value, wrote.transform.offset_w.low.value
    };
    regs_o.transform.w_min = wrote.transform.w_min.value.value;
    regs_o.transform_normal.rotation[0][0] = wrote.transform_normal.rotation_0_0.value.value;
    regs_o.transform_normal.rotation[0][1] = wrote.transform_normal.rotation_0_1.value.value;
    regs_o.transform_normal.rotation[0][2] = wrote.transform_normal.rotation_0_2.value.value;
    regs_o.transform_normal.rotation[1][0] = wrote.transform_normal.rotation_1_0.value.value;
    regs_o.transform_normal.rotation[1][1] = wrote.transform_normal.rotation_1_1.value.value;
    regs_o.transform_normal.rotation[1][2] = wrote.transform_normal.rotation_1_2.value.value;
    regs_o.transform_normal.rotation[2][0] = wrote.transform_normal.rotation_2_0.value.value;
    regs_o.transform_normal.rotation[2][1] = wrote.transform_normal.rotation_2_1.value.value;
    regs_o.transform_normal.rotation[2][2] = wrote.transform_normal.rotation_2_2.value.value;
    regs_o.transform_normal.eye[0] = wrote.transform_normal.eye_0.value.value;
    regs_o.transform_normal.eye[1] = wrote.transform_normal.eye_1.value.value;
    regs_o.transform_normal.eye[2] = wrote.transform_normal.eye_2.value.value;
    regs_o.normal.threshold = wrote.normal.threshold.value.value;
    regs_o.summed_height.average = wrote.summed_height.average.value.value;
    regs_o.summed_height.sum_threshold = {
      wrote.summed_height.sum_threshold.high.value, wrote.summed_height.sum_threshold.low.value
    };
    regs_o.summed_height.average_threshold = wrote.summed_height.average_threshold.value.value;
    regs_o.view.threshold = wrote.view.threshold.value.value;
    regs_o.highlight.half_vector[0] = wrote.highlight.half_vector_0.value.value;
    regs_o.highlight.half_vector[1] = wrote.highlight.half_vector_1.value.value;
    regs_o.highlight.half_vector[2] = wrote.highlight.half_vector_2.value.value;
    regs_o.highlight.threshold = wrote.highlight.threshold.value.value;
    regs_o.profile.threshold = wrote.profile.threshold.value.value;
    regs_o.pass.use_nt = wrote.pass.use_nt.value.value;
    regs_o.pass.use_sht = wrote.pass.use_sht.value.value;
    regs_o.pass.use_pt = wrote.pass.use_pt.value.value;
    regs_o.pass.use_ht = wrote.pass.use_ht.value.value;
    regs_o.pass.use_vt = wrote.pass.use_vt.value.value;
    regs_o.pass.use_ct = wrote.pass.use_ct.value.value;
    regs_o.pass.max_generation = wrote.pass.max_generation.value.value[3:0];
    generation_beyond_o = wrote.pass.max_generation.value.value > 32'd15;
    regs_o.pass.cull = wrote.pass.cull.value.value;
    regs_o.queue.fifo = wrote.queue.fifo.value.value;
  end

  // The codes are listed twice, once for the documents.
  localparam logic [13:0][31:0] Documented = {
      32'(edge_engine_error__none), 32'(edge_engine_error__map_size_zero),
      32'(edge_engine_error__map_size_too_large), 32'(edge_engine_error__max_generation_too_large),
      32'(edge_engine_error__early_last), 32'(edge_engine_error__missing_last),
      32'(edge_engine_error__last_disagrees), 32'(edge_engine_error__coordinate_outside_map),
      32'(edge_engine_error__start_while_busy), 32'(edge_engine_error__queue_overflow),
      32'(edge_engine_error__map_early_last), 32'(edge_engine_error__map_missing_last),
      32'(edge_engine_error__stopped), 32'(edge_engine_error__memory_error)
  };
  localparam logic [13:0][31:0] Used = {
      32'(None), 32'(MapSizeZero), 32'(MapSizeTooLarge), 32'(MaxGenerationTooLarge),
      32'(EarlyLast), 32'(MissingLast), 32'(LastDisagrees), 32'(CoordinateOutsideMap),
      32'(StartWhileBusy), 32'(QueueOverflow), 32'(MapEarlyLast), 32'(MapMissingLast),
      32'(Stopped), 32'(MemoryError)
  };
  if (Documented != Used) begin : gen_codes
    $error("edge_engine.rdl and edge_engine_pkg.sv number the errors differently");
  end
endmodule

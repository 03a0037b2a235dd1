// edge_engine_axi: the edge engine with its maps in memory behind AXI4 buses: edge_engine.sv, one lane, and a reader at each read port.
//   parameters  as edge_engine.sv; ADDRESS_BITS up to 48; DATA_BYTES of the buses, 8 at least; OUTSTANDING beats on each, more than the
//               memory's latency and 8
//   displacement_base_i   texels, 2 bytes each;  table_base_i  words of the summed-area table, 8 bytes of which 40 bits are read
//   normal_base_i         texels of the normal map, 8 bytes of which 48 bits are read;  all row by row, constant while a mesh runs
//   m_axi_table_*, _quad_*, _place_*, _normal_*   the table; displacement of profiles, and of new vertices; the map of normals
//   aresetn               of the memories too: no beat of before may come after it
//   everything else       as edge_engine.sv; a beat that is not OKAY is its error memory_error
//
//   latency and initiation interval: a word, which is a beat, a clock and bus, so the four rectangles of an edge take 12 clocks, a sample
//   of a profile, a displacement, a normal 4, in two bursts mostly; SAT_READS_PER_CLOCK and PROFILE_SAMPLES_PER_CLOCK say only how many
//   words are asked for together. Outputs as axi_read.sv and edge_engine.sv.
//
//   edge_engine --[axi_read_maps]-- m_axi_*
module edge_engine_axi
  import formats_pkg::*;
  import surface_pkg::*;
  import memory_pkg::*;
  import edge_pkg::*;
#(
  parameter int unsigned SAT_READS_PER_CLOCK = 1,
  parameter int unsigned PROFILE_SAMPLES_PER_CLOCK = 1,
  parameter int unsigned QUEUE_DEPTH = 4096,
  parameter int unsigned MAX_GENERATION = 15,
  parameter int unsigned IN_FLIGHT = 128,
  parameter int unsigned ADDRESS_BITS = 32,
  parameter int unsigned DATA_BYTES = 8,
  parameter int unsigned OUTSTANDING = 128,
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

  output logic [ADDRESS_BITS-1:0] m_axi_table_araddr,
  output logic [7:0]              m_axi_table_arlen,
  output logic [2:0]              m_axi_table_arsize,
  output logic [1:0]              m_axi_table_arburst,
  output logic [2:0]              m_axi_table_arprot,
  output logic                    m_axi_table_arvalid,
  input  logic                    m_axi_table_arready,
  input  logic [8*DATA_BYTES-1:0] m_axi_table_rdata,
  input  logic [1:0]              m_axi_table_rresp,
  input  logic                    m_axi_table_rlast,
  input  logic                    m_axi_table_rvalid,
  output logic                    m_axi_table_rready,

  output logic [ADDRESS_BITS-1:0] m_axi_quad_araddr,
  output logic [7:0]              m_axi_quad_arlen,
  output logic [2:0]              m_axi_quad_arsize,
  output logic [1:0]              m_axi_quad_arburst,
  output logic [2:0]              m_axi_quad_arprot,
  output logic                    m_axi_quad_arvalid,
  input  logic                    m_axi_quad_arready,
  input  logic [8*DATA_BYTES-1:0] m_axi_quad_rdata,
  input  logic [1:0]              m_axi_quad_rresp,
  input  logic                    m_axi_quad_rlast,
  input  logic                    m_axi_quad_rvalid,
  output logic                    m_axi_quad_rready,

  output logic [ADDRESS_BITS-1:0] m_axi_place_araddr,
  output logic [7:0]              m_axi_place_arlen,
  output logic [2:0]              m_axi_place_arsize,
  output logic [1:0]              m_axi_place_arburst,
  output logic [2:0]              m_axi_place_arprot,
  output logic                    m_axi_place_arvalid,
  input  logic                    m_axi_place_arready,
  input  logic [8*DATA_BYTES-1:0] m_axi_place_rdata,
  input  logic [1:0]              m_axi_place_rresp,
  input  logic                    m_axi_place_rlast,
  input  logic                    m_axi_place_rvalid,
  output logic                    m_axi_place_rready,

  output logic [ADDRESS_BITS-1:0] m_axi_normal_araddr,
  output logic [7:0]              m_axi_normal_arlen,
  output logic [2:0]              m_axi_normal_arsize,
  output logic [1:0]              m_axi_normal_arburst,
  output logic [2:0]              m_axi_normal_arprot,
  output logic                    m_axi_normal_arvalid,
  input  logic                    m_axi_normal_arready,
  input  logic [8*DATA_BYTES-1:0] m_axi_normal_rdata,
  input  logic [1:0]              m_axi_normal_rresp,
  input  logic                    m_axi_normal_rlast,
  input  logic                    m_axi_normal_rvalid,
  output logic                    m_axi_normal_rready,
  // verilog_lint: waive-stop port-name-suffix

  input  logic [ADDRESS_BITS-1:0] displacement_base_i,
  input  logic [ADDRESS_BITS-1:0] table_base_i,
  input  logic [ADDRESS_BITS-1:0] normal_base_i,

  output logic       table_write_valid_o,
  input  logic       table_write_ready_i,
  output map_size_t  table_write_x_o,
  output map_size_t  table_write_y_o,
  output table_sum_t table_write_word_o,
  output logic       normal_write_valid_o,
  input  logic       normal_write_ready_i,
  output map_size_t  normal_write_x_o,
  output map_size_t  normal_write_y_o,
  output normal_t    normal_write_word_o
);
  map_size_t  map_width;
  logic       failed;

  logic table_req_valid, table_req_ready, table_rsp_valid;
  logic quad_req_valid, quad_req_ready, quad_rsp_valid;
  logic place_req_valid, place_req_ready, place_rsp_valid;
  logic normal_req_valid, normal_req_ready, normal_rsp_valid;
  table_request_t [SAT_READS_PER_CLOCK-1:0]       table_req;
  table_sum_t     [SAT_READS_PER_CLOCK-1:0]       table_rsp;
  quad_request_t  [PROFILE_SAMPLES_PER_CLOCK-1:0] quad_req;
  logic           [PROFILE_SAMPLES_PER_CLOCK-1:0] quad_req_mask;
  texel_quad_t    [PROFILE_SAMPLES_PER_CLOCK-1:0] quad_rsp;
  quad_request_t place_req, normal_req;
  texel_quad_t   place_rsp;
  normal_quad_t  normal_rsp;

  edge_engine #(
    .LANES(1),
    .SAT_READS_PER_CLOCK(SAT_READS_PER_CLOCK),
    .PROFILE_SAMPLES_PER_CLOCK(PROFILE_SAMPLES_PER_CLOCK),
    .QUEUE_DEPTH(QUEUE_DEPTH),
    .MAX_GENERATION(MAX_GENERATION),
    .IN_FLIGHT(IN_FLIGHT)
  ) i_engine (
    .aclk,
    .aresetn,
    .s_axil_awaddr, .s_axil_awprot, .s_axil_awvalid, .s_axil_awready, .s_axil_wdata,
    .s_axil_wstrb, .s_axil_wvalid, .s_axil_wready, .s_axil_bresp, .s_axil_bvalid, .s_axil_bready,
    .s_axil_araddr, .s_axil_arprot, .s_axil_arvalid, .s_axil_arready, .s_axil_rdata,
    .s_axil_rresp, .s_axil_rvalid, .s_axil_rready,
    .s_axis_tdata, .s_axis_tlast, .s_axis_tvalid, .s_axis_tready,
    .m_axis_tdata, .m_axis_tlast, .m_axis_tvalid, .m_axis_tready,
    .s_axis_map_tdata, .s_axis_map_tlast, .s_axis_map_tvalid, .s_axis_map_tready,
    .table_write_valid_o, .table_write_ready_i, .table_write_x_o, .table_write_y_o,
    .table_write_word_o,
    .normal_write_valid_o, .normal_write_ready_i, .normal_write_x_o, .normal_write_y_o,
    .normal_write_word_o,
    .table_req_valid_o(table_req_valid),
    .table_req_ready_i(table_req_ready),
    .table_req_o(table_req),
    .table_rsp_valid_i(table_rsp_valid),
    .table_rsp_i(table_rsp),
    .quad_req_valid_o(quad_req_valid),
    .quad_req_ready_i(quad_req_ready),
    .quad_req_o(quad_req),
    .quad_req_mask_o(quad_req_mask),
    .quad_rsp_valid_i(quad_rsp_valid),
    .quad_rsp_i(quad_rsp),
    .place_req_valid_o(place_req_valid),
    .place_req_ready_i(place_req_ready),
    .place_req_o(place_req),
    .place_rsp_valid_i(place_rsp_valid),
    .place_rsp_i(place_rsp),
    .normal_req_valid_o(normal_req_valid),
    .normal_req_ready_i(normal_req_ready),
    .normal_req_o(normal_req),
    .normal_rsp_valid_i(normal_rsp_valid),
    .normal_rsp_i(normal_rsp),
    .map_width_o(map_width),
    .memory_error_i(failed)
  );

  axi_read_maps #(
    .Reads(SAT_READS_PER_CLOCK),
    .Samples(PROFILE_SAMPLES_PER_CLOCK),
    .AddressBits(ADDRESS_BITS),
    .DataBytes(DATA_BYTES),
    .Outstanding(OUTSTANDING)
  ) i_maps (
    .aclk,
    .aresetn,
    .displacement_base_i,
    .table_base_i,
    .normal_base_i,
    .width_i(map_width),
    .error_o(failed),
    .table_req_valid_i(table_req_valid),
    .table_req_ready_o(table_req_ready),
    .table_req_i(table_req),
    .table_rsp_valid_o(table_rsp_valid),
    .table_rsp_o(table_rsp),
    .quad_req_valid_i(quad_req_valid),
    .quad_req_ready_o(quad_req_ready),
    .quad_req_i(quad_req),
    .quad_req_mask_i(quad_req_mask),
    .quad_rsp_valid_o(quad_rsp_valid),
    .quad_rsp_o(quad_rsp),
    .place_req_valid_i(place_req_valid),
    .place_req_ready_o(place_req_ready),
    .place_req_i(place_req),
    .place_rsp_valid_o(place_rsp_valid),
    .place_rsp_o(place_rsp),
    .normal_req_valid_i(normal_req_valid),
    .normal_req_ready_o(normal_req_ready),
    .normal_req_i(normal_req),
    .normal_rsp_valid_o(normal_rsp_valid),
    .normal_rsp_o(normal_rsp),
    .m_axi_table_araddr, .m_axi_table_arlen, .m_axi_table_arsize, .m_axi_table_arburst,
    .m_axi_table_arprot, .m_axi_table_arvalid, .m_axi_table_arready, .m_axi_table_rdata,
    .m_axi_table_rresp, .m_axi_table_rlast, .m_axi_table_rvalid, .m_axi_table_rready,
    .m_axi_quad_araddr, .m_axi_quad_arlen, .m_axi_quad_arsize, .m_axi_quad_arburst,
    .m_axi_quad_arprot, .m_axi_quad_arvalid, .m_axi_quad_arready, .m_axi_quad_rdata,
    .m_axi_quad_rresp, .m_axi_quad_rlast, .m_axi_quad_rvalid, .m_axi_quad_rready,
    .m_axi_place_araddr, .m_axi_place_arlen, .m_axi_place_arsize, .m_axi_place_arburst,
    .m_axi_place_arprot, .m_axi_place_arvalid, .m_axi_place_arready, .m_axi_place_rdata,
    .m_axi_place_rresp, .m_axi_place_rlast, .m_axi_place_rvalid, .m_axi_place_rready,
    .m_axi_normal_araddr, .m_axi_normal_arlen, .m_axi_normal_arsize, .m_axi_normal_arburst,
    .m_axi_normal_arprot, .m_axi_normal_arvalid, .m_axi_normal_arready, .m_axi_normal_rdata,
    .m_axi_normal_rresp, .m_axi_normal_rlast, .m_axi_normal_rvalid, .m_axi_normal_rready
  );
endmodule

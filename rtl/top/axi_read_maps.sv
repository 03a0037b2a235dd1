// axi_read_maps: serves the four read ports of the maps of one lane (memory_pkg.sv), each over an AXI4 bus of its own.
//   parameters  Reads words of the table and Samples quads of the profile a request; the rest as axi_read.sv
//   in    displacement_base_i   of texels, 2 bytes each, for quad and place;  table_base_i  of words of 8 bytes, of which 40 bits are read
//         normal_base_i         of 8 bytes, of which 48 bits are read;  width_i  texels in a row; all constant while a request is inside
//         quad_req_mask_i       which quads of the profile are wanted: the others are not fetched
//   out   error_o               for one clock with an answer: a beat of it was not OKAY
//
//   m_axi_quad, _place, _normal   a row of a quad is a burst of two beats where its columns are neighbours (axi_read_quads.sv); of the
//                         table each word is a burst: a rectangle's corners do not lie beside each other
//
//   latency 10 and the memory's; initiation interval: a clock for each word that is read, at least one a request. Registered: as
//   axi_read.sv, and a gate at error_o.
//
//   table  --[axi_read]-------- m_axi_table       place  --[axi_read_quads]-- m_axi_place
//   quad   --[axi_read]-------- m_axi_quad        normal --[axi_read_quads]-- m_axi_normal
module axi_read_maps
  import formats_pkg::*;
  import surface_pkg::*;
  import memory_pkg::*;
#(
  parameter int unsigned Reads = 1,
  parameter int unsigned Samples = 1,
  parameter int unsigned AddressBits = 32,
  parameter int unsigned DataBytes = 8,
  parameter int unsigned Outstanding = 128
) (
  // verilog_lint: waive-start port-name-suffix  the bus standard's own names
  input  logic aclk,
  input  logic aresetn,

  output logic [AddressBits-1:0] m_axi_table_araddr,
  output logic [7:0]              m_axi_table_arlen,
  output logic [2:0]              m_axi_table_arsize,
  output logic [1:0]              m_axi_table_arburst,
  output logic [2:0]              m_axi_table_arprot,
  output logic                    m_axi_table_arvalid,
  input  logic                    m_axi_table_arready,
  input  logic [8*DataBytes-1:0] m_axi_table_rdata,
  input  logic [1:0]              m_axi_table_rresp,
  input  logic                    m_axi_table_rlast,
  input  logic                    m_axi_table_rvalid,
  output logic                    m_axi_table_rready,

  output logic [AddressBits-1:0] m_axi_quad_araddr,
  output logic [7:0]              m_axi_quad_arlen,
  output logic [2:0]              m_axi_quad_arsize,
  output logic [1:0]              m_axi_quad_arburst,
  output logic [2:0]              m_axi_quad_arprot,
  output logic                    m_axi_quad_arvalid,
  input  logic                    m_axi_quad_arready,
  input  logic [8*DataBytes-1:0] m_axi_quad_rdata,
  input  logic [1:0]              m_axi_quad_rresp,
  input  logic                    m_axi_quad_rlast,
  input  logic                    m_axi_quad_rvalid,
  output logic                    m_axi_quad_rready,

  output logic [AddressBits-1:0] m_axi_place_araddr,
  output logic [7:0]              m_axi_place_arlen,
  output logic [2:0]              m_axi_place_arsize,
  output logic [1:0]              m_axi_place_arburst,
  output logic [2:0]              m_axi_place_arprot,
  output logic                    m_axi_place_arvalid,
  input  logic                    m_axi_place_arready,
  input  logic [8*DataBytes-1:0] m_axi_place_rdata,
  input  logic [1:0]              m_axi_place_rresp,
  input  logic                    m_axi_place_rlast,
  input  logic                    m_axi_place_rvalid,
  output logic                    m_axi_place_rready,

  output logic [AddressBits-1:0] m_axi_normal_araddr,
  output logic [7:0]              m_axi_normal_arlen,
  output logic [2:0]              m_axi_normal_arsize,
  output logic [1:0]              m_axi_normal_arburst,
  output logic [2:0]              m_axi_normal_arprot,
  output logic                    m_axi_normal_arvalid,
  input  logic                    m_axi_normal_arready,
  input  logic [8*DataBytes-1:0] m_axi_normal_rdata,
  input  logic [1:0]              m_axi_normal_rresp,
  input  logic                    m_axi_normal_rlast,
  input  logic                    m_axi_normal_rvalid,
  output logic                    m_axi_normal_rready,
  // verilog_lint: waive-stop port-name-suffix

  input  logic [AddressBits-1:0] displacement_base_i,
  input  logic [AddressBits-1:0] table_base_i,
  input  logic [AddressBits-1:0] normal_base_i,
  input  map_size_t              width_i,
  output logic                   error_o,

  input  logic                       table_req_valid_i,
  output logic                       table_req_ready_o,
  input  table_request_t [Reads-1:0] table_req_i,
  output logic                       table_rsp_valid_o,
  output table_sum_t     [Reads-1:0] table_rsp_o,

  input  logic                        quad_req_valid_i,
  output logic                        quad_req_ready_o,
  input  quad_request_t [Samples-1:0] quad_req_i,
  input  logic          [Samples-1:0] quad_req_mask_i,
  output logic                        quad_rsp_valid_o,
  output texel_quad_t   [Samples-1:0] quad_rsp_o,

  input  logic          place_req_valid_i,
  output logic          place_req_ready_o,
  input  quad_request_t place_req_i,
  output logic          place_rsp_valid_o,
  output texel_quad_t   place_rsp_o,

  input  logic          normal_req_valid_i,
  output logic          normal_req_ready_o,
  input  quad_request_t normal_req_i,
  output logic          normal_rsp_valid_o,
  output normal_quad_t  normal_rsp_o
);
  logic [3:0] failed;
  assign error_o = |failed;

  axi_read #(
    .Words(Reads),
    .WordBytes(8),
    .WordBits($bits(table_sum_t)),
    .AddressBits(AddressBits),
    .DataBytes(DataBytes),
    .Outstanding(Outstanding)
  ) i_table (
    .aclk,
    .aresetn,
    .base_i(table_base_i),
    .width_i(width_i),
    .error_o(failed[0]),
    .req_valid_i(table_req_valid_i),
    .req_ready_o(table_req_ready_o),
    .req_i(table_req_i),
    .rsp_valid_o(table_rsp_valid_o),
    .rsp_o(table_rsp_o),
    .m_axi_araddr(m_axi_table_araddr),
    .m_axi_arlen(m_axi_table_arlen),
    .m_axi_arsize(m_axi_table_arsize),
    .m_axi_arburst(m_axi_table_arburst),
    .m_axi_arprot(m_axi_table_arprot),
    .m_axi_arvalid(m_axi_table_arvalid),
    .m_axi_arready(m_axi_table_arready),
    .m_axi_rdata(m_axi_table_rdata),
    .m_axi_rresp(m_axi_table_rresp),
    .m_axi_rlast(m_axi_table_rlast),
    .m_axi_rvalid(m_axi_table_rvalid),
    .m_axi_rready(m_axi_table_rready)
  );

  // The samples of a clock that nobody wants are not fetched.
  table_request_t [4*Samples-1:0] quad_words;
  for (genvar i = 0; i < Samples; i++) begin : gen_sample
    for (genvar word = 0; word < 4; word++) begin : gen_word
      assign quad_words[4*i+word] = '{
          y: quad_req_i[i].y[word/2],
          x: quad_req_i[i].x[word%2],
          read: quad_req_mask_i[i]
      };
    end
  end
  axi_read #(
    .Words(4 * Samples),
    .WordBytes(2),
    .AddressBits(AddressBits),
    .DataBytes(DataBytes),
    .Outstanding(Outstanding),
    .Pairs(1'b1)
  ) i_quad (
    .aclk,
    .aresetn,
    .base_i(displacement_base_i),
    .width_i(width_i),
    .error_o(failed[1]),
    .req_valid_i(quad_req_valid_i),
    .req_ready_o(quad_req_ready_o),
    .req_i(quad_words),
    .rsp_valid_o(quad_rsp_valid_o),
    .rsp_o(quad_rsp_o),
    .m_axi_araddr(m_axi_quad_araddr),
    .m_axi_arlen(m_axi_quad_arlen),
    .m_axi_arsize(m_axi_quad_arsize),
    .m_axi_arburst(m_axi_quad_arburst),
    .m_axi_arprot(m_axi_quad_arprot),
    .m_axi_arvalid(m_axi_quad_arvalid),
    .m_axi_arready(m_axi_quad_arready),
    .m_axi_rdata(m_axi_quad_rdata),
    .m_axi_rresp(m_axi_quad_rresp),
    .m_axi_rlast(m_axi_quad_rlast),
    .m_axi_rvalid(m_axi_quad_rvalid),
    .m_axi_rready(m_axi_quad_rready)
  );

  axi_read_quads #(
    .WordBytes(2),
    .AddressBits(AddressBits),
    .DataBytes(DataBytes),
    .Outstanding(Outstanding)
  ) i_place (
    .aclk,
    .aresetn,
    .base_i(displacement_base_i),
    .width_i(width_i),
    .error_o(failed[2]),
    .req_valid_i(place_req_valid_i),
    .req_ready_o(place_req_ready_o),
    .req_i(place_req_i),
    .rsp_valid_o(place_rsp_valid_o),
    .rsp_o(place_rsp_o),
    .m_axi_araddr(m_axi_place_araddr),
    .m_axi_arlen(m_axi_place_arlen),
    .m_axi_arsize(m_axi_place_arsize),
    .m_axi_arburst(m_axi_place_arburst),
    .m_axi_arprot(m_axi_place_arprot),
    .m_axi_arvalid(m_axi_place_arvalid),
    .m_axi_arready(m_axi_place_arready),
    .m_axi_rdata(m_axi_place_rdata),
    .m_axi_rresp(m_axi_place_rresp),
    .m_axi_rlast(m_axi_place_rlast),
    .m_axi_rvalid(m_axi_place_rvalid),
    .m_axi_rready(m_axi_place_rready)
  );

  axi_read_quads #(
    .WordBytes(8),
    .WordBits($bits(normal_t)),
    .AddressBits(AddressBits),
    .DataBytes(DataBytes),
    .Outstanding(Outstanding)
  ) i_normal (
    .aclk,
    .aresetn,
    .base_i(normal_base_i),
    .width_i(width_i),
    .error_o(failed[3]),
    .req_valid_i(normal_req_valid_i),
    .req_ready_o(normal_req_ready_o),
    .req_i(normal_req_i),
    .rsp_valid_o(normal_rsp_valid_o),
    .rsp_o(normal_rsp_o),
    .m_axi_araddr(m_axi_normal_araddr),
    .m_axi_arlen(m_axi_normal_arlen),
    .m_axi_arsize(m_axi_normal_arsize),
    .m_axi_arburst(m_axi_normal_arburst),
    .m_axi_arprot(m_axi_normal_arprot),
    .m_axi_arvalid(m_axi_normal_arvalid),
    .m_axi_arready(m_axi_normal_arready),
    .m_axi_rdata(m_axi_normal_rdata),
    .m_axi_rresp(m_axi_normal_rresp),
    .m_axi_rlast(m_axi_normal_rlast),
    .m_axi_rvalid(m_axi_normal_rvalid),
    .m_axi_rready(m_axi_normal_rready)
  );
endmodule

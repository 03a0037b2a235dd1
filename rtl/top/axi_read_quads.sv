// axi_read_quads: serves a port that asks for 2 x 2 words (memory_pkg.sv) from memory behind an AXI4
// bus: texels of two bytes, normals of eight.
//   rsp_o[row][column]; the rest, and all parameters, as axi_read.sv, which does it
//
//   m_axi             a row whose columns lie beside each other is one burst of two beats, so a quad
//                     within the map two addresses; a row around the seam, of a clamped column, or
//                     across 4 KB is two bursts of one
//
//   latency 10 and the memory's, initiation interval 4: four beats a request
module axi_read_quads
  import formats_pkg::*;
  import memory_pkg::*;
#(
  parameter int unsigned WordBytes = 2,
  parameter int unsigned WordBits = 8 * WordBytes,
  parameter int unsigned AddressBits = 32,
  parameter int unsigned DataBytes = 8,
  parameter int unsigned Outstanding = 128
) (
  // verilog_lint: waive-start port-name-suffix  the bus standard's own names
  input  logic aclk,
  input  logic aresetn,

  input  logic [AddressBits-1:0] base_i,
  input  map_size_t              width_i,
  output logic                   error_o,

  input  logic                          req_valid_i,
  output logic                          req_ready_o,
  input  quad_request_t                 req_i,
  output logic                          rsp_valid_o,
  output logic [1:0][1:0][WordBits-1:0] rsp_o,

  output logic [AddressBits-1:0] m_axi_araddr,
  output logic [7:0]             m_axi_arlen,
  output logic [2:0]             m_axi_arsize,
  output logic [1:0]             m_axi_arburst,
  output logic [2:0]             m_axi_arprot,
  output logic                   m_axi_arvalid,
  input  logic                   m_axi_arready,
  input  logic [8*DataBytes-1:0] m_axi_rdata,
  input  logic [1:0]             m_axi_rresp,
  input  logic                   m_axi_rlast,
  input  logic                   m_axi_rvalid,
  output logic                   m_axi_rready
  // verilog_lint: waive-stop port-name-suffix
);
  table_request_t [3:0] words;
  for (genvar row = 0; row < 2; row++) begin : gen_row
    for (genvar column = 0; column < 2; column++) begin : gen_column
      assign words[2*row+column] = '{y: req_i.y[row], x: req_i.x[column], read: 1'b1};
    end
  end
  axi_read #(
    .Words(4),
    .WordBytes(WordBytes),
    .WordBits(WordBits),
    .AddressBits(AddressBits),
    .DataBytes(DataBytes),
    .Outstanding(Outstanding),
    .Pairs(1'b1)
  ) i_read (
    .aclk,
    .aresetn,
    .base_i,
    .width_i,
    .error_o,
    .req_valid_i,
    .req_ready_o,
    .req_i(words),
    .rsp_valid_o,
    .rsp_o,
    .m_axi_araddr,
    .m_axi_arlen,
    .m_axi_arsize,
    .m_axi_arburst,
    .m_axi_arprot,
    .m_axi_arvalid,
    .m_axi_arready,
    .m_axi_rdata,
    .m_axi_rresp,
    .m_axi_rlast,
    .m_axi_rvalid,
    .m_axi_rready
  );
endmodule

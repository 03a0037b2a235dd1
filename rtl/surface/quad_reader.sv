// quad_reader: asks a map memory for the quad around each texture coordinate, and keeps the fractions until the answer comes.
//   in    in_*        u
//   out   fraction_o  of u and v, of the quad that is answered at this clock: valid with the port's rsp_valid
//   in    rsp_valid_i the memory answers;  done_i: a place for an answer has become free
//   port  req_*       to the memory
//
//   latency 5 from in to req, initiation interval 1; all outputs registered, in_ready_o the AND of two comparisons of registers.
//   InFlight words at most are between in and done_i: whoever takes the answers has as many places, so that no answer is refused.
//
//   u --[map_address]--[FIFO]--> req        f --[FIFO of InFlight]--> fraction_o
module quad_reader
  import formats_pkg::*;
  import surface_pkg::*;
  import memory_pkg::*;
#(
  parameter int unsigned InFlight = 128
) (
  input  logic            clk_i,
  input  logic            rst_ni,
  input  map_regs_t       map_i,
  input  logic            in_valid_i,
  output logic            in_ready_o,
  input  map_address_in_t in_i,
  output logic            req_valid_o,
  input  logic            req_ready_i,
  output quad_request_t   req_o,
  input  logic            rsp_valid_i,
  output fraction_t [1:0] fraction_o,
  input  logic            done_i
);
  localparam int unsigned CountBits = $clog2(InFlight + 1);

  logic [CountBits-1:0] reserved_q;
  logic free, pipe_ready, take;
  assign free = reserved_q != CountBits'(InFlight);
  assign in_ready_o = free && pipe_ready;
  assign take = in_valid_i && in_ready_o;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) reserved_q <= '0;
    else reserved_q <= reserved_q + CountBits'(take) - CountBits'(done_i);
  end

  map_address_out_t address;
  map_address i_address (.clk_i, .map_i, .in_i, .out_o(address));
  quad_request_t request;
  assign request = '{y: address.y, x: address.x};
  logic unused_fraction;
  assign unused_fraction = ^address.f;
  stream_pipe #(.T(quad_request_t), .Latency(2)) i_request (
    .clk_i,
    .rst_ni,
    .in_valid_i(in_valid_i && free),
    .in_ready_o(pipe_ready),
    .data_i(request),
    .out_valid_o(req_valid_o),
    .out_ready_i(req_ready_i),
    .out_o(req_o)
  );

  // A fraction is there three clocks after its word was taken, the answer six at the earliest.
  fraction_t [1:0] fraction;
  assign fraction = {in_i.u[1][CoordinateFraction-1:0], in_i.u[0][CoordinateFraction-1:0]};
  logic unused_ready, unused_valid;
  logic [CountBits-1:0] unused_count;
  stream_fifo #(.T(fraction_t [1:0]), .Depth(InFlight)) i_fraction (
    .clk_i,
    .rst_ni,
    .in_valid_i(take),
    .in_ready_o(unused_ready),
    .in_i(fraction),
    .out_valid_o(unused_valid),
    .out_ready_i(rsp_valid_i),
    .out_o(fraction_o),
    .count_o(unused_count)
  );
endmodule

// edge_engine_mesh: a mesh from its start to its end: edge_engine_control.sv, which begins and refuses, and edge_engine_input.sv, which
// lets its base triangles in and finds what is wrong with its packet.
//   in    max_generation_i .. memory_error_i   as edge_engine_control.sv;  in_*  the packet, as edge_engine_input.sv
//   out   regs_o                   of the mesh that runs, constant until it is done
//         begin_o, end_o           for one clock: the engine begins; its input is over
//         out_*                    base triangles to the engine
//         busy_o, done_o, swallowing_o, error_code_o   for the state register
//
//   latency as the two modules say; initiation interval of a mesh and of its triangles, and what is registered, too.
module edge_engine_mesh
  import formats_pkg::*;
  import edge_pkg::*;
  import edge_engine_pkg::*;
(
  input  logic           clk_i,
  input  logic           rst_ni,
  input  generation_t    max_generation_i,
  input  control_t       control_i,
  input  engine_regs_t   regs_i,
  input  logic           generation_beyond_i,
  input  logic [31:0]    expected_i,
  input  logic           engine_done_i,
  input  logic           overflow_i,
  input  error_code_e    map_error_i,
  input  logic           memory_error_i,
  input  logic           in_valid_i,
  output logic           in_ready_o,
  input  base_triangle_t in_i,
  input  logic           in_last_i,

  output engine_regs_t   regs_o,
  output logic           begin_o,
  output logic           end_o,
  output logic           out_valid_o,
  input  logic           out_ready_i,
  output base_triangle_t out_o,
  output logic           busy_o,
  output logic           done_o,
  output logic           swallowing_o,
  output error_code_e    error_code_o
);
  logic              over, refuse, close, stop;
  logic [31:0]       expected;
  coordinate_t [1:0] limit;
  error_code_e       input_error;
  edge_engine_control i_control (
    .clk_i,
    .rst_ni,
    .max_generation_i,
    .control_i,
    .regs_i,
    .generation_beyond_i,
    .expected_i,
    .engine_done_i,
    .overflow_i,
    .input_over_i(over),
    .input_error_i(input_error),
    .map_error_i,
    .memory_error_i,
    .regs_o,
    .expected_o(expected),
    .limit_o(limit),
    .begin_o,
    .refuse_o(refuse),
    .close_o(close),
    .stop_o(stop),
    .busy_o,
    .done_o,
    .error_code_o
  );
  edge_engine_input i_input (
    .clk_i,
    .rst_ni,
    .begin_i(begin_o),
    .refuse_i(refuse),
    .close_i(close),
    .stop_i(stop),
    .expected_i(expected),
    .limit_i(limit),
    .in_valid_i,
    .in_ready_o,
    .in_i,
    .in_last_i,
    .out_valid_o,
    .out_ready_i,
    .out_o,
    .end_o,
    .over_o(over),
    .swallowing_o,
    .error_o(input_error)
  );
endmodule

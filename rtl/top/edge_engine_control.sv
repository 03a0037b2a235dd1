// edge_engine_control: begins a mesh and sees it to its end: shadows its registers, refuses what the engine cannot run with, and keeps
// the first error for the host.
//   in    max_generation_i   of the build
//         control_i          start, stop, clear_error, each for one clock
//         regs_i, expected_i as the host wrote them; generation_beyond_i: a max_generation that regs_i has no room for
//         engine_done_i, overflow_i       of the engine
//         input_over_i, input_error_i     no more is to come of the packet; an error found in it, for one clock
//         map_error_i                     an error of the builders of maps, for one clock
//         memory_error_i                  an answer of a map memory was none, for one clock
//   out   regs_o, expected_o  taken over at start, constant until done; limit_o: the largest coordinates they allow
//         begin_o             for one clock: engine and input begin; with refuse_o no triangle is let in
//         close_o             for one clock: the host has seen an error, or begins anew: nothing more is swallowed; at once, so that no
//                             word is swallowed that comes after the host's write was answered
//         stop_o              for one clock, once the mesh runs: its packet is to end
//         busy_o, done_o, error_code_o
//
//   latency 2 from start to begin_o and limit_o, 1 to the other outputs, 1 from stop to stop_o once the mesh runs, which it does 4 clocks
//   after its start; initiation interval: a mesh. All outputs but close_o are registered, or a gate from registers.
//   A mesh that is refused begins too, without triangles, so that every start but one while busy puts one packet out.
module edge_engine_control
  import formats_pkg::*;
  import edge_pkg::*;
  import edge_engine_pkg::*;
(
  input  logic               clk_i,
  input  logic               rst_ni,
  input  generation_t        max_generation_i,
  input  control_t           control_i,
  input  engine_regs_t       regs_i,
  input  logic               generation_beyond_i,
  input  logic [31:0]        expected_i,
  input  logic               engine_done_i,
  input  logic               overflow_i,
  input  logic               input_over_i,
  input  error_code_e        input_error_i,
  input  error_code_e        map_error_i,
  input  logic               memory_error_i,
  output engine_regs_t       regs_o,
  output logic [31:0]        expected_o,
  output coordinate_t [1:0]  limit_o,
  output logic               begin_o,
  output logic               refuse_o,
  output logic               close_o,
  output logic               stop_o,
  output logic               busy_o,
  output logic               done_o,
  output error_code_e        error_code_o
);
  typedef enum logic [2:0] {
    Idle,
    Load,
    Begin,
    Started,
    Running
  } phase_e;
  phase_e phase_q, next_phase;

  logic start, ends;
  assign start = control_i.start && phase_q == Idle;
  assign close_o = start || control_i.clear_error;
  assign ends = phase_q == Running && engine_done_i && input_over_i;
  always_comb begin
    next_phase = phase_q;
    unique case (phase_q)
      Idle:    if (start) next_phase = Load;
      Load:    next_phase = Begin;
      Begin:   next_phase = Started;
      Started: next_phase = Running;
      Running: if (ends) next_phase = Idle;
      default: next_phase = Idle;
    endcase
  end

  // What the registers are worth, known with busy_o; in Load what they allow.
  error_code_e checked;
  always_comb begin
    checked = map_error(regs_i.map.width, regs_i.map.height);
    if (checked == None &&
        (generation_beyond_i || regs_i.pass.max_generation > max_generation_i))
      checked = MaxGenerationTooLarge;
  end
  always_ff @(posedge clk_i) begin
    if (start) begin
      regs_o <= regs_i;
      expected_o <= expected_i;
      refuse_o <= checked != None;
    end
    limit_o[0] <= coordinate_limit(regs_o.map.width, regs_o.map.wrap_u);
    limit_o[1] <= coordinate_limit(regs_o.map.height, regs_o.map.wrap_v);
  end

  // A stop waits for the mesh to run.
  logic stop_q;
  assign stop_o = stop_q && phase_q == Running;

  // What went wrong in this clock, and whether it is the first.
  logic        overflow_q;
  error_code_e wrong;
  always_comb begin
    wrong = map_error_i;
    if (memory_error_i) wrong = MemoryError;
    if (control_i.start && phase_q != Idle) wrong = StartWhileBusy;
    if (overflow_i && !overflow_q) wrong = QueueOverflow;
    if (input_error_i != None) wrong = input_error_i;
    if (start && checked != None) wrong = checked;
  end
  always_ff @(posedge clk_i) begin
    overflow_q <= overflow_i;
    if (!rst_ni) begin
      phase_q <= Idle;
      stop_q <= 1'b0;
      begin_o <= 1'b0;
      busy_o <= 1'b0;
      done_o <= 1'b0;
      error_code_o <= None;
    end else begin
      phase_q <= next_phase;
      stop_q <= next_phase != Idle && (control_i.stop || (stop_q && !stop_o));
      begin_o <= phase_q == Load;
      busy_o <= next_phase != Idle;
      if (start) done_o <= 1'b0;
      else if (ends) done_o <= 1'b1;
      if (start || control_i.clear_error || error_code_o == None) error_code_o <= wrong;
    end
  end
endmodule

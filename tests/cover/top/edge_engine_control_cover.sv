// edge_engine_control_cover: every error that the host can be told, a second error behind the first, and a stop that waits for its mesh.
//   bound into edge_engine_control
module edge_engine_control_cover
  import edge_engine_pkg::*;
(
  input logic        clk_i,
  input logic        rst_ni,
  input error_code_e wrong,
  input error_code_e error_code_o,
  input logic        stop_q,
  input logic        stop_o,
  input control_t    control_i
);
  error_code_e first;
  assign first = rst_ni && error_code_o == None ? wrong : None;
  map_size_zero: cover property (@(posedge clk_i) first == MapSizeZero);
  map_size_too_large: cover property (@(posedge clk_i) first == MapSizeTooLarge);
  max_generation_too_large: cover property (@(posedge clk_i) first == MaxGenerationTooLarge);
  early_last: cover property (@(posedge clk_i) first == EarlyLast);
  missing_last: cover property (@(posedge clk_i) first == MissingLast);
  last_disagrees: cover property (@(posedge clk_i) first == LastDisagrees);
  coordinate_outside_map: cover property (@(posedge clk_i) first == CoordinateOutsideMap);
  start_while_busy: cover property (@(posedge clk_i) first == StartWhileBusy);
  queue_overflow: cover property (@(posedge clk_i) first == QueueOverflow);
  map_early_last: cover property (@(posedge clk_i) first == MapEarlyLast);
  map_missing_last: cover property (@(posedge clk_i) first == MapMissingLast);
  stopped: cover property (@(posedge clk_i) first == Stopped);
  memory_error: cover property (@(posedge clk_i) first == MemoryError);
  error_behind_another: cover property (@(posedge clk_i) rst_ni && error_code_o != None
                                        && wrong != None && !control_i.start);
  stop_waits: cover property (@(posedge clk_i) rst_ni && stop_q && !stop_o);
endmodule

bind edge_engine_control edge_engine_control_cover i_cover (.*);

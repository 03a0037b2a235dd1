// edge_dispatch: sends what is asked of a triangle into the lanes, an edge (or base vertex) a clock and lane, and the triangle itself into
// the flight that waits for the answers.
//   Lanes = 1  edges follow each other in the lane, settled ones leave no gap;  Lanes = 3  edge i goes to lane i, a triangle a clock
//
//   contract: the loop over the edges in step() of hls/edge/engine.hpp
//   latency 0: what it sends is a choice from the word at its input; initiation interval: what is asked of a triangle over the lanes, a
//   clock at least. Registered: what was sent; no output. in_ready_o, and with three lanes the valids, depend on the readies of lanes and
//   flight, which are registers'.
module edge_dispatch
  import edge_pkg::*;
  import lane_pkg::*;
  import engine_pkg::*;
#(
  parameter int unsigned Lanes = 1
) (
  input  logic                 clk_i,
  input  logic                 rst_ni,
  input  logic                 in_valid_i,
  output logic                 in_ready_o,
  input  flight_t              in_i,
  output logic                 flight_valid_o,
  input  logic                 flight_ready_i,
  output flight_t              flight_o,
  output logic     [Lanes-1:0] lane_valid_o,
  input  logic     [Lanes-1:0] lane_ready_i,
  output lane_in_t [Lanes-1:0] lane_o
);
  lane_in_t [2:0] work;
  for (genvar i = 0; i < 3; i++) begin : gen_edge
    assign work[i] = '{
        b: edge_end(in_i.t.v[(i+1)%3]),
        a: edge_end(in_i.t.v[i]),
        generation: in_i.t.generation[i],
        place: in_i.place
    };
  end

  assign flight_o = in_i;

  if (Lanes == 3) begin : gen_three
    logic [2:0] lanes_ready;
    logic go;
    assign lanes_ready = lane_ready_i | ~in_i.ask;
    assign go = in_valid_i && flight_ready_i && (&lanes_ready);
    assign in_ready_o = flight_ready_i && (&lanes_ready);
    assign flight_valid_o = go;
    assign lane_valid_o = in_i.ask & {3{go}};
    assign lane_o = work;
    logic unused_clk;
    assign unused_clk = clk_i ^ rst_ni;
  end else begin : gen_one
    // Edges of the triangle at the head that were sent; it has entered the flight with the first.
    // chosen is kept as it is: without that synthesis finds it anew for every bit of the edge.
    logic [2:0] sent_q, left;
    (* keep *) logic [2:0] chosen;
    logic started_q, send, last;
    assign left = in_i.ask & ~sent_q;
    assign chosen = left & (~left + 3'd1);
    assign last = left == chosen;
    assign lane_valid_o[0] = in_valid_i && left != '0 && (started_q || flight_ready_i);
    assign send = lane_valid_o[0] && lane_ready_i[0];
    assign in_ready_o = last && (left == '0 || lane_ready_i[0]) && (started_q || flight_ready_i);
    assign flight_valid_o = in_valid_i && !started_q && (send || left == '0);
    always_comb begin
      lane_o[0] = '0;
      for (int i = 0; i < 3; i++) lane_o[0] |= {$bits(lane_in_t){chosen[i]}} & work[i];
    end
    always_ff @(posedge clk_i) begin
      if (!rst_ni) begin
        sent_q <= '0;
        started_q <= 1'b0;
      end else if (in_valid_i && in_ready_o) begin
        sent_q <= '0;
        started_q <= 1'b0;
      end else if (send) begin
        sent_q <= sent_q | chosen;
        started_q <= 1'b1;
      end
    end
  end
endmodule

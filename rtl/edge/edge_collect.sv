// edge_collect: gathers what the lanes answer about the triangle at the head of the flight, and hands both on when all is there.
//   Lanes = 1  one answer a clock;  Lanes = 3  a triangle a clock
//   out_o  the triangle, which edges split and where; place: a base triangle whose vertices are m
//
//   contract: the loop over the edges in step() of hls/edge/engine.hpp
//   latency 0: the last answer passes straight on; initiation interval: the answers of a triangle over the lanes, a clock at least.
//   Registered: the answers kept; no output. The readies depend on out_ready_i, which is a FIFO's.
module edge_collect
  import surface_pkg::*;
  import edge_pkg::*;
  import lane_pkg::*;
  import engine_pkg::*;
#(
  parameter int unsigned Lanes = 1
) (
  input  logic                   clk_i,
  input  logic                   rst_ni,
  input  logic                   flight_valid_i,
  output logic                   flight_ready_o,
  input  flight_t                flight_i,
  input  logic       [Lanes-1:0] lane_valid_i,
  output logic       [Lanes-1:0] lane_ready_o,
  input  lane_out_t  [Lanes-1:0] lane_i,
  output logic                   out_valid_o,
  input  logic                   out_ready_i,
  output collected_t             out_o
);
  assign out_o.place = flight_i.place;
  assign out_o.t.t = flight_i.t;

  if (Lanes == 3) begin : gen_three
    assign out_valid_o = flight_valid_i && (&(lane_valid_i | ~flight_i.ask));
    assign flight_ready_o = out_valid_o && out_ready_i;
    assign lane_ready_o = flight_i.ask & {3{flight_ready_o}};
    for (genvar i = 0; i < 3; i++) begin : gen_edge
      assign out_o.t.split[i] = flight_i.ask[i] && lane_i[i].split;
      assign out_o.t.m[i] = lane_i[i].m;
    end
    logic unused_clk;
    assign unused_clk = clk_i ^ rst_ni;
  end else begin : gen_one
    logic    [2:0] had_q, split_q, left, chosen;
    vertex_t [2:0] m_q;
    logic          last;
    assign left = flight_i.ask & ~had_q;
    assign chosen = left & (~left + 3'd1);
    assign last = left == chosen;
    assign out_valid_o = flight_valid_i && last && (lane_valid_i[0] || left == '0);
    assign flight_ready_o = out_valid_o && out_ready_i;
    assign lane_ready_o[0] = flight_valid_i && left != '0 && (!last || out_ready_i);
    for (genvar i = 0; i < 3; i++) begin : gen_edge
      assign out_o.t.split[i] = chosen[i] ? lane_i[0].split : split_q[i];
      assign out_o.t.m[i] = chosen[i] ? lane_i[0].m : m_q[i];
      always_ff @(posedge clk_i) begin
        if (chosen[i] && lane_valid_i[0] && lane_ready_o[0]) m_q[i] <= lane_i[0].m;
      end
    end
    always_ff @(posedge clk_i) begin
      if (!rst_ni || (flight_valid_i && flight_ready_o)) begin
        had_q <= '0;
        split_q <= '0;
      end else if (lane_valid_i[0] && lane_ready_o[0]) begin
        had_q <= had_q | chosen;
        split_q <= split_q | (chosen & {3{lane_i[0].split}});
      end
    end
  end
endmodule

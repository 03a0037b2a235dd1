// pass_or_tessellate: combines the tests of an edge.
//   split = (nt | sht | pt | ht) & vt & ct, of those that are used, below the largest generation and where not settled
//   contract: hls/edge/pass_or_tessellate.hpp; its function cull is a module of its own
//
//   latency 1, initiation interval 1; a pure pipeline: never stalls, no reset on data; registered: the answer
module pass_or_tessellate
  import edge_pkg::*;
(
  input  logic                     clk_i,
  input  pass_or_tessellate_regs_t regs_i,
  input  pass_or_tessellate_in_t   in_i,
  output pass_or_tessellate_out_t  out_o
);
  logic wanted, allowed;
  assign wanted = (in_i.nt && regs_i.use_nt) || (in_i.sht && regs_i.use_sht)
               || (in_i.pt && regs_i.use_pt) || (in_i.ht && regs_i.use_ht);
  assign allowed = (in_i.vt || !regs_i.use_vt) && (in_i.ct || !regs_i.use_ct);
  always_ff @(posedge clk_i) begin
    out_o.split <= !in_i.settled && in_i.generation < regs_i.max_generation && wanted && allowed;
  end

  logic unused_cull;
  assign unused_cull = regs_i.cull;
endmodule

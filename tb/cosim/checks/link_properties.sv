// link_properties: the handshake of one link within a circuit, in every run of a model that has it bound in (engine_links.sv).
//   a word that is not taken is still valid at the next edge, and the same;  after an edge in reset nothing is valid
//   parameters  Name of the link, which a broken rule is told with;  Width of the word
//
//   A word is copied in the first clock of its wait, and compared only while it waits: a link that moves costs two bits a clock.
module link_properties #(
  parameter string Name = "link",
  parameter int unsigned Width = 1
) (
  input logic             clk_i,
  input logic             rst_ni,
  input logic             valid_i,
  input logic             ready_i,
  input logic [Width-1:0] word_i
);
  // verilator tracing_off
  // verilator coverage_off
  logic waiting_q, reset_q;
  logic [Width-1:0] word_q;
  initial {waiting_q, reset_q} = 2'b00;
  always_ff @(posedge clk_i) begin
    reset_q <= !rst_ni;
    waiting_q <= rst_ni && valid_i && !ready_i;
    if (valid_i && !ready_i && !waiting_q) word_q <= word_i;
    if (rst_ni && waiting_q) begin
      assert (valid_i) else $error("%s: valid is dropped before ready", Name);
      assert (!valid_i || word_i == word_q)
        else $error("%s: the word changes before it is taken", Name);
    end
    if (reset_q) assert (!valid_i) else $error("%s: valid in reset", Name);
  end
endmodule

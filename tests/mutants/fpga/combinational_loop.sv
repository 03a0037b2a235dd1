// rejected: loop
module combinational_loop (
  input  logic [3:0] in_i,
  output logic [3:0] out_o
);
  logic [3:0] a, b;
  assign a = b + in_i;
  assign b = a ^ 4'd5;
  assign out_o = a;
endmodule

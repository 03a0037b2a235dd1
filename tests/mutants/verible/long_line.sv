// rejected: line length, no trailing spaces
module long_line (
  input  logic [7:0] first_long_name_i,  
  output logic       any_o
);
  assign any_o = first_long_name_i[0] | first_long_name_i[1] | first_long_name_i[2] | first_long_name_i[3];
endmodule

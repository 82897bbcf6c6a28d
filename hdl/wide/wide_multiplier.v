// SPDX-License-Identifier: Apache-2.0
// The multiplier of a word unit of MPU4, signed, one start a clock. The low word of a product is there exactly
// `mul` steps after the start, the high word a step later (hdl/isa/wide.toml, [distance]):
//   EX  operands   +1  operand registers   +2  product   +3  low word (ID3 of MULL)   +4  high word
`default_nettype none

module wide_multiplier (
    input  wire        clk_i,
    input  wire [15:0] x_s1_i,
    input  wire [15:0] x_s2_i,
    output wire [15:0] d3_low_o,
    output wire [15:0] d3_high_o
);

  reg signed [15:0] s1_q;
  reg signed [15:0] s2_q;
  reg signed [31:0] product_q;
  reg [15:0] low_q;
  reg [15:0] high_q;
  reg [15:0] late_q;
  always @(posedge clk_i) begin
    s1_q <= x_s1_i;
    s2_q <= x_s2_i;
    product_q <= s1_q * s2_q;
    low_q <= product_q[15:0];
    high_q <= product_q[31:16];
    late_q <= high_q;
  end
  assign d3_low_o  = low_q;
  assign d3_high_o = late_q;

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// EX: the word adder. Takes two 16-bit operands, gives their sum or difference, wrapped to 16 bits.
// MV, MVL and MVH are sums with an operand that ID2 made 0.
`default_nettype none
`include "rung_isa.vh"

module alu (
    input  wire                       subtract_i,
    input  wire [`RUNG_WORD_BITS-1:0] s1_i,
    input  wire [`RUNG_WORD_BITS-1:0] s2_i,
    output wire [`RUNG_WORD_BITS-1:0] result_o
);

  wire [`RUNG_WORD_BITS-1:0] addend = s2_i ^ {`RUNG_WORD_BITS{subtract_i}};
  wire [`RUNG_WORD_BITS-1:0] carry = {{`RUNG_WORD_BITS - 1{1'b0}}, subtract_i};

  assign result_o = s1_i + addend + carry;

endmodule

`default_nettype wire

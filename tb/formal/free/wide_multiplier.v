// SPDX-License-Identifier: Apache-2.0
// Any product whatever, in the place of hdl/wide/wide_multiplier.v: for proofs that are not about it.
`default_nettype none
`include "rung_wide.vh"

module wide_multiplier (
    input  wire                                   clk_i,
    input  wire [`RUNG_WIDE_LAYOUT_WORD_BITS-1:0] x_s1_i,
    input  wire [`RUNG_WIDE_LAYOUT_WORD_BITS-1:0] x_s2_i,
    output wire [`RUNG_WIDE_LAYOUT_WORD_BITS-1:0] d3_low_o,
    output wire [`RUNG_WIDE_LAYOUT_WORD_BITS-1:0] d3_high_o
);

  (* anyseq *) wire [`RUNG_WIDE_LAYOUT_WORD_BITS-1:0] low;
  (* anyseq *) wire [`RUNG_WIDE_LAYOUT_WORD_BITS-1:0] high;
  assign d3_low_o  = low;
  assign d3_high_o = high;
  wire unused = &{1'b0, clk_i, x_s1_i, x_s2_i};

endmodule

`default_nettype wire

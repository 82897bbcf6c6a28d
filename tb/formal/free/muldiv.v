// SPDX-License-Identifier: Apache-2.0
// Any result whatever, in the place of hdl/core/muldiv.v: for proofs that are not about it. What it is asked
// is for the proof to look at; what it answers then is muldiv_proof.v's.
`default_nettype none
`include "rung_isa.vh"

module muldiv #(
    parameter MUL_DSP = 1
) (
    input  wire                       clk_i,
    input  wire                       rst_ni,
    input  wire                       scan_start_i,
    input  wire                       x_start_i,
    input  wire                       x_executed_i,
    input  wire                       x_div_i,
    input  wire                       x_wide_i,
    input  wire                       x_high_i,
    input  wire [`RUNG_WORD_BITS-1:0] x_s1_i,
    input  wire [`RUNG_WORD_BITS-1:0] x_s2_i,
    input  wire [                1:0] d3_word_i,
    output wire [`RUNG_WORD_BITS-1:0] d3_result_o,
    output wire                       d3_valid_o,
    output wire                       w_div_by_0_o
);

  (* anyseq *)wire [`RUNG_WORD_BITS-1:0] result;
  (* anyseq *)wire valid;
  (* anyseq *)wire by_0;
  assign d3_result_o  = result;
  assign d3_valid_o   = valid;
  assign w_div_by_0_o = by_0;
  wire unused = &{1'b0, MUL_DSP != 0, clk_i, rst_ni, scan_start_i, x_start_i, x_executed_i, x_div_i,
                  x_wide_i, x_high_i, x_s1_i, x_s2_i, d3_word_i};

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// Any result whatever, in the place of hdl/core/alu.v: for proofs that are not about it. What it gets is for
// the proof to look at; what it makes of that is alu_proof.v's. Kept are that only a test gives a 1, and
// what the bank gets.
`default_nettype none
`include "rung_isa.vh"

module alu (
    input  wire                       clk_i,
    input  wire                       scan_start_i,
    input  wire [  `RUNG_OP_BITS-1:0] d2_op_i,
    input  wire [`RUNG_WORD_BITS-1:0] x_s1_i,
    input  wire [`RUNG_WORD_BITS-1:0] x_s2_i,
    input  wire [`RUNG_WORD_BITS-1:0] x_acc_i,
    input  wire [`RUNG_WORD_BITS-1:0] x_cross_i,
    output wire [`RUNG_WORD_BITS-1:0] x_result_o,
    output wire [`RUNG_WORD_BITS-1:0] x_bank_o,
    output wire [`RUNG_WORD_BITS-1:0] x_sum_o,
    output wire                       x_test_o
);

  (* anyseq *)wire [`RUNG_WORD_BITS-1:0] result;
  (* anyseq *)wire [`RUNG_WORD_BITS-1:0] sum;
  (* anyseq *)wire test;
  reg [`RUNG_OP_BITS-1:0] d3_op_q, x_op_q;
  always @(posedge clk_i) {d3_op_q, x_op_q} <= {d2_op_i, d3_op_q};

  wire is_test = x_op_q == `RUNG_OP_EQ || x_op_q == `RUNG_OP_LT || x_op_q == `RUNG_OP_LTU ||
      x_op_q == `RUNG_OP_LTC || x_op_q == `RUNG_OP_TB;
  // Two of its ways are wires, for MVL to MV3 and for the host.
  wire passes2 = x_op_q == `RUNG_OP_MV || x_op_q == `RUNG_OP_MVL || x_op_q == `RUNG_OP_MVH ||
      x_op_q == `RUNG_OP_MV2 || x_op_q == `RUNG_OP_MV3;
  assign x_result_o = passes2 ? x_s2_i : x_op_q == `RUNG_OP_NOP ? x_s1_i : result;
  assign x_bank_o = x_result_o ^ x_cross_i;
  assign x_sum_o = sum;
  assign x_test_o = is_test && test;
  wire unused = &{1'b0, scan_start_i, x_acc_i};

endmodule

`default_nettype wire

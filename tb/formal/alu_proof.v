// SPDX-License-Identifier: Apache-2.0
// The word arithmetic of a slot (hdl/core/alu.v), full width: result, test and carry of every opcode are
// those of model/word_model.v, for any operands and after any instructions; the bank gets result
// exclusive-or what the other banks hold.
`default_nettype none
`include "rung_isa.vh"

module alu_proof (
    input wire clk_i,
    input wire scan_start_i,
    input wire [`RUNG_OP_BITS-1:0] op_i,
    input wire [`RUNG_WORD_BITS-1:0] s1_i,
    input wire [`RUNG_WORD_BITS-1:0] s2_i,
    input wire [`RUNG_WORD_BITS-1:0] acc_i,
    input wire [`RUNG_WORD_BITS-1:0] cross_i,
    input wire peek_carry
);

  localparam BITS = `RUNG_WORD_BITS;

  wire [BITS-1:0] result, bank, sum;
  wire test;
  alu alu (
      .clk_i(clk_i),
      .scan_start_i(scan_start_i),
      .d2_op_i(op_i),
      .x_s1_i(s1_i),
      .x_s2_i(s2_i),
      .x_acc_i(acc_i),
      .x_cross_i(cross_i),
      .x_result_o(result),
      .x_bank_o(bank),
      .x_sum_o(sum),
      .x_test_o(test)
  );

  // ---- the instruction in EX: in ID2 two clocks ago --------------------------------------------
  reg [`RUNG_OP_BITS-1:0] op_q[1:2];
  reg [1:0] age_q;
  initial age_q = 2'd0;
  reg carry_q;
  wire carry, writes, tests, expected_test;
  wire [BITS-1:0] expected;
  always @(posedge clk_i) begin
    op_q[1] <= op_i;
    op_q[2] <= op_q[1];
    if (age_q != 2'd3) age_q <= age_q + 2'd1;
    carry_q <= carry && !scan_start_i;
  end
  wire [`RUNG_OP_BITS-1:0] op = op_q[2];
  word_model model (
      .op_i(op),
      .s1_i(s1_i),
      .s2_i(s2_i),
      .acc_i(acc_i),
      .carry_i(carry_q),
      .writes_o(writes),
      .tests_o(tests),
      .result_o(expected),
      .test_o(expected_test),
      .carry_o(carry)
  );

  wire known = age_q == 2'd3;
  always @* begin
    // The model starts in the state in which the hardware is.
    if (!known) assume (carry_q == peek_carry);
    if (known) begin
      assert (carry_q == peek_carry);
      assert (test == expected_test);
      if (writes || tests) assert (bank == (result ^ cross_i));
      if (writes) assert (result == expected);
      if (op == `RUNG_OP_NOP) assert (result == s1_i);
      if (op == `RUNG_OP_MVL || op == `RUNG_OP_MVH || op == `RUNG_OP_MV2 || op == `RUNG_OP_MV3)
        assert (result == s2_i && bank == (result ^ cross_i));
      if (op == `RUNG_OP_IX) assert (sum == s1_i + s2_i);
    end
  end

  always @* begin
    if (known) begin
      cover (op == `RUNG_OP_SBC && carry_q && carry && result == 16'h1234);
      cover (op == `RUNG_OP_LTC && carry_q && test);
      cover (op == `RUNG_OP_ROL && result == 16'hC001 && s2_i == 16'h7777);
      cover (op == `RUNG_OP_MINU && result != s2_i);
      cover (op == `RUNG_OP_TB && test && s2_i[3:0] == 4'd9);
    end
  end

endmodule

`default_nettype wire

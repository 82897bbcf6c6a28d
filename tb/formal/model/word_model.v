// SPDX-License-Identifier: Apache-2.0
// What a word instruction or a test of MPU1 to MPU3 means, from hdl/isa/README.md: its result from its
// operands, without a clock and without the hardware's tricks. Who writes it where, and whether, is
// slot_model.v's.
`default_nettype none
`include "rung_isa.vh"

module word_model (
    input  wire [  `RUNG_OP_BITS-1:0] op_i,
    input  wire [`RUNG_WORD_BITS-1:0] s1_i,
    input  wire [`RUNG_WORD_BITS-1:0] s2_i,
    input  wire [`RUNG_WORD_BITS-1:0] acc_i,
    input  wire                       carry_i,
    // result_o goes to a word device; test_o to a bit device
    output reg                        writes_o,
    output reg                        tests_o,
    output reg  [`RUNG_WORD_BITS-1:0] result_o,
    output reg                        test_o,
    output reg                        carry_o
);

  localparam BITS = `RUNG_WORD_BITS;

  wire takes_carry = op_i == `RUNG_OP_ADC || op_i == `RUNG_OP_SBC || op_i == `RUNG_OP_LTC;
  wire [BITS:0] carry = {{BITS{1'b0}}, takes_carry && carry_i};
  wire [BITS:0] sum = {1'b0, s1_i} + {1'b0, s2_i} + carry;
  wire [BITS:0] difference = {1'b0, s1_i} - {1'b0, s2_i} - carry;
  // One bit wider than the operands, so that s1 less a borrow is never wrong.
  wire [BITS:0] signed1 = {s1_i[BITS-1], s1_i} - carry;
  wire [BITS:0] signed2 = {s2_i[BITS-1], s2_i};
  wire [2*BITS-1:0] rotated = {s1_i, s1_i} << s2_i[3:0];

  always @* begin
    writes_o = 1'b1;
    tests_o  = 1'b0;
    carry_o  = carry_i;
    result_o = s1_i;
    test_o   = 1'b0;
    case (op_i)
      `RUNG_OP_MV, `RUNG_OP_STX: result_o = s2_i;
      `RUNG_OP_MVX: result_o = s1_i;
      `RUNG_OP_ADD, `RUNG_OP_ADC: {carry_o, result_o} = sum;
      `RUNG_OP_SUB, `RUNG_OP_SBC: {carry_o, result_o} = difference;
      `RUNG_OP_WAND: result_o = s1_i & s2_i;
      `RUNG_OP_WOR: result_o = s1_i | s2_i;
      `RUNG_OP_WXOR: result_o = s1_i ^ s2_i;
      `RUNG_OP_ROL: result_o = rotated[2*BITS-1:BITS];
      `RUNG_OP_MINU: result_o = s1_i < s2_i ? s1_i : s2_i;
      `RUNG_OP_MVA: result_o = acc_i;
      `RUNG_OP_EQ, `RUNG_OP_LT, `RUNG_OP_LTU, `RUNG_OP_LTC, `RUNG_OP_TB: begin
        writes_o = 1'b0;
        tests_o  = 1'b1;
        case (op_i)
          `RUNG_OP_EQ: test_o = s1_i == s2_i;
          `RUNG_OP_LT: test_o = $signed(s1_i) < $signed(s2_i);
          `RUNG_OP_LTU: test_o = s1_i < s2_i;
          `RUNG_OP_LTC: test_o = $signed(signed1) < $signed(signed2);
          default: test_o = s1_i[s2_i[3:0]];
        endcase
        if (op_i == `RUNG_OP_LTU) carry_o = s1_i < s2_i;
      end
      `RUNG_OP_CMP: begin
        writes_o = 1'b0;
        carry_o  = s1_i < s2_i;
      end
      default: writes_o = 1'b0;
    endcase
  end

endmodule

`default_nettype wire

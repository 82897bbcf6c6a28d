// SPDX-License-Identifier: Apache-2.0
// What one instruction of MPU1 to MPU3 does to its slot and to the devices, from hdl/isa/README.md: no
// clock, no pipeline. Devices are as all steps before have left them. An instruction that waits for its unit
// is issued twice: the first pass starts the unit, the last writes what the unit gives.
`default_nettype none
`include "rung_isa.vh"

module slot_model #(
    parameter LOOKUP = 1,
    parameter FREE_ALU = 0,  // 1: results are what the ALU gives, which alu_proof.v is about
    parameter BIT_ADDR = 2,
    parameter WORD_ADDR = 2,
    parameter IX_BITS = 2,
    parameter INSTRUCTION_BITS = 31
) (
    input  wire [            INSTRUCTION_BITS-1:0] instruction_i,
    input  wire                                    first_i,
    input  wire                                    last_i,
    input  wire [                             7:0] row_i,         // of the LUT
    // devices, and what the unit gives
    input  wire [              (1<<BIT_ADDR)-1:0] bits_i,
    input  wire [(`RUNG_WORD_BITS<<WORD_ADDR)-1:0] words_i,
    input  wire                                    unit_valid_i,
    input  wire [             `RUNG_WORD_BITS-1:0] unit_word_i,
    input  wire [             `RUNG_WORD_BITS-1:0] alu_result_i,
    input  wire [             `RUNG_WORD_BITS-1:0] alu_sum_i,
    input  wire                                    alu_test_i,
    // the slot before and after
    input  wire                                    exc_i,
    input  wire [           `RUNG_BLOCK_STACK-1:0] block_i,
    input  wire [          `RUNG_BRANCH_STACK-1:0] branch_i,
    input  wire [             `RUNG_WORD_BITS-1:0] acc_i,
    input  wire                                    carry_i,
    input  wire [                     IX_BITS-1:0] ix_i,
    output reg                                     exc_o,
    output reg  [           `RUNG_BLOCK_STACK-1:0] block_o,
    output reg  [          `RUNG_BRANCH_STACK-1:0] branch_o,
    output reg  [             `RUNG_WORD_BITS-1:0] acc_o,
    output wire                                    carry_o,
    output wire [                     IX_BITS-1:0] ix_o,
    // the instruction is of this processor, retires in this pass, has word operands, sets ix
    output reg                                     legal_o,
    output wire                                    retires_o,
    output wire                                    words_o,
    output wire                                    sets_ix_o,
    // what it writes
    output reg                                     bit_we_o,
    output wire [                    BIT_ADDR-1:0] bit_addr_o,
    output reg                                     bit_value_o,
    output wire                                    word_we_o,
    output wire [                   WORD_ADDR-1:0] word_addr_o,
    output wire [             `RUNG_WORD_BITS-1:0] word_value_o,
    // what it asks of the multiply-divide unit
    output wire                                    start_o,
    output wire                                    divide_o,
    output wire                                    wide_o,
    output wire                                    ldh_o,
    output wire                                    run_o,
    output wire                                    collects_o,
    output reg  [                             1:0] unit_index_o,
    output wire [             `RUNG_WORD_BITS-1:0] s1_o,
    output wire [             `RUNG_WORD_BITS-1:0] s2_o
);

  localparam BITS = `RUNG_WORD_BITS;

  // ---- fields ("Layout of one slot's instruction") ---------------------------------------------
  localparam OPERAND = LOOKUP != 0 ? BIT_ADDR + 1 : BIT_ADDR;
  localparam DEST_AT = BITS + WORD_ADDR;  // the word sources are the longer, numbers being short
  localparam TAIL_AT = DEST_AT + (OPERAND > WORD_ADDR ? OPERAND : WORD_ADDR);
  wire [5:0] op = instruction_i[INSTRUCTION_BITS-1-:6];
  wire u = instruction_i[TAIL_AT];
  wire [1:0] kind = instruction_i[TAIL_AT+1+:2];
  wire [BITS-1:0] source = instruction_i[BITS-1:0];
  wire [WORD_ADDR-1:0] rs = instruction_i[BITS+:WORD_ADDR];
  wire [WORD_ADDR-1:0] rd = instruction_i[DEST_AT+:WORD_ADDR];
  wire [BIT_ADDR-1:0] dest = instruction_i[DEST_AT+:BIT_ADDR];
  wire [BIT_ADDR-1:0] a_number = LOOKUP != 0 ? instruction_i[0+:BIT_ADDR] : dest;
  wire [BIT_ADDR-1:0] b_number = instruction_i[BIT_ADDR+1+:BIT_ADDR];
  wire a_n0 = LOOKUP != 0 && instruction_i[BIT_ADDR];
  wire b_n0 = instruction_i[2*BIT_ADDR+1];
  wire c_n0 = LOOKUP != 0 && instruction_i[DEST_AT+OPERAND-1];

  // ---- operands --------------------------------------------------------------------------------
  wire [BIT_ADDR-1:0] bit_ix = ix_i[BIT_ADDR-1:0];
  wire [WORD_ADDR-1:0] word_ix = ix_i[WORD_ADDR-1:0];
  wire reads_ix = op == `RUNG_OP_LDX || op == `RUNG_OP_MVBX;
  wire a = reads_ix ? bits_i[bit_ix] : a_n0 ? exc_i : bits_i[a_number];
  wire b = b_n0 ? exc_i : bits_i[b_number];
  wire c = c_n0 ? exc_i : bits_i[dest];
  wire [BITS-1:0] rs_word = words_i[rs*BITS+:BITS];
  wire [BITS-1:0] source_word = words_i[source[WORD_ADDR-1:0]*BITS+:BITS];
  assign s1_o = op == `RUNG_OP_MVX ? words_i[word_ix*BITS+:BITS] : kind == 2'd2 ? source : rs_word;
  assign s2_o = kind == 2'd0 ? source_word : kind == 2'd1 ? source : rs_word;
  assign run_o = u || exc_i;

  // ---- the multiply-divide unit ----------------------------------------------------------------
  wire multiplies = op == `RUNG_OP_MUL || op == `RUNG_OP_MULS;
  wire multiplies32 = op == `RUNG_OP_MULD || op == `RUNG_OP_MULDS;
  wire divides = op == `RUNG_OP_DIV || op == `RUNG_OP_DIVS;
  wire divides32 = op == `RUNG_OP_DIVD || op == `RUNG_OP_DIVDS;
  wire waits = op == `RUNG_OP_MUL || op == `RUNG_OP_DIV || op == `RUNG_OP_MULD ||
      op == `RUNG_OP_DIVD;
  assign start_o = first_i && (multiplies || multiplies32 || divides || divides32);
  assign divide_o = divides || divides32;
  assign wide_o = multiplies32 || divides32;
  assign ldh_o = first_i && op == `RUNG_OP_LDH;
  assign collects_o = waits ? last_i : first_i &&
      (op == `RUNG_OP_MVL || op == `RUNG_OP_MVH || op == `RUNG_OP_MV2 || op == `RUNG_OP_MV3);
  always @* begin
    case (op)
      `RUNG_OP_MVH: unit_index_o = 2'd1;
      `RUNG_OP_MV2: unit_index_o = 2'd2;
      `RUNG_OP_MV3: unit_index_o = 2'd3;
      default: unit_index_o = 2'd0;
    endcase
  end
  assign retires_o = waits ? last_i : first_i;

  // ---- words -----------------------------------------------------------------------------------
  wire writes, tests, expected_test, carry;
  wire [BITS-1:0] expected;
  word_model words (
      .op_i(op),
      .s1_i(s1_o),
      .s2_i(s2_o),
      .acc_i(acc_i),
      .carry_i(carry_i),
      .writes_o(writes),
      .tests_o(tests),
      .result_o(expected),
      .test_o(expected_test),
      .carry_o(carry)
  );
  wire [BITS-1:0] sum = FREE_ALU != 0 ? alu_sum_i : s1_o + s2_o;
  wire [BITS-1:0] result = FREE_ALU != 0 && op != `RUNG_OP_MV ? alu_result_i : expected;
  wire test = FREE_ALU != 0 ? alu_test_i : expected_test;
  assign sets_ix_o = first_i && op == `RUNG_OP_IX;
  assign ix_o = sets_ix_o ? sum[IX_BITS-1:0] : ix_i;
  assign carry_o = first_i ? carry : carry_i;
  assign word_we_o = collects_o ? unit_valid_i : first_i && writes && run_o;
  assign word_addr_o = op == `RUNG_OP_STX ? word_ix : rd;
  assign word_value_o = collects_o ? unit_word_i : result;

  // ---- bits ------------------------------------------------------------------------------------
  wire writes_ix = op == `RUNG_OP_SETX || op == `RUNG_OP_RSTX;
  assign bit_addr_o = writes_ix ? bit_ix : dest;
  assign words_o = first_i &&
      (writes || tests || start_o || ldh_o || sets_ix_o || op == `RUNG_OP_CMP);
  always @* begin
    legal_o = 1'b1;
    exc_o = exc_i;
    block_o = block_i;
    branch_o = branch_i;
    acc_o = acc_i;
    bit_we_o = 1'b0;
    bit_value_o = 1'b0;
    case (op)
      `RUNG_OP_LUT, `RUNG_OP_LUTO, `RUNG_OP_LUTS, `RUNG_OP_LUTR: begin
        legal_o = LOOKUP != 0;
        exc_o = row_i[{a, b, c}];
        bit_we_o = op == `RUNG_OP_LUTO || (op != `RUNG_OP_LUT && exc_o);
        bit_value_o = exc_o && op != `RUNG_OP_LUTR;
      end
      `RUNG_OP_LD: exc_o = a;
      `RUNG_OP_LDX, `RUNG_OP_LDI: begin
        legal_o = LOOKUP == 0;
        exc_o   = op == `RUNG_OP_LDI ? !a : a;
      end
      `RUNG_OP_AND: {legal_o, exc_o} = {LOOKUP == 0, exc_i && a};
      `RUNG_OP_ANI: {legal_o, exc_o} = {LOOKUP == 0, exc_i && !a};
      `RUNG_OP_OR: {legal_o, exc_o} = {LOOKUP == 0, exc_i || a};
      `RUNG_OP_ORI: {legal_o, exc_o} = {LOOKUP == 0, exc_i || !a};
      `RUNG_OP_INV: {legal_o, exc_o} = {LOOKUP == 0, !exc_i};
      `RUNG_OP_ANB: {legal_o, exc_o} = {LOOKUP == 0, exc_i && block_i[0]};
      `RUNG_OP_ORB: {legal_o, exc_o} = {LOOKUP == 0, exc_i || block_i[0]};
      `RUNG_OP_POP: {legal_o, exc_o} = {LOOKUP == 0, block_i[0]};
      `RUNG_OP_MPS: {legal_o, branch_o} = {LOOKUP == 0, branch_i[14:0], exc_i};
      `RUNG_OP_MRD: {legal_o, exc_o} = {LOOKUP == 0, branch_i[0]};
      `RUNG_OP_MPP: {legal_o, exc_o, branch_o} = {LOOKUP == 0, branch_i[0], 1'b0, branch_i[15:1]};
      `RUNG_OP_OUT: {bit_we_o, bit_value_o} = {1'b1, exc_i};
      `RUNG_OP_SET, `RUNG_OP_SETX: {bit_we_o, bit_value_o} = {run_o, 1'b1};
      `RUNG_OP_RST, `RUNG_OP_RSTX: {bit_we_o, bit_value_o} = {run_o, 1'b0};
      `RUNG_OP_MVBX: {legal_o, bit_we_o, bit_value_o} = {LOOKUP != 0 && !a_n0, 1'b1, a};
      `RUNG_OP_GET: begin
        if (u) acc_o = {BITS{1'b0}};
        if (LOOKUP != 0) begin
          acc_o = {acc_o[BITS-4:0], a && !a_n0, b && !b_n0, c && !c_n0};
        end else begin
          acc_o = {acc_o[BITS-2:0], a};
        end
      end
      `RUNG_OP_MULS, `RUNG_OP_DIVS, `RUNG_OP_MULDS, `RUNG_OP_DIVDS, `RUNG_OP_MVL:
      legal_o = LOOKUP != 0;
      `RUNG_OP_MULD, `RUNG_OP_DIVD: legal_o = LOOKUP == 0;
      default: begin
        legal_o = op <= `RUNG_OP_RSTX;
        {bit_we_o, bit_value_o} = {tests && run_o, test};
      end
    endcase
    if (LOOKUP == 0) begin
      if (op == `RUNG_OP_LD || op == `RUNG_OP_LDI || op == `RUNG_OP_LDX)
        block_o = {block_i[14:0], exc_i};
      if (op == `RUNG_OP_ANB || op == `RUNG_OP_ORB || op == `RUNG_OP_POP)
        block_o = {1'b0, block_i[15:1]};
    end
    // A device's field has no kind 3.
    if (kind == 2'd3 && (writes || tests || collects_o || start_o || ldh_o || op == `RUNG_OP_CMP ||
                         op == `RUNG_OP_IX))
      legal_o = 1'b0;
    // Only the first pass does something.
    if (!first_i) begin
      exc_o = exc_i;
      block_o = block_i;
      branch_o = branch_i;
      acc_o = acc_i;
      bit_we_o = 1'b0;
    end
  end

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// The word arithmetic of one slot, decoded in ID2 and done in EX: sums, differences and compares in
// one adder; beside it logic, rotation and what is only moved (logic functions "s1" and "s2").
// Instructions that it does not know give s1, which is how the host reads a device.
`default_nettype none
`include "rung_isa.vh"

module alu (
    input  wire                       clk_i,
    input  wire                       scan_start_i,
    // ID2: opcode as issued
    input  wire [  `RUNG_OP_BITS-1:0] d2_op_i,
    // EX: operands, what GET gathered, and what the other banks hold at rd
    input  wire [`RUNG_WORD_BITS-1:0] x_s1_i,
    input  wire [`RUNG_WORD_BITS-1:0] x_s2_i,
    input  wire [`RUNG_WORD_BITS-1:0] x_acc_i,
    input  wire [`RUNG_WORD_BITS-1:0] x_cross_i,
    // EX: the result, and what this slot's bank gets; s1 + s2, if the instruction is IX; the result of
    // a test, 0 if it is none
    output wire [`RUNG_WORD_BITS-1:0] x_result_o,
    output wire [`RUNG_WORD_BITS-1:0] x_bank_o,
    output wire [`RUNG_WORD_BITS-1:0] x_sum_o,
    output wire                       x_test_o
);

  localparam BITS = `RUNG_WORD_BITS;
  // Logic functions, as the operand bits that give 1: {s2 alone, s1 alone, both}.
  localparam [2:0] GIVE_0 = 3'b000;
  localparam [2:0] GIVE_AND = 3'b001;
  localparam [2:0] GIVE_OR = 3'b111;
  localparam [2:0] GIVE_XOR = 3'b110;
  localparam [2:0] GIVE_S1 = 3'b011;
  localparam [2:0] GIVE_S2 = 3'b101;

  // ---- ID2: decode -----------------------------------------------------------------------------
  reg d2_sum, d2_subtract, d2_signed, d2_use_carry, d2_set_carry;
  reg d2_minimum, d2_rotate, d2_acc, d2_less, d2_equal, d2_bit;
  reg [2:0] d2_logic;
  always @* begin
    {d2_sum, d2_subtract, d2_signed, d2_use_carry, d2_set_carry} = 5'd0;
    {d2_minimum, d2_rotate, d2_acc, d2_less, d2_equal, d2_bit} = 6'd0;
    d2_logic = GIVE_S1;
    case (d2_op_i)
      `RUNG_OP_ADD, `RUNG_OP_ADC, `RUNG_OP_SUB, `RUNG_OP_SBC: begin
        d2_sum = 1'b1;
        d2_logic = GIVE_0;
        d2_subtract = d2_op_i == `RUNG_OP_SUB || d2_op_i == `RUNG_OP_SBC;
        d2_use_carry = d2_op_i == `RUNG_OP_ADC || d2_op_i == `RUNG_OP_SBC;
        d2_set_carry = 1'b1;
      end
      `RUNG_OP_CMP: begin
        d2_subtract  = 1'b1;
        d2_set_carry = 1'b1;
      end
      `RUNG_OP_LT, `RUNG_OP_LTU, `RUNG_OP_LTC: begin
        d2_subtract = 1'b1;
        d2_less = 1'b1;
        d2_signed = d2_op_i != `RUNG_OP_LTU;
        d2_use_carry = d2_op_i == `RUNG_OP_LTC;
        d2_set_carry = d2_op_i == `RUNG_OP_LTU;
      end
      `RUNG_OP_EQ: d2_equal = 1'b1;
      `RUNG_OP_TB: d2_bit = 1'b1;
      `RUNG_OP_MINU: begin
        d2_subtract = 1'b1;
        d2_minimum = 1'b1;
        d2_logic = GIVE_S2;
      end
      `RUNG_OP_WAND: d2_logic = GIVE_AND;
      `RUNG_OP_WOR: d2_logic = GIVE_OR;
      `RUNG_OP_WXOR: d2_logic = GIVE_XOR;
      `RUNG_OP_ROL: begin
        d2_rotate = 1'b1;
        d2_logic  = GIVE_0;
      end
      `RUNG_OP_MVA: begin
        d2_acc   = 1'b1;
        d2_logic = GIVE_0;
      end
      `RUNG_OP_MV, `RUNG_OP_STX, `RUNG_OP_MVL, `RUNG_OP_MVH, `RUNG_OP_MV2, `RUNG_OP_MV3: begin
        d2_logic = GIVE_S2;
      end
      default: ;
    endcase
  end

  reg d3_sum_q, d3_subtract_q, d3_signed_q, d3_use_carry_q, d3_set_carry_q;
  reg d3_minimum_q, d3_rotate_q, d3_acc_q, d3_less_q, d3_equal_q, d3_bit_q;
  reg [2:0] d3_logic_q;
  reg x_sum_q, x_subtract_q, x_signed_q, x_use_carry_q, x_set_carry_q;
  reg x_minimum_q, x_rotate_q, x_acc_q, x_less_q, x_equal_q, x_bit_q;
  reg [2:0] x_logic_q;
  always @(posedge clk_i) begin
    {d3_sum_q, x_sum_q} <= {d2_sum, d3_sum_q};
    {d3_subtract_q, x_subtract_q} <= {d2_subtract, d3_subtract_q};
    {d3_signed_q, x_signed_q} <= {d2_signed, d3_signed_q};
    {d3_use_carry_q, x_use_carry_q} <= {d2_use_carry, d3_use_carry_q};
    {d3_set_carry_q, x_set_carry_q} <= {d2_set_carry, d3_set_carry_q};
    {d3_minimum_q, x_minimum_q} <= {d2_minimum, d3_minimum_q};
    {d3_rotate_q, x_rotate_q} <= {d2_rotate, d3_rotate_q};
    {d3_acc_q, x_acc_q} <= {d2_acc, d3_acc_q};
    {d3_less_q, x_less_q} <= {d2_less, d3_less_q};
    {d3_equal_q, x_equal_q} <= {d2_equal, d3_equal_q};
    {d3_bit_q, x_bit_q} <= {d2_bit, d3_bit_q};
    {d3_logic_q, x_logic_q} <= {d2_logic, d3_logic_q};
  end

  // ---- EX: the adder ---------------------------------------------------------------------------
  // With one bit more than a word, of which the top bit is the carry, the borrow, or "s1 is less".
  reg carry_q;
  wire [BITS:0] x_augend = {x_signed_q && x_s1_i[BITS-1], x_s1_i};
  wire [BITS:0] x_addend = {x_signed_q && x_s2_i[BITS-1], x_s2_i} ^ {BITS + 1{x_subtract_q}};
  wire x_carry_in = x_subtract_q ^ (x_use_carry_q && carry_q);
  // The carry enters through a bit below the lowest: one carry chain, not two.
  wire [BITS+1:0] x_chain = {x_augend, 1'b1} + {x_addend, x_carry_in};
  wire [BITS:0] x_sum = x_chain[BITS+1:1];
  wire x_less = x_sum[BITS];
  wire unused_chain = &{1'b0, x_chain[0]};

  always @(posedge clk_i) begin
    if (scan_start_i) begin
      carry_q <= 1'b0;
    end else if (x_set_carry_q) begin
      carry_q <= x_less;
    end
  end

  // ---- EX: beside it ---------------------------------------------------------------------------
  wire [BITS-1:0] x_logic = ({BITS{x_logic_q[0]}} & x_s1_i & x_s2_i) |
                            ({BITS{x_logic_q[1]}} & x_s1_i & ~x_s2_i) |
                            ({BITS{x_logic_q[2]}} & ~x_s1_i & x_s2_i);

  wire [3:0] x_by = x_s2_i[3:0];
  wire [BITS-1:0] x_by_1 = x_by[0] ? {x_s1_i[BITS-2:0], x_s1_i[BITS-1]} : x_s1_i;
  wire [BITS-1:0] x_by_3 = x_by[1] ? {x_by_1[BITS-3:0], x_by_1[BITS-1-:2]} : x_by_1;
  wire [BITS-1:0] x_by_7 = x_by[2] ? {x_by_3[BITS-5:0], x_by_3[BITS-1-:4]} : x_by_3;
  wire [BITS-1:0] x_rotated = x_by[3] ? {x_by_7[BITS-9:0], x_by_7[BITS-1-:8]} : x_by_7;

  // ---- EX: the result --------------------------------------------------------------------------
  // The adder is the latest, so only exclusive-ors come behind it, in one level of look-up tables: of
  // all that is early, of the sum, and, for the smaller one, of the bits in which s2 has to change if
  // s1 is less.
  wire [BITS-1:0] x_early =
      x_logic | ({BITS{x_rotate_q}} & x_rotated) | ({BITS{x_acc_q}} & x_acc_i);
  wire [BITS-1:0] x_change = {BITS{x_minimum_q}} & (x_s1_i ^ x_s2_i);
  wire [BITS-1:0] x_late = ({BITS{x_sum_q}} & x_sum[BITS-1:0]) ^ ({BITS{x_less}} & x_change);
  assign x_result_o = x_early ^ x_late;
  assign x_bank_o = (x_early ^ x_cross_i) ^ x_late;
  assign x_sum_o = x_sum[BITS-1:0];
  assign x_test_o = (x_less_q && x_less) || (x_equal_q && x_s1_i == x_s2_i) ||
                    (x_bit_q && x_s1_i[x_by]);

endmodule

`default_nettype wire

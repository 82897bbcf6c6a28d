// SPDX-License-Identifier: Apache-2.0
// A word unit of MPU4, beside slot 2u: result <- gate ? op(s1, s2) : keep, where the gate is what slot 2u has
// computed in the step before. Tests set the flag, which slots 2u and 2u+1 can use as an operand.
`default_nettype none
`include "rung_isa.vh"
`include "rung_wide.vh"

module word_unit #(
    parameter UNITS = 8,
    parameter UNIT_BITS = 3,
    parameter ADDR_BITS = 9,  // of the rows of words
    parameter ARITY = 3,  // of the bit slot
    parameter INSTRUCTION_BITS = 47,
    parameter DIVIDER = 1,  // 1: has DIV
    parameter WIDE = 1  // 1: has MULD and DIVD
) (
    input  wire                                         clk_i,
    input  wire                                         rst_ni,
    // IF3: the instruction: source, s1, keep, kind, always, op
    input  wire [                 INSTRUCTION_BITS-1:0] f3_instruction_i,
    // EX: a scan has started and its first step is not here yet
    input  wire                                         x_start_i,
    // EX: slot 2u: its operands, and its result of the step before
    input  wire [                            ARITY-1:0] x_operands_i,
    input  wire                                         x_gate_i,
    // the row of all units, a clock after `w`, and where it goes
    input  wire [UNITS*`RUNG_WIDE_LAYOUT_WORD_BITS-1:0] b_row_i,
    input  wire                                         b_we_i,
    input  wire [                        ADDR_BITS-1:0] b_addr_i,
    output wire [      `RUNG_WIDE_LAYOUT_WORD_BITS-1:0] w_value_o,
    output wire                                         w_flag_o,
    output wire                                         w_div_by_0_o
);

  localparam BITS = `RUNG_WIDE_LAYOUT_WORD_BITS;
  localparam ROW_BITS = `RUNG_WIDE_LAYOUT_ROW_BITS;
  localparam OP_BITS = `RUNG_WIDE_LAYOUT_OP_BITS;
  localparam S1_AT = BITS;
  localparam KEEP_AT = S1_AT + UNIT_BITS + ROW_BITS;
  localparam KIND_AT = KEEP_AT + ROW_BITS;
  localparam ALWAYS_AT = KIND_AT + `RUNG_WIDE_LAYOUT_KIND_BITS;
  localparam OP_AT = ALWAYS_AT + 1;
  localparam [1:0] CONSTANT_S2 = 2'd1;
  localparam [1:0] CONSTANT_S1 = 2'd2;

  // ---- ID1: what an operand's place is does not depend on kind any more ------------------------
  wire [UNIT_BITS+ROW_BITS-1:0] f3_s1 = f3_instruction_i[S1_AT+:UNIT_BITS+ROW_BITS];
  wire [1:0] f3_kind = f3_instruction_i[KIND_AT+:2];
  wire [OP_BITS-1:0] f3_op = f3_instruction_i[OP_AT+:OP_BITS];
  wire f3_collects = f3_op == `RUNG_WIDE_OP_MULL || f3_op == `RUNG_WIDE_OP_MULH ||
                     f3_op == `RUNG_WIDE_OP_QUO || f3_op == `RUNG_WIDE_OP_REM ||
                     f3_op == `RUNG_WIDE_OP_MW0 || f3_op == `RUNG_WIDE_OP_MW1 ||
                     f3_op == `RUNG_WIDE_OP_MW2 || f3_op == `RUNG_WIDE_OP_MW3;
  reg [UNIT_BITS+ROW_BITS-1:0] d1_s1_q;
  reg [UNIT_BITS+ROW_BITS-1:0] d1_s2_q;
  reg [ROW_BITS-1:0] d1_keep_q;
  reg [BITS-1:0] d1_source_q;
  reg [OP_BITS-1:0] d1_op_q;
  reg d1_always_q, d1_other1_q, d1_other2_q, d1_collects_q;
  always @(posedge clk_i) begin
    d1_s1_q <= f3_s1;
    d1_s2_q <= f3_kind == CONSTANT_S1 ? f3_s1 : f3_instruction_i[UNIT_BITS+ROW_BITS-1:0];
    d1_keep_q <= f3_instruction_i[KEEP_AT+:ROW_BITS];
    d1_source_q <= f3_instruction_i[BITS-1:0];
    d1_op_q <= f3_op;
    d1_always_q <= f3_instruction_i[ALWAYS_AT];
    d1_other1_q <= f3_kind == CONSTANT_S1;
    d1_other2_q <= f3_kind == CONSTANT_S2 || f3_collects;
    d1_collects_q <= f3_collects;
  end

  // ---- ID2: decode -----------------------------------------------------------------------------
  reg [OP_BITS-1:0] d2_op_q;
  reg d2_always_q, d2_collects_q;
  reg [BITS-1:0] d2_source_q;
  always @(posedge clk_i) begin
    d2_op_q <= d1_op_q;
    d2_always_q <= d1_always_q;
    d2_collects_q <= d1_collects_q;
    d2_source_q <= d1_source_q;
  end

  // The adder and what stands beside it are those of MPU1 to MPU3, under their opcodes.
  reg [`RUNG_OP_BITS-1:0] d2_alu_op;
  wire d2_take_wide = d2_op_q == `RUNG_WIDE_OP_MW0 || d2_op_q == `RUNG_WIDE_OP_MW1 ||
                      d2_op_q == `RUNG_WIDE_OP_MW2 || d2_op_q == `RUNG_WIDE_OP_MW3;
  wire [1:0] d2_word = {
    d2_op_q == `RUNG_WIDE_OP_MW2 || d2_op_q == `RUNG_WIDE_OP_MW3,
    d2_op_q == `RUNG_WIDE_OP_MW1 || d2_op_q == `RUNG_WIDE_OP_MW3
  };
  reg d2_result, d2_test, d2_get, d2_high, d2_start;
  always @* begin
    d2_alu_op = `RUNG_OP_MV;
    d2_result = 1'b1;
    d2_test   = 1'b0;
    case (d2_op_q)
      `RUNG_WIDE_OP_MV, `RUNG_WIDE_OP_MULL, `RUNG_WIDE_OP_MULH, `RUNG_WIDE_OP_QUO,
      `RUNG_WIDE_OP_REM, `RUNG_WIDE_OP_MW0, `RUNG_WIDE_OP_MW1, `RUNG_WIDE_OP_MW2, `RUNG_WIDE_OP_MW3:
      ;
      `RUNG_WIDE_OP_ADD: d2_alu_op = `RUNG_OP_ADD;
      `RUNG_WIDE_OP_SUB: d2_alu_op = `RUNG_OP_SUB;
      `RUNG_WIDE_OP_ADC: d2_alu_op = `RUNG_OP_ADC;
      `RUNG_WIDE_OP_SBC: d2_alu_op = `RUNG_OP_SBC;
      `RUNG_WIDE_OP_WAND: d2_alu_op = `RUNG_OP_WAND;
      `RUNG_WIDE_OP_WOR: d2_alu_op = `RUNG_OP_WOR;
      `RUNG_WIDE_OP_WXOR: d2_alu_op = `RUNG_OP_WXOR;
      `RUNG_WIDE_OP_ROL: d2_alu_op = `RUNG_OP_ROL;
      `RUNG_WIDE_OP_MINU: d2_alu_op = `RUNG_OP_MINU;
      `RUNG_WIDE_OP_MVA: d2_alu_op = `RUNG_OP_MVA;
      default: begin
        d2_result = 1'b0;
        d2_test   = 1'b1;
        case (d2_op_q)
          `RUNG_WIDE_OP_EQ: d2_alu_op = `RUNG_OP_EQ;
          `RUNG_WIDE_OP_LT: d2_alu_op = `RUNG_OP_LT;
          `RUNG_WIDE_OP_LTU: d2_alu_op = `RUNG_OP_LTU;
          `RUNG_WIDE_OP_LTC: d2_alu_op = `RUNG_OP_LTC;
          `RUNG_WIDE_OP_TB: d2_alu_op = `RUNG_OP_TB;
          default: d2_test = 1'b0;
        endcase
      end
    endcase
    d2_get   = d2_op_q == `RUNG_WIDE_OP_GET;
    d2_high  = d2_op_q == `RUNG_WIDE_OP_LDH;
    d2_start = d2_op_q == `RUNG_WIDE_OP_MULD || d2_op_q == `RUNG_WIDE_OP_DIVD;
  end

  // ---- ID3: what comes from the units, or stands in the instruction ----------------------------
  reg [OP_BITS-1:0] d3_op_q;
  reg d3_always_q, d3_result_q, d3_test_q, d3_get_q, d3_high_q, d3_start_q;
  reg [BITS-1:0] d3_source_q;
  always @(posedge clk_i) begin
    d3_op_q <= d2_op_q;
    d3_always_q <= d2_always_q;
    d3_result_q <= d2_result;
    d3_test_q <= d2_test;
    d3_get_q <= d2_get;
    d3_high_q <= d2_high;
    d3_start_q <= d2_start;
    d3_source_q <= d2_source_q & {BITS{!d2_collects_q}};
  end

  wire [BITS-1:0] d3_low;
  wire [BITS-1:0] d3_high;
  wire [BITS-1:0] d3_quotient;
  wire [BITS-1:0] d3_remainder;
  wire [BITS-1:0] d3_wide;
  wire d3_zero, d3_zero_late, d3_wide_valid;
  reg d3_take_low_q, d3_take_high_q, d3_take_quotient_q, d3_take_remainder_q, d3_take_wide_q;
  always @(posedge clk_i) begin
    d3_take_low_q <= d2_op_q == `RUNG_WIDE_OP_MULL;
    d3_take_high_q <= d2_op_q == `RUNG_WIDE_OP_MULH;
    d3_take_quotient_q <= d2_op_q == `RUNG_WIDE_OP_QUO;
    d3_take_remainder_q <= d2_op_q == `RUNG_WIDE_OP_REM;
    d3_take_wide_q <= d2_take_wide;
  end
  wire [BITS-1:0] d3_other2 = d3_source_q |
      (d3_low & {BITS{d3_take_low_q}}) | (d3_high & {BITS{d3_take_high_q}}) |
      (d3_quotient & {BITS{d3_take_quotient_q}}) | (d3_remainder & {BITS{d3_take_remainder_q}}) |
      (d3_wide & {BITS{d3_take_wide_q}});
  wire d3_no_result = (d3_take_quotient_q && d3_zero) || (d3_take_remainder_q && d3_zero_late) ||
      (d3_take_wide_q && !d3_wide_valid);

  // ---- operands --------------------------------------------------------------------------------
  reg [BITS-1:0] w_value_q;
  reg [BITS-1:0] b_value_q;
  wire [BITS-1:0] x_s1;
  wire [BITS-1:0] x_s2;
  wire [BITS-1:0] x_keep;
  row_operand #(
      .WIDTH(BITS),
      .LANES(UNITS),
      .LANE_BITS(UNIT_BITS),
      .ADDR_BITS(ADDR_BITS)
  ) s1 (
      .clk_i(clk_i),
      .d1_lane_i(d1_s1_q[UNIT_BITS-1:0]),
      .d1_row_i(d1_s1_q[UNIT_BITS+:ROW_BITS]),
      .d1_other_i(d1_other1_q),
      .d3_other_i(d3_source_q),
      .w_own_i(w_value_q),
      .b_row_i(b_row_i),
      .b_we_i(b_we_i),
      .b_addr_i(b_addr_i),
      .x_value_o(x_s1)
  );
  row_operand #(
      .WIDTH(BITS),
      .LANES(UNITS),
      .LANE_BITS(UNIT_BITS),
      .ADDR_BITS(ADDR_BITS)
  ) s2 (
      .clk_i(clk_i),
      .d1_lane_i(d1_s2_q[UNIT_BITS-1:0]),
      .d1_row_i(d1_s2_q[UNIT_BITS+:ROW_BITS]),
      .d1_other_i(d1_other2_q),
      .d3_other_i(d3_other2),
      .w_own_i(w_value_q),
      .b_row_i(b_row_i),
      .b_we_i(b_we_i),
      .b_addr_i(b_addr_i),
      .x_value_o(x_s2)
  );
  // Only this unit's lane.
  row_operand #(
      .WIDTH(BITS),
      .LANES(1),
      .LANE_BITS(1),
      .ADDR_BITS(ADDR_BITS)
  ) keep (
      .clk_i(clk_i),
      .d1_lane_i(1'b0),
      .d1_row_i(d1_keep_q),
      .d1_other_i(1'b0),
      .d3_other_i({BITS{1'b0}}),
      .w_own_i(w_value_q),
      .b_row_i(b_value_q),
      .b_we_i(b_we_i),
      .b_addr_i(b_addr_i),
      .x_value_o(x_keep)
  );

  // ---- EX --------------------------------------------------------------------------------------
  reg x_always_q, x_result_q, x_no_result_q, x_test_q, x_get_q, x_high_q, x_start_q, x_wide_div_q;
  always @(posedge clk_i) begin
    x_always_q <= d3_always_q;
    x_result_q <= d3_result_q && !d3_no_result;
    x_no_result_q <= d3_no_result;
    x_test_q <= d3_test_q;
    x_get_q <= d3_get_q;
    x_high_q <= d3_high_q;
    x_start_q <= d3_start_q;
    x_wide_div_q <= d3_op_q == `RUNG_WIDE_OP_DIVD;
  end

  reg [BITS-1:0] acc_q;
  wire [BITS-1:0] x_result;
  wire [BITS-1:0] x_sum;
  wire [BITS-1:0] x_bank;
  wire x_test;
  alu alu (
      .clk_i(clk_i),
      .scan_start_i(x_start_i),
      .d2_op_i(d2_alu_op),
      .x_s1_i(x_s1),
      .x_s2_i(x_s2),
      .x_acc_i(acc_q),
      .x_cross_i({BITS{1'b0}}),
      .x_result_o(x_result),
      .x_bank_o(x_bank),
      .x_sum_o(x_sum),
      .x_test_o(x_test)
  );
  wire unused_alu = &{1'b0, x_sum, x_bank};

  wire x_gate = x_always_q || x_gate_i;
  reg  w_flag_q;
  reg  w_div_by_0_q;
  always @(posedge clk_i) begin
    w_value_q <= x_result_q && x_gate ? x_result : x_keep;
    b_value_q <= w_value_q;
    w_div_by_0_q <= x_no_result_q && x_gate;
    if (x_test_q) w_flag_q <= x_test;
  end
  assign w_value_o = w_value_q;
  assign w_flag_o = w_flag_q;
  assign w_div_by_0_o = w_div_by_0_q;

  // GET takes what slot 2u looks up; a clock later it is in the accumulator.
  reg w_get_q, w_clear_q;
  reg [ARITY-1:0] w_operands_q;
  always @(posedge clk_i) begin
    w_get_q <= x_get_q;
    w_clear_q <= x_always_q;
    w_operands_q <= x_operands_i;
    if (w_get_q) acc_q <= {w_clear_q ? {BITS - ARITY{1'b0}} : acc_q[BITS-ARITY-1:0], w_operands_q};
  end

  // ---- multiply, divide ------------------------------------------------------------------------
  wide_multiplier multiplier (
      .clk_i(clk_i),
      .x_s1_i(x_s1),
      .x_s2_i(x_s2),
      .d3_low_o(d3_low),
      .d3_high_o(d3_high)
  );

  generate
    if (DIVIDER != 0) begin : g_divider
      wide_divider divider (
          .clk_i(clk_i),
          .x_s1_i(x_s1),
          .x_s2_i(x_s2),
          .d3_quotient_o(d3_quotient),
          .d3_remainder_o(d3_remainder),
          .d3_zero_o(d3_zero),
          .d3_zero_late_o(d3_zero_late)
      );
    end else begin : g_no_divider
      assign {d3_quotient, d3_remainder, d3_zero, d3_zero_late} = {2 * BITS + 2{1'b0}};
    end
    if (WIDE != 0) begin : g_wide
      // Its result is taken a stage before ID3: that is a sum behind a choice of words.
      wire [BITS-1:0] d2_wide;
      wire d2_wide_valid;
      reg [BITS-1:0] d3_wide_q;
      reg d3_wide_valid_q;
      always @(posedge clk_i) {d3_wide_q, d3_wide_valid_q} <= {d2_wide, d2_wide_valid};
      assign d3_wide = d3_wide_q;
      assign d3_wide_valid = d3_wide_valid_q;
      wire unused_zero;
      muldiv #(
          .MUL_DSP(0)
      ) unit (
          .clk_i(clk_i),
          .rst_ni(rst_ni),
          .scan_start_i(x_start_i),
          .x_start_i(x_start_q),
          .x_executed_i(1'b1),
          .x_div_i(x_wide_div_q),
          .x_wide_i(1'b1),
          .x_high_i(x_high_q),
          .x_s1_i(x_s1),
          .x_s2_i(x_s2),
          .d3_word_i(d2_word),
          .d3_result_o(d2_wide),
          .d3_valid_o(d2_wide_valid),
          .w_div_by_0_o(unused_zero)
      );
    end else begin : g_no_wide
      assign {d3_wide, d3_wide_valid} = {{BITS{1'b0}}, 1'b1};
      wire unused_wide = &{1'b0, rst_ni, x_start_q, x_high_q, x_wide_div_q, d2_word};
    end
  endgenerate

endmodule

`default_nettype wire

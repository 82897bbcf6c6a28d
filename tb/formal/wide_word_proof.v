// SPDX-License-Identifier: Apache-2.0
// A word unit of MPU4 (hdl/wide/word_unit.v), full width: result <- gate ? op(s1, s2) : keep, for every operation but
// those of the multiplier and the dividers, with constants and near values as operands; flag, carry and
// accumulator as hdl/isa/wide.toml has them. What is free: instructions, gates, rows, bits.
`default_nettype none
`include "rung_wide.vh"

module wide_word_proof #(
    parameter UNITS = 2,
    parameter UNIT_BITS = 1,
    parameter ARITY = 3,
    parameter ADDR_BITS = 1,
    parameter CARRY_ONLY = 0,  // 1: only what sets or takes carry or accumulator, in longer runs
    parameter INSTRUCTION_BITS = `RUNG_WIDE_LAYOUT_WORD_BITS + UNIT_BITS +
        2 * `RUNG_WIDE_LAYOUT_ROW_BITS + `RUNG_WIDE_LAYOUT_KIND_BITS + 1 + `RUNG_WIDE_LAYOUT_OP_BITS
) (
    input wire clk_i,
    input wire [INSTRUCTION_BITS-1:0] instruction_i,
    input wire [ARITY-1:0] operands_i,
    input wire gate_i,
    input wire [UNITS*`RUNG_WIDE_LAYOUT_WORD_BITS-1:0] bus_i,
    input wire we_i,
    input wire [ADDR_BITS-1:0] addr_i
);

  localparam BITS = `RUNG_WIDE_LAYOUT_WORD_BITS;
  localparam ROW_BITS = `RUNG_WIDE_LAYOUT_ROW_BITS;
  localparam OP_BITS = `RUNG_WIDE_LAYOUT_OP_BITS;
  localparam NEAR_BITS = ROW_BITS - `RUNG_WIDE_LAYOUT_SPECIAL_BITS;
  localparam S1_AT = BITS;
  localparam KEEP_AT = S1_AT + UNIT_BITS + ROW_BITS;
  localparam KIND_AT = KEEP_AT + ROW_BITS;
  localparam ALWAYS_AT = KIND_AT + `RUNG_WIDE_LAYOUT_KIND_BITS;
  localparam OP_AT = ALWAYS_AT + 1;
  localparam AGES = 6;

  wire [BITS-1:0] value;
  wire flag, div_by_0;
  word_unit #(
      .UNITS(UNITS),
      .UNIT_BITS(UNIT_BITS),
      .ADDR_BITS(ADDR_BITS),
      .ARITY(ARITY),
      .INSTRUCTION_BITS(INSTRUCTION_BITS),
      .DIVIDER(0),
      .WIDE(0)
  ) unit (
      .clk_i(clk_i),
      .rst_ni(1'b1),
      .f3_instruction_i(instruction_i),
      .x_start_i(1'b0),
      .x_operands_i(operands_i),
      .x_gate_i(gate_i),
      .b_row_i(bus_i),
      .b_we_i(we_i),
      .b_addr_i(addr_i),
      .w_value_o(value),
      .w_flag_o(flag),
      .w_div_by_0_o(div_by_0)
  );

  reg [INSTRUCTION_BITS-1:0] instruction_q[1:AGES];
  reg [BITS-1:0] value_q[1:AGES];
  reg [UNITS*BITS-1:0] bus_q[1:AGES];
  reg [ARITY-1:0] operands_q[1:AGES];
  reg gate_q;
  reg flag_before_q;
  reg [3:0] age_q;
  initial age_q = 4'd0;
  integer i;
  always @(posedge clk_i) begin
    instruction_q[1] <= instruction_i;
    value_q[1] <= value;
    bus_q[1] <= bus_i;
    operands_q[1] <= operands_i;
    for (i = 2; i <= AGES; i = i + 1) begin
      instruction_q[i] <= instruction_q[i-1];
      value_q[i] <= value_q[i-1];
      bus_q[i] <= bus_q[i-1];
      operands_q[i] <= operands_q[i-1];
    end
    gate_q <= gate_i;
    flag_before_q <= flag;
    if (age_q != 4'd15) age_q <= age_q + 4'd1;
  end

  // ---- the instruction whose result is there now: in IF3 five clocks ago, in EX one ------------
  wire [INSTRUCTION_BITS-1:0] now = instruction_q[5];
  wire [OP_BITS-1:0] op = now[OP_AT+:OP_BITS];
  wire [1:0] kind = now[KIND_AT+:2];
  wire gate = now[ALWAYS_AT] || gate_q;

  // A near value by its place: zero, own 1 to 3, bus 4 to 6. `lane` counts on the bus.
  function automatic [BITS-1:0] near_value(input reg [UNIT_BITS-1:0] lane,
                                           input reg [NEAR_BITS-1:0] near);
    case (near)
      `RUNG_WIDE_NEAR_OWN_FIRST: near_value = value_q[1];
      `RUNG_WIDE_NEAR_OWN_FIRST + 1: near_value = value_q[2];
      `RUNG_WIDE_NEAR_OWN_LAST: near_value = value_q[3];
      `RUNG_WIDE_NEAR_BUS_FIRST: near_value = bus_q[3][lane*BITS+:BITS];
      `RUNG_WIDE_NEAR_BUS_FIRST + 1: near_value = bus_q[4][lane*BITS+:BITS];
      `RUNG_WIDE_NEAR_BUS_LAST: near_value = bus_q[5][lane*BITS+:BITS];
      default: near_value = {BITS{1'b0}};
    endcase
  endfunction
  wire [BITS-1:0] constant = now[BITS-1:0];
  wire [BITS-1:0] low_place = near_value(now[UNIT_BITS-1:0], now[UNIT_BITS+:NEAR_BITS]);
  wire [BITS-1:0] high_place = near_value(now[S1_AT+:UNIT_BITS], now[S1_AT+UNIT_BITS+:NEAR_BITS]);
  wire [BITS-1:0] s1 = kind == 2'd2 ? constant : high_place;
  wire [BITS-1:0] s2 = kind == 2'd0 ? low_place : kind == 2'd1 ? constant : high_place;
  // `keep` has no lane; off the bus it is the unit's own value again, which bus_i need not be here.
  wire [NEAR_BITS-1:0] keep_near = now[KEEP_AT+:NEAR_BITS];
  wire keep_own = keep_near <= `RUNG_WIDE_NEAR_OWN_LAST;
  wire [BITS-1:0] keep = near_value({UNIT_BITS{1'b0}}, keep_near);

  wire known = age_q > 4'd5;
  // Every place is near, and none asks for a flag, which words do not have.
  always @* begin
    assume (&instruction_i[KEEP_AT+NEAR_BITS+:ROW_BITS-NEAR_BITS]);
    assume (instruction_i[KEEP_AT+:NEAR_BITS] != `RUNG_WIDE_NEAR_FLAG);
    assume (&instruction_i[S1_AT+UNIT_BITS+NEAR_BITS+:ROW_BITS-NEAR_BITS]);
    assume (instruction_i[S1_AT+UNIT_BITS+:NEAR_BITS] != `RUNG_WIDE_NEAR_FLAG);
    assume (instruction_i[KIND_AT+:2] != 2'd3);
    if (instruction_i[KIND_AT+:2] == 2'd0) begin
      assume (&instruction_i[UNIT_BITS+NEAR_BITS+:ROW_BITS-NEAR_BITS]);
      assume (instruction_i[UNIT_BITS+:NEAR_BITS] != `RUNG_WIDE_NEAR_FLAG);
    end
  end

  // With CARRY_ONLY places are 0 and the last value, and operations those of carry and accumulator.
  wire [OP_BITS-1:0] next_op = instruction_i[OP_AT+:OP_BITS];
  always @* begin
    if (CARRY_ONLY != 0) begin
      assume (instruction_i[KEEP_AT+:NEAR_BITS] == `RUNG_WIDE_NEAR_ZERO);
      assume (instruction_i[S1_AT+UNIT_BITS+:NEAR_BITS] <= `RUNG_WIDE_NEAR_OWN_FIRST);
      assume (instruction_i[KIND_AT+:2] != 2'd0);
      assume (next_op == `RUNG_WIDE_OP_ADD || next_op == `RUNG_WIDE_OP_ADC ||
              next_op == `RUNG_WIDE_OP_SUB || next_op == `RUNG_WIDE_OP_SBC ||
              next_op == `RUNG_WIDE_OP_LTU || next_op == `RUNG_WIDE_OP_LTC ||
              next_op == `RUNG_WIDE_OP_GET || next_op == `RUNG_WIDE_OP_MVA ||
              next_op == `RUNG_WIDE_OP_NOP);
    end
  end

  // ---- carry, accumulator ----------------------------------------------------------------------
  reg carry_q;  // before the instruction; known after the first that sets it
  reg carry_known_q;
  initial carry_known_q = 1'b0;
  wire [BITS:0] sum = {1'b0, s1} + {1'b0, s2} + {{BITS{1'b0}}, op == `RUNG_WIDE_OP_ADC && carry_q};
  wire [BITS:0] difference =
      {1'b0, s1} - {1'b0, s2} - {{BITS{1'b0}}, op == `RUNG_WIDE_OP_SBC && carry_q};
  wire adds = op == `RUNG_WIDE_OP_ADD || op == `RUNG_WIDE_OP_ADC;
  wire subtracts = op == `RUNG_WIDE_OP_SUB || op == `RUNG_WIDE_OP_SBC || op == `RUNG_WIDE_OP_LTU;
  wire takes_carry = op == `RUNG_WIDE_OP_ADC || op == `RUNG_WIDE_OP_SBC || op == `RUNG_WIDE_OP_LTC;
  always @(posedge clk_i) begin
    if (known && (adds || subtracts)) begin
      carry_q <= adds ? sum[BITS] : difference[BITS];
      carry_known_q <= carry_known_q || !takes_carry;
    end
  end

  wire is_get = op == `RUNG_WIDE_OP_GET;
  // GET shows two steps later: acc_q is what the instruction before the last has left.
  reg [BITS-1:0] acc_q;
  reg acc_known_q;
  reg get_q, clear_q, known_q;
  reg [ARITY-1:0] bits_q;
  initial {acc_known_q, get_q, known_q} = 3'b000;
  always @(posedge clk_i) begin
    get_q <= known && is_get;
    clear_q <= now[ALWAYS_AT];
    bits_q <= operands_q[1];
    if (get_q) begin
      acc_q <= {clear_q ? {BITS - ARITY{1'b0}} : acc_q[BITS-ARITY-1:0], bits_q};
      acc_known_q <= acc_known_q || clear_q;
    end
  end

  // ---- what it has to be -----------------------------------------------------------------------
  wire [2*BITS-1:0] rotated = {s1, s1} << s2[3:0];
  wire signed [BITS:0] s1_less_borrow = {s1[BITS-1], s1} - {{BITS{1'b0}}, carry_q};
  always @* begin
    if (known) begin
      assert (!div_by_0);
      case (op)
        `RUNG_WIDE_OP_MV, `RUNG_WIDE_OP_ADD, `RUNG_WIDE_OP_SUB, `RUNG_WIDE_OP_WAND,
        `RUNG_WIDE_OP_WOR, `RUNG_WIDE_OP_WXOR, `RUNG_WIDE_OP_ROL, `RUNG_WIDE_OP_MINU,
        `RUNG_WIDE_OP_ADC, `RUNG_WIDE_OP_SBC, `RUNG_WIDE_OP_MVA: begin
          if (!gate && keep_own) assert (value == keep);
        end
        `RUNG_WIDE_OP_MULL, `RUNG_WIDE_OP_MULH, `RUNG_WIDE_OP_QUO, `RUNG_WIDE_OP_REM,
        `RUNG_WIDE_OP_MW0, `RUNG_WIDE_OP_MW1, `RUNG_WIDE_OP_MW2, `RUNG_WIDE_OP_MW3: ;
        default: if (keep_own) assert (value == keep);
      endcase
      if (gate) begin
        case (op)
          `RUNG_WIDE_OP_MV: assert (value == s2);
          `RUNG_WIDE_OP_ADD: assert (value == sum[BITS-1:0]);
          `RUNG_WIDE_OP_SUB: assert (value == difference[BITS-1:0]);
          `RUNG_WIDE_OP_ADC: if (carry_known_q) assert (value == sum[BITS-1:0]);
          `RUNG_WIDE_OP_SBC: if (carry_known_q) assert (value == difference[BITS-1:0]);
          `RUNG_WIDE_OP_WAND: assert (value == (s1 & s2));
          `RUNG_WIDE_OP_WOR: assert (value == (s1 | s2));
          `RUNG_WIDE_OP_WXOR: assert (value == (s1 ^ s2));
          `RUNG_WIDE_OP_ROL: assert (value == rotated[2*BITS-1:BITS]);
          `RUNG_WIDE_OP_MINU: assert (value == (s1 < s2 ? s1 : s2));
          `RUNG_WIDE_OP_MVA: if (acc_known_q && !get_q) assert (value == acc_q);
          default: ;
        endcase
      end
      // The flag, whatever the gate.
      case (op)
        `RUNG_WIDE_OP_EQ: assert (flag == (s1 == s2));
        `RUNG_WIDE_OP_LT: assert (flag == ($signed(s1) < $signed(s2)));
        `RUNG_WIDE_OP_LTU: assert (flag == (s1 < s2));
        `RUNG_WIDE_OP_LTC:
        if (carry_known_q) assert (flag == (s1_less_borrow < $signed({s2[BITS-1], s2})));
        `RUNG_WIDE_OP_TB: assert (flag == s1[s2[3:0]]);
        default: assert (flag == flag_before_q);
      endcase
    end
  end

  always @* begin
    if (known) begin
      cover (op == `RUNG_WIDE_OP_ADC && carry_known_q && carry_q && gate);
      cover (op == `RUNG_WIDE_OP_MVA && acc_known_q && !get_q && gate && value == 16'hA5A5);
      cover (op == `RUNG_WIDE_OP_LTC && carry_known_q && carry_q && flag);
    end
  end

  generate
    if (CARRY_ONLY == 0) begin : g_kept
      always @* if (known) cover (op == `RUNG_WIDE_OP_SUB && !gate && value == 16'h1234);
    end
  endgenerate

endmodule

`default_nettype wire

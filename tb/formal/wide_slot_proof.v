// SPDX-License-Identifier: Apache-2.0
// A bit slot of MPU4 (hdl/wide/bit_slot.v): its result is the entry of the instruction's table that its operands
// select, in a fixed number of clocks, for any table and any operands; and each operand is the one that its
// own field of the instruction names. What a place means is wide_operand_proof.v.
`default_nettype none
`include "rung_wide.vh"

module wide_slot_proof #(
    parameter SLOTS = 4,
    parameter SLOT_BITS = 2,
    parameter ARITY = 3,
    parameter ADDR_BITS = 2,
    parameter INSTRUCTION_BITS = (1 << ARITY) + ARITY * (SLOT_BITS + `RUNG_WIDE_LAYOUT_ROW_BITS)
) (
    input wire clk_i,
    input wire [INSTRUCTION_BITS-1:0] instruction_i,
    input wire flag_i,
    input wire [SLOTS-1:0] bus_i,
    input wire we_i,
    input wire [ADDR_BITS-1:0] addr_i
);

  localparam TABLE_BITS = 1 << ARITY;
  localparam ROW_BITS = `RUNG_WIDE_LAYOUT_ROW_BITS;
  localparam PLACE_BITS = SLOT_BITS + ROW_BITS;
  localparam NEAR_BITS = ROW_BITS - `RUNG_WIDE_LAYOUT_SPECIAL_BITS;
  localparam AGES = 5;

  wire value;
  wire [ARITY-1:0] operands;
  bit_slot #(
      .SLOTS(SLOTS),
      .SLOT_BITS(SLOT_BITS),
      .ARITY(ARITY),
      .INSTRUCTION_BITS(INSTRUCTION_BITS),
      .ADDR_BITS(ADDR_BITS)
  ) slot (
      .clk_i(clk_i),
      .d1_instruction_i(instruction_i),
      .d3_flag_i(flag_i),
      .b_row_i(bus_i),
      .b_we_i(we_i),
      .b_addr_i(addr_i),
      .w_value_o(value),
      .x_operands_o(operands)
  );

  reg [INSTRUCTION_BITS-1:0] instruction_q[1:AGES];
  reg [ARITY-1:0] operands_q;
  reg value_q[1:AGES];
  reg flag_q[1:AGES];
  reg [SLOTS-1:0] bus_q[1:AGES];
  reg [3:0] age_q;
  initial age_q = 4'd0;
  integer i;
  always @(posedge clk_i) begin
    instruction_q[1] <= instruction_i;
    value_q[1] <= value;
    flag_q[1] <= flag_i;
    bus_q[1] <= bus_i;
    for (i = 2; i <= AGES; i = i + 1) begin
      instruction_q[i] <= instruction_q[i-1];
      value_q[i] <= value_q[i-1];
      flag_q[i] <= flag_q[i-1];
      bus_q[i] <= bus_q[i-1];
    end
    operands_q <= operands;
    if (age_q != 4'd15) age_q <= age_q + 4'd1;
  end

  always @* if (age_q > 4'd6) assert (value == instruction_q[4][operands_q]);

  // Operand i: c is 0, a the highest.
  genvar g;
  generate
    for (g = 0; g < ARITY; g = g + 1) begin : g_operand
      wire [PLACE_BITS-1:0] place = instruction_q[3][TABLE_BITS+g*PLACE_BITS+:PLACE_BITS];
      wire [SLOT_BITS-1:0] lane = place[SLOT_BITS-1:0];
      wire special = &place[PLACE_BITS-1:SLOT_BITS+NEAR_BITS];
      wire [NEAR_BITS-1:0] near = place[SLOT_BITS+:NEAR_BITS];
      always @* begin
        if (age_q > 4'd6 && special) begin
          case (near)
            `RUNG_WIDE_NEAR_ZERO: assert (operands[g] == 1'b0);
            `RUNG_WIDE_NEAR_OWN_FIRST: assert (operands[g] == value);
            `RUNG_WIDE_NEAR_OWN_FIRST + 1: assert (operands[g] == value_q[1]);
            `RUNG_WIDE_NEAR_OWN_LAST: assert (operands[g] == value_q[2]);
            `RUNG_WIDE_NEAR_BUS_FIRST: assert (operands[g] == bus_q[2][lane]);
            `RUNG_WIDE_NEAR_BUS_FIRST + 1: assert (operands[g] == bus_q[3][lane]);
            `RUNG_WIDE_NEAR_BUS_LAST: assert (operands[g] == bus_q[4][lane]);
            default: assert (operands[g] == flag_q[1]);
          endcase
        end
      end
    end
  endgenerate

  always @* begin
    if (age_q > 4'd8) begin
      cover (operands == 3'b101 && instruction_q[3][TABLE_BITS-1:0] == 8'h20);
      cover (value && value_q[1] && !value_q[2]);
    end
  end

endmodule

`default_nettype wire

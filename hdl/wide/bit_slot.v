// SPDX-License-Identifier: Apache-2.0
// A bit slot of MPU4: three operands, each a place or a near value, and their look-up in the table that the
// instruction carries. The result is this slot's lane of the step's row.
`default_nettype none
`include "rung_wide.vh"

module bit_slot #(
    parameter SLOTS = 16,
    parameter SLOT_BITS = 4,
    parameter ARITY = 3,  // operands
    parameter INSTRUCTION_BITS = 50,
    parameter ADDR_BITS = 10  // of the rows of bits
) (
    input  wire                        clk_i,
    // ID1: the table, above it the operands c, b, a, each lane and above it row
    input  wire [INSTRUCTION_BITS-1:0] d1_instruction_i,
    // ID3: the flag of the word unit beside this slot
    input  wire                        d3_flag_i,
    // the row of all slots, a clock after `w`, and where it goes
    input  wire [           SLOTS-1:0] b_row_i,
    input  wire                        b_we_i,
    input  wire [       ADDR_BITS-1:0] b_addr_i,
    output wire                        w_value_o,
    // EX: the operands, a the highest
    output wire [           ARITY-1:0] x_operands_o
);

  localparam TABLE_BITS = 1 << ARITY;
  localparam ROW_BITS = `RUNG_WIDE_LAYOUT_ROW_BITS;
  localparam PLACE_BITS = SLOT_BITS + ROW_BITS;

  reg w_value_q;
  genvar i;
  generate
    for (i = 0; i < ARITY; i = i + 1) begin : g_operand
      row_operand #(
          .WIDTH(1),
          .LANES(SLOTS),
          .LANE_BITS(SLOT_BITS),
          .ADDR_BITS(ADDR_BITS)
      ) operand (
          .clk_i(clk_i),
          .d1_lane_i(d1_instruction_i[TABLE_BITS+i*PLACE_BITS+:SLOT_BITS]),
          .d1_row_i(d1_instruction_i[TABLE_BITS+i*PLACE_BITS+SLOT_BITS+:ROW_BITS]),
          .d1_other_i(1'b0),
          .d3_other_i(d3_flag_i),
          .w_own_i(w_value_q),
          .b_row_i(b_row_i),
          .b_we_i(b_we_i),
          .b_addr_i(b_addr_i),
          .x_value_o(x_operands_o[i])
      );
    end
  endgenerate

  reg [TABLE_BITS-1:0] d2_table_q;
  reg [TABLE_BITS-1:0] d3_table_q;
  reg [TABLE_BITS-1:0] x_table_q;
  always @(posedge clk_i) begin
    d2_table_q <= d1_instruction_i[TABLE_BITS-1:0];
    d3_table_q <= d2_table_q;
    x_table_q  <= d3_table_q;
    w_value_q  <= x_table_q[x_operands_o];
  end
  assign w_value_o = w_value_q;

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// A slot of MPU4: its instruction memory, its bit slot and, in every second one, a word unit. Between scans the load
// port puts instructions of its own in (l_): every slot rewrites its place of a row with what it holds, but
// for the one whose value the host gives.
`default_nettype none
`include "rung_wide.vh"

module wide_slot #(
    parameter SLOTS = 16,
    parameter SLOT_BITS = 4,
    parameter SLOT = 0,  // this one
    parameter UNIT_BITS = 3,
    parameter ARITY = 3,
    parameter HAS_UNIT = 1,
    parameter DIVIDER = 1,
    parameter WIDE = 1,
    parameter PC_BITS = 9,
    parameter BIT_ADDR = 10,
    parameter WORD_ADDR = 9,
    parameter BIT_PART = 50,  // of an instruction: the bit slot's part, and the word unit's
    parameter WORD_PART = 47,
    parameter INSTRUCTION_BITS = 97
) (
    input  wire                                             clk_i,
    input  wire                                             rst_ni,
    // instruction memory
    input  wire                                             m_write_i,
    input  wire [                              PC_BITS-1:0] m_addr_i,
    input  wire [                     INSTRUCTION_BITS-1:0] m_data_i,
    input  wire [                              PC_BITS-1:0] f1_pc_i,
    input  wire                                             f2_valid_i,
    // IF3, while no instruction is there (else 0): the row of operand a and of `keep`; with l_lane_i a has
    // this slot's lane; the table's halves for a; with l_set_i a constant for the word unit
    input  wire [           `RUNG_WIDE_LAYOUT_ROW_BITS-1:0] l_row_i,
    input  wire                                             l_lane_i,
    input  wire                                             l_high_i,
    input  wire                                             l_low_i,
    input  wire                                             l_set_i,
    input  wire [          `RUNG_WIDE_LAYOUT_WORD_BITS-1:0] l_data_i,
    // EX: a scan has started and its first step is not here yet
    input  wire                                             x_start_i,
    // ID3: the flag of the unit beside this slot; after EX: the unit's own
    input  wire                                             d3_flag_i,
    output wire                                             w_flag_o,
    output wire                                             w_div_by_0_o,
    // the row of all, a clock after `w`, and where it goes
    input  wire [                                SLOTS-1:0] b_bits_i,
    input  wire [(SLOTS/2)*`RUNG_WIDE_LAYOUT_WORD_BITS-1:0] b_words_i,
    input  wire                                             b_bit_we_i,
    input  wire                                             b_word_we_i,
    input  wire [           `RUNG_WIDE_LAYOUT_ROW_BITS-1:0] b_addr_i,
    output wire                                             w_bit_o,
    output wire [          `RUNG_WIDE_LAYOUT_WORD_BITS-1:0] w_word_o
);

  localparam ROW_BITS = `RUNG_WIDE_LAYOUT_ROW_BITS;
  localparam PLACE_BITS = SLOT_BITS + ROW_BITS;
  localparam TABLE_BITS = 1 << ARITY;
  localparam KIND_BITS = `RUNG_WIDE_LAYOUT_KIND_BITS;
  localparam OP_BITS = `RUNG_WIDE_LAYOUT_OP_BITS;

  // ---- IF2, IF3 --------------------------------------------------------------------------------
  wire [INSTRUCTION_BITS-1:0] f2_instruction;
  bank_ram #(
      .WIDTH(INSTRUCTION_BITS),
      .DEPTH(1 << PC_BITS),
      .ADDR_BITS(PC_BITS),
      .CLEARED(0)
  ) memory (
      .clk_i(clk_i),
      .read_i(1'b1),
      .read_addr_i(f1_pc_i),
      .read_data_o(f2_instruction),
      .write_i(m_write_i),
      .write_addr_i(m_addr_i),
      .write_data_i(m_data_i)
  );

  // One in each slot, for its fan-out
  (* keep *) reg f3_valid_q;
  reg [INSTRUCTION_BITS-1:0] f3_instruction_q;
  always @(posedge clk_i) begin
    f3_valid_q <= f2_valid_i && rst_ni;
    f3_instruction_q <= f2_instruction;
  end
  wire [INSTRUCTION_BITS-1:0] f3_program = f3_instruction_q & {INSTRUCTION_BITS{f3_valid_q}};

  // ---- ID1: the bit slot's part ----------------------------------------------------------------
  localparam [SLOT_BITS-1:0] LANE = SLOT;
  wire [PLACE_BITS-1:0] l_place = {l_row_i, LANE & {SLOT_BITS{l_lane_i}}};
  wire [BIT_PART-1:0] l_bit_part = {
    l_place,
    {BIT_PART - PLACE_BITS - TABLE_BITS{1'b0}},
    {TABLE_BITS / 2{l_high_i}},
    {TABLE_BITS / 2{l_low_i}}
  };
  reg [BIT_PART-1:0] d1_bit_part_q;
  always @(posedge clk_i) d1_bit_part_q <= f3_program[BIT_PART-1:0] | l_bit_part;

  wire [ARITY-1:0] x_operands;
  bit_slot #(
      .SLOTS(SLOTS),
      .SLOT_BITS(SLOT_BITS),
      .ARITY(ARITY),
      .INSTRUCTION_BITS(BIT_PART),
      .ADDR_BITS(BIT_ADDR)
  ) bits (
      .clk_i(clk_i),
      .d1_instruction_i(d1_bit_part_q),
      .d3_flag_i(d3_flag_i),
      .b_row_i(b_bits_i),
      .b_we_i(b_bit_we_i),
      .b_addr_i(b_addr_i[BIT_ADDR-1:0]),
      .w_value_o(w_bit_o),
      .x_operands_o(x_operands)
  );

  // ---- the word unit ---------------------------------------------------------------------------
  generate
    if (HAS_UNIT != 0) begin : g_unit
      localparam [KIND_BITS-1:0] CONSTANT_S2 = 1;
      localparam [OP_BITS-1:0] OP_MV = `RUNG_WIDE_OP_MV;
      wire [WORD_PART-1:0] l_word_part = {
        OP_MV & {OP_BITS{l_set_i}},
        l_set_i,
        CONSTANT_S2 & {KIND_BITS{l_set_i}},
        l_row_i,
        {UNIT_BITS + ROW_BITS{1'b0}},
        l_data_i
      };
      word_unit #(
          .UNITS(SLOTS / 2),
          .UNIT_BITS(UNIT_BITS),
          .ADDR_BITS(WORD_ADDR),
          .ARITY(ARITY),
          .INSTRUCTION_BITS(WORD_PART),
          .DIVIDER(DIVIDER),
          .WIDE(WIDE)
      ) words (
          .clk_i(clk_i),
          .rst_ni(rst_ni),
          .f3_instruction_i(f3_program[BIT_PART+:WORD_PART] | l_word_part),
          .x_start_i(x_start_i),
          .x_operands_i(x_operands),
          .x_gate_i(w_bit_o),
          .b_row_i(b_words_i),
          .b_we_i(b_word_we_i),
          .b_addr_i(b_addr_i[WORD_ADDR-1:0]),
          .w_value_o(w_word_o),
          .w_flag_o(w_flag_o),
          .w_div_by_0_o(w_div_by_0_o)
      );
    end else begin : g_no_unit
      assign w_word_o = {`RUNG_WIDE_LAYOUT_WORD_BITS{1'b0}};
      assign w_flag_o = 1'b0;
      assign w_div_by_0_o = 1'b0;
      wire unused_unit = &{1'b0, x_start_i, x_operands, b_words_i, b_word_we_i};
      wire unused_access = &{1'b0, l_set_i, l_data_i};
    end
  endgenerate

endmodule

`default_nettype wire

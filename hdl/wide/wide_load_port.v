// SPDX-License-Identifier: Apache-2.0
// The load port of MPU4, one access a clock while no scan runs; six clocks have to lie between the last access and
// start_i. Spaces:
//   0 instruction memory, write: address (step * SLOTS + slot) * 8 + chunk, 16 bits of the instruction, the
//     highest chunk last: it writes the instruction
//   2 bits: address row * SLOTS + lane         3 words: address row * UNITS + unit
//   4 control, write: 0 length in steps, 1 first latch row, 2 number of latch rows
// An access to a row goes down the pipeline as an instruction of all slots (wide_slot.v), which read the row and
// write it back but for one lane; if one of the six accesses before has the same row, they take that one's
// result, as a program would. A read answers in the tenth clock after the edge that samples it.
`default_nettype none
`include "rung_wide.vh"

module wide_load_port #(
    parameter SLOTS = 16,
    parameter SLOT_BITS = 4,
    parameter UNIT_BITS = 3,
    parameter PC_BITS = 9,
    parameter LATCH_BITS = 4,
    parameter INSTRUCTION_BITS = 97,
    parameter LAST_EVEN = 6,  // highest chunk of an instruction with a word unit's part
    parameter LAST_ODD = 3  // and of one without
) (
    input wire clk_i,
    input wire rst_ni,
    input wire load_valid_i,
    input wire load_write_i,
    input wire [2:0] load_space_i,
    input wire [19:0] load_addr_i,
    input wire [15:0] load_data_i,
    output wire load_rvalid_o,
    output wire [15:0] load_rdata_o,
    // the program's
    output wire [PC_BITS:0] length_o,
    output wire [`RUNG_WIDE_LAYOUT_ROW_BITS-1:0] latch_row_o,
    output wire [LATCH_BITS-1:0] latch_rows_o,
    // instruction memories
    output wire [SLOTS-1:0] m_write_o,
    output wire [PC_BITS-1:0] m_addr_o,
    output wire [INSTRUCTION_BITS-1:0] m_data_o,
    // IF3; all 0 if there is no access
    output wire l_access_o,
    output wire [`RUNG_WIDE_LAYOUT_ROW_BITS-1:0] l_row_o,
    output wire [`RUNG_WIDE_LAYOUT_ROW_BITS-1:0] l_from_o,  // where the slots read it
    output wire [SLOTS-1:0] l_set_bit_o,
    output wire l_bit_o,
    output wire [SLOTS/2-1:0] l_set_word_o,
    output wire [15:0] l_data_o,
    output wire l_bit_we_o,
    output wire l_word_we_o,
    // a clock after `w`
    input wire [SLOTS-1:0] b_bits_i,
    input wire [(SLOTS/2)*`RUNG_WIDE_LAYOUT_WORD_BITS-1:0] b_words_i
);

  localparam ROW_BITS = `RUNG_WIDE_LAYOUT_ROW_BITS;
  localparam SPECIAL_BITS = `RUNG_WIDE_LAYOUT_SPECIAL_BITS;
  localparam NEAR_BITS = ROW_BITS - SPECIAL_BITS;
  localparam UNITS = SLOTS / 2;
  localparam CHUNKS = (INSTRUCTION_BITS + 15) / 16;
  localparam [2:0] INSTRUCTIONS = 3'd0;
  localparam [2:0] BITS = 3'd2;
  localparam [2:0] WORDS = 3'd3;
  localparam [2:0] CONTROL = 3'd4;
  localparam [2:0] LAST_EVEN_CHUNK = LAST_EVEN[2:0];
  localparam [2:0] LAST_ODD_CHUNK = LAST_ODD[2:0];

  // ---- the access, registered ------------------------------------------------------------------
  reg access_q, write_q;
  reg [ 2:0] space_q;
  reg [19:0] addr_q;
  reg [15:0] data_q;
  always @(posedge clk_i) begin
    access_q <= load_valid_i && rst_ni;
    write_q  <= load_write_i;
    space_q  <= load_space_i;
    addr_q   <= load_addr_i;
    data_q   <= load_data_i;
  end

  reg [PC_BITS:0] length_q;
  reg [ROW_BITS-1:0] latch_row_q;
  reg [LATCH_BITS-1:0] latch_rows_q;
  wire control = access_q && write_q && space_q == CONTROL;
  always @(posedge clk_i) begin
    if (!rst_ni) begin
      length_q <= {PC_BITS + 1{1'b0}};
      latch_rows_q <= {LATCH_BITS{1'b0}};
    end else if (control) begin
      if (addr_q[1:0] == 2'd0) length_q <= data_q[PC_BITS:0];
      if (addr_q[1:0] == 2'd1) latch_row_q <= data_q[ROW_BITS-1:0];
      if (addr_q[1:0] == 2'd2) latch_rows_q <= data_q[LATCH_BITS-1:0];
    end
  end
  assign length_o = length_q;
  assign latch_row_o = latch_row_q;
  assign latch_rows_o = latch_rows_q;

  // ---- instruction memories --------------------------------------------------------------------
  wire [2:0] chunk = addr_q[2:0];
  wire [SLOT_BITS-1:0] slot = addr_q[3+:SLOT_BITS];
  wire last = chunk == (slot[0] ? LAST_ODD_CHUNK : LAST_EVEN_CHUNK);
  reg [16*CHUNKS-1:0] m_data_q;
  reg [SLOTS-1:0] m_write_q;
  reg [PC_BITS-1:0] m_addr_q;
  integer i;
  always @(posedge clk_i) begin
    for (i = 0; i < CHUNKS; i = i + 1) if (chunk == i[2:0]) m_data_q[16*i+:16] <= data_q;
    for (i = 0; i < SLOTS; i = i + 1) begin
      m_write_q[i] <= access_q && write_q && space_q == INSTRUCTIONS && last &&
          slot == i[SLOT_BITS-1:0];
    end
    m_addr_q <= addr_q[3+SLOT_BITS+:PC_BITS];
  end
  assign m_write_o = m_write_q;
  assign m_addr_o  = m_addr_q;
  assign m_data_o  = m_data_q[INSTRUCTION_BITS-1:0];
  wire unused_data = &{1'b0, m_data_q};

  // ---- rows: two registers more, so that the last step's row is there for the first access -----
  reg p_access_q, p_write_q, p_words_q;
  reg [ROW_BITS-1:0] p_row_q;
  reg [SLOT_BITS-1:0] p_lane_q;
  reg [15:0] p_data_q;
  reg l_access_q, l_bit_we_q, l_word_we_q, l_words_q, l_read_q;
  reg [ROW_BITS-1:0] l_row_q;
  reg [SLOT_BITS-1:0] l_lane_q;
  reg [SLOTS-1:0] l_set_bit_q;
  reg [UNITS-1:0] l_set_word_q;
  reg [15:0] l_data_q;
  reg l_bit_q;

  // How many accesses ago this row was accessed, 1 to 6; 0: longer ago.
  localparam PAST = 6;
  reg [PAST-1:0] past_valid_q;
  reg [PAST-1:0] past_words_q;
  reg [PAST*ROW_BITS-1:0] past_rows_q;  // the newest lowest
  reg [NEAR_BITS-1:0] p_near;
  integer past;
  always @* begin
    p_near = {NEAR_BITS{1'b0}};
    for (past = PAST - 1; past >= 0; past = past - 1) begin
      if (past_valid_q[past] && past_words_q[past] == p_words_q &&
          past_rows_q[past*ROW_BITS+:ROW_BITS] == p_row_q) begin
        p_near = past[NEAR_BITS-1:0] + 1'b1;
      end
    end
  end
  reg [ROW_BITS-1:0] l_from_q;
  always @(posedge clk_i) begin
    past_valid_q <= {past_valid_q[PAST-2:0], p_access_q} & {PAST{rst_ni}};
    past_words_q <= {past_words_q[PAST-2:0], p_words_q};
    past_rows_q  <= {past_rows_q[(PAST-1)*ROW_BITS-1:0], p_row_q};
    if (!p_access_q) l_from_q <= {ROW_BITS{1'b0}};
    else if (p_near == {NEAR_BITS{1'b0}}) l_from_q <= p_row_q;
    else l_from_q <= {{SPECIAL_BITS{1'b1}}, p_near};
  end
  assign l_from_o = l_from_q;

  integer lane;
  wire space_words = space_q == WORDS;
  always @(posedge clk_i) begin
    p_access_q <= access_q && (space_words || space_q == BITS) && rst_ni;
    p_write_q <= write_q;
    p_words_q <= space_words;
    p_row_q <= space_words ? addr_q[UNIT_BITS+:ROW_BITS] : addr_q[SLOT_BITS+:ROW_BITS];
    p_lane_q <= space_words ? {1'b0, addr_q[UNIT_BITS-1:0]} : addr_q[SLOT_BITS-1:0];
    p_data_q <= data_q;

    l_access_q <= p_access_q && rst_ni;
    l_read_q <= p_access_q && !p_write_q;
    l_words_q <= p_words_q;
    l_lane_q <= p_lane_q;
    l_row_q <= p_row_q & {ROW_BITS{p_access_q}};
    l_data_q <= p_data_q & {16{p_access_q && p_write_q && p_words_q}};
    l_bit_q <= p_data_q[0];
    l_bit_we_q <= p_access_q && p_write_q && !p_words_q;
    l_word_we_q <= p_access_q && p_write_q && p_words_q;
    for (lane = 0; lane < SLOTS; lane = lane + 1) begin
      l_set_bit_q[lane] <= p_access_q && p_write_q && !p_words_q && p_lane_q == lane[SLOT_BITS-1:0];
    end
    for (lane = 0; lane < UNITS; lane = lane + 1) begin
      l_set_word_q[lane] <= p_access_q && p_write_q && p_words_q && p_lane_q == lane[SLOT_BITS-1:0];
    end
  end
  assign l_access_o = l_access_q;
  assign l_row_o = l_row_q;
  assign l_set_bit_o = l_set_bit_q;
  assign l_set_word_o = l_set_word_q;
  assign l_bit_o = l_bit_q;
  assign l_data_o = l_data_q;
  assign l_bit_we_o = l_bit_we_q;
  assign l_word_we_o = l_word_we_q;
  wire unused_addr = &{1'b0, addr_q};

  // ---- reads: where the value is, with the access to where the rows are ------------------------
  localparam STAGES = 6;  // ID1, ID2, ID3, EX, w, b
  reg [STAGES-1:0] read_q;
  reg [STAGES-1:0] words_q;
  reg [STAGES*SLOT_BITS-1:0] lanes_q;
  always @(posedge clk_i) begin
    read_q  <= {read_q[STAGES-2:0], l_read_q} & {STAGES{rst_ni}};
    words_q <= {words_q[STAGES-2:0], l_words_q};
    lanes_q <= {lanes_q[(STAGES-1)*SLOT_BITS-1:0], l_lane_q};
  end
  wire [SLOT_BITS-1:0] b_lane = lanes_q[(STAGES-1)*SLOT_BITS+:SLOT_BITS];
  reg rvalid_q;
  reg [15:0] rdata_q;
  always @(posedge clk_i) begin
    rvalid_q <= read_q[STAGES-1] && rst_ni;
    rdata_q  <= words_q[STAGES-1] ? b_words_i[b_lane[UNIT_BITS-1:0]*16+:16] :
        {15'd0, b_bits_i[b_lane]};
  end
  assign load_rvalid_o = rvalid_q;
  assign load_rdata_o  = rdata_q;

endmodule

`default_nettype wire

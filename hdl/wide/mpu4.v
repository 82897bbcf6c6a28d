// SPDX-License-Identifier: Apache-2.0
// MPU4, the wide processor: SLOTS bit slots and half as many word units, one step a clock, no stalls. The results of
// a step are one row of the row memories, of which every operand has a copy (hdl/wide/README.md). A scan: start_i
// is sampled while busy_o is 0, and with it in_i; the clocks from that edge to the first that samples done_o as 1
// are a constant of the program, and clocks_o counts them. Load port: wide/wide_load_port.v. rst_ni is
// synchronous, has to last 8 clocks, and leaves all memories alone.
`default_nettype none
`include "rung_wide.vh"

module mpu4 #(
    parameter SLOTS = 16,  // 4, 8 or 16
    parameter DIVIDERS = 2,  // units that have DIV, from unit 0 on; unit 0 has MULD and DIVD too
    parameter ARITY = 3,  // operands of a bit slot
    parameter PC_BITS = 9,  // steps: 2^PC_BITS
    parameter BIT_ADDR = 10,  // rows of bits: 2^BIT_ADDR
    parameter WORD_ADDR = 9,  // rows of words: 2^WORD_ADDR
    parameter INPUTS = 256  // latched at most, a multiple of SLOTS
) (
    input  wire                        clk_i,
    input  wire                        rst_ni,
    // scan
    input  wire                        start_i,
    input  wire [INPUTS-1:0] in_i,
    output wire                        done_o,
    output wire                        busy_o,
    output wire                        error_o,  // a division by 0, until the next scan
    output wire [                31:0] clocks_o,
    // load port
    input  wire                        load_valid_i,
    input  wire                        load_write_i,
    input  wire [                 2:0] load_space_i,
    input  wire [                19:0] load_addr_i,
    input  wire [                15:0] load_data_i,
    output wire                        load_rvalid_o,
    output wire [                15:0] load_rdata_o
`ifdef RUNG_RETIRE
    ,
    // the row of the step that is in the clock after its EX
    output wire                        retire_valid_o,
    output wire [                15:0] retire_step_o,
    output wire [           SLOTS-1:0] retire_bits_o,
    output wire [         8*SLOTS-1:0] retire_words_o
`endif
);

  localparam ROW_BITS = `RUNG_WIDE_LAYOUT_ROW_BITS;
  localparam WORD_BITS = `RUNG_WIDE_LAYOUT_WORD_BITS;
  localparam UNITS = SLOTS / 2;
  localparam SLOT_BITS = SLOTS == 16 ? 4 : SLOTS == 8 ? 3 : 2;
  localparam UNIT_BITS = SLOT_BITS - 1;
  localparam LATCH_ROWS = INPUTS / SLOTS;
  localparam LATCH_BITS = 7;
  localparam BIT_PART = (1 << ARITY) + ARITY * (SLOT_BITS + ROW_BITS);
  localparam WORD_PART = WORD_BITS + UNIT_BITS + 2 * ROW_BITS +
      `RUNG_WIDE_LAYOUT_KIND_BITS + 1 + `RUNG_WIDE_LAYOUT_OP_BITS;
  localparam INSTRUCTION_BITS = BIT_PART + WORD_PART;

  wire [PC_BITS:0] length;
  wire [ROW_BITS-1:0] latch_row;
  wire [LATCH_BITS-1:0] latch_rows;
  wire [SLOTS-1:0] m_write;
  wire [PC_BITS-1:0] m_addr;
  wire [INSTRUCTION_BITS-1:0] m_data;
  wire l_access, l_bit, l_bit_we, l_word_we;
  wire [ROW_BITS-1:0] l_host_row;
  wire [ROW_BITS-1:0] l_from;
  wire latch_valid;
  wire [SLOTS-1:0] latch_bits;
  wire [SLOTS-1:0] l_set_bit;
  wire [UNITS-1:0] l_set_word;
  wire [WORD_BITS-1:0] l_data;
  wire [PC_BITS-1:0] f1_pc;
  wire f2_valid, x_start, w_valid, b_bit_we, b_word_we;
  wire [ROW_BITS-1:0] w_addr;
  wire [ROW_BITS-1:0] b_addr;
  wire [SLOTS-1:0] w_bits;
  wire [UNITS*WORD_BITS-1:0] w_words;
  // The row halfway to the operands, where the inputs come in
  reg [SLOTS-1:0] b_bits_q;
  reg [UNITS*WORD_BITS-1:0] b_words_q;
  always @(posedge clk_i) begin
    b_bits_q  <= latch_valid ? latch_bits : w_bits;
    b_words_q <= w_words;
  end
  wire [UNITS-1:0] w_flags;
  wire [UNITS-1:0] w_div_by_0;

  wide_load_port #(
      .SLOTS(SLOTS),
      .SLOT_BITS(SLOT_BITS),
      .UNIT_BITS(UNIT_BITS),
      .PC_BITS(PC_BITS),
      .LATCH_BITS(LATCH_BITS),
      .INSTRUCTION_BITS(INSTRUCTION_BITS),
      .LAST_EVEN((INSTRUCTION_BITS - 1) / 16),
      .LAST_ODD((BIT_PART - 1) / 16)
  ) load_port (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .load_valid_i(load_valid_i),
      .load_write_i(load_write_i),
      .load_space_i(load_space_i),
      .load_addr_i(load_addr_i),
      .load_data_i(load_data_i),
      .load_rvalid_o(load_rvalid_o),
      .load_rdata_o(load_rdata_o),
      .length_o(length),
      .latch_row_o(latch_row),
      .latch_rows_o(latch_rows),
      .m_write_o(m_write),
      .m_addr_o(m_addr),
      .m_data_o(m_data),
      .l_access_o(l_access),
      .l_row_o(l_host_row),
      .l_from_o(l_from),
      .l_set_bit_o(l_set_bit),
      .l_bit_o(l_bit),
      .l_set_word_o(l_set_word),
      .l_data_o(l_data),
      .l_bit_we_o(l_bit_we),
      .l_word_we_o(l_word_we),
      .b_bits_i(b_bits_q),
      .b_words_i(b_words_q)
  );

  wide_fetch #(
      .SLOTS(SLOTS),
      .PC_BITS(PC_BITS),
      .LATCH_ROWS(LATCH_ROWS),
      .LATCH_BITS(LATCH_BITS)
  ) fetch (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .start_i(start_i),
      .in_i(in_i),
      .busy_o(busy_o),
      .done_o(done_o),
      .clocks_o(clocks_o),
      .length_i(length),
      .latch_row_i(latch_row),
      .latch_rows_i(latch_rows),
      .f1_pc_o(f1_pc),
      .f2_valid_o(f2_valid),
      .latch_valid_o(latch_valid),
      .latch_bits_o(latch_bits),
      .l_host_row_i(l_host_row),
      .l_bit_we_i(l_bit_we),
      .l_word_we_i(l_word_we),
      .x_start_o(x_start),
      .w_valid_o(w_valid),
      .b_bit_we_o(b_bit_we),
      .b_word_we_o(b_word_we),
      .w_addr_o(w_addr),
      .b_addr_o(b_addr)
  );

  genvar s;
  generate
    for (s = 0; s < SLOTS; s = s + 1) begin : g_slot
      wire [WORD_BITS-1:0] w_word;
      wire w_flag, w_zero;
      wide_slot #(
          .SLOTS(SLOTS),
          .SLOT_BITS(SLOT_BITS),
          .SLOT(s),
          .UNIT_BITS(UNIT_BITS),
          .ARITY(ARITY),
          .HAS_UNIT(s % 2 == 0 ? 1 : 0),
          .DIVIDER(s / 2 < DIVIDERS ? 1 : 0),
          .WIDE(s == 0 ? 1 : 0),
          .PC_BITS(PC_BITS),
          .BIT_ADDR(BIT_ADDR),
          .WORD_ADDR(WORD_ADDR),
          .BIT_PART(BIT_PART),
          .WORD_PART(WORD_PART),
          .INSTRUCTION_BITS(s % 2 == 0 ? INSTRUCTION_BITS : BIT_PART)
      ) slot (
          .clk_i(clk_i),
          .rst_ni(rst_ni),
          .m_write_i(m_write[s]),
          .m_addr_i(m_addr),
          .m_data_i(m_data[(s%2==0?INSTRUCTION_BITS : BIT_PART)-1:0]),
          .f1_pc_i(f1_pc),
          .f2_valid_i(f2_valid),
          .l_row_i(l_from),
          .l_lane_i(l_access),
          .l_high_i(l_access && (l_bit || !l_set_bit[s])),
          .l_low_i(l_bit && l_set_bit[s]),
          .l_set_i(l_set_word[s/2]),
          .l_data_i(l_data),
          .x_start_i(x_start),
          .d3_flag_i(w_flags[s/2]),
          .w_flag_o(w_flag),
          .w_div_by_0_o(w_zero),
          .b_bits_i(b_bits_q),
          .b_words_i(b_words_q),
          .b_bit_we_i(b_bit_we),
          .b_word_we_i(b_word_we),
          .b_addr_i(b_addr),
          .w_bit_o(w_bits[s]),
          .w_word_o(w_word)
      );
      if (s % 2 == 0) begin : g_unit
        assign w_words[(s/2)*WORD_BITS+:WORD_BITS] = w_word;
        assign w_flags[s/2] = w_flag;
        assign w_div_by_0[s/2] = w_zero;
      end else begin : g_no_unit
        wire unused_unit = &{1'b0, w_word, w_flag, w_zero};
      end
    end
  endgenerate

  reg error_q;
  always @(posedge clk_i) begin
    if (!rst_ni || x_start) error_q <= 1'b0;
    else if (|w_div_by_0) error_q <= 1'b1;
  end
  assign error_o = error_q;

`ifdef RUNG_RETIRE
  assign retire_valid_o = w_valid;
  assign retire_step_o  = {{16 - ROW_BITS{1'b0}}, w_addr};
  assign retire_bits_o  = w_bits;
  assign retire_words_o = w_words;
`else
  wire unused_retire = &{1'b0, w_valid, w_addr};
`endif

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// One slot: the bit side (look-up unit, or MPU1's contact unit), the word side, the index, and the
// registers after EX that forwarding reads. Every slot does every instruction of its processor and
// has its own exc, acc, carry and ix.
`default_nettype none
`include "rung_isa.vh"

module slot #(
    parameter LOOKUP = 1,  // 1: MPU2 and MPU3, 0: MPU1
    parameter SLOTS = 1,
    parameter SLOT = 0,  // this one
    parameter READS = 3,  // bit operands
    parameter BIT_ADDR = 10,  // bits of a bit device's number
    parameter WORD_ADDR = 8,  // bits of a word device's number
    parameter FIELD_BITS = 43,  // bits of one slot's instruction below its opcode
    parameter MUL_DSP = 1
) (
    input  wire                               clk_i,
    input  wire                               rst_ni,
    input  wire                               scan_start_i,
    // IF3: the opcode that ID1 has next, unless it holds
    input  wire [            `RUNG_OP_BITS-1:0] f3_op_i,
    input  wire                                 d1_hold_i,
    // ID1: the instruction, and which pass of a waiting step this is
    input  wire [            `RUNG_OP_BITS-1:0] d1_op_i,
    input  wire [               FIELD_BITS-1:0] d1_fields_i,
    input  wire                                 d1_first_i,
    input  wire                                 d1_last_i,
    output wire [           READS*BIT_ADDR-1:0] d1_bit_addr_o,
    output wire [           `RUNG_ROW_BITS-1:0] d1_row_o,
    output wire [              2*WORD_ADDR-1:0] d1_word_addr_o,
    output wire [                WORD_ADDR-1:0] d1_word_dest_o,
    // ID2: data of the LUT and of the device memories, in the order of the addresses
    input  wire [                          7:0] d2_row_i,
    input  wire [              READS*SLOTS-1:0] d2_bit_bank_i,
    input  wire [2*SLOTS*`RUNG_WORD_BITS-1:0]   d2_word_bank_i,
    input  wire [  SLOTS*`RUNG_WORD_BITS-1:0]   d2_word_cross_i,
    // this slot's writes: device from ID2 on, enable in EX, then enable, value and bank data after
    // EX (w_), and the data one clock later still (v_)
    output wire [                 BIT_ADDR-1:0] d2_bit_dest_o,
    output wire [                 BIT_ADDR-1:0] d3_bit_dest_o,
    output wire [                 BIT_ADDR-1:0] x_bit_dest_o,
    output wire [                 BIT_ADDR-1:0] w_bit_dest_o,
    output wire                                 x_bit_we_o,
    output wire                                 w_bit_we_o,
    output wire                                 w_bit_value_o,
    output wire                                 w_bit_bank_o,
    output wire                                 v_bit_value_o,
    output wire                                 v_bit_bank_o,
    output wire [                WORD_ADDR-1:0] d2_word_dest_o,
    output wire [                WORD_ADDR-1:0] d3_word_dest_o,
    output wire [                WORD_ADDR-1:0] x_word_dest_o,
    output wire [                WORD_ADDR-1:0] w_word_dest_o,
    output wire                                 x_word_we_o,
    output wire                                 w_word_we_o,
    output wire [          `RUNG_WORD_BITS-1:0] w_word_value_o,
    output wire [          `RUNG_WORD_BITS-1:0] w_word_bank_o,
    output wire [          `RUNG_WORD_BITS-1:0] v_word_value_o,
    output wire [          `RUNG_WORD_BITS-1:0] v_word_bank_o,
    // the writes of all slots, this one among them
    input  wire [           SLOTS*BIT_ADDR-1:0] d2_bit_dest_i,
    input  wire [           SLOTS*BIT_ADDR-1:0] d3_bit_dest_i,
    input  wire [           SLOTS*BIT_ADDR-1:0] x_bit_dest_i,
    input  wire [           SLOTS*BIT_ADDR-1:0] w_bit_dest_i,
    input  wire [                    SLOTS-1:0] x_bit_we_i,
    input  wire [                    SLOTS-1:0] w_bit_we_i,
    input  wire [                    SLOTS-1:0] w_bit_value_i,
    input  wire [                    SLOTS-1:0] w_bit_bank_i,
    input  wire [                    SLOTS-1:0] v_bit_value_i,
    input  wire [                    SLOTS-1:0] v_bit_bank_i,
    input  wire [          SLOTS*WORD_ADDR-1:0] d2_word_dest_i,
    input  wire [          SLOTS*WORD_ADDR-1:0] d3_word_dest_i,
    input  wire [          SLOTS*WORD_ADDR-1:0] x_word_dest_i,
    input  wire [          SLOTS*WORD_ADDR-1:0] w_word_dest_i,
    input  wire [                    SLOTS-1:0] x_word_we_i,
    input  wire [                    SLOTS-1:0] w_word_we_i,
    input  wire [    SLOTS*`RUNG_WORD_BITS-1:0] w_word_value_i,
    input  wire [    SLOTS*`RUNG_WORD_BITS-1:0] w_word_bank_i,
    input  wire [    SLOTS*`RUNG_WORD_BITS-1:0] v_word_value_i,
    input  wire [    SLOTS*`RUNG_WORD_BITS-1:0] v_word_bank_i,
    // an executed division by 0, in the clock after its EX
    output wire                                 w_div_by_0_o
`ifdef RUNG_RETIRE
    ,
    output wire                                 x_exc_next_o,
    output wire                                 x_bit_value_o,
    output wire [          `RUNG_WORD_BITS-1:0] x_word_value_o
`endif
);

  // ---- ID1: what this pass of the step issues --------------------------------------------------
  wire d1_waits = d1_op_i == `RUNG_OP_MUL || d1_op_i == `RUNG_OP_DIV ||
      d1_op_i == `RUNG_OP_MULD || d1_op_i == `RUNG_OP_DIVD;
  reg [`RUNG_OP_BITS-1:0] d1_op;
  always @* begin
    d1_op = `RUNG_OP_NOP;
    if (d1_first_i) begin
      d1_op = d1_op_i;
      if (d1_op_i == `RUNG_OP_MUL) d1_op = `RUNG_OP_MULS;
      if (d1_op_i == `RUNG_OP_DIV) d1_op = `RUNG_OP_DIVS;
      if (d1_op_i == `RUNG_OP_MULD) d1_op = `RUNG_OP_MULDS;
      if (d1_op_i == `RUNG_OP_DIVD) d1_op = `RUNG_OP_DIVDS;
    end else if (d1_last_i && d1_waits) begin
      d1_op = `RUNG_OP_MVL;
    end
  end

  // ---- the index -------------------------------------------------------------------------------
  localparam IX_BITS = BIT_ADDR > WORD_ADDR ? BIT_ADDR : WORD_ADDR;
  wire d1_ix_source;
  wire d1_ix_dest;
  wire [IX_BITS-1:0] d1_ix;
  wire [`RUNG_WORD_BITS-1:0] x_sum;
  index_unit #(
      .IX_BITS(IX_BITS)
  ) index (
      .clk_i(clk_i),
      .f3_op_i(f3_op_i),
      .d1_hold_i(d1_hold_i),
      .d1_source_o(d1_ix_source),
      .d1_dest_o(d1_ix_dest),
      .d1_ix_o(d1_ix),
      .d1_op_i(d1_op),
      .x_sum_i(x_sum[IX_BITS-1:0])
  );
  wire unused_ix = &{1'b0, d1_ix, x_sum};

  // ---- the bit side ----------------------------------------------------------------------------
  wire x_test_we;
  wire x_test;
  wire [`RUNG_WORD_BITS-1:0] x_acc;
  wire x_exc;
  wire x_bit_value;
  wire x_bit_bank;
  wire x_exc_next;
  generate
    if (LOOKUP != 0) begin : g_look_up
      look_up_unit #(
          .SLOTS(SLOTS),
          .SLOT(SLOT),
          .BIT_ADDR(BIT_ADDR),
          .WORD_ADDR(WORD_ADDR),
          .FIELD_BITS(FIELD_BITS)
      ) bits (
          .clk_i(clk_i),
          .scan_start_i(scan_start_i),
          .d1_op_i(d1_op),
          .d1_fields_i(d1_fields_i),
          .d1_ix_source_i(d1_ix_source),
          .d1_ix_dest_i(d1_ix_dest),
          .d1_ix_i(d1_ix[BIT_ADDR-1:0]),
          .d1_addr_o(d1_bit_addr_o),
          .d1_row_o(d1_row_o),
          .d2_bank_i(d2_bit_bank_i),
          .d2_row_i(d2_row_i),
          .d2_dest_o(d2_bit_dest_o),
          .d3_dest_o(d3_bit_dest_o),
          .x_dest_o(x_bit_dest_o),
          .d2_dest_i(d2_bit_dest_i),
          .d3_dest_i(d3_bit_dest_i),
          .x_dest_i(x_bit_dest_i),
          .w_dest_i(w_bit_dest_i),
          .x_we_i(x_bit_we_i),
          .w_we_i(w_bit_we_i),
          .w_value_i(w_bit_value_i),
          .w_bank_i(w_bit_bank_i),
          .v_value_i(v_bit_value_i),
          .v_bank_i(v_bit_bank_i),
          .x_test_we_i(x_test_we),
          .x_test_i(x_test),
          .x_we_o(x_bit_we_o),
          .x_value_o(x_bit_value),
          .x_bank_o(x_bit_bank),
          .x_exc_o(x_exc),
          .x_exc_next_o(x_exc_next),
          .x_acc_o(x_acc)
      );
    end else begin : g_contact
      contact_unit #(
          .BIT_ADDR(BIT_ADDR),
          .WORD_ADDR(WORD_ADDR),
          .FIELD_BITS(FIELD_BITS)
      ) bits (
          .clk_i(clk_i),
          .scan_start_i(scan_start_i),
          .d1_op_i(d1_op),
          .d1_fields_i(d1_fields_i),
          .d1_ix_dest_i(d1_ix_dest),
          .d1_ix_i(d1_ix[BIT_ADDR-1:0]),
          .d1_addr_o(d1_bit_addr_o),
          .d2_bank_i(d2_bit_bank_i),
          .d2_dest_o(d2_bit_dest_o),
          .d3_dest_o(d3_bit_dest_o),
          .x_dest_o(x_bit_dest_o),
          .w_dest_i(w_bit_dest_i),
          .w_we_i(w_bit_we_i),
          .w_value_i(w_bit_value_i),
          .v_value_i(v_bit_value_i),
          .x_test_we_i(x_test_we),
          .x_test_i(x_test),
          .x_we_o(x_bit_we_o),
          .x_value_o(x_bit_value),
          .x_exc_o(x_exc),
          .x_exc_next_o(x_exc_next),
          .x_acc_o(x_acc)
      );
      assign d1_row_o = {`RUNG_ROW_BITS{1'b0}};
      assign x_bit_bank = x_bit_value;
      // One writer, whose values the unit has already; no LUT.
      wire unused_writers = &{1'b0, d2_bit_dest_i, d3_bit_dest_i, x_bit_dest_i, x_bit_we_i};
      wire unused_row = &{1'b0, d2_row_i, w_bit_bank_i, v_bit_bank_i};
    end
  endgenerate

  // ---- the word side ---------------------------------------------------------------------------
  wire [`RUNG_WORD_BITS-1:0] x_word_value;
  wire [`RUNG_WORD_BITS-1:0] x_word_bank;
  word_unit #(
      .LOOKUP(LOOKUP),
      .SLOTS(SLOTS),
      .SLOT(SLOT),
      .BIT_ADDR(BIT_ADDR),
      .WORD_ADDR(WORD_ADDR),
      .FIELD_BITS(FIELD_BITS),
      .MUL_DSP(MUL_DSP)
  ) words (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .scan_start_i(scan_start_i),
      .d1_op_i(d1_op),
      .d1_fields_i(d1_fields_i),
      .d1_ix_source_i(d1_ix_source),
      .d1_ix_dest_i(d1_ix_dest),
      .d1_ix_i(d1_ix[WORD_ADDR-1:0]),
      .d1_addr_o(d1_word_addr_o),
      .d1_dest_o(d1_word_dest_o),
      .d2_bank_i(d2_word_bank_i),
      .d2_cross_i(d2_word_cross_i),
      .d2_dest_o(d2_word_dest_o),
      .d3_dest_o(d3_word_dest_o),
      .x_dest_o(x_word_dest_o),
      .d2_dest_i(d2_word_dest_i),
      .d3_dest_i(d3_word_dest_i),
      .x_dest_i(x_word_dest_i),
      .w_dest_i(w_word_dest_i),
      .x_we_i(x_word_we_i),
      .w_we_i(w_word_we_i),
      .w_value_i(w_word_value_i),
      .w_bank_i(w_word_bank_i),
      .v_value_i(v_word_value_i),
      .v_bank_i(v_word_bank_i),
      .x_exc_i(x_exc),
      .x_acc_i(x_acc),
      .x_we_o(x_word_we_o),
      .x_value_o(x_word_value),
      .x_bank_o(x_word_bank),
      .x_test_we_o(x_test_we),
      .x_test_o(x_test),
      .x_sum_o(x_sum),
      .w_div_by_0_o(w_div_by_0_o)
  );

  // ---- after EX: what the memories get, and what forwarding and the host read ------------------
  reg w_bit_we_q, w_bit_value_q, w_bit_bank_q;
  reg w_word_we_q;
  reg [BIT_ADDR-1:0] w_bit_dest_q;
  reg [WORD_ADDR-1:0] w_word_dest_q;
  reg [`RUNG_WORD_BITS-1:0] w_word_value_q;
  reg [`RUNG_WORD_BITS-1:0] w_word_bank_q;
  always @(posedge clk_i) begin
    w_bit_we_q <= x_bit_we_o;
    w_bit_dest_q <= x_bit_dest_o;
    w_bit_value_q <= x_bit_value;
    w_bit_bank_q <= x_bit_bank;
    w_word_we_q <= x_word_we_o;
    w_word_dest_q <= x_word_dest_o;
    w_word_value_q <= x_word_value;
    w_word_bank_q <= x_word_bank;
  end
  assign w_bit_we_o = w_bit_we_q;
  assign w_bit_dest_o = w_bit_dest_q;
  assign w_bit_value_o = w_bit_value_q;
  assign w_bit_bank_o = w_bit_bank_q;
  assign w_word_we_o = w_word_we_q;
  assign w_word_dest_o = w_word_dest_q;
  assign w_word_value_o = w_word_value_q;
  assign w_word_bank_o = w_word_bank_q;

  // A step four behind reads the memory in the clock in which it is written.
  reg v_bit_value_q, v_bit_bank_q;
  reg [`RUNG_WORD_BITS-1:0] v_word_value_q;
  reg [`RUNG_WORD_BITS-1:0] v_word_bank_q;
  always @(posedge clk_i) begin
    v_bit_value_q <= w_bit_value_q;
    v_bit_bank_q <= w_bit_bank_q;
    v_word_value_q <= w_word_value_q;
    v_word_bank_q <= w_word_bank_q;
  end
  assign v_bit_value_o = v_bit_value_q;
  assign v_bit_bank_o = v_bit_bank_q;
  assign v_word_value_o = v_word_value_q;
  assign v_word_bank_o = v_word_bank_q;

`ifdef RUNG_RETIRE
  assign x_exc_next_o   = x_exc_next;
  assign x_bit_value_o  = x_bit_value;
  assign x_word_value_o = x_word_value;
`else
  wire unused_exc_next = x_exc_next;
`endif

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// The bit side of one slot of MPU2 and MPU3 (paper, 4.3): three operands, one look-up, the
// accumulator exc (also operand N0, the previous look-up's result), and the write of device c.
// Every bit instruction is a look-up: LD, OUT, MVBX, SET, RST and NOP look up "a" (with exc for `a`
// where they need exc), SET and RST with u a constant 1; SET, RST, LUTS and LUTR write only if the
// result is 1. A test's look-up is cleared, so that the word side's result goes into it. GET gathers
// the operands in acc.
`default_nettype none
`include "rung_isa.vh"

module look_up_unit #(
    parameter SLOTS = 1,
    parameter SLOT = 0,  // this one
    parameter BIT_ADDR = 10,  // bits of a bit device's number
    parameter FIELD_BITS = 43,  // bits of one slot's instruction below its opcode
    parameter WORD_ADDR = 8
) (
    input  wire                       clk_i,
    input  wire                       scan_start_i,
    // ID1: opcode as issued, the instruction's fields below it; operand addresses, c lowest
    input  wire [  `RUNG_OP_BITS-1:0] d1_op_i,
    input  wire [     FIELD_BITS-1:0] d1_fields_i,
    // ID1: for an indexed access, what takes the place of a or c
    input  wire                       d1_ix_source_i,
    input  wire                       d1_ix_dest_i,
    input  wire [       BIT_ADDR-1:0] d1_ix_i,
    output wire [     3*BIT_ADDR-1:0] d1_addr_o,
    output wire [ `RUNG_ROW_BITS-1:0] d1_row_o,
    // ID2: memory data, c lowest, and for each operand bank 0 lowest; the LUT's row
    input  wire [        3*SLOTS-1:0] d2_bank_i,
    input  wire [                7:0] d2_row_i,
    // the devices that all slots write: steps in ID2, ID3 and EX, the one
    // before (w_) and the one before that (v_)
    output wire [       BIT_ADDR-1:0] d2_dest_o,
    output wire [       BIT_ADDR-1:0] d3_dest_o,
    output wire [       BIT_ADDR-1:0] x_dest_o,
    input  wire [ SLOTS*BIT_ADDR-1:0] d2_dest_i,
    input  wire [ SLOTS*BIT_ADDR-1:0] d3_dest_i,
    input  wire [ SLOTS*BIT_ADDR-1:0] x_dest_i,
    input  wire [ SLOTS*BIT_ADDR-1:0] w_dest_i,
    input  wire [          SLOTS-1:0] x_we_i,
    input  wire [          SLOTS-1:0] w_we_i,
    input  wire [          SLOTS-1:0] w_value_i,
    input  wire [          SLOTS-1:0] w_bank_i,
    input  wire [          SLOTS-1:0] v_value_i,
    input  wire [          SLOTS-1:0] v_bank_i,
    // EX: a test of the word side is executed; its result, 0 if there is none
    input  wire                       x_test_we_i,
    input  wire                       x_test_i,
    // EX: this slot's write (value, and what its bank gets), exc before and after, and acc
    output wire                       x_we_o,
    output wire                       x_value_o,
    output wire                       x_bank_o,
    output wire                       x_exc_o,
    output wire                       x_exc_next_o,
    output wire [`RUNG_WORD_BITS-1:0] x_acc_o
);

  localparam LOOKUP = 1;
  `include "fields.vh"

  // ---- ID1 -------------------------------------------------------------------------------------
  wire [  BIT_ADDR:0] d1_a = d1_fields_i[A_AT+:OPERAND_BITS];
  wire [  BIT_ADDR:0] d1_b = d1_fields_i[B_AT+:OPERAND_BITS];
  wire [  BIT_ADDR:0] d1_c = d1_fields_i[DEST_AT+:OPERAND_BITS];
  wire [BIT_ADDR-1:0] d1_a_addr = d1_ix_source_i ? d1_ix_i : d1_a[BIT_ADDR-1:0];
  wire [BIT_ADDR-1:0] d1_c_addr = d1_ix_dest_i ? d1_ix_i : d1_c[BIT_ADDR-1:0];
  assign d1_row_o  = d1_fields_i[ROW_AT+:`RUNG_ROW_BITS];
  assign d1_addr_o = {d1_a_addr, d1_b[BIT_ADDR-1:0], d1_c_addr};

  // ---- ID2: decode -----------------------------------------------------------------------------
  reg [`RUNG_OP_BITS-1:0] d2_op_q;
  reg [2:0] d2_n0_q;
  reg d2_u_q;
  reg [BIT_ADDR-1:0] d2_dest_q;
  always @(posedge clk_i) begin
    d2_op_q   <= d1_op_i;
    d2_n0_q   <= {d1_a[BIT_ADDR], d1_b[BIT_ADDR], d1_c[BIT_ADDR]};
    d2_u_q    <= d1_fields_i[U_AT];
    d2_dest_q <= d1_c_addr;
  end
  assign d2_dest_o = d2_dest_q;

  reg d2_use_row, d2_use_exc, d2_one, d2_exc_we, d2_we, d2_we_if_1, d2_clear, d2_get;
  always @* begin
    d2_use_row = 1'b0;
    d2_use_exc = 1'b0;
    d2_one = 1'b0;
    d2_exc_we = 1'b0;
    d2_we = 1'b0;
    d2_we_if_1 = 1'b0;
    d2_clear = 1'b0;
    d2_get = 1'b0;
    case (d2_op_q)
      `RUNG_OP_LUT, `RUNG_OP_LUTO, `RUNG_OP_LUTS, `RUNG_OP_LUTR: begin
        d2_use_row = 1'b1;
        d2_exc_we = 1'b1;
        d2_we = d2_op_q == `RUNG_OP_LUTO;
        d2_we_if_1 = d2_op_q == `RUNG_OP_LUTS || d2_op_q == `RUNG_OP_LUTR;
        d2_clear = d2_op_q == `RUNG_OP_LUTR;
      end
      `RUNG_OP_LD: d2_exc_we = 1'b1;
      `RUNG_OP_OUT: begin
        d2_use_exc = 1'b1;
        d2_we = 1'b1;
      end
      `RUNG_OP_SET, `RUNG_OP_SETX, `RUNG_OP_RST, `RUNG_OP_RSTX: begin
        d2_use_exc = 1'b1;
        d2_one = d2_u_q;
        d2_we_if_1 = 1'b1;
        d2_clear = d2_op_q == `RUNG_OP_RST || d2_op_q == `RUNG_OP_RSTX;
      end
      `RUNG_OP_MVBX: d2_we = 1'b1;
      `RUNG_OP_EQ, `RUNG_OP_LT, `RUNG_OP_LTU, `RUNG_OP_LTC, `RUNG_OP_TB: d2_clear = 1'b1;
      `RUNG_OP_GET: d2_get = 1'b1;
      default: ;
    endcase
  end

  // ---- ID3 -------------------------------------------------------------------------------------
  reg d3_use_row_q, d3_one_q, d3_exc_we_q, d3_we_q, d3_we_if_1_q, d3_clear_q, d3_get_q, d3_u_q;
  reg [2:0] d3_n0_q;
  reg [7:0] d3_row_q;
  reg [BIT_ADDR-1:0] d3_dest_q;
  always @(posedge clk_i) begin
    d3_use_row_q <= d2_use_row;
    d3_one_q <= d2_one;
    d3_exc_we_q <= d2_exc_we;
    d3_we_q <= d2_we;
    d3_we_if_1_q <= d2_we_if_1;
    d3_clear_q <= d2_clear;
    d3_get_q <= d2_get;
    d3_u_q <= d2_u_q;
    d3_n0_q <= d2_n0_q | {d2_use_exc, 2'b00};
    d3_row_q <= d2_row_i;
    d3_dest_q <= d2_dest_q;
  end
  assign d3_dest_o = d3_dest_q;

  // An instruction that is no look-up gives 1 at {a,b,c} = 1xx, or everywhere.
  wire [7:0] d3_function = d3_use_row_q ? d3_row_q : {4'hF, {4{d3_one_q}}};

  // ---- EX --------------------------------------------------------------------------------------
  reg  [7:0] x_function_q;
  reg x_exc_we_q, x_we_q, x_we_if_1_q, x_clear_q, x_get_q, x_u_q;
  reg [2:0] x_n0_q;
  reg [BIT_ADDR-1:0] x_dest_q;
  reg exc_q;
  reg [`RUNG_WORD_BITS-1:0] acc_q;
  always @(posedge clk_i) begin
    x_function_q <= d3_function;
    x_exc_we_q <= d3_exc_we_q;
    x_we_q <= d3_we_q;
    x_we_if_1_q <= d3_we_if_1_q;
    x_clear_q <= d3_clear_q;
    x_get_q <= d3_get_q;
    x_u_q <= d3_u_q;
    x_n0_q <= d3_n0_q;
    x_dest_q <= d3_dest_q;
  end
  assign x_dest_o = x_dest_q;

  wire [2:0] x_device;
  genvar i;
  generate
    for (i = 0; i < 3; i = i + 1) begin : g_operand
      operand #(
          .WIDTH(1),
          .ADDR_BITS(BIT_ADDR),
          .WRITERS(SLOTS)
      ) operand (
          .clk_i(clk_i),
          .d1_addr_i(d1_addr_o[i*BIT_ADDR+:BIT_ADDR]),
          .d2_dest_i(d2_dest_i),
          .d3_dest_i(d3_dest_i),
          .x_dest_i(x_dest_i),
          .w_dest_i(w_dest_i),
          .d2_bank_i(d2_bank_i[i*SLOTS+:SLOTS]),
          .d3_device_i(!d3_n0_q[i]),
          .d3_other_i(1'b0),
          .x_we_i(x_we_i),
          .w_we_i(w_we_i),
          .w_data_i(w_value_i),
          .v_data_i(v_value_i),
          .x_value_o(x_device[i])
      );
    end
  endgenerate

  // What the other banks hold at device c.
  wire [SLOTS-1:0] x_cross;
  generate
    for (i = 0; i < SLOTS; i = i + 1) begin : g_cross
      if (i == SLOT) begin : g_own
        assign x_cross[i] = 1'b0;
        wire unused_own = &{1'b0, w_bank_i[i], v_bank_i[i]};
      end else begin : g_other
        operand #(
            .WIDTH(1),
            .ADDR_BITS(BIT_ADDR),
            .WRITERS(1)
        ) operand (
            .clk_i(clk_i),
            .d1_addr_i(d1_addr_o[0+:BIT_ADDR]),
            .d2_dest_i(d2_dest_i[i*BIT_ADDR+:BIT_ADDR]),
            .d3_dest_i(d3_dest_i[i*BIT_ADDR+:BIT_ADDR]),
            .x_dest_i(x_dest_i[i*BIT_ADDR+:BIT_ADDR]),
            .w_dest_i(w_dest_i[i*BIT_ADDR+:BIT_ADDR]),
            .d2_bank_i(d2_bank_i[i]),
            .d3_device_i(1'b1),
            .d3_other_i(1'b0),
            .x_we_i(x_we_i[i]),
            .w_we_i(w_we_i[i]),
            .w_data_i(w_bank_i[i]),
            .v_data_i(v_bank_i[i]),
            .x_value_o(x_cross[i])
        );
      end
    end
  endgenerate

  wire [2:0] x_operands = x_device | (x_n0_q & {3{exc_q}});
  wire x_result = x_function_q[x_operands];

  assign x_we_o = x_we_q || (x_we_if_1_q && x_result) || x_test_we_i;
  assign x_value_o = (x_result && !x_clear_q) || x_test_i;
  assign x_bank_o = x_value_o ^ (^x_cross);
  assign x_exc_o = exc_q;
  assign x_exc_next_o = x_exc_we_q ? x_result : exc_q;
  assign x_acc_o = acc_q;

  always @(posedge clk_i) begin
    exc_q <= x_exc_next_o && !scan_start_i;
    if (scan_start_i) begin
      acc_q <= {`RUNG_WORD_BITS{1'b0}};
    end else if (x_get_q) begin
      // An operand that is N0 has no device, and counts as 0.
      acc_q <= {acc_q[`RUNG_WORD_BITS-4:0] & {`RUNG_WORD_BITS - 3{!x_u_q}}, x_device};
    end
  end

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// The word side of one slot, alike in all three processors: two operands (device or constant), the
// arithmetic, the multiply-divide unit, and the write of device rd if exc, u or the unit allows it; a
// test's result, which the bit side writes.
`default_nettype none
`include "rung_isa.vh"

module word_unit #(
    parameter LOOKUP = 1,  // 1: instruction layout of MPU2 and MPU3, 0: of MPU1
    parameter SLOTS = 1,
    parameter SLOT = 0,  // this one
    parameter BIT_ADDR = 10,
    parameter FIELD_BITS = 43,  // bits of one slot's instruction below its opcode
    parameter WORD_ADDR = 8,  // bits of a word device's number
    parameter MUL_DSP = 1
) (
    input  wire                               clk_i,
    input  wire                               rst_ni,
    input  wire                               scan_start_i,
    // ID1: opcode as issued, the instruction's fields below it; operand addresses {s2, s1}
    input  wire [          `RUNG_OP_BITS-1:0] d1_op_i,
    input  wire [             FIELD_BITS-1:0] d1_fields_i,
    // ID1: for an indexed access, what takes the place of rs (as s1) or rd
    input  wire                               d1_ix_source_i,
    input  wire                               d1_ix_dest_i,
    input  wire [              WORD_ADDR-1:0] d1_ix_i,
    output wire [            2*WORD_ADDR-1:0] d1_addr_o,
    output wire [              WORD_ADDR-1:0] d1_dest_o,
    // ID2: memory data of s1 (lower) and s2, bank 0 lowest; of rd, in the other banks
    input  wire [2*SLOTS*`RUNG_WORD_BITS-1:0] d2_bank_i,
    input  wire [  SLOTS*`RUNG_WORD_BITS-1:0] d2_cross_i,
    // the devices that all slots write: steps in ID2, ID3 and EX, the one
    // before (w_) and the one before that (v_)
    output wire [              WORD_ADDR-1:0] d2_dest_o,
    output wire [              WORD_ADDR-1:0] d3_dest_o,
    output wire [              WORD_ADDR-1:0] x_dest_o,
    input  wire [        SLOTS*WORD_ADDR-1:0] d2_dest_i,
    input  wire [        SLOTS*WORD_ADDR-1:0] d3_dest_i,
    input  wire [        SLOTS*WORD_ADDR-1:0] x_dest_i,
    input  wire [        SLOTS*WORD_ADDR-1:0] w_dest_i,
    input  wire [                  SLOTS-1:0] x_we_i,
    input  wire [                  SLOTS-1:0] w_we_i,
    input  wire [  SLOTS*`RUNG_WORD_BITS-1:0] w_value_i,
    input  wire [  SLOTS*`RUNG_WORD_BITS-1:0] w_bank_i,
    input  wire [  SLOTS*`RUNG_WORD_BITS-1:0] v_value_i,
    input  wire [  SLOTS*`RUNG_WORD_BITS-1:0] v_bank_i,
    // EX: the slot's accumulators; the write (value, and what this slot's bank gets)
    input  wire                               x_exc_i,
    input  wire [        `RUNG_WORD_BITS-1:0] x_acc_i,
    output wire                               x_we_o,
    output wire [        `RUNG_WORD_BITS-1:0] x_value_o,
    output wire [        `RUNG_WORD_BITS-1:0] x_bank_o,
    // EX: a test is executed; its result, 0 if there is none; what IX gives
    output wire                               x_test_we_o,
    output wire                               x_test_o,
    output wire [        `RUNG_WORD_BITS-1:0] x_sum_o,
    // an executed division by 0, in the clock after its EX
    output wire                               w_div_by_0_o
);

  `include "fields.vh"
  localparam BITS = `RUNG_WORD_BITS;
  localparam [1:0] CONSTANT_S2 = 2'd1;
  localparam [1:0] CONSTANT_S1 = 2'd2;

  // ---- ID1 -------------------------------------------------------------------------------------
  wire [BITS-1:0] d1_source = d1_fields_i[BITS-1:0];
  wire [WORD_ADDR-1:0] d1_rs = d1_fields_i[RS_AT+:WORD_ADDR];
  wire [WORD_ADDR-1:0] d1_rd = d1_ix_dest_i ? d1_ix_i : d1_fields_i[DEST_AT+:WORD_ADDR];
  wire [1:0] d1_kind = d1_fields_i[KIND_AT+:`RUNG_KIND_BITS];
  wire d1_u = d1_fields_i[U_AT];
  wire [WORD_ADDR-1:0] d1_s1 = d1_ix_source_i ? d1_ix_i : d1_rs;
  wire [WORD_ADDR-1:0] d1_s2 = d1_kind == CONSTANT_S1 ? d1_rs : d1_source[WORD_ADDR-1:0];
  assign d1_addr_o = {d1_s2, d1_s1};
  assign d1_dest_o = d1_rd;

  // ---- ID2: decode -----------------------------------------------------------------------------
  reg [`RUNG_OP_BITS-1:0] d2_op_q;
  reg [1:0] d2_kind_q;
  reg d2_u_q;
  reg [BITS-1:0] d2_source_q;
  reg [WORD_ADDR-1:0] d2_dest_q;
  always @(posedge clk_i) begin
    d2_op_q <= d1_op_i;
    d2_kind_q <= d1_kind;
    d2_u_q <= d1_u;
    d2_source_q <= d1_source;
    d2_dest_q <= d1_rd;
  end
  assign d2_dest_o = d2_dest_q;

  reg d2_we, d2_test, d2_collect, d2_indexed, d2_start, d2_div, d2_wide, d2_high;
  reg [1:0] d2_word;
  always @* begin
    {d2_we, d2_test, d2_collect, d2_indexed} = 4'd0;
    {d2_start, d2_div, d2_wide, d2_high} = 4'd0;
    d2_word = 2'd0;
    case (d2_op_q)
      `RUNG_OP_MV, `RUNG_OP_ADD, `RUNG_OP_ADC, `RUNG_OP_SUB, `RUNG_OP_SBC, `RUNG_OP_WAND,
      `RUNG_OP_WOR, `RUNG_OP_WXOR, `RUNG_OP_ROL, `RUNG_OP_MINU, `RUNG_OP_MVA, `RUNG_OP_STX: begin
        d2_we = 1'b1;
      end
      `RUNG_OP_MVX: begin
        d2_we = 1'b1;
        d2_indexed = 1'b1;
      end
      `RUNG_OP_EQ, `RUNG_OP_LT, `RUNG_OP_LTU, `RUNG_OP_LTC, `RUNG_OP_TB: d2_test = 1'b1;
      `RUNG_OP_MULS, `RUNG_OP_DIVS, `RUNG_OP_MULDS, `RUNG_OP_DIVDS: begin
        d2_start = 1'b1;
        d2_div   = d2_op_q == `RUNG_OP_DIVS || d2_op_q == `RUNG_OP_DIVDS;
        d2_wide  = d2_op_q == `RUNG_OP_MULDS || d2_op_q == `RUNG_OP_DIVDS;
      end
      `RUNG_OP_LDH: d2_high = 1'b1;
      `RUNG_OP_MVL, `RUNG_OP_MVH, `RUNG_OP_MV2, `RUNG_OP_MV3: begin
        d2_collect = 1'b1;
        d2_word[0] = d2_op_q == `RUNG_OP_MVH || d2_op_q == `RUNG_OP_MV3;
        d2_word[1] = d2_op_q == `RUNG_OP_MV2 || d2_op_q == `RUNG_OP_MV3;
      end
      default: ;
    endcase
  end

  // ---- ID3 -------------------------------------------------------------------------------------
  reg d3_we_q, d3_test_q, d3_collect_q, d3_start_q, d3_div_q, d3_wide_q, d3_high_q, d3_u_q;
  reg d3_device1_q, d3_device2_q;
  reg [1:0] d3_word_q;
  reg [BITS-1:0] d3_source_q;
  reg [WORD_ADDR-1:0] d3_dest_q;
  always @(posedge clk_i) begin
    d3_we_q <= d2_we;
    d3_test_q <= d2_test;
    d3_collect_q <= d2_collect;
    d3_word_q <= d2_word;
    d3_start_q <= d2_start;
    d3_div_q <= d2_div;
    d3_wide_q <= d2_wide;
    d3_high_q <= d2_high;
    d3_u_q <= d2_u_q;
    d3_device1_q <= d2_kind_q != CONSTANT_S1 || d2_indexed;
    d3_device2_q <= d2_kind_q != CONSTANT_S2 && !d2_collect;
    d3_source_q <= d2_source_q;
    d3_dest_q <= d2_dest_q;
  end
  assign d3_dest_o = d3_dest_q;

  wire [BITS-1:0] d3_unit;
  wire d3_unit_valid;
  wire [BITS-1:0] d3_other2 = d3_collect_q ? d3_unit : d3_source_q;

  // ---- EX --------------------------------------------------------------------------------------
  reg x_we_q, x_test_q, x_start_q, x_div_q, x_wide_q, x_high_q, x_always_q;
  reg [WORD_ADDR-1:0] x_dest_q;
  always @(posedge clk_i) begin
    x_we_q <= d3_we_q || (d3_collect_q && d3_unit_valid);
    x_test_q <= d3_test_q;
    x_always_q <= d3_u_q || d3_collect_q;
    x_start_q <= d3_start_q;
    x_div_q <= d3_div_q;
    x_wide_q <= d3_wide_q;
    x_high_q <= d3_high_q;
    x_dest_q <= d3_dest_q;
  end
  assign x_dest_o = x_dest_q;

  wire [BITS-1:0] x_s1;
  operand #(
      .WIDTH(BITS),
      .ADDR_BITS(WORD_ADDR),
      .WRITERS(SLOTS)
  ) s1 (
      .clk_i(clk_i),
      .d1_addr_i(d1_addr_o[0+:WORD_ADDR]),
      .d2_dest_i(d2_dest_i),
      .d3_dest_i(d3_dest_i),
      .x_dest_i(x_dest_i),
      .w_dest_i(w_dest_i),
      .d2_bank_i(d2_bank_i[0+:SLOTS*BITS]),
      .d3_device_i(d3_device1_q),
      .d3_other_i(d3_source_q),
      .x_we_i(x_we_i),
      .w_we_i(w_we_i),
      .w_data_i(w_value_i),
      .v_data_i(v_value_i),
      .x_value_o(x_s1)
  );

  wire [BITS-1:0] x_s2;
  operand #(
      .WIDTH(BITS),
      .ADDR_BITS(WORD_ADDR),
      .WRITERS(SLOTS)
  ) s2 (
      .clk_i(clk_i),
      .d1_addr_i(d1_addr_o[WORD_ADDR+:WORD_ADDR]),
      .d2_dest_i(d2_dest_i),
      .d3_dest_i(d3_dest_i),
      .x_dest_i(x_dest_i),
      .w_dest_i(w_dest_i),
      .d2_bank_i(d2_bank_i[SLOTS*BITS+:SLOTS*BITS]),
      .d3_device_i(d3_device2_q),
      .d3_other_i(d3_other2),
      .x_we_i(x_we_i),
      .w_we_i(w_we_i),
      .w_data_i(w_value_i),
      .v_data_i(v_value_i),
      .x_value_o(x_s2)
  );

  // What the other banks hold at rd.
  wire [SLOTS*BITS-1:0] x_cross;
  genvar i;
  generate
    for (i = 0; i < SLOTS; i = i + 1) begin : g_cross
      if (i == SLOT) begin : g_own
        assign x_cross[i*BITS+:BITS] = {BITS{1'b0}};
        wire unused_own = &{1'b0, d2_cross_i[i*BITS+:BITS]};
        wire unused_bank = &{1'b0, w_bank_i[i*BITS+:BITS], v_bank_i[i*BITS+:BITS]};
      end else begin : g_other
        operand #(
            .WIDTH(BITS),
            .ADDR_BITS(WORD_ADDR),
            .WRITERS(1)
        ) operand (
            .clk_i(clk_i),
            .d1_addr_i(d1_rd),
            .d2_dest_i(d2_dest_i[i*WORD_ADDR+:WORD_ADDR]),
            .d3_dest_i(d3_dest_i[i*WORD_ADDR+:WORD_ADDR]),
            .x_dest_i(x_dest_i[i*WORD_ADDR+:WORD_ADDR]),
            .w_dest_i(w_dest_i[i*WORD_ADDR+:WORD_ADDR]),
            .d2_bank_i(d2_cross_i[i*BITS+:BITS]),
            .d3_device_i(1'b1),
            .d3_other_i({BITS{1'b0}}),
            .x_we_i(x_we_i[i]),
            .w_we_i(w_we_i[i]),
            .w_data_i(w_bank_i[i*BITS+:BITS]),
            .v_data_i(v_bank_i[i*BITS+:BITS]),
            .x_value_o(x_cross[i*BITS+:BITS])
        );
      end
    end
  endgenerate

  reg [BITS-1:0] x_others;
  integer j;
  always @* begin
    x_others = {BITS{1'b0}};
    for (j = 0; j < SLOTS; j = j + 1) x_others = x_others ^ x_cross[j*BITS+:BITS];
  end

  alu alu (
      .clk_i(clk_i),
      .scan_start_i(scan_start_i),
      .d2_op_i(d2_op_q),
      .x_s1_i(x_s1),
      .x_s2_i(x_s2),
      .x_acc_i(x_acc_i),
      .x_cross_i(x_others),
      .x_result_o(x_value_o),
      .x_bank_o(x_bank_o),
      .x_sum_o(x_sum_o),
      .x_test_o(x_test_o)
  );

  wire x_run = x_always_q || x_exc_i;
  assign x_we_o = x_we_q && x_run;
  assign x_test_we_o = x_test_q && x_run;

  muldiv #(
      .MUL_DSP(MUL_DSP)
  ) unit (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .scan_start_i(scan_start_i),
      .x_start_i(x_start_q),
      .x_executed_i(x_run),
      .x_div_i(x_div_q),
      .x_wide_i(x_wide_q),
      .x_high_i(x_high_q),
      .x_s1_i(x_s1),
      .x_s2_i(x_s2),
      .d3_word_i(d3_word_q),
      .d3_result_o(d3_unit),
      .d3_valid_o(d3_unit_valid),
      .w_div_by_0_o(w_div_by_0_o)
  );

endmodule

`default_nettype wire

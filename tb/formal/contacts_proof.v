// SPDX-License-Identifier: Apache-2.0
// One look-up of MPU2 is three contacts of MPU1 (paper, 4.3): both bit sides run the same source, four
// clocks at a time. MPU1 takes a first contact (LD, LDI, or none: it goes on with exc), two more (AND, ANI,
// OR, ORI or none) and a coil (OUT, SET, RST or none); MPU2 takes NOPs and then LUT, LUTO, LUTS or LUTR,
// with N0 as `a` where MPU1 goes on, and the row that the paper's opcode of 1 + 3 + 3 bits stands for.
// Afterwards exc, the write and all devices are equal.
`default_nettype none
`include "rung_isa.vh"

module contacts_proof #(
    parameter BIT_ADDR = 2,
    parameter WORD_ADDR = 2
) (
    input wire clk_i,
    // the next four clocks' source
    input wire go_on_i,  // no first contact
    input wire first_i,  // 0: LD, 1: LDI
    input wire [2:0] second_i,  // 0: none, 1: AND, 2: ANI, 3: OR, 4: ORI
    input wire [2:0] third_i,
    input wire [1:0] coil_i,  // 0: none, 1: OUT, 2: SET, 3: RST
    input wire [BIT_ADDR-1:0] a_i,
    input wire [BIT_ADDR-1:0] b_i,
    input wire [BIT_ADDR-1:0] c_i,
    input wire peek_exc1,
    input wire peek_exc2
);

  localparam DEVICES = 1 << BIT_ADDR;
  localparam BITS = `RUNG_WORD_BITS;
  localparam DEST_AT = BITS + WORD_ADDR;
  localparam FIELDS1 = DEST_AT + BIT_ADDR + 3;
  localparam FIELDS2 = DEST_AT + BIT_ADDR + 1 + `RUNG_ROW_BITS;

  reg [3:0] age_q;
  initial age_q = 4'd0;
  always @(posedge clk_i) if (age_q != 4'd15) age_q <= age_q + 4'd1;
  wire reset = age_q < 4'd8;  // NOPs until the pipelines are empty

  // ---- the source ------------------------------------------------------------------------------
  reg [1:0] phase_q;
  reg go_on_q, first_q;
  reg [2:0] second_q, third_q;
  reg [1:0] coil_q;
  reg [BIT_ADDR-1:0] a_q, b_q, c_q;
  always @* assume (second_i <= 3'd4 && third_i <= 3'd4);
  always @(posedge clk_i) begin
    phase_q <= reset ? 2'd0 : phase_q + 2'd1;
    if (reset || phase_q == 2'd3) begin
      {go_on_q, first_q, coil_q} <= {go_on_i, first_i, coil_i};
      {second_q, third_q} <= {second_i, third_i};
      {a_q, b_q, c_q} <= {a_i, b_i, c_i};
    end
  end

  function automatic [`RUNG_OP_BITS-1:0] contact(input reg [2:0] code);
    case (code)
      3'd1: contact = `RUNG_OP_AND;
      3'd2: contact = `RUNG_OP_ANI;
      3'd3: contact = `RUNG_OP_OR;
      3'd4: contact = `RUNG_OP_ORI;
      default: contact = `RUNG_OP_NOP;
    endcase
  endfunction
  function automatic meaning(input reg [2:0] code, input reg held, input reg device);
    case (code)
      3'd1: meaning = held && device;
      3'd2: meaning = held && !device;
      3'd3: meaning = held || device;
      3'd4: meaning = held || !device;
      default: meaning = held;
    endcase
  endfunction

  reg [`RUNG_OP_BITS-1:0] op1, op2;
  reg [BIT_ADDR-1:0] device;
  reg [7:0] row;
  integer i;
  always @* begin
    op1 = `RUNG_OP_NOP;
    op2 = `RUNG_OP_NOP;
    device = c_q;
    case (phase_q)
      2'd0: begin
        if (!go_on_q) op1 = first_q ? `RUNG_OP_LDI : `RUNG_OP_LD;
        device = a_q;
      end
      2'd1: begin
        op1 = contact(second_q);
        device = b_q;
      end
      2'd2: op1 = contact(third_q);
      default: begin
        op2 = `RUNG_OP_LUT;
        if (coil_q == 2'd1) {op1, op2} = {`RUNG_OP_OUT, `RUNG_OP_LUTO};
        if (coil_q == 2'd2) {op1, op2} = {`RUNG_OP_SET, `RUNG_OP_LUTS};
        if (coil_q == 2'd3) {op1, op2} = {`RUNG_OP_RST, `RUNG_OP_LUTR};
      end
    endcase
    if (reset) {op1, op2} = {`RUNG_OP_NOP, `RUNG_OP_NOP};
    for (i = 0; i < 8; i = i + 1) begin
      row[i] = meaning(third_q, meaning(second_q, i[2] ^ (first_q && !go_on_q), i[1]), i[0]);
    end
  end
  reg [7:0] row_q;  // ID2
  always @(posedge clk_i) row_q <= row;

  // ---- both bit sides, each with devices of its own --------------------------------------------
  wire [BIT_ADDR-1:0] addr1;
  wire [3*BIT_ADDR-1:0] addr2;
  wire we1, value1, exc1, we2, value2, bank2, exc2;
  wire [BIT_ADDR-1:0] d2_dest1, d3_dest1, x_dest1, d2_dest2, d3_dest2, x_dest2;
  reg bank1_q, w_we1_q, w_value1_q, v_value1_q, w_we2_q, w_value2_q, v_value2_q;
  reg [2:0] bank2_q;
  reg [BIT_ADDR-1:0] w_dest1_q, w_dest2_q;
  reg [DEVICES-1:0] devices1_q, devices2_q;
  wire [`RUNG_WORD_BITS-1:0] acc1, acc2;
  wire x_exc1, x_exc2;
  wire [`RUNG_ROW_BITS-1:0] row_number;
  contact_unit #(
      .BIT_ADDR(BIT_ADDR),
      .WORD_ADDR(WORD_ADDR),
      .FIELD_BITS(FIELDS1)
  ) mpu1 (
      .clk_i(clk_i),
      .scan_start_i(1'b0),
      .d1_op_i(op1),
      .d1_fields_i({3'd0, device, {DEST_AT{1'b0}}}),
      .d1_ix_dest_i(1'b0),
      .d1_ix_i({BIT_ADDR{1'b0}}),
      .d1_addr_o(addr1),
      .d2_bank_i(bank1_q),
      .d2_dest_o(d2_dest1),
      .d3_dest_o(d3_dest1),
      .x_dest_o(x_dest1),
      .w_dest_i(w_dest1_q),
      .w_we_i(w_we1_q),
      .w_value_i(w_value1_q),
      .v_value_i(v_value1_q),
      .x_test_we_i(1'b0),
      .x_test_i(1'b0),
      .x_we_o(we1),
      .x_value_o(value1),
      .x_exc_o(x_exc1),
      .x_exc_next_o(exc1),
      .x_acc_o(acc1)
  );
  wire [DEST_AT-1:0] sources2 = {{DEST_AT - 2 * BIT_ADDR - 2{1'b0}}, 1'b0, b_q, go_on_q, a_q};
  look_up_unit #(
      .BIT_ADDR(BIT_ADDR),
      .WORD_ADDR(WORD_ADDR),
      .FIELD_BITS(FIELDS2)
  ) mpu2 (
      .clk_i(clk_i),
      .scan_start_i(1'b0),
      .d1_op_i(op2),
      .d1_fields_i({{`RUNG_ROW_BITS{1'b0}}, 1'b0, c_q, sources2}),
      .d1_ix_source_i(1'b0),
      .d1_ix_dest_i(1'b0),
      .d1_ix_i({BIT_ADDR{1'b0}}),
      .d1_addr_o(addr2),
      .d1_row_o(row_number),
      .d2_bank_i(bank2_q),
      .d2_row_i(row_q),
      .d2_dest_o(d2_dest2),
      .d3_dest_o(d3_dest2),
      .x_dest_o(x_dest2),
      .d2_dest_i(d2_dest2),
      .d3_dest_i(d3_dest2),
      .x_dest_i(x_dest2),
      .w_dest_i(w_dest2_q),
      .x_we_i(we2),
      .w_we_i(w_we2_q),
      .w_value_i(w_value2_q),
      .w_bank_i(w_value2_q),
      .v_value_i(v_value2_q),
      .v_bank_i(v_value2_q),
      .x_test_we_i(1'b0),
      .x_test_i(1'b0),
      .x_we_o(we2),
      .x_value_o(value2),
      .x_bank_o(bank2),
      .x_exc_o(x_exc2),
      .x_exc_next_o(exc2),
      .x_acc_o(acc2)
  );
  initial devices1_q = {DEVICES{1'b0}};
  initial devices2_q = {DEVICES{1'b0}};
  always @(posedge clk_i) begin
    bank1_q <= devices1_q[addr1];
    bank2_q <= {devices2_q[addr2[2*BIT_ADDR+:BIT_ADDR]], devices2_q[addr2[BIT_ADDR+:BIT_ADDR]],
                devices2_q[addr2[0+:BIT_ADDR]]};
    {w_we1_q, w_dest1_q, w_value1_q, v_value1_q} <= {we1 && !reset, x_dest1, value1, w_value1_q};
    {w_we2_q, w_dest2_q, w_value2_q, v_value2_q} <= {we2 && !reset, x_dest2, value2, w_value2_q};
    if (w_we1_q && !reset) devices1_q[w_dest1_q] <= w_value1_q;
    if (w_we2_q && !reset) devices2_q[w_dest2_q] <= w_value2_q;
  end

  // ---- the coil is in EX three clocks after ID1 ------------------------------------------------
  reg [1:0] behind_q[1:3];
  always @(posedge clk_i) begin
    behind_q[1] <= phase_q;
    behind_q[2] <= behind_q[1];
    behind_q[3] <= behind_q[2];
  end
  wire together = age_q == 4'd15 && behind_q[3] == 2'd3;
  // Both start with the same exc.
  always @* if (age_q < 4'd12) assume (peek_exc1 == peek_exc2);
  always @* begin
    if (!reset) begin
      assert (w_we1_q == w_we2_q && devices1_q == devices2_q);
      if (w_we1_q) assert (w_dest1_q == w_dest2_q && w_value1_q == w_value2_q);
    end
    if (age_q == 4'd15) begin
      assert (behind_q[1] + 2'd1 == phase_q && behind_q[2] + 2'd2 == phase_q);
      assert (behind_q[3] + 2'd3 == phase_q);
      assert (we1 == we2);
      if (behind_q[3] == 2'd0) assert (peek_exc1 == peek_exc2);
    end
    if (together) begin
      assert (exc1 == exc2);
      if (we1) assert (value1 == value2 && x_dest1 == x_dest2);
    end
  end

  always @* begin
    cover (together && we1 && value1 && devices1_q == 4'b0110);
    cover (together && exc1 && we1 && !value1);
  end

endmodule

`default_nettype wire

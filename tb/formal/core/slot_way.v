// SPDX-License-Identifier: Apache-2.0
// For core_proof.v, one slot: its registers beside those of the model, what retires beside what the model
// says, and, so that induction goes through, what stands in the stages from ID1 to the second clock after
// EX.
`default_nettype none
`include "rung_isa.vh"

module slot_way #(
    parameter LOOKUP = 1,
    parameter FREE_ALU = 0,
    parameter BIT_ADDR = 2,
    parameter WORD_ADDR = 2,
    parameter IX_BITS = 2,
    parameter BITS = 16,
    parameter SLOT_BITS = 31
) (
    input wire clk_i,
    input wire quiet_i,  // still reset, and nothing in ID2
    input wire known_i,
    input wire scan_start_i,
    // steps in ID1, and in ID2 (lowest), ID3, EX; a step's pass; its number in EX
    input wire [SLOT_BITS-1:0] d1_step_i,
    input wire d1_valid_i,
    input wire d1_first_i,
    input wire [3*SLOT_BITS-1:0] steps_i,
    input wire [2:0] valid_i,
    input wire [2:0] first_i,
    input wire last_i,
    input wire [15:0] number_i,
    // EX: what the LUT gave, the devices, a host's write, what the unit gave
    input wire [7:0] row_i,
    input wire [(1<<BIT_ADDR)-1:0] bits_i,
    input wire [(BITS<<WORD_ADDR)-1:0] words_i,
    input wire host_bit_we_i,
    input wire host_word_we_i,
    input wire [15:0] host_data_i,
    input wire [1:0] unit_index_i,
    input wire [BITS-1:0] unit_word_i,
    input wire unit_valid_i,
    // the slot's bank, and what the other banks hold
    input wire [(1<<BIT_ADDR)-1:0] bit_bank_i,
    input wire [(BITS<<WORD_ADDR)-1:0] word_bank_i,
    input wire [(1<<BIT_ADDR)-1:0] other_bits_i,
    input wire [(BITS<<WORD_ADDR)-1:0] other_words_i,
    // inside the hardware, as in core_proof.v
    input wire peek_exc_i,
    input wire [`RUNG_BLOCK_STACK-1:0] peek_block_i,
    input wire [`RUNG_BRANCH_STACK-1:0] peek_branch_i,
    input wire [BITS-1:0] peek_acc_i,
    input wire peek_carry_i,
    input wire [IX_BITS-1:0] peek_ix_i,
    input wire peek_ix_source_i,
    input wire peek_ix_dest_i,
    input wire peek_bit_we_i,
    input wire peek_word_we_i,
    input wire peek_x_bit_bank_i,
    input wire [BITS-1:0] peek_x_word_bank_i,
    input wire peek_start_i,
    input wire peek_run_i,
    input wire peek_div_i,
    input wire peek_wide_i,
    input wire peek_ldh_i,
    input wire [BITS-1:0] peek_s1_i,
    input wire [BITS-1:0] peek_s2_i,
    input wire [5:0] peek_bit_op_i,
    input wire [5:0] peek_alu_op_i,
    input wire [BITS-1:0] peek_alu_acc_i,
    input wire [BITS-1:0] peek_alu_result_i,
    input wire [BITS-1:0] peek_alu_sum_i,
    input wire peek_alu_test_i,
    input wire [1:0] peek_scan_start_i,
    input wire [4*BIT_ADDR-1:0] peek_bit_dest_i,
    input wire [4*WORD_ADDR-1:0] peek_word_dest_i,
    input wire peek_w_bit_we_i,
    input wire peek_w_word_we_i,
    input wire [1:0] peek_bit_value_i,
    input wire [2*BITS-1:0] peek_word_value_i,
    input wire peek_v_bit_bank_i,
    input wire [BITS-1:0] peek_v_word_bank_i,
    // the retire port
    input wire retire_valid_i,
    input wire [15:0] retire_step_i,
    input wire retire_exc_i,
    input wire retire_bit_we_i,
    input wire [15:0] retire_bit_addr_i,
    input wire retire_bit_data_i,
    input wire retire_word_we_i,
    input wire [15:0] retire_word_addr_i,
    input wire [15:0] retire_word_data_i,
    // the model's writes, by a step of the program; what was written one and two clocks ago
    output wire bit_we_o,
    output wire [BIT_ADDR-1:0] bit_addr_o,
    output wire bit_value_o,
    output wire word_we_o,
    output wire [WORD_ADDR-1:0] word_addr_o,
    output wire [BITS-1:0] word_value_o,
    output wire [1:0] bit_we_before_o,
    output wire [2*BIT_ADDR-1:0] bit_dest_before_o,
    output wire [1:0] word_we_before_o,
    output wire [2*WORD_ADDR-1:0] word_dest_before_o
);

  localparam DEST_AT = BITS + WORD_ADDR;

  function automatic uses_ix(input reg [5:0] op);
    uses_ix = op == `RUNG_OP_MVX || op == `RUNG_OP_MVBX || writes_ix(op);
  endfunction
  // MPU1's only bit operand stands in the place of the destination, also where it is read.
  function automatic writes_ix(input reg [5:0] op);
    writes_ix = op == `RUNG_OP_STX || op == `RUNG_OP_LDX || op == `RUNG_OP_SETX ||
        op == `RUNG_OP_RSTX;
  endfunction

  // ---- EX: the model ---------------------------------------------------------------------------
  wire valid = valid_i[2];
  wire [SLOT_BITS-1:0] step = steps_i[2*SLOT_BITS+:SLOT_BITS];
  wire [5:0] op = step[SLOT_BITS-1-:6];
  reg exc_q, carry_q;
  reg [`RUNG_BLOCK_STACK-1:0] block_q;
  reg [`RUNG_BRANCH_STACK-1:0] branch_q;
  reg [BITS-1:0] acc_q;
  reg [IX_BITS-1:0] ix_q;
  wire exc, carry, bit_we, word_we;
  wire [`RUNG_BLOCK_STACK-1:0] block;
  wire [`RUNG_BRANCH_STACK-1:0] branch;
  wire [BITS-1:0] acc;
  wire [IX_BITS-1:0] ix;
  wire legal, retires, has_words, sets_ix, starts, divide, wide, ldh, run, collects;
  wire [1:0] unit_index;
  wire [BITS-1:0] s1, s2;
  slot_model #(
      .LOOKUP(LOOKUP),
      .FREE_ALU(FREE_ALU),
      .BIT_ADDR(BIT_ADDR),
      .WORD_ADDR(WORD_ADDR),
      .IX_BITS(IX_BITS),
      .INSTRUCTION_BITS(SLOT_BITS)
  ) model (
      .instruction_i(step),
      .first_i(first_i[2]),
      .last_i(last_i),
      .row_i(row_i),
      .bits_i(bits_i),
      .words_i(words_i),
      .unit_valid_i(unit_valid_i),
      .unit_word_i(unit_word_i),
      .alu_result_i(peek_alu_result_i),
      .alu_sum_i(peek_alu_sum_i),
      .alu_test_i(peek_alu_test_i),
      .exc_i(exc_q),
      .block_i(block_q),
      .branch_i(branch_q),
      .acc_i(acc_q),
      .carry_i(carry_q),
      .ix_i(ix_q),
      .exc_o(exc),
      .block_o(block),
      .branch_o(branch),
      .acc_o(acc),
      .carry_o(carry),
      .ix_o(ix),
      .legal_o(legal),
      .retires_o(retires),
      .words_o(has_words),
      .sets_ix_o(sets_ix),
      .bit_we_o(bit_we),
      .bit_addr_o(bit_addr_o),
      .bit_value_o(bit_value_o),
      .word_we_o(word_we),
      .word_addr_o(word_addr_o),
      .word_value_o(word_value_o),
      .start_o(starts),
      .divide_o(divide),
      .wide_o(wide),
      .ldh_o(ldh),
      .run_o(run),
      .collects_o(collects),
      .unit_index_o(unit_index),
      .s1_o(s1),
      .s2_o(s2)
  );
  assign bit_we_o  = valid && bit_we;
  assign word_we_o = valid && word_we;
  always @* if (valid) assume (legal);

  // A scan begins with nothing of the last one but ix and LDH's words, which programs set first.
  always @(posedge clk_i) begin
    if (valid) begin
      {exc_q, carry_q, acc_q, ix_q} <= {exc, carry, acc, ix};
      {block_q, branch_q} <= {block, branch};
    end
    // The model takes over what the hardware holds.
    if (!known_i) begin
      {exc_q, carry_q} <= {peek_exc_i, peek_carry_i};
      {block_q, branch_q} <= {peek_block_i, peek_branch_i};
      {acc_q, ix_q} <= {peek_acc_i, peek_ix_i};
    end
    if (scan_start_i) begin
      {exc_q, carry_q, acc_q} <= {2'b00, {BITS{1'b0}}};
      {block_q, branch_q} <= {`RUNG_BLOCK_STACK + `RUNG_BRANCH_STACK{1'b0}};
    end
  end

  // Destinations from ID2 to the second clock after EX.
  reg [BIT_ADDR-1:0] bit_dest_q[1:5];
  reg [WORD_ADDR-1:0] word_dest_q[1:5];
  wire [WORD_ADDR-1:0] x_word_dest = word_dest_q[3];

  reg [5:0] alu_op_q[1:2];
  always @(posedge clk_i) {alu_op_q[2], alu_op_q[1]} <= {alu_op_q[1], peek_alu_op_i};
  wire [5:0] alu_op = alu_op_q[2];
  wire sets_carry = alu_op == `RUNG_OP_ADD || alu_op == `RUNG_OP_ADC || alu_op == `RUNG_OP_SUB ||
      alu_op == `RUNG_OP_SBC || alu_op == `RUNG_OP_CMP || alu_op == `RUNG_OP_LTU;

  always @* begin
    if (known_i) begin
      assert (peek_exc_i == exc_q && peek_acc_i == acc_q && peek_ix_i == ix_q);
      if (FREE_ALU == 0) assert (peek_carry_i == carry_q);
      if (LOOKUP == 0) assert (peek_block_i == block_q && peek_branch_i == branch_q);

      assert (retire_valid_i == (valid && retires));
      if (valid) assert (retire_step_i == number_i);
      if (retire_valid_i) assert (retire_exc_i == exc);
      assert (peek_bit_we_i == (valid ? bit_we : host_bit_we_i));
      assert (retire_bit_we_i == bit_we_o);
      if (bit_we_o) begin
        assert (retire_bit_addr_i == {{16 - BIT_ADDR{1'b0}}, bit_addr_o});
        assert (retire_bit_data_i == bit_value_o);
      end
      assert (peek_word_we_i == (valid ? word_we : host_word_we_i));
      assert (retire_word_we_i == word_we_o);
      if (word_we_o) begin
        assert (retire_word_addr_i == {{16 - WORD_ADDR{1'b0}}, word_addr_o});
        assert (retire_word_data_i == word_value_o);
      end

      // what the slot's bank gets
      if (peek_bit_we_i)
        assert (peek_x_bit_bank_i == (other_bits_i[bit_dest_q[3]] ^ retire_bit_data_i));
      if (peek_word_we_i)
        assert (peek_x_word_bank_i == (other_words_i[x_word_dest*BITS+:BITS] ^ retire_word_data_i));

      // what ALU and unit are asked
      assert (valid && first_i[2] && retires ? alu_op == op : !sets_carry);
      if (valid && has_words) begin
        assert (peek_s1_i == s1 && peek_s2_i == s2 && peek_alu_acc_i == acc_q);
      end
      assert (peek_start_i == (valid && starts) && peek_ldh_i == (valid && ldh));
      if (valid && starts) begin
        assert (peek_run_i == run && peek_div_i == divide && peek_wide_i == wide);
      end
      if (valid && collects) assert (unit_index_i == unit_index);
      assert (peek_scan_start_i == {2{scan_start_i}});
    end
  end

  // ---- ID1: an indexed access stands RUNG_INDEX_LATENCY clocks behind its IX, or later ---------
  wire [5:0] d1_op = d1_step_i[SLOT_BITS-1-:6];
  reg [3:1] sets_ix_q;
  always @* if (d1_valid_i && uses_ix(d1_op)) assume (sets_ix_q == 3'b000);
  always @* begin
    if (quiet_i) begin
      assert (peek_alu_op_i == `RUNG_OP_NOP && peek_bit_op_i == `RUNG_OP_NOP);
      assert (!peek_ix_source_i && !peek_ix_dest_i);
    end
    if (known_i) begin
      assert (peek_bit_op_i == peek_alu_op_i);
      assert (peek_ix_source_i == (d1_op == `RUNG_OP_MVX || d1_op == `RUNG_OP_MVBX));
      assert (peek_ix_dest_i == writes_ix(d1_op));
    end
  end

  // ---- ID2 to EX, and behind EX: destinations; where nothing is written, for the compares only --
  integer i;
  always @(posedge clk_i) begin
    sets_ix_q <= {sets_ix_q[2:1], d1_valid_i && d1_first_i && d1_op == `RUNG_OP_IX};
    bit_dest_q[1] <= writes_ix(d1_op) ? ix_q[BIT_ADDR-1:0] : d1_step_i[DEST_AT+:BIT_ADDR];
    word_dest_q[1] <= writes_ix(d1_op) ? ix_q[WORD_ADDR-1:0] : d1_step_i[DEST_AT+:WORD_ADDR];
    for (i = 2; i <= 5; i = i + 1) begin
      bit_dest_q[i]  <= bit_dest_q[i-1];
      word_dest_q[i] <= word_dest_q[i-1];
    end
  end
  always @* if (known_i) assert (sets_ix_q[3] == (valid && sets_ix));

  genvar g;
  generate
    for (g = 1; g <= 4; g = g + 1) begin : g_stage
      always @* begin
        if (known_i) begin
          assert (peek_bit_dest_i[(g-1)*BIT_ADDR+:BIT_ADDR] == bit_dest_q[g]);
          assert (peek_word_dest_i[(g-1)*WORD_ADDR+:WORD_ADDR] == word_dest_q[g]);
        end
      end
    end
    for (g = 1; g <= 3; g = g + 1) begin : g_way
      wire [SLOT_BITS-1:0] way = steps_i[(g-1)*SLOT_BITS+:SLOT_BITS];
      wire [5:0] way_op = way[SLOT_BITS-1-:6];
      wire by_ix = writes_ix(way_op);
      wire waits = way_op == `RUNG_OP_MUL || way_op == `RUNG_OP_DIV || way_op == `RUNG_OP_MULD ||
          way_op == `RUNG_OP_DIVD;
      wire [5:0] issued = g == 1 ? peek_alu_op_i : g == 2 ? alu_op_q[1] : alu_op_q[2];
      wire ix_ahead = (g < 2 && sets_ix_q[2]) || (g < 3 && sets_ix_q[3]);
      always @* begin
        if (known_i) begin
          assert (sets_ix_q[g] == (valid_i[g-1] && first_i[g-1] && way_op == `RUNG_OP_IX));
          if (valid_i[g-1] && uses_ix(way_op)) assert (!ix_ahead);
          assert (valid_i[g-1] || first_i[g-1]);
          if (first_i[g-1] && !waits) assert (issued == way_op);
          assert (bit_dest_q[g] == (by_ix ? ix_q[BIT_ADDR-1:0] : way[DEST_AT+:BIT_ADDR]));
          assert (word_dest_q[g] == (by_ix ? ix_q[WORD_ADDR-1:0] : way[DEST_AT+:WORD_ADDR]));
        end
      end
    end
  endgenerate

  // ---- behind EX: the last two writes ----------------------------------------------------------
  reg [2:1] bit_we_q, word_we_q, bit_value_q;
  reg [BITS-1:0] word_value_q[1:2];
  always @(posedge clk_i) begin
    bit_we_q <= {bit_we_q[1], valid ? bit_we : host_bit_we_i};
    word_we_q <= {word_we_q[1], valid ? word_we : host_word_we_i};
    bit_value_q <= {bit_value_q[1], valid ? bit_value_o : host_data_i[0]};
    word_value_q[1] <= valid ? word_value_o : host_data_i;
    word_value_q[2] <= word_value_q[1];
  end
  assign bit_we_before_o = bit_we_q;
  assign word_we_before_o = word_we_q;
  assign bit_dest_before_o = {bit_dest_q[5], bit_dest_q[4]};
  assign word_dest_before_o = {word_dest_q[5], word_dest_q[4]};
  wire [BIT_ADDR-1:0] v_bit_dest = bit_dest_q[5];
  wire [WORD_ADDR-1:0] v_word_dest = word_dest_q[5];
  always @* begin
    if (known_i) begin
      assert (peek_w_bit_we_i == bit_we_q[1] && peek_w_word_we_i == word_we_q[1]);
      if (bit_we_q[1]) assert (peek_bit_value_i[1] == bit_value_q[1]);
      if (word_we_q[1]) assert (peek_word_value_i[BITS+:BITS] == word_value_q[1]);
      if (bit_we_q[2]) begin
        assert (peek_bit_value_i[0] == bit_value_q[2]);
        assert (peek_v_bit_bank_i == bit_bank_i[v_bit_dest]);
      end
      if (word_we_q[2]) begin
        assert (peek_word_value_i[0+:BITS] == word_value_q[2]);
        assert (peek_v_word_bank_i == word_bank_i[v_word_dest*BITS+:BITS]);
      end
    end
  end

endmodule

`default_nettype wire

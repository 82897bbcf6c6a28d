// SPDX-License-Identifier: Apache-2.0
// MPU1, MPU2, MPU3 (hdl/core/core.v) over the retire port: whatever steps come, and whatever the host does between scans, each
// instruction does what model/slot_model.v says with the devices as all steps before it have left them, in the
// clock in which it retires, and nothing else writes. The model has no pipeline, so that this is forwarding at
// every distance and from either slot, N0, gating, write order, indexed access and the load port in one. Program
// memory and multiply-divide unit are free (free/); they have proofs of their own.
`default_nettype none
`include "rung_isa.vh"

module core_proof #(
    parameter LOOKUP = 1,
    parameter SLOTS = 1,
    parameter FREE_ALU = 0,  // 1: with free/alu.v
    parameter BIT_ADDR = 2,
    parameter WORD_ADDR = 2,
    // not to be set
    parameter IX_BITS = BIT_ADDR > WORD_ADDR ? BIT_ADDR : WORD_ADDR,
    parameter BITS = `RUNG_WORD_BITS,
    parameter BIT_DEVICES = 1 << BIT_ADDR,
    parameter WORD_DEVICES = 1 << WORD_ADDR,
    parameter OPERAND = LOOKUP != 0 ? BIT_ADDR + 1 : BIT_ADDR,
    parameter SLOT_BITS = BITS + WORD_ADDR + (OPERAND > WORD_ADDR ? OPERAND : WORD_ADDR) +
        (LOOKUP != 0 ? 7 : 3) + 6,
    parameter READS = LOOKUP != 0 ? 3 : 1
) (
    input wire clk_i,
    input wire start_i,
    input wire load_valid_i,
    input wire load_write_i,
    input wire [2:0] load_space_i,
    input wire [19:0] load_addr_i,
    input wire [15:0] load_data_i,
    // inside the hardware; slot 0 lowest
    input wire [40:0] peek_access,  // of the load port: valid, write, space, address, data
    input wire [4:0] peek_accesses,  // the same on its way from ID1 (lowest) to behind EX
    input wire [4:0] peek_reads,
    input wire [4:0] peek_word_reads,
    input wire [SLOTS*SLOT_BITS-1:0] peek_step,  // ID1
    input wire peek_valid,
    input wire [15:0] peek_number,
    input wire peek_first,
    input wire peek_last,
    input wire peek_waits,
    input wire peek_waiting,
    input wire [5:0] peek_fetch,  // of free/fetch.v: since, ended, d1_end, d2_end, d3_end
    input wire [SLOTS*8-1:0] peek_row,  // ID2: what the LUT gives
    input wire [SLOTS-1:0] peek_exc,
    input wire [SLOTS*`RUNG_BLOCK_STACK-1:0] peek_block,
    input wire [SLOTS*`RUNG_BRANCH_STACK-1:0] peek_branch,
    input wire [SLOTS*BITS-1:0] peek_acc,
    input wire [SLOTS-1:0] peek_carry,
    input wire [SLOTS*IX_BITS-1:0] peek_ix,
    input wire [SLOTS-1:0] peek_ix_source,  // ID1: ix in the place of a source, of the destination
    input wire [SLOTS-1:0] peek_ix_dest,
    input wire [SLOTS-1:0] peek_bit_we,  // EX, host accesses too
    input wire [SLOTS-1:0] peek_word_we,
    // the unit: what it is asked in EX, its answer in ID3
    input wire [SLOTS-1:0] peek_start,
    input wire [SLOTS-1:0] peek_run,
    input wire [SLOTS-1:0] peek_div,
    input wire [SLOTS-1:0] peek_wide,
    input wire [SLOTS-1:0] peek_ldh,
    input wire [SLOTS*BITS-1:0] peek_s1,
    input wire [SLOTS*BITS-1:0] peek_s2,
    // the ALU: the instruction in ID2, acc in EX, its results
    input wire [SLOTS*6-1:0] peek_alu_op,
    input wire [SLOTS*BITS-1:0] peek_alu_acc,
    input wire [SLOTS*BITS-1:0] peek_alu_result,
    input wire [SLOTS*BITS-1:0] peek_alu_sum,
    input wire [SLOTS-1:0] peek_alu_test,
    input wire [SLOTS*2-1:0] peek_unit_index,
    input wire [SLOTS*BITS-1:0] peek_unit_word,
    input wire [SLOTS-1:0] peek_unit_valid,
    input wire [SLOTS-1:0] peek_by_0,
    // devices written by the steps in ID2 (lowest), ID3, EX and behind it; what the last two wrote
    input wire [4*SLOTS*BIT_ADDR-1:0] peek_bit_dest,
    input wire [4*SLOTS*WORD_ADDR-1:0] peek_word_dest,
    input wire [SLOTS-1:0] peek_w_bit_we,
    input wire [SLOTS-1:0] peek_w_word_we,
    input wire [2*SLOTS-1:0] peek_bit_value,  // v_ lower, w_ upper
    input wire [2*SLOTS*BITS-1:0] peek_word_value,
    input wire [2*SLOTS-1:0] peek_bit_bank,
    input wire [2*SLOTS*BITS-1:0] peek_word_bank,
    // memories: for each bank, for each copy of it, all devices
    input wire [SLOTS*SLOTS*READS*BIT_DEVICES-1:0] peek_bits,
    input wire [SLOTS*(SLOTS*2+SLOTS-1)*WORD_DEVICES*BITS-1:0] peek_words
);

  // ---- reset: five clocks --------------------------------------------------------------------
  reg [2:0] age_q;
  initial age_q = 3'd0;
  always @(posedge clk_i) if (age_q != 3'd6) age_q <= age_q + 3'd1;
  wire reset = age_q < 3'd5;
  wire known = age_q == 3'd6;
  wire taking = !known;  // the model takes over what the hardware holds
  wire start = start_i && !reset;
  wire load_valid = load_valid_i && !reset;

  wire busy, done, error, load_rvalid;
  wire [15:0] load_rdata;
  wire [31:0] clocks;
  wire [SLOTS-1:0] write_valid;
  wire [SLOTS*16-1:0] write_addr, write_data;
  wire [SLOTS-1:0] retire_valid, retire_exc, retire_bit_we, retire_bit_data, retire_word_we;
  wire [SLOTS*16-1:0] retire_step, retire_bit_addr, retire_word_addr, retire_word_data;
  core #(
      .LOOKUP(LOOKUP),
      .SLOTS(SLOTS),
      .STEPS(4),
      .BIT_DEVICES(BIT_DEVICES),
      .WORD_DEVICES(WORD_DEVICES),
      .MUL_LATENCY(2),
      .DIV_LATENCY(3),
      .MUL32_LATENCY(2),
      .DIV32_LATENCY(3)
  ) core (
      .clk_i(clk_i),
      .rst_ni(!reset),
      .start_i(start),
      .busy_o(busy),
      .done_o(done),
      .error_o(error),
      .clocks_o(clocks),
      .range_i(1'b0),
      .entry_i(16'd0),
      .end_i(16'd0),
      .write_valid_o(write_valid),
      .write_addr_o(write_addr),
      .write_data_o(write_data),
      .load_valid_i(load_valid),
      .load_write_i(load_write_i),
      .load_space_i(load_space_i),
      .load_addr_i(load_addr_i),
      .load_data_i(load_data_i),
      .load_rvalid_o(load_rvalid),
      .load_rdata_o(load_rdata),
      .retire_valid_o(retire_valid),
      .retire_step_o(retire_step),
      .retire_exc_o(retire_exc),
      .retire_bit_we_o(retire_bit_we),
      .retire_bit_addr_o(retire_bit_addr),
      .retire_bit_data_o(retire_bit_data),
      .retire_word_we_o(retire_word_we),
      .retire_word_addr_o(retire_word_addr),
      .retire_word_data_o(retire_word_data)
  );
  wire scan_start = start && !busy;

  localparam DEST_AT = BITS + WORD_ADDR;
  function automatic indexed_op(input reg [5:0] op);
    indexed_op = op == `RUNG_OP_MVX || op == `RUNG_OP_STX || op == `RUNG_OP_MVBX ||
        op == `RUNG_OP_LDX || op == `RUNG_OP_SETX || op == `RUNG_OP_RSTX;
  endfunction

  // ---- what is in EX: in ID1 three clocks ago --------------------------------------------------
  reg [SLOTS*SLOT_BITS-1:0] step_q[1:3];
  reg valid_q[1:3];
  reg first_q[1:3];
  reg last_q[1:3];
  reg [15:0] number_q[1:3];
  reg [SLOTS*8-1:0] row_q[1:2];
  reg [SLOTS*2-1:0] unit_index_q;
  reg [SLOTS*BITS-1:0] unit_word_q;
  reg [SLOTS-1:0] unit_valid_q;
  // A host access: accepted so many clocks ago; in EX after 5, answered after 6.
  reg host_q[1:6];
  reg host_write_q[1:6];
  reg [2:0] host_space_q[1:6];
  reg [19:0] host_addr_q[1:6];
  reg [15:0] host_data_q[1:6];
  integer i;
  always @(posedge clk_i) begin
    step_q[1] <= peek_step;
    valid_q[1] <= peek_valid && !reset;
    first_q[1] <= peek_first;
    last_q[1] <= peek_last;
    number_q[1] <= peek_number;
    for (i = 2; i <= 3; i = i + 1) begin
      step_q[i] <= step_q[i-1];
      valid_q[i] <= valid_q[i-1] && !reset;
      first_q[i] <= first_q[i-1];
      last_q[i] <= last_q[i-1];
      number_q[i] <= number_q[i-1];
    end
    row_q[1] <= peek_row;
    row_q[2] <= row_q[1];
    unit_index_q <= peek_unit_index;
    unit_word_q <= peek_unit_word;
    unit_valid_q <= peek_unit_valid;
    host_q[1] <= load_valid && !busy;
    host_write_q[1] <= load_write_i;
    host_space_q[1] <= load_space_i;
    host_addr_q[1] <= load_addr_i;
    host_data_q[1] <= load_data_i;
    for (i = 2; i <= 6; i = i + 1) begin
      host_q[i] <= host_q[i-1] && !reset;
      host_write_q[i] <= host_write_q[i-1];
      host_space_q[i] <= host_space_q[i-1];
      host_addr_q[i] <= host_addr_q[i-1];
      host_data_q[i] <= host_data_q[i-1];
    end
  end
  wire [SLOTS*SLOT_BITS-1:0] instructions = step_q[3];
  wire [SLOTS*8-1:0] rows = row_q[2];
  wire valid = valid_q[3];
  wire first = first_q[3];
  wire last = last_q[3];
  wire host_bit = host_q[5] && host_space_q[5] == 3'd2;
  wire host_word = host_q[5] && host_space_q[5] == 3'd3;

  // ---- the memories: copies of a bank are alike, the banks' exclusive-or is the device ---------
  localparam BIT_COPIES = SLOTS * READS;
  localparam WORD_COPIES = 3 * SLOTS - 1;
  localparam WORD_BANK = WORD_DEVICES * BITS;
  reg [BIT_DEVICES-1:0] held_bits;
  reg [WORD_BANK-1:0] held_words;
  reg copies_alike;
  wire [SLOTS*BIT_DEVICES-1:0] bit_banks;
  wire [SLOTS*WORD_BANK-1:0] word_banks;
  genvar k;
  generate
    for (k = 0; k < SLOTS; k = k + 1) begin : g_bank
      assign bit_banks[k*BIT_DEVICES+:BIT_DEVICES] = peek_bits[k*BIT_COPIES*BIT_DEVICES+:BIT_DEVICES];
      assign word_banks[k*WORD_BANK+:WORD_BANK] = peek_words[k*WORD_COPIES*WORD_BANK+:WORD_BANK];
    end
  endgenerate
  // the same with the writes that come at the end of this clock
  reg [SLOTS*BIT_DEVICES-1:0] bit_banks_next;
  reg [SLOTS*WORD_BANK-1:0] word_banks_next;
  reg [BIT_DEVICES-1:0] coming_bits;
  reg [WORD_BANK-1:0] coming_words;
  integer b, c, p;
  always @* begin
    bit_banks_next = bit_banks;
    word_banks_next = word_banks;
    coming_bits = {BIT_DEVICES{1'b0}};
    coming_words = {WORD_BANK{1'b0}};
    for (p = 0; p < SLOTS; p = p + 1) begin
      if (peek_w_bit_we[p])
        bit_banks_next[p*BIT_DEVICES+peek_bit_dest[(3*SLOTS+p)*BIT_ADDR+:BIT_ADDR]] =
            peek_bit_bank[SLOTS+p];
      if (peek_w_word_we[p])
        word_banks_next[p*WORD_BANK+peek_word_dest[(3*SLOTS+p)*WORD_ADDR+:WORD_ADDR]*BITS+:BITS] =
            peek_word_bank[(SLOTS+p)*BITS+:BITS];
      coming_bits = coming_bits ^ bit_banks_next[p*BIT_DEVICES+:BIT_DEVICES];
      coming_words = coming_words ^ word_banks_next[p*WORD_BANK+:WORD_BANK];
    end
  end
  always @* begin
    held_bits = {BIT_DEVICES{1'b0}};
    held_words = {WORD_BANK{1'b0}};
    copies_alike = 1'b1;
    for (b = 0; b < SLOTS; b = b + 1) begin
      held_bits = held_bits ^ peek_bits[b*BIT_COPIES*BIT_DEVICES+:BIT_DEVICES];
      held_words = held_words ^ peek_words[b*WORD_COPIES*WORD_BANK+:WORD_BANK];
      for (c = 1; c < BIT_COPIES; c = c + 1) begin
        if (peek_bits[(b*BIT_COPIES+c)*BIT_DEVICES+:BIT_DEVICES] !=
            peek_bits[b*BIT_COPIES*BIT_DEVICES+:BIT_DEVICES])
          copies_alike = 1'b0;
      end
      for (c = 1; c < WORD_COPIES; c = c + 1) begin
        if (peek_words[(b*WORD_COPIES+c)*WORD_BANK+:WORD_BANK] !=
            peek_words[b*WORD_COPIES*WORD_BANK+:WORD_BANK])
          copies_alike = 1'b0;
      end
    end
  end

  // ---- the model: devices, and one slot_model for each slot ------------------------------------
  reg [BIT_DEVICES-1:0] bits_q, bits_next, bits_before_q;
  reg [WORD_DEVICES*BITS-1:0] words_q, words_next, words_before_q;
  wire [SLOTS-1:0] legal, bit_we, bit_value, word_we, sets_ix;
  wire [SLOTS*BIT_ADDR-1:0] bit_addr;
  wire [SLOTS-1:0] w_bit_we, w_word_we, v_bit_we, v_word_we;
  wire [SLOTS*BIT_ADDR-1:0] w_bit_dest, v_bit_dest;
  wire [SLOTS*WORD_ADDR-1:0] w_word_dest, v_word_dest;
  wire [SLOTS*WORD_ADDR-1:0] word_addr;
  wire [SLOTS*BITS-1:0] word_value;
  genvar s;
  generate
    for (s = 0; s < SLOTS; s = s + 1) begin : g_slot
      reg exc_q, carry_q;
      reg [`RUNG_BLOCK_STACK-1:0] block_q;
      reg [`RUNG_BRANCH_STACK-1:0] branch_q;
      reg [BITS-1:0] acc_q;
      reg [IX_BITS-1:0] ix_q;
      wire exc, carry;
      wire [`RUNG_BLOCK_STACK-1:0] block;
      wire [`RUNG_BRANCH_STACK-1:0] branch;
      wire [BITS-1:0] acc;
      wire [IX_BITS-1:0] ix;
      wire retires, has_words, starts, divide, wide, ldh, run, collects;
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
          .instruction_i(instructions[s*SLOT_BITS+:SLOT_BITS]),
          .first_i(first),
          .last_i(last),
          .row_i(rows[s*8+:8]),
          .bits_i(bits_q),
          .words_i(words_q),
          .unit_valid_i(unit_valid_q[s]),
          .unit_word_i(unit_word_q[s*BITS+:BITS]),
          .alu_result_i(peek_alu_result[s*BITS+:BITS]),
          .alu_sum_i(peek_alu_sum[s*BITS+:BITS]),
          .alu_test_i(peek_alu_test[s]),
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
          .legal_o(legal[s]),
          .retires_o(retires),
          .words_o(has_words),
          .sets_ix_o(sets_ix[s]),
          .bit_we_o(bit_we[s]),
          .bit_addr_o(bit_addr[s*BIT_ADDR+:BIT_ADDR]),
          .bit_value_o(bit_value[s]),
          .word_we_o(word_we[s]),
          .word_addr_o(word_addr[s*WORD_ADDR+:WORD_ADDR]),
          .word_value_o(word_value[s*BITS+:BITS]),
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

      // A scan begins with nothing of the last one but ix and LDH's words, which programs set first.
      always @(posedge clk_i) begin
        if (valid) begin
          exc_q <= exc;
          carry_q <= carry;
          block_q <= block;
          branch_q <= branch;
          acc_q <= acc;
          ix_q <= ix;
        end
        if (taking) begin
          exc_q <= peek_exc[s];
          carry_q <= peek_carry[s];
          block_q <= peek_block[s*`RUNG_BLOCK_STACK+:`RUNG_BLOCK_STACK];
          branch_q <= peek_branch[s*`RUNG_BRANCH_STACK+:`RUNG_BRANCH_STACK];
          acc_q <= peek_acc[s*BITS+:BITS];
          ix_q <= peek_ix[s*IX_BITS+:IX_BITS];
        end
        if (scan_start) begin
          exc_q <= 1'b0;
          carry_q <= 1'b0;
          block_q <= {`RUNG_BLOCK_STACK{1'b0}};
          branch_q <= {`RUNG_BRANCH_STACK{1'b0}};
          acc_q <= {BITS{1'b0}};
        end
      end

      wire host_bit_we = s == 0 && host_bit && host_write_q[5];
      wire host_word_we = s == 0 && host_word && host_write_q[5];
      wire [5:0] d1_op = peek_step[(s+1)*SLOT_BITS-1-:6];

      // ---- ID1: an indexed access stands RUNG_INDEX_LATENCY clocks behind its IX, or later -----
      always @* if (valid) assume (legal[s]);
      reg sets_ix_q[1:3];
      always @* if (peek_valid && indexed_op(d1_op)) assume (!sets_ix_q[1] && !sets_ix_q[2] && !sets_ix_q[3]);

      // What is no write has a destination too, for the compares only.
      wire d1_ix_dest = d1_op == `RUNG_OP_STX || d1_op == `RUNG_OP_LDX || d1_op == `RUNG_OP_SETX ||
          d1_op == `RUNG_OP_RSTX;
      wire [BIT_ADDR-1:0] d1_bit_dest =
          d1_ix_dest ? ix_q[BIT_ADDR-1:0] : peek_step[s*SLOT_BITS+DEST_AT+:BIT_ADDR];
      wire [WORD_ADDR-1:0] d1_word_dest =
          d1_ix_dest ? ix_q[WORD_ADDR-1:0] : peek_step[s*SLOT_BITS+DEST_AT+:WORD_ADDR];
      always @* begin
        if (known) begin
          assert (peek_ix_source[s] == (d1_op == `RUNG_OP_MVX || d1_op == `RUNG_OP_MVBX));
          assert (peek_ix_dest[s] == d1_ix_dest);
        end
      end
      reg [BIT_ADDR-1:0] bit_dest_q[1:4];
      reg [WORD_ADDR-1:0] word_dest_q[1:4];
      integer d;
      always @(posedge clk_i) begin
        sets_ix_q[1]   <= peek_valid && peek_first && d1_op == `RUNG_OP_IX;
        bit_dest_q[1]  <= d1_bit_dest;
        word_dest_q[1] <= d1_word_dest;
        for (d = 2; d <= 4; d = d + 1) begin
          if (d < 4) sets_ix_q[d] <= sets_ix_q[d-1];
          bit_dest_q[d]  <= bit_dest_q[d-1];
          word_dest_q[d] <= word_dest_q[d-1];
        end
      end
      genvar g;
      for (g = 1; g <= 4; g = g + 1) begin : g_stage
        always @* begin
          if (known) begin
            assert (peek_bit_dest[((g-1)*SLOTS+s)*BIT_ADDR+:BIT_ADDR] == bit_dest_q[g]);
            assert (peek_word_dest[((g-1)*SLOTS+s)*WORD_ADDR+:WORD_ADDR] == word_dest_q[g]);
          end
        end
      end
      // The same from the steps on their way.
      for (g = 1; g <= 3; g = g + 1) begin : g_way
        wire [SLOTS*SLOT_BITS-1:0] steps = step_q[g];
        wire [SLOT_BITS-1:0] step = steps[s*SLOT_BITS+:SLOT_BITS];
        wire [5:0] op = step[SLOT_BITS-1-:6];
        wire ix_dest = op == `RUNG_OP_STX || op == `RUNG_OP_LDX || op == `RUNG_OP_SETX ||
            op == `RUNG_OP_RSTX;
        wire ix_ahead = (g < 2 && sets_ix_q[2]) || (g < 3 && sets_ix_q[3]);
        always @* begin
          if (known) begin
            assert (sets_ix_q[g] == (valid_q[g] && first_q[g] && op == `RUNG_OP_IX));
            if (valid_q[g] && indexed_op(op)) assert (!ix_ahead);
            assert (bit_dest_q[g] == (ix_dest ? ix_q[BIT_ADDR-1:0] : step[DEST_AT+:BIT_ADDR]));
            assert (word_dest_q[g] == (ix_dest ? ix_q[WORD_ADDR-1:0] : step[DEST_AT+:WORD_ADDR]));
          end
        end
      end

      reg [5:0] alu_op_q[1:2];
      always @(posedge clk_i) begin
        alu_op_q[1] <= peek_alu_op[s*6+:6];
        alu_op_q[2] <= alu_op_q[1];
      end

      // ---- behind EX: the last writes --------------------------------------------------------
      reg bit_we_q[1:2];
      reg word_we_q[1:2];
      reg bit_value_q[1:2];
      reg [BITS-1:0] word_value_q[1:2];
      reg [BIT_ADDR-1:0] v_bit_dest_q;
      reg [WORD_ADDR-1:0] v_word_dest_q;
      always @(posedge clk_i) begin
        bit_we_q[1] <= valid ? bit_we[s] : host_bit_we;
        word_we_q[1] <= valid ? word_we[s] : host_word_we;
        bit_value_q[1] <= valid ? bit_value[s] : host_data_q[5][0];
        word_value_q[1] <= valid ? word_value[s*BITS+:BITS] : host_data_q[5];
        bit_we_q[2] <= bit_we_q[1];
        word_we_q[2] <= word_we_q[1];
        bit_value_q[2] <= bit_value_q[1];
        word_value_q[2] <= word_value_q[1];
        v_bit_dest_q <= bit_dest_q[4];
        v_word_dest_q <= word_dest_q[4];
      end
      assign w_bit_we[s] = bit_we_q[1];
      assign w_word_we[s] = word_we_q[1];
      assign v_bit_we[s] = bit_we_q[2];
      assign v_word_we[s] = word_we_q[2];
      assign w_bit_dest[s*BIT_ADDR+:BIT_ADDR] = bit_dest_q[4];
      assign w_word_dest[s*WORD_ADDR+:WORD_ADDR] = word_dest_q[4];
      assign v_bit_dest[s*BIT_ADDR+:BIT_ADDR] = v_bit_dest_q;
      assign v_word_dest[s*WORD_ADDR+:WORD_ADDR] = v_word_dest_q;
      wire [BIT_DEVICES-1:0] bit_bank = bit_banks[s*BIT_DEVICES+:BIT_DEVICES];
      wire [WORD_BANK-1:0] word_bank = word_banks[s*WORD_BANK+:WORD_BANK];
      always @* begin
        if (known) begin
          assert (peek_w_bit_we[s] == bit_we_q[1] && peek_w_word_we[s] == word_we_q[1]);
          if (bit_we_q[1]) assert (peek_bit_value[SLOTS+s] == bit_value_q[1]);
          if (word_we_q[1]) assert (peek_word_value[(SLOTS+s)*BITS+:BITS] == word_value_q[1]);
          if (bit_we_q[2]) begin
            assert (peek_bit_value[s] == bit_value_q[2]);
            assert (peek_bit_bank[s] == bit_bank[v_bit_dest_q]);
          end
          if (word_we_q[2]) begin
            assert (peek_word_value[s*BITS+:BITS] == word_value_q[2]);
            assert (peek_word_bank[s*BITS+:BITS] == word_bank[v_word_dest_q*BITS+:BITS]);
          end
        end
      end

      // ---- what has to be ----------------------------------------------------------------------
      always @* begin
        if (known) begin
          assert (peek_exc[s] == exc_q);
          if (FREE_ALU == 0) assert (peek_carry[s] == carry_q);
          if (LOOKUP == 0) begin
            assert (peek_block[s*`RUNG_BLOCK_STACK+:`RUNG_BLOCK_STACK] == block_q);
            assert (peek_branch[s*`RUNG_BRANCH_STACK+:`RUNG_BRANCH_STACK] == branch_q);
          end
          assert (peek_acc[s*BITS+:BITS] == acc_q);
          assert (peek_ix[s*IX_BITS+:IX_BITS] == ix_q);

          assert (retire_valid[s] == (valid && retires));
          if (valid) assert (retire_step[s*16+:16] == number_q[3]);
          if (retire_valid[s]) assert (retire_exc[s] == exc);
          assert (peek_bit_we[s] == (valid ? bit_we[s] : host_bit_we));
          assert (retire_bit_we[s] == (valid && bit_we[s]));
          if (peek_bit_we[s] && valid) begin
            assert (retire_bit_addr[s*16+:16] == {{16 - BIT_ADDR{1'b0}}, bit_addr[s*BIT_ADDR+:BIT_ADDR]});
            assert (retire_bit_data[s] == bit_value[s]);
          end
          assert (peek_word_we[s] == (valid ? word_we[s] : host_word_we));
          assert (retire_word_we[s] == (valid && word_we[s]));
          if (peek_word_we[s] && valid) begin
            assert (retire_word_addr[s*16+:16] == {{16 - WORD_ADDR{1'b0}}, word_addr[s*WORD_ADDR+:WORD_ADDR]});
            assert (retire_word_data[s*BITS+:BITS] == word_value[s*BITS+:BITS]);
          end

          assert (peek_start[s] == (valid && starts));
          assert (peek_ldh[s] == (valid && ldh));
          if (valid && has_words) begin
            assert (peek_s1[s*BITS+:BITS] == s1 && peek_s2[s*BITS+:BITS] == s2);
            assert (peek_alu_acc[s*BITS+:BITS] == acc_q);
            if (!starts) assert (alu_op_q[2] == instructions[(s+1)*SLOT_BITS-1-:6]);
          end
          if (valid && starts) begin
            assert (peek_run[s] == run && peek_div[s] == divide && peek_wide[s] == wide);
          end
          if (valid && collects) assert (unit_index_q[s*2+:2] == unit_index);
        end
      end
    end
  endgenerate

  // ---- devices: a step's slots read before any of them writes ----------------------------------
  integer w;
  always @* begin
    bits_next  = bits_q;
    words_next = words_q;
    for (w = 0; w < SLOTS; w = w + 1) begin
      if (valid && bit_we[w]) bits_next[bit_addr[w*BIT_ADDR+:BIT_ADDR]] = bit_value[w];
      if (valid && word_we[w])
        words_next[word_addr[w*WORD_ADDR+:WORD_ADDR]*BITS+:BITS] = word_value[w*BITS+:BITS];
    end
    if (host_bit && host_write_q[5]) bits_next[host_addr_q[5][BIT_ADDR-1:0]] = host_data_q[5][0];
    if (host_word && host_write_q[5])
      words_next[host_addr_q[5][WORD_ADDR-1:0]*BITS+:BITS] = host_data_q[5];
  end
  always @(posedge clk_i) begin
    bits_q <= bits_next;
    words_q <= words_next;
    bits_before_q <= bits_q;  // as in the memories, which are written a clock later
    words_before_q <= words_q;
    if (taking) begin
      bits_q <= held_bits;
      words_q <= held_words;
      bits_before_q <= held_bits;
      words_before_q <= held_words;
    end
  end

  // Two slots of a step do not write one device: the compiler sees to it.
  generate
    if (SLOTS > 1) begin : g_apart
      always @* begin
        if (valid && bit_we[0] && bit_we[1])
          assume (bit_addr[0+:BIT_ADDR] != bit_addr[BIT_ADDR+:BIT_ADDR]);
        if (valid && word_we[0] && word_we[1])
          assume (word_addr[0+:WORD_ADDR] != word_addr[WORD_ADDR+:WORD_ADDR]);
      end
      // What they wrote in the last two clocks.
      always @* begin
        if (known) begin
          assert (!(&w_bit_we) || w_bit_dest[0+:BIT_ADDR] != w_bit_dest[BIT_ADDR+:BIT_ADDR]);
          assert (!(&v_bit_we) || v_bit_dest[0+:BIT_ADDR] != v_bit_dest[BIT_ADDR+:BIT_ADDR]);
          assert (!(&w_word_we) || w_word_dest[0+:WORD_ADDR] != w_word_dest[WORD_ADDR+:WORD_ADDR]);
          assert (!(&v_word_we) || v_word_dest[0+:WORD_ADDR] != v_word_dest[WORD_ADDR+:WORD_ADDR]);
        end
      end
    end
  endgenerate

  // ---- where the scan is: nothing of it is left when the next may start, or the host may come --
  reg waits;
  integer v;
  always @* begin
    waits = 1'b0;
    for (v = 0; v < SLOTS; v = v + 1) begin
      case (peek_step[v*SLOT_BITS+SLOT_BITS-1-:6])
        `RUNG_OP_MUL, `RUNG_OP_DIV, `RUNG_OP_MULD, `RUNG_OP_DIVD: waits = 1'b1;
        default: ;
      endcase
    end
  end
  wire [1:0] since = peek_fetch[5:4];
  wire ended = peek_fetch[3];
  wire in_ex = valid_q[1] || valid_q[2] || valid_q[3];
  always @* begin
    if (known) begin
      assert (peek_waits == waits && (!waits || peek_valid) && (!peek_waiting || waits));
      assert (!busy || ended == |peek_fetch[2:0]);
      if (!busy) assert (!peek_valid && !in_ex && peek_fetch[2:0] == 3'd0);
      if (busy && since != 2'd3) assert (!peek_valid && !in_ex && !ended);
      case (peek_fetch[2:0])
        3'b000: ;
        3'b100: assert (!peek_valid);
        3'b010: assert (!peek_valid && !valid_q[1]);
        3'b001: assert (!peek_valid && !valid_q[1] && !valid_q[2]);
        default: assert (1'b0);
      endcase
      if (busy && host_q[1]) assert (since == 2'd1);
      if (busy && host_q[2]) assert (since <= 2'd2 && since != 2'd0);
      assert (!(host_q[2] && peek_valid));
      assert (!(host_q[3] && valid_q[1]) && !(host_q[4] && valid_q[2]));
      assert (!(host_q[5] && valid_q[3]));
    end
  end

  // ---- a host access in the load port, and from ID1 to EX as slot 0's instruction ----------------
  localparam TAIL_AT = DEST_AT + (OPERAND > WORD_ADDR ? OPERAND : WORD_ADDR);
  always @* begin
    if (known) begin
      assert (peek_access[40] == host_q[1]);
      if (host_q[1])
        assert (peek_access[39:0] ==
                {host_write_q[1], host_space_q[1], host_addr_q[1], host_data_q[1]});
    end
  end
  genvar h;
  generate
    for (h = 2; h <= 6; h = h + 1) begin : g_access
      wire write = host_write_q[h];
      wire bits = host_q[h] && host_space_q[h] == 3'd2;
      wire words = host_q[h] && host_space_q[h] == 3'd3;
      wire [BIT_ADDR-1:0] bit_device = host_addr_q[h][BIT_ADDR-1:0];
      wire [WORD_ADDR-1:0] word_device = host_addr_q[h][WORD_ADDR-1:0];
      wire [BITS-1:0] data = host_data_q[h];
      always @* begin
        if (known) begin
          assert (peek_accesses[h-2] == host_q[h]);
          assert (peek_reads[h-2] == ((bits || words) && !write));
          if (peek_reads[h-2]) assert (peek_word_reads[h-2] == words);
        end
      end
      if (h < 6) begin : g_step
        wire [SLOTS*SLOT_BITS-1:0] all = h == 2 ? peek_step : step_q[h-2];
        wire other = h == 2 ? peek_valid : valid_q[h-2];
        wire [SLOT_BITS-1:0] step = all[SLOT_BITS-1:0];
        wire [5:0] op = step[SLOT_BITS-1-:6];
        wire [BIT_ADDR-1:0] dest = step[DEST_AT+:BIT_ADDR];
        wire [BIT_ADDR-1:0] a = LOOKUP != 0 ? step[0+:BIT_ADDR] : dest;
        always @* begin
          if (known && !other) begin
            assert (all >> SLOT_BITS == {SLOTS * SLOT_BITS{1'b0}});
            if (!bits && !words) assert (step == {SLOT_BITS{1'b0}});
            if (bits && write) begin
              assert (op == (data[0] ? `RUNG_OP_SET : `RUNG_OP_RST) && step[TAIL_AT]);
              assert (dest == bit_device);
            end
            if (bits && !write) begin
              assert (op == `RUNG_OP_NOP && a == bit_device);
              if (LOOKUP != 0) assert (!step[BIT_ADDR]);
            end
            if (words) assert (step[TAIL_AT+1+:2] == 2'd1);
            if (words && write) begin
              assert (op == `RUNG_OP_MV && step[TAIL_AT] && step[BITS-1:0] == data);
              assert (step[DEST_AT+:WORD_ADDR] == word_device);
            end
            if (words && !write) begin
              assert (op == `RUNG_OP_NOP && step[BITS+:WORD_ADDR] == word_device);
            end
          end
        end
      end
    end
  endgenerate

  // ---- host reads, words that go out, error ----------------------------------------------------
  reg [15:0] host_read_q;
  reg [SLOTS-1:0] written_q[1:2];
  reg [SLOTS*WORD_ADDR-1:0] written_addr_q[1:2];
  reg [SLOTS*BITS-1:0] written_data_q[1:2];
  reg error_q;
  always @(posedge clk_i) begin
    host_read_q <= host_bit ? {15'd0, bits_q[host_addr_q[5][BIT_ADDR-1:0]]} :
        words_q[host_addr_q[5][WORD_ADDR-1:0]*BITS+:BITS];
    written_q[1] <= word_we & {SLOTS{valid}};
    written_addr_q[1] <= word_addr;
    written_data_q[1] <= word_value;
    written_q[2] <= written_q[1];
    written_addr_q[2] <= written_addr_q[1];
    written_data_q[2] <= written_data_q[1];
    error_q <= (error_q || |peek_by_0) && !scan_start && !reset;
  end
  integer o;
  always @* begin
    assert (age_q <= 3'd6 && copies_alike);
    if (age_q != 3'd0 && !known) begin
      assert (!busy && !peek_valid && !peek_waits && !peek_waiting && peek_fetch[3:0] == 4'd0);
      assert (peek_step == {SLOTS * SLOT_BITS{1'b0}} && !peek_access[40]);
      assert (!in_ex && !host_q[1] && !host_q[2] && !host_q[3] && !host_q[4] && !host_q[5] && !host_q[6]);
    end
    if (known) begin
      assert (held_bits == bits_before_q && held_words == words_before_q);
      assert (coming_bits == bits_q && coming_words == words_q);
      assert (load_rvalid == (host_q[6] && !host_write_q[6] && (host_space_q[6] == 3'd2 || host_space_q[6] == 3'd3)));
      if (load_rvalid) assert (load_rdata == host_read_q);
      assert (write_valid == written_q[2]);
      assert (error == (error_q || |peek_by_0));
    end
    for (o = 0; o < SLOTS; o = o + 1) begin
      if (known && written_q[2][o]) begin
        assert (write_addr[o*16+:16] == {{16 - WORD_ADDR{1'b0}}, written_addr_q[2][o*WORD_ADDR+:WORD_ADDR]});
        assert (write_data[o*16+:16] == written_data_q[2][o*BITS+:BITS]);
      end
    end
  end

  always @* begin
    if (known && valid) begin
      cover (&bit_we && bits_q != {BIT_DEVICES{1'b0}});
      cover (&word_we && word_value[BITS-1:0] == 16'h4321);
    end
    if (known) cover (load_rvalid && load_rdata == 16'h1234);
  end

endmodule

`default_nettype wire

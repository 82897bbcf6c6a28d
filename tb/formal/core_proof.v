// SPDX-License-Identifier: Apache-2.0
// MPU1, MPU2, MPU3 (hdl/core/core.v) over the retire port: whatever steps come, and whatever the host does
// between scans, each instruction does what model/slot_model.v says with the devices as all steps before it
// have left them, in the clock in which it retires, and nothing else writes. The model has no pipeline, so
// that this is forwarding at every distance and from either slot, N0, gating, write order, indexed access
// and the load port in one. Program memory, ALU and multiply-divide unit are free (free/); they have proofs
// of their own. What is asserted beside that of the stages (core/) is what induction needs.
`default_nettype none
`include "rung_isa.vh"

module core_proof #(
    parameter LOOKUP = 1,
    parameter SLOTS = 1,
    parameter FREE_ALU = 0,  // 1: with free/alu.v
    parameter USED_BITS = 16,  // of what is written to words; those above are 0
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
    input wire [SLOTS-1:0] peek_x_bit_bank,
    input wire [SLOTS*BITS-1:0] peek_x_word_bank,
    // the unit: what it is asked in EX, its answer in ID3
    input wire [SLOTS-1:0] peek_start,
    input wire [SLOTS-1:0] peek_run,
    input wire [SLOTS-1:0] peek_div,
    input wire [SLOTS-1:0] peek_wide,
    input wire [SLOTS-1:0] peek_ldh,
    input wire [SLOTS*BITS-1:0] peek_s1,
    input wire [SLOTS*BITS-1:0] peek_s2,
    // the ALU: the instruction in ID2, acc in EX, its results
    input wire [SLOTS*6-1:0] peek_bit_op,  // the same on the bit side
    input wire [SLOTS*6-1:0] peek_alu_op,
    input wire [SLOTS*BITS-1:0] peek_alu_acc,
    input wire [SLOTS*BITS-1:0] peek_alu_result,
    input wire [SLOTS*BITS-1:0] peek_alu_sum,
    input wire [SLOTS-1:0] peek_alu_test,
    input wire [SLOTS-1:0] peek_alu_scan_start,
    input wire [SLOTS-1:0] peek_unit_scan_start,
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
  wire [1:0] since = peek_fetch[5:4];


  // ---- from ID1 to EX: steps three clocks back, what the LUT gave two, and the unit one ---------
  reg [3*SLOTS*SLOT_BITS-1:0] steps_q;  // in ID2 (lowest), ID3, EX
  reg [2:0] valid_q, first_q, last_q;
  reg [15:0] number_q[1:3];
  reg [SLOTS*8-1:0] row_q[1:2];
  reg [SLOTS*2-1:0] unit_index_q;
  reg [SLOTS*BITS-1:0] unit_word_q;
  reg [SLOTS-1:0] unit_valid_q;
  always @(posedge clk_i) begin
    steps_q <= {steps_q[2*SLOTS*SLOT_BITS-1:0], peek_step};
    valid_q <= {valid_q[1:0], peek_valid} & {3{!reset}};
    first_q <= {first_q[1:0], peek_first};
    last_q <= {last_q[1:0], peek_last};
    number_q[1] <= peek_number;
    number_q[2] <= number_q[1];
    number_q[3] <= number_q[2];
    row_q[1] <= peek_row;
    row_q[2] <= row_q[1];
    {unit_index_q, unit_word_q, unit_valid_q} <= {peek_unit_index, peek_unit_word, peek_unit_valid};
  end
  wire valid = valid_q[2];
  wire [SLOTS*8-1:0] rows = row_q[2];

  reg [BIT_DEVICES-1:0] bits_q;  // the devices before the step in EX
  reg [WORD_DEVICES*BITS-1:0] words_q;

  // ---- the host --------------------------------------------------------------------------------
  wire host_bit_we, host_word_we;
  wire [19:0] host_addr;
  wire [15:0] host_data;
  wire [6:1] host_access;
  host_way #(
      .LOOKUP(LOOKUP),
      .SLOTS(SLOTS),
      .BIT_ADDR(BIT_ADDR),
      .WORD_ADDR(WORD_ADDR),
      .BITS(BITS),
      .TAIL_AT(BITS + WORD_ADDR + (OPERAND > WORD_ADDR ? OPERAND : WORD_ADDR)),
      .SLOT_BITS(SLOT_BITS)
  ) host (
      .clk_i(clk_i),
      .reset_i(reset),
      .known_i(known),
      .busy_i(busy),
      .load_valid_i(load_valid),
      .load_write_i(load_write_i),
      .load_space_i(load_space_i),
      .load_addr_i(load_addr_i),
      .load_data_i(load_data_i),
      .load_rvalid_i(load_rvalid),
      .load_rdata_i(load_rdata),
      .peek_access_i(peek_access),
      .peek_accesses_i(peek_accesses),
      .peek_reads_i(peek_reads),
      .peek_word_reads_i(peek_word_reads),
      .steps_i({steps_q, peek_step}),
      .valid_i({valid_q, peek_valid}),
      .since_i(since),
      .x_bit_i(retire_bit_data[0]),
      .x_word_i(retire_word_data[15:0]),
      .bits_i(bits_q),
      .words_i(words_q),
      .bit_we_o(host_bit_we),
      .word_we_o(host_word_we),
      .addr_o(host_addr),
      .data_o(host_data),
      .access_o(host_access)
  );

  // ---- the memories ----------------------------------------------------------------------------
  localparam WORD_BANK = WORD_DEVICES * BITS;
  wire bits_alike, words_alike;
  wire [SLOTS*BIT_DEVICES-1:0] bit_banks, other_bits;
  wire [SLOTS*WORD_BANK-1:0] word_banks, other_words;
  wire [BIT_DEVICES-1:0] held_bits, coming_bits;
  wire [WORD_BANK-1:0] held_words, coming_words;
  banks #(
      .SLOTS(SLOTS),
      .COPIES(SLOTS * READS),
      .WIDTH(1),
      .ADDR_BITS(BIT_ADDR)
  ) bit_memory (
      .memory_i(peek_bits),
      .we_i(peek_w_bit_we),
      .dest_i(peek_bit_dest[3*SLOTS*BIT_ADDR+:SLOTS*BIT_ADDR]),
      .data_i(peek_bit_bank[SLOTS+:SLOTS]),
      .alike_o(bits_alike),
      .banks_o(bit_banks),
      .held_o(held_bits),
      .coming_o(coming_bits),
      .others_o(other_bits)
  );
  banks #(
      .SLOTS(SLOTS),
      .COPIES(3 * SLOTS - 1),
      .WIDTH(BITS),
      .ADDR_BITS(WORD_ADDR)
  ) word_memory (
      .memory_i(peek_words),
      .we_i(peek_w_word_we),
      .dest_i(peek_word_dest[3*SLOTS*WORD_ADDR+:SLOTS*WORD_ADDR]),
      .data_i(peek_word_bank[SLOTS*BITS+:SLOTS*BITS]),
      .alike_o(words_alike),
      .banks_o(word_banks),
      .held_o(held_words),
      .coming_o(coming_words),
      .others_o(other_words)
  );

  // ---- the slots -------------------------------------------------------------------------------
  wire [SLOTS-1:0] bit_we, bit_value, word_we;
  wire [SLOTS*BIT_ADDR-1:0] bit_addr;
  wire [SLOTS*WORD_ADDR-1:0] word_addr;
  wire [SLOTS*BITS-1:0] word_value;
  wire [SLOTS*2-1:0] bit_we_before, word_we_before;
  wire [SLOTS*2*BIT_ADDR-1:0] bit_dest_before;
  wire [SLOTS*2*WORD_ADDR-1:0] word_dest_before;
  genvar s, g;
  generate
    for (s = 0; s < SLOTS; s = s + 1) begin : g_slot
      wire [3*SLOT_BITS-1:0] steps;
      wire [4*BIT_ADDR-1:0] bit_dest;
      wire [4*WORD_ADDR-1:0] word_dest;
      for (g = 0; g < 4; g = g + 1) begin : g_stage
        if (g < 3) begin : g_step
          assign steps[g*SLOT_BITS+:SLOT_BITS] = steps_q[(g*SLOTS+s)*SLOT_BITS+:SLOT_BITS];
        end
        assign bit_dest[g*BIT_ADDR+:BIT_ADDR] = peek_bit_dest[(g*SLOTS+s)*BIT_ADDR+:BIT_ADDR];
        assign word_dest[g*WORD_ADDR+:WORD_ADDR] = peek_word_dest[(g*SLOTS+s)*WORD_ADDR+:WORD_ADDR];
      end
      wire [2*BITS-1:0] word_values = {
        peek_word_value[(SLOTS+s)*BITS+:BITS], peek_word_value[s*BITS+:BITS]
      };
      wire [1:0] bit_values = {peek_bit_value[SLOTS+s], peek_bit_value[s]};
      wire [1:0] scan_starts = {peek_alu_scan_start[s], peek_unit_scan_start[s]};
      wire [15:0] number = number_q[3];
      slot_way #(
          .LOOKUP(LOOKUP),
          .FREE_ALU(FREE_ALU),
          .BIT_ADDR(BIT_ADDR),
          .WORD_ADDR(WORD_ADDR),
          .IX_BITS(IX_BITS),
          .BITS(BITS),
          .SLOT_BITS(SLOT_BITS)
      ) slot (
          .clk_i(clk_i),
          .quiet_i(age_q >= 3'd2 && !known),
          .known_i(known),
          .scan_start_i(scan_start),
          .d1_step_i(peek_step[s*SLOT_BITS+:SLOT_BITS]),
          .d1_valid_i(peek_valid),
          .d1_first_i(peek_first),
          .steps_i(steps),
          .valid_i(valid_q),
          .first_i(first_q),
          .last_i(last_q[2]),
          .number_i(number),
          .row_i(rows[s*8+:8]),
          .bits_i(bits_q),
          .words_i(words_q),
          .host_bit_we_i(s == 0 && host_bit_we),
          .host_word_we_i(s == 0 && host_word_we),
          .host_data_i(host_data),
          .unit_index_i(unit_index_q[s*2+:2]),
          .unit_word_i(unit_word_q[s*BITS+:BITS]),
          .unit_valid_i(unit_valid_q[s]),
          .bit_bank_i(bit_banks[s*BIT_DEVICES+:BIT_DEVICES]),
          .word_bank_i(word_banks[s*WORD_BANK+:WORD_BANK]),
          .other_bits_i(other_bits[s*BIT_DEVICES+:BIT_DEVICES]),
          .other_words_i(other_words[s*WORD_BANK+:WORD_BANK]),
          .peek_exc_i(peek_exc[s]),
          .peek_block_i(peek_block[s*`RUNG_BLOCK_STACK+:`RUNG_BLOCK_STACK]),
          .peek_branch_i(peek_branch[s*`RUNG_BRANCH_STACK+:`RUNG_BRANCH_STACK]),
          .peek_acc_i(peek_acc[s*BITS+:BITS]),
          .peek_carry_i(peek_carry[s]),
          .peek_ix_i(peek_ix[s*IX_BITS+:IX_BITS]),
          .peek_ix_source_i(peek_ix_source[s]),
          .peek_ix_dest_i(peek_ix_dest[s]),
          .peek_bit_we_i(peek_bit_we[s]),
          .peek_word_we_i(peek_word_we[s]),
          .peek_x_bit_bank_i(peek_x_bit_bank[s]),
          .peek_x_word_bank_i(peek_x_word_bank[s*BITS+:BITS]),
          .peek_start_i(peek_start[s]),
          .peek_run_i(peek_run[s]),
          .peek_div_i(peek_div[s]),
          .peek_wide_i(peek_wide[s]),
          .peek_ldh_i(peek_ldh[s]),
          .peek_s1_i(peek_s1[s*BITS+:BITS]),
          .peek_s2_i(peek_s2[s*BITS+:BITS]),
          .peek_bit_op_i(peek_bit_op[s*6+:6]),
          .peek_alu_op_i(peek_alu_op[s*6+:6]),
          .peek_alu_acc_i(peek_alu_acc[s*BITS+:BITS]),
          .peek_alu_result_i(peek_alu_result[s*BITS+:BITS]),
          .peek_alu_sum_i(peek_alu_sum[s*BITS+:BITS]),
          .peek_alu_test_i(peek_alu_test[s]),
          .peek_scan_start_i(scan_starts),
          .peek_bit_dest_i(bit_dest),
          .peek_word_dest_i(word_dest),
          .peek_w_bit_we_i(peek_w_bit_we[s]),
          .peek_w_word_we_i(peek_w_word_we[s]),
          .peek_bit_value_i(bit_values),
          .peek_word_value_i(word_values),
          .peek_v_bit_bank_i(peek_bit_bank[s]),
          .peek_v_word_bank_i(peek_word_bank[s*BITS+:BITS]),
          .retire_valid_i(retire_valid[s]),
          .retire_step_i(retire_step[s*16+:16]),
          .retire_exc_i(retire_exc[s]),
          .retire_bit_we_i(retire_bit_we[s]),
          .retire_bit_addr_i(retire_bit_addr[s*16+:16]),
          .retire_bit_data_i(retire_bit_data[s]),
          .retire_word_we_i(retire_word_we[s]),
          .retire_word_addr_i(retire_word_addr[s*16+:16]),
          .retire_word_data_i(retire_word_data[s*16+:16]),
          .bit_we_o(bit_we[s]),
          .bit_addr_o(bit_addr[s*BIT_ADDR+:BIT_ADDR]),
          .bit_value_o(bit_value[s]),
          .word_we_o(word_we[s]),
          .word_addr_o(word_addr[s*WORD_ADDR+:WORD_ADDR]),
          .word_value_o(word_value[s*BITS+:BITS]),
          .bit_we_before_o(bit_we_before[s*2+:2]),
          .bit_dest_before_o(bit_dest_before[s*2*BIT_ADDR+:2*BIT_ADDR]),
          .word_we_before_o(word_we_before[s*2+:2]),
          .word_dest_before_o(word_dest_before[s*2*WORD_ADDR+:2*WORD_ADDR])
      );
    end

    // The slots of a step do not write one device: the compiler sees to it.
    if (SLOTS > 1) begin : g_apart
      always @* begin
        if (&bit_we) assume (bit_addr[0+:BIT_ADDR] != bit_addr[BIT_ADDR+:BIT_ADDR]);
        if (&word_we) assume (word_addr[0+:WORD_ADDR] != word_addr[WORD_ADDR+:WORD_ADDR]);
      end
      for (g = 0; g < 2; g = g + 1) begin : g_before
        always @* begin
          if (known && bit_we_before[g] && bit_we_before[2+g])
            assert (bit_dest_before[g*BIT_ADDR+:BIT_ADDR] !=
                    bit_dest_before[(2+g)*BIT_ADDR+:BIT_ADDR]);
          if (known && word_we_before[g] && word_we_before[2+g])
            assert (word_dest_before[g*WORD_ADDR+:WORD_ADDR] !=
                    word_dest_before[(2+g)*WORD_ADDR+:WORD_ADDR]);
        end
      end
    end
  endgenerate

  // Fewer bits of words, all of which are alike to everything but the ALU, make it easier for the solver.
  generate
    if (USED_BITS < BITS) begin : g_narrow
      localparam ABOVE = BITS - USED_BITS;
      always @* if (host_word_we) assume (host_data[BITS-1-:ABOVE] == {ABOVE{1'b0}});
      for (s = 0; s < SLOTS; s = s + 1) begin : g_written
        always @* begin
          if (word_we[s]) assume (word_value[(s+1)*BITS-1-:ABOVE] == {ABOVE{1'b0}});
        end
        for (g = 0; g < WORD_DEVICES; g = g + 1) begin : g_device
          always @* begin
            // Before the reset is through, anything may be written.
            if (!known) assume (word_banks[s*WORD_BANK+(g+1)*BITS-1-:ABOVE] == {ABOVE{1'b0}});
            if (known) assert (word_banks[s*WORD_BANK+(g+1)*BITS-1-:ABOVE] == {ABOVE{1'b0}});
            if (known) assert (words_q[(g+1)*BITS-1-:ABOVE] == {ABOVE{1'b0}});
          end
        end
      end
    end
  endgenerate

  // ---- devices: a step's slots read before any of them writes ----------------------------------
  reg [BIT_DEVICES-1:0] bits_next, bits_before_q;
  reg [WORD_BANK-1:0] words_next, words_before_q;
  integer w;
  always @* begin
    bits_next  = bits_q;
    words_next = words_q;
    for (w = 0; w < SLOTS; w = w + 1) begin
      if (bit_we[w]) bits_next[bit_addr[w*BIT_ADDR+:BIT_ADDR]] = bit_value[w];
      if (word_we[w])
        words_next[word_addr[w*WORD_ADDR+:WORD_ADDR]*BITS+:BITS] = word_value[w*BITS+:BITS];
    end
    if (host_bit_we) bits_next[host_addr[BIT_ADDR-1:0]] = host_data[0];
    if (host_word_we) words_next[host_addr[WORD_ADDR-1:0]*BITS+:BITS] = host_data;
  end
  always @(posedge clk_i) begin
    {bits_q, words_q} <= {bits_next, words_next};
    {bits_before_q, words_before_q} <= {bits_q, words_q};  // the memories have it a clock later
    if (!known) begin
      {bits_q, words_q} <= {held_bits, held_words};
      {bits_before_q, words_before_q} <= {held_bits, held_words};
    end
  end

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
  wire ended = peek_fetch[3];
  wire some = peek_valid || valid_q != 3'b000;
  always @* begin
    assert (age_q <= 3'd6 && bits_alike && words_alike);
    if (age_q != 3'd0 && !known) begin
      assert (!busy && !some && !peek_waits && !peek_waiting && peek_fetch[3:0] == 4'd0);
      assert (peek_step == {SLOTS * SLOT_BITS{1'b0}} && !peek_access[40] && host_access == 6'd0);
    end
    if (age_q >= 3'd2 && !known) assert (!peek_accesses[0] && !peek_reads[0]);
    if (known) begin
      assert ({held_bits, held_words} == {bits_before_q, words_before_q});
      assert ({coming_bits, coming_words} == {bits_q, words_q});
      assert (peek_waits == waits && (!waits || peek_valid) && (!peek_waiting || waits));
      assert (!busy || ended == |peek_fetch[2:0]);
      if (!busy) assert (!some && peek_fetch[2:0] == 3'd0);
      if (busy && since != 2'd3) assert (!some && !ended);
      case (peek_fetch[2:0])
        3'b000: ;
        3'b100: assert (!peek_valid);
        3'b010: assert (!peek_valid && !valid_q[0]);
        3'b001: assert (!peek_valid && !valid_q[0] && !valid_q[1]);
        default: assert (1'b0);
      endcase
    end
  end

  // ---- words that go out, error ----------------------------------------------------------------
  reg [SLOTS-1:0] written_q[1:2];
  reg [SLOTS*WORD_ADDR-1:0] written_addr_q[1:2];
  reg [SLOTS*BITS-1:0] written_data_q[1:2];
  reg error_q;
  always @(posedge clk_i) begin
    written_q[1] <= word_we;
    written_addr_q[1] <= word_addr;
    written_data_q[1] <= word_value;
    written_q[2] <= written_q[1];
    written_addr_q[2] <= written_addr_q[1];
    written_data_q[2] <= written_data_q[1];
    error_q <= (error_q || |peek_by_0) && !scan_start && !reset;
  end
  integer o;
  always @* begin
    if (known) assert (write_valid == written_q[2] && error == (error_q || |peek_by_0));
    for (o = 0; o < SLOTS; o = o + 1) begin
      if (known && written_q[2][o]) begin
        assert (write_addr[o*16+:16] ==
                {{16 - WORD_ADDR{1'b0}}, written_addr_q[2][o*WORD_ADDR+:WORD_ADDR]});
        assert (write_data[o*16+:16] == written_data_q[2][o*BITS+:BITS]);
      end
    end
  end

  localparam [15:0] SAMPLE = USED_BITS < BITS ? 16'h0002 : 16'h4321;
  always @* begin
    cover (known && &bit_we && bits_q != {BIT_DEVICES{1'b0}});
    cover (known && &word_we && word_value[BITS-1:0] == SAMPLE);
    cover (known && load_rvalid && load_rdata == SAMPLE);
  end

endmodule

`default_nettype wire

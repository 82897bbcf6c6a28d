// SPDX-License-Identifier: Apache-2.0
// The micro-sequencer (hdl/controller/micro/micro_sequencer.v) with any firmware, beside a model that is written from the page's
// table (hdl/controller/micro/README.md): it executes an instruction at once, in three clocks and one more for each bit of a shift,
// and has the same pc, acc, x and test behind each, and the same word in RAM, any of them; the bus sees the access of each
// IN, INX, OUT and OUTX once, in the instruction's second clock, and no other. A RETURN goes behind the last CALL that has not
// returned, at any depth up to 16. A reset sets all of RAM to 0, a word a clock, before the first instruction, at 0.
`default_nettype none
`include "rung_controller.vh"

module micro_sequencer_proof (
    input wire        clk_i,
    input wire        rst_ni,
    input wire [15:0] mem_rdata_i
);

  localparam [15:0] WORDS = `RUNG_MICRO_RAM_WORDS;
  localparam [15:0] RETURNS = WORDS - 16'd16;  // from here on: where calls come back to

  wire [15:0] mem_addr, mem_wdata;
  wire mem_read, mem_write;
  micro_sequencer sequencer (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni),
      .mem_addr_o (mem_addr),
      .mem_read_o (mem_read),
      .mem_write_o(mem_write),
      .mem_wdata_o(mem_wdata),
      .mem_rdata_i(mem_rdata_i)
  );

  (* hierconn *) wire [2:0] \sequencer.state_q ;
  (* hierconn *) wire [11:0] \sequencer.pc_q ;
  (* hierconn *) wire [15:0] \sequencer.acc_q ;
  (* hierconn *) wire [15:0] \sequencer.x_q ;
  (* hierconn *) wire \sequencer.test_q ;
  (* hierconn *) wire \sequencer.tested_q ;
  (* hierconn *) wire [3:0] \sequencer.shifts_q ;
  (* hierconn *) wire [8:0] \sequencer.clear_q ;
  (* hierconn *) wire [3:0] \sequencer.depth_q ;
  (* hierconn *) wire [15:0] \sequencer.instruction ;
  (* hierconn *) wire \sequencer.program_rom.read_i ;
  (* hierconn *) wire [11:0] \sequencer.program_rom.addr_i ;
  (* hierconn *) wire [8:0] \sequencer.ram.watched ;
  (* hierconn *) wire [15:0] \sequencer.ram.word_q ;
  (* hierconn *) wire [15:0] \sequencer.ram.read_data_q ;

  reg begun_q;
`ifndef RUNG_NARROW
  initial begun_q = 1'b0;
  always @* if (!begun_q) assume (!rst_ni);
`endif
  always @(posedge clk_i) begun_q <= 1'b1;

  // ---- the model's state -----------------------------------------------------------------------------
  reg clears_q;  // RAM
  reg [15:0] cleared_q;  // words
  reg [4:0] clock_q;  // of the instruction
  reg [15:0] word_q;  // the instruction
  reg [11:0] pc_q;
  reg [15:0] acc_q;
  reg [15:0] x_q;
  reg test_q;
  reg by_test_q;  // jumps go by it
  reg [4:0] depth_q;  // calls that have not returned

  // Any word of RAM: one of the program's, or one that a call comes back to, of a depth.
  wire [15:0] place = {7'd0, \sequencer.ram.watched };
  wire of_program = place < RETURNS;
  wire [15:0] level = place - RETURNS;
  reg [15:0] ram_q;
  reg [11:0] back_q;  // from the call that has not returned at this depth
  reg back_known_q;  // the program has not written over it

  // ---- one instruction ---------------------------------------------------------------------------------
  wire [15:0] word = clock_q == 5'd1 ? \sequencer.instruction : word_q;
  wire [4:0] opcode = word[15:11];
  wire second = word[10];
  wire [15:0] n = {5'd0, word[10:0]};
  wire [15:0] half_n = {6'd0, word[9:0]};
  wire jump = word[15:14] == 2'd3;
  wire loads = opcode == 5'd9 && !second;
  wire indexed = opcode == 5'd9;
  wire [15:0] at = indexed ? half_n + (second ? x_q : acc_q) : opcode <= 5'd8 ? n : half_n;
  wire uses_ram = opcode <= 5'd9 || opcode == 5'd20 || opcode == 5'd22;
  wire calls = jump && word[13:12] == 2'd3;
  wire returns = word == 16'hb802;
  wire conditional = jump && (word[13:12] == 2'd1 || word[13:12] == 2'd2);
  // The table's words: RAM has the place, calls are 16 deep at most.
  wire legal = (jump || opcode != 5'd23 || word <= 16'hb805) && (!uses_ram || at < WORDS) &&
      !(calls && depth_q == 5'd16) && !(returns && depth_q == 5'd0);

  // What RAM has at a place: the model knows one.
  wire here = at == place && of_program;
  wire [15:0] ram = here ? ram_q : \sequencer.ram.read_data_q ;
  wire [4:0] depth_less = depth_q - 5'd1;
  wire [11:0] back = back_known_q && !of_program && {11'd0, depth_less} == level ? back_q :
      \sequencer.ram.read_data_q [11:0];
  wire shift = opcode == 5'd19;
  wire [4:0] last_clock = 5'd2 + (shift ? {1'b0, word[3:0]} : 5'd0);
  wire ends = !clears_q && clock_q == last_clock;

  reg [11:0] next_pc;
  reg [15:0] acc, x;
  reg test, compares, writes;
  reg [15:0] written;
  reg bus_read, bus_write;
  reg [15:0] bus_addr;
  wire condition = by_test_q ? test_q : acc_q != 16'd0;
  always @* begin
    next_pc = pc_q + 12'd1;
    acc = acc_q;
    x = x_q;
    test = test_q;
    {compares, writes, bus_read, bus_write} = 4'd0;
    written = acc_q;
    bus_addr = half_n;
    if (jump) begin
      case (word[13:12])
        2'd1: if (!condition) next_pc = word[11:0];  // JZ
        2'd2: if (condition) next_pc = word[11:0];  // JNZ
        default: next_pc = word[11:0];  // JUMP, CALL
      endcase
    end else begin
      case (opcode)
        5'd0: acc = ram;  // LOAD
        5'd1: writes = 1'b1;  // STORE
        5'd2: acc = acc_q + ram;  // ADD
        5'd3: acc = acc_q - ram;  // SUB
        5'd4: acc = acc_q & ram;  // AND
        5'd5: acc = acc_q | ram;  // OR
        5'd6: acc = acc_q ^ ram;  // XOR
        5'd7: {compares, test} = {1'b1, acc_q == ram};  // EQ
        5'd8: {compares, test} = {1'b1, acc_q < ram};  // LTU
        5'd9: begin  // LOADX, STOREX
          if (second) writes = 1'b1;
          else acc = ram;
        end
        5'd10: acc = n;  // LOADI
        5'd11: acc = acc_q + n;  // ADDI
        5'd12: acc = acc_q - n;  // SUBI
        5'd13: acc = acc_q & n;  // ANDI
        5'd14: acc = acc_q | n;  // ORI
        5'd15: acc = acc_q ^ n;  // XORI
        5'd16: {compares, test} = {1'b1, acc_q == n};  // EQI
        5'd17: {compares, test} = {1'b1, acc_q < n};  // LTUI
        5'd18: acc = acc_q | {n[4:0], 11'd0};  // ORH
        5'd19: acc = n[4] ? acc_q >> n[3:0] : acc_q << n[3:0];  // SHIFT
        5'd20: begin  // INDEX, CLEAR
          if (second) {writes, written} = {1'b1, 16'd0};
          else x = ram;
        end
        5'd21: begin  // IN, OUT
          if (second) bus_write = 1'b1;
          else {bus_read, acc} = {1'b1, mem_rdata_i};
        end
        5'd22: begin  // INC, DEC
          acc = second ? ram - 16'd1 : ram + 16'd1;
          {writes, written} = {1'b1, acc};
        end
        default: begin
          case (word)
            16'hb800: x = acc_q;  // SETX
            16'hb801: acc = ~acc_q;  // NOT
            16'hb802: next_pc = back;  // RETURN
            16'hb803: {bus_read, bus_addr, acc} = {1'b1, acc_q, mem_rdata_i};  // INX
            16'hb804: {bus_write, bus_addr} = {1'b1, x_q};  // OUTX
            16'hb805: acc = {15'd0, test_q};  // TEST
            default: ;
          endcase
        end
      endcase
    end
  end

  always @* if (!clears_q && clock_q != 5'd0) assume (legal);

  always @(posedge clk_i) begin
    if (clock_q == 5'd1) word_q <= \sequencer.instruction ;
    if (!rst_ni) begin
      clears_q  <= 1'b1;
      cleared_q <= 16'd0;
    end else if (clears_q) begin
      cleared_q <= cleared_q + 16'd1;
      // What a reset leaves: pc 0, no calls; acc, x and test are anything.
      {pc_q, clock_q, depth_q, by_test_q, back_known_q} <= 24'd0;
      {acc_q, x_q, test_q} <= {\sequencer.acc_q , \sequencer.x_q , \sequencer.test_q };
      ram_q <= 16'd0;
      clears_q <= cleared_q != WORDS - 16'd1;
    end else begin
      clock_q <= ends ? 5'd0 : clock_q + 5'd1;
      if (ends) begin
        {pc_q, acc_q, x_q, test_q} <= {next_pc, acc, x, test};
        by_test_q <= compares || (by_test_q && ((jump && !conditional) || returns));
        depth_q <= depth_q + {4'd0, calls} - {4'd0, returns};
        if (writes && at == place) begin
          ram_q <= written;
          back_known_q <= 1'b0;
        end
        if (calls && !of_program && {11'd0, depth_q} == level) begin
          {back_known_q, back_q} <= {1'b1, pc_q + 12'd1};
        end
        if (returns && {11'd0, depth_less} == level) back_known_q <= 1'b0;
      end
    end
  end

  // ---- what the bus and the ROM see, in every clock -----------------------------------------------------
  wire second_clock = !clears_q && clock_q == 5'd1;
  always @* begin
    if (begun_q) begin
      assert (mem_read == (second_clock && bus_read));
      assert (mem_write == (second_clock && bus_write));
      if (mem_read || mem_write) assert (mem_addr == bus_addr);
      if (mem_write) assert (mem_wdata == acc_q);
      assert (\sequencer.program_rom.read_i == (!clears_q && clock_q == 5'd0));
      if (\sequencer.program_rom.read_i ) assert (\sequencer.program_rom.addr_i == pc_q);
    end
  end

  // ---- behind each instruction, and in its other clocks -----------------------------------------------------
  wire shifts = clock_q >= 5'd3;
  wire [4:0] shifted = clock_q - 5'd3;
  // STORE, STOREX and CLEAR write in the second clock.
  wire wrote = clock_q >= 5'd2 && !jump && writes && opcode != 5'd22 && at == place;
  always @* begin
    if (begun_q && clears_q) begin
      assert (\sequencer.state_q == 3'd0 && {7'd0, \sequencer.clear_q } == cleared_q);
      assert (cleared_q < WORDS);
      if (place < cleared_q) assert (\sequencer.ram.word_q == 16'd0);
      assert (\sequencer.pc_q == 12'd0 && \sequencer.depth_q == 4'd0 && !\sequencer.tested_q );
    end
    if (begun_q && !clears_q) begin
      assert (\sequencer.acc_q == (!shifts ? acc_q : n[4] ? acc_q >> shifted : acc_q << shifted));
      assert (\sequencer.x_q == x_q && \sequencer.test_q == test_q);
      assert (\sequencer.pc_q == (shifts ? pc_q + 12'd1 : pc_q));
      assert (\sequencer.tested_q == (by_test_q && !shifts));
      assert (\sequencer.depth_q == depth_q[3:0] && depth_q <= 5'd16);
      if (of_program) assert (\sequencer.ram.word_q == (wrote ? written : ram_q));
      if (back_known_q) begin
        assert (!of_program && {11'd0, depth_q} > level);
        if (!wrote) assert (\sequencer.ram.word_q [11:0] == back_q);
      end
      if (clock_q != 5'd0) assert (clock_q <= last_clock);
      if (clock_q >= 5'd2) assert (\sequencer.instruction == word_q);
      case (clock_q)
        5'd0: assert (\sequencer.state_q == 3'd1);
        5'd1: assert (\sequencer.state_q == 3'd2);
        5'd2: begin
          assert (\sequencer.state_q == (bus_read ? 3'd4 : 3'd3));
          if (uses_ram && !jump && here && !wrote) assert (\sequencer.ram.read_data_q == ram_q);
          if (returns && back_known_q && {11'd0, depth_less} == level) begin
            assert (\sequencer.ram.read_data_q [11:0] == back_q);
          end
        end
        default: begin
          assert (\sequencer.state_q == 3'd5 && shift);
          assert ({1'b0, \sequencer.shifts_q } == {1'b0, word[3:0]} - shifted);
        end
      endcase
    end
  end

`ifdef RUNG_NARROW
  // One run, from an instruction's first clock on: RAM takes 512 clocks to be cleared.
  initial begun_q = 1'b1;
  initial {clears_q, pc_q, clock_q, depth_q, by_test_q, back_known_q, ram_q} = 41'd0;
  reg narrow_q;
  initial narrow_q = 1'b0;
  always @(posedge clk_i) narrow_q <= 1'b1;
  always @* begin
    assume (rst_ni);
    if (!narrow_q) begin
      assume (\sequencer.state_q == 3'd1 && \sequencer.pc_q == 12'd0);
      assume (\sequencer.depth_q == 4'd0 && !\sequencer.tested_q );
      assume (\sequencer.ram.word_q == ram_q);
      assume ({acc_q, x_q, test_q} == {\sequencer.acc_q , \sequencer.x_q , \sequencer.test_q });
    end
  end
`endif

  // A call and its return; a value that has gone through RAM to the bus; a right shift by 3; a jump by a test behind a jump.
  reg shifted_q;
  initial shifted_q = 1'b0;
  always @(posedge clk_i) shifted_q <= ends && shift && word[4:0] == 5'b10011 && !jump;
  always @* begin
    cover (begun_q && ends && returns && back_known_q && {11'd0, depth_less} == level);
    cover (begun_q && mem_write && acc_q == 16'h1234 && ram_q == 16'h1234 && of_program);
    cover (begun_q && shifted_q && acc_q == 16'h0123);
    cover (begun_q && ends && conditional && by_test_q && acc_q != 16'd0 && pc_q > 12'd7);
  end

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// For core_proof.v: a host access, from the load port to slot 0's EX, where it reads or writes its device
// behind all that was accepted before, and to the answer in the sixth clock.
`default_nettype none
`include "rung_isa.vh"

module host_way #(
    parameter LOOKUP = 1,
    parameter SLOTS = 1,
    parameter BIT_ADDR = 2,
    parameter WORD_ADDR = 2,
    parameter BITS = 16,
    parameter TAIL_AT = 21,
    parameter SLOT_BITS = 31
) (
    input wire clk_i,
    input wire reset_i,
    input wire known_i,
    input wire busy_i,
    // the port
    input wire load_valid_i,
    input wire load_write_i,
    input wire [2:0] load_space_i,
    input wire [19:0] load_addr_i,
    input wire [15:0] load_data_i,
    input wire load_rvalid_i,
    input wire [15:0] load_rdata_i,
    // inside the hardware, as in core_proof.v; steps from ID1 (lowest) to EX, of the program if valid
    input wire [40:0] peek_access_i,
    input wire [4:0] peek_accesses_i,
    input wire [4:0] peek_reads_i,
    input wire [4:0] peek_word_reads_i,
    input wire [4*SLOTS*SLOT_BITS-1:0] steps_i,
    input wire [3:0] valid_i,
    input wire [1:0] since_i,
    // devices in EX, and what slot 0 gives there
    input wire x_bit_i,
    input wire [15:0] x_word_i,
    input wire [(1<<BIT_ADDR)-1:0] bits_i,
    input wire [(BITS<<WORD_ADDR)-1:0] words_i,
    // the write in EX; an access in IF3 (lowest) to behind EX
    output wire bit_we_o,
    output wire word_we_o,
    output wire [19:0] addr_o,
    output wire [15:0] data_o,
    output wire [6:1] access_o
);

  localparam DEST_AT = BITS + WORD_ADDR;

  // ---- accepted so many clocks ago: in IF3 after 1, in EX after 5 ------------------------------
  reg [6:1] access_q;
  reg [6:1] write_q;
  reg [2:0] space_q[1:6];
  reg [19:0] addr_q[1:6];
  reg [15:0] data_q[1:6];
  integer i;
  always @(posedge clk_i) begin
    access_q <= {access_q[5:1], load_valid_i && !busy_i} & {6{!reset_i}};
    write_q <= {write_q[5:1], load_write_i};
    space_q[1] <= load_space_i;
    addr_q[1] <= load_addr_i;
    data_q[1] <= load_data_i;
    for (i = 2; i <= 6; i = i + 1) begin
      space_q[i] <= space_q[i-1];
      addr_q[i]  <= addr_q[i-1];
      data_q[i]  <= data_q[i-1];
    end
  end
  assign access_o = access_q;
  assign bit_we_o = access_q[5] && write_q[5] && space_q[5] == 3'd2;
  assign word_we_o = access_q[5] && write_q[5] && space_q[5] == 3'd3;
  assign addr_o = addr_q[5];
  assign data_o = data_q[5];

  // ---- the answer ------------------------------------------------------------------------------
  reg [15:0] read_q;
  wire [BIT_ADDR-1:0] bit_read = addr_q[5][BIT_ADDR-1:0];
  wire [WORD_ADDR-1:0] word_read = addr_q[5][WORD_ADDR-1:0];
  wire reads_bit = space_q[5] == 3'd2;
  wire [15:0] read = reads_bit ? {15'd0, bits_i[bit_read]} : words_i[word_read*BITS+:BITS];
  always @(posedge clk_i) read_q <= read;
  wire answers = access_q[6] && !write_q[6] && (space_q[6] == 3'd2 || space_q[6] == 3'd3);
  always @* begin
    if (known_i) begin
      if (peek_reads_i[3]) assert (reads_bit ? x_bit_i == read[0] : x_word_i == read);
      assert (load_rvalid_i == answers);
      if (answers) assert (load_rdata_i == read_q);
      assert (peek_access_i[40] == access_q[1]);
      if (access_q[1])
        assert (peek_access_i[39:0] == {write_q[1], space_q[1], addr_q[1], data_q[1]});
      // never beside a step of the program
      if (busy_i && access_q[1]) assert (since_i == 2'd1);
      if (busy_i && access_q[2]) assert (since_i == 2'd1 || since_i == 2'd2);
      assert ((access_q[5:2] & valid_i) == 4'd0);
    end
  end

  // ---- on its way, as slot 0's instruction -----------------------------------------------------
  genvar h;
  generate
    for (h = 2; h <= 6; h = h + 1) begin : g_stage
      wire [2:0] space = space_q[h];
      wire [19:0] addr = addr_q[h];
      wire [15:0] data = data_q[h];
      wire write = write_q[h];
      wire bits = access_q[h] && space == 3'd2;
      wire words = access_q[h] && space == 3'd3;
      always @* begin
        if (known_i) begin
          assert (peek_accesses_i[h-2] == access_q[h]);
          assert (peek_reads_i[h-2] == ((bits || words) && !write));
          if (peek_reads_i[h-2]) assert (peek_word_reads_i[h-2] == words);
        end
      end
      if (h < 6) begin : g_step
        wire [SLOTS*SLOT_BITS-1:0] all = steps_i[(h-2)*SLOTS*SLOT_BITS+:SLOTS*SLOT_BITS];
        wire [SLOT_BITS-1:0] step = all[SLOT_BITS-1:0];
        wire [5:0] op = step[SLOT_BITS-1-:6];
        wire [BIT_ADDR-1:0] dest = step[DEST_AT+:BIT_ADDR];
        wire [BIT_ADDR-1:0] a = LOOKUP != 0 ? step[0+:BIT_ADDR] : dest;
        always @* begin
          if (known_i && !valid_i[h-2]) begin
            assert (all >> SLOT_BITS == {SLOTS * SLOT_BITS{1'b0}});
            if (!bits && !words) assert (step == {SLOT_BITS{1'b0}});
            if (bits && write) begin
              assert (op == (data[0] ? `RUNG_OP_SET : `RUNG_OP_RST) && step[TAIL_AT]);
              assert (dest == addr[BIT_ADDR-1:0]);
            end
            if (bits && !write) begin
              assert (op == `RUNG_OP_NOP && a == addr[BIT_ADDR-1:0]);
              if (LOOKUP != 0) assert (!step[BIT_ADDR]);
            end
            if (words) assert (step[TAIL_AT+1+:2] == 2'd1);
            if (words && write) begin
              assert (op == `RUNG_OP_MV && step[TAIL_AT] && step[BITS-1:0] == data);
              assert (step[DEST_AT+:WORD_ADDR] == addr[WORD_ADDR-1:0]);
            end
            if (words && !write) begin
              assert (op == `RUNG_OP_NOP && step[BITS+:WORD_ADDR] == addr[WORD_ADDR-1:0]);
            end
          end
        end
      end
    end
  endgenerate

endmodule

`default_nettype wire

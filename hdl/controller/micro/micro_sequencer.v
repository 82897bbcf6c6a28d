// SPDX-License-Identifier: Apache-2.0
// The micro-sequencer: a 16-bit accumulator machine that runs the controller's firmware from ROM (README.md: its
// instructions). Three clocks an instruction: F the ROM is addressed, D the instruction names a word of RAM
// or an address of the bus, E the result. A shift takes one more for each bit.
//
// After a reset all of RAM is set to 0, one word a clock, before the first instruction. Bus: mem_addr_o in the
// clock of mem_read_o or mem_write_o; mem_rdata_i is taken in the clock after mem_read_o.
`default_nettype none
`include "rung_controller.vh"

module micro_sequencer #(
    parameter integer CONFIG_ID = 1  // whose firmware: micro_rom.v
) (
    input  wire        clk_i,
    input  wire        rst_ni,
    output wire [15:0] mem_addr_o,
    output wire        mem_read_o,
    output wire        mem_write_o,
    output wire [15:0] mem_wdata_o,
    input  wire [15:0] mem_rdata_i
`ifdef RUNG_MICRO_TEST
    ,
    // a test's own program in the place of the firmware
    input  wire        test_write_i,
    input  wire [11:0] test_addr_i,
    input  wire [15:0] test_data_i
`endif
);

  localparam integer RAM_WORDS = `RUNG_MICRO_RAM_WORDS;
  localparam integer RAM_ADDR = $clog2(RAM_WORDS);

  // Opcodes: scripts/micro/isa.py.
  localparam [4:0] LOAD = 5'd0;
  localparam [4:0] STORE = 5'd1;
  localparam [4:0] ADD = 5'd2;
  localparam [4:0] SUB = 5'd3;
  localparam [4:0] AND = 5'd4;
  localparam [4:0] OR = 5'd5;
  localparam [4:0] XOR = 5'd6;
  localparam [4:0] EQ = 5'd7;
  localparam [4:0] LTU = 5'd8;
  localparam [4:0] LOADX = 5'd9;  // or STOREX
  localparam [4:0] LOADI = 5'd10;
  localparam [4:0] ADDI = 5'd11;
  localparam [4:0] SUBI = 5'd12;
  localparam [4:0] ANDI = 5'd13;
  localparam [4:0] ORI = 5'd14;
  localparam [4:0] XORI = 5'd15;
  localparam [4:0] EQI = 5'd16;
  localparam [4:0] LTUI = 5'd17;
  localparam [4:0] ORH = 5'd18;
  localparam [4:0] SHIFT = 5'd19;
  localparam [4:0] INDEX = 5'd20;  // or CLEAR
  localparam [4:0] IN = 5'd21;  // or OUT
  localparam [4:0] INC = 5'd22;  // or DEC
  localparam [4:0] MISC = 5'd23;
  localparam [2:0] SETX = 3'd0;
  localparam [2:0] NOT = 3'd1;
  localparam [2:0] RETURN = 3'd2;
  localparam [2:0] INX = 3'd3;
  localparam [2:0] OUTX = 3'd4;
  localparam [2:0] TEST = 3'd5;
  localparam [1:0] JUMP = 2'd0;
  localparam [1:0] JZ = 2'd1;  // 2 is JNZ
  localparam [1:0] CALL = 2'd3;

  localparam [2:0] CLEARS = 3'd0;
  localparam [2:0] FETCH = 3'd1;
  localparam [2:0] DECODE = 3'd2;
  localparam [2:0] EXECUTE = 3'd3;
  localparam [2:0] BUS = 3'd4;
  localparam [2:0] SHIFTS = 3'd5;

  reg [2:0] state_q;
  reg [11:0] pc_q;
  reg [15:0] acc_q;
  reg [15:0] x_q;
  reg test_q;
  reg tested_q;  // jumps go by test_q
  reg [3:0] shifts_q;
  reg [RAM_ADDR-1:0] clear_q;
  reg [3:0] depth_q;  // calls that have not returned, modulo 16

  // ---- F: the instruction ------------------------------------------------------------------------
  wire [15:0] instruction;
  micro_rom #(
      .CONFIG_ID(CONFIG_ID)
  ) program_rom (
      .clk_i (clk_i),
`ifdef RUNG_MICRO_TEST
      .test_write_i(test_write_i),
      .test_addr_i (test_addr_i),
      .test_data_i (test_data_i),
`endif
      .read_i(state_q == FETCH),
      .addr_i(pc_q),
      .data_o(instruction)
  );

  wire [4:0] opcode = instruction[15:11];
  wire [10:0] number = instruction[10:0];
  wire jumps = instruction[15:14] == 2'b11;
  wire [1:0] jump = instruction[13:12];
  wire misc = opcode == MISC && !jumps;

  wire returns = misc && number[2:0] == RETURN;
  wire calls = state_q == EXECUTE && jumps && jump == CALL;
  wire [11:0] next_pc = pc_q + 12'd1;

  // ---- D: RAM and bus ------------------------------------------------------------------------------
  // The last words of RAM are where calls come back to, a ring.
  wire [15:0] ram_data;
  wire [9:0] offset = opcode != LOADX ? 10'd0 : number[10] ? x_q[9:0] : acc_q[9:0];
  wire [9:0] ram_addr = number[9:0] + offset;
  wire clears = opcode == INDEX && number[10];
  wire store = state_q == DECODE && !jumps &&
      (opcode == STORE || clears || (opcode == LOADX && number[10]));

  bank_ram #(
      .WIDTH(16),
      .DEPTH(RAM_WORDS),
      .ADDR_BITS(RAM_ADDR)
  ) ram (
      .clk_i(clk_i),
      .read_i(state_q == DECODE),
      .read_addr_i(returns ? {{RAM_ADDR - 4{1'b1}}, depth_q - 4'd1} : ram_addr[RAM_ADDR-1:0]),
      .read_data_o(ram_data),
      .write_i(store || steps || calls || state_q == CLEARS),
      .write_addr_i(state_q == CLEARS ? clear_q : calls ? {{RAM_ADDR - 4{1'b1}}, depth_q} :
                    ram_addr[RAM_ADDR-1:0]),
      .write_data_i(state_q == CLEARS ? 16'd0 : calls ? {4'd0, next_pc} :
                    steps ? sum[15:0] : clears ? 16'd0 : acc_q)
  );
  wire unused_addr = &{1'b0, ram_addr};

  wire steps = state_q == EXECUTE && !jumps && opcode == INC;
  wire bus_read = !jumps && ((opcode == IN && !number[10]) || (misc && number[2:0] == INX));
  wire bus_write = !jumps && ((opcode == IN && number[10]) || (misc && number[2:0] == OUTX));
  assign mem_addr_o = misc ? (number[2:0] == INX ? acc_q : x_q) : {6'd0, number[9:0]};
  assign mem_read_o = state_q == DECODE && bus_read;
  assign mem_write_o = state_q == DECODE && bus_write;
  assign mem_wdata_o = acc_q;

  // ---- E: the result ---------------------------------------------------------------------------------
  wire immediate = opcode >= LOADI && opcode != INC;
  wire [15:0] operand = immediate ? {5'd0, number} : ram_data;
  wire subtract = opcode == SUB || opcode == SUBI || opcode == LTU || opcode == LTUI;
  wire [15:0] left = opcode == INC ? {{15{number[10]}}, 1'b1} : acc_q;
  wire [16:0] sum = {1'b0, left} + {1'b0, operand ^ {16{subtract}}} + {16'd0, subtract};
  wire equal = opcode == EQ || opcode == EQI;
  wire compare = !jumps && (equal || opcode == LTU || opcode == LTUI);
  reg [15:0] result;

  always @* begin
    result = acc_q;
    if (misc) begin
      if (number[2:0] == NOT) result = ~acc_q;
      if (number[2:0] == TEST) result = {15'd0, test_q};
    end else begin
      case (opcode)
        LOAD, LOADI: result = operand;
        LOADX: if (!number[10]) result = operand;
        ADD, ADDI, SUB, SUBI, INC: result = sum[15:0];
        AND, ANDI: result = acc_q & operand;
        OR, ORI: result = acc_q | operand;
        XOR, XORI: result = acc_q ^ operand;
        ORH: result = acc_q | {number[4:0], 11'd0};
        default: ;
      endcase
    end
  end

  // ---- jumps -----------------------------------------------------------------------------------------
  wire zero = tested_q ? !test_q : acc_q == 16'd0;
  wire always_taken = jump == JUMP || jump == CALL;
  wire taken = always_taken || (jump == JZ) == zero;

  // ---- state -------------------------------------------------------------------------------------------
  always @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q <= CLEARS;
      clear_q <= {RAM_ADDR{1'b0}};
      pc_q <= 12'd0;
      depth_q <= 4'd0;
      tested_q <= 1'b0;
    end else begin
      case (state_q)
        CLEARS: begin
          clear_q <= clear_q + 1'b1;
          if (&clear_q) state_q <= FETCH;
        end
        FETCH: state_q <= DECODE;
        DECODE: state_q <= bus_read ? BUS : EXECUTE;
        BUS: begin
          acc_q <= mem_rdata_i;
          tested_q <= 1'b0;
          pc_q <= next_pc;
          state_q <= FETCH;
        end
        SHIFTS: begin
          acc_q <= instruction[4] ? {1'b0, acc_q[15:1]} : {acc_q[14:0], 1'b0};
          shifts_q <= shifts_q - 4'd1;
          if (shifts_q == 4'd1) state_q <= FETCH;
        end
        default: begin
          pc_q <= jumps && taken ? instruction[11:0] : returns ? ram_data[11:0] : next_pc;
          if (calls) depth_q <= depth_q + 4'd1;
          else if (returns) depth_q <= depth_q - 4'd1;
          if (compare) test_q <= equal ? acc_q == operand : !sum[16];
          tested_q <= compare || (tested_q && (jumps ? always_taken : returns));
          shifts_q <= number[3:0];
          state_q <= !jumps && opcode == SHIFT && number[3:0] != 4'd0 ? SHIFTS : FETCH;
          if (!jumps) begin
            acc_q <= result;
            if (misc && number[2:0] == SETX) x_q <= acc_q;
            if (opcode == INDEX && !number[10]) x_q <= ram_data;
          end
        end
      endcase
    end
  end

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// The load port: one access a clock while no scan runs, nor in the clock that starts one. Spaces:
//   0 instruction memory (address: step * 8 + chunk; 16-bit chunks, the lowest first; write only)
//   1 LUT (address: row; 8 bits; all slots alike; write only)
//   2 bit devices   3 word devices   (write and read)
//   4 program length in steps (write only)
// The length goes last, or at least one clock lies between the last chunk and the start of a scan.
// Device accesses go down slot 0's pipeline as instructions, so that the banks stay consistent and
// no memory needs another port; a scan may start while they are on their way. A read answers with
// load_rvalid_o in the sixth clock after the edge that takes it.
`default_nettype none
`include "rung_isa.vh"

module load_port #(
    parameter LOOKUP = 1,  // 1: instruction layout of MPU2 and MPU3, 0: of MPU1
    parameter BIT_ADDR = 10,  // bits of a bit device's number
    parameter WORD_ADDR = 8,  // bits of a word device's number
    parameter INSTRUCTION_BITS = 45  // bits of one slot's instruction
) (
    input  wire                        clk_i,
    input  wire                        rst_ni,
    input  wire                        busy_i,
    // the port
    input  wire                        load_valid_i,
    input  wire                        load_write_i,
    input  wire [                 2:0] load_space_i,
    input  wire [                19:0] load_addr_i,
    input  wire [                15:0] load_data_i,
    output wire                        load_rvalid_o,
    output wire [                15:0] load_rdata_o,
    // to the memories that are loaded directly
    output wire                        l_chunk_o,
    output wire                        l_lut_o,
    output wire                        l_length_o,
    output wire [                19:0] l_addr_o,
    output wire [                15:0] l_data_o,
    // to slot 0's ID1: an instruction, or 0
    output wire [INSTRUCTION_BITS-1:0] l_instruction_o,
    // what slot 0 has in the clock after EX is an access
    output wire                        w_access_o,
    // slot 0's results, in the clock after EX
    input  wire                        w_bit_i,
    input  wire [                15:0] w_word_i
);

  `include "fields.vh"

  localparam [2:0] SPACE_STEPS = 3'd0;
  localparam [2:0] SPACE_LUT = 3'd1;
  localparam [2:0] SPACE_BITS = 3'd2;
  localparam [2:0] SPACE_WORDS = 3'd3;
  localparam [2:0] SPACE_LENGTH = 3'd4;

  reg l_valid_q;
  reg l_write_q;
  reg [2:0] l_space_q;
  reg [19:0] l_addr_q;
  reg [15:0] l_data_q;

  always @(posedge clk_i) begin
    l_valid_q <= load_valid_i && !busy_i && rst_ni;
    l_write_q <= load_write_i;
    l_space_q <= load_space_i;
    l_addr_q  <= load_addr_i;
    l_data_q  <= load_data_i;
  end

  assign l_chunk_o  = l_valid_q && l_write_q && l_space_q == SPACE_STEPS;
  assign l_lut_o    = l_valid_q && l_write_q && l_space_q == SPACE_LUT;
  assign l_length_o = l_valid_q && l_write_q && l_space_q == SPACE_LENGTH;
  assign l_addr_o   = l_addr_q;
  assign l_data_o   = l_data_q;

  // A write is SET, RST or MV that always runs. A read is a NOP that names the device: a NOP
  // gives its operand `a`, and s1, like any instruction, and writes neither.
  reg [INSTRUCTION_BITS-1:0] l_instruction;
  always @* begin
    l_instruction = {INSTRUCTION_BITS{1'b0}};
    if (l_valid_q && l_space_q == SPACE_BITS) begin
      if (l_write_q) begin
        l_instruction[OP_AT+:`RUNG_OP_BITS] = l_data_q[0] ? `RUNG_OP_SET : `RUNG_OP_RST;
        l_instruction[DEST_AT+:BIT_ADDR] = l_addr_q[BIT_ADDR-1:0];
        l_instruction[U_AT] = 1'b1;
      end else begin
        l_instruction[A_AT+:BIT_ADDR] = l_addr_q[BIT_ADDR-1:0];
      end
    end else if (l_valid_q && l_space_q == SPACE_WORDS) begin
      l_instruction[KIND_AT+:`RUNG_KIND_BITS] = 2'd1;
      if (l_write_q) begin
        l_instruction[OP_AT+:`RUNG_OP_BITS] = `RUNG_OP_MV;
        l_instruction[DEST_AT+:WORD_ADDR] = l_addr_q[WORD_ADDR-1:0];
        l_instruction[`RUNG_WORD_BITS-1:0] = l_data_q;
        l_instruction[U_AT] = 1'b1;
      end else begin
        l_instruction[RS_AT+:WORD_ADDR] = l_addr_q[WORD_ADDR-1:0];
      end
    end
  end
  assign l_instruction_o = l_instruction;

  // The read's way through ID1, ID2, ID3 and EX.
  wire l_read = l_valid_q && !l_write_q && (l_space_q == SPACE_BITS || l_space_q == SPACE_WORDS);
  reg d1_read_q, d2_read_q, d3_read_q, x_read_q, w_read_q;
  reg d1_word_q, d2_word_q, d3_word_q, x_word_q, w_word_q;
  always @(posedge clk_i) begin
    if (!rst_ni) begin
      {d1_read_q, d2_read_q, d3_read_q, x_read_q, w_read_q} <= 5'd0;
    end else begin
      {d1_read_q, d2_read_q, d3_read_q, x_read_q, w_read_q} <= {
        l_read, d1_read_q, d2_read_q, d3_read_q, x_read_q
      };
    end
    {d1_word_q, d2_word_q, d3_word_q, x_word_q, w_word_q} <= {
      l_space_q == SPACE_WORDS, d1_word_q, d2_word_q, d3_word_q, x_word_q
    };
  end

  // Accesses on the same way, writes too.
  reg d1_access_q, d2_access_q, d3_access_q, x_access_q, w_access_q;
  always @(posedge clk_i) begin
    {d1_access_q, d2_access_q, d3_access_q, x_access_q, w_access_q} <= {
      l_valid_q, d1_access_q, d2_access_q, d3_access_q, x_access_q
    };
  end
  assign w_access_o = w_access_q;

  assign load_rvalid_o = w_read_q;
  assign load_rdata_o  = w_word_q ? w_word_i : {15'd0, w_bit_i};

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// CRC-32 (IEEE 802.3, as zlib) for the micro-sequencer: registers crc_* of hdl/isa/controller.toml. A byte
// takes the 2 clocks after its write, fewer than an instruction of the sequencer.
// Bus: select, address and data in the clock of read_i or write_i; rdata_o in the clock after read_i, else 0.
`default_nettype none
`include "rung_controller.vh"

module crc32 (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        sel_register_i,
    input  wire [ 7:0] addr_i,
    input  wire        read_i,
    input  wire        write_i,
    input  wire [15:0] wdata_i,
    output wire [15:0] rdata_o
);

  localparam [7:0] CLEAR = `RUNG_REG_CRC_CLEAR;
  localparam [7:0] BYTE = `RUNG_REG_CRC_BYTE;
  localparam [7:0] LOW = `RUNG_REG_CRC_LOW;
  localparam [7:0] HIGH = `RUNG_REG_CRC_HIGH;
  localparam [31:0] POLYNOMIAL = 32'hedb88320;

  reg [31:0] crc_q;
  reg [ 1:0] left_q;  // halves of the byte
  reg [15:0] rdata_q;

  function automatic [31:0] four_bits(input reg [31:0] value);
    integer bit_number;
    begin
      four_bits = value;
      for (bit_number = 0; bit_number < 4; bit_number = bit_number + 1) begin
        four_bits = {1'b0, four_bits[31:1]} ^ (four_bits[0] ? POLYNOMIAL : 32'd0);
      end
    end
  endfunction

  wire write = sel_register_i && write_i;
  wire read = sel_register_i && read_i;

  // verilator lint_off UNUSEDSIGNAL
  wire [7:0] unused = wdata_i[15:8];
  // verilator lint_on UNUSEDSIGNAL

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      crc_q  <= 32'hffffffff;
      left_q <= 2'd0;
    end else if (write && addr_i == CLEAR) begin
      crc_q  <= 32'hffffffff;
      left_q <= 2'd0;
    end else if (left_q != 2'd0) begin
      crc_q  <= four_bits(crc_q);
      left_q <= left_q - 2'd1;
    end else if (write && addr_i == BYTE) begin
      crc_q[7:0] <= crc_q[7:0] ^ wdata_i[7:0];
      left_q <= 2'd2;
    end

    rdata_q <= 16'd0;
    if (read && addr_i == LOW) rdata_q <= ~crc_q[15:0];
    if (read && addr_i == HIGH) rdata_q <= ~crc_q[31:16];
  end

  assign rdata_o = rdata_q;

endmodule

`default_nettype wire

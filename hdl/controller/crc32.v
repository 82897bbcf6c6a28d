// SPDX-License-Identifier: Apache-2.0
// CRC-32 (IEEE 802.3, as zlib) for the micro-sequencer: registers crc_* of hdl/isa/controller.toml. A byte
// takes the 8 clocks after its write; what is read or written meanwhile is not the CRC of anything.
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
  reg [ 3:0] left_q;  // bits of the byte
  reg [15:0] rdata_q;

  wire write = sel_register_i && write_i;
  wire read = sel_register_i && read_i;

  // verilator lint_off UNUSEDSIGNAL
  wire [7:0] unused = wdata_i[15:8];
  // verilator lint_on UNUSEDSIGNAL

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      crc_q  <= 32'hffffffff;
      left_q <= 4'd0;
    end else if (write && addr_i == CLEAR) begin
      crc_q  <= 32'hffffffff;
      left_q <= 4'd0;
    end else if (left_q != 4'd0) begin
      crc_q  <= {1'b0, crc_q[31:1]} ^ (crc_q[0] ? POLYNOMIAL : 32'd0);
      left_q <= left_q - 4'd1;
    end else if (write && addr_i == BYTE) begin
      crc_q[7:0] <= crc_q[7:0] ^ wdata_i[7:0];
      left_q <= 4'd8;
    end

    rdata_q <= 16'd0;
    if (read && addr_i == LOW) rdata_q <= ~crc_q[15:0];
    if (read && addr_i == HIGH) rdata_q <= ~crc_q[31:16];
  end

  assign rdata_o = rdata_q;

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// SPI byte port to the flash, mode 0, highest bit first, for the micro-sequencer: registers flash_* of
// hdl/isa/controller.toml. A byte takes 16 * HALF_CLOCKS clocks; a write of flash_data meanwhile is ignored.
// mosi_o changes with the falling edge of sck_o and csn_o only by flash_select. miso_i is sampled with the
// clock edge at which sck_o falls, that is 2 * HALF_CLOCKS clocks after the falling edge that made the flash
// put it there: all of an SPI clock for the way out, the flash and the way back. It is no asynchronous
// input, so it has no synchroniser.
// Bus: select, address and data in the clock of read_i or write_i; rdata_o in the clock after read_i, else 0.
`default_nettype none
`include "rung_controller.vh"

module flash_port #(
    parameter integer HALF_CLOCKS = 1  // clocks of half an SPI clock, 1 or 2
) (
    input  wire        clk_i,
    input  wire        rst_ni,
    // pins
    output wire        csn_o,
    output wire        sck_o,
    output wire        mosi_o,
    input  wire        miso_i,
    // bus
    input  wire        sel_register_i,
    input  wire [ 7:0] addr_i,
    input  wire        read_i,
    input  wire        write_i,
    input  wire [15:0] wdata_i,
    output wire [15:0] rdata_o
);

  localparam [7:0] SELECT = `RUNG_REG_FLASH_SELECT;
  localparam [7:0] DATA = `RUNG_REG_FLASH_DATA;
  localparam [7:0] BUSY = `RUNG_REG_FLASH_BUSY;
  localparam [0:0] LAST_CLOCK = HALF_CLOCKS == 2;

  reg csn_q;
  reg sck_q;
  reg [7:0] out_q;
  reg [7:0] in_q;
  reg busy_q;
  reg clock_q;  // of this half
  reg [2:0] bit_q;
  reg [15:0] rdata_q;

  wire write = sel_register_i && write_i;
  wire read = sel_register_i && read_i;
  wire half_end = clock_q == LAST_CLOCK;

  // verilator lint_off UNUSEDSIGNAL
  wire [7:0] unused = wdata_i[15:8];
  // verilator lint_on UNUSEDSIGNAL

  always @(posedge clk_i) begin
    if (!rst_ni) csn_q <= 1'b1;
    else if (write && addr_i == SELECT) csn_q <= !wdata_i[0];

    if (!rst_ni) begin
      busy_q <= 1'b0;
      sck_q  <= 1'b0;
    end else if (!busy_q) begin
      if (write && addr_i == DATA) begin
        busy_q  <= 1'b1;
        out_q   <= wdata_i[7:0];
        clock_q <= 1'b0;
        bit_q   <= 3'd0;
      end
    end else if (!half_end) begin
      clock_q <= 1'b1;
    end else begin
      clock_q <= 1'b0;
      sck_q   <= !sck_q;
      if (sck_q) begin
        in_q  <= {in_q[6:0], miso_i};
        bit_q <= bit_q + 3'd1;
        // mosi keeps its last bit, so that nothing toggles between bytes.
        if (bit_q == 3'd7) busy_q <= 1'b0;
        else out_q <= {out_q[6:0], 1'b0};
      end
    end

    rdata_q <= 16'd0;
    if (read && addr_i == DATA) rdata_q <= {8'd0, in_q};
    if (read && addr_i == BUSY) rdata_q <= {15'd0, busy_q};
  end

  assign csn_o   = csn_q;
  assign sck_o   = sck_q;
  assign mosi_o  = out_q[7];
  assign rdata_o = rdata_q;

endmodule

`default_nettype wire

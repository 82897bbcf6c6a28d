// SPDX-License-Identifier: Apache-2.0
// The firmware's ROM: a block RAM with contents that scripts/gen_isa.py compiles from firmware/, one set for each
// configuration.
`default_nettype none
`include "rung_controller.vh"

module micro_rom #(
    parameter integer CONFIG_ID = 1
) (
    input  wire        clk_i,
`ifdef RUNG_MICRO_TEST
    input  wire        test_write_i,
    input  wire [11:0] test_addr_i,
    input  wire [15:0] test_data_i,
`endif
    input  wire        read_i,
    input  wire [11:0] addr_i,
    output wire [15:0] data_o
);

  reg [15:0] rom[0:`RUNG_MICRO_ROM_WORDS-1];
  reg [15:0] data_q;

  integer i;
  initial begin
    for (i = 0; i < `RUNG_MICRO_ROM_WORDS; i = i + 1) rom[i] = 16'd0;
    `include "rung_micro_rom.vh"
  end

  always @(posedge clk_i) begin
`ifdef RUNG_MICRO_TEST
    if (test_write_i) rom[test_addr_i] <= test_data_i;
`endif
    if (read_i) data_q <= rom[addr_i];
  end

  assign data_o = data_q;

endmodule

`default_nettype wire

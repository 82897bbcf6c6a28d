// SPDX-License-Identifier: Apache-2.0
// The firmware's ROM: a block RAM with contents that scripts/gen_isa.py compiles from firmware/, one set for each
// configuration. It is as deep as that needs, in steps of 256 words, a block RAM of an iCE40.
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

`ifdef RUNG_MICRO_TEST
  localparam integer WORDS = `RUNG_MICRO_ROM_WORDS;
`else
  `include "rung_micro_rom_words.vh"
  localparam integer WORDS = FIRMWARE_WORDS;
`endif
  localparam integer ADDR = $clog2(WORDS);

  reg [15:0] rom[0:WORDS-1];
  reg [15:0] data_q;

  generate
    `include "rung_micro_rom.vh"
  endgenerate

  always @(posedge clk_i) begin
`ifdef RUNG_MICRO_TEST
    if (test_write_i) rom[test_addr_i] <= test_data_i;
`endif
    if (read_i) data_q <= rom[addr_i[ADDR-1:0]];
  end

  wire unused_addr = &{1'b0, addr_i};

  assign data_o = data_q;

endmodule

`default_nettype wire

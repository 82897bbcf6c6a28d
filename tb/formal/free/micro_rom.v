// SPDX-License-Identifier: Apache-2.0
// In the place of hdl/controller/micro/micro_rom.v: each read gives any word, so that what is shown is shown of any firmware.
`default_nettype none

module micro_rom #(
    parameter integer CONFIG_ID = 1
) (
    input  wire        clk_i,
    input  wire        read_i,
    input  wire [11:0] addr_i,
    output wire [15:0] data_o
);

  (* anyseq *) wire [15:0] any;
  reg [15:0] data_q;
  always @(posedge clk_i) if (read_i) data_q <= any;
  assign data_o = data_q;

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// A LUT of a netlist, one entry of which is wrong while fault_i is its NUMBER (scripts/flow/gate.py).
`default_nettype none

module faulty_lut #(
    parameter [15:0] INIT = 16'd0,
    parameter integer NUMBER = 1,
    parameter [3:0] ENTRY = 4'd0
) (
    input  wire [7:0] fault_i,
    input  wire [3:0] in_i,
    output wire       out_o
);

  assign out_o = INIT[in_i] ^ (fault_i == NUMBER[7:0] && in_i == ENTRY);

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// Power-on reset: active-low, synchronous, held for 16 clocks after configuration. The flip-flops start
// at 0, which iCE40 and ECP5 guarantee when they are configured.
`default_nettype none

module power_on_reset (
    input  wire clk_i,
    output wire rst_no
);

  reg [15:0] held_q = 16'h0;

  always @(posedge clk_i) held_q <= {held_q[14:0], 1'b1};

  assign rst_no = held_q[15];

endmodule
`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// Power-on reset: active-low, synchronous, held for 16 clocks after configuration, or for 2^LONGER clocks if
// LONGER is not 0. The flip-flops start at 0, which iCE40, ECP5 and Gowin's devices guarantee when they are
// configured.
`default_nettype none

module power_on_reset #(
    parameter integer LONGER = 0
) (
    input  wire clk_i,
    output wire rst_no
);

  generate
    if (LONGER == 0) begin : gen_short
      reg [15:0] held_q = 16'h0;

      always @(posedge clk_i) held_q <= {held_q[14:0], 1'b1};

      assign rst_no = held_q[15];
    end else begin : gen_long
      reg [LONGER:0] count_q = {(LONGER + 1) {1'b0}};

      always @(posedge clk_i) if (!count_q[LONGER]) count_q <= count_q + 1'b1;

      assign rst_no = count_q[LONGER];
    end
  endgenerate

endmodule
`default_nettype wire

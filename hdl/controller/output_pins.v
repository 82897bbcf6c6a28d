// SPDX-License-Identifier: Apache-2.0
// Output pins: levels are collected while a refresh reads them, and all pins change in the clock after
// refresh_i. While running_i is 0 each pin has its safe level, or keeps its own. invert_i acts behind all of it.
`default_nettype none

module output_pins #(
    parameter integer OUTPUTS = 32
) (
    input  wire               clk_i,
    input  wire               rst_ni,
    input  wire               running_i,
    input  wire               clear_i,      // a first scan begins: no level has been collected
    input  wire               valid_i,
    input  wire [        5:0] pin_i,
    input  wire               level_i,
    input  wire               refresh_i,
    input  wire [OUTPUTS-1:0] safe_i,       // level in the safe state
    input  wire [OUTPUTS-1:0] hold_i,       // keeps its level there instead
    input  wire [OUTPUTS-1:0] invert_i,
    output wire [OUTPUTS-1:0] level_o,      // before inversion
    output wire [OUTPUTS-1:0] pins_o
);

  reg [OUTPUTS-1:0] next_q;
  reg [OUTPUTS-1:0] level_q;
  reg [OUTPUTS-1:0] pins_q;

  genvar n;
  generate
    for (n = 0; n < OUTPUTS; n = n + 1) begin : gen_pin
      always @(posedge clk_i) begin
        if (clear_i) next_q[n] <= 1'b0;
        else if (valid_i && pin_i == n) next_q[n] <= level_i;
        if (!rst_ni) level_q[n] <= 1'b0;
        else if (!running_i) level_q[n] <= hold_i[n] ? level_q[n] : safe_i[n];
        else if (refresh_i) level_q[n] <= next_q[n];
      end
    end
  endgenerate

  always @(posedge clk_i) pins_q <= level_q ^ invert_i;

  assign level_o = level_q;
  assign pins_o  = pins_q;

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// The PWM output as the refresh has it: a duty that an entry of the list gave takes the place of the device
// port's from the clock after end_i on, together with all pins, until a refresh without such an entry. on_o:
// outputs are not safe, and a refresh has been since they were.
`default_nettype none

module pwm_entry (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        begin_i,
    input  wire        value_valid_i,
    input  wire [15:0] value_i,
    input  wire        end_i,
    input  wire        safe_i,
    output wire        on_o,
    output wire        duty_valid_o,
    output wire [15:0] duty_o
);

  reg seen_q;
  reg [15:0] next_q;
  reg on_q;
  reg duty_valid_q;
  reg [15:0] duty_q;

  always @(posedge clk_i) begin
    if (value_valid_i) next_q <= value_i;
    if (end_i) duty_q <= next_q;

    if (!rst_ni) begin
      seen_q <= 1'b0;
      on_q <= 1'b0;
      duty_valid_q <= 1'b0;
    end else begin
      if (begin_i) seen_q <= 1'b0;
      else if (value_valid_i) seen_q <= 1'b1;
      if (safe_i) on_q <= 1'b0;
      else if (end_i) on_q <= 1'b1;
      if (end_i) duty_valid_q <= seen_q;
    end
  end

  assign on_o = on_q;
  assign duty_valid_o = duty_valid_q;
  assign duty_o = duty_q;

endmodule

`default_nettype wire

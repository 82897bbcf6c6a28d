// SPDX-License-Identifier: Apache-2.0
// The RUN switch: brought into the clock domain, and taken when it has not changed for 7 to 8 milliseconds.
// It is right from the end of a reset of 4 clocks on.
`default_nettype none

module run_switch (
    input  wire clk_i,
    input  wire rst_ni,
    input  wire pin_i,
    input  wire millisecond_i,  // 1 for a clock each millisecond
    output wire run_o
);

  localparam [2:0] STEADY = 3'd7;

  reg [1:0] pin_q;
  reg [2:0] differs_q;  // milliseconds
  reg run_q;

  always @(posedge clk_i) begin
    pin_q <= {pin_q[0], pin_i};

    if (!rst_ni) begin
      run_q <= pin_q[1];
      differs_q <= 3'd0;
    end else if (pin_q[1] == run_q) begin
      differs_q <= 3'd0;
    end else if (millisecond_i) begin
      differs_q <= differs_q + 3'd1;
      if (differs_q == STEADY) run_q <= pin_q[1];
    end
  end

  assign run_o = run_q;

endmodule

`default_nettype wire

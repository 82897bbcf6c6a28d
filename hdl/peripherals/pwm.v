// SPDX-License-Identifier: Apache-2.0
// PWM output. duty_i: share of the time that pwm_o is 1, in per cent, signed; below 0 counts as 0, above
// 100 as 100. hz_i: periods a second; 0, and one above half the clock's frequency: pwm_o stays 0.
// Each clock adds hz to a phase that counts modulo CLOCK_HZ, so a second has exactly hz periods, and a
// period's length is never more than a clock off; pwm_o is 1 while the phase is below the duty's share.
// duty_i and hz_i may change at any time, together: a pair that has stood for 16 clocks is what the next
// period begins with, and from frequency 0 the output begins sum 18 clocks. No period mixes two pairs.
`default_nettype none

module pwm #(
    parameter integer CLOCK_HZ = 12000000  // of clk_i; a multiple of 100
) (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire [15:0] duty_i,
    input  wire [31:0] hz_i,
    output wire        pwm_o
);

  localparam integer BITS = $clog2(CLOCK_HZ + 1);  // of a phase or a share of one
  localparam [31:0] PERIOD = CLOCK_HZ;
  localparam [31:0] PER_CENT = CLOCK_HZ / 100;
  localparam [31:0] FASTEST = CLOCK_HZ / 2;
  localparam [6:0] FULL = 7'd100;

  // ---- the pair that is wanted: share = duty * PER_CENT, a bit of duty a clock ------------------
  reg [2:0] count_q;
  reg [6:0] duty_q;
  reg [BITS-1:0] hz_q;
  reg [BITS-1:0] product_q;
  reg [BITS-1:0] want_share_q;
  reg [BITS-1:0] want_step_q;

  wire [6:0] duty = duty_i[15] ? 7'd0 : (|duty_i[14:7] || duty_i[6:0] > FULL) ? FULL : duty_i[6:0];

  always @(posedge clk_i) begin
    if (count_q == 3'd7) begin
      duty_q <= duty;
      hz_q <= hz_i > FASTEST ? {BITS{1'b0}} : hz_i[BITS-1:0];
      product_q <= {BITS{1'b0}};
      want_share_q <= product_q;
      want_step_q <= hz_q;
    end else begin
      duty_q <= {duty_q[5:0], 1'b0};
      product_q <= {product_q[BITS-2:0], 1'b0} + (duty_q[6] ? PER_CENT[BITS-1:0] : {BITS{1'b0}});
    end

    if (!rst_ni) begin
      count_q <= 3'd0;
      duty_q <= 7'd0;
      hz_q <= {BITS{1'b0}};
      product_q <= {BITS{1'b0}};
      want_share_q <= {BITS{1'b0}};
      want_step_q <= {BITS{1'b0}};
    end else begin
      count_q <= count_q + 3'd1;
    end
  end

  // ---- the period: both sums beside each other, the sign of the second says which one ----------
  reg on_q;
  reg [BITS-1:0] phase_q;
  reg [BITS-1:0] share_q;
  reg [BITS-1:0] step_q;
  reg [BITS:0] step_less_q;  // step_q - PERIOD
  reg pwm_q;

  wire [BITS-1:0] sum = phase_q + step_q;
  wire [BITS:0] sum_less = {1'b0, phase_q} + step_less_q;
  wire period_end = !sum_less[BITS];

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      on_q <= 1'b0;
      pwm_q <= 1'b0;
    end else begin
      if (!on_q || period_end) begin
        on_q <= want_step_q != {BITS{1'b0}};
        share_q <= want_share_q;
        step_q <= want_step_q;
        step_less_q <= {1'b0, want_step_q} - PERIOD[BITS:0];
      end
      pwm_q <= on_q && phase_q < share_q;
    end
    if (!on_q) phase_q <= {BITS{1'b0}};
    else phase_q <= period_end ? sum_less[BITS-1:0] : sum;
  end

  assign pwm_o = pwm_q;

endmodule

`default_nettype wire

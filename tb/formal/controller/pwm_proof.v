// SPDX-License-Identifier: Apache-2.0
// PWM output (hdl/peripherals/pwm.v), for any duties and frequencies, whenever they change: each clock adds the frequency of the
// period's pair to a phase that counts modulo CLOCK_HZ; the output is, a clock later, whether the phase is below the duty's
// share of CLOCK_HZ. A period begins where the phase has come round, and while the output is off in each clock; all of it
// goes by one pair, which stood at the inputs in one of the 16 clocks before, and so is the pair that stood there in all of them.
`default_nettype none

module pwm_proof #(
    parameter integer CLOCK_HZ = 12000000
) (
    input wire        clk_i,
    input wire        rst_ni,
    input wire [15:0] duty_i,
    input wire [31:0] hz_i
);

  localparam integer BITS = $clog2(CLOCK_HZ + 1);
  localparam [31:0] CLOCK = CLOCK_HZ;

  wire out;
  pwm #(
      .CLOCK_HZ(CLOCK_HZ)
  ) pwm (
      .clk_i (clk_i),
      .rst_ni(rst_ni),
      .duty_i(duty_i),
      .hz_i  (hz_i),
      .pwm_o (out)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  // ---- what the inputs mean: per cent from 0 to 100, and Hz, 0 for off ------------------------------
  wire signed [15:0] asked = duty_i;
  wire [6:0] per_cent = asked < 0 ? 7'd0 : asked > 100 ? 7'd100 : duty_i[6:0];
  wire [31:0] in_range = 2 * {1'b0, hz_i} > CLOCK_HZ ? 32'd0 : hz_i;
  // Place k: k + 1 clocks ago. A reset counts as a pair of 0 that has been there for ever.
  reg [6:0] per_cent_q[0:16];
  reg [BITS-1:0] hz_q[0:16];
  integer k;
  always @(posedge clk_i) begin
    for (k = 0; k < 17; k = k + 1) begin
      if (!rst_ni) begin
        per_cent_q[k] <= 7'd0;
        hz_q[k] <= {BITS{1'b0}};
      end else begin
        per_cent_q[k] <= k == 0 ? per_cent : per_cent_q[k-1];
        hz_q[k] <= k == 0 ? in_range[BITS-1:0] : hz_q[k-1];
      end
    end
  end

  // The share of a duty: CLOCK_HZ / 100 for each per cent.
  function automatic [BITS-1:0] share_of(input reg [6:0] duty);
    integer b;
    begin
      share_of = {BITS{1'b0}};
      for (b = 0; b < 7; b = b + 1) if (duty[b]) share_of = share_of + ((CLOCK_HZ / 100) << b);
    end
  endfunction

  // ---- periods ---------------------------------------------------------------------------------------
  (* hierconn *) wire [BITS-1:0] \pwm.share_q ;
  (* hierconn *) wire [BITS-1:0] \pwm.step_q ;
  reg begins_q;  // with this clock; in its registers the hardware shows by which pair
  reg on_q;  // this, share and step: in a period's other clocks
  reg [BITS-1:0] share_q;
  reg [BITS-1:0] step_q;
  reg [BITS-1:0] phase_q;
  reg out_q;
  wire [BITS-1:0] share = begins_q ? \pwm.share_q : share_q;
  wire [BITS-1:0] step = begins_q ? \pwm.step_q : step_q;
  wire on = begins_q ? step != 0 : on_q;
  wire [BITS:0] sum = {1'b0, phase_q} + {1'b0, step};
  wire ends = on && sum >= CLOCK_HZ;

  always @(posedge clk_i) begin
    begins_q <= rst_ni && (!on || ends);
    on_q <= rst_ni && on;
    out_q <= rst_ni && on && phase_q < share;
    share_q <= share;
    step_q <= step;
    phase_q <= !on ? 0 : ends ? sum - CLOCK_HZ : sum;
  end

  reg stood;  // the pair did so in one of the 16 clocks
  integer n;
  always @* begin
    stood = 1'b0;
    for (n = 1; n < 17; n = n + 1) begin
      if (share == share_of(per_cent_q[n]) && step == hz_q[n]) stood = 1'b1;
    end
  end
  always @* begin
    if (begun_q) begin
      assert (out == out_q);
      if (begins_q) assert (stood);
    end
  end

  // ---- for the induction ---------------------------------------------------------------------------
  (* hierconn *) wire [2:0] \pwm.count_q ;
  (* hierconn *) wire [6:0] \pwm.duty_q ;
  (* hierconn *) wire [BITS-1:0] \pwm.hz_q ;
  (* hierconn *) wire [BITS-1:0] \pwm.product_q ;
  (* hierconn *) wire [BITS-1:0] \pwm.want_share_q ;
  (* hierconn *) wire [BITS-1:0] \pwm.want_step_q ;
  (* hierconn *) wire \pwm.on_q ;
  (* hierconn *) wire [BITS-1:0] \pwm.phase_q ;
  (* hierconn *) wire [BITS:0] \pwm.step_less_q ;
  wire [6:0] sampled = per_cent_q[\pwm.count_q ];
  wire [4:0] wanted = {2'd1, \pwm.count_q };
  always @* begin
    if (begun_q) begin
      assert (\pwm.duty_q == sampled << \pwm.count_q );
      assert (\pwm.product_q == share_of(sampled >> (4'd7 - {1'b0, \pwm.count_q })));
      assert (\pwm.hz_q == hz_q[\pwm.count_q ]);
      assert (\pwm.want_share_q == share_of(per_cent_q[wanted]));
      assert (\pwm.want_step_q == hz_q[wanted]);
      assert (\pwm.on_q == on);
      for (n = 0; n < 17; n = n + 1) begin
        assert (per_cent_q[n] <= 7'd100 && 2 * {2'b00, hz_q[n]} <= CLOCK_HZ);
      end
      if (on) begin
        assert (\pwm.share_q == share && \pwm.step_q == step && \pwm.phase_q == phase_q);
        assert (\pwm.step_less_q == {1'b0, step} - CLOCK[BITS:0]);
        assert (step != 0 && 2 * {2'b00, step} <= CLOCK_HZ && phase_q < CLOCK_HZ);
      end
    end
  end

`ifdef RUNG_NARROW
  always @* assume (begun_q == rst_ni && (duty_i == 16'd10 || duty_i == 16'd90));
  always @* assume (hz_i == CLOCK_HZ / 2 || hz_i == CLOCK_HZ / 4);
`endif
  // A period of two clocks at 50 per cent; one at 100 per cent whose pair is not the one of the period before.
  reg out_before_q;
  reg [BITS-1:0] step_before_q;
  always @(posedge clk_i) begin
    out_before_q  <= out;
    step_before_q <= step;
  end
  always @* begin
    cover (begun_q && out && !out_before_q && ends && step == CLOCK_HZ / 2);
    cover (begun_q && begins_q && on && step_before_q != 0 && step_before_q != step);
  end

endmodule

`default_nettype wire

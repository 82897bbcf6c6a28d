// SPDX-License-Identifier: Apache-2.0
// The refreshed duty of the PWM output (hdl/controller/pwm_entry.v): it changes only with the end of a refresh, to the last value
// that this refresh gave, and is the list's only if it gave one; the output is on only if a refresh has ended since
// outputs had to be safe.
`default_nettype none

module pwm_entry_proof (
    input wire        clk_i,
    input wire        rst_ni,
    input wire        begin_i,
    input wire        value_valid_i,
    input wire [15:0] value_i,
    input wire        end_i,
    input wire        safe_i
);

  wire on, duty_valid;
  wire [15:0] duty;
  pwm_entry entry (
      .clk_i        (clk_i),
      .rst_ni       (rst_ni),
      .begin_i      (begin_i),
      .value_valid_i(value_valid_i),
      .value_i      (value_i),
      .end_i        (end_i),
      .safe_i       (safe_i),
      .on_o         (on),
      .duty_valid_o (duty_valid),
      .duty_o       (duty)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);
  // A value comes between the beginning of its refresh and the end.
  reg given_q;
  reg [15:0] value_q;
  reg listed_q;
  reg [15:0] duty_q;
  reg on_q;
  always @* assume (!(value_valid_i && (begin_i || end_i)));

  always @(posedge clk_i) begin
    if (!rst_ni || begin_i) given_q <= 1'b0;
    else if (value_valid_i) given_q <= 1'b1;
    if (value_valid_i) value_q <= value_i;
    if (!rst_ni) listed_q <= 1'b0;
    else if (end_i) listed_q <= given_q;
    if (end_i && given_q) duty_q <= value_q;
    on_q <= rst_ni && !safe_i && (end_i || on_q);
  end

  always @* begin
    if (begun_q) begin
      assert (on == on_q);
      assert (duty_valid == listed_q);
      if (listed_q) assert (duty == duty_q);
    end
  end

  // For the induction.
  (* hierconn *) wire \entry.seen_q ;
  (* hierconn *) wire [15:0] \entry.next_q ;
  always @* begin
    if (begun_q) begin
      assert (\entry.seen_q == given_q);
      if (given_q) assert (\entry.next_q == value_q);
    end
  end

  always @* cover (begun_q && on && duty_valid && duty == 16'd55);

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// RUN switch (hdl/controller/run_switch.v): it is taken in the clock of the eighth millisecond in which it stood still at
// the other position, so after 7 to 8 milliseconds, and never sooner; bouncing begins the count anew.
`default_nettype none

module run_switch_proof (
    input wire clk_i,
    input wire rst_ni,
    input wire pin_i,
    input wire millisecond_i
);

  wire run;
  run_switch switch_ (
      .clk_i        (clk_i),
      .rst_ni       (rst_ni),
      .pin_i        (pin_i),
      .millisecond_i(millisecond_i),
      .run_o        (run)
  );

  // A reset of four clocks to begin with.
  reg [2:0] age_q;
  initial age_q = 3'd0;
  always @(posedge clk_i) if (age_q != 3'd7) age_q <= age_q + 3'd1;
  always @* if (age_q < 3'd4) assume (!rst_ni);
  wire ready = age_q >= 3'd4;

  // Ends of milliseconds since the pin, two clocks late, was last where the switch is.
  reg [2:0] pin_q;
  reg [3:0] ends_q;
  reg run_q;
  reg reset_q;
  always @(posedge clk_i) begin
    pin_q   <= {pin_q[1:0], pin_i};
    run_q   <= run;
    reset_q <= !rst_ni;
    if (!rst_ni || pin_q[1] == run) ends_q <= 4'd0;
    else ends_q <= (ends_q == 4'd8 ? 4'd0 : ends_q) + {3'd0, millisecond_i};
  end

  always @* begin
    if (ready) begin
      assert (ends_q <= 4'd8);
      if (reset_q)
        assert (run == pin_q[2]);
        else assert ((run != run_q) == (ends_q == 4'd8));
    end
  end

  // For the induction.
  (* hierconn *) wire [2:0] \switch_.differs_q ;
  (* hierconn *) wire [1:0] \switch_.pin_q ;
  always @* begin
    if (age_q >= 3'd2) assert (\switch_.pin_q == pin_q[1:0]);
    if (ready) begin
      assert (\switch_.differs_q == ends_q[2:0]);
      if (ends_q == 4'd8) assert (run == pin_q[2]);
    end
  end

  always @* begin
    cover (ready && !reset_q && run && !run_q);
    cover (ready && !reset_q && ends_q == 4'd6 && run == pin_q[1]);
  end

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// Output pins (hdl/controller/output_pins.v), any of them: a pin changes only in the clock after the end of a refresh, in that
// after one in which outputs have to be safe, with a setting that is written, or with a reset; never else. At the end of a
// refresh it takes the last value that was given to it since the refresh's beginning, or its level of the setup if there
// was none, and all pins do so in the same clock; safe it shows its level of the setup, or keeps its own.
`default_nettype none
`include "rung_controller.vh"

module output_pins_proof #(
    parameter integer OUTPUTS = 6
) (
    input wire                 clk_i,
    input wire                 rst_ni,
    input wire [3*OUTPUTS-1:0] setup_i,
    input wire                 begin_i,
    input wire                 value_valid_i,
    input wire [          7:0] value_pin_i,
    input wire                 value_i,
    input wire                 end_i,
    input wire                 safe_i,
    input wire                 sel_register_i,
    input wire [          7:0] addr_i,
    input wire                 read_i
);

  wire [OUTPUTS-1:0] out;
  wire [15:0] rdata;
  output_pins #(
      .OUTPUTS(OUTPUTS)
  ) pins (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .out_o         (out),
      .setup_i       (setup_i),
      .begin_i       (begin_i),
      .value_valid_i (value_valid_i),
      .value_pin_i   (value_pin_i),
      .value_i       (value_i),
      .end_i         (end_i),
      .safe_i        (safe_i),
      .sel_register_i(sel_register_i),
      .addr_i        (addr_i),
      .read_i        (read_i),
      .rdata_o       (rdata)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  (* anyconst *) wire [7:0] pin;
  always @* assume (pin < OUTPUTS);
  wire [2:0] setup = setup_i[3*pin+:3];
  wire safe_level = setup[0];
  wire keeps = setup[1];
  wire inverted = setup[2];

  // The value since the refresh's beginning, and the level behind the inversion.
  reg refreshed_q;  // a refresh has begun
  reg given_q;  // it had an entry of this pin
  reg given_value_q;
  reg not_given_q;  // what is shown without one
  reg level_q;
  wire given = value_valid_i && value_pin_i == pin;
  wire at_end = given_q ? given_value_q : not_given_q;

  always @(posedge clk_i) begin
    if (begin_i) begin
      refreshed_q <= 1'b1;
      given_q <= 1'b0;
      not_given_q <= safe_level;
    end else if (given) begin
      given_q <= 1'b1;
      given_value_q <= value_i;
    end
    if (!begun_q) refreshed_q <= begin_i;

    if (!rst_ni) level_q <= 1'b0;
    else if (safe_i) level_q <= keeps ? level_q : safe_level;
    else if (end_i) level_q <= at_end;
  end
  always @* assume (!end_i || refreshed_q);  // an end has a beginning

  // What may change the pin, in the clock before.
  reg may_q;
  reg out_q;
  reg inverted_q;
  reg before_q;
  reg was_reset_q;
  always @(posedge clk_i) begin
    out_q <= out[pin];
    inverted_q <= inverted;
    was_reset_q <= !rst_ni;
    may_q <= !rst_ni || (end_i && !safe_i) || (safe_i && !keeps);
    before_q <= inverted_q;
  end
  always @* begin
    if (begun_q) begin
      assert (out[pin] == (!was_reset_q && (level_q ^ inverted_q)));
      // No entry of the list but by the end of its refresh.
      if (!may_q && before_q == inverted_q && begun_2_q && !reset_before_q)
        assert (out[pin] == out_q);
    end
  end
  reg begun_2_q;
  initial begun_2_q = 1'b0;
  reg reset_before_q;
  always @(posedge clk_i) begin
    begun_2_q <= begun_q;
    reset_before_q <= was_reset_q;
  end

  // The bus sees the level.
  reg read_q;
  reg [15:0] levels_q;
  always @(posedge clk_i) begin
    read_q   <= begun_q && sel_register_i && read_i && addr_i == `RUNG_REG_OUTPUTS;
    levels_q <= {15'd0, level_q};
  end
  always @* if (begun_q && read_q && pin < 8'd16) assert (rdata[pin[3:0]] == levels_q[0]);

  // For the induction.
  (* hierconn *) wire [OUTPUTS-1:0] \pins.next_q ;
  (* hierconn *) wire [OUTPUTS-1:0] \pins.level_q ;
  always @* begin
    if (begun_q) begin
      assert (\pins.level_q [pin] == level_q);
      if (refreshed_q) assert (\pins.next_q [pin] == at_end);
    end
  end

  always @* begin
    cover (begun_2_q && !may_q && given_q && given_value_q && !out[pin]);
    cover (begun_2_q && may_q && !was_reset_q && out[pin] && !out_q && !inverted_q);
  end

endmodule

`default_nettype wire

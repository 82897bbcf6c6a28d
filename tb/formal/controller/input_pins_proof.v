// SPDX-License-Identifier: Apache-2.0
// Input pins (hdl/controller/input_pins.v), any of them: its filter (input_filter_proof.v) has this pin, its own five bits of the
// setup and the common sample clock, one clock in filter_clocks_i + 1; what the program sees is pin and analogue samples as
// they were in the clock of the last latch, all in the same one, and changes at no other time; the bus reads the pin at its place.
`default_nettype none

module input_pins_proof #(
    parameter integer INPUTS = 35
) (
    input wire                clk_i,
    input wire                rst_ni,
    input wire [  INPUTS-1:0] in_i,
    input wire [       127:0] adc_i,
    input wire [        15:0] filter_clocks_i,
    input wire [5*INPUTS-1:0] filter_i,
    input wire                latch_i,
    input wire                sel_register_i,
    input wire [         7:0] addr_i,
    input wire                read_i
);

  wire [INPUTS-1:0] held;
  wire [127:0] adc_held;
  wire [15:0] rdata;
  input_pins #(
      .INPUTS(INPUTS)
  ) pins (
      .clk_i          (clk_i),
      .rst_ni         (rst_ni),
      .in_i           (in_i),
      .adc_i          (adc_i),
      .filter_clocks_i(filter_clocks_i),
      .filter_i       (filter_i),
      .latch_i        (latch_i),
      .held_o         (held),
      .adc_held_o     (adc_held),
      .sel_register_i (sel_register_i),
      .addr_i         (addr_i),
      .read_i         (read_i),
      .rdata_o        (rdata)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  // ---- the filter of any pin, beside the one in the hardware ---------------------------------------
  (* anyconst *) wire [7:0] pin;
  always @* assume (pin < INPUTS);
  // The clocks of the samples: the second one behind a reset, and filter_clocks_i + 1 behind each, with filter_clocks_i as
  // it was in the clock before it.
  reg [16:0] until_q;
  reg [15:0] clocks_q;
  wire sample = until_q == 17'd0;
  wire value;
  always @(posedge clk_i) begin
    clocks_q <= filter_clocks_i;
    if (!rst_ni) until_q <= 17'd1;
    else until_q <= sample ? {1'b0, clocks_q} : until_q - 17'd1;
  end
  input_filter filter (
      .clk_i    (clk_i),
      .rst_ni   (rst_ni),
      .pin_i    (in_i[pin]),
      .sample_i (sample),
      .samples_i(filter_i[5*pin+:4]),
      .invert_i (filter_i[5*pin+4]),
      .value_o  (value)
  );

  // ---- what the program and the bus see ------------------------------------------------------------
  (* anyconst *) wire [2:0] channel;
  reg latched_q;
  initial latched_q = 1'b0;
  reg value_q;
  reg [15:0] adc_q;
  reg before_q;
  reg read_q;
  initial read_q = 1'b0;
  reg read_known_q;
  initial read_known_q = 1'b0;
  reg here_q;
  reg [5:0] place_q;
  always @(posedge clk_i) begin
    if (latch_i) begin
      latched_q <= begun_q;
      value_q <= value;
      adc_q <= adc_i[16*channel+:16];
    end
    before_q <= value;
    read_known_q <= begun_q;
    read_q <= begun_q && sel_register_i && read_i && addr_i >= 8'd64 && addr_i < 8'd68;
    here_q <= addr_i == 8'd64 + {6'd0, pin[5:4]};
    place_q <= {addr_i[1:0], 4'd0};
  end
  always @* begin
    if (begun_q) begin
      if (latched_q) assert (held[pin] == value_q && adc_held[16*channel+:16] == adc_q);
      if (read_q && here_q) assert (rdata[pin[3:0]] == before_q);
      if (read_known_q && !read_q) assert (rdata == 16'd0);
    end
  end
  // Pins that there are not are 0.
  integer i;
  always @* begin
    for (i = 0; i < 16; i = i + 1) begin
      if (read_q && place_q + i >= INPUTS) assert (!rdata[i]);
    end
  end

  // ---- for the induction ---------------------------------------------------------------------------
  (* hierconn *) wire [15:0] \pins.rest_q ;
  (* hierconn *) wire \pins.sample_q ;
  always @* begin
    if (begun_q) begin
      assert (\pins.sample_q == sample);
      if (sample) assert (\pins.rest_q == clocks_q);
      else assert ({1'b0, \pins.rest_q } + 17'd1 == until_q);
    end
  end

  always @* begin
    cover (begun_q && latched_q && held[pin] && !value && adc_held[16*channel+:16] == 16'h0123);
    cover (read_q && here_q && rdata == 16'h0002 && pin == 8'd33);
    cover (begun_q && sample && clocks_q == 16'd3 && until_before_q);
  end
  reg until_before_q;
  always @(posedge clk_i) until_before_q <= until_q == 17'd1;

endmodule

`default_nettype wire

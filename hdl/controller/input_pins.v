// SPDX-License-Identifier: Apache-2.0
// All inputs of a controller: a filter a pin, sampled together every filter_clocks_i + 1 clocks, and what the
// program sees: pins and analogue samples as they were in the clock of latch_i, from the next clock on.
// Bus: registers inputs of hdl/isa/controller.toml; rdata_o in the clock after read_i, else 0.
`default_nettype none
`include "rung_controller.vh"

module input_pins #(
    parameter integer INPUTS = 32  // 1 to 64
) (
    input  wire                clk_i,
    input  wire                rst_ni,
    input  wire [  INPUTS-1:0] in_i,
    input  wire [       127:0] adc_i,            // 8 samples of 16 bits, channel 0 lowest
    // setup: 5 bits a pin
    input  wire [        15:0] filter_clocks_i,
    input  wire [5*INPUTS-1:0] filter_i,
    // to the program
    input  wire                latch_i,
    output wire [  INPUTS-1:0] held_o,
    output wire [       127:0] adc_held_o,
    // bus
    input  wire                sel_register_i,
    input  wire [         7:0] addr_i,
    input  wire                read_i,
    output wire [        15:0] rdata_o
);

  localparam [7:0] FIRST_REGISTER = `RUNG_REG_INPUTS;
  localparam integer UNUSED = 64 - INPUTS;

  reg [15:0] rest_q;  // clocks to the next sample
  reg        sample_q;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      rest_q   <= 16'd0;
      sample_q <= 1'b0;
    end else begin
      rest_q   <= rest_q == 16'd0 ? filter_clocks_i : rest_q - 16'd1;
      sample_q <= rest_q == 16'd0;
    end
  end

  wire [INPUTS-1:0] value;

  genvar i;
  generate
    for (i = 0; i < INPUTS; i = i + 1) begin : g_pin
      input_filter filter (
          .clk_i    (clk_i),
          .rst_ni   (rst_ni),
          .pin_i    (in_i[i]),
          .sample_i (sample_q),
          .samples_i(filter_i[5*i+:4]),
          .invert_i (filter_i[5*i+4]),
          .value_o  (value[i])
      );
    end
  endgenerate

  reg [INPUTS-1:0] held_q;
  reg [127:0] adc_held_q;

  always @(posedge clk_i) begin
    if (latch_i) begin
      held_q <= value;
      adc_held_q <= adc_i;
    end
  end

  assign held_o = held_q;
  assign adc_held_o = adc_held_q;

  wire [63:0] values;
  generate
    if (UNUSED == 0) begin : g_all
      assign values = value;
    end else begin : g_some
      assign values = {{UNUSED{1'b0}}, value};
    end
  endgenerate

  reg  [15:0] rdata_q;
  wire [ 7:0] offset = addr_i ^ FIRST_REGISTER;

  always @(posedge clk_i) begin
    rdata_q <= 16'd0;
    if (sel_register_i && read_i && offset[7:2] == 6'd0) rdata_q <= values[{offset[1:0], 4'd0}+:16];
  end

  assign rdata_o = rdata_q;

endmodule

`default_nettype wire

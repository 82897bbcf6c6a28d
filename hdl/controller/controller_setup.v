// SPDX-License-Identifier: Apache-2.0
// The registers of load space setup (controller.toml), written by the firmware while it loads a program.
`default_nettype none
`include "rung_controller.vh"

module controller_setup #(
    parameter integer INPUTS  = 32,
    parameter integer OUTPUTS = 32
) (
    input  wire                clk_i,
    input  wire                rst_ni,
    input  wire                write_i,
    input  wire [         7:0] addr_i,
    input  wire [        15:0] data_i,
    output wire [         8:0] latch_count_o,
    output wire [         7:0] refresh_first_o,
    output wire [         8:0] refresh_count_o,
    output wire [        11:0] exchange_points_o,
    output wire [        31:0] period_o,
    output wire [        31:0] watchdog_o,
    output wire [        15:0] filter_clocks_o,
    output wire [        31:0] pwm_hz_o,
    output wire [        23:0] adc_route_o,        // channel of device port adc n: 3n + 2 to 3n
    output wire [4*INPUTS-1:0] filter_samples_o,
    output wire [  INPUTS-1:0] invert_in_o,
    output wire [ OUTPUTS-1:0] safe_o,
    output wire [ OUTPUTS-1:0] hold_o,
    output wire [ OUTPUTS-1:0] invert_out_o
);

  localparam [7:0] ADC_ROUTE = `RUNG_SETUP_ADC_ROUTE;
  localparam [7:0] FILTER = `RUNG_SETUP_FILTER;
  localparam [7:0] OUTPUT = `RUNG_SETUP_OUTPUT;

  reg [8:0] latch_count_q;
  reg [7:0] refresh_first_q;
  reg [8:0] refresh_count_q;
  reg [11:0] exchange_points_q;
  reg [31:0] period_q, watchdog_q, pwm_hz_q;
  reg [15:0] filter_clocks_q;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      latch_count_q <= 9'd0;
      refresh_first_q <= 8'd0;
      refresh_count_q <= 9'd0;
      exchange_points_q <= 12'd0;
      period_q <= 32'd0;
      watchdog_q <= 32'd0;
      pwm_hz_q <= 32'd0;
      filter_clocks_q <= 16'd0;
    end else if (write_i) begin
      case (addr_i)
        `RUNG_SETUP_LATCH_COUNT: latch_count_q <= data_i[8:0];
        `RUNG_SETUP_REFRESH_FIRST: refresh_first_q <= data_i[7:0];
        `RUNG_SETUP_REFRESH_COUNT: refresh_count_q <= data_i[8:0];
        `RUNG_SETUP_EXCHANGE_POINTS: exchange_points_q <= data_i[11:0];
        `RUNG_SETUP_PERIOD_LOW: period_q[15:0] <= data_i;
        `RUNG_SETUP_PERIOD_HIGH: period_q[31:16] <= data_i;
        `RUNG_SETUP_WATCHDOG_LOW: watchdog_q[15:0] <= data_i;
        `RUNG_SETUP_WATCHDOG_HIGH: watchdog_q[31:16] <= data_i;
        `RUNG_SETUP_FILTER_CLOCKS: filter_clocks_q <= data_i;
        `RUNG_SETUP_PWM_HZ_LOW: pwm_hz_q[15:0] <= data_i;
        `RUNG_SETUP_PWM_HZ_HIGH: pwm_hz_q[31:16] <= data_i;
        default: ;
      endcase
    end
  end

  assign latch_count_o = latch_count_q;
  assign refresh_first_o = refresh_first_q;
  assign refresh_count_o = refresh_count_q;
  assign exchange_points_o = exchange_points_q;
  assign period_o = period_q;
  assign watchdog_o = watchdog_q;
  assign filter_clocks_o = filter_clocks_q;
  assign pwm_hz_o = pwm_hz_q;

  genvar n;
  generate
    for (n = 0; n < `RUNG_SETUP_ADC_ROUTE_COUNT; n = n + 1) begin : gen_route
      reg [2:0] route_q;
      always @(posedge clk_i) begin
        if (!rst_ni) route_q <= n[2:0];
        else if (write_i && addr_i == ADC_ROUTE + n[7:0]) route_q <= data_i[2:0];
      end
      assign adc_route_o[3*n+:3] = route_q;
    end
    for (n = 0; n < INPUTS; n = n + 1) begin : gen_input
      reg [4:0] filter_q;
      always @(posedge clk_i) begin
        if (!rst_ni) filter_q <= 5'd0;
        else if (write_i && addr_i == FILTER + n[7:0]) filter_q <= data_i[4:0];
      end
      assign filter_samples_o[4*n+:4] = filter_q[3:0];
      assign invert_in_o[n] = filter_q[4];
    end
    for (n = 0; n < OUTPUTS; n = n + 1) begin : gen_output
      reg [2:0] output_q;
      always @(posedge clk_i) begin
        if (!rst_ni) output_q <= 3'd0;
        else if (write_i && addr_i == OUTPUT + n[7:0]) output_q <= data_i[2:0];
      end
      assign {invert_out_o[n], hold_o[n], safe_o[n]} = output_q;
    end
  endgenerate

endmodule

`default_nettype wire

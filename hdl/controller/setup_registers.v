// SPDX-License-Identifier: Apache-2.0
// Space setup (hdl/isa/controller.toml): what the scan controller and the pins are told. All 0 after reset.
`default_nettype none
`include "rung_controller.vh"

module setup_registers #(
    parameter integer INPUTS  = 32,  // 1 to 64, as the next
    parameter integer OUTPUTS = 32
) (
    input  wire                 clk_i,
    input  wire                 rst_ni,
    input  wire                 write_i,
    input  wire [          7:0] addr_i,
    input  wire [         15:0] data_i,
    output wire [          8:0] latch_count_o,
    output wire [          7:0] refresh_first_o,
    output wire [          8:0] refresh_count_o,
    output wire [         11:0] exchange_points_o,
    output wire [         31:0] period_o,
    output wire [         31:0] watchdog_o,
    output wire [         15:0] filter_clocks_o,
    output wire [         31:0] pwm_hz_o,
    output wire [         23:0] adc_route_o,       // 3 bits a channel
    output wire [ 5*INPUTS-1:0] filter_o,          // 5 bits a pin: samples, inverted
    output wire [3*OUTPUTS-1:0] output_o           // 3 bits a pin: safe level, keeps, inverted
);

  localparam [7:0] LATCH_COUNT = `RUNG_SETUP_LATCH_COUNT;
  localparam [7:0] REFRESH_FIRST = `RUNG_SETUP_REFRESH_FIRST;
  localparam [7:0] REFRESH_COUNT = `RUNG_SETUP_REFRESH_COUNT;
  localparam [7:0] EXCHANGE_POINTS = `RUNG_SETUP_EXCHANGE_POINTS;
  localparam [7:0] PERIOD_LOW = `RUNG_SETUP_PERIOD_LOW;
  localparam [7:0] PERIOD_HIGH = `RUNG_SETUP_PERIOD_HIGH;
  localparam [7:0] WATCHDOG_LOW = `RUNG_SETUP_WATCHDOG_LOW;
  localparam [7:0] WATCHDOG_HIGH = `RUNG_SETUP_WATCHDOG_HIGH;
  localparam [7:0] FILTER_CLOCKS = `RUNG_SETUP_FILTER_CLOCKS;
  localparam [7:0] PWM_HZ_LOW = `RUNG_SETUP_PWM_HZ_LOW;
  localparam [7:0] PWM_HZ_HIGH = `RUNG_SETUP_PWM_HZ_HIGH;
  localparam [7:0] ADC_ROUTE = `RUNG_SETUP_ADC_ROUTE;
  localparam [7:0] FILTER = `RUNG_SETUP_FILTER;
  localparam [7:0] OUTPUT = `RUNG_SETUP_OUTPUT;

  reg [8:0] latch_count_q;
  reg [7:0] refresh_first_q;
  reg [8:0] refresh_count_q;
  reg [11:0] exchange_points_q;
  reg [31:0] period_q;
  reg [31:0] watchdog_q;
  reg [15:0] filter_clocks_q;
  reg [31:0] pwm_hz_q;
  reg [23:0] adc_route_q;
  reg [5*INPUTS-1:0] filter_q;
  reg [3*OUTPUTS-1:0] output_q;

  integer i;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      latch_count_q <= 9'd0;
      refresh_first_q <= 8'd0;
      refresh_count_q <= 9'd0;
      exchange_points_q <= 12'd0;
      period_q <= 32'd0;
      watchdog_q <= 32'd0;
      filter_clocks_q <= 16'd0;
      pwm_hz_q <= 32'd0;
      adc_route_q <= 24'd0;
      filter_q <= {5 * INPUTS{1'b0}};
      output_q <= {3 * OUTPUTS{1'b0}};
    end else if (write_i) begin
      case (addr_i)
        LATCH_COUNT: latch_count_q <= data_i[8:0];
        REFRESH_FIRST: refresh_first_q <= data_i[7:0];
        REFRESH_COUNT: refresh_count_q <= data_i[8:0];
        EXCHANGE_POINTS: exchange_points_q <= data_i[11:0];
        PERIOD_LOW: period_q[15:0] <= data_i;
        PERIOD_HIGH: period_q[31:16] <= data_i;
        WATCHDOG_LOW: watchdog_q[15:0] <= data_i;
        WATCHDOG_HIGH: watchdog_q[31:16] <= data_i;
        FILTER_CLOCKS: filter_clocks_q <= data_i;
        PWM_HZ_LOW: pwm_hz_q[15:0] <= data_i;
        PWM_HZ_HIGH: pwm_hz_q[31:16] <= data_i;
        default: ;
      endcase
      for (i = 0; i < 8; i = i + 1) begin
        if (addr_i == ADC_ROUTE + i[7:0]) adc_route_q[3*i+:3] <= data_i[2:0];
      end
      for (i = 0; i < INPUTS; i = i + 1) begin
        if (addr_i == FILTER + i[7:0]) filter_q[5*i+:5] <= data_i[4:0];
      end
      for (i = 0; i < OUTPUTS; i = i + 1) begin
        if (addr_i == OUTPUT + i[7:0]) output_q[3*i+:3] <= data_i[2:0];
      end
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
  assign adc_route_o = adc_route_q;
  assign filter_o = filter_q;
  assign output_o = output_q;

endmodule

`default_nettype wire

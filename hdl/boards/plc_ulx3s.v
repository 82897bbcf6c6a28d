// SPDX-License-Identifier: Apache-2.0
// The controller on a ULX3S with an ECP5-85F, from the board's 25 MHz. in_i and out_o are the pins of
// hdl/isa/boards.toml in their order; all pins are in constraints/plc_ulx3s.lpf.
// Host: USB serial, host_de_o for an RS-485 driver beside it. Lamps: LED 7 run, 6 fault, 5 forced, 4 host line.
// The flash is the one that the board is configured from: its clock pin is the configuration clock's, which
// only the USRMCLK primitive reaches. wifi_gpio0_o at 0 would hand the board over to its ESP32.
`default_nettype none
`include "rung_isa.vh"
`include "rung_controller.vh"

module plc_ulx3s (
    input  wire        clk_25mhz_i,
    input  wire [22:0] in_i,
    output wire [17:0] out_o,
    input  wire        run_switch_i,
    output wire        run_o,
    output wire        fault_o,
    output wire        forced_o,
    output wire        line_o,
    // host
    input  wire        host_rx_i,
    output wire        host_tx_o,
    output wire        host_de_o,
    // the program's own UART and PWM
    input  wire        rx_i,
    output wire        tx_o,
    output wire        pwm_o,
    // flow tasks: link to the units above and below, the panel
    input  wire        upper_rx_i,
    output wire        upper_tx_o,
    input  wire        lower_rx_i,
    output wire        lower_tx_o,
    input  wire        panel_rx_i,
    output wire        panel_tx_o,
    output wire        panel_de_o,
    // converter
    output wire        adc_csn_o,
    output wire        adc_sck_o,
    output wire        adc_mosi_o,
    input  wire        adc_miso_i,
    // flash
    output wire        flash_csn_o,
    output wire        flash_mosi_o,
    input  wire        flash_miso_i,
    output wire        flash_holdn_o,
    output wire        flash_wpn_o,
    output wire        wifi_gpio0_o
);

  wire rst_n;
  wire flash_sck;
  wire [127:0] samples;

  assign flash_holdn_o = 1'b1;
  assign flash_wpn_o   = 1'b1;
  assign wifi_gpio0_o  = 1'b1;

  power_on_reset #(
      .LONGER(12)
  ) power_on_reset (
      .clk_i (clk_25mhz_i),
      .rst_no(rst_n)
  );

  USRMCLK flash_clock (
      .USRMCLKI (flash_sck),
      .USRMCLKTS(1'b0)
  );

  max11123 #(
      .HALF(4)
  ) adc (
      .clk_i    (clk_25mhz_i),
      .rst_ni   (rst_n),
      .csn_o    (adc_csn_o),
      .sck_o    (adc_sck_o),
      .mosi_o   (adc_mosi_o),
      .miso_i   (adc_miso_i),
      .samples_o(samples)
  );

  controller #(
      .MPU(3),
      .CLOCK_HZ(`RUNG_ECP5_CLOCK_HZ),
      .CLOCKS_PER_MS(`RUNG_ECP5_CLOCK_HZ / 1000),
      `RUNG_ECP5_MAP,
      `RUNG_BOARD_ULX3S,
      `RUNG_ECP5_MPU3
  ) controller (
      .clk_i       (clk_25mhz_i),
      .rst_ni      (rst_n),
      .in_i        (in_i),
      .out_o       (out_o),
      .adc_i       (samples),
      .pwm_o       (pwm_o),
      .rx_i        (rx_i),
      .tx_o        (tx_o),
      .host_rx_i   (host_rx_i),
      .host_tx_o   (host_tx_o),
      .host_de_o   (host_de_o),
      .flash_csn_o (flash_csn_o),
      .flash_sck_o (flash_sck),
      .flash_mosi_o(flash_mosi_o),
      .flash_miso_i(flash_miso_i),
      .run_switch_i(run_switch_i),
      .upper_rx_i  (upper_rx_i),
      .upper_tx_o  (upper_tx_o),
      .lower_rx_i  (lower_rx_i),
      .lower_tx_o  (lower_tx_o),
      .panel_rx_i  (panel_rx_i),
      .panel_tx_o  (panel_tx_o),
      .panel_de_o  (panel_de_o),
      .run_o       (run_o),
      .fault_o     (fault_o),
      .forced_o    (forced_o),
      .line_o      (line_o)
  );

endmodule
`default_nettype wire

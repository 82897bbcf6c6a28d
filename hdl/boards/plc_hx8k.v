// SPDX-License-Identifier: Apache-2.0
// The controller on an iCE40-HX8K breakout board, from the board's 12 MHz, with MPU2: MPU3 alone takes 30 of
// the 32 block RAMs. in_i and out_o are the pins of hdl/isa/boards.toml in their order; all pins are in
// constraints/plc_hx8k.pcf.
// Host: USB serial, host_de_o for an RS-485 driver beside it. Lamps: D2 run, D3 fault, D4 forced, D5 host line.
// The board has no switch: run_switch_i is a header pin with a pull-up, so that an open pin is RUN.
// An iCE40's block RAMs cannot be read in the first microseconds, which the reset outlasts (341 us).
`default_nettype none
`include "rung_isa.vh"
`include "rung_controller.vh"

module plc_hx8k (
    input  wire        clk_12mhz_i,
    input  wire [ 7:0] in_i,
    output wire [11:0] out_o,
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
    // flash
    output wire        flash_csn_o,
    output wire        flash_sck_o,
    output wire        flash_mosi_o,
    input  wire        flash_miso_i
);

  wire rst_n;

  power_on_reset #(
      .LONGER(12)
  ) power_on_reset (
      .clk_i (clk_12mhz_i),
      .rst_no(rst_n)
  );

  controller #(
      .MPU(2),
      .CLOCK_HZ(`RUNG_HX8K_CLOCK_HZ),
      .CLOCKS_PER_MS(`RUNG_HX8K_CLOCK_HZ / 1000),
      `RUNG_HX8K_MAP,
      `RUNG_BOARD_HX8K,
      `RUNG_HX8K_MPU2
  ) controller (
      .clk_i       (clk_12mhz_i),
      .rst_ni      (rst_n),
      .in_i        (in_i),
      .out_o       (out_o),
      .adc_i       (128'd0),
      .pwm_o       (pwm_o),
      .rx_i        (rx_i),
      .tx_o        (tx_o),
      .host_rx_i   (host_rx_i),
      .host_tx_o   (host_tx_o),
      .host_de_o   (host_de_o),
      .flash_csn_o (flash_csn_o),
      .flash_sck_o (flash_sck_o),
      .flash_mosi_o(flash_mosi_o),
      .flash_miso_i(flash_miso_i),
      .run_switch_i(run_switch_i),
      .upper_rx_i  (1'b1),
      .lower_rx_i  (1'b1),
      .panel_rx_i  (1'b1),
      // verilator lint_off PINCONNECTEMPTY
      .upper_tx_o  (),
      .lower_tx_o  (),
      .panel_tx_o  (),
      .panel_de_o  (),
      // verilator lint_on PINCONNECTEMPTY
      .run_o       (run_o),
      .fault_o     (fault_o),
      .forced_o    (forced_o),
      .line_o      (line_o)
  );

endmodule
`default_nettype wire

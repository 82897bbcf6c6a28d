// SPDX-License-Identifier: Apache-2.0
// The controller on a Tang Nano 20K (GW2AR-18), from the board's 27 MHz. in_i and out_o are the pins of
// hdl/isa/boards.toml in their order; all pins are in constraints/plc_tangnano20k.cst.
// Host: USB serial, host_de_o for an RS-485 driver beside it. Lamps: LED 5 run, 4 fault, 3 forced, 2 host line.
// The LEDs light at 0, so those of the outputs and the lamps are inverted here: for a program 1 is light.
// run_switch_i is a header pin with a pull-up, so that an open pin is RUN.
`default_nettype none
`include "rung_isa.vh"
`include "rung_controller.vh"

module plc_tangnano20k (
    input  wire       clk_27mhz_i,
    input  wire [5:0] in_i,
    output wire [7:0] out_o,
    input  wire       run_switch_i,
    output wire       run_no,
    output wire       fault_no,
    output wire       forced_no,
    output wire       line_no,
    // host
    input  wire       host_rx_i,
    output wire       host_tx_o,
    output wire       host_de_o,
    // the program's own UART and PWM
    input  wire       rx_i,
    output wire       tx_o,
    output wire       pwm_o,
    // flash
    output wire       flash_csn_o,
    output wire       flash_sck_o,
    output wire       flash_mosi_o,
    input  wire       flash_miso_i
);

  localparam [7:0] LEDS = 8'h03;

  wire rst_n;
  wire [7:0] out;
  wire run;
  wire fault;
  wire forced;
  wire line;

  assign out_o = out ^ LEDS;
  assign {run_no, fault_no, forced_no, line_no} = ~{run, fault, forced, line};

  power_on_reset #(
      .LONGER(12)
  ) power_on_reset (
      .clk_i (clk_27mhz_i),
      .rst_no(rst_n)
  );

  controller #(
      .MPU(2),
      .CLOCK_HZ(`RUNG_GW2A_CLOCK_HZ),
      .CLOCKS_PER_MS(`RUNG_GW2A_CLOCK_HZ / 1000),
      `RUNG_GW2A_MAP,
      `RUNG_BOARD_TANGNANO20K,
      `RUNG_GW2A_MPU2
  ) controller (
      .clk_i       (clk_27mhz_i),
      .rst_ni      (rst_n),
      .in_i        (in_i),
      .out_o       (out),
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
      .run_o       (run),
      .fault_o     (fault),
      .forced_o    (forced),
      .line_o      (line)
  );

endmodule
`default_nettype wire

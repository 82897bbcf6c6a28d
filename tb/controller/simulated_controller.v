// SPDX-License-Identifier: Apache-2.0
// The controller as `rung device` and the tests run it: BOARD 0 is the board `simulated` of
// hdl/isa/boards.toml (MPU3, sizes of the ECP5), BOARD 2 the iCE40-HX8K breakout's (MPU2). Its clock is
// scaled: a millisecond has CLOCKS_PER_MS clocks, and every rate follows from it.
// Pins that the board does not have are left open. baud_step_o and parity_o are what the host UART is set
// to, for a client whose line always has the controller's rate.
`default_nettype none
`include "rung_isa.vh"
`include "rung_controller.vh"

module simulated_controller #(
    parameter integer BOARD         = 0,
    parameter integer CLOCKS_PER_MS = 250
) (
    input  wire         clk_i,
    input  wire         rst_ni,
    // plant
    // verilator lint_off UNUSEDSIGNAL
    input  wire [ 63:0] in_i,
    // verilator lint_on UNUSEDSIGNAL
    output wire [ 63:0] out_o,
    input  wire [127:0] adc_i,
    output wire         pwm_o,
    input  wire         rx_i,
    output wire         tx_o,
    // host line
    input  wire         host_rx_i,
    output wire         host_tx_o,
    output wire         host_de_o,
    output wire [ 19:0] baud_step_o,
    output wire [  1:0] parity_o,
    // flash
    output wire         flash_csn_o,
    output wire         flash_sck_o,
    output wire         flash_mosi_o,
    input  wire         flash_miso_i,
    // operation; latch_o is 1 in the clock in which a scan begins
    output wire         latch_o,
    input  wire         run_switch_i,
    output wire         run_o,
    output wire         fault_o,
    output wire         forced_o,
    output wire         line_o
);

  generate
    if (BOARD == 0) begin : gen_simulated
      controller #(
          .MPU(3),
          .CLOCK_HZ(1000 * CLOCKS_PER_MS),
          .CLOCKS_PER_MS(CLOCKS_PER_MS),
          `RUNG_ECP5_MAP,
          `RUNG_BOARD_SIMULATED,
          `RUNG_ECP5_MPU3
      ) controller (
          .clk_i       (clk_i),
          .rst_ni      (rst_ni),
          .in_i        (in_i[`RUNG_BOARD_SIMULATED_INPUTS-1:0]),
          .out_o       (out_o[`RUNG_BOARD_SIMULATED_OUTPUTS-1:0]),
          .adc_i       (adc_i),
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
      assign out_o[63:`RUNG_BOARD_SIMULATED_OUTPUTS] = {64 - `RUNG_BOARD_SIMULATED_OUTPUTS{1'b0}};
      assign latch_o = controller.core.bus.latch;
      assign baud_step_o = controller.host_uart.baud_step_i;
      assign parity_o = controller.host_uart.parity_i;
    end else begin : gen_hx8k
      controller #(
          .MPU(2),
          .CLOCK_HZ(1000 * CLOCKS_PER_MS),
          .CLOCKS_PER_MS(CLOCKS_PER_MS),
          `RUNG_HX8K_MAP,
          `RUNG_BOARD_HX8K,
          `RUNG_HX8K_MPU2
      ) controller (
          .clk_i       (clk_i),
          .rst_ni      (rst_ni),
          .in_i        (in_i[`RUNG_BOARD_HX8K_INPUTS-1:0]),
          .out_o       (out_o[`RUNG_BOARD_HX8K_OUTPUTS-1:0]),
          .adc_i       (adc_i),
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
      assign out_o[63:`RUNG_BOARD_HX8K_OUTPUTS] = {64 - `RUNG_BOARD_HX8K_OUTPUTS{1'b0}};
      assign latch_o = controller.core.bus.latch;
      assign baud_step_o = controller.host_uart.baud_step_i;
      assign parity_o = controller.host_uart.parity_i;
    end
  endgenerate

endmodule
`default_nettype wire

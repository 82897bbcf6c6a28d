// SPDX-License-Identifier: Apache-2.0
// The iCE40-HX8K breakout's controller as simulated_controller.v has it, but for its host UART: bytes of the
// line are ports, so that tests with very many frames spend no clocks on bits.
`default_nettype none
`include "rung_isa.vh"
`include "rung_controller.vh"

module simulated_core #(
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
    output wire [ 19:0] baud_step_o,
    output wire [  1:0] parity_o,
    input  wire         host_rx_active_i,
    input  wire         host_rx_valid_i,
    input  wire [  7:0] host_rx_data_i,
    input  wire         host_rx_error_i,
    output wire         host_tx_valid_o,
    output wire [  7:0] host_tx_data_o,
    input  wire         host_tx_ready_i,
    input  wire         host_tx_busy_i,
    // flash
    output wire         flash_csn_o,
    output wire         flash_sck_o,
    output wire         flash_mosi_o,
    input  wire         flash_miso_i,
    // operation; latch_o is 1 in the clock in which a scan begins
    input  wire         run_switch_i,
    output wire         run_o,
    output wire         fault_o,
    output wire         forced_o,
    output wire         line_o,
    output wire         latch_o
);

  controller_core #(
      .MPU(2),
      .CLOCK_HZ(1000 * CLOCKS_PER_MS),
      .CLOCKS_PER_MS(CLOCKS_PER_MS),
      `RUNG_HX8K_MAP,
      `RUNG_BOARD_HX8K,
      `RUNG_HX8K_MPU2
  ) core (
      .clk_i           (clk_i),
      .rst_ni          (rst_ni),
      .in_i            (in_i[`RUNG_BOARD_HX8K_INPUTS-1:0]),
      .out_o           (out_o[`RUNG_BOARD_HX8K_OUTPUTS-1:0]),
      .adc_i           (adc_i),
      .pwm_o           (pwm_o),
      .rx_i            (rx_i),
      .tx_o            (tx_o),
      .flash_csn_o     (flash_csn_o),
      .flash_sck_o     (flash_sck_o),
      .flash_mosi_o    (flash_mosi_o),
      .flash_miso_i    (flash_miso_i),
      .run_switch_i    (run_switch_i),
      .run_o           (run_o),
      .fault_o         (fault_o),
      .forced_o        (forced_o),
      .line_o          (line_o),
      .baud_step_o     (baud_step_o),
      .parity_o        (parity_o),
      .host_rx_active_i(host_rx_active_i),
      .host_rx_valid_i (host_rx_valid_i),
      .host_rx_data_i  (host_rx_data_i),
      .host_rx_error_i (host_rx_error_i),
      .host_tx_valid_o (host_tx_valid_o),
      .host_tx_data_o  (host_tx_data_o),
      .host_tx_ready_i (host_tx_ready_i),
      .host_tx_busy_i  (host_tx_busy_i)
  );

  assign latch_o = core.bus.latch;
  assign out_o[63:`RUNG_BOARD_HX8K_OUTPUTS] = {64 - `RUNG_BOARD_HX8K_OUTPUTS{1'b0}};

endmodule
`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// A controller with flow tasks as the bench of several units holds it: board `simulated`, MPU3, sizes of the ECP5, a
// millisecond of CLOCKS_PER_MS clocks. filtered_o: the inputs behind their filters. Pins that nothing here uses are idle.
`default_nettype none
`include "rung_isa.vh"
`include "rung_controller.vh"

module flow_unit #(
    parameter integer CLOCKS_PER_MS = 2000
) (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire [ 7:0] in_i,
    output wire [ 7:0] out_o,
    output wire [ 7:0] filtered_o,
    // host line
    input  wire        host_rx_i,
    output wire        host_tx_o,
    output wire [19:0] host_baud_o,
    output wire [ 1:0] host_parity_o,
    // the panel's line
    input  wire        panel_rx_i,
    output wire        panel_tx_o,
    output wire [19:0] panel_baud_o,
    output wire [ 1:0] panel_parity_o,
    // link
    input  wire        upper_rx_i,
    output wire        upper_tx_o,
    input  wire        lower_rx_i,
    output wire        lower_tx_o,
    // flash
    output wire        flash_csn_o,
    output wire        flash_sck_o,
    output wire        flash_mosi_o,
    input  wire        flash_miso_i,
    // operation; latch_o is 1 in the clock in which a round begins
    output wire        latch_o,
    output wire        run_o,
    output wire        fault_o
);

  localparam integer INPUTS = `RUNG_BOARD_SIMULATED_INPUTS;
  localparam integer OUTPUTS = `RUNG_BOARD_SIMULATED_OUTPUTS;
  // verilator lint_off UNUSEDSIGNAL
  wire [OUTPUTS-1:0] outputs;
  wire [INPUTS-1:0] filtered = controller.core.bus.input_pins.value;
  // verilator lint_on UNUSEDSIGNAL
  assign out_o = outputs[7:0];
  assign filtered_o = filtered[7:0];
  assign latch_o = controller.core.bus.latch;
  assign host_baud_o = controller.host_uart.baud_step_i;
  assign host_parity_o = controller.host_uart.parity_i;
  assign panel_baud_o = controller.core.bus.gen_flow.flow.panel_baud;
  assign panel_parity_o = controller.core.bus.gen_flow.flow.panel_parity;

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
      .in_i        ({{INPUTS - 8{1'b0}}, in_i}),
      .out_o       (outputs),
      .adc_i       (128'd0),
      // verilator lint_off PINCONNECTEMPTY
      .pwm_o       (),
      .tx_o        (),
      .host_de_o   (),
      .panel_de_o  (),
      .forced_o    (),
      .line_o      (),
      // verilator lint_on PINCONNECTEMPTY
      .rx_i        (1'b1),
      .host_rx_i   (host_rx_i),
      .host_tx_o   (host_tx_o),
      .panel_rx_i  (panel_rx_i),
      .panel_tx_o  (panel_tx_o),
      .upper_rx_i  (upper_rx_i),
      .upper_tx_o  (upper_tx_o),
      .lower_rx_i  (lower_rx_i),
      .lower_tx_o  (lower_tx_o),
      .flash_csn_o (flash_csn_o),
      .flash_sck_o (flash_sck_o),
      .flash_mosi_o(flash_mosi_o),
      .flash_miso_i(flash_miso_i),
      .run_switch_i(1'b1),
      .run_o       (run_o),
      .fault_o     (fault_o)
  );

endmodule

`default_nettype wire

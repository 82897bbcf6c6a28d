// SPDX-License-Identifier: Apache-2.0
// The controller: what a board top holds beside reset and clock (README.md).
`default_nettype none

module controller #(
    parameter integer MPU           = 3,
    parameter integer CLOCK_HZ      = 25000000,
    parameter integer CLOCKS_PER_MS = CLOCK_HZ / 1000,
    parameter integer CONFIG_ID     = 1,
    parameter integer BIT_POINTS    = 1024,
    parameter integer WORD_POINTS   = 512,
    parameter integer BOARD_ID      = 0,
    parameter integer INPUTS        = 32,  // at most 64
    parameter integer OUTPUTS       = 32,  // at most 64
    parameter integer FLASH_BASE    = 0,
    parameter integer STEPS         = 256,
    parameter integer BIT_DEVICES   = 1024,
    parameter integer WORD_DEVICES  = 256,
    parameter integer MUL_DSP       = 0,
    parameter integer MUL_LATENCY   = 20,
    parameter integer DIV_LATENCY   = 20,
    parameter integer MUL32_LATENCY = 40,
    parameter integer DIV32_LATENCY = 40
) (
    input  wire               clk_i,
    input  wire               rst_ni,
    // pins of the plant
    input  wire [ INPUTS-1:0] in_i,
    output wire [OUTPUTS-1:0] out_o,
    input  wire [      127:0] adc_i,
    output wire               pwm_o,
    input  wire               rx_i,
    output wire               tx_o,
    // host line
    input  wire               host_rx_i,
    output wire               host_tx_o,
    output wire               host_de_o,
    // flash
    output wire               flash_csn_o,
    output wire               flash_sck_o,
    output wire               flash_mosi_o,
    input  wire               flash_miso_i,
    // operation
    input  wire               run_switch_i,
    output wire               run_o,
    output wire               fault_o,
    output wire               forced_o,
    output wire               line_o
);

  wire [19:0] baud_step;
  wire [1:0] parity;
  wire rx_active, rx_valid, rx_error, tx_valid, tx_ready, tx_busy;
  wire [7:0] rx_data, tx_data;

  host_uart host_uart (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni),
      .baud_step_i(baud_step),
      .parity_i   (parity),
      .rx_i       (host_rx_i),
      .tx_o       (host_tx_o),
      .de_o       (host_de_o),
      .rx_active_o(rx_active),
      .rx_valid_o (rx_valid),
      .rx_data_o  (rx_data),
      .rx_error_o (rx_error),
      .tx_valid_i (tx_valid),
      .tx_data_i  (tx_data),
      .tx_ready_o (tx_ready),
      .tx_busy_o  (tx_busy)
  );

  controller_core #(
      .MPU          (MPU),
      .CLOCK_HZ     (CLOCK_HZ),
      .CLOCKS_PER_MS(CLOCKS_PER_MS),
      .CONFIG_ID    (CONFIG_ID),
      .BIT_POINTS   (BIT_POINTS),
      .WORD_POINTS  (WORD_POINTS),
      .BOARD_ID     (BOARD_ID),
      .INPUTS       (INPUTS),
      .OUTPUTS      (OUTPUTS),
      .FLASH_BASE   (FLASH_BASE),
      .STEPS        (STEPS),
      .BIT_DEVICES  (BIT_DEVICES),
      .WORD_DEVICES (WORD_DEVICES),
      .MUL_DSP      (MUL_DSP),
      .MUL_LATENCY  (MUL_LATENCY),
      .DIV_LATENCY  (DIV_LATENCY),
      .MUL32_LATENCY(MUL32_LATENCY),
      .DIV32_LATENCY(DIV32_LATENCY)
  ) core (
      .clk_i           (clk_i),
      .rst_ni          (rst_ni),
      .in_i            (in_i),
      .out_o           (out_o),
      .adc_i           (adc_i),
      .pwm_o           (pwm_o),
      .rx_i            (rx_i),
      .tx_o            (tx_o),
      .baud_step_o     (baud_step),
      .parity_o        (parity),
      .host_rx_active_i(rx_active),
      .host_rx_valid_i (rx_valid),
      .host_rx_data_i  (rx_data),
      .host_rx_error_i (rx_error),
      .host_tx_valid_o (tx_valid),
      .host_tx_data_o  (tx_data),
      .host_tx_ready_i (tx_ready),
      .host_tx_busy_i  (tx_busy),
      .flash_csn_o     (flash_csn_o),
      .flash_sck_o     (flash_sck_o),
      .flash_mosi_o    (flash_mosi_o),
      .flash_miso_i    (flash_miso_i),
      .run_switch_i    (run_switch_i),
      .run_o           (run_o),
      .fault_o         (fault_o),
      .forced_o        (forced_o),
      .line_o          (line_o)
  );

endmodule

`default_nettype wire

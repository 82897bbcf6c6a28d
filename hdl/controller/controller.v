// SPDX-License-Identifier: Apache-2.0
// The controller: what a board top holds. README.md says what it does; the lists of parameters are generated
// from hdl/isa: `RUNG_<CONFIG>_MAP, `RUNG_BOARD_<NAME>, `RUNG_<CONFIG>_MPU<n>.
`default_nettype none

module controller #(
    parameter integer MPU           = 2,         // 1, 2 or 3
    parameter integer CLOCK_HZ      = 12000000,  // of clk_i
    parameter integer CLOCKS_PER_MS = CLOCK_HZ / 1000,
    // configuration and board: `RUNG_<CONFIG>_MAP, `RUNG_BOARD_<NAME>
    parameter integer CONFIG_ID     = 2,
    parameter integer BIT_POINTS    = 1024,
    parameter integer WORD_POINTS   = 472,
    parameter integer BOARD_ID      = 0,
    parameter integer INPUTS        = 32,
    parameter integer OUTPUTS       = 32,
    parameter integer FLASH_BASE    = 0,
    parameter integer FLOW          = 0,         // 1: with flow tasks (hdl/flow)
    // the processor's own
    parameter integer STEPS         = 512,
    parameter integer BIT_DEVICES   = 1024,
    parameter integer WORD_DEVICES  = 256,
    parameter integer MUL_DSP       = 0,
    parameter integer MUL_LATENCY   = 18,
    parameter integer DIV_LATENCY   = 19,
    parameter integer MUL32_LATENCY = 34,
    parameter integer DIV32_LATENCY = 37
) (
    input  wire               clk_i,
    input  wire               rst_ni,
    // pins
    input  wire [ INPUTS-1:0] in_i,
    output wire [OUTPUTS-1:0] out_o,
    input  wire [      127:0] adc_i,
    output wire               pwm_o,
    input  wire               rx_i,
    output wire               tx_o,
    output wire               flash_csn_o,
    output wire               flash_sck_o,
    output wire               flash_mosi_o,
    input  wire               flash_miso_i,
    // the host's line; host_de_o: driver enable of RS-485
    input  wire               host_rx_i,
    output wire               host_tx_o,
    output wire               host_de_o,
    // switch
    input  wire               run_switch_i,
    // lines of flow tasks
    input  wire               upper_rx_i,
    output wire               upper_tx_o,
    input  wire               lower_rx_i,
    output wire               lower_tx_o,
    input  wire               panel_rx_i,
    output wire               panel_tx_o,
    output wire               panel_de_o,
    // lamps
    output wire               run_o,
    output wire               fault_o,
    output wire               forced_o,
    output wire               line_o
);

  wire [19:0] baud_step;
  wire [1:0] parity;
  wire host_rx_active;
  wire host_rx_valid;
  wire [7:0] host_rx_data;
  wire host_rx_error;
  wire host_tx_valid;
  wire [7:0] host_tx_data;
  wire host_tx_ready;
  wire host_tx_busy;

  host_uart host_uart (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni),
      .baud_step_i(baud_step),
      .parity_i   (parity),
      .rx_i       (host_rx_i),
      .tx_o       (host_tx_o),
      .de_o       (host_de_o),
      .rx_active_o(host_rx_active),
      .rx_valid_o (host_rx_valid),
      .rx_data_o  (host_rx_data),
      .rx_error_o (host_rx_error),
      .tx_valid_i (host_tx_valid),
      .tx_data_i  (host_tx_data),
      .tx_ready_o (host_tx_ready),
      .tx_busy_o  (host_tx_busy)
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
      .FLOW         (FLOW),
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
      .flash_csn_o     (flash_csn_o),
      .flash_sck_o     (flash_sck_o),
      .flash_mosi_o    (flash_mosi_o),
      .flash_miso_i    (flash_miso_i),
      .run_switch_i    (run_switch_i),
      .upper_rx_i      (upper_rx_i),
      .upper_tx_o      (upper_tx_o),
      .lower_rx_i      (lower_rx_i),
      .lower_tx_o      (lower_tx_o),
      .panel_rx_i      (panel_rx_i),
      .panel_tx_o      (panel_tx_o),
      .panel_de_o      (panel_de_o),
      .run_o           (run_o),
      .fault_o         (fault_o),
      .forced_o        (forced_o),
      .line_o          (line_o),
      .baud_step_o     (baud_step),
      .parity_o        (parity),
      .host_rx_active_i(host_rx_active),
      .host_rx_valid_i (host_rx_valid),
      .host_rx_data_i  (host_rx_data),
      .host_rx_error_i (host_rx_error),
      .host_tx_valid_o (host_tx_valid),
      .host_tx_data_o  (host_tx_data),
      .host_tx_ready_i (host_tx_ready),
      .host_tx_busy_i  (host_tx_busy)
  );

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// A controller without the UART of its host's line, whose bytes are ports: all on the micro-sequencer's bus,
// and the micro-sequencer.
`default_nettype none

module controller_core #(
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
    output wire               line_o,
    // bytes of the host's line
    output wire [       19:0] baud_step_o,
    output wire [        1:0] parity_o,
    input  wire               host_rx_active_i,
    input  wire               host_rx_valid_i,
    input  wire [        7:0] host_rx_data_i,
    input  wire               host_rx_error_i,
    output wire               host_tx_valid_o,
    output wire [        7:0] host_tx_data_o,
    input  wire               host_tx_ready_i,
    input  wire               host_tx_busy_i
);

  wire [15:0] mem_addr;
  wire mem_read;
  wire mem_write;
  wire [15:0] mem_wdata;
  wire [15:0] mem_rdata;

  micro_sequencer #(
      .CONFIG_ID(CONFIG_ID)
  ) micro (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni),
      .mem_addr_o (mem_addr),
      .mem_read_o (mem_read),
      .mem_write_o(mem_write),
      .mem_wdata_o(mem_wdata),
      .mem_rdata_i(mem_rdata)
  );

  controller_bus #(
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
  ) bus (
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
      .baud_step_o     (baud_step_o),
      .parity_o        (parity_o),
      .host_rx_active_i(host_rx_active_i),
      .host_rx_valid_i (host_rx_valid_i),
      .host_rx_data_i  (host_rx_data_i),
      .host_rx_error_i (host_rx_error_i),
      .host_tx_valid_o (host_tx_valid_o),
      .host_tx_data_o  (host_tx_data_o),
      .host_tx_ready_i (host_tx_ready_i),
      .host_tx_busy_i  (host_tx_busy_i),
      .mem_addr_i      (mem_addr),
      .mem_read_i      (mem_read),
      .mem_write_i     (mem_write),
      .mem_wdata_i     (mem_wdata),
      .mem_rdata_o     (mem_rdata)
  );

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// Bench top: MPU1 in the `hx8k` configuration behind its port exchange, whose other sides are the
// test's.
`default_nettype none
`include "rung_isa.vh"

module port_bench #(
    parameter integer BIT_DEVICES  = 1024,
    parameter integer WORD_DEVICES = 256
) (
    input  wire         clk_i,
    input  wire         rst_ni,
    input  wire         scan_i,
    output wire         busy_o,
    output wire         done_o,
    output wire [ 31:0] clocks_o,
    input  wire [  1:0] port_bits_i,
    input  wire [  6:0] port_words_i,
    input  wire         rx_valid_i,
    input  wire [  7:0] rx_data_i,
    output wire         rx_lost_o,
    input  wire         tx_ready_i,
    output wire         tx_valid_o,
    output wire [  7:0] tx_data_o,
    output wire [ 15:0] pwm_duty_o,
    output wire [ 31:0] pwm_hz_o,
    input  wire [127:0] adc_i,
    input  wire         persist_ready_i,
    output wire         keep_valid_o,
    output wire [  5:0] keep_index_o,
    output wire [ 15:0] keep_value_o,
    input  wire         restore_valid_i,
    output wire         restore_ready_o,
    input  wire [  5:0] restore_index_i,
    input  wire [ 15:0] restore_value_i,
    input  wire         host_valid_i,
    output wire         host_ready_o,
    input  wire         host_write_i,
    input  wire [  2:0] host_space_i,
    input  wire [ 19:0] host_addr_i,
    input  wire [ 15:0] host_data_i,
    output wire         host_rvalid_o,
    output wire [ 15:0] host_rdata_o,
    // between exchange and processor, for the test to count clocks
    output wire         start_o,
    output wire         processor_done_o
);

  wire        load_valid;
  wire        load_write;
  wire [ 2:0] load_space;
  wire [19:0] load_addr;
  wire [15:0] load_data;
  wire        load_rvalid;
  wire [15:0] load_rdata;

  port_exchange #(
      .BIT_DEVICES (BIT_DEVICES),
      .WORD_DEVICES(WORD_DEVICES)
  ) exchange (
      .clk_i          (clk_i),
      .rst_ni         (rst_ni),
      .scan_i         (scan_i),
      .busy_o         (busy_o),
      .done_o         (done_o),
      .port_bits_i    (port_bits_i),
      .port_words_i   (port_words_i),
      .rx_valid_i     (rx_valid_i),
      .rx_data_i      (rx_data_i),
      .rx_lost_o      (rx_lost_o),
      .tx_ready_i     (tx_ready_i),
      .tx_valid_o     (tx_valid_o),
      .tx_data_o      (tx_data_o),
      .pwm_duty_o     (pwm_duty_o),
      .pwm_hz_o       (pwm_hz_o),
      .adc_i          (adc_i),
      .persist_ready_i(persist_ready_i),
      .keep_valid_o   (keep_valid_o),
      .keep_index_o   (keep_index_o),
      .keep_value_o   (keep_value_o),
      .restore_valid_i(restore_valid_i),
      .restore_ready_o(restore_ready_o),
      .restore_index_i(restore_index_i),
      .restore_value_i(restore_value_i),
      .host_valid_i   (host_valid_i),
      .host_ready_o   (host_ready_o),
      .host_write_i   (host_write_i),
      .host_space_i   (host_space_i),
      .host_addr_i    (host_addr_i),
      .host_data_i    (host_data_i),
      .host_rvalid_o  (host_rvalid_o),
      .host_rdata_o   (host_rdata_o),
      .start_o        (start_o),
      .done_i         (processor_done_o),
      .load_valid_o   (load_valid),
      .load_write_o   (load_write),
      .load_space_o   (load_space),
      .load_addr_o    (load_addr),
      .load_data_o    (load_data),
      .load_rvalid_i  (load_rvalid),
      .load_rdata_i   (load_rdata)
  );

  mpu1 #(
      `RUNG_HX8K_MPU1
  ) mpu (
      .clk_i        (clk_i),
      .rst_ni       (rst_ni),
      .start_i      (start_o),
      .done_o       (processor_done_o),
      // verilator lint_off PINCONNECTEMPTY
      .busy_o       (),
      .error_o      (),
      // verilator lint_on PINCONNECTEMPTY
      .clocks_o     (clocks_o),
      .range_i      (1'b0),
      .entry_i      (16'd0),
      .end_i        (16'd0),
      // verilator lint_off PINCONNECTEMPTY
      .write_valid_o(),
      .write_addr_o (),
      .write_data_o (),
      // verilator lint_on PINCONNECTEMPTY
      .load_valid_i (load_valid),
      .load_write_i (load_write),
      .load_space_i (load_space),
      .load_addr_i  (load_addr),
      .load_data_i  (load_data),
      .load_rvalid_o(load_rvalid),
      .load_rdata_o (load_rdata)
  );

endmodule
`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// The host line as the controller has it: RTU line and UART.
`default_nettype none

module rtu_bench (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        sel_rx_frame_i,
    input  wire        sel_tx_frame_i,
    input  wire        sel_register_i,
    input  wire [ 7:0] addr_i,
    input  wire        read_i,
    input  wire        write_i,
    input  wire [15:0] wdata_i,
    output wire [15:0] rdata_o,
    input  wire        rx_i,
    output wire        tx_o,
    output wire        de_o,
    output wire        active_o
);

  wire [19:0] baud_step;
  wire [1:0] parity;
  wire rx_active;
  wire rx_valid;
  wire [7:0] rx_data;
  wire rx_error;
  wire tx_valid;
  wire [7:0] tx_data;
  wire tx_ready;
  wire tx_busy;

  rtu_line line (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .sel_rx_frame_i(sel_rx_frame_i),
      .sel_tx_frame_i(sel_tx_frame_i),
      .sel_register_i(sel_register_i),
      .addr_i        (addr_i),
      .read_i        (read_i),
      .write_i       (write_i),
      .wdata_i       (wdata_i),
      .rdata_o       (rdata_o),
      .baud_step_o   (baud_step),
      .parity_o      (parity),
      .rx_active_i   (rx_active),
      .rx_valid_i    (rx_valid),
      .rx_data_i     (rx_data),
      .rx_error_i    (rx_error),
      .tx_valid_o    (tx_valid),
      .tx_data_o     (tx_data),
      .tx_ready_i    (tx_ready),
      .tx_busy_i     (tx_busy),
      .active_o      (active_o)
  );

  host_uart uart (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni),
      .baud_step_i(baud_step),
      .parity_i   (parity),
      .rx_i       (rx_i),
      .tx_o       (tx_o),
      .de_o       (de_o),
      .rx_active_o(rx_active),
      .rx_valid_o (rx_valid),
      .rx_data_o  (rx_data),
      .rx_error_o (rx_error),
      .tx_valid_i (tx_valid),
      .tx_data_i  (tx_data),
      .tx_ready_o (tx_ready),
      .tx_busy_o  (tx_busy)
  );

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// UART of the host line: 8 bits, parity_i 0 (none), 1 (odd) or 2 (even). As Modbus has it, a character
// is 11 bits: without parity it is sent with two stop bits; one is enough in what is received.
// baud_step_i as in uart_tx.v, 13 clocks a bit and more, a client 2 % off.
// rx_valid_o is 1 for a clock when a byte is in rx_data_o, rx_error_o instead of it when its stop bit or
// parity was wrong. rx_active_o is 1 while a byte comes in, from the middle of its start bit to the clock before
// these, so that counting from there on measures the silence between bytes, to an eighth of a bit.
// A byte is sent when tx_valid_i and tx_ready_o are both 1; one that waits follows without a gap. de_o enables
// an RS-485 driver: 1 from the clock before the first start bit to the clock after the last stop bit.
`default_nettype none

module host_uart (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire [19:0] baud_step_i,
    input  wire [ 1:0] parity_i,
    // pins
    input  wire        rx_i,
    output wire        tx_o,
    output wire        de_o,
    // bytes received
    output wire        rx_active_o,
    output wire        rx_valid_o,
    output wire [ 7:0] rx_data_o,
    output wire        rx_error_o,
    // bytes to send
    input  wire        tx_valid_i,
    input  wire [ 7:0] tx_data_i,
    output wire        tx_ready_o,
    output wire        tx_busy_o
);

  wire framing_error;
  wire parity_error;
  wire sending;

  uart_rx receiver (
      .clk_i          (clk_i),
      .rst_ni         (rst_ni),
      .baud_step_i    (baud_step_i),
      .parity_i       (parity_i),
      .rx_i           (rx_i),
      .active_o       (rx_active_o),
      .valid_o        (rx_valid_o),
      .data_o         (rx_data_o),
      .framing_error_o(framing_error),
      .parity_error_o (parity_error)
  );

  uart_tx transmitter (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni),
      .baud_step_i(baud_step_i),
      .parity_i   (parity_i),
      .two_stops_i(!(parity_i[1] ^ parity_i[0])),
      .valid_i    (tx_valid_i),
      .data_i     (tx_data_i),
      .ready_o    (tx_ready_o),
      .busy_o     (sending),
      .tx_o       (tx_o)
  );

  // A register of its own: the pin must not glitch from one byte to the next.
  reg de_q;

  always @(posedge clk_i) begin
    if (!rst_ni) de_q <= 1'b0;
    else de_q <= sending || (tx_valid_i && tx_ready_o);
  end

  assign rx_error_o = framing_error || parity_error;
  assign tx_busy_o = de_q;
  assign de_o = de_q;

endmodule

`default_nettype wire

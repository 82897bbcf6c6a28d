// SPDX-License-Identifier: Apache-2.0
// In the place of hdl/controller/host_uart.v, with its contract, for tests with very many frames: a byte on a
// line is ten clocks, one a bit: a start bit 0, eight bits, the lowest first, and a 1, or a 0 for a byte that is
// an error. Rate and parity mean nothing. Bytes are to be 16 clocks apart (../fast_line.hpp), as rtu_line.v needs it.
`default_nettype none

module host_uart (
    input  wire        clk_i,
    input  wire        rst_ni,
    // verilator lint_off UNUSEDSIGNAL
    input  wire [19:0] baud_step_i,
    input  wire [ 1:0] parity_i,
    // verilator lint_on UNUSEDSIGNAL
    input  wire        rx_i,
    output wire        tx_o,
    output wire        de_o,
    output wire        rx_active_o,
    output wire        rx_valid_o,
    output wire [ 7:0] rx_data_o,
    output wire        rx_error_o,
    input  wire        tx_valid_i,
    input  wire [ 7:0] tx_data_i,
    output wire        tx_ready_o,
    output wire        tx_busy_o
);

  reg [3:0] rx_left_q;  // bits that are still to come
  reg [8:0] rx_bits_q;
  reg rx_done_q;
  reg [3:0] tx_left_q;  // clocks until the next byte
  reg [9:0] tx_bits_q;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      rx_left_q <= 4'd0;
      rx_done_q <= 1'b0;
      tx_left_q <= 4'd0;
      tx_bits_q <= 10'h3ff;
    end else begin
      rx_done_q <= rx_left_q == 4'd1;
      if (rx_left_q != 4'd0) begin
        rx_bits_q <= {rx_i, rx_bits_q[8:1]};
        rx_left_q <= rx_left_q - 4'd1;
      end else if (!rx_i) begin
        rx_left_q <= 4'd9;
      end

      tx_bits_q <= {1'b1, tx_bits_q[9:1]};
      if (tx_left_q != 4'd0) begin
        tx_left_q <= tx_left_q - 4'd1;
      end else if (tx_valid_i) begin
        tx_bits_q <= {1'b1, tx_data_i, 1'b0};
        tx_left_q <= 4'd15;
      end
    end
  end

  assign rx_active_o = rx_left_q != 4'd0;
  assign rx_valid_o = rx_done_q && rx_bits_q[8];
  assign rx_error_o = rx_done_q && !rx_bits_q[8];
  assign rx_data_o = rx_bits_q[7:0];
  assign tx_o = tx_bits_q[0];
  assign tx_ready_o = tx_left_q == 4'd0;
  assign tx_busy_o = tx_left_q != 4'd0;
  assign de_o = tx_busy_o;

endmodule

`default_nettype wire

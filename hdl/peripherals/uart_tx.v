// SPDX-License-Identifier: Apache-2.0
// UART transmitter, 8 bits, parity_i 0 (none), 1 (odd) or 2 (even), one stop bit or with two_stops_i two,
// and with one byte of buffer: a byte is taken in the clock in which valid_i and ready_o are both 1, and a
// byte that waits follows the one before it without a gap. busy_o is 1 from the clock after a byte was taken,
// which is one clock before its start bit, until the last stop bit has ended.
// Baud rate: baud_step_i is how much of an eighth of a bit passes in a clock, in units of 2^-20:
// 8 * 2^20 * baud / clock frequency, rounded; the clock must have more than eight times the baud rate.
// A bit's length is right on average to 2^-20 eighths a clock and never more than a clock off;
// it, like the other settings, may change while nothing is sent. After reset, and between bytes, the line is 1.
`default_nettype none

module uart_tx (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire [19:0] baud_step_i,
    input  wire [ 1:0] parity_i,
    input  wire        two_stops_i,
    input  wire        valid_i,
    input  wire [ 7:0] data_i,
    output wire        ready_o,
    output wire        busy_o,
    output wire        tx_o
);

  localparam [3:0] BITS_AFTER_START = 4'd9;  // without parity and second stop bit

  reg next_full_q;
  reg [7:0] next_q;
  reg active_q;
  reg [8:0] shift_q;
  reg [3:0] left_q;
  reg tx_q;
  reg [22:0] phase_q;

  wire with_parity = parity_i[1] ^ parity_i[0];

  // The carry out of eight eighths ends the bit; what is left over counts for the next one.
  wire [23:0] phase = {1'b0, phase_q} + {4'd0, baud_step_i};
  wire bit_end = active_q && phase[23];
  wire load = next_full_q && (!active_q || (bit_end && left_q == 4'd0));

  always @(posedge clk_i) begin
    if (!active_q) phase_q <= 23'd0;
    else phase_q <= phase[22:0];

    if (valid_i && ready_o) next_q <= data_i;

    if (!rst_ni) begin
      next_full_q <= 1'b0;
      active_q <= 1'b0;
      tx_q <= 1'b1;
    end else begin
      if (valid_i && ready_o) next_full_q <= 1'b1;
      else if (load) next_full_q <= 1'b0;
      if (load) begin
        active_q <= 1'b1;
        tx_q <= 1'b0;
        shift_q <= {with_parity ? ^next_q ^ parity_i[0] : 1'b1, next_q};
        left_q <= BITS_AFTER_START + {3'd0, with_parity} + {3'd0, two_stops_i};
      end else if (bit_end) begin
        active_q <= left_q != 4'd0;
        tx_q <= shift_q[0];
        shift_q <= {1'b1, shift_q[8:1]};
        left_q <= left_q - 4'd1;
      end
    end
  end

  assign ready_o = !next_full_q;
  assign busy_o  = next_full_q || active_q;
  assign tx_o = tx_q;

endmodule

`default_nettype wire

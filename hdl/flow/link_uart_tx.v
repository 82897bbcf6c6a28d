// SPDX-License-Identifier: Apache-2.0
// UART transmitter of the link between units: 8 bits, no parity, one stop bit, DIVISOR clocks a bit. A byte is taken
// in a clock in which valid_i and ready_o are both 1, and follows the one before it without a gap if that has not
// ended. busy_o is 1 from the clock after a byte was taken to the end of the last stop bit.
`default_nettype none

module link_uart_tx #(
    parameter integer DIVISOR = 16
) (
    input  wire       clk_i,
    input  wire       rst_ni,
    input  wire       valid_i,
    input  wire [7:0] data_i,
    output wire       ready_o,
    output wire       busy_o,
    output wire       tx_o
);

  localparam integer BITS = $clog2(DIVISOR);
  // verilator lint_off WIDTH
  localparam [BITS-1:0] BIT_END = DIVISOR - 1;
  // verilator lint_on WIDTH
  localparam [3:0] BITS_AFTER_START = 4'd9;

  reg full_q;
  reg [7:0] next_q;
  reg active_q;
  reg [8:0] shift_q;
  reg [3:0] left_q;
  reg [BITS-1:0] phase_q;
  reg tx_q;

  wire bit_end = active_q && phase_q == BIT_END;
  wire load = full_q && (!active_q || (bit_end && left_q == 4'd0));

  always @(posedge clk_i) begin
    if (!active_q || bit_end) phase_q <= {BITS{1'b0}};
    else phase_q <= phase_q + {{BITS - 1{1'b0}}, 1'b1};
    if (valid_i && ready_o) next_q <= data_i;

    if (!rst_ni) begin
      full_q <= 1'b0;
      active_q <= 1'b0;
      tx_q <= 1'b1;
    end else begin
      if (valid_i && ready_o) full_q <= 1'b1;
      else if (load) full_q <= 1'b0;
      if (load) begin
        active_q <= 1'b1;
        tx_q <= 1'b0;
        shift_q <= {1'b1, next_q};
        left_q <= BITS_AFTER_START;
      end else if (bit_end) begin
        active_q <= left_q != 4'd0;
        tx_q <= shift_q[0];
        shift_q <= {1'b1, shift_q[8:1]};
        left_q <= left_q - 4'd1;
      end
    end
  end

  assign ready_o = !full_q;
  assign busy_o = full_q || active_q;
  assign tx_o = tx_q;

endmodule

`default_nettype wire

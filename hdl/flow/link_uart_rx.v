// SPDX-License-Identifier: Apache-2.0
// UART receiver of the link between units: 8 bits, no parity, DIVISOR clocks a bit, 6 and more. rx_i is
// asynchronous. Three samples around the middle of each bit decide by majority, an eighth of a bit apart (a clock at
// fewer than 16). The sender's clock may differ by 2 %.
// valid_o is 1 for a clock when a byte is in data_o, error_o instead of it when its stop bit was 0; then the line
// has to be 1 before the next byte. line_o is the line as it is after the input's registers.
`default_nettype none

module link_uart_rx #(
    parameter integer DIVISOR = 16
) (
    input  wire       clk_i,
    input  wire       rst_ni,
    input  wire       rx_i,
    output wire       line_o,
    output wire       valid_o,
    output wire [7:0] data_o,
    output wire       error_o
);

  localparam integer APART = DIVISOR >= 16 ? DIVISOR / 8 : 1;
  localparam integer MIDDLE = DIVISOR / 2;
  localparam integer BITS = $clog2(DIVISOR);
  // verilator lint_off WIDTH
  localparam [BITS-1:0] FIRST_SAMPLE = MIDDLE - APART - 1;
  localparam [BITS-1:0] SECOND_SAMPLE = MIDDLE - 1;
  localparam [BITS-1:0] LAST_SAMPLE = MIDDLE + APART - 1;
  localparam [BITS-1:0] BIT_END = DIVISOR - 1;
  // verilator lint_on WIDTH
  localparam [3:0] START_BIT = 4'd0;
  localparam [3:0] STOP_BIT = 4'd9;

  // Two registers against metastability, one more to see edges.
  reg [2:0] line_q;
  wire line = line_q[1];

  always @(posedge clk_i) begin
    if (!rst_ni) line_q <= 3'b111;
    else line_q <= {line_q[1:0], rx_i};
  end

  reg active_q;
  reg [BITS-1:0] phase_q;
  reg [1:0] samples_q;
  reg [3:0] bit_q;
  reg [7:0] shift_q;
  reg valid_q;
  reg error_q;

  wire sample = phase_q == FIRST_SAMPLE || phase_q == SECOND_SAMPLE;
  wire decide = active_q && phase_q == LAST_SAMPLE;
  wire majority = (samples_q[1] && samples_q[0]) || (line && (samples_q[1] || samples_q[0]));

  always @(posedge clk_i) begin
    if (!active_q) begin
      phase_q <= {BITS{1'b0}};
      bit_q   <= START_BIT;
    end else begin
      phase_q <= phase_q == BIT_END ? {BITS{1'b0}} : phase_q + {{BITS - 1{1'b0}}, 1'b1};
      if (decide) bit_q <= bit_q + 4'd1;
    end
    if (sample) samples_q <= {samples_q[0], line};
    if (decide && bit_q != STOP_BIT) shift_q <= {majority, shift_q[7:1]};

    if (!rst_ni) begin
      active_q <= 1'b0;
      valid_q <= 1'b0;
      error_q <= 1'b0;
    end else begin
      if (!active_q) active_q <= line_q[2] && !line;
      else if (decide) active_q <= bit_q == START_BIT ? !majority : bit_q != STOP_BIT;
      valid_q <= decide && bit_q == STOP_BIT && majority;
      error_q <= decide && bit_q == STOP_BIT && !majority;
    end
  end

  assign line_o  = line;
  assign valid_o = valid_q;
  assign data_o  = shift_q;
  assign error_o = error_q;

endmodule

`default_nettype wire

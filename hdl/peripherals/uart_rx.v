// SPDX-License-Identifier: Apache-2.0
// UART receiver, 8 bits, parity_i 0 (none), 1 (odd) or 2 (even), one stop bit or more. baud_step_i as in
// uart_tx.v. rx_i is asynchronous. Three samples of each bit, an eighth of a bit apart around its
// middle, decide by majority, so a disturbance shorter than that cannot change a bit; a start bit that is 1
// after an eighth or at its middle was none. The sender's baud rate may differ by 2 %, at 13 clocks a
// bit and more.
// valid_o is 1 for one clock when a byte is in data_o, which then stays until the next; framing_error_o
// is 1 for one clock instead when the stop bit was 0, and the receiver waits for the line to be 1
// again; parity_error_o is 1 for one clock instead when only the parity was wrong. All come within the stop
// bit, so that the next byte may follow at once. active_o is 1 from the middle of a start bit, where it is sure
// to be one, to the clock before these.
`default_nettype none

module uart_rx (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire [19:0] baud_step_i,
    input  wire [ 1:0] parity_i,
    input  wire        rx_i,
    output wire        active_o,
    output wire        valid_o,
    output wire [ 7:0] data_o,
    output wire        framing_error_o,
    output wire        parity_error_o
);

  localparam [2:0] LAST_SAMPLE = 3'd4;  // at the end of this eighth; the others one and two before
  localparam [3:0] START_BIT = 4'd0;
  localparam [3:0] AFTER_DATA = 4'd9;  // the parity bit, else the stop bit

  // Two registers against metastability, one more to see edges.
  reg [2:0] line_q;
  wire line = line_q[1];
  wire falls = line_q[2] && !line_q[1];

  always @(posedge clk_i) begin
    if (!rst_ni) line_q <= 3'b111;
    else line_q <= {line_q[1:0], rx_i};
  end

  reg active_q;
  reg [2:0] eighth_q;
  reg [19:0] phase_q;
  reg [1:0] samples_q;
  reg [3:0] bit_q;
  reg [7:0] shift_q;
  reg [7:0] data_q;
  reg valid_q;
  reg framing_error_q;
  reg parity_wrong_q;
  reg parity_error_q;

  wire with_parity = parity_i[1] ^ parity_i[0];
  wire parity_bit = with_parity && bit_q == AFTER_DATA;
  wire stop_bit = bit_q == (with_parity ? AFTER_DATA + 4'd1 : AFTER_DATA);
  wire [20:0] phase = {1'b0, phase_q} + {1'b0, baud_step_i};
  wire tick = phase[20];
  wire decide = active_q && tick && eighth_q == LAST_SAMPLE;
  // A short pulse is dropped early: it must not hide the edge of a start bit that follows it.
  wire pulse = tick && eighth_q == 3'd0 && bit_q == START_BIT && line;
  wire majority = (samples_q[1] && samples_q[0]) || (line && (samples_q[1] || samples_q[0]));

  always @(posedge clk_i) begin
    if (!active_q) begin
      phase_q  <= 20'd0;
      eighth_q <= 3'd0;
      bit_q <= START_BIT;
    end else begin
      phase_q <= phase[19:0];
      if (tick) begin
        eighth_q  <= eighth_q + 3'd1;
        samples_q <= {samples_q[0], line};
      end
      if (decide) begin
        bit_q   <= bit_q + 4'd1;
        if (parity_bit) parity_wrong_q <= ^shift_q ^ majority ^ parity_i[0];
        else shift_q <= {majority, shift_q[7:1]};
      end
    end
    if (decide && stop_bit) data_q <= shift_q;

    if (!rst_ni) begin
      active_q <= 1'b0;
      valid_q <= 1'b0;
      framing_error_q <= 1'b0;
      parity_error_q <= 1'b0;
    end else begin
      if (!active_q) active_q <= falls;
      else if (pulse) active_q <= 1'b0;
      else if (decide) active_q <= bit_q == START_BIT ? !majority : !stop_bit;
      valid_q <= decide && stop_bit && majority && !(with_parity && parity_wrong_q);
      framing_error_q <= decide && stop_bit && !majority;
      parity_error_q <= decide && stop_bit && majority && with_parity && parity_wrong_q;
    end
  end

  assign active_o = active_q && bit_q != START_BIT;
  assign valid_o = valid_q;
  assign data_o = data_q;
  assign framing_error_o = framing_error_q;
  assign parity_error_o = parity_error_q;

endmodule

`default_nettype wire

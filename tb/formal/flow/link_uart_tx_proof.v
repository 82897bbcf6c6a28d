// SPDX-License-Identifier: Apache-2.0
// UART transmitter of the link (hdl/flow/link_uart_tx.v): each byte that is taken leaves once and in its order, as a start bit,
// eight bits, lowest first, and a stop bit, DIVISOR clocks each, to the clock; one that waits follows without a gap.
`default_nettype none

module link_uart_tx_proof #(
    parameter integer DIVISOR = 16
) (
    input wire       clk_i,
    input wire       rst_ni,
    input wire       valid_i,
    input wire [7:0] data_i
);

  wire ready, busy, tx;
  link_uart_tx #(
      .DIVISOR(DIVISOR)
  ) uart (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .valid_i(valid_i),
      .data_i (data_i),
      .ready_o(ready),
      .busy_o (busy),
      .tx_o   (tx)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  // The byte on the line, its bit and the bit's clock; the byte that waits.
  localparam integer LAST = DIVISOR - 1;
  reg sends_q;
  reg [7:0] byte_q;
  reg [3:0] bit_q;
  reg [7:0] clock_q;
  reg waits_q;
  reg [7:0] next_q;
  wire ends = sends_q && bit_q == 4'd9 && clock_q == LAST[7:0];
  wire goes = waits_q && (!sends_q || ends);
  wire takes = valid_i && !waits_q;

  always @(posedge clk_i) begin
    if (!rst_ni) {sends_q, waits_q} <= 2'b00;
    else begin
      waits_q <= takes || (waits_q && !goes);
      sends_q <= goes || (sends_q && !ends);
    end
    if (takes) next_q <= data_i;
    if (goes) begin
      byte_q  <= next_q;
      bit_q   <= 4'd0;
      clock_q <= 8'd0;
    end else if (clock_q == LAST[7:0]) begin
      bit_q   <= bit_q + 4'd1;
      clock_q <= 8'd0;
    end else begin
      clock_q <= clock_q + 8'd1;
    end
  end

  wire [9:0] frame = {1'b1, byte_q, 1'b0};
  always @* begin
    if (begun_q) begin
      assert (ready == !waits_q);
      assert (busy == (waits_q || sends_q));
      assert (tx == (!sends_q || frame[bit_q]));
    end
  end

  // For the induction.
  (* hierconn *) wire [8:0] \uart.shift_q ;
  (* hierconn *) wire [3:0] \uart.left_q ;
  (* hierconn *) wire [$clog2(DIVISOR)-1:0] \uart.phase_q ;
  (* hierconn *) wire \uart.active_q ;
  (* hierconn *) wire \uart.full_q ;
  (* hierconn *) wire [7:0] \uart.next_q ;
  wire [17:0] rest = {10'h3ff, byte_q} >> bit_q;
  always @* begin
    if (begun_q) begin
      assert (\uart.active_q == sends_q);
      assert (\uart.full_q == waits_q);
      if (waits_q) assert (\uart.next_q == next_q);
      if (sends_q) begin
        assert (bit_q <= 4'd9 && clock_q < DIVISOR);
        assert (\uart.left_q == 4'd9 - bit_q);
        assert (\uart.phase_q == clock_q);
        assert (\uart.shift_q == rest[8:0]);
      end
    end
  end

  always @* cover (begun_q && sends_q && byte_q == 8'h5b && bit_q == 4'd1 && waits_q && !ready);

endmodule

`default_nettype wire

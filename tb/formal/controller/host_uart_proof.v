// SPDX-License-Identifier: Apache-2.0
// Driver of the host's line (hdl/controller/host_uart.v, de_o): enabled from the clock before the first start bit, through every bit
// of every character, whose 11 bits have a parity bit or a second stop bit, and of those that follow without a gap, to
// the clock after the last stop bit, and never else: whoever else is on the line has it from then on. For any rate, parity and bytes.
`default_nettype none

module host_uart_proof (
    input wire       clk_i,
    input wire       rst_ni,
    input wire       rx_i,
    input wire       valid_i,
    input wire [7:0] data_i
);

  (* anyconst *) wire [19:0] step;
  (* anyconst *) wire [1:0] parity;
`ifdef RUNG_NARROW
  always @* assume (step == 20'd1048575 && data_i == 8'h5b);
`endif
  wire tx, de, rx_active, rx_valid, rx_error, ready, busy;
  wire [7:0] rx_data;
  host_uart uart (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni),
      .baud_step_i(step),
      .parity_i   (parity),
      .rx_i       (rx_i),
      .tx_o       (tx),
      .de_o       (de),
      .rx_active_o(rx_active),
      .rx_valid_o (rx_valid),
      .rx_data_o  (rx_data),
      .rx_error_o (rx_error),
      .tx_valid_i (valid_i),
      .tx_data_i  (data_i),
      .tx_ready_o (ready),
      .tx_busy_o  (busy)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  // ---- the character on the line, as in uart_tx_proof; the byte that waits ---------------------------------------
  localparam [3:0] LAST = 4'd10;
  wire with_parity = parity == 2'd1 || parity == 2'd2;
  reg sends_q;
  reg [7:0] byte_q;
  reg [3:0] bit_q;
  reg [23:0] passed_q;
  reg waits_q;
  reg [7:0] next_q;
  reg after_q;  // the clock after a last stop bit
  wire [23:0] passed = passed_q + {4'd0, step};
  wire bit_ends = sends_q && passed >= 24'd8388608;
  wire ends = bit_ends && bit_q == LAST;
  wire goes = waits_q && (!sends_q || ends);
  wire takes = valid_i && !waits_q;

  always @(posedge clk_i) begin
    if (!rst_ni) {sends_q, waits_q, after_q} <= 3'b000;
    else begin
      waits_q <= takes || (waits_q && !goes);
      sends_q <= goes || (sends_q && !ends);
      after_q <= ends && !goes;
    end
    if (takes) next_q <= data_i;
    if (goes) begin
      byte_q <= next_q;
      bit_q  <= 4'd0;
    end else if (bit_ends) begin
      bit_q <= bit_q + 4'd1;
    end
    passed_q <= !sends_q ? 24'd0 : bit_ends ? passed - 24'd8388608 : passed;
  end

  wire [10:0] frame = {1'b1, with_parity ? ^byte_q ^ parity[0] : 1'b1, byte_q, 1'b0};
  reg de_before_q, sends_before_q, reset_q;
  always @(posedge clk_i) {de_before_q, sends_before_q, reset_q} <= {de, sends_q, !rst_ni};
  always @* begin
    if (begun_q) begin
      assert (tx == (!sends_q || frame[bit_q]));
      assert (ready == !waits_q && busy == de);
      if (!tx || sends_q) assert (de && (de_before_q || reset_q));
      if (!sends_q && !waits_q) assert (de == after_q);
      // A byte that waits goes at once if none is on the line: it is enabled for no longer than that clock.
      if (waits_q && !sends_q) assert (de);
      if (de && !de_before_q) assert (waits_q && !sends_q);
      if (de_before_q && !de) assert (reset_q || (!sends_q && !sends_before_q));
      if (reset_q) assert (!de && tx);
    end
  end

  // ---- for the induction -----------------------------------------------------------------------------------------
  (* hierconn *) wire [8:0] \uart.transmitter.shift_q ;
  (* hierconn *) wire [3:0] \uart.transmitter.left_q ;
  (* hierconn *) wire [22:0] \uart.transmitter.phase_q ;
  (* hierconn *) wire \uart.transmitter.active_q ;
  (* hierconn *) wire \uart.transmitter.next_full_q ;
  (* hierconn *) wire [7:0] \uart.transmitter.next_q ;
  wire [19:0] rest = {11'h7ff, frame[9:1]} >> bit_q;
  always @* begin
    if (begun_q) begin
      assert (\uart.transmitter.active_q == sends_q);
      assert (\uart.transmitter.next_full_q == waits_q);
      if (after_q) assert (!sends_q);
      assert (de == (waits_q || sends_q || after_q));
      if (waits_q) assert (\uart.transmitter.next_q == next_q);
      if (sends_q) begin
        assert (bit_q <= LAST && passed_q < 24'd8388608);
        assert (\uart.transmitter.left_q == LAST - bit_q);
        assert (\uart.transmitter.phase_q == passed_q[22:0]);
        assert (\uart.transmitter.shift_q == rest[8:0]);
      end
    end
  end

  reg followed_q;  // a character came behind another one without a gap
  always @(posedge clk_i) followed_q <= begun_q && rst_ni && (followed_q || (ends && goes));
  always @* begin
    cover (begun_q && followed_q && de);
    cover (begun_q && after_q && de && parity == 2'd1);
  end

endmodule

`default_nettype wire

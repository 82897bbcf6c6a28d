// SPDX-License-Identifier: Apache-2.0
// UART transmitter (hdl/peripherals/uart_tx.v), as the host's line and the ladder's have it: each byte that is taken leaves once
// and in its order, as a start bit, eight bits, lowest first, the parity bit if there is one, and one or two stop bits; one
// that waits follows without a gap. In a run of bytes, bit k ends with the clock in which baud_step_i, added up, reaches k + 1
// bits, for any rate.
`default_nettype none

module uart_tx_proof (
    input wire       clk_i,
    input wire       rst_ni,
    input wire       valid_i,
    input wire [7:0] data_i
);

  (* anyconst *) wire [19:0] step;
  (* anyconst *) wire [1:0] parity;
  (* anyconst *) wire two_stops;
  always @* assume (parity != 2'd3);
`ifdef RUNG_NARROW
  always @* assume (step == 20'd524288);
`endif
  wire ready, busy, tx;
  uart_tx uart (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni),
      .baud_step_i(step),
      .parity_i   (parity),
      .two_stops_i(two_stops),
      .valid_i    (valid_i),
      .data_i     (data_i),
      .ready_o    (ready),
      .busy_o     (busy),
      .tx_o       (tx)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  // The byte on the line, its bit and how much of it has passed, in units of 2^-23 bits; the byte that waits.
  wire with_parity = parity != 2'd0;
  wire [3:0] last = 4'd9 + {3'd0, with_parity} + {3'd0, two_stops};
  reg sends_q;
  reg [7:0] byte_q;
  reg [3:0] bit_q;
  reg [23:0] passed_q;
  reg waits_q;
  reg [7:0] next_q;
  wire [23:0] passed = passed_q + {4'd0, step};
  wire bit_ends = sends_q && passed >= 24'd8388608;
  wire ends = bit_ends && bit_q == last;
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
      byte_q <= next_q;
      bit_q  <= 4'd0;
    end else if (bit_ends) begin
      bit_q <= bit_q + 4'd1;
    end
    passed_q <= !sends_q ? 24'd0 : bit_ends ? passed - 24'd8388608 : passed;
  end

  wire [11:0] frame = {2'b11, with_parity ? ^byte_q ^ (parity == 2'd1) : 1'b1, byte_q, 1'b0};
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
  (* hierconn *) wire [22:0] \uart.phase_q ;
  (* hierconn *) wire \uart.active_q ;
  (* hierconn *) wire \uart.next_full_q ;
  (* hierconn *) wire [7:0] \uart.next_q ;
  wire [19:0] rest = {11'h7ff, frame[9:1]} >> bit_q;
  always @* begin
    if (begun_q) begin
      assert (\uart.active_q == sends_q);
      assert (\uart.next_full_q == waits_q);
      if (waits_q) assert (\uart.next_q == next_q);
      if (sends_q) begin
        assert (bit_q <= last && passed_q < 24'd8388608);
        assert (\uart.left_q == last - bit_q);
        assert (\uart.phase_q == passed_q[22:0]);
        assert (\uart.shift_q == rest[8:0]);
      end
    end
  end

  always @* cover (begun_q && sends_q && byte_q == 8'h5b && bit_q == 4'd1 && waits_q && !ready);

endmodule

`default_nettype wire

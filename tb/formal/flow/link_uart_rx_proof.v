// SPDX-License-Identifier: Apache-2.0
// UART receiver of the link (hdl/flow/link_uart_rx.v): each frame on the line gives its byte, once, or an error if its stop bit
// is 0, and nothing else ever gives any; whatever the pauses between frames. The sender's clock may be off: the edge at the end
// of bit i comes up to (5 i + 20) / 16 clocks too early or too late, which is 2 % at 16 clocks a bit, or more; and in each
// bit of data the line may be wrong for one clock.
`default_nettype none

module link_uart_rx_proof (
    input wire       clk_i,
    input wire       rst_ni,
    input wire       send_i,    // a frame begins, if it can
    input wire [7:0] byte_i,
    input wire       stop_i,    // its stop bit
    input wire       edge_i,    // the next bit begins, if it can
    input wire       disturb_i
);

  localparam integer DIVISOR = 16;

  wire valid, error, line_out, line;
  wire [7:0] data;
  link_uart_rx #(
      .DIVISOR(DIVISOR)
  ) uart (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .rx_i   (line),
      .line_o (line_out),
      .valid_o(valid),
      .data_o (data),
      .error_o(error)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* assume (rst_ni == begun_q);

  // ---- the sender --------------------------------------------------------------------------------------
  reg sends_q;
  reg [7:0] byte_q;
  reg stop_q;
  reg [3:0] bit_q;
  reg [7:0] clock_q;  // since the frame's beginning
  reg disturbed_q;  // this bit was
  reg [2:0] idle_q;  // clocks since the last frame's end
  wire [7:0] due = {bit_q, 4'd15};  // nominal last clock of this bit
  wire [3:0] off = (5 * (bit_q + 1) + 15) / 16;
  wire may_end = clock_q + {4'd0, off} >= due;
  wire must_end = clock_q == due + {4'd0, off};
  wire bit_ends = sends_q && (must_end || (may_end && edge_i));
  wire frame_ends = bit_ends && bit_q == 4'd9;
  wire begins = send_i && (sends_q ? frame_ends && stop_q : idle_q >= 3'd3 || stop_q);
  wire of_data = sends_q && bit_q >= 4'd1 && bit_q <= 4'd8;
  wire disturbs = disturb_i && of_data && !disturbed_q;
  wire [9:0] frame = {stop_q, byte_q, 1'b0};
  assign line = (!sends_q || frame[bit_q]) ^ disturbs;

  always @(posedge clk_i) begin
    if (!begun_q) begin
      sends_q <= 1'b0;
      stop_q  <= 1'b0;
      idle_q  <= 3'd0;
    end else begin
      sends_q <= begins || (sends_q && !frame_ends);
      idle_q  <= sends_q ? 3'd0 : idle_q == 3'd7 ? 3'd7 : idle_q + 3'd1;
      if (begins) {byte_q, stop_q} <= {byte_i, stop_i};
    end
    clock_q <= begins ? 8'd0 : clock_q + 8'd1;
    bit_q <= begins ? 4'd0 : bit_q + {3'd0, bit_ends};
    disturbed_q <= !begins && !bit_ends && (disturbed_q || disturbs);
  end

  // ---- the receiver's clock: it sees the edge three clocks later, and is done in the middle of the stop bit ----
  localparam [7:0] DONE = 8'd154;
  localparam [7:0] IDLE = 8'd255;
  reg [2:0] begins_q;
  reg [7:0] seen_q;  // clocks since it saw the last frame's beginning
  reg [7:0] sent_q;
  reg good_q;
  always @(posedge clk_i) begin
    if (!begun_q) begins_q <= 3'd0;
    else begins_q <= {begins_q[1:0], begins};
    if (!begun_q) seen_q <= IDLE;
    else if (begins_q[2]) seen_q <= 8'd0;
    else if (seen_q != IDLE) seen_q <= seen_q + 8'd1;
    if (seen_q == DONE - 8'd4) {sent_q, good_q} <= {byte_q, stop_q};
  end
  wire ends = seen_q == DONE;
  always @* begin
    if (begun_q) begin
      assert (valid == (ends && good_q));
      assert (error == (ends && !good_q));
      if (valid) assert (data == sent_q);
    end
  end

  // ---- for the induction; samples and the line's registers follow from the last clocks --------------------------
  (* hierconn *) wire \uart.active_q ;
  (* hierconn *) wire [3:0] \uart.phase_q ;
  (* hierconn *) wire [3:0] \uart.bit_q ;
  (* hierconn *) wire [7:0] \uart.shift_q ;
  wire [7:0] sent = seen_q > DONE - 8'd4 ? sent_q : byte_q;
  wire [3:0] decided = seen_q[7:4] + {3'd0, seen_q[3:0] > 4'd9};
  wire [3:0] bits = decided == 4'd0 ? 4'd0 : decided - 4'd1;
  always @* begin
    if (begun_q) begin
      assert (\uart.active_q == (seen_q < DONE));
      if (sends_q) begin
        assert (bit_q <= 4'd9);
        assert (clock_q <= due + {4'd0, off});
        if (bit_q != 4'd0) assert (clock_q + 8'd16 + {4'd0, off} > due);
        if (clock_q < 8'd3)
          assert (begins_q == 3'd1 << clock_q && seen_q >= DONE - 8'd1 + clock_q);
          else assert (begins_q == 3'd0 && seen_q == clock_q - 8'd3);
        if (clock_q >= DONE) assert ({sent_q, good_q} == {byte_q, stop_q});
      end else begin
        assert (begins_q == 3'd0);
        assert (seen_q >= DONE - 8'd1 + {5'd0, idle_q});
      end
      if (\uart.active_q ) begin
        assert (\uart.phase_q == seen_q[3:0]);
        assert (\uart.bit_q == decided);
        if (bits != 4'd0)
          assert (((\uart.shift_q >> (4'd8 - bits)) ^ sent) << (4'd8 - bits) == 8'd0);
      end
    end
  end

  always @*
    cover (begun_q && \uart.active_q && \uart.bit_q == 4'd3 && bit_q == 4'd2 && disturbed_q);

endmodule

`default_nettype wire

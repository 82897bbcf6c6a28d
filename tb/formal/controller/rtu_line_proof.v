// SPDX-License-Identifier: Apache-2.0
// RTU line (hdl/controller/rtu_line.v). Receiving: a frame that waits has exactly the bytes that came, in their places, all of
// them good, 4 to 256 in number, after the silence; it stays as it is until it is taken, whatever comes on the line
// meanwhile, and every frame that is not kept is counted. Sending: after line_send exactly its bytes leave, each once and
// in order, and two more, the CRC's; then the line is free again. Any byte of either buffer.
`default_nettype none
`include "rung_controller.vh"

module rtu_line_proof (
    input wire        clk_i,
    input wire        sel_rx_frame_i,
    input wire        sel_tx_frame_i,
    input wire        sel_register_i,
    input wire [ 7:0] addr_i,
    input wire        read_i,
    input wire        write_i,
    input wire [15:0] wdata_i,
    input wire        rx_active_i,
    input wire        rx_valid_i,
    input wire [ 7:0] rx_data_i,
    input wire        rx_error_i,
    input wire        tx_ready_i,
    input wire        tx_busy_i
);

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;

  wire tx_valid, active;
  wire [ 7:0] tx_data;
  wire [15:0] rdata;
  wire [19:0] step;
  wire [ 1:0] parity;
  rtu_line line (
      .clk_i         (clk_i),
      .rst_ni        (begun_q),
      .sel_rx_frame_i(sel_rx_frame_i),
      .sel_tx_frame_i(sel_tx_frame_i),
      .sel_register_i(sel_register_i),
      .addr_i        (addr_i),
      .read_i        (read_i),
      .write_i       (write_i),
      .wdata_i       (wdata_i),
      .rdata_o       (rdata),
      .baud_step_o   (step),
      .parity_o      (parity),
      .rx_active_i   (rx_active_i),
      .rx_valid_i    (rx_valid_i),
      .rx_data_i     (rx_data_i),
      .rx_error_i    (rx_error_i),
      .tx_valid_o    (tx_valid),
      .tx_data_o     (tx_data),
      .tx_ready_i    (tx_ready_i),
      .tx_busy_i     (tx_busy_i),
      .active_o      (active)
  );

  (* hierconn *) wire [8:0] \line.frames.watched ;
  (* hierconn *) wire [7:0] \line.frames.word_q ;
  (* hierconn *) wire [7:0] \line.frames.read_data_q ;
  (* hierconn *) wire [2:0] \line.state_q ;
  (* hierconn *) wire [8:0] \line.index_q ;
  (* hierconn *) wire [7:0] \line.to_send_q ;
  (* hierconn *) wire [7:0] \line.byte_q ;
  (* hierconn *) wire [8:0] \line.length_q ;
  (* hierconn *) wire \line.open_q ;
  (* hierconn *) wire \line.drop_q ;
  (* hierconn *) wire \line.bad_q ;
  (* hierconn *) wire \line.waits_q ;
  (* hierconn *) wire \line.store_q ;
  (* hierconn *) wire \line.byte_in ;
  (* hierconn *) wire \line.silent ;
  (* hierconn *) wire \line.frame_end ;
  (* hierconn *) wire \line.force_sending ;
  (* hierconn *) wire [15:0] \line.bad_crc_q ;
  (* hierconn *) wire [15:0] \line.lost_q ;

  wire register_write = sel_register_i && write_i;
  wire takes = register_write && addr_i == `RUNG_REG_LINE_TAKE;
  wire bus_here = sel_tx_frame_i && write_i && {1'b1, addr_i} == \line.frames.watched ;
  always @* begin
    assume (!(rx_valid_i && rx_error_i) && !(read_i && write_i));
    assume ({1'b0, sel_rx_frame_i} + {1'b0, sel_tx_frame_i} + {1'b0, sel_register_i} <= 2'd1);
    // The firmware only reads rx_frame, and leaves tx_frame alone while it is sent.
    assume (!(sel_rx_frame_i && write_i));
    assume (!(sel_tx_frame_i && (write_i || read_i)) || \line.state_q == 3'd0);
    // The bus leaves the buffers' port a clock within the silence behind a byte.
    assume (!\line.store_q || !\line.silent );
  end

  // ---- the frame that comes: bytes so far, and the watched one ----------------------------------------------
  wire [7:0] place = \line.frames.watched [7:0];
  wire of_rx = !\line.frames.watched [8];
  reg kept_q;  // it is received
  reg spoilt_q;  // a byte was bad, or one too many
  reg [9:0] bytes_q;
  reg [7:0] byte_q;
  wire first = \line.byte_in && !\line.open_q ;
  wire may = !\line.waits_q && \line.state_q == 3'd0;
  wire [9:0] number = first ? 10'd0 : bytes_q;
  always @(posedge clk_i) begin
    if (\line.byte_in ) begin
      if (first) kept_q <= may;
      spoilt_q <= (!first && spoilt_q) || rx_error_i || number > 10'd255;
      if (number != 10'd1023) bytes_q <= number + 10'd1;
      if (number == {2'd0, place}) byte_q <= rx_data_i;
    end
  end

  // ---- the frame that waits -----------------------------------------------------------------------------------
  reg waited_q;
  reg took_q;
  reg [8:0] length_q;
  reg [7:0] word_q;
  reg ended_q;  // one that was kept ended in the clock before
  reg good_q;  // and had only good bytes
  reg [15:0] bad_before_q, lost_before_q;
  reg lost_now_q;
  always @(posedge clk_i) begin
    waited_q <= begun_q && \line.waits_q ;
    took_q <= takes;
    length_q <= \line.length_q ;
    word_q <= \line.frames.word_q ;
    ended_q <= begun_q && (\line.frame_end || (\line.force_sending && \line.open_q )) && kept_q;
    good_q <= !spoilt_q && bytes_q >= 10'd4 && \line.frame_end ;
    bad_before_q <= \line.bad_crc_q ;
    lost_before_q <= \line.lost_q ;
    lost_now_q <= begun_q && first && !may;
  end
  always @* begin
    if (begun_q) begin
      if (waited_q && !took_q) assert (\line.waits_q );
      if (waited_q && \line.waits_q ) begin
        assert (\line.length_q == length_q);
        if (of_rx && {1'b0, place} < length_q) assert (\line.frames.word_q == word_q);
      end
      if (\line.waits_q && !waited_q && began_2_q) begin
        assert (ended_q && good_q);
        assert ({1'b0, \line.length_q } == bytes_q);
        if (of_rx && {2'd0, place} < bytes_q) assert (\line.frames.word_q == byte_q);
      end
      // Whatever was received and is not kept is counted; so is each that was not received.
      if (began_2_q && ended_q) assert (\line.waits_q || \line.bad_crc_q == bad_before_q + 16'd1);
      if (began_2_q) assert (\line.lost_q == lost_before_q + {15'd0, lost_now_q});
    end
  end
  reg began_2_q;
  initial began_2_q = 1'b0;
  always @(posedge clk_i) began_2_q <= begun_q;

  // ---- what is sent -------------------------------------------------------------------------------------------
  reg sends_q;
  reg [8:0] to_send_q;
  reg [8:0] sent_q;
  reg known_q;  // the firmware has written the watched byte
  reg [7:0] out_q;
  wire leaves = tx_valid && tx_ready_i;
  wire send = register_write && addr_i == `RUNG_REG_LINE_SEND && wdata_i != 16'd0 &&
      wdata_i <= 16'd254;
  always @(posedge clk_i) begin
    if (!begun_q) sends_q <= 1'b0;
    else if (!sends_q && send) sends_q <= 1'b1;
    else if (sends_q && sent_q == to_send_q + 9'd2 && !tx_busy_i) sends_q <= 1'b0;
    if (!sends_q && send) {to_send_q, sent_q} <= {wdata_i[8:0], 9'd0};
    else if (leaves) sent_q <= sent_q + 9'd1;
    if (!begun_q) known_q <= 1'b0;
    else if (bus_here) known_q <= 1'b1;
    if (bus_here) out_q <= wdata_i[7:0];
  end
  always @* begin
    if (begun_q) begin
      assert (sends_q == (\line.state_q != 3'd0));
      if (leaves) assert (sends_q && sent_q < to_send_q + 9'd2);
      if (tx_valid && known_q && !of_rx && sent_q == {1'b0, place} && sent_q < to_send_q) begin
        assert (tx_data == out_q);
      end
    end
  end

  // ---- for the induction ----------------------------------------------------------------------------------------
  always @* begin
    if (begun_q) begin
      if (\line.open_q ) begin
        assert (\line.drop_q == !kept_q && bytes_q != 10'd0);
        if (kept_q && !\line.bad_q ) begin
          assert (!spoilt_q && bytes_q <= 10'd256);
          assert ({1'b0, \line.length_q } + {9'd0, \line.store_q } == bytes_q);
          if (of_rx && {1'b0, place} < \line.length_q ) assert (\line.frames.word_q == byte_q);
          if (of_rx && \line.store_q && {1'b0, place} == \line.length_q )
            assert (\line.byte_q == byte_q);
        end
        if (kept_q) assert (!\line.waits_q && \line.state_q <= 3'd1);
      end
      if (!\line.open_q || !kept_q) assert (!\line.store_q );
      if (\line.waits_q ) assert (!\line.store_q );
      if (known_q && !of_rx) assert (\line.frames.word_q == out_q);
      if (sends_q) begin
        assert (to_send_q >= 9'd1 && to_send_q <= 9'd254 && \line.to_send_q == to_send_q[7:0]);
        case (\line.state_q )
          3'd1: assert (sent_q == 9'd0);
          3'd2, 3'd3, 3'd4: assert (sent_q == \line.index_q && sent_q < to_send_q);
          3'd5: assert (sent_q == to_send_q);
          3'd6: assert (sent_q == to_send_q + 9'd1);
          default: assert (sent_q == to_send_q + 9'd2);
        endcase
        if (known_q && !of_rx && \line.index_q == {1'b0, place}) begin
          if (\line.state_q == 3'd3) assert (\line.frames.read_data_q == out_q);
          if (\line.state_q == 3'd4) assert (\line.byte_q == out_q);
        end
      end
    end
  end

`ifdef RUNG_NARROW
  always @*
    assume (!(sel_register_i && write_i) || addr_i != `RUNG_REG_LINE_SEND || wdata_i == 16'd1);
`endif
  always @* cover (begun_q && leaves && sent_q == 9'd1 && tx_data == 8'hbf);

endmodule

`default_nettype wire

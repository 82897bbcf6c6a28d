// SPDX-License-Identifier: Apache-2.0
// A hop of the link: the sender of one unit (hdl/flow/link_send.v) and the receiver of its neighbour (link_receive.v) on a line
// that loses, damages and invents bytes in every clock, and loses answers; the neighbour restarts whenever it wants to.
//   A frame is taken by the neighbour once at most, however often it is repeated.
//   One that leaves the sender as taken has been taken: exactly once. Any other that leaves is counted as lost.
//   One that the neighbour refuses, or does not know, has not been taken, and is kept.
//   Repeats end: after the last one without an answer the frame leaves, and START goes.
`default_nettype none
`include "rung_flow.vh"
`ifdef RUNG_NARROW
// Covers and faults: a timeout of 13 bit times, gaps of 3. Nothing that is shown depends on them.
`undef RUNG_FLOW_BLOCK_WORDS
`define RUNG_FLOW_BLOCK_WORDS -5
`undef RUNG_LINK_ACK_TIMEOUT
`define RUNG_LINK_ACK_TIMEOUT 3
`undef RUNG_LINK_GAP
`define RUNG_LINK_GAP 1
`endif

module link_sequence_proof (
    input wire       clk_i,
    input wire       tick_i,
    input wire       other_tick_i,
    // the sender's frames and UART
    input wire [1:0] commit_i,
    input wire [6:0] length_i,
    input wire [7:0] data_i,
    input wire       ready_i,
    input wire       busy_i,
    input wire       answer_i,
    input wire [5:0] answer_head_i,
    // the line
    input wire       lose_i,
    input wire       damage_i,
    input wire       noise_i,
    input wire [7:0] noise_data_i,
    input wire       error_i,
    input wire       line_i,
    // the neighbour
    input wire       restart_i,
    input wire       any_room_i,
    input wire       request_room_i,
    input wire       send_answer_i,
    input wire       lose_answer_i
);

  localparam [1:0] DATA = `RUNG_LINK_KIND_DATA;
  localparam [1:0] ANSWER = `RUNG_LINK_KIND_ANSWER;
  localparam [1:0] START = `RUNG_LINK_KIND_START;
  localparam [1:0] TAKEN = `RUNG_LINK_ANSWER_TAKEN;
  localparam [1:0] FULL = `RUNG_LINK_ANSWER_FULL;
  localparam [1:0] UNKNOWN = `RUNG_LINK_ANSWER_UNKNOWN;
  localparam [1:0] STARTED = `RUNG_LINK_ANSWER_STARTED;

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  wire other_rst_n = begun_q && !restart_i;

  wire [1:0] lane_free;
  wire lane, byte_valid, answer_taken, down;
  wire [6:0] index;
  wire [7:0] byte_;
  wire [15:0] again, lost;
  wire ack;
  wire [7:0] other_head;
  link_send send (
      .clk_i         (clk_i),
      .rst_ni        (begun_q),
      .bit_tick_i    (tick_i),
      .free_o        (lane_free),
      .commit_i      (commit_i & lane_free & {2{begun_q}}),
      .length_i      (length_i),
      .read_lane_o   (lane),
      .read_index_o  (index),
      .read_data_i   (data_i),
      .byte_valid_o  (byte_valid),
      .byte_o        (byte_),
      .byte_ready_i  (ready_i),
      .byte_busy_i   (busy_i),
      .answer_valid_i(answer_i),
      .answer_head_i ({ANSWER, answer_head_i}),
      .answer_taken_o(answer_taken),
      .ack_valid_i   (ack),
      .ack_code_i    (other_head[2:1]),
      .ack_sequence_i(other_head[0]),
      .down_o        (down),
      .again_o       (again),
      .lost_o        (lost)
  );

  (* hierconn *) wire [2:0] \send.state_q ;
  (* hierconn *) wire [7:0] \send.head_q ;
  (* hierconn *) wire \send.awaiting_q ;
  (* hierconn *) wire \send.answer_q ;
  (* hierconn *) wire \send.started_q ;
  (* hierconn *) wire \send.sequence_q ;
  (* hierconn *) wire \send.repeat_q ;
  (* hierconn *) wire [2:0] \send.tries_q ;
  (* hierconn *) wire [1:0] \send.full_q ;
  (* hierconn *) wire \send.lane_q ;
  (* hierconn *) wire \send.late ;
  (* hierconn *) wire \send.mine ;
  (* hierconn *) wire \send.taken ;
  (* hierconn *) wire \send.started ;
  (* hierconn *) wire \send.refused ;
  (* hierconn *) wire \send.unknown ;
  (* hierconn *) wire \send.give_up ;
  (* hierconn *) wire [1:0] \send.leaves ;
  (* hierconn *) wire \send.send_answer ;
  (* hierconn *) wire \send.send_start ;
  (* hierconn *) wire \send.send_frame ;
  (* hierconn *) wire \send.send_again ;

  // ---- the line: a byte arrives, or not, or another one, or one that nobody has sent -------------------
  wire sends = byte_valid && ready_i;
  wire arrives = sends && !lose_i;
  wire other_valid, take;
  wire [1:0] class_;
  link_receive receive (
      .clk_i         (clk_i),
      .rst_ni        (other_rst_n),
      .unit_i        (4'd2),
      .bit_tick_i    (other_tick_i),
      .line_i        (line_i),
      .byte_valid_i  (arrives || (!sends && noise_i)),
      .byte_i        (arrives && !damage_i ? byte_ : noise_data_i),
      .byte_error_i  (error_i),
      .begin_o       (),
      .write_o       (),
      .write_index_o (),
      .write_data_o  (),
      .commit_o      (take),
      .commit_class_o(class_),
      .any_room_i    (any_room_i),
      .request_room_i(request_room_i),
      .answer_valid_o(other_valid),
      .answer_head_o (other_head),
      .answer_taken_i(send_answer_i),
      .ack_valid_o   (),
      .ack_code_o    (),
      .ack_sequence_o(),
      .bad_o         (),
      .full_o        ()
  );
  assign ack = other_valid && send_answer_i && !lose_answer_i && other_rst_n;

  (* hierconn *) wire [1:0] \receive.state_q ;
  (* hierconn *) wire [6:0] \receive.index_q ;
  (* hierconn *) wire [6:0] \receive.last_q ;
  (* hierconn *) wire [1:0] \receive.kind_q ;
  (* hierconn *) wire [2:0] \receive.code_q ;
  (* hierconn *) wire \receive.synced_q ;
  (* hierconn *) wire \receive.due_q ;
  (* hierconn *) wire \receive.broken ;
  (* hierconn *) wire \receive.checked ;
  (* hierconn *) wire \receive.right ;
  wire framing = \receive.state_q == 2'd0;
  wire checking = \receive.state_q == 2'd1;
  wire head_now = sends && \send.state_q == 3'd1;

  // The neighbour has all bytes of the sender's frame so far, and has not yet checked it.
  reg whole_q;
  wire from_middle = framing && sends && !head_now && \receive.index_q == 7'd0;
  wire spoilt = (sends && (lose_i || damage_i)) || (!sends && noise_i && !checking) ||
      \receive.broken || \receive.state_q == 2'd2 || from_middle;
  always @(posedge clk_i) begin
    if (!other_rst_n) whole_q <= 1'b0;
    else if (head_now)
      whole_q <= arrives && !damage_i && framing && \receive.index_q == 7'd0 && !\receive.broken ;
    else if (spoilt || \receive.checked ) whole_q <= 1'b0;
  end

  // ---- what is asked -----------------------------------------------------------------------------------
  wire asks = \send.send_start || \send.send_frame || \send.send_again ;
  reg  asking_q;  // no answer yet, and the timeout has not passed
  reg  asks_start_q;  // it is START
  always @(posedge clk_i) begin
    if (!begun_q) asking_q <= 1'b0;
    else if (asks) asking_q <= 1'b1;
    else if (\send.mine || \send.started || \send.late ) asking_q <= 1'b0;
    if (asks) asks_start_q <= \send.send_start ;
  end
  always @* begin
    // The CRC: only what has come as it was sent, to its end, is right.
    assume (!\receive.right || (whole_q && \send.state_q != 3'd1 && \send.state_q != 3'd2 &&
                                \send.state_q != 3'd3 && \send.state_q != 3'd4));
    // Bytes take longer than a check; the neighbour's answer is there before the timeout or never.
    assume (!head_now || !whole_q);
    assume (!asks || !whole_q);
    assume (!\send.send_answer || !whole_q);
    assume (!\send.late || (!whole_q && !other_valid));
  end

  // ---- whether the neighbour has taken the frame in each buffer -------------------------------------------
  reg [1:0] got_q;
  reg open_q;  // the frame of lane_q has been sent, and what became of it is not known
  reg [2:0] sendings_q;  // of the open frame
  reg [15:0] lost_count_q;
  wire [1:0] current = {\send.lane_q , !\send.lane_q };
  integer i;
  always @(posedge clk_i) begin
    for (i = 0; i < 2; i = i + 1) begin
      if (!begun_q || \send.leaves [i]) got_q[i] <= 1'b0;
      else if (take && current[i]) got_q[i] <= 1'b1;
    end
    if (!begun_q) open_q <= 1'b0;
    else if (\send.send_frame ) open_q <= 1'b1;
    else if (\send.mine || \send.give_up ) open_q <= 1'b0;
    if (\send.send_frame ) sendings_q <= 3'd1;
    else if (\send.send_again ) sendings_q <= sendings_q + 3'd1;
    if (!begun_q) lost_count_q <= 16'd0;
    else if (\send.leaves != 2'b00 && !\send.taken ) lost_count_q <= lost_count_q + 16'd1;
  end
  wire got = |(got_q & current);

  always @* begin
    if (begun_q) begin
      if (take) assert (open_q && |(\send.full_q & current) && !got);
      if (\send.taken ) assert (open_q && got && \send.leaves == current);
      if (\send.refused ) assert (!got && \send.leaves == 2'b00);
      if (\send.unknown && !\send.give_up ) assert (!got && \send.leaves == 2'b00);
      assert (\send.leaves != 2'b11);
      assert (lost == lost_count_q);
      if (open_q) assert (sendings_q >= 3'd1 && sendings_q <= 3'd1 + `RUNG_LINK_RETRIES);
      if (open_q && \send.late && sendings_q == 3'd1 + `RUNG_LINK_RETRIES) assert (\send.give_up );
    end
  end

  // ---- for the induction -------------------------------------------------------------------------------------
  wire in_frame = \send.state_q >= 3'd1 && \send.state_q <= 3'd5;
  always @* begin
    if (begun_q) begin
      assert (\send.state_q <= 3'd6 && \receive.state_q <= 2'd2);
      assert ((got_q & ~\send.full_q ) == 2'b00);
      assert ((got_q & ~current) == 2'b00);
      if (got) assert (open_q);
      if (open_q) assert (|(\send.full_q & current) && \send.started_q );
      if (\send.repeat_q ) assert (open_q);
      if (open_q && !\send.repeat_q && \send.tries_q == 3'd0) assert (asking_q && !asks_start_q);
      if (open_q) assert (asking_q || \send.repeat_q );
      if (open_q) assert (sendings_q == \send.tries_q + {2'd0, asking_q});
      if (!open_q && \send.started_q ) assert (\send.tries_q == 3'd0);
      assert (\send.tries_q <= `RUNG_LINK_RETRIES);
      if (down) assert (!\send.started_q );
      if (\send.awaiting_q ) assert (asking_q);
      // A frame on its way is the one that is asked, or an answer.
      if (asking_q) assert (asks_start_q == !\send.started_q );
      if (asking_q && !asks_start_q) assert (open_q);
      if (in_frame && !\send.answer_q ) begin
        if (\send.state_q != 3'd5 && \send.tries_q == 3'd0) assert (!got);
        assert (asking_q && !\send.awaiting_q && (!other_valid || \send.state_q == 3'd5));
        assert (\send.head_q == (asks_start_q ? {START, 6'd0} : {DATA, 5'd0, \send.sequence_q }));
      end
      if (in_frame && \send.answer_q && \send.state_q != 3'd5)
        assert (\send.head_q [7:6] == ANSWER);
      if (asking_q && !\send.awaiting_q ) assert (in_frame && !\send.answer_q );
      if (framing && \receive.index_q != 7'd0) begin
        assert (\receive.index_q <= \receive.last_q && \receive.last_q <= 7'd74);
        assert (\receive.last_q == 7'd2 || \receive.last_q >= 7'd10);
        assert (\receive.last_q == 7'd2 || \receive.kind_q == DATA);
      end
      // What the neighbour has of it.
      if (whole_q) begin
        assert (in_frame || \send.state_q == 3'd6 || \send.state_q == 3'd0);
        assert (framing ? \receive.index_q != 7'd0 : checking);
        assert (\receive.kind_q == \send.head_q [7:6] && \receive.code_q == \send.head_q [2:0]);
        assert (\send.head_q [7:6] == ANSWER || asking_q);
        if (\send.head_q [7:6] != ANSWER) begin
          assert (\send.head_q == (asks_start_q ? {START, 6'd0} : {DATA, 5'd0, \send.sequence_q }));
          assert (!other_valid);
          if (got) assert (\send.tries_q != 3'd0);
        end
        assert (\send.state_q != 3'd1);
      end
      // Its answer belongs to what is asked.
      if (other_valid) begin
        assert (asking_q);
        if (asks_start_q)
          assert (other_head[2:1] == STARTED && \receive.synced_q && !\receive.due_q );
          else begin
            assert (other_head[2:1] != STARTED && other_head[0] == \send.sequence_q );
            if (other_head[2:1] == TAKEN) assert (got);
            if (other_head[2:1] == FULL) assert (!got);
            if (other_head[2:1] == UNKNOWN && \send.tries_q == 3'd0) assert (!got);
          end
      end
      // The bit that is due.
      if (\send.started_q && \receive.synced_q )
        assert (\receive.due_q == (\send.sequence_q ^ got));
    end
  end

`ifdef RUNG_NARROW
  (* hierconn *) wire \send.append.busy ;
  (* hierconn *) wire \receive.check.busy ;
  (* hierconn *) wire [15:0] \receive.check.crc ;
  always @* begin
    assume (ready_i && !busy_i && tick_i && other_tick_i && !answer_i && line_i == !in_frame);
    assume (!noise_i && !damage_i && !error_i && !lose_i && any_room_i && request_room_i);
    assume (length_i == 7'd8 && commit_i == {1'b0, begun_q} && send_answer_i);
    assume (data_i == (\receive.index_q == 7'd1 ? 8'd2 : 8'd1));
    assume (!\send.append.busy && !\receive.check.busy && \receive.check.crc == 16'd0);
  end
`endif
  always @* begin
    cover (begun_q && \send.taken );
  end

endmodule

`default_nettype wire

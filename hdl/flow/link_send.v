// SPDX-License-Identifier: Apache-2.0
// Sends the frames of one side of the link, one at a time: head, bytes of its buffer, CRC; then the neighbour's
// answer is awaited, and the frame repeated without one.
//
// There are two buffers, one for replies and one for requests, which take turns if both have a frame: a neighbour that
// asks without end must not keep this side from asking. Where the neighbour has no room for a request (FULL, so it is
// sure that it has not taken it) a reply goes before its next sending. So requests that wait, wherever they are, hold
// up a reply by one frame at most; replies end in their requester's pool, which always has their place; and requests
// wait for nothing but replies and the scheduler that executes them. No waits can stand in a circle for ever, with all
// buffers full in both directions. What the scheduler does not serve any more is dropped by link_dispatch.v after the
// requests' timeout.
//
// The neighbour's answer can be no later than the timeout: it waits at most for the whole frame that is being sent
// there. So an answer always belongs to the sending before it.
// - no answer after the last retry: the frame is given up and counted. Whether the neighbour took it is not known, nor
//   which sequence bit it expects; START, repeated until it is answered, makes bit 0 the next. START is also sent
//   after reset. Without an answer to that either (to four after reset) the side is down: START goes on, and frames that
//   come are dropped and counted at once instead of holding up those behind them for a timeout each.
// - UNKNOWN: the neighbour has restarted. If this was the frame's first sending it cannot have been taken, and it goes
//   after START; if it was a later one the first may have been, and it is given up rather than doubled.
// Answers to the neighbour (3 bytes) go between frames, before everything else.
`default_nettype none
`include "rung_flow.vh"

module link_send (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        bit_tick_i,
    // buffers, 0 for replies, 1 for requests: a commit, for which free_o is 1, says that bytes 0 to length - 1 are there
    output wire [ 1:0] free_o,
    input  wire [ 1:0] commit_i,
    input  wire [ 6:0] length_i,
    // their bytes: data_i belongs to the address of a few clocks before
    output wire        read_lane_o,
    output wire [ 6:0] read_index_o,
    input  wire [ 7:0] read_data_i,
    // UART
    output wire        byte_valid_o,
    output wire [ 7:0] byte_o,
    input  wire        byte_ready_i,
    input  wire        byte_busy_i,
    // receiver
    input  wire        answer_valid_i,
    input  wire [ 7:0] answer_head_i,
    output wire        answer_taken_o,
    input  wire        ack_valid_i,
    input  wire [ 1:0] ack_code_i,
    input  wire        ack_sequence_i,
    // state and counters
    output wire        down_o,
    output wire [15:0] again_o,
    output wire [15:0] lost_o
);

  localparam [1:0] DATA = `RUNG_LINK_KIND_DATA;
  localparam [1:0] START = `RUNG_LINK_KIND_START;
  localparam [1:0] TAKEN = `RUNG_LINK_ANSWER_TAKEN;
  localparam [1:0] FULL = `RUNG_LINK_ANSWER_FULL;
  localparam [1:0] UNKNOWN = `RUNG_LINK_ANSWER_UNKNOWN;
  localparam [1:0] STARTED = `RUNG_LINK_ANSWER_STARTED;
  localparam [2:0] RETRIES = `RUNG_LINK_RETRIES;
  // In bit times. A gap counts begun ones, and the neighbour's clock is another: two more.
  localparam [9:0] GAP = `RUNG_LINK_GAP + 2;
  localparam [9:0] TIMEOUT = 10 * (11 + 2 * `RUNG_FLOW_BLOCK_WORDS) + `RUNG_LINK_ACK_TIMEOUT;
  localparam [9:0] PAUSE = `RUNG_LINK_ACK_TIMEOUT;  // of a request that found no room

  localparam [2:0] IDLE = 3'd0;
  localparam [2:0] HEAD = 3'd1;
  localparam [2:0] BYTES = 3'd2;
  localparam [2:0] CRC_LOW = 3'd3;
  localparam [2:0] CRC_HIGH = 3'd4;
  localparam [2:0] DRAIN = 3'd5;
  localparam [2:0] SPACE = 3'd6;  // the gap

  reg  [ 2:0] state_q;
  reg  [ 7:0] head_q;
  reg         control_q;  // an answer or START is being sent, nothing from a buffer
  reg         answer_q;  // an answer: nothing is awaited after it
  reg         lane_q;  // buffer of the frame that is sent or awaits its answer
  reg  [ 6:0] index_q;
  reg  [ 9:0] timer_q;  // bit times since a frame or START, or FULL
  reg  [ 9:0] gap_q;
  reg         awaiting_q;  // an answer to the frame or START
  reg         started_q;  // the neighbour knows the sequence bit
  reg         down_q;
  reg         sequence_q;
  reg         repeat_q;  // the neighbour may have taken the frame: no other may go before it
  reg         pause_q;  // a request found no room
  reg  [ 2:0] tries_q;  // sendings without an answer
  reg  [ 1:0] full_q;
  reg  [13:0] lengths_q;
  reg  [ 1:0] refused_q;  // sent, and surely not taken
  reg  [15:0] again_q;
  reg  [15:0] lost_q;

  // ---- the neighbour's answers ----
  wire        ack = ack_valid_i && awaiting_q;
  wire        mine = ack && started_q && ack_sequence_i == sequence_q;
  wire        taken = mine && ack_code_i == TAKEN;
  wire        refused = mine && ack_code_i == FULL;
  wire        unknown = mine && ack_code_i == UNKNOWN;
  wire        started = ack && !started_q && ack_code_i == STARTED;
  wire        late = awaiting_q && timer_q == TIMEOUT && !ack;
  wire        last_try = tries_q == RETRIES;
  wire        give_up = started_q && ((late && last_try) || (unknown && tries_q != 3'd0));
  // One at a time, so that each is counted.
  wire [ 1:0] drop = down_q ? {full_q[1] && !full_q[0], full_q[0]} : 2'b00;
  wire [ 1:0] lane_bit = {lane_q, !lane_q};
  wire [ 1:0] leaves = drop | (lane_bit & {2{taken || give_up}});

  // ---- what goes next ----
  wire        crc_busy;
  wire [15:0] crc;
  wire        sending = state_q == HEAD || state_q == BYTES || state_q == CRC_LOW ||
      state_q == CRC_HIGH;
  wire        offer = sending && !crc_busy;
  wire        ready = offer && byte_ready_i;
  wire        sent = state_q == DRAIN && !byte_busy_i;
  wire        sent_asking = sent && !answer_q;
  wire        rest = state_q == IDLE && !awaiting_q;
  wire        reply_waits = full_q[0];
  wire        request_waits = full_q[1] && !pause_q;
  wire        take_request = request_waits && !(reply_waits && lane_q);
  wire        send_answer = state_q == IDLE && answer_valid_i;
  wire        send_start = rest && !answer_valid_i && !started_q;
  wire        send_again = rest && !answer_valid_i && started_q && repeat_q;
  wire        send_frame = rest && !answer_valid_i && started_q && !repeat_q &&
      (reply_waits || request_waits);

  always @(posedge clk_i) begin
    if (commit_i[0]) lengths_q[6:0] <= length_i;
    if (commit_i[1]) lengths_q[13:7] <= length_i;

    if (send_answer || send_start || send_frame || send_again) begin
      head_q <= send_answer ? answer_head_i : send_start ? {START, 6'd0} : {DATA, 5'd0, sequence_q};
      control_q <= send_answer || send_start;
      index_q <= 7'd0;
    end else if (state_q == BYTES && ready) begin
      index_q <= index_q + 7'd1;
    end
    if (!rst_ni) lane_q <= 1'b0;
    else if (send_frame) lane_q <= take_request;
    if (!rst_ni) answer_q <= 1'b1;  // nothing has been asked
    else if (send_answer || rest) answer_q <= send_answer;

    if (!rst_ni) begin
      full_q <= 2'b00;
      awaiting_q <= 1'b0;
      started_q <= 1'b0;
      down_q <= 1'b0;
      repeat_q <= 1'b0;
      pause_q <= 1'b0;
      tries_q <= 3'd0;
      again_q <= 16'd0;
      lost_q <= 16'd0;
    end else begin
      full_q <= (full_q & ~leaves) | commit_i;
      if (sent_asking) awaiting_q <= 1'b1;
      else if (mine || started || late) awaiting_q <= 1'b0;

      if (started) begin
        started_q <= 1'b1;
        down_q <= 1'b0;
        sequence_q <= 1'b0;
      end else if (unknown || give_up) begin
        started_q <= 1'b0;
      end else if (taken) begin
        sequence_q <= !sequence_q;
      end
      if (late && !started_q && last_try) down_q <= 1'b1;

      if (mine || started) tries_q <= 3'd0;
      else if (late && !last_try) tries_q <= tries_q + 3'd1;

      if (mine || give_up) repeat_q <= 1'b0;
      else if (late && started_q) repeat_q <= 1'b1;
      if (refused && lane_q) pause_q <= 1'b1;
      else if (sent_asking || timer_q == PAUSE) pause_q <= 1'b0;

      if (send_again) again_q <= again_q + 16'd1;
      else if (send_frame && refused_q[take_request]) again_q <= again_q + 16'd1;
      if (give_up || drop != 2'b00) lost_q <= lost_q + 16'd1;
    end
  end

  // For the counter.
  always @(posedge clk_i) begin
    if (!rst_ni) refused_q <= 2'b00;
    else refused_q <= (refused_q | (lane_bit & {2{refused || unknown}})) & ~leaves & ~commit_i;
  end

  always @(posedge clk_i) begin
    if (sent_asking || refused) timer_q <= 10'd0;
    else if (bit_tick_i && timer_q != TIMEOUT) timer_q <= timer_q + 10'd1;
  end

  // ---- a frame ----
  wire [6:0] length = lane_q ? lengths_q[13:7] : lengths_q[6:0];

  always @(posedge clk_i) begin
    if (state_q == DRAIN) gap_q <= 10'd0;
    else if (bit_tick_i) gap_q <= gap_q + 10'd1;

    if (!rst_ni) begin
      state_q <= DRAIN;  // the first frame also has its gap before it
    end else begin
      case (state_q)
        IDLE: if (send_answer || send_start || send_frame || send_again) state_q <= HEAD;
        HEAD: if (ready) state_q <= control_q ? CRC_LOW : BYTES;
        BYTES: if (ready && index_q + 7'd1 == length) state_q <= CRC_LOW;
        CRC_LOW: if (ready) state_q <= CRC_HIGH;
        CRC_HIGH: if (ready) state_q <= DRAIN;
        DRAIN: if (sent) state_q <= SPACE;
        default: if (gap_q == GAP) state_q <= IDLE;
      endcase
    end
  end

  assign byte_valid_o = offer;
  assign byte_o = state_q == HEAD ? head_q : state_q == BYTES ? read_data_i :
      state_q == CRC_LOW ? crc[7:0] : crc[15:8];

  link_crc append (
      .clk_i  (clk_i),
      .start_i(state_q == HEAD),
      .byte_i (ready && (state_q == HEAD || state_q == BYTES)),
      .data_i (byte_o),
      .busy_o (crc_busy),
      .crc_o  (crc)
  );

  assign free_o = ~full_q;
  assign read_lane_o = lane_q;
  assign read_index_o = index_q;
  assign answer_taken_o = send_answer;
  assign down_o = down_q;
  assign again_o = again_q;
  assign lost_o = lost_q;

endmodule

`default_nettype wire

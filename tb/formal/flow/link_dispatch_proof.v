// SPDX-License-Identifier: Apache-2.0
// Dispatcher of the link (hdl/flow/link_dispatch.v), with a table of which it keeps one block, any one. A record that is taken from a ring leaves
// it once, and in that clock it is handed on once, as it came, into a buffer that was free, or as an event command into a block
// that was offered, or completes the request that it answers in tag, unit, kind and count, or is counted as dropped. An own frame goes out
// once, as the table has it, into a free buffer of its side. Each request that is open has one completion: its answer's,
// no_reply not before its deadline, or refused if nobody can be asked. Every job has an end. What words hold is not in it.
`default_nettype none
`include "rung_flow.vh"

module link_dispatch_proof (
    input wire        clk_i,
    input wire        rst_ni,
    input wire        millisecond_i,
    input wire [ 1:0] found_i,
    input wire [ 7:0] upper_data_i,
    input wire [ 7:0] lower_data_i,
    input wire [ 3:0] frees_i,              // buffers that have been sent
    input wire [ 1:0] down_i,
    input wire        table_open_i,
    input wire        table_queued_i,
    input wire        table_lower_i,
    input wire [15:0] table_data_i,
    input wire        enters_i,             // the watched block gets a frame,
    input wire        enters_request_i,     // a request if it is not an event's
    input wire [63:0] enters_words_i,       // these
    input wire        mem_ready_i,
    input wire [15:0] mem_rdata_i,
    input wire        done_ready_i,
    input wire        event_block_valid_i,
    input wire [ 4:0] event_block_i,
    input wire        event_ready_i,
    input wire [63:0] record_i,             // head of the next record
    // inside of it
    input wire [ 3:0] peek_state,
    input wire        peek_own,
    input wire        peek_side,
    input wire [ 1:0] peek_class,
    input wire [ 4:0] peek_block,
    input wire [ 6:0] peek_index,
    input wire [63:0] peek_head,
    input wire        peek_drop,
    input wire [15:0] peek_now,
    input wire        peek_overdue
);

  (* anyconst *) wire [3:0] unit;
  (* anyconst *) wire [15:0] timeout;
  (* anyconst *) wire [4:0] block;  // the watched one
  wire block_event = block[4:3] == 2'b10;
  always @* assume (block <= `RUNG_FLOW_PC_BLOCK);

  wire [15:0] deadline, mem_wdata, event_first, late;
  wire [1:0] find_class, ring_free, table_word;
  wire ring_read, lane_write, table_sent, table_ended, table_read, mem_valid, mem_write;
  wire [6:0] ring_index, lane_length;
  wire [3:0] lane_commit, event_use;
  reg [3:0] lane_free_q;
  wire [8:0] lane_addr;
  wire [7:0] lane_data, done_status, event_board, event_from, event_tag;
  wire [4:0] table_block, done_block, reply_done_block;
  wire [9:0] mem_addr;
  wire done_valid, event_valid, event_write, event_given, reply_done;
  wire [5:0] event_count;
  link_dispatch dispatch (
      .clk_i              (clk_i),
      .rst_ni             (rst_ni),
      .unit_i             (unit),
      .timeout_ms_i       (timeout),
      .millisecond_i      (millisecond_i),
      .deadline_o         (deadline),
      .find_class_o       (find_class),
      .found_i            (found_i),
      .ring_read_o        (ring_read),
      .ring_index_o       (ring_index),
      .upper_data_i       (upper_data_i),
      .lower_data_i       (lower_data_i),
      .ring_free_o        (ring_free),
      .lane_free_i        (lane_free_q),
      .lane_commit_o      (lane_commit),
      .lane_length_o      (lane_length),
      .lane_write_o       (lane_write),
      .lane_addr_o        (lane_addr),
      .lane_data_o        (lane_data),
      .down_i             (down_i),
      .table_block_o      (table_block),
      .table_open_i       (table_open_i),
      .table_queued_i     (table_queued_i),
      .table_lower_i      (table_lower_i),
      .table_sent_o       (table_sent),
      .table_ended_o      (table_ended),
      .table_read_o       (table_read),
      .table_word_o       (table_word),
      .table_data_i       (table_data_i),
      .mem_valid_o        (mem_valid),
      .mem_ready_i        (mem_ready_i),
      .mem_write_o        (mem_write),
      .mem_addr_o         (mem_addr),
      .mem_wdata_o        (mem_wdata),
      .mem_rdata_i        (mem_rdata_i),
      .done_valid_o       (done_valid),
      .done_ready_i       (done_ready_i),
      .done_block_o       (done_block),
      .done_status_o      (done_status),
      .event_block_valid_i(event_block_valid_i),
      .event_block_i      (event_block_i),
      .event_valid_o      (event_valid),
      .event_ready_i      (event_ready_i),
      .event_write_o      (event_write),
      .event_board_o      (event_board),
      .event_first_o      (event_first),
      .event_count_o      (event_count),
      .event_from_o       (event_from),
      .event_tag_o        (event_tag),
      .event_given_o      (event_given),
      .event_use_o        (event_use),
      .reply_done_valid_o (reply_done),
      .reply_done_block_o (reply_done_block),
      .late_o             (late)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* assume (rst_ni == begun_q);

  // ---- buffers; offered blocks ---------------------------------------------------------------------------------
  reg offered_q;
  reg [4:0] offered_block_q;
  integer i;
  always @(posedge clk_i) begin
    for (i = 0; i < 4; i = i + 1) begin
      if (!rst_ni) lane_free_q[i] <= 1'b1;
      else if (lane_commit[i]) lane_free_q[i] <= 1'b0;
      else if (frees_i[i]) lane_free_q[i] <= 1'b1;
    end
    offered_q <= rst_ni && event_block_valid_i && !(event_valid && event_ready_i);
    offered_block_q <= event_block_i;
  end
  always @* begin
    if (offered_q) assume (event_block_valid_i && event_block_i == offered_block_q);
    if (event_block_valid_i) assume (event_block_i[4:3] == 2'b10);
  end

  // ---- the table's watched block -----------------------------------------------------------------------------------
  reg open_q, queued_q, lower_q;
  reg [63:0] words_q;  // word 0 highest
  wire looks = table_block == block;
  wire sent = table_sent && looks;
  wire ended = table_ended && looks;
  wire enters = enters_i && !open_q && !queued_q && !looks && !due_q && rst_ni;
  reg read_q;
  reg [1:0] read_word_q;
  always @(posedge clk_i) begin
    if (!rst_ni) {open_q, queued_q} <= 2'b00;
    else if (enters) {open_q, queued_q} <= {!block_event, 1'b1};
    else if (ended) {open_q, queued_q} <= 2'b00;
    else if (sent) queued_q <= 1'b0;
    if (enters) begin
      words_q <= enters_words_i;
      lower_q <= enters_words_i[35:32] > unit;
    end
    read_q <= begun_q && looks && (open_q || queued_q);
    read_word_q <= table_word;
  end
  always @* begin
    if (looks) assume ({table_open_i, table_queued_i} == {open_q, queued_q});
    if (looks && queued_q) assume (table_lower_i == lower_q);
    if (read_q) assume (table_data_i == words_q[16*(2'd3-read_word_q)+:16]);
    // A unit's number has four bits; replies go to somebody.
    assume (enters_words_i[39:36] == 4'd0 && !(block_event && enters_words_i[47]));
  end

  // ---- the record that is looked at: its head, until it leaves -------------------------------------------------------
  reg [63:0] record_q;
  reg head_read_q;
  reg [2:0] head_index_q;
  wire leaves = ring_free != 2'b00;
  wire [7:0] ring_data = peek_side ? lower_data_i : upper_data_i;
  always @(posedge clk_i) begin
    if (!begun_q || leaves || table_sent) record_q <= record_i;
    head_read_q <= ring_read && ring_index < 7'd8;
    head_index_q <= ring_index[2:0];
  end
  always @* begin
    if (head_read_q && begun_q) assume (ring_data == record_q[8*(3'd7-head_index_q)+:8]);
  end
  wire [7:0] record_from = record_q[55:48];
  wire [7:0] record_type = record_q[47:40];
  wire [7:0] record_tag = record_q[39:32];
  wire [5:0] record_count = record_q[5:0];
  // link_receive.v takes only what has a type and a count.
  always @* begin
    assume (record_type <= 8'd4 && record_type >= 8'd1 && record_q[7:0] <= `RUNG_FLOW_BLOCK_WORDS);
  end
  wire record_words = record_type == `RUNG_LINK_TYPE_WRITE ||
      record_type == `RUNG_LINK_TYPE_READ_REPLY;

  // ---- what has been written to the buffer -----------------------------------------------------------------------------
  reg [63:0] out_q;
  reg [8:0] written_q;  // bytes of this frame
  wire commits = lane_commit != 4'd0;
  always @(posedge clk_i) begin
    if (!begun_q || commits || leaves) written_q <= 9'd0;
    else if (lane_write) written_q <= written_q + 9'd1;
    if (lane_write && lane_addr[6:0] < 7'd8) out_q[8*(3'd7-lane_addr[2:0])+:8] <= lane_data;
  end

  // ---- completions of the watched block, and answers that come late ------------------------------------------------------
  reg due_q;  // it has been ended, and nobody has been told
  reg [7:0] due_status_q;
  reg [15:0] now_q;
  reg over_q;
  reg [15:0] late_q;
  wire over = ((now_q - words_q[63:48]) & 16'h8000) == 16'd0;
  wire answered = ended && leaves;
  wire told = done_valid && done_ready_i && done_block == block;
  always @(posedge clk_i) begin
    if (!rst_ni) due_q <= 1'b0;
    else if (ended) due_q <= 1'b1;
    else if (told) due_q <= 1'b0;
    if (ended) begin
      due_status_q <= answered ? record_q[15:8] : words_q[47] && peek_state == 4'd3 ?
          `RUNG_FLOW_STATUS_REFUSED : `RUNG_FLOW_STATUS_NO_REPLY;
    end
    if (!rst_ni) now_q <= 16'd0;
    else if (millisecond_i) now_q <= now_q + 16'd1;
    over_q <= over;
    if (!rst_ni) late_q <= 16'd0;
    else if (leaves && !commits && !event_given && !table_ended) late_q <= late_q + 16'd1;
  end

  wire read = !words_q[46];
  wire [3:0] request_type = read ? `RUNG_LINK_TYPE_READ : `RUNG_LINK_TYPE_WRITE;
  wire [3:0] reply_type = read ? `RUNG_LINK_TYPE_READ_REPLY : `RUNG_LINK_TYPE_WRITE_REPLY;
  wire [3:0] own_type = block_event ? reply_type : request_type;
  // A reply has words only if it is one of a read, and done.
  wire [7:0] own_count = block_event && (!read || words_q[23:16] != 8'd0) ? 8'd0 :
      {2'd0, words_q[45:40]};
  wire [63:0] own_frame = {
    4'd0,
    words_q[35:32],
    words_q[6:3],
    unit,
    4'd0,
    own_type,
    block_event ? words_q[15:8] : {words_q[2:0], block},
    block_event ? 8'd0 : words_q[15:8],
    words_q[31:16],
    own_count
  };
  always @* begin
    if (begun_q) begin
      // A record leaves one ring, and is one thing.
      assert (ring_free != 2'b11);
      assert (!(leaves && table_sent));
      if (commits) assert (leaves != table_sent);
      if (event_given) assert (leaves && !commits && !table_ended);
      if (leaves && table_ended) assert (!commits);
      assert (late == late_q);
      // Into one buffer, that is free, with all its bytes.
      assert ((lane_commit & ~lane_free_q) == 4'd0);
      assert ((lane_commit & (lane_commit - 4'd1)) == 4'd0);
      if (lane_write) assert (lane_free_q[lane_addr[8:7]]);
      if ((leaves && commits) || sent) assert (written_q == {2'd0, lane_length});
      if (commits && leaves) begin
        assert (out_q == record_q);
        assert (lane_length == 7'd8 + (record_words ? {record_count, 1'b0} : 7'd0));
        // To the other side, as what it is.
        assert (lane_commit == (ring_free[0] ? (peek_class[0] ? 4'd4 : 4'd8) :
                                (peek_class[0] ? 4'd1 : 4'd2)));
      end
      if (sent) begin
        assert (commits && queued_q && out_q == own_frame);
        if (lower_q) assert (lane_commit == (block_event ? 4'd4 : 4'd8));
        else assert (lane_commit == (block_event ? 4'd1 : 4'd2));
        assert (reply_done == block_event);
        if (reply_done) assert (reply_done_block == block);
      end
      if (reply_done && reply_done_block == block) assert (sent && block_event);
      // Each request one completion.
      if (ended) assert (open_q && !due_q);
      if (done_valid && done_block == block) assert (due_q && done_status == due_status_q);
      if (due_q) assert (done_valid && done_block == block);
      if (answered) begin
        assert (record_tag == {words_q[2:0], block} &&
            record_from == {words_q[6:3], words_q[35:32]});
        assert (record_type == {4'd0, reply_type});
        if (read) assert (record_count == (record_q[15:8] == 8'd0 ? words_q[45:40] : 6'd0));
      end
      if (ended && !answered && peek_state != 4'd3) assert (over_q);
      if (ended && !answered && peek_state == 4'd3) assert (words_q[47]);
      // An event command is the record's, into a block that is offered.
      if (event_given) assert (event_block_valid_i && !event_valid);
      if (event_valid) assert (event_block_valid_i);
      if (given_q) begin
        assert (event_valid && event_write == (given_record_q[42:40] == `RUNG_LINK_TYPE_WRITE));
        assert ({event_board, event_first} == given_record_q[31:8]);
        assert (event_count == given_record_q[5:0]);
        assert (event_from == {4'd0, given_record_q[51:48]} && event_tag == given_record_q[39:32]);
      end
    end
  end
  reg given_q;
  reg [63:0] given_record_q;
  always @(posedge clk_i) begin
    given_q <= event_given && rst_ni;
    given_record_q <= record_q;
  end

  // ---- clocks of a job, beside those in which the pool lets it wait -------------------------------------------------------
  localparam [3:0] JOBS = 4'd0;
  localparam [3:0] SCAN = 4'd1;
  localparam [3:0] DEADLINE = 4'd2;
  localparam [3:0] TABLE = 4'd3;
  localparam [3:0] HEAD = 4'd4;
  localparam [3:0] MATCH = 4'd5;
  localparam [3:0] OUT = 4'd6;
  localparam [3:0] FETCH = 4'd7;
  localparam [3:0] FETCH_LOW = 4'd8;
  localparam [3:0] GET = 4'd9;
  localparam [3:0] PUT = 4'd10;
  localparam [3:0] PUT_LOW = 4'd11;
  localparam [3:0] FINISH = 4'd12;
  localparam [3:0] HEAD_DONE = 4'd13;
  localparam [3:0] COMPARE = 4'd14;
  localparam [8:0] MOST = 9'd350;
  wire job = peek_state >= TABLE && peek_state <= HEAD_DONE;
  reg [8:0] clocks_q;
  always @(posedge clk_i) begin
    if (!job) clocks_q <= 9'd0;
    else if (!mem_valid || mem_ready_i) clocks_q <= clocks_q + 9'd1;
  end
  // The head as it is when it has been turned once round.
  wire [5:0] turn = peek_state == OUT ? {peek_index[2:0], 3'd0} : 6'd0;
  wire [127:0] turned = {peek_head, peek_head} >> turn;
  wire [63:0] head = turned[63:0];
  wire [5:0] count = head[5:0];
  wire [8:0] words = 9'd5 * {3'd0, count};
  wire [8:0] words_left = 9'd5 * ({3'd0, count} - {3'd0, peek_index[5:0]});
  reg [8:0] rest;
  always @* begin
    case (peek_state)
      TABLE: rest = 9'd4 - {7'd0, peek_index[1:0]} + 9'd325;
      HEAD: rest = 9'd9 - {5'd0, peek_index[3:0]} + 9'd326;
      HEAD_DONE: rest = words + 9'd11;
      OUT: rest = 9'd10 - {5'd0, peek_index[3:0]} + words;
      MATCH: rest = 9'd5 - {7'd0, peek_index[1:0]} + words;
      FETCH: rest = words_left + 9'd1;
      FETCH_LOW: rest = words_left;
      GET: rest = words_left - 9'd1;
      PUT: rest = words_left - 9'd2;
      PUT_LOW: rest = words_left - 9'd3;
      default: rest = 9'd1;
    endcase
  end

  // ---- for the induction ------------------------------------------------------------------------------------------------------
  wire own_watched = peek_own && peek_block == block;
  wire [63:0] frame = peek_own ? own_frame : record_q;
  wire word_loop = peek_state >= FETCH && peek_state <= PUT_LOW;
  wire to_lane = peek_own || !peek_class[1];
  wire through = job && !peek_own && !peek_class[1];
  wire of_event = job && !peek_own && peek_class == 2'd2;
  wire of_reply = job && !peek_own && peek_class == 2'd3;
  wire head_there = peek_state >= MATCH && peek_state <= HEAD_DONE;
  wire with_words = (head[42:40] == `RUNG_LINK_TYPE_WRITE ||
                     head[42:40] == `RUNG_LINK_TYPE_READ_REPLY) && count != 6'd0;
  wire [1:0] lane = peek_own ? {peek_side, peek_block[4:3] != 2'b10} : {!peek_side, !peek_class[0]};
  wire mine = of_reply && head_there && !peek_drop && record_tag[4:0] == block;
  integer k;
  always @* begin
    // The side of a block stays; a count is one that can be.
    if (peek_state == DEADLINE) assume (table_lower_i == peek_side);
    assume (enters_words_i[45:40] <= `RUNG_FLOW_BLOCK_WORDS);
    if (begun_q) begin
      assert (peek_state <= COMPARE && peek_block <= `RUNG_FLOW_PC_BLOCK);
      if (job) assert ({1'b0, clocks_q} + {1'b0, rest} <= {1'b0, MOST});
      if (peek_state == TABLE) assert (peek_own && peek_index < 7'd4);
      if (peek_state == COMPARE || peek_state == DEADLINE) assert (peek_own);
      if (peek_state == HEAD) assert (!peek_own && peek_index < 7'd9);
      if (peek_state == HEAD_DONE) assert (!peek_own && peek_index == 7'd0);
      if (peek_state == MATCH) assert (of_reply && peek_index < 7'd4);
      if (peek_state == OUT) assert (to_lane && peek_index < 7'd9);
      if (peek_state == FETCH_LOW) assert (!peek_own);
      if (peek_state == PUT_LOW) assert (to_lane);
      if (word_loop) assert ({1'b0, count} > peek_index && with_words);
      if (peek_state == COMPARE || peek_state == DEADLINE || !job) assert (written_q == 9'd0);
      if (peek_state == SCAN || peek_state == COMPARE ||
          peek_state == DEADLINE) assert (peek_index == 7'd0);
      if (peek_state == COMPARE || peek_state == DEADLINE || (job && to_lane) ||
          peek_state == SCAN) assert (!peek_drop);
      // What has been written.
      if (job && !to_lane) assert (written_q == 9'd0);
      if (peek_state == TABLE || peek_state == HEAD ||
          peek_state == HEAD_DONE) assert (written_q == 9'd0);
      if (peek_state == OUT) assert (written_q == {2'd0, peek_index});
      if (word_loop && to_lane) begin
        assert (written_q == 9'd8 + {1'b0, peek_index, 1'b0} + {8'd0, peek_state == PUT_LOW});
      end
      if (peek_state == FINISH && to_lane) begin
        assert (written_q == 9'd8 + (with_words ? {2'd0, count, 1'b0} : 9'd0));
      end
      if (job && to_lane) assert (lane_free_q[lane]);
      // The head.
      if (peek_state == HEAD) begin
        for (k = 1; k < 9; k = k + 1) begin
          if (peek_index == k[6:0]) begin
            assert (head_read_q && head_index_q == k[2:0] - 3'd1);
            assert ((peek_head & ~(64'hffffffffffffffff << 8 * (k - 1))) ==
                    (record_q >> (72 - 8 * k)));
          end
        end
      end
      if (head_there && (!peek_own || own_watched)) assert (head == frame);
      if (peek_state == OUT && (!peek_own || own_watched)) begin
        for (k = 0; k < 8; k = k + 1) begin
          if (peek_index > k[6:0]) assert (out_q[56-8*k+:8] == frame[56-8*k+:8]);
        end
      end
      if ((word_loop || peek_state == FINISH) && to_lane && (!peek_own ||
          own_watched)) assert (out_q == frame);
      if (peek_state == TABLE && own_watched) begin
        if (peek_index >= 7'd1) assert (read_q && read_word_q == peek_index[1:0]);
        if (peek_index >= 7'd2) begin
          assert (peek_head[63:56] == own_frame[63:56] && peek_head[47:40] == own_frame[47:40]);
          assert (peek_head[7:0] == {2'd0, words_q[45:40]} && !words_q[47]);
        end
        if (peek_index >= 7'd3) assert (peek_head[23:8] == words_q[31:16]);
      end
      if (job && own_watched) assert (queued_q && peek_side == lower_q);
      if (job && own_watched && peek_state != TABLE) assert (!words_q[47]);
      if (open_q || queued_q) begin
        assert (lower_q == (words_q[35:32] > unit) && words_q[39:36] == 4'd0);
        assert (words_q[45:40] <= `RUNG_FLOW_BLOCK_WORDS && !(block_event && words_q[47]));
          if (block_event) assert (!open_q);
      end
      if (queued_q && !block_event) assert (open_q);
      if ((peek_state == COMPARE || peek_state == DEADLINE) && peek_block == block) begin
        assert (open_q && peek_own && (!queued_q || peek_side == lower_q));
        if (peek_state == COMPARE) assert (read_q && read_word_q == 2'd0);
        else assert (peek_overdue == over_q);
      end
      assert (peek_now == now_q);
      // Answers.
      assert (due_q == (done_valid && done_block == block));
      if (due_q) assert (!open_q && done_status == due_status_q);
      if (of_reply) assert (!done_valid);
      if (peek_state == MATCH && record_tag[4:0] == block && open_q) begin
        if (peek_index == 7'd1) assert (read_q && read_word_q == 2'd1);
        if (peek_index == 7'd2) assert (read_q && read_word_q == 2'd3);
      end
      if (mine && (peek_state != MATCH || peek_index >= 7'd2) && peek_state != HEAD_DONE) begin
        assert (open_q && record_from[3:0] == words_q[35:32]);
        assert (record_type == {4'd0, reply_type});
        if (read) assert (record_count == (record_q[15:8] == 8'd0 ? words_q[45:40] : 6'd0));
      end
      if (mine && (peek_state != MATCH || peek_index >= 7'd3) && peek_state != HEAD_DONE) begin
        assert ({record_from[7:4], record_tag[7:5]} == words_q[6:0]);
      end
      // Event commands.
      if (of_event && !peek_drop) assert (event_block_valid_i && !event_valid);
      if (event_valid) assert (offered_q || event_block_valid_i);
      assert (late == late_q);
    end
  end

  always @* begin
    cover (begun_q && commits && leaves && record_count == 6'd1 && record_words);
    cover (begun_q && sent && !read && own_count == 8'd1);
    cover (begun_q && answered && read && record_count == 6'd1);
    cover (begun_q && given_q && event_write && event_count == 6'd1);
    cover (begun_q && told && done_status == `RUNG_FLOW_STATUS_NO_REPLY);
  end

endmodule

`default_nettype wire

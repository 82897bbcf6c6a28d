// SPDX-License-Identifier: Apache-2.0
// Moves records and frames of the link, one at a time, each in some 20 to 250 clocks: the jobs, in turn,
//   replies to this unit     into the block of their request, which is complete then;
//   replies to others        from a ring to the other side's buffer;
//   event commands           to the scheduler, words of a write into the offered block;
//   requests to others       as their replies;
//   the unit's own frames    of link_table.v, block after block, from the pool to a buffer.
// None waits for another: a job that finds no room is passed over until the next turn. Transit and own frames take
// turns on a buffer, and so do own frames among themselves: the first block that finds the buffer taken has the next
// turn, and the blocks behind it in their order. Own requests for a side that is down stay in the table.
//
// Timeouts: a request that is open at its deadline is complete with no_reply; an answer that comes later, or that
// does not match in tag, unit, kind and count, is dropped and counted (late_o). So is, after all event blocks have
// been taken for as long as a request's timeout, each event command that comes: its requester has given up too, and the
// ring must go on for others, whatever happens to the scheduler.
`default_nettype none
`include "rung_flow.vh"

module link_dispatch (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire [ 3:0] unit_i,
    input  wire [15:0] timeout_ms_i,
    input  wire        millisecond_i,
    output wire [15:0] deadline_o,
    // receive rings: bit 0 upper side, 1 lower
    output wire [ 1:0] find_class_o,
    input  wire [ 1:0] found_i,
    output wire        ring_read_o,
    output wire [ 6:0] ring_index_o,
    input  wire [ 7:0] upper_data_i,
    input  wire [ 7:0] lower_data_i,
    output wire [ 1:0] ring_free_o,
    // buffers to send from: bits 1:0 upper side's reply and request, 3:2 lower side's
    input  wire [ 3:0] lane_free_i,
    output wire [ 3:0] lane_commit_o,
    output wire [ 6:0] lane_length_o,
    output wire        lane_write_o,
    output wire [ 8:0] lane_addr_o,
    output wire [ 7:0] lane_data_o,
    input  wire [ 1:0] down_i,
    // table of own frames
    output wire [ 4:0] table_block_o,
    input  wire        table_open_i,
    input  wire        table_queued_i,
    input  wire        table_lower_i,
    output wire        table_sent_o,
    output wire        table_ended_o,
    output wire        table_read_o,
    output wire [ 1:0] table_word_o,
    input  wire [15:0] table_data_i,
    // pool
    output wire        mem_valid_o,
    input  wire        mem_ready_i,
    output wire        mem_write_o,
    output wire [ 9:0] mem_addr_o,
    output wire [15:0] mem_wdata_o,
    input  wire [15:0] mem_rdata_i,
    // completions
    output wire        done_valid_o,
    input  wire        done_ready_i,
    output wire [ 4:0] done_block_o,
    output wire [ 7:0] done_status_o,
    // event commands
    input  wire        event_block_valid_i,
    input  wire [ 4:0] event_block_i,
    output wire        event_valid_o,
    input  wire        event_ready_i,
    output wire        event_write_o,
    output wire [ 7:0] event_board_o,
    output wire [15:0] event_first_o,
    output wire [ 5:0] event_count_o,
    output wire [ 7:0] event_from_o,
    output wire [ 7:0] event_tag_o,
    output wire        event_given_o,
    output wire [ 3:0] event_use_o,
    // replies
    output wire        reply_done_valid_o,
    output wire [ 4:0] reply_done_block_o,
    // counter
    output wire [15:0] late_o
);

  localparam [7:0] NO_REPLY = `RUNG_FLOW_STATUS_NO_REPLY;
  localparam [7:0] REFUSED = `RUNG_FLOW_STATUS_REFUSED;
  localparam [7:0] DONE = `RUNG_FLOW_STATUS_DONE;
  localparam [2:0] READ = `RUNG_LINK_TYPE_READ;
  localparam [2:0] WRITE = `RUNG_LINK_TYPE_WRITE;
  localparam [2:0] READ_REPLY = `RUNG_LINK_TYPE_READ_REPLY;
  localparam [2:0] WRITE_REPLY = `RUNG_LINK_TYPE_WRITE_REPLY;
  localparam [4:0] LAST_BLOCK = `RUNG_FLOW_PC_BLOCK;
  localparam [6:0] HEAD_BYTES = 7'd8;  // to ... count

  // Classes of records: bit 1 for this unit, bit 0 a reply.
  localparam [1:0] THROUGH = 2'd0;
  localparam [1:0] THROUGH_REPLY = 2'd1;
  localparam [1:0] EVENT = 2'd2;
  localparam [1:0] OWN_REPLY = 2'd3;

  localparam [3:0] JOBS = 4'd0;  // is there one of class find_class_o on side job_q[0]?
  localparam [3:0] SCAN = 4'd1;  // block_q of the table
  localparam [3:0] DEADLINE = 4'd2;
  localparam [3:0] TABLE = 4'd3;  // an own frame's head from the table
  localparam [3:0] HEAD = 4'd4;  // a record's head from the ring
  localparam [3:0] MATCH = 4'd5;  // a reply to its request
  localparam [3:0] OUT = 4'd6;  // a head to the buffer
  localparam [3:0] FETCH = 4'd7;  // a word, or its high byte
  localparam [3:0] FETCH_LOW = 4'd8;
  localparam [3:0] GET = 4'd9;
  localparam [3:0] PUT = 4'd10;  // a word, or its high byte
  localparam [3:0] PUT_LOW = 4'd11;
  localparam [3:0] FINISH = 4'd12;
  localparam [3:0] HEAD_DONE = 4'd13;
  localparam [3:0] COMPARE = 4'd14;  // block_q's deadline, which comes late in the clock

  reg [3:0] state_q;
  reg [2:0] job_q;
  reg [1:0] class_q;
  reg own_q;  // a frame of the table, else a record
  reg side_q;  // that it comes from; an own frame: that it goes to
  reg [4:0] block_q;
  reg [4:0] left_q;  // blocks to look at
  reg [6:0] index_q;
  reg [63:0] head_q;
  reg [15:0] word_q;
  reg drop_q;  // the record is good for nothing
  // Buffers whose next frame is an own one, or one that goes through, if there is one: if a look at all blocks, or
  // all jobs, that began with the buffer free has not found one, the other kind may go again.
  reg [3:0] own_next_q;
  reg [3:0] through_next_q;
  reg [3:0] seen_q;  // were free when the look began
  // Buffers that a block of the table has the next turn on, and which.
  reg [3:0] claimed_q;
  reg [19:0] claims_q;
  reg done_valid_q;
  reg [4:0] done_block_q;
  reg [7:0] done_status_q;
  reg event_valid_q;
  reg event_was_q;
  reg [42:0] event_q;
  reg [15:0] late_q;

  wire [7:0] head_from = head_q[55:48];
  wire [2:0] head_type = head_q[42:40];
  wire [7:0] head_tag = head_q[39:32];
  wire [7:0] head_status = head_q[15:8];
  wire [5:0] head_count = head_q[5:0];
  wire has_words = (head_type == WRITE || head_type == READ_REPLY) && head_count != 6'd0;

  // ---- time ----
  reg [15:0] now_q;
  reg [15:0] stall_q;
  reg stalled_q;
  wire event_room = event_block_valid_i && !event_valid_q && !event_was_q;
  // A value of now_q in the last 2^15 ms has passed.
  reg overdue_q;  // in state DEADLINE
  wire stall_over = ((now_q - stall_q) & 16'h8000) == 16'd0;

  always @(posedge clk_i) begin
    overdue_q <= ((now_q - table_data_i) & 16'h8000) == 16'd0;
    if (!rst_ni) now_q <= 16'd0;
    else if (millisecond_i) now_q <= now_q + 16'd1;
    // A begun millisecond does not count.
    if (!rst_ni || event_room) stall_q <= deadline_o;
    if (!rst_ni || event_room) stalled_q <= 1'b0;
    else if (stall_over) stalled_q <= 1'b1;
  end

  assign deadline_o = now_q + timeout_ms_i + 16'd1;

  // ---- is there something to do ----
  reg [1:0] job_class;
  always @(*) begin
    case (job_q[2:1])
      2'd0: job_class = OWN_REPLY;
      2'd1: job_class = THROUGH_REPLY;
      2'd2: job_class = EVENT;
      default: job_class = THROUGH;
    endcase
  end

  wire job_side = job_q[0];
  wire [3:0] through_free = lane_free_i & ~own_next_q;
  wire [3:0] own_free = lane_free_i & ~through_next_q;
  wire [1:0] other_side = job_side ? through_free[1:0] : through_free[3:2];
  reg job_room;
  always @(*) begin
    case (job_class)
      OWN_REPLY: job_room = !done_valid_q;
      THROUGH_REPLY: job_room = other_side[0];
      EVENT: job_room = event_room || stalled_q;
      default: job_room = other_side[1];
    endcase
  end
  wire job_go = found_i[job_side] && job_room;

  // Blocks of event commands have replies, the others requests.
  wire block_event = block_q[4:3] == 2'b10;
  wire [1:0] own_lane = {table_lower_i, !block_event};
  wire own_turn = !claimed_q[own_lane] || claims_q[5*own_lane+:5] == block_q;
  wire own_wants = table_queued_i && (block_event || !down_i[table_lower_i]);
  wire own_go = own_wants && own_turn && own_free[own_lane];
  wire expired = state_q == DEADLINE && overdue_q && !done_valid_q;
  wire [4:0] next_block = block_q == LAST_BLOCK ? 5'd0 : block_q + 5'd1;

  wire visit = (state_q == SCAN && !table_open_i) || state_q == DEADLINE;
  wire own_waits = own_wants && !expired && !own_go;
  integer i;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      claimed_q <= 4'd0;
    end else if (visit) begin
      for (i = 0; i < 4; i = i + 1) begin
        if (own_waits && own_lane == i[1:0]) begin
          if (!claimed_q[i]) claims_q[5*i+:5] <= block_q;
          claimed_q[i] <= 1'b1;
        end else if (claims_q[5*i+:5] == block_q) begin
          claimed_q[i] <= 1'b0;
        end
      end
    end
  end

  // ---- a reply and its request ----
  wire matching = state_q == MATCH;
  wire match_route = table_open_i && table_data_i[3:0] == head_from[3:0] &&
      head_type == (table_data_i[14] ? WRITE_REPLY : READ_REPLY) &&
      (table_data_i[14] || head_count == (head_status == DONE ? table_data_i[13:8] : 6'd0));
  wire match_use = table_data_i[6:0] == {head_from[7:4], head_tag[7:5]};

  // ---- words ----
  wire to_pool = !own_q && class_q[1];
  wire to_lane = !to_pool;
  wire [4:0] word_index = index_q[4:0];
  wire out_done = index_q == HEAD_BYTES;  // the head has been turned once round
  wire last_word = index_q[5:0] + 6'd1 == head_count;
  wire [7:0] ring_data = side_q ? lower_data_i : upper_data_i;
  wire nobody = state_q == TABLE && index_q[1:0] == 2'd1 && table_data_i[15];
  wire finished = state_q == FINISH;
  // Lane of the frame: replies or requests; side: own frames' or across.
  wire lane_request = own_q ? !block_event : !class_q[0];
  wire lane_side = own_q ? side_q : !side_q;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q <= JOBS;
      job_q   <= 3'd0;
      block_q <= 5'd0;
      own_next_q <= 4'd0;
      through_next_q <= 4'd0;
    end else begin
      case (state_q)
        JOBS: begin
          job_q   <= job_q + 3'd1;
          index_q <= 7'd0;
          class_q <= job_class;
          side_q  <= job_side;
          own_q   <= 1'b0;
          drop_q  <= job_class == EVENT && !event_room;
          left_q  <= LAST_BLOCK;
          if (job_go) state_q <= HEAD;
          else if (job_q == 3'd7) state_q <= SCAN;
          if (job_q == 3'd0 || job_q == 3'd7) seen_q <= lane_free_i;
          if (job_q == 3'd7) through_next_q <= through_next_q & ~seen_q;
        end
        SCAN: begin
          own_q  <= 1'b1;
          side_q <= table_lower_i;
          if (table_open_i) begin
            state_q <= COMPARE;
          end else if (own_go) begin
            state_q <= TABLE;
          end else begin
            block_q <= next_block;
            left_q  <= left_q - 5'd1;
            if (left_q == 5'd0) state_q <= JOBS;
          end
          if (left_q == 5'd0) own_next_q <= own_next_q & ~seen_q;
        end
        COMPARE: state_q <= DEADLINE;
        DEADLINE: begin
          if (!expired && own_go) begin
            state_q <= TABLE;
          end else begin
            block_q <= next_block;
            left_q  <= left_q - 5'd1;
            state_q <= left_q == 5'd0 ? JOBS : SCAN;
          end
        end
        TABLE: begin
          index_q <= index_q + 7'd1;
          if (nobody) begin
            block_q <= next_block;
            state_q <= JOBS;
          end else if (index_q[1:0] == 2'd3) begin
            index_q <= 7'd0;
            state_q <= OUT;
          end
        end
        HEAD: begin
          index_q <= index_q + 7'd1;
          if (index_q == HEAD_BYTES) begin
            index_q <= 7'd0;
            state_q <= HEAD_DONE;
          end
        end
        MATCH: begin
          index_q <= index_q + 7'd1;
          if (index_q[1:0] == 2'd1 && !match_route) drop_q <= 1'b1;
          if (index_q[1:0] == 2'd2 && !match_use) drop_q <= 1'b1;
          if (index_q[1:0] == 2'd3) begin
            index_q <= 7'd0;
            state_q <= has_words && !drop_q ? FETCH : FINISH;
          end
        end
        OUT: begin
          index_q <= index_q + 7'd1;
          if (out_done) begin
            index_q <= 7'd0;
            state_q <= has_words ? FETCH : FINISH;
          end
        end
        FETCH: if (!own_q || mem_ready_i) state_q <= own_q ? GET : FETCH_LOW;
        FETCH_LOW: state_q <= GET;
        GET: state_q <= PUT;
        PUT:
        if (to_lane) begin
          state_q <= PUT_LOW;
        end else if (mem_ready_i) begin
          index_q <= index_q + 7'd1;
          state_q <= last_word ? FINISH : FETCH;
        end
        PUT_LOW: begin
          index_q <= index_q + 7'd1;
          state_q <= last_word ? FINISH : FETCH;
        end
        HEAD_DONE: begin
          if (class_q[1] == 1'b0) state_q <= OUT;
          else if (class_q == OWN_REPLY) state_q <= MATCH;
          else state_q <= has_words && !drop_q ? FETCH : FINISH;
        end
        default:
        if (finished) begin
          state_q <= JOBS;
          if (own_q) block_q <= next_block;
          if (to_lane) begin
            own_next_q[{lane_side, lane_request}] <= !own_q;
            through_next_q[{lane_side, lane_request}] <= own_q;
          end
        end
      endcase
    end
  end

  // ---- the head ----
  always @(posedge clk_i) begin
    case (state_q)
      HEAD: if (index_q != 7'd0) head_q <= {head_q[55:0], ring_data};
      OUT:  if (!out_done) head_q <= {head_q[55:0], head_q[63:56]};
      TABLE:
      case (index_q[1:0])
        2'd1: begin
          head_q[63:56] <= {4'd0, table_data_i[3:0]};
          head_q[47:40] <= {5'd0, block_event ?
              (table_data_i[14] ? WRITE_REPLY : READ_REPLY) : (table_data_i[14] ? WRITE : READ)};
          head_q[7:0] <= {2'd0, table_data_i[13:8]};
        end
        2'd2: head_q[23:8] <= table_data_i;
        2'd3: begin
          head_q[55:48] <= {table_data_i[6:3], unit_i};
          head_q[39:32] <= block_event ? table_data_i[15:8] : {table_data_i[2:0], block_q};
          head_q[31:24] <= block_event ? 8'd0 : table_data_i[15:8];
          // No words but those of a read that is done.
          if (block_event && (head_type == WRITE_REPLY || head_q[15:8] != DONE)) begin
            head_q[7:0] <= 8'd0;
          end
        end
        default: ;
      endcase
      default: ;
    endcase

    if (state_q == FETCH_LOW) word_q[15:8] <= ring_data;
    if (state_q == GET) begin
      word_q[7:0] <= own_q ? mem_rdata_i[7:0] : ring_data;
      if (own_q) word_q[15:8] <= mem_rdata_i[15:8];
    end
  end

  // ---- what a finished one brings ----
  wire deliver = finished && !own_q && !drop_q;
  wire complete = deliver && class_q == OWN_REPLY;
  wire give = deliver && class_q == EVENT;

  always @(posedge clk_i) begin
    if (complete) begin
      done_block_q  <= head_tag[4:0];
      done_status_q <= head_status;
    end else if (!done_valid_q) begin
      done_block_q  <= block_q;
      done_status_q <= nobody ? REFUSED : NO_REPLY;
    end
    if (give) begin
      event_q <= {head_type == WRITE, head_q[31:24], head_q[23:8], head_count, head_from[3:0],
          head_tag};
    end

    event_was_q <= event_valid_q;
    if (!rst_ni) begin
      done_valid_q <= 1'b0;
      event_valid_q <= 1'b0;
      late_q <= 16'd0;
    end else begin
      if (complete || expired || (nobody && !done_valid_q)) done_valid_q <= 1'b1;
      else if (done_ready_i) done_valid_q <= 1'b0;
      if (give) event_valid_q <= 1'b1;
      else if (event_ready_i) event_valid_q <= 1'b0;
      if (finished && drop_q) late_q <= late_q + 16'd1;
    end
  end

  assign find_class_o = state_q == JOBS ? job_class : class_q;
  assign ring_read_o = state_q == HEAD || state_q == FETCH || state_q == FETCH_LOW;
  assign ring_index_o = state_q == HEAD ? index_q :
      HEAD_BYTES + {1'b0, word_index, state_q == FETCH_LOW};
  assign ring_free_o = {2{finished && !own_q}} & {side_q, !side_q};

  assign lane_write_o = (state_q == OUT && !out_done) ||
      (to_lane && (state_q == PUT || state_q == PUT_LOW));
  assign lane_addr_o = {lane_side, lane_request, state_q == OUT ? index_q :
      HEAD_BYTES + {1'b0, word_index, state_q == PUT_LOW}};
  assign lane_data_o = state_q == OUT ? head_q[63:56] :
      state_q == PUT ? word_q[15:8] : word_q[7:0];
  assign lane_length_o = HEAD_BYTES + (has_words ? {head_count, 1'b0} : 7'd0);
  assign lane_commit_o = {3'd0, finished && to_lane} << {lane_side, lane_request};

  assign table_block_o = complete || matching ? head_tag[4:0] : block_q;
  assign table_sent_o = finished && own_q;
  assign table_ended_o = complete || expired || (nobody && !done_valid_q);
  assign table_read_o = 1'b1;
  assign table_word_o = state_q == SCAN ? 2'd0 : matching ? {index_q[0], 1'b1} :
      index_q[1:0] + 2'd1;

  assign mem_valid_o = (state_q == FETCH && own_q) || (state_q == PUT && to_pool);
  assign mem_write_o = state_q == PUT;
  assign mem_addr_o = {own_q ? block_q : class_q[0] ? head_tag[4:0] : event_block_i, word_index};
  assign mem_wdata_o = word_q;

  assign done_valid_o = done_valid_q;
  assign done_block_o = done_block_q;
  assign done_status_o = done_status_q;
  assign event_valid_o = event_valid_q;
  assign {event_write_o, event_board_o, event_first_o, event_count_o} = event_q[42:12];
  assign event_from_o = {4'd0, event_q[11:8]};
  assign event_tag_o = event_q[7:0];
  assign event_given_o = give;
  assign event_use_o = head_from[7:4];
  assign reply_done_valid_o = finished && own_q && block_event;
  assign reply_done_block_o = block_q;
  assign late_o = late_q;

endmodule

`default_nettype wire

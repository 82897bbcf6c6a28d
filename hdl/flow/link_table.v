// SPDX-License-Identifier: Apache-2.0
// What this unit has to send of its own, by block of the pool: the scheduler's requests and its replies to event
// commands, each until it is sent, and requests until they are complete. A block has one at a time, so that the table
// has room for all that there can be. In the 32 clocks after reset it takes nothing.
//
// A request or reply is taken in a clock; the next one can be in the fifth clock after it. Words of a block
// (read data in the clock after read_i):
//   0  deadline, a value of now_i
//   1  bit 15: nobody can be asked that, 14: write, 13:8 count, 7:0 unit that it goes to
//   2  first variable; a reply's status
//   3  request: 15:8 board, 6:0 use; reply: 15:8 tag, 6:3 the requester's further bits of it
// The tag of a request is 32 * use + block, the frame's `from` has the upper bits of use. use changes with each
// request of the block, so that a late answer matches a later request only after 128 of them; not even a reset
// lets it begin anew.
`default_nettype none

module link_table (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire [ 3:0] unit_i,
    input  wire [15:0] deadline_i,
    // requests
    input  wire        req_valid_i,
    output wire        req_ready_o,
    input  wire [ 4:0] req_block_i,
    input  wire        req_write_i,
    input  wire [ 7:0] req_unit_i,
    input  wire [ 7:0] req_board_i,
    input  wire [15:0] req_first_i,
    input  wire [ 5:0] req_count_i,
    // replies
    input  wire        reply_valid_i,
    output wire        reply_ready_o,
    input  wire [ 4:0] reply_block_i,
    input  wire        reply_write_i,
    input  wire [ 7:0] reply_status_i,
    input  wire [ 5:0] reply_count_i,
    input  wire [ 7:0] reply_to_i,
    input  wire [ 7:0] reply_tag_i,
    // the requester's further bits of the tag of an event command
    input  wire        event_given_i,
    input  wire [ 2:0] event_block_i,
    input  wire [ 3:0] event_use_i,
    // look-up of a block, in the same clock
    input  wire [ 4:0] block_i,
    output wire        open_o,  // a request that is not complete
    output wire        queued_o,  // to be sent
    output wire        lower_o,  // on the lower side
    input  wire        sent_i,
    input  wire        ended_i,
    // its words
    input  wire        read_i,
    input  wire [ 1:0] read_word_i,
    output wire [15:0] read_data_o
);

  localparam [5:0] MOST_WORDS = 6'd32;
  localparam [1:0] LAST = 2'd3;

  // Marks of the blocks, in LUT memories with a write port each: queued is where entered and left differ, open
  // likewise. After reset all are made equal, a block a clock.
  reg [2:0] entered_q[0:31];  // lower side, open, queued
  reg [1:0] left_q[0:31];  // open, queued
  reg clearing_q;
  reg [4:0] clear_q;
  reg [6:0] use_q[0:31];
  reg [3:0] event_use_q[0:7];

  // ---- one is taken ----
  reg busy_q;
  reg reply_q;
  reg [1:0] word_q;
  reg [4:0] block_q;
  reg [15:0] route_q;
  reg [15:0] first_q;
  reg [15:0] tag_q;

  wire take_request = req_valid_i && req_ready_o;
  wire take_reply = reply_valid_i && reply_ready_o;
  wire [3:0] unit = req_unit_i[3:0];
  wire nobody = req_unit_i[7:4] != 4'd0 || unit == 4'd0 || unit == unit_i ||
      req_count_i == 6'd0 || req_count_i > MOST_WORDS;
  wire entered = busy_q && word_q == LAST;

  // No reset: see above.
  always @(posedge clk_i) begin
    if (entered && !reply_q) use_q[block_q] <= tag_q[6:0] + 7'd1;
    if (event_given_i) event_use_q[event_block_i] <= event_use_i;
  end

  always @(posedge clk_i) begin
    if (take_request) begin
      reply_q <= 1'b0;
      block_q <= req_block_i;
      route_q <= {nobody, req_write_i, req_count_i, 4'd0, unit};
      first_q <= req_first_i;
      tag_q   <= {req_board_i, 1'b0, use_q[req_block_i]};
    end else if (take_reply) begin
      reply_q <= 1'b1;
      block_q <= reply_block_i;
      route_q <= {1'b0, reply_write_i, reply_count_i, reply_to_i};
      first_q <= {8'd0, reply_status_i};
      tag_q   <= {reply_tag_i, 1'b0, event_use_q[reply_block_i[2:0]], 3'd0};
    end
    if (!rst_ni) busy_q <= 1'b0;
    else if (take_request || take_reply) busy_q <= 1'b1;
    else if (entered) busy_q <= 1'b0;
    word_q <= busy_q ? word_q + 2'd1 : 2'd0;
  end

  always @(posedge clk_i) begin
    clearing_q <= !rst_ni || (clearing_q && clear_q != 5'd31);
    clear_q <= clearing_q && rst_ni ? clear_q + 5'd1 : 5'd0;
  end

  wire [2:0] entered_marks = entered_q[block_i];
  wire [1:0] left_marks = left_q[block_i];
  wire [1:0] marks = entered_marks[1:0] ^ left_marks;
  wire leaves = sent_i || ended_i;
  wire [4:0] enter_block = clearing_q ? clear_q : block_q;
  wire [4:0] leave_block = clearing_q ? clear_q : block_i;
  wire lower = route_q[3:0] > unit_i;
  wire [1:0] to_differ = ~left_q[block_q];

  always @(posedge clk_i) begin
    if (clearing_q || entered) begin
      entered_q[enter_block] <= clearing_q ? 3'd0 : {lower, to_differ[1] ^ reply_q, to_differ[0]};
    end
    if (clearing_q || leaves) begin
      left_q[leave_block] <= clearing_q ? 2'd0 :
          {ended_i ? entered_marks[1] : left_marks[1], entered_marks[0]};
    end
  end

  wire [15:0] word = word_q == 2'd0 ? deadline_i : word_q == 2'd1 ? route_q :
      word_q == 2'd2 ? first_q : tag_q;

  bank_ram #(
      .WIDTH(16),
      .DEPTH(128),
      .ADDR_BITS(7),
      .CLEARED(0)
  ) entries (
      .clk_i       (clk_i),
      .read_i      (read_i),
      .read_addr_i ({block_i, read_word_i}),
      .read_data_o (read_data_o),
      .write_i     (busy_q),
      .write_addr_i({block_q, word_q}),
      .write_data_i(word)
  );

  assign req_ready_o = !busy_q && !clearing_q;
  assign reply_ready_o = req_ready_o && !req_valid_i;
  assign open_o = marks[1] && !clearing_q;
  assign queued_o = marks[0] && !clearing_q;
  assign lower_o = entered_marks[2];

endmodule

`default_nettype wire

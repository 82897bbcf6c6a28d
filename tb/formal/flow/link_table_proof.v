// SPDX-License-Identifier: Apache-2.0
// Table of own frames (hdl/flow/link_table.v), of any block and any word of it: each request and reply that is taken is queued until
// it is sent, a request open until it is complete, and neither ever again; its words are those of its page; its side is that of its
// unit; each request of the block has the use behind that of the one before, resets or not. The next one is taken in the fifth
// clock, a reply behind a request, and nothing in the 32 clocks after a reset.
`default_nettype none
`include "rung_flow.vh"

module link_table_proof (
    input wire         clk_i,
    input wire         rst_ni,
    input wire [ 15:0] deadline_i,
    input wire         req_valid_i,
    input wire [  4:0] req_block_i,
    input wire         req_write_i,
    input wire [  7:0] req_unit_i,
    input wire [  7:0] req_board_i,
    input wire [ 15:0] req_first_i,
    input wire [  5:0] req_count_i,
    input wire         reply_valid_i,
    input wire [  4:0] reply_block_i,
    input wire         reply_write_i,
    input wire [  7:0] reply_status_i,
    input wire [  5:0] reply_count_i,
    input wire [  7:0] reply_to_i,
    input wire [  7:0] reply_tag_i,
    input wire         event_given_i,
    input wire [  2:0] event_block_i,
    input wire [  3:0] event_use_i,
    input wire [  4:0] block_i,
    input wire         sent_i,
    input wire         ended_i,
    input wire         read_i,
    input wire [  1:0] read_word_i,
    // inside of it
    input wire [  6:0] peek_watched,
    input wire [ 15:0] peek_word,
    input wire [ 95:0] peek_entered,
    input wire [ 63:0] peek_left,
    input wire [223:0] peek_use,
    input wire [ 31:0] peek_event_use,
    input wire         peek_clearing,
    input wire [  4:0] peek_clear,
    input wire         peek_busy,
    input wire [  1:0] peek_index,
    input wire         peek_reply,
    input wire [  4:0] peek_block,
    input wire [ 15:0] peek_route,
    input wire [ 15:0] peek_first,
    input wire [ 15:0] peek_tag
);

  (* anyconst *) wire [3:0] unit;
  (* anyconst *) wire [4:0] block;
  (* anyconst *) wire [1:0] word;
  always @* assume (peek_watched == {block, word});

  wire req_ready, reply_ready, open, queued, lower;
  wire [15:0] read_data;
  link_table table_of_frames (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .unit_i        (unit),
      .deadline_i    (deadline_i),
      .req_valid_i   (req_valid_i),
      .req_ready_o   (req_ready),
      .req_block_i   (req_block_i),
      .req_write_i   (req_write_i),
      .req_unit_i    (req_unit_i),
      .req_board_i   (req_board_i),
      .req_first_i   (req_first_i),
      .req_count_i   (req_count_i),
      .reply_valid_i (reply_valid_i),
      .reply_ready_o (reply_ready),
      .reply_block_i (reply_block_i),
      .reply_write_i (reply_write_i),
      .reply_status_i(reply_status_i),
      .reply_count_i (reply_count_i),
      .reply_to_i    (reply_to_i),
      .reply_tag_i   (reply_tag_i),
      .event_given_i (event_given_i),
      .event_block_i (event_block_i),
      .event_use_i   (event_use_i),
      .block_i       (block_i),
      .open_o        (open),
      .queued_o      (queued),
      .lower_o       (lower),
      .sent_i        (sent_i),
      .ended_i       (ended_i),
      .read_i        (read_i),
      .read_word_i   (read_word_i),
      .read_data_o   (read_data)
  );

  reg begun_q;
  reg warm_q;
  initial {begun_q, warm_q} = 2'b00;
  always @(posedge clk_i) {begun_q, warm_q} <= {1'b1, begun_q};
  always @* if (!begun_q) assume (!rst_ni);
`ifdef RUNG_NARROW
  always @* begin
    assume (rst_ni == begun_q && unit == 4'd7 && block == 5'd17 && word == 2'd3 &&
        deadline_i == 16'd0);
    assume (!event_given_i && req_block_i == block && reply_block_i == block && block_i == block);
    assume (cold_q == 6'd0 || !(req_valid_i || reply_valid_i || sent_i || ended_i || read_i));
    assume (req_first_i == 16'd0 && req_board_i == 8'd0 && !req_write_i && req_count_i == 6'd1);
    assume (reply_tag_i == 8'd0 && reply_status_i == 8'd0 && !reply_write_i &&
        reply_count_i == 6'd1);
  end
`endif

  // ---- when something is taken -------------------------------------------------------------------------
  reg [5:0] cold_q;  // clocks until the first one after a reset in which it may be
  reg [2:0] since_q;  // clocks since the last one was taken, 1 to 4; then 0
  wire takes_request = rst_ni && req_valid_i && req_ready;
  wire takes_reply = rst_ni && reply_valid_i && reply_ready;
  always @(posedge clk_i) begin
    if (!rst_ni) cold_q <= 6'd32;
    else if (cold_q != 6'd0) cold_q <= cold_q - 6'd1;
    if (!rst_ni) since_q <= 3'd0;
    else if (takes_request || takes_reply) since_q <= 3'd1;
    else if (since_q != 3'd0) since_q <= since_q == 3'd4 ? 3'd0 : since_q + 3'd1;
  end
  wire free = cold_q == 6'd0 && since_q == 3'd0;

  // ---- what the block has -----------------------------------------------------------------------------
  wire request = takes_request && req_block_i == block;
  wire reply = takes_reply && reply_block_i == block;
  wire here = block_i == block;
  reg comes_q;  // the one that was taken last is the block's
  reg comes_reply_q;
  reg open_q;
  reg queued_q;
  reg lower_q;
  reg nobody_q;
  // What its words have to be, word 0 highest; word 0 is filled in when it is written.
  reg [63:0] words_q;
  reg [6:0] use_q;  // of its next request: anything at first
  reg event_known_q;
  reg [3:0] event_use_q;
  wire nobody = req_unit_i == 8'd0 || req_unit_i > `RUNG_FLOW_UNITS || req_unit_i == {4'd0, unit} ||
      req_count_i == 6'd0 || req_count_i > `RUNG_FLOW_BLOCK_WORDS;

  reg known_use_q;  // when the reply was taken
  always @(posedge clk_i) if (takes_reply) known_use_q <= event_known_q;

  // A block has one at a time.
  wire taken = open_q || queued_q || (since_q != 3'd0 && comes_q);
  always @* begin
    assume (!(req_valid_i && req_block_i == block && taken));
    assume (!(reply_valid_i && reply_block_i == block && taken));
    assume (!(req_valid_i && reply_valid_i && req_block_i == block && reply_block_i == block));
    assume (!reply_valid_i || reply_to_i <= `RUNG_FLOW_UNITS);
  end

  always @(posedge clk_i) begin
    if (takes_request || takes_reply) comes_q <= request || reply;
    if (takes_request || takes_reply) comes_reply_q <= reply;
    if (request) begin
      nobody_q <= nobody;
      words_q[47:0] <= {
        nobody, req_write_i, req_count_i, req_unit_i, req_first_i, req_board_i, 1'b0, use_q
      };
      lower_q <= req_unit_i > {4'd0, unit};
    end
    if (reply) begin
      nobody_q <= 1'b0;
      words_q[47:0] <= {
        1'b0,
        reply_write_i,
        reply_count_i,
        reply_to_i,
        8'd0,
        reply_status_i,
        reply_tag_i,
        1'b0,
        event_use_q,
        3'd0
      };
      lower_q <= reply_to_i > {4'd0, unit};
    end
    if (since_q == 3'd1 && comes_q) words_q[63:48] <= deadline_i;
    if (since_q == 3'd4 && comes_q && !comes_reply_q) use_q <= use_q + 7'd1;
    if (!begun_q) event_known_q <= 1'b0;
    else if (event_given_i && event_block_i == block[2:0]) event_known_q <= 1'b1;
    if (event_given_i && event_block_i == block[2:0]) event_use_q <= event_use_i;

    if (!rst_ni) {open_q, queued_q} <= 2'b00;
    else if (since_q == 3'd4 && comes_q) {open_q, queued_q} <= {!comes_reply_q, 1'b1};
    else if (here && ended_i) {open_q, queued_q} <= 2'b00;
    else if (here && sent_i) queued_q <= 1'b0;
  end

  // ---- the watched word: what it has to be from the clock on that writes it ------------------------------
  wire writes = since_q == {1'b0, word} + 3'd1 && comes_q;
  // Bits of a word that mean something.
  reg [15:0] means;
  reg [15:0] due;
  always @* begin
    due   = word == 2'd0 ? deadline_i : words_q[16*(2'd3-word)+:16];
    means = 16'hffff;
    if (word == 2'd1 && nobody_q) means = 16'h8000;
    if (word == 2'd3 && !comes_reply_q) means = 16'hff7f;
    if (word == 2'd3 && comes_reply_q) means = known_use_q ? 16'hff78 : 16'hff00;
  end
  reg known_q;
  reg [15:0] word_q;
  reg [15:0] means_q;
  reg read_q;
  reg [15:0] read_word_q;
  reg [15:0] read_means_q;
  always @(posedge clk_i) begin
    if (!begun_q) known_q <= 1'b0;
    else if (writes) known_q <= 1'b1;
    if (writes) {word_q, means_q} <= {due, means};
    read_q <= begun_q && known_q && read_i && here && read_word_i == word && !writes;
    {read_word_q, read_means_q} <= {word_q, means_q};
  end

  always @* begin
    if (begun_q) begin
      assert (req_ready == free);
      assert (reply_ready == (free && !req_valid_i));
      if (here) assert (open == open_q && queued == queued_q);
      if (here && queued_q && !nobody_q) assert (lower == lower_q);
      if (read_q) assert ((read_data & read_means_q) == (read_word_q & read_means_q));
    end
  end

  // ---- for the induction -------------------------------------------------------------------------------
  wire [2:0] entered = peek_entered[3*block+:3];
  wire [1:0] left = peek_left[2*block+:2];
  always @* begin
    if (begun_q && !warm_q)
      assume (peek_use[7*block+:7] == use_q);  // whatever the first reset leaves
    if (begun_q) begin
      assert (cold_q <= 6'd32 && since_q <= 3'd4 && (cold_q == 6'd0 || since_q == 3'd0));
      assert (peek_clearing == (cold_q != 6'd0));
      if (cold_q != 6'd0) assert ({1'b0, peek_clear} == 6'd32 - cold_q);
      assert (peek_busy == (since_q != 3'd0));
      if (cold_q == 6'd0) assert (peek_index == (since_q == 3'd0 ? 2'd0 : since_q[1:0] - 2'd1));
      if (cold_q == 6'd0)
        assert ((entered[1:0] ^ left) == {open_q, queued_q});
        else if (block < peek_clear) assert (entered[1:0] == left);
      if (cold_q != 6'd0) assert (!open_q && !queued_q);
      if (queued_q && !nobody_q) assert (entered[2] == lower_q);
      if (open_q || queued_q) assert (!(since_q != 3'd0 && comes_q));
      assert (peek_use[7*block+:7] == use_q);
      if (event_known_q) assert (peek_event_use[4*block[2:0]+:4] == event_use_q);
      if (since_q != 3'd0) begin
        assert (comes_q == (peek_block == block));
        if (comes_q) begin
          assert (peek_reply == comes_reply_q);
          assert (peek_route[15] == nobody_q);
          if (!nobody_q) assert (peek_route == words_q[47:32]);
          if (!nobody_q) assert (lower_q == (peek_route[3:0] > unit));
          if (nobody_q) assert (words_q[47]);
          assert (peek_first == words_q[31:16]);
          assert (peek_tag[15:8] == words_q[15:8]);
          if (!comes_reply_q)
            assert (peek_tag[6:0] == words_q[6:0] && words_q[6:0] == use_q);
            else if (known_use_q) assert (peek_tag[6:3] == words_q[6:3]);
        end
      end
      if (known_q) assert ((peek_word & means_q) == (word_q & means_q));
    end
  end

  // ---- covers ---------------------------------------------------------------------------------------------
  reg [6:0] first_use_q;
  always @(posedge clk_i) if (!warm_q) first_use_q <= use_q;
  always @* begin
    cover (begun_q && rst_ni && here && queued && !open && lower && since_q == 3'd0);  // a reply
    cover (begun_q && read_q && word == 2'd3 && read_means_q == 16'hff7f &&
           read_word_q[6:0] == first_use_q + 7'd1);
  end

endmodule

`default_nettype wire

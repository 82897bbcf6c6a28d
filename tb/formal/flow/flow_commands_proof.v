// SPDX-License-Identifier: Apache-2.0
// Commands of a round (hdl/flow/flow_commands.v): the PC's, and the event command of any block. Each one that is taken is sent once, copied
// or refused, as it was asked for; an event command has then one reply, with its status, and only that frees its place in the ring;
// the PC's state is WAIT, EXECUTE or PAUSE as its page says, and nobody changes what it asks for. Event commands are looked at in the
// order in which they came, suspended ones behind the others, each once a round; a round has a bounded number of clocks, beside those
// in which it waits for a copy, a request that goes out, or, in place, for data. A round may be stopped at any time.
`default_nettype none
`include "rung_controller.vh"
`include "rung_flow.vh"
`include "flow_ops.vh"

module flow_commands_proof (
    input wire         clk_i,
    input wire         rst_ni,
    input wire         start_i,
    input wire         stop_i,
    input wire         event_valid_i,
    input wire [  4:0] event_block_i,
    input wire         event_block_valid_i,
    input wire         event_write_i,
    input wire [  7:0] event_board_i,
    input wire [ 15:0] event_first_i,
    input wire [  5:0] event_count_i,
    input wire [  7:0] event_from_i,
    input wire [  7:0] event_tag_i,
    input wire         reply_ready_i,
    input wire         completes_i,          // of the watched block
    input wire         pc_completes_i,
    input wire [  7:0] status_i,
    input wire [  1:0] way_i,
    input wire         gives_up_i,
    input wire         exclusive_i,
    input wire         held_i,
    input wire         sending_i,
    input wire         copy_done_i,
    input wire         sel_register_i,
    input wire [  7:0] addr_i,
    input wire         read_i,
    input wire         write_i,
    input wire [ 15:0] wdata_i,
    input wire [  8:0] came_i,
    // inside of it
    input wire [  3:0] peek_state,
    input wire         peek_of_pc,
    input wire [ 23:0] peek_ring,
    input wire [  2:0] peek_read,
    input wire [  2:0] peek_write,
    input wire [  3:0] peek_held,
    input wire [  3:0] peek_left,
    input wire [  2:0] peek_head,
    input wire [  7:0] peek_waits,
    input wire [  7:0] peek_replies,
    input wire [375:0] peek_events,
    input wire [ 63:0] peek_finals,
    input wire [  7:0] peek_status,
    input wire [  1:0] peek_pc_state,
    input wire         peek_pc_write,
    input wire [ 47:0] peek_pc,
    input wire [  7:0] peek_pc_status,
    input wire         peek_begun
);

  (* anyconst *) wire [2:0] event_number;  // the watched event block
  (* anyconst *) wire in_place;
  (* anyconst *) wire [3:0] unit;
  wire [4:0] event_block = `RUNG_FLOW_TASK_BLOCKS + {2'd0, event_number};

  wire done, event_ready, reply_valid, reply_write, take, lock, frees, send, write, copy_start;
  wire held, failed, executed, suspended, pc_waiting;
  wire [4:0] reply_block, block;
  wire [7:0] reply_status, reply_to, reply_tag;
  wire [5:0] reply_count;
  wire [15:0] resource, first, count, rdata;
  flow_commands commands (
      .clk_i              (clk_i),
      .rst_ni             (rst_ni),
      .start_i            (start_i),
      .stop_i             (stop_i),
      .done_o             (done),
      .in_place_i         (in_place),
      .unit_i             (unit),
      .event_valid_i      (event_valid_i),
      .event_ready_o      (event_ready),
      .event_block_i      (event_block_i),
      .event_block_valid_i(event_block_valid_i),
      .event_write_i      (event_write_i),
      .event_board_i      (event_board_i),
      .event_first_i      (event_first_i),
      .event_count_i      (event_count_i),
      .event_from_i       (event_from_i),
      .event_tag_i        (event_tag_i),
      .reply_valid_o      (reply_valid),
      .reply_ready_i      (reply_ready_i),
      .reply_block_o      (reply_block),
      .reply_write_o      (reply_write),
      .reply_status_o     (reply_status),
      .reply_count_o      (reply_count),
      .reply_to_o         (reply_to),
      .reply_tag_o        (reply_tag),
      .came_i             (came_i),
      .status_i           (status_i),
      .take_o             (take),
      .resource_o         (resource),
      .first_o            (first),
      .count_o            (count),
      .way_i              (way_i),
      .gives_up_i         (gives_up_i),
      .exclusive_i        (exclusive_i),
      .held_i             (held_i),
      .lock_o             (lock),
      .free_o             (frees),
      .send_o             (send),
      .write_o            (write),
      .block_o            (block),
      .sending_i          (sending_i),
      .copy_start_o       (copy_start),
      .copy_done_i        (copy_done_i),
      .held_o             (held),
      .failed_o           (failed),
      .executed_o         (executed),
      .suspended_o        (suspended),
      .pc_waiting_o       (pc_waiting),
      .sel_register_i     (sel_register_i),
      .addr_i             (addr_i),
      .read_i             (read_i),
      .write_i            (write_i),
      .wdata_i            (wdata_i),
      .rdata_o            (rdata)
  );

  reg begun_q;
  reg warm_q;
  initial {begun_q, warm_q} = 2'b00;
  always @(posedge clk_i) {begun_q, warm_q} <= {1'b1, begun_q};
  always @* if (!begun_q) assume (!rst_ni);

  // ---- who is around it -----------------------------------------------------------------------------------
  reg going_q, stopped_q, copying_q;
  reg [1:0] since_q;  // clocks since the route took a transfer; 3: its way stays
  reg [1:0] way_q;
  reg of_pc_q;  // it is the PC's,
  reg of_event_q;  // the watched event command's
  reg [7:0] owned_q;  // event blocks that are not offered
  wire accepts = event_valid_i && event_ready && rst_ni;
  wire leaves = reply_valid && reply_ready_i;
  always @* begin
    assume (!(start_i && (going_q || stopped_q)));
    if (event_block_valid_i) assume (event_block_i[4:3] == 2'b10 && !owned_q[event_block_i[2:0]]);
    assume (!copy_done_i || copying_q);
    if (since_q == 2'd3) assume (way_i == way_q);
  end
  integer b;
  always @(posedge clk_i) begin
    if (!rst_ni || stop_i || done) going_q <= 1'b0;
    else if (start_i) going_q <= 1'b1;
    stopped_q <= !rst_ni || stop_i;
    if (!rst_ni || stop_i || copy_done_i) copying_q <= 1'b0;
    else if (copy_start) copying_q <= 1'b1;
    if (take) since_q <= 2'd1;
    else if (since_q != 2'd3) since_q <= since_q + 2'd1;
    way_q <= way_i;
    if (!rst_ni || stop_i || (start_i && !going_q)) {of_pc_q, of_event_q} <= 2'b00;
    else if (take) {of_pc_q, of_event_q} <= {block == `RUNG_FLOW_PC_BLOCK, block == event_block};
    for (b = 0; b < 8; b = b + 1) begin
      if (!rst_ni) owned_q[b] <= 1'b0;
      else if (accepts && event_block_i[2:0] == b[2:0]) owned_q[b] <= 1'b1;
      else if (leaves && reply_block[2:0] == b[2:0]) owned_q[b] <= 1'b0;
    end
  end

  // ---- the watched event command ----------------------------------------------------------------------------
  localparam [1:0] NONE = 2'd0;
  localparam [1:0] NEW = 2'd1;  // or held, or begun and stopped: it has not been sent
  localparam [1:0] SENT = 2'd2;
  localparam [1:0] REPLY = 2'd3;  // all is done but that
  reg [1:0] event_q;
  reg asked_write_q;
  reg [7:0] asked_board_q, asked_from_q, asked_tag_q;
  reg [15:0] asked_first_q;
  reg [5:0] asked_count_q;
  reg asked_out_q;  // data under way,
  reg came_q;  // are there, with
  reg [7:0] came_status_q;
  reg [7:0] final_q;
  reg [3:0] held_q;  // in the ring,
  reg [3:0] ahead_q;  // ahead of it
  reg looked_q;  // it has been looked at in this round
  reg copied_q;
  wire accepted = accepts && event_block_i == event_block;
  wire mine = block == event_block;
  wire leaves_mine = leaves && reply_block == event_block;
  wire finishes = frees && mine;
  wire rotates = peek_state == 4'd12;  // the head goes behind the others
  always @* assume (came_i[event_number] == came_q);
  always @* if (mine && came_q) assume (status_i == came_status_q);
  wire completes = completes_i && asked_out_q;
  always @(posedge clk_i) begin
    if (accepted) begin
      {asked_write_q, asked_board_q} <= {event_write_i, event_board_i};
      asked_first_q <= event_first_i;
      {asked_count_q, asked_from_q, asked_tag_q} <= {event_count_i, event_from_i, event_tag_i};
    end
    if (!rst_ni) event_q <= NONE;
    else if (accepted) event_q <= NEW;
    else if (send && mine) event_q <= SENT;
    else if (finishes) event_q <= REPLY;
    else if (leaves_mine) event_q <= NONE;
    if (finishes) final_q <= event_q == SENT ? came_status_q :
        way_i == `FLOW_WAY_REFUSED ? `RUNG_FLOW_STATUS_REFUSED : `RUNG_FLOW_STATUS_DONE;

    if (!rst_ni) asked_out_q <= 1'b0;
    else if (send && mine) asked_out_q <= 1'b1;
    else if (completes) asked_out_q <= 1'b0;
    if (!rst_ni || (send && mine)) came_q <= 1'b0;
    else if (completes) came_q <= 1'b1;
    if (completes) came_status_q <= status_i;

    if (!rst_ni) held_q <= 4'd0;
    else held_q <= held_q + {3'd0, accepts} - {3'd0, leaves};
    if (accepted) ahead_q <= held_q - {3'd0, leaves};
    else if (rotates && ahead_q == 4'd0) ahead_q <= held_q - 4'd1;
    else if (leaves || rotates) ahead_q <= ahead_q - 4'd1;

    if (start_i || accepted) looked_q <= 1'b0;
    else if ((take || reply_valid) && mine) looked_q <= 1'b1;
    if (take) copied_q <= 1'b0;
    else if (copy_done_i) copied_q <= 1'b1;
  end

  always @* begin
    if (begun_q) begin
      if (take && mine) begin
        assert (event_q == NEW && ahead_q == 4'd0 && !looked_q);
        assert (resource == {4'd0, unit, asked_board_q} && first == asked_first_q);
        assert (count == {10'd0, asked_count_q});
      end
      if (mine && (send || copy_start || lock || held)) assert (event_q == NEW && of_event_q);
      if (mine && (send || copy_start)) assert (write == asked_write_q);
      if (send) assert (way_i == `FLOW_WAY_LINK || way_i == `FLOW_WAY_PANEL);
      if (copy_start) assert (way_i == `FLOW_WAY_LOCAL);
      if (lock) assert (send && exclusive_i);
      if (send && exclusive_i) assert (lock);
      if (finishes) begin
        assert (executed && (event_q == NEW || event_q == SENT));
        if (event_q == SENT) assert (came_q);
        else assert (way_i == `FLOW_WAY_REFUSED || (way_i == `FLOW_WAY_LOCAL && copied_q));
      end
      if (executed) assert (frees && block != `RUNG_FLOW_PC_BLOCK);
      if (reply_valid && reply_block == event_block) begin
        assert (event_q == REPLY && ahead_q == 4'd0 && reply_write == asked_write_q);
        assert (reply_status == final_q && reply_to == asked_from_q && reply_tag == asked_tag_q);
        assert (reply_count == (asked_write_q || final_q != 8'd0 ? 6'd0 : asked_count_q));
      end
      // Every one that comes finds a place.
      if (accepts) assert (held_q < 4'd8);
      if (!going_q && event_block_valid_i) assert (event_ready);
    end
  end

  // ---- the PC's command -----------------------------------------------------------------------------------------
  reg [1:0] pc_q;  // its state: 0 WAIT, 1 EXECUTE, 2 PAUSE
  reg pc_write_q, pc_out_q, pc_came_q;
  reg [7:0] pc_came_status_q, pc_status_q;
  reg [47:0] pc_words_q;  // resource, first, count
  wire of_pc = block == `RUNG_FLOW_PC_BLOCK;
  wire bus_write = sel_register_i && write_i;
  wire pc_begins = bus_write && addr_i == `RUNG_REG_FLOW_PC_CONTROL && wdata_i[0] && pc_q == 2'd0;
  wire pc_finishes = frees && of_pc;
  wire pc_completes = pc_completes_i && pc_out_q;
  always @* assume (came_i[8] == pc_came_q);
  always @* if (of_pc && pc_came_q) assume (status_i == pc_came_status_q);
  reg rdata_known_q;
  reg [15:0] rdata_q;
  always @(posedge clk_i) begin
    if (!rst_ni) pc_q <= 2'd0;
    else if (pc_begins) pc_q <= 2'd1;
    else if (send && of_pc) pc_q <= 2'd2;
    else if (pc_finishes) pc_q <= 2'd0;
    if (pc_begins) pc_write_q <= wdata_i[1];
    if (bus_write && pc_q == 2'd0) begin
      if (addr_i == `RUNG_REG_FLOW_PC_RESOURCE) pc_words_q[47:32] <= wdata_i;
      if (addr_i == `RUNG_REG_FLOW_PC_FIRST) pc_words_q[31:16] <= wdata_i;
      if (addr_i == `RUNG_REG_FLOW_PC_COUNT) pc_words_q[15:0] <= wdata_i;
    end
    if (!rst_ni) pc_status_q <= 8'd0;
    else if (pc_finishes) begin
      pc_status_q <= pc_q == 2'd2 ? pc_came_status_q :
          way_i == `FLOW_WAY_REFUSED ? `RUNG_FLOW_STATUS_REFUSED : `RUNG_FLOW_STATUS_DONE;
    end
    if (!rst_ni) pc_out_q <= 1'b0;
    else if (send && of_pc) pc_out_q <= 1'b1;
    else if (pc_completes) pc_out_q <= 1'b0;
    if (!rst_ni || (send && of_pc)) pc_came_q <= 1'b0;
    else if (pc_completes) pc_came_q <= 1'b1;
    if (pc_completes) pc_came_status_q <= status_i;
    rdata_known_q <= begun_q;
    rdata_q <= 16'd0;
    if (sel_register_i && read_i) begin
      case (addr_i)
        `RUNG_REG_FLOW_PC_CONTROL: rdata_q <= {14'd0, pc_q};
        `RUNG_REG_FLOW_PC_RESOURCE: rdata_q <= pc_words_q[47:32];
        `RUNG_REG_FLOW_PC_FIRST: rdata_q <= pc_words_q[31:16];
        `RUNG_REG_FLOW_PC_COUNT: rdata_q <= pc_words_q[15:0];
        `RUNG_REG_FLOW_PC_STATUS: rdata_q <= {8'd0, pc_status_q};
        default: ;
      endcase
    end
  end
  always @* begin
    if (begun_q) begin
      assert (pc_waiting == (pc_q == 2'd0));
      if (take && of_pc) assert (pc_q == 2'd1 && {resource, first, count} == pc_words_q);
      if (of_pc && (send || copy_start || lock || held)) assert (pc_q == 2'd1 && of_pc_q);
      if (of_pc && (send || copy_start)) assert (write == pc_write_q);
      if (pc_finishes) begin
        assert (pc_q == 2'd1 || pc_q == 2'd2);
        if (pc_q == 2'd2) assert (pc_came_q);
        else assert (way_i == `FLOW_WAY_REFUSED || (way_i == `FLOW_WAY_LOCAL && copied_q));
      end
      if (rdata_known_q) assert (rdata == rdata_q);
    end
  end

  // ---- clocks of a round, beside those in which it waits -------------------------------------------------------
  localparam [3:0] IDLE = 4'd0;
  localparam [3:0] PC = 4'd1;
  localparam [3:0] EVENT = 4'd2;
  localparam [3:0] LOOK = 4'd3;
  localparam [3:0] TAKE = 4'd4;
  localparam [3:0] ROUTE = 4'd5;
  localparam [3:0] ROUTED = 4'd6;
  localparam [3:0] COPY = 4'd7;
  localparam [3:0] SENDS = 4'd8;
  localparam [3:0] AWAIT = 4'd9;
  localparam [3:0] CAME = 4'd10;
  localparam [3:0] FINISH = 4'd11;
  localparam [3:0] TURN = 4'd12;
  localparam [3:0] LEAVE = 4'd13;
  localparam [7:0] MOST = 8'd97;
  reg [7:0] clocks_q;
  wire waits = (peek_state == COPY && !copy_done_i) || (peek_state == SENDS && sending_i) ||
      (peek_state == AWAIT && (!came_i[peek_of_pc ? 4'd8 : {1'b0, peek_head}]));
  always @(posedge clk_i) begin
    if (start_i && !going_q) clocks_q <= 8'd0;
    else if (!waits && going_q) clocks_q <= clocks_q + 8'd1;
  end
  wire [7:0] behind = 8'd11 * {4'd0, peek_left} + 8'd1;  // clocks of those that are to come
  reg [7:0] most_left;
  always @* begin
    case (peek_state)
      PC: most_left = 8'd8;
      TAKE: most_left = peek_of_pc ? 8'd7 : 8'd9;
      ROUTE: most_left = peek_of_pc ? 8'd6 : 8'd8;
      ROUTED: most_left = peek_of_pc ? 8'd5 : 8'd7;
      COPY, SENDS: most_left = peek_of_pc ? 8'd4 : 8'd6;
      AWAIT: most_left = peek_of_pc ? 8'd3 : 8'd5;
      CAME: most_left = peek_of_pc ? 8'd2 : 8'd4;
      FINISH: most_left = peek_of_pc ? 8'd1 : 8'd3;
      LEAVE: most_left = 8'd2;
      TURN: most_left = 8'd1;
      default: most_left = 8'd0;
    endcase
  end
  wire [7:0] rest = peek_state == LOOK ? behind - 8'd1 : behind + most_left;

  // ---- for the induction ------------------------------------------------------------------------------------------
  wire [2:0] head = peek_ring[3*peek_read+:3];
  wire beyond = peek_state >= TAKE;  // of_event_q and of_pc_q say whose it is
  integer s, t;
  reg [2:0] place;
  always @* begin
    place = 3'd0;
    if (begun_q) begin
      if (going_q) assert ({1'b0, clocks_q} + {1'b0, rest} <= {1'b0, MOST});
      assert (going_q == (peek_state != IDLE) && peek_state <= LEAVE);
      if (going_q) assert (peek_left <= 4'd8);
      assert (peek_held == held_q && held_q <= 4'd8);
      assert (peek_write == peek_read + held_q[2:0]);
      assert (held_q == {3'd0, owned_q[0]} + {3'd0, owned_q[1]} + {3'd0, owned_q[2]} +
          {3'd0, owned_q[3]} + {3'd0, owned_q[4]} + {3'd0, owned_q[5]} + {3'd0, owned_q[6]} +
          {3'd0, owned_q[7]});
      for (s = 0; s < 8; s = s + 1) begin
        place = s[2:0] - peek_read;
        if ({1'b0, place} < held_q) begin
          assert (owned_q[peek_ring[3*s+:3]]);
          assert ((peek_ring[3*s+:3] == event_number) == (event_q != NONE &&
              ahead_q == {1'b0, place}));
          for (t = 0; t < s; t = t + 1) begin
            if ({1'b0, t[2:0] - peek_read} < held_q) begin
              assert (peek_ring[3*s+:3] != peek_ring[3*t+:3]);
            end
          end
        end
      end
      assert (owned_q[event_number] == (event_q != NONE));
      if (event_q != NONE) assert (ahead_q < held_q);
      if (event_q != NONE) begin
        assert (peek_events[47*event_number+:47] ==
                {asked_write_q, asked_board_q, asked_first_q, asked_count_q, asked_from_q,
                 asked_tag_q});
      end
      assert (peek_waits[event_number] == (event_q == SENT));
      assert (peek_replies[event_number] == (event_q == REPLY));
      if (event_q == REPLY) assert (peek_finals[8*event_number+:8] == final_q);
      if (event_q == SENT) assert (asked_out_q != came_q);
      else assert (!asked_out_q);
      // The head is that of the ring; those that have been looked at are behind those that are to come.
      if (going_q && peek_state != PC && !peek_of_pc) begin
        if (peek_state >= LOOK) assert (peek_head == head && held_q != 4'd0);
        if (peek_state == EVENT || peek_state == LOOK) assert (peek_left <= held_q);
        else assert (peek_left < held_q);
      end
      if (going_q && (peek_state == PC || peek_of_pc)) assert (peek_left <= held_q);
      if (peek_state == LOOK) assert (peek_left != 4'd0 && !peek_of_pc);
      if (peek_state == PC) assert (peek_of_pc && !looked_q);
      if (going_q && peek_of_pc) assert (!looked_q);
      if (peek_state >= TURN) assert (!peek_of_pc);
      if (event_q != NONE && looked_q && going_q) begin
        if (peek_state == EVENT || peek_state == LOOK) assert (ahead_q >= peek_left);
        else assert (ahead_q == 4'd0 || ahead_q > peek_left);
      end
      if (peek_state == TAKE && !peek_of_pc && peek_head == event_number) assert (!looked_q);
      // Whose turn it is.
      if (peek_state >= ROUTE && peek_state <= SENDS) begin
        assert (of_pc_q == peek_of_pc);
        assert (of_event_q == (!peek_of_pc && peek_head == event_number));
      end
      if (peek_state >= TAKE && peek_state <= SENDS) begin
        if (peek_of_pc) assert (pc_q == 2'd1);
        else if (peek_head == event_number) assert (event_q == NEW);
      end
      if (peek_state == AWAIT || peek_state == CAME) begin
        if (peek_of_pc) assert (pc_q == 2'd2);
        else if (peek_head == event_number) assert (event_q == SENT);
        if (peek_state == CAME && peek_of_pc) assert (pc_came_q);
        if (peek_state == CAME && !peek_of_pc && peek_head == event_number) assert (came_q);
      end
      if (peek_state == FINISH) begin
        if (peek_of_pc && pc_q == 2'd2) assert (pc_came_q && peek_status == pc_came_status_q);
        if (peek_of_pc && pc_q != 2'd2) assert (pc_q == 2'd1);
        if (!peek_of_pc && peek_head == event_number) begin
          assert (event_q == SENT || event_q == NEW);
          if (event_q == SENT) assert (came_q && peek_status == came_status_q);
        end
        if (peek_of_pc ? pc_q == 2'd1 : (peek_head == event_number && event_q == NEW)) begin
          assert (since_q == 2'd3);
          assert (way_q == `FLOW_WAY_REFUSED || (way_q == `FLOW_WAY_LOCAL && copied_q));
          assert (peek_status == (way_q == `FLOW_WAY_REFUSED ? `RUNG_FLOW_STATUS_REFUSED : 8'd0));
        end
      end
      if (peek_state == LEAVE && peek_head == event_number) assert (event_q == REPLY);
      if (peek_state == ROUTE) assert (since_q == 2'd1);
      if (peek_state == ROUTED) assert (since_q == 2'd2);
      if (peek_state == COPY || peek_state == SENDS) assert (since_q == 2'd3);
      if (peek_state == COPY) assert (way_q == `FLOW_WAY_LOCAL && peek_status == 8'd0);
      if (peek_state == SENDS) assert (way_q == `FLOW_WAY_LINK || way_q == `FLOW_WAY_PANEL);
      assert (copying_q == (peek_state == COPY && peek_begun));
      if (peek_begun) assert (peek_state == COPY || stopped_q);
      assert (peek_pc_state == pc_q && peek_pc_status == pc_status_q && pc_q != 2'd3);
      if (pc_q != 2'd0) assert (peek_pc_write == pc_write_q);
      assert (peek_pc == pc_words_q);
      if (pc_q == 2'd2) assert (pc_out_q != pc_came_q);
      else assert (!pc_out_q);
    end
    if (begun_q && !warm_q) assume (peek_pc == pc_words_q);  // whatever the first reset leaves
  end

  always @* begin
    cover (begun_q && leaves_mine && final_q == 8'd1 && held_q == 4'd2);
    cover (begun_q && rst_ni && pc_status_q == 8'd2 && pc_q == 2'd0 && !going_q);
    cover (begun_q && done && clocks_q == 8'd17 && event_q == SENT && !in_place);
  end

endmodule

`default_nettype wire

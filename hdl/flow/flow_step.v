// SPDX-License-Identifier: Apache-2.0
// The turns of tasks in a round (FETCH, LOAD, STORE, PAUSE: README.md): from start_i to done_o, both pulses,
// one turn of every task that flow_ready.v gives. Operations on the task table, rows, transfers and copies are
// those of flow_tasks.v, flow_tables.v, flow_route.v and flow_copy.v, whose timing this follows; who else uses them
// does so between done_o and start_i. stop_i: the turn under way ends here; busy_o is 1 until its block is free.
`default_nettype none
`include "rung_flow.vh"
`include "flow_ops.vh"

module flow_step (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        start_i,
    input  wire        stop_i,
    output wire        done_o,
    output wire        busy_o,
    // setup
    input  wire        in_place_i,           // wait in the turn
    input  wire        command_held_i,       // a command found its board held
    // next task
    input  wire        found_i,
    input  wire        around_i,
    input  wire [ 6:0] next_i,
    output wire        pick_o,
    output wire        around_o,
    // task table
    output wire        op_valid_o,
    output wire [ 3:0] op_o,
    output wire [ 6:0] op_task_o,
    output wire [ 4:0] op_block_o,
    output wire        op_free_o,
    input  wire        peek_waits_i,
    input  wire        peek_ask_i,
    input  wire        peek_skip_i,
    input  wire        peek_has_i,
    input  wire [ 4:0] peek_block_i,
    input  wire [22:0] row_i,
    output wire        row_write_o,
    output wire [ 6:0] row_task_o,
    output wire [22:0] row_o,
    output wire [10:0] row_view_o,
    // tables
    output wire        step_read_o,
    output wire [10:0] step_o,
    input  wire [15:0] step_entry_i,
    input  wire [15:0] step_end_i,
    input  wire [ 7:0] step_before_i,
    input  wire [ 7:0] step_after_i,
    input  wire        step_break_i,
    output wire        transfer_read_o,
    output wire [ 7:0] transfer_o,
    // route
    output wire        take_o,
    input  wire [ 1:0] way_i,
    input  wire        gives_up_i,
    input  wire        exclusive_i,
    input  wire        held_i,
    input  wire [ 3:0] board_i,
    output wire        lock_o,
    output wire [ 3:0] lock_board_o,
    output wire        send_o,
    output wire        write_o,
    output wire [ 4:0] block_o,
    input  wire        sending_i,
    input  wire [ 7:0] status_i,             // of block_o
    // pool
    input  wire        task_block_valid_i,
    input  wire [ 4:0] task_block_i,
    output wire        task_block_take_o,
    // copies
    output wire        copy_start_o,
    output wire        copy_put_o,
    output wire        copy_to_block_o,
    output wire        copy_mapped_o,
    output wire [ 4:0] copy_block_o,
    output wire        copy_head_o,          // from the head on, else the first variable
    output wire [15:0] copy_put_data_o,
    input  wire        copy_done_i,
    // words written by the routine: next step, starts and stops
    output wire        start_o,
    output wire [15:0] entry_o,
    output wire [15:0] end_o,
    input  wire        done_i,
    input  wire        wrote_next_i,
    input  wire [10:0] wrote_step_i,
    input  wire        wrote_end_i,
    input  wire        commands_i,           // in this clock too
    input  wire [ 7:0] command_i,            // bit 7: start, else stop
    input  wire        command_known_i,      // else it changes nothing
    input  wire        command_last_i,
    output wire        command_take_o,
    // counters
    output wire        full_o,
    output wire        held_o,
    output wire        failed_o
);

  localparam [1:0] PHASE_FETCH = 2'd0;
  localparam [1:0] PHASE_LOAD = 2'd1;
  localparam [1:0] PHASE_STORE = 2'd2;
  localparam [4:0] SCRATCH = `RUNG_FLOW_PC_BLOCK + 1;
  localparam [7:0] REFUSED = `RUNG_FLOW_STATUS_REFUSED;

  localparam [5:0] IDLE = 6'd0;
  localparam [5:0] PICK = 6'd1;  // the turn before ends, the next one begins
  localparam [5:0] ROW = 6'd2;  // the row is there, the step is read
  localparam [5:0] STEP = 6'd3;  // the step is there
  localparam [5:0] DECIDE = 6'd4;
  localparam [5:0] ANSWER = 6'd5;  // the block's status is looked up
  localparam [5:0] STORED = 6'd6;  // the answer to a STORE has come
  localparam [5:0] FETCH = 6'd7;  // DECIDE once more, behind it
  localparam [5:0] READ = 6'd8;  // a transfer is read,
  localparam [5:0] TAKE = 6'd9;  // is there,
  localparam [5:0] ROUTE = 6'd10;  // is taken,
  localparam [5:0] ROUTED = 6'd11;  // and its way known
  localparam [5:0] LOCK = 6'd12;  // of the board behind the routine
  localparam [5:0] GET = 6'd13;  // transfer before the routine: map to scratch block
  localparam [5:0] PUT = 6'd14;  // block to words
  localparam [5:0] STATUS = 6'd15;
  localparam [5:0] SETTLE = 6'd16;  // the last access has a clock to get to the processor
  localparam [5:0] RUN = 6'd17;
  localparam [5:0] RUNNING = 6'd18;
  localparam [5:0] LAST = 6'd19;  // the last words written are there
  localparam [5:0] COMMAND = 6'd20;
  localparam [5:0] GAP1 = 6'd21;  // until next_i knows what has changed
  localparam [5:0] GAP2 = 6'd22;
  localparam [5:0] GAP3 = 6'd23;
  localparam [5:0] GAP4 = 6'd24;
  localparam [5:0] COLLECT = 6'd25;  // transfer behind the routine: words to block
  localparam [5:0] GIVE = 6'd26;  // scratch block to map
  localparam [5:0] SEND = 6'd27;
  localparam [5:0] SENT = 6'd28;
  localparam [5:0] AWAIT = 6'd29;  // in place: peek,
  localparam [5:0] AWAIT_ROW = 6'd30;  // again and again
  localparam [5:0] AWAIT_STEP = 6'd31;
  localparam [5:0] AWAIT_FLAGS = 6'd32;
  localparam [5:0] ABORT = 6'd33;

  localparam [1:0] FOR_AFTER = 2'd0;  // before the step begins, the transfer behind it,
  localparam [1:0] FOR_BEFORE = 2'd1;  // and the one before it: to see whether it can begin
  localparam [1:0] FOR_LOAD = 2'd2;
  localparam [1:0] FOR_STORE = 2'd3;

  reg [5:0] state_q;
  reg [1:0] for_q;
  reg [6:0] task_q;
  reg begun_q;  // copy or request of this state
  reg [10:0] step_q;
  reg row_due_q;
  reg [10:0] next_q;
  reg ends_q;
  reg [1:0] phase_q;  // as the row will have it
  reg status_due_q;
  reg [7:0] status_q;
  reg own_q;  // a block is the turn's,
  reg [4:0] block_q;  // this one
  reg finish_due_q;  // it has to be freed, or the task to be ended
  reg gone_q;  // the task has stopped itself
  reg behind_q;  // its routine has ended
  reg in_place_q;
  reg after_link_q;
  reg after_lock_q;
  reg after_held_q;
  reg [3:0] after_board_q;
  reg break_q;
  reg [7:0] before_q;
  reg [7:0] after_q;
  reg [15:0] entry_q;
  reg [15:0] end_q;
  reg start_q;
  reg flags_due_q;  // breakpoint or block to be taken
  reg answered_q;  // the turn began with the answer to a STORE
  reg short_q;  // somebody had no block or board, since the round's turns began
  reg short_before_q;  // or in the round before

  // ---- FETCH -------------------------------------------------------------------------------------
  wire fetch = (state_q == DECIDE && phase_q == PHASE_FETCH) || state_q == FETCH;
  wire pause = (break_q || peek_ask_i) && !peek_skip_i;
  wire has_before = before_q != 8'd0;
  wire has_after = after_q != 8'd0;
  wire linked = way_i == `FLOW_WAY_LINK || way_i == `FLOW_WAY_PANEL;
  wire check = state_q == ROUTED && for_q == FOR_BEFORE;
  wire check_alone = state_q == ROUTED && for_q == FOR_AFTER && !has_before;
  wire after_link = check_alone ? linked : after_link_q;
  wire after_held = check_alone ? held_i : after_held_q;
  wire needs_block = (check && linked) || after_link;
  wire blocked = (check && held_i) || after_held;
  wire checks = check || check_alone;
  // Who has just given back a block and takes one again would be the only one to have it for ever.
  wire gives_way = answered_q && (short_q || short_before_q);
  wire begins = checks && !blocked && (!needs_block || (task_block_valid_i && !gives_way));
  wire fails = checks && !begins;
  wire waits_in_place = in_place_i || !gives_up_i;

  // ---- what the states start -------------------------------------------------------------------------
  wire local_after = way_i == `FLOW_WAY_LOCAL;
  wire copying = state_q == GET || state_q == PUT || state_q == COLLECT || state_q == GIVE;
  assign copy_start_o = copying && !begun_q;
  assign copy_to_block_o = state_q == GET || state_q == COLLECT;
  assign copy_mapped_o = state_q == GET || state_q == GIVE;
  assign copy_head_o = state_q == PUT || state_q == COLLECT;
  assign copy_block_o = way_i == `FLOW_WAY_LOCAL ? SCRATCH : block_q;
  assign copy_put_o = state_q == STATUS;
  assign copy_put_data_o = {8'd0, status_q};

  assign transfer_read_o = state_q == READ;
  assign transfer_o = for_q == FOR_AFTER || for_q == FOR_STORE ? after_q : before_q;
  assign take_o = state_q == TAKE;
  assign send_o = state_q == SEND && !sending_i;
  assign write_o = for_q == FOR_STORE;
  assign block_o = block_q;
  assign task_block_take_o = begins && needs_block;
  assign lock_o = (begins && needs_block && exclusive_i) ||
      (state_q == LOCK && after_lock_q && own_q);
  assign lock_board_o = state_q == LOCK ? after_board_q : board_i;

  assign step_read_o = state_q == ROW || state_q == AWAIT_ROW;
  assign step_o = row_i[10:0];
  wire pick = state_q == PICK && !finish_due_q;
  assign pick_o = pick && found_i;
  assign around_o = pick && !found_i && !around_i;
  assign done_o = pick && !found_i && around_i;
  assign busy_o = state_q != IDLE;

  assign start_o = start_q;
  assign entry_o = entry_q;
  assign end_o = end_q;
  assign command_take_o = state_q == COMMAND;

  assign row_write_o = (state_q == PICK && row_due_q) || state_q == SENT;
  assign row_task_o = task_q;
  assign row_o = {status_q, status_due_q, ends_q, phase_q, next_q};
  assign row_view_o = phase_q == PHASE_FETCH ? next_q : step_q;

  // ---- operations ----------------------------------------------------------------------------------
  reg op_valid;
  reg [3:0] op;
  reg op_free;
  always @* begin
    op_valid = 1'b0;
    op = `FLOW_OP_PEEK;
    op_free = 1'b0;
    case (state_q)
      PICK: begin
        op_valid = found_i || finish_due_q;
        if (finish_due_q) begin
          op = ends_q && !gone_q ? `FLOW_OP_END : `FLOW_OP_FREE;
          op_free = own_q;
        end
      end
      STORED: begin
        op_valid = 1'b1;
        op = ends_q ? `FLOW_OP_END : `FLOW_OP_TAKE;
        op_free = 1'b1;
      end
      DECIDE, FETCH: begin
        op_valid = fetch && pause;
        op = `FLOW_OP_PAUSE;
      end
      // Nothing else is under way in these.
      RUN: begin
        op_valid = flags_due_q;
        op = `FLOW_OP_TAKE;
      end
      COMMAND: begin
        op_valid = command_known_i;
        op = command_i[7] ? `FLOW_OP_START : `FLOW_OP_STOP;
      end
      SEND: begin
        op_valid = !sending_i;
        op = `FLOW_OP_WAIT;
      end
      AWAIT: op_valid = 1'b1;
      ABORT: begin
        op_valid = own_q;
        op = `FLOW_OP_FREE;
        op_free = 1'b1;
      end
      default: ;
    endcase
  end
  assign op_valid_o = op_valid;
  assign op_o = op;
  assign op_task_o = state_q == COMMAND ? command_i[6:0] :
      state_q == PICK && !finish_due_q ? next_i : task_q;
  assign op_block_o = block_q;
  assign op_free_o = op_free;

  // ---- the course of a turn --------------------------------------------------------------------------
  wire refused = way_i == `FLOW_WAY_REFUSED;
  wire load_done = state_q == ROUTED && for_q == FOR_LOAD;
  wire store_refused = state_q == ROUTED && for_q == FOR_STORE && refused;

  always @(posedge clk_i) begin
    start_q <= 1'b0;
    begun_q <= copying && !copy_done_i;
    case (state_q)
      IDLE: if (start_i && !stop_i) state_q <= PICK;
      PICK: begin
        row_due_q <= 1'b0;
        finish_due_q <= 1'b0;
        if (!finish_due_q) begin
          state_q <= found_i ? ROW : around_i ? IDLE : GAP1;
          task_q  <= next_i;
          {in_place_q, gone_q, behind_q, ends_q, own_q} <= 5'd0;
          phase_q <= PHASE_FETCH;
          after_link_q <= 1'b0;
          after_held_q <= 1'b0;
          after_lock_q <= 1'b0;
          answered_q <= 1'b0;
        end
      end
      ROW: state_q <= STEP;
      STEP: begin
        {status_q, status_due_q, ends_q, phase_q, step_q} <= row_i;
        next_q <= row_i[10:0];
        {entry_q, end_q} <= {step_entry_i, step_end_i};
        {before_q, after_q, break_q} <= {step_before_i, step_after_i, step_break_i};
        state_q <= DECIDE;
      end
      DECIDE: begin
        flags_due_q <= peek_skip_i || peek_has_i;
        phase_q <= PHASE_FETCH;
        for_q <= FOR_LOAD;
        block_q <= peek_block_i;
        own_q <= phase_q == PHASE_LOAD;
        if (phase_q == PHASE_STORE) state_q <= ANSWER;
        else state_q <= READ;  // for a LOAD; FETCH below
      end
      ANSWER: state_q <= STORED;
      STORED: begin
        // The block's status is there; a step in place has had its turn.
        {status_q, status_due_q} <= {status_i, 1'b1};
        flags_due_q <= peek_skip_i;
        state_q <= ends_q || in_place_q ? PICK : FETCH;
        row_due_q <= 1'b1;
        answered_q <= 1'b1;
      end
      FETCH: ;  // below
      READ: state_q <= TAKE;
      TAKE: state_q <= ROUTE;
      ROUTE: state_q <= ROUTED;
      ROUTED: begin
        case (for_q)
          FOR_AFTER: begin
            {after_link_q, after_held_q} <= {linked, held_i};
            {after_lock_q, after_board_q} <= {exclusive_i, board_i};
            if (has_before) begin
              state_q <= READ;
              for_q   <= FOR_BEFORE;
            end else begin
              // lock_o has done this one.
              after_lock_q <= 1'b0;
              state_q <= status_due_q ? STATUS : RUN;
              start_q <= begins && !status_due_q;
            end
          end
          FOR_BEFORE: state_q <= LOCK;
          FOR_LOAD: begin
            state_q  <= status_i == 8'd0 ? PUT : STATUS;
            status_q <= status_i;
          end
          default: begin
            state_q <= refused ? PICK : COLLECT;
            {status_q, status_due_q} <= {REFUSED, refused};
            {row_due_q, finish_due_q} <= {refused, refused && (own_q || ends_q)};
          end
        endcase
        if (fails) {state_q, row_due_q} <= {PICK, 1'b1};
        if (begins) {own_q, block_q} <= {needs_block, task_block_i};
      end
      LOCK: begin
        // Route still has the transfer before the routine.
        case (way_i)
          `FLOW_WAY_REFUSED: state_q <= STATUS;
          `FLOW_WAY_LOCAL: state_q <= GET;
          default: state_q <= SEND;
        endcase
        status_q <= refused ? REFUSED : 8'd0;
      end
      GET: if (copy_done_i) state_q <= PUT;
      PUT: if (copy_done_i) state_q <= STATUS;
      STATUS: state_q <= SETTLE;
      SETTLE: begin
        state_q <= RUN;
        start_q <= 1'b1;
      end
      RUN: begin
        state_q <= RUNNING;
        status_due_q <= 1'b0;
      end
      RUNNING: if (done_i) state_q <= LAST;
      LAST: begin
        behind_q  <= 1'b1;
        row_due_q <= 1'b1;
        finish_due_q <= own_q || ends_q || (wrote_next_i && wrote_end_i);
        if (has_after) {state_q, for_q, finish_due_q} <= {READ, FOR_STORE, 1'b0};
        else state_q <= PICK;
        if (commands_i) state_q <= COMMAND;
      end
      COMMAND: begin
        if (command_known_i && command_i == {1'b0, task_q}) begin
          {row_due_q, ends_q, gone_q} <= 3'b001;
          finish_due_q <= own_q;
        end
        if (command_last_i) state_q <= GAP1;
      end
      GAP1: state_q <= GAP2;
      GAP2: state_q <= GAP3;
      GAP3: state_q <= GAP4;
      GAP4: state_q <= behind_q && has_after && !gone_q ? READ : PICK;
      COLLECT: if (copy_done_i) state_q <= local_after ? GIVE : SEND;
      GIVE: begin
        status_q <= 8'd0;
        if (copy_done_i) begin
          {state_q, status_due_q, row_due_q} <= {PICK, 2'b11};
          finish_due_q <= own_q || ends_q;
        end
      end
      SEND: begin
        phase_q <= for_q == FOR_STORE ? PHASE_STORE : PHASE_LOAD;
        if (!sending_i) {state_q, own_q} <= {SENT, 1'b0};
      end
      SENT: begin
        {row_due_q, finish_due_q} <= 2'b00;
        in_place_q <= waits_in_place;
        state_q <= waits_in_place ? AWAIT : PICK;
      end
      AWAIT: state_q <= AWAIT_ROW;
      AWAIT_ROW: state_q <= AWAIT_STEP;
      // Flags are there in the clock after it.
      AWAIT_STEP: state_q <= AWAIT_FLAGS;
      AWAIT_FLAGS: state_q <= peek_waits_i ? AWAIT : STEP;
      default: begin  // ABORT
        state_q <= IDLE;
        // Nothing of this turn is left for the next round.
        {row_due_q, finish_due_q, own_q} <= 3'd0;
      end
    endcase

    if (fetch) begin
      for_q <= has_after ? FOR_AFTER : FOR_BEFORE;
      if (pause) {state_q, row_due_q} <= {PICK, 1'b1};
      else if (has_before || has_after) state_q <= READ;
      else if (status_due_q) state_q <= STATUS;
      else {state_q, start_q} <= {RUN, 1'b1};
    end
    if (wrote_next_i && (state_q == RUNNING || state_q == LAST)) begin
      next_q <= wrote_step_i;
      ends_q <= wrote_end_i;
    end

    if (state_q == IDLE && start_i) begin
      {short_before_q, short_q} <= {short_q, 1'b0};
    end else if (command_held_i || (fails && (blocked || !task_block_valid_i))) begin
      short_q <= 1'b1;
    end

    if (stop_i && state_q != IDLE) begin
      state_q <= ABORT;
      start_q <= 1'b0;
    end
    if (!rst_ni) begin
      state_q <= IDLE;
      start_q <= 1'b0;
      {row_due_q, finish_due_q, own_q} <= 3'd0;
      {short_q, short_before_q} <= 2'd0;
    end
  end

  // ---- counters ------------------------------------------------------------------------------------
  assign full_o = fails && !blocked;
  assign held_o = fails && blocked;
  assign failed_o = (load_done && status_i != 8'd0) || (state_q == STORED && status_i != 8'd0) ||
      store_refused || (state_q == LOCK && refused);

endmodule

`default_nettype wire

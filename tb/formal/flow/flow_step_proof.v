// SPDX-License-Identifier: Apache-2.0
// Turns of tasks (hdl/flow/flow_step.v), any row, step, transfers, routine and answers. A turn is of the task that was picked, and no
// other's row or flags are touched, but by the starts and stops that its routine has written. Its routine runs once, with the entry
// and the end of the step in the task's row, behind all that stands before it: never at a breakpoint, nor before its words are there,
// which are copied only if their status is `done`; what stands behind it is sent or written afterwards, unless the routine has
// stopped its task. A turn that cannot have its block or board has done nothing. A block is taken only if one is offered, and
// belongs to the turn until it is freed or goes out with a request, once; boards are locked with it. One request at most is under
// way. A turn has a bounded number of clocks beside those in which it waits. What flow_tasks_proof, flow_ready_proof and
// flow_locks_proof assume of it is asserted here.
`default_nettype none
`include "rung_flow.vh"
`include "flow_ops.vh"

module flow_step_proof (
    input wire        clk_i,
    input wire        rst_ni,
    input wire        start_i,
    input wire        stop_i,
    input wire        command_held_i,
    input wire        found_i,
    input wire        around_i,
    input wire [ 6:0] next_i,
    input wire        peek_waits_i,
    input wire        peek_ask_i,
    input wire        peek_skip_i,
    input wire        peek_has_i,
    input wire [ 4:0] peek_block_i,
    input wire [22:0] row_i,
    input wire [15:0] step_entry_i,
    input wire [15:0] step_end_i,
    input wire [ 7:0] step_before_i,
    input wire [ 7:0] step_after_i,
    input wire        step_break_i,
    input wire [ 1:0] way_i,
    input wire        gives_up_i,
    input wire        exclusive_i,
    input wire        held_i,
    input wire [ 3:0] board_i,
    input wire        sending_i,
    input wire [ 7:0] status_i,
    input wire        task_block_valid_i,
    input wire [ 4:0] task_block_i,
    input wire        copy_done_i,
    input wire        done_i,
    input wire        wrote_next_i,
    input wire [10:0] wrote_step_i,
    input wire        wrote_end_i,
    input wire        commands_i,
    input wire [ 7:0] command_i,
    input wire        command_known_i,
    input wire        command_last_i,
    // inside of it
    input wire [ 5:0] peek_state,
    input wire [ 1:0] peek_for,
    input wire [ 6:0] peek_task,
    input wire        peek_begun,
    input wire [10:0] peek_step,
    input wire        peek_row_due,
    input wire [10:0] peek_next,
    input wire        peek_ends,
    input wire [ 1:0] peek_phase,
    input wire        peek_status_due,
    input wire [ 7:0] peek_status,
    input wire        peek_own,
    input wire [ 4:0] peek_its_block,
    input wire        peek_finish_due,
    input wire        peek_gone,
    input wire        peek_behind,
    input wire        peek_in_place,
    input wire        peek_after_link,
    input wire        peek_after_lock,
    input wire        peek_after_held,
    input wire [ 3:0] peek_after_board,
    input wire        peek_break,
    input wire [ 7:0] peek_before,
    input wire [ 7:0] peek_after,
    input wire [15:0] peek_entry,
    input wire [15:0] peek_end,
    input wire        peek_start,
    input wire        peek_flags_due,
    input wire        peek_answered,
    input wire        peek_short,
    input wire        peek_short_before
);

  localparam [1:0] FETCHES = 2'd0;
  localparam [1:0] LOADS = 2'd1;
  localparam [1:0] STORES = 2'd2;
  localparam [4:0] SCRATCH = `RUNG_FLOW_PC_BLOCK + 1;
  (* anyconst *) wire in_place;

  wire done, busy, pick, go_around, op_valid, op_free, row_write, step_read, transfer_read;
  wire take, lock, send, write, block_take, copy_start, copy_put, copy_to_block, copy_mapped;
  wire copy_head, start, command_take, full, held, failed;
  wire [3:0] op, lock_board;
  wire [6:0] op_task, row_task;
  wire [4:0] op_block, block, copy_block;
  wire [22:0] row;
  wire [10:0] row_view, step;
  wire [7:0] transfer;
  wire [15:0] copy_put_data, entry, step_end;
  flow_step turns (
      .clk_i             (clk_i),
      .rst_ni            (rst_ni),
      .start_i           (start_i),
      .stop_i            (stop_i),
      .done_o            (done),
      .busy_o            (busy),
      .in_place_i        (in_place),
      .command_held_i    (command_held_i),
      .found_i           (found_i),
      .around_i          (around_i),
      .next_i            (next_i),
      .pick_o            (pick),
      .around_o          (go_around),
      .op_valid_o        (op_valid),
      .op_o              (op),
      .op_task_o         (op_task),
      .op_block_o        (op_block),
      .op_free_o         (op_free),
      .peek_waits_i      (peek_waits_i),
      .peek_ask_i        (peek_ask_i),
      .peek_skip_i       (peek_skip_i),
      .peek_has_i        (peek_has_i),
      .peek_block_i      (peek_block_i),
      .row_i             (row_i),
      .row_write_o       (row_write),
      .row_task_o        (row_task),
      .row_o             (row),
      .row_view_o        (row_view),
      .step_read_o       (step_read),
      .step_o            (step),
      .step_entry_i      (step_entry_i),
      .step_end_i        (step_end_i),
      .step_before_i     (step_before_i),
      .step_after_i      (step_after_i),
      .step_break_i      (step_break_i),
      .transfer_read_o   (transfer_read),
      .transfer_o        (transfer),
      .take_o            (take),
      .way_i             (way_i),
      .gives_up_i        (gives_up_i),
      .exclusive_i       (exclusive_i),
      .held_i            (held_i),
      .board_i           (board_i),
      .lock_o            (lock),
      .lock_board_o      (lock_board),
      .send_o            (send),
      .write_o           (write),
      .block_o           (block),
      .sending_i         (sending_i),
      .status_i          (status_i),
      .task_block_valid_i(task_block_valid_i),
      .task_block_i      (task_block_i),
      .task_block_take_o (block_take),
      .copy_start_o      (copy_start),
      .copy_put_o        (copy_put),
      .copy_to_block_o   (copy_to_block),
      .copy_mapped_o     (copy_mapped),
      .copy_block_o      (copy_block),
      .copy_head_o       (copy_head),
      .copy_put_data_o   (copy_put_data),
      .copy_done_i       (copy_done_i),
      .start_o           (start),
      .entry_o           (entry),
      .end_o             (step_end),
      .done_i            (done_i),
      .wrote_next_i      (wrote_next_i),
      .wrote_step_i      (wrote_step_i),
      .wrote_end_i       (wrote_end_i),
      .commands_i        (commands_i),
      .command_i         (command_i),
      .command_known_i   (command_known_i),
      .command_last_i    (command_last_i),
      .command_take_o    (command_take),
      .full_o            (full),
      .held_o            (held),
      .failed_o          (failed)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  // ---- the round and its turns, as the ready vector sees them ---------------------------------------------------------
  reg [3:0] quiet_q;
  reg going_q;  // a round's turns, or what is left of one that was stopped
  reg stopped_q;
  reg turn_q;
  reg [6:0] task_q;
  wire look = pick || go_around || done;
  wire peeks = op_valid && op == `FLOW_OP_PEEK;
  reg [3:0] peeked_q;  // a PEEK, so many clocks ago
  reg [1:0] taken_q;  // the route took a transfer
  reg step_read_q;
  initial quiet_q = 4'd0;
  initial {going_q, stopped_q, turn_q, peeked_q, taken_q, step_read_q} = 10'd0;
  always @(posedge clk_i) begin
    if (!rst_ni || stop_i || done) going_q <= 1'b0;
    else if (start_i) going_q <= 1'b1;
    stopped_q <= rst_ni && stop_i && (going_q || stopped_q);
    if (!rst_ni || stop_i) turn_q <= 1'b0;
    else if (look) turn_q <= pick;
    if (pick) task_q <= next_i;
    peeked_q <= {peeked_q[2:0], peeks};
    quiet_q <= {quiet_q[2:0], rst_ni && !stop_i && !done};
    taken_q <= {taken_q[0], take};
    step_read_q <= step_read;
  end

  // ---- who is around it: tables and flags stay until they are read anew ------------------------------------------------
  reg [22:0] row_before_q;
  reg [48:0] step_before_q;
  reg [8:0] flags_before_q;
  reg [4:0] way_before_q;
  reg [3:0] board_before_q;
  reg [4:0] block_before_q;
  reg [7:0] status_before_q;
  wire [48:0] step_row = {step_entry_i, step_end_i, step_before_i, step_after_i, step_break_i};
  wire [8:0] flags = {peek_waits_i, peek_ask_i, peek_skip_i, peek_has_i, peek_block_i};
  wire [1:0] row_phase = row_i[12:11];
  reg waiting_q;  // for data, in place
  reg [22:0] sent_row_q;
  reg copying_q;
  always @(posedge clk_i) begin
    {row_before_q, step_before_q, flags_before_q} <= {row_i, step_row, flags};
    way_before_q <= {way_i, gives_up_i, exclusive_i, 1'b0};
    {board_before_q, block_before_q, status_before_q} <= {board_i, block, status_i};
    if (!rst_ni || stop_i || copy_done_i) copying_q <= 1'b0;
    else if (copy_start) copying_q <= 1'b1;
  end
  initial copying_q = 1'b0;
  always @* begin
    // A round's turns begin five clocks behind a reset, stop or end at the earliest (flow_round), at most in that of a stop.
    assume (!start_i || (!going_q && quiet_q == 4'hf));
    if (!peeked_q[0]) assume (row_i == row_before_q);
    if (!step_read_q) assume (step_row == step_before_q);
    if (!peeked_q[2]) assume (flags == flags_before_q);
    if (!taken_q[1]) assume ({way_i, gives_up_i, exclusive_i, 1'b0} == way_before_q);
    if (!taken_q[0]) assume (board_i == board_before_q);
    // A block's status comes before its task is ready again, and stays.
    if (block == block_before_q && !waiting_q && !peeked_q[2]) assume (status_i == status_before_q);
    // A row as it was written (asserted below) or as a start makes it; in place it is the one that was written before.
    if (peeked_q[0]) begin
      assume (row_phase != 2'd3 && (!row_i[13] || row_phase == STORES));
      if (waiting_q) assume (row_i == sent_row_q);
    end
    // A task that is picked does not wait, and has a block's data exactly if its row says so (asserted below).
    if (peeked_q[2]) begin
      assume (peek_has_i == (row_phase != FETCHES) && peek_block_i < 5'd16);
      if (!waiting_q) assume (!peek_waits_i);
      if (waiting_q) assume (peek_block_i == own_block_q);
    end
    assume (!task_block_valid_i || task_block_i < 5'd16);
    assume (!copy_done_i || copying_q);
    // A task has one turn in a round (flow_ready).
    if (turn_q && found_i) assume (next_i != task_q);
    assume (next_i < `RUNG_FLOW_TASKS);
    // Tables stay while a program runs: a step that loads has a transfer before it that is sent, and the way of the one behind it
    // is the same when it is looked at again.
    if (step_read_q && row_phase == LOADS) assume (has_before);
    if (taken_q[1] && turn_q && phase_q == LOADS && !ran_q) assume (linked);
    if (taken_q[1] && after_known_q && transfer_q == step_after_i) begin
      assume (way_i == after_way_q && exclusive_i == after_alone_q && board_i == after_board_q);
    end
  end

`ifdef RUNG_NARROW
  always @* begin
    assume (rst_ni == begun_q && next_i <= 7'd2 && row_i[22:16] == 7'd0 && row_i[10:2] == 9'd1);
    assume (step_entry_i == {5'd0, row_i[10:0]} && step_end_i == 16'h1234);
    assume (step_before_i <= 8'd1 && (step_after_i == 8'd0 || step_after_i == 8'd2));
    assume (status_i <= 8'd1 && wrote_step_i[10:2] == 9'd1 && command_i[6:0] <= 7'd2);
    assume (task_block_i == 5'd3 && peek_block_i[4:1] == 4'd1 && board_i <= 4'd1);
    assume (copy_done_i == copying_q && !sending_i && command_last_i && done_i);
  end
`endif

  // ---- the turn -----------------------------------------------------------------------------------------------------
  reg ran_q;  // its routine was started,
  reg over_q;  // has ended
  reg paused_q, failed_q, refused_q, gone_q, stored_q, sent_q, gave_q, got_q, collected_q, put_q;
  reg loaded_q;  // words of the block were copied to their devices
  reg own_q, fresh_q;  // a block belongs to the turn, taken in it
  reg [4:0] own_block_q;
  reg [7:0] transfer_q;  // that the route has
  reg has_q, started_q;  // the task's flags, its row's phase
  reg [1:0] phase_q;
  reg [10:0] next_q;  // the next step
  reg ends_q;
  reg resumed_q;  // in place
  reg wrote_q;
  reg lacks_q, lacked_q;
  reg after_known_q;
  reg [1:0] after_way_q;
  reg after_alone_q, after_held_q, locked_after_q;
  reg [3:0] after_board_q;
  // Its words are written from the clock behind the start to the one behind the end.
  reg running_q, last_q;
  reg [7:0] answer_q;  // of its last transfer
  wire resumes = waiting_q && peeked_q[2] && !peek_waits_i;
  wire has_before = step_before_i != 8'd0;
  wire has_after = step_after_i != 8'd0;
  wire linked = way_i == `FLOW_WAY_LINK || way_i == `FLOW_WAY_PANEL;
  wire pauses = (step_break_i || peek_ask_i) && !peek_skip_i;
  wire frees_stored = op_valid && op_free && (op == `FLOW_OP_TAKE || op == `FLOW_OP_END) && !ran_q;
  wire of_command = op_valid && command_take;
  wire stops_itself = of_command && op == `FLOW_OP_STOP && op_task == task_q;
  always @(posedge clk_i) begin
    if (pick) begin
      {ran_q, over_q, paused_q, failed_q, refused_q, gone_q, stored_q, sent_q} <= 8'd0;
      {gave_q, got_q, collected_q, put_q, loaded_q, fresh_q, resumed_q, wrote_q} <= 8'd0;
      {has_q, started_q} <= 2'b01;
    end else begin
      if (start) ran_q <= 1'b1;
      if (running_q && done_i) over_q <= 1'b1;
      if (op_valid && op == `FLOW_OP_PAUSE) paused_q <= 1'b1;
      if (full || held) failed_q <= 1'b1;
      if (failed && over_q) refused_q <= 1'b1;
      if (stops_itself) gone_q <= 1'b1;
      if (frees_stored) stored_q <= 1'b1;
      else if (send) stored_q <= 1'b0;
      if (send) sent_q <= 1'b1;
      if (send && write) wrote_q <= 1'b1;
      if (copy_done_i && copy_to_block && copy_mapped) got_q <= 1'b1;
      if (copy_done_i && copy_to_block && !copy_mapped) collected_q <= 1'b1;
      if (copy_done_i && !copy_to_block && copy_mapped) gave_q <= 1'b1;
      if (copy_done_i && !copy_to_block && !copy_mapped) loaded_q <= 1'b1;
      if (copy_put) put_q <= 1'b1;
      if (block_take) fresh_q <= 1'b1;
      else if (op_valid && (op_free || op == `FLOW_OP_WAIT)) fresh_q <= 1'b0;
      if (resumes) resumed_q <= 1'b1;
      if (peeked_q[2]) has_q <= peek_has_i;
      else if (op_valid && op_task == task_q) begin
        if (op == `FLOW_OP_TAKE || op == `FLOW_OP_END || op == `FLOW_OP_STOP) has_q <= 1'b0;
        if (op == `FLOW_OP_WAIT) has_q <= 1'b1;
      end
      if (op_valid && op_task == task_q) begin
        if (op == `FLOW_OP_STOP || op == `FLOW_OP_END) started_q <= 1'b0;
        if (op == `FLOW_OP_START) started_q <= 1'b1;
      end
    end
    if (!rst_ni || stop_i || resumes) waiting_q <= 1'b0;
    else if (send) waiting_q <= in_place || !gives_up_i;
    if (!rst_ni || pick || stopped_q) own_q <= 1'b0;
    else if (block_take) {own_q, own_block_q} <= {1'b1, task_block_i};
    else if (turn_q && peeked_q[2] && peek_has_i && (resumes || !waiting_q)) begin
      {own_q, own_block_q} <= {1'b1, peek_block_i};
    end else if (op_valid && (op_free || op == `FLOW_OP_WAIT)) own_q <= 1'b0;
    if (transfer_read) transfer_q <= transfer;
    if (peeked_q[1]) {phase_q, next_q, ends_q} <= {row_phase, row_i[10:0], row_i[13]};
    else begin
      if (row_write) phase_q <= row[12:11];
      if (stops_itself) ends_q <= 1'b0;
      if ((running_q || last_q) && wrote_next_i) {next_q, ends_q} <= {wrote_step_i, wrote_end_i};
    end
    if (row_write) sent_row_q <= row;
    if (!rst_ni) {lacks_q, lacked_q} <= 2'b00;
    else if (start_i) {lacked_q, lacks_q} <= {lacks_q, 1'b0};
    else if (command_held_i || held || (full && !task_block_valid_i)) lacks_q <= 1'b1;
    if (pick) after_known_q <= 1'b0;
    else if (taken_q[1] && turn_q && transfer_q == step_after_i && !after_known_q) begin
      {after_known_q, after_way_q} <= {1'b1, way_i};
      {after_alone_q, after_held_q, after_board_q} <= {exclusive_i, held_i, board_i};
    end
    if (pick) locked_after_q <= 1'b0;
    else if (lock && (!has_before || !block_take)) locked_after_q <= 1'b1;
    if (!rst_ni || stop_i) {running_q, last_q} <= 2'b00;
    else {running_q, last_q} <= {start || (running_q && !done_i), running_q && done_i};
    if (frees_stored) answer_q <= status_i;
  end

  // ---- what a turn does ------------------------------------------------------------------------------------------------
  wire of_turn = turn_q && !stopped_q;
  wire to_words = copy_start && !copy_to_block && !copy_mapped;
  wire from_map = copy_start && copy_to_block && copy_mapped;
  wire from_words = copy_start && copy_to_block && !copy_mapped;
  wire to_map = copy_start && !copy_to_block && copy_mapped;
  wire local_way = way_i == `FLOW_WAY_LOCAL;
  wire refused = way_i == `FLOW_WAY_REFUSED;
  wire of_before = transfer_q == step_before_i && has_before;
  wire of_after = transfer_q == step_after_i && has_after;
  wire loads = phase_q == LOADS;  // its data have come
  wire [1:0] phase_now = row_write ? row[12:11] : phase_q;
  always @* begin
    if (begun_q) begin
      assert (busy == (going_q || stopped_q));
      // Only in a turn, and of its task.
      if (look) assert (going_q && !stopped_q && !(pick && (go_around || done)));
      if (pick) assert (found_i && peeks && op_task == next_i);
      if (go_around) assert (!found_i && !around_i);
      if (done) assert (!found_i && around_i);
      if (row_write) assert (of_turn && row_task == task_q && (started_q || stored_q || wrote_q));
      if (op_valid && !pick && !stopped_q) begin
        assert (of_turn && (command_take || op_task == task_q));
        if (!command_take) assert (op != `FLOW_OP_START && op != `FLOW_OP_STOP);
      end
      if (command_take) begin
        assert (of_turn && over_q && op_valid == command_known_i && op_task == command_i[6:0]);
        assert (op == (command_i[7] ? `FLOW_OP_START : `FLOW_OP_STOP) && !op_free);
      end
      if (step_read) assert (peeked_q[0] && step == row_i[10:0]);
      if (take) assert (of_turn);
      if (copy_start || copy_put) assert (of_turn && !copying_q && !(copy_start && copy_put));
      if (copying_q) assert (of_turn);

      // The routine: once, of the step, behind all that stands before it.
      if (start) begin
        assert (of_turn && !ran_q && !paused_q && !failed_q && !copying_q && !waiting_q && !sent_q
                || (resumed_q && !ran_q && of_turn && !copying_q && !waiting_q));
        assert (entry == step_entry_i && step_end == step_end_i);
        assert (phase_q == FETCHES || loads || stored_q);
        if (!loads) assert (!pauses);
        if (has_before) begin
          assert (put_q && (loads || local_way || refused));
          assert (loads || got_q == local_way);
          assert (loaded_q == (loads ? status_i == 8'd0 : local_way));
        end else begin
          assert (!loads && !got_q && !loaded_q && put_q == (row_i[14] || stored_q));
        end
      end
      if (copy_put) begin
        assert (!ran_q && !put_q);
        if (!has_before) begin
          assert (copy_put_data == {8'd0, stored_q ? answer_q : row_i[22:15]});
        end else if (loads) assert (copy_put_data == {8'd0, status_i});
        else begin
          assert (copy_put_data == {8'd0, local_way ? 8'd0 : `RUNG_FLOW_STATUS_REFUSED});
        end
      end

      // Words: into their devices before it, from their devices behind it.
      if (from_map) assert (!ran_q && of_before && local_way && copy_block == SCRATCH && !loads);
      if (to_words) begin
        assert (!ran_q && of_before && copy_head);
        if (loads) assert (own_q && copy_block == own_block_q && status_i == 8'd0);
        else assert (got_q && local_way && copy_block == SCRATCH);
      end
      if (from_words) begin
        assert (over_q && !gone_q && of_after && copy_head && !refused && !collected_q);
        assert (copy_block == (local_way ? SCRATCH : own_block_q) && (local_way || own_q));
      end
      if (to_map) begin
        assert (collected_q && local_way && !gone_q && of_after && copy_block == SCRATCH);
      end

      // Requests: one at most, of the block that was taken, which is the task table's from then on.
      assert (send == (op_valid && op == `FLOW_OP_WAIT));
      if (send) begin
        assert (of_turn && !sending_i && !waiting_q && linked && own_q && block == own_block_q);
        assert (op_block == own_block_q && !copying_q && !gone_q && (!sent_q || resumed_q));
        if (write) assert (over_q && collected_q && of_after);
        else assert (!ran_q && !failed_q && of_before && phase_q != LOADS);
      end

      // Blocks and boards.
      if (block_take) assert (of_turn && task_block_valid_i && !own_q && !held_i && !ran_q);
      if (op_free && op_valid && !stopped_q) assert (own_q && op_block == own_block_q);
      if (look) assert (!own_q);
      if (stopped_q && own_q && fresh_q) begin
        assert (op_valid && op == `FLOW_OP_FREE && op_free && op_block == own_block_q);
      end
      if (stopped_q) begin
        assert (!start && !send && !take && !lock && !copy_start && !copy_put && !row_write);
        assert (!op_valid || (op == `FLOW_OP_FREE && op_free && op_block == own_block_q));
      end

      // A board that cannot be shared is locked by who takes a block for a step that has it, if nobody holds it.
      if (lock) begin
        assert (of_turn && !ran_q && (block_take || (own_q && fresh_q && block == own_block_q)));
        if (block_take) assert (exclusive_i && !held_i && lock_board == board_i);
        else begin
          assert (after_known_q && after_alone_q && !after_held_q);
          assert (lock_board == after_board_q);
        end
      end
      if (block_take && exclusive_i) assert (lock && lock_board == board_i);
      if ((start || send || copy_start || copy_put) && fresh_q && !ran_q && has_after) begin
        assert (after_known_q && (!after_alone_q || locked_after_q));
      end

      // Who has given a block back in this turn takes none while somebody has lacked one, or a board, since the last round's turns.
      if (block_take) assert (!(stored_q && (lacks_q || lacked_q)));
      // And nobody fails without a reason.
      if (full) assert (!task_block_valid_i || (stored_q && (lacks_q || lacked_q)));

      // What cannot begin has done nothing.
      if (full || held) begin
        assert (of_turn && !ran_q && !sent_q && !own_q && !copying_q && !got_q && !put_q);
        assert (!block_take && !lock && !(full && held));
      end
      if (failed_q || paused_q) begin
        assert (!start && !copy_start && !copy_put && !send && !lock && !block_take);
      end

      // A turn's end.
      if (look && turn_q) begin
        assert (!copying_q && !running_q && !waiting_q);
        assert (ran_q || paused_q || failed_q || sent_q || (stored_q && !started_q));
        if (ran_q) assert (over_q);
        if (ran_q && ends_q && !gone_q && !wrote_q) assert (!started_q);
        if (ran_q && has_after && !gone_q) assert (wrote_q || gave_q || refused_q);
        // Flags and row agree, as the next turn assumes.
        if (started_q && !gone_q) assert (has_q == (phase_now != FETCHES));
      end
      if (row_write) begin
        assert (row[12:11] != 2'd3);
        if (row[13] && started_q) begin
          assert (row[12:11] == STORES || (op_valid && op == `FLOW_OP_END));
        end
        if (row[12:11] == LOADS) assert (has_before && row[10:0] == row_i[10:0]);
        if (failed_q || paused_q) begin
          assert (row[22:14] == (stored_q ? {answer_q, 1'b1} : row_i[22:14]));
          assert (row[10:0] == row_i[10:0] && !row[13]);
        end
        assert (row[10:0] == next_q && row[13] == ends_q);
        assert (row[12:11] == (send_before_q ? (write_before_q ? STORES : LOADS) : FETCHES));
        assert (!gone_q);
      end
      if (op_valid && op == `FLOW_OP_END) assert (ends_q && !gone_q && started_q);
      if (op_valid && op == `FLOW_OP_PAUSE) begin
        assert (of_turn && pauses && !ran_q && !own_q && phase_q != LOADS);
      end
    end
  end
  reg send_before_q, write_before_q;
  always @(posedge clk_i) {send_before_q, write_before_q} <= {send, write};

  // ---- what is assumed of it elsewhere -----------------------------------------------------------------------------------
  // flow_tasks: a row is not written when its task is started nor read when it is written; what waits, pauses, goes on or ends was
  // not stopped before. flow_ready: three clocks before the next task is looked for nothing becomes unready, but the one
  // whose turn ends with it.
  reg [3:0] started_before_q, unready_before_q;
  wire unready = op_valid && (op == `FLOW_OP_STOP || op == `FLOW_OP_END || op == `FLOW_OP_WAIT ||
      op == `FLOW_OP_PAUSE);
  reg locked_q;
  reg [3:0] locked_board_q;
  initial {started_before_q, unready_before_q, locked_q} = 9'd0;
  always @(posedge clk_i) begin
    started_before_q <= {started_before_q[2:0], op_valid && op == `FLOW_OP_START};
    unready_before_q <= {unready_before_q[2:0], unready};
    locked_q <= lock;
    locked_board_q <= lock_board;
  end
  always @* begin
    if (begun_q) begin
      if (row_write) assert (!started_before_q[1]);
      if (peeks) assert (started_before_q[1:0] == 2'b00 && !(row_write && row_task == op_task));
      if (op_valid && (op == `FLOW_OP_WAIT || op == `FLOW_OP_PAUSE || op == `FLOW_OP_TAKE ||
                       op == `FLOW_OP_END)) assert (!gone_q && started_q && !waiting_q);
      if (look) assert (unready_before_q[3:2] == 2'b00);
      if (look && unready_before_q[1]) assert (sent_q);
      // flow_route: a board that is held is locked again by its holder only.
      if (lock && locked_q && lock_board == locked_board_q) assert (block == own_block_q);
    end
  end

  // ---- for the induction ---------------------------------------------------------------------------------------------------
  localparam [5:0] IDLE = 6'd0;
  localparam [5:0] PICK = 6'd1;
  localparam [5:0] ROW = 6'd2;
  localparam [5:0] STEP = 6'd3;
  localparam [5:0] DECIDE = 6'd4;
  localparam [5:0] ANSWER = 6'd5;
  localparam [5:0] STORED = 6'd6;
  localparam [5:0] FETCH = 6'd7;
  localparam [5:0] READ = 6'd8;
  localparam [5:0] TAKE = 6'd9;
  localparam [5:0] ROUTE = 6'd10;
  localparam [5:0] ROUTED = 6'd11;
  localparam [5:0] LOCK = 6'd12;
  localparam [5:0] GET = 6'd13;
  localparam [5:0] PUT = 6'd14;
  localparam [5:0] STATUS = 6'd15;
  localparam [5:0] SETTLE = 6'd16;
  localparam [5:0] RUN = 6'd17;
  localparam [5:0] RUNNING = 6'd18;
  localparam [5:0] LAST = 6'd19;
  localparam [5:0] COMMAND = 6'd20;
  localparam [5:0] GAP1 = 6'd21;
  localparam [5:0] GAP2 = 6'd22;
  localparam [5:0] GAP3 = 6'd23;
  localparam [5:0] GAP4 = 6'd24;
  localparam [5:0] COLLECT = 6'd25;
  localparam [5:0] GIVE = 6'd26;
  localparam [5:0] SEND = 6'd27;
  localparam [5:0] SENT = 6'd28;
  localparam [5:0] AWAIT = 6'd29;
  localparam [5:0] AWAIT_ROW = 6'd30;
  localparam [5:0] AWAIT_STEP = 6'd31;
  localparam [5:0] AWAIT_FLAGS = 6'd32;
  localparam [5:0] ABORT = 6'd33;
  localparam [1:0] FOR_AFTER = 2'd0;
  localparam [1:0] FOR_BEFORE = 2'd1;
  localparam [1:0] FOR_LOAD = 2'd2;
  localparam [1:0] FOR_STORE = 2'd3;

  wire [3:0] acted = unready_before_q | started_before_q | peeked_q;
  wire after_linked = after_way_q == `FLOW_WAY_LINK || after_way_q == `FLOW_WAY_PANEL;
  wire gap = peek_state >= GAP1 && peek_state <= GAP4;
  wire routes = peek_state >= READ && peek_state <= ROUTED;
  wire copies = peek_state == GET || peek_state == PUT || peek_state == COLLECT ||
      peek_state == GIVE;
  wire awaits = peek_state >= AWAIT && peek_state <= AWAIT_FLAGS;
  // Before it is known what to do,
  wire early = (peek_state >= ROW && peek_state <= DECIDE) || awaits;
  wire answers = peek_state == ANSWER || peek_state == STORED;
  // to the routine, and in it.
  wire ahead = peek_state == FETCH || (routes && peek_for != FOR_STORE) || peek_state == LOCK ||
      peek_state == GET || peek_state == PUT || peek_state == STATUS || peek_state == SETTLE ||
      (peek_state == SEND && peek_for != FOR_STORE);
  wire behind = (routes && peek_for == FOR_STORE) || peek_state == COLLECT || peek_state == GIVE ||
      (peek_state == SEND && peek_for == FOR_STORE);
  always @* begin
    if (begun_q) begin
      assert (peek_state <= ABORT && stopped_q == (peek_state == ABORT));
      assert (going_q == (peek_state != IDLE && peek_state != ABORT));
      if (turn_q) assert (going_q && peek_task == task_q && task_q < `RUNG_FLOW_TASKS);
      if (going_q && !turn_q) begin
        assert (peek_state == PICK || (gap && !peek_behind));
        assert (peeked_q[2:0] == 3'd0 && !peek_row_due && !peek_finish_due && !own_q);
        assert (!peek_own && !waiting_q && !copying_q && !running_q && !last_q);
        assert (started_before_q == 4'd0);
        case (peek_state)
          GAP1: assert (!unready_before_q[3] && !unready_before_q[0]);
          GAP2: assert (unready_before_q[1:0] == 2'd0);
          GAP3: assert (unready_before_q[2:0] == 3'd0);
          default: assert (unready_before_q == 4'd0);
        endcase
      end
      if (going_q) begin
        assert (peeked_q[0] == (peek_state == ROW || peek_state == AWAIT_ROW));
        assert (peeked_q[1] == ((peek_state == STEP && !resumed_q) || peek_state == AWAIT_STEP));
        assert (peeked_q[2] == ((peek_state == DECIDE && !resumed_q) || peek_state == AWAIT_FLAGS));
        assert (taken_q == {peek_state == ROUTED, peek_state == ROUTE});
        assert (step_read_q == (peek_state == STEP && !resumed_q || peek_state == AWAIT_STEP));
        assert (peek_start == (peek_state == RUN) && running_q == (peek_state == RUNNING));
        assert (last_q == (peek_state == LAST) && copying_q == (copies && peek_begun));
        if (!copies) assert (!peek_begun);
      end else begin
        assert (!peek_start && !running_q && !last_q && !copying_q && !waiting_q);
        if (!stopped_q) begin
          assert (!peek_row_due && !peek_finish_due && !peek_own && !own_q);
        end
        if (quiet_q[0]) assert (!acted[0]);
        if (quiet_q[1:0] == 2'h3) assert (!acted[1]);
        if (quiet_q[2:0] == 3'h7) assert (!acted[2]);
        if (quiet_q == 4'hf) assert (!acted[3]);
      end
      if (peek_own) assert (peek_its_block == own_block_q);
      assert (peek_short == lacks_q && peek_short_before == lacked_q);
      if (stopped_q && own_q && fresh_q) assert (peek_own);
      if (turn_q) begin
        assert (peek_gone == gone_q && peek_behind == (over_q && peek_state != LAST));
        assert (ran_q == (running_q || over_q) && (!gone_q || over_q));
        if (fresh_q) assert (own_q);
        if (running_q) assert (!over_q);
        // Blocks.
        if (early || answers) assert (!peek_own && !fresh_q);
        else if (peek_state != PICK || peek_finish_due) assert (peek_own == own_q);
        if (answers) assert (own_q && peek_its_block == own_block_q);
        if (early) assert (own_q == (resumed_q && (peek_state == STEP || peek_state == DECIDE)));
        if (peek_state == SENT) assert (!own_q);
        // Row and step.
        if (!early || peek_state == DECIDE || awaits) begin
          assert (peek_next == next_q && peek_ends == ends_q);
        end
        if (!awaits && peek_state > STEP) begin
          assert (peek_step == row_i[10:0] && peek_before == step_before_i);
          assert (peek_after == step_after_i && peek_break == step_break_i);
          assert (peek_entry == step_entry_i && peek_end == step_end_i);
        end
        if ((peek_state == STEP && resumed_q) || (awaits && peek_state >= AWAIT_STEP)) begin
          assert (row_i == sent_row_q);
        end
        if ((peek_state == STEP || peek_state == DECIDE) && resumed_q) begin
          assert (own_block_q == peek_block_i && peek_has_i);
        end
        if (peek_state == DECIDE && !resumed_q) assert (phase_q == row_phase);
        if (peek_state == DECIDE) assert (peek_phase == phase_q);
        if (!early || peek_state == DECIDE) assert (phase_q != 2'd3);
        if (peek_state == STEP || peek_state == DECIDE) assert (row_phase != 2'd3);
        // Where it stands.
        if (ahead || peek_state == RUN) assert (!ran_q && !paused_q && !failed_q && !gone_q);
        if (behind) assert (over_q && !gone_q && has_after);
        if (behind && peek_state != READ) assert (transfer_q == step_after_i);
        if (gap || peek_state == COMMAND) assert (over_q);
        // Operations of the clocks before.
        case (peek_state)
          PICK: assert (unready_before_q[3:2] == 2'b00 && (sent_q || !unready_before_q[1]));
          ROW: assert (!unready_before_q[3] && !unready_before_q[0]);
          STEP: assert (unready_before_q[1:0] == 2'b00 && (!resumed_q || unready_before_q == 4'd0));
          DECIDE: assert (unready_before_q[2:0] == 3'd0);
          SENT: assert (unready_before_q[3:1] == 3'd0);
          AWAIT: assert (unready_before_q[3:2] == 2'd0 && !unready_before_q[0]);
          AWAIT_ROW: assert (!unready_before_q[3] && unready_before_q[1:0] == 2'd0);
          AWAIT_STEP: assert (unready_before_q[2:0] == 3'd0);
          GAP2: assert (!unready_before_q[0]);
          GAP3: assert (unready_before_q[1:0] == 2'd0);
          GAP4: assert (unready_before_q[2:0] == 3'd0);
          default:
          if (peek_state != COMMAND && peek_state != GAP1) assert (unready_before_q == 4'd0);
        endcase
        case (peek_state)
          COMMAND, GAP1: ;
          GAP2: assert (!started_before_q[0]);
          GAP3: assert (started_before_q[1:0] == 2'd0);
          GAP4: assert (started_before_q[2:0] == 3'd0);
          default: assert (started_before_q[1:0] == 2'd0);
        endcase
        if (early && !awaits && !resumed_q) begin
          assert (!ran_q && !sent_q && !stored_q && !paused_q && !failed_q && !put_q && !got_q);
          assert (!loaded_q && !collected_q && !gave_q && !wrote_q && !after_known_q && !has_q);
          assert (!refused_q);
        end
        if (resumed_q || waiting_q || wrote_q) assert (sent_q);
        if (wrote_q) assert (over_q && collected_q);
        if (!over_q) assert (!refused_q);
        if (awaits) assert (waiting_q);
        if (waiting_q) assert (peek_state == SENT || awaits);
        if (peek_state == SENT) assert (sent_q && waiting_q == (in_place || !gives_up_i));
        assert (send_before_q == (peek_state == SENT));
        if (send_before_q) begin
          assert (write_before_q == over_q && wrote_q == over_q && (over_q || !ran_q));
          assert (peek_phase == (over_q ? STORES : LOADS));
          if (!over_q) assert (has_before && next_q == row_i[10:0]);
        end
        if (awaits || ((peek_state == STEP || peek_state == DECIDE) && resumed_q)) begin
          assert (sent_row_q[12:11] == (ran_q ? STORES : LOADS) && over_q == ran_q);
          assert (phase_q == sent_row_q[12:11]);
          assert (wrote_q == ran_q && !gone_q && !paused_q && !failed_q && has_q);
          assert (sent_row_q[10:0] == next_q && sent_row_q[13] == ends_q && !stored_q);
          if (!ran_q) assert (!got_q && !put_q && !loaded_q && !collected_q && !gave_q);
          assert (ran_q || !ends_q);
        end
        if (peek_state == DECIDE && !awaits && resumed_q) assert (row_i == sent_row_q);
        if ((peek_state == STEP || peek_state == DECIDE) && row_i[13]) assert (row_phase == STORES);
        if ((peek_state == STEP || peek_state == DECIDE || (awaits && peek_state >= AWAIT_STEP)) &&
            row_phase == LOADS) begin
          assert (has_before);
        end
        if (peek_state == DECIDE) begin
          assert ({peek_status, peek_status_due} == row_i[22:14]);
          assert (peek_has_i == (row_phase != FETCHES));
        end
        if (answers) begin
          assert (phase_q == STORES && ran_q == wrote_q && ran_q == over_q && has_q && !gone_q);
          assert (ran_q == resumed_q && !paused_q && !failed_q && !stored_q && sent_q == ran_q);
          if (!ran_q) assert (!got_q && !put_q && !loaded_q && !collected_q && !gave_q);
          if (!ran_q) assert (!after_known_q);
        end
        if (answers || ahead || peek_state == RUN) assert (peek_in_place == resumed_q);
        if (early) assert (peek_in_place == (resumed_q || waiting_q));
        if (peek_state == DECIDE || answers) begin
          assert (next_q == row_i[10:0] && ends_q == row_i[13]);
        end
        // Up to the routine.
        if (ahead || peek_state == RUN) begin
          assert (!ends_q && !wrote_q && !collected_q && !gave_q && next_q == row_i[10:0]);
          assert (sent_q == resumed_q && (!sent_q || loads) && has_q == loads);
          assert (stored_q == (phase_q == STORES) && peek_status_due == (row_i[14] || stored_q));
          if (peek_state != FETCH) assert ((peek_for == FOR_LOAD) == loads);
          if (peek_state == FETCH) assert (stored_q && !own_q && !put_q);
          if (loads) assert (has_before && own_q && peek_flags_due && !fresh_q);
          else assert (!pauses || peek_state == FETCH);
          if (peek_state < GET || peek_state == SEND) assert (!got_q && !loaded_q && !put_q);
          if (peek_state == GET || peek_state == PUT) assert (!loaded_q && !put_q && has_before);
          if (peek_state == GET) assert (local_way && !got_q && !loads && peek_for == FOR_BEFORE);
          if (peek_state == PUT) assert (peek_for == FOR_BEFORE || peek_for == FOR_LOAD);
          if (peek_state == PUT) begin
            assert (loads ? status_i == 8'd0 && !got_q && own_q : got_q && local_way);
          end
          if (peek_state == STATUS) assert (!put_q);
          if (peek_state == SETTLE) assert (put_q);
          if (peek_state == STATUS || peek_state == SETTLE || peek_state == RUN) begin
            if (loads) assert (!got_q && loaded_q == (status_i == 8'd0));
            else if (has_before) assert ((local_way || refused) && got_q == local_way);
            if (!loads) assert (loaded_q == (has_before && local_way));
            if (!has_before) assert (!got_q && !loads);
          end
          if (peek_state == RUN) assert (put_q == (has_before || peek_status_due));
          if (peek_state == STATUS) assert (has_before || peek_status_due);
        end
        if (early || answers || ahead || behind || (peek_state >= RUN && peek_state <= LAST)) begin
          assert (!peek_finish_due);
        end
        if ((peek_state == COMMAND || gap) && has_after && !gone_q) assert (!peek_finish_due);
        if (early) assert (!peek_row_due);
        if (ahead || peek_state == RUN) assert (peek_row_due == stored_q);
        if (peek_state == FETCH || (routes && !peek_for[1])) assert (peek_answered == stored_q);
        if (early && !awaits && !resumed_q) assert (!peek_answered);
        if (answers && !resumed_q) assert (!peek_answered);
        // Its status.
        if (peek_state == FETCH || (ahead && !has_before) || (routes && peek_for[1] == 1'b0)) begin
          assert (peek_status == (stored_q ? answer_q : row_i[22:15]));
        end
        if (peek_state == STATUS && has_before) begin
          assert (peek_status == (loads ? status_i : local_way ? 8'd0 : `RUNG_FLOW_STATUS_REFUSED));
        end
        if ((peek_state == GET || peek_state == PUT) && !loads) assert (peek_status == 8'd0);
        if (peek_state == PUT && loads) assert (peek_status == status_i);
        // Transfers.
        if (routes && (peek_for == FOR_AFTER || peek_for == FOR_STORE)) assert (has_after);
        if (routes && (peek_for == FOR_BEFORE || peek_for == FOR_LOAD)) assert (has_before);
        if (routes && peek_state != READ) begin
          assert (transfer_q == (peek_for[0] == peek_for[1] ? step_after_i : step_before_i));
        end
        if (peek_state == LOCK || peek_state == GET || peek_state == PUT ||
            (peek_state == SEND && !over_q)) begin
          assert (has_before && transfer_q == step_before_i);
        end
        if (peek_state == LOCK) assert (peek_for == FOR_BEFORE && (own_q || !linked));
        if (peek_state == SEND) assert (linked && own_q && !has_q);
        if (peek_state == COLLECT) assert (!refused && (own_q || !linked) && !collected_q);
        if (peek_state == GIVE) assert (local_way && collected_q && !gave_q);
        if (peek_state == SEND && over_q) assert (collected_q);
        // The block for what stands behind it.
        if (routes && !peek_for[1]) begin
          assert (!own_q && peek_after_link == (after_known_q && after_linked));
          if (peek_for == FOR_BEFORE && has_after) assert (after_known_q);
        end
        if (peek_state == FETCH || (early && !awaits)) begin
          if (!resumed_q) assert (!peek_after_link && !after_known_q);
        end
        if (answers && !resumed_q) assert (!peek_after_link);
        if (((ahead && peek_state >= LOCK) || (peek_state >= RUN && peek_state <= GAP4) ||
             (routes && peek_for == FOR_STORE)) && has_after && !own_q && !gone_q) begin
          assert (after_known_q && !after_linked);
        end
        if (routes && peek_for == FOR_AFTER) assert (!after_known_q);
        if (routes && peek_for == FOR_BEFORE && has_after) begin
          assert (peek_after_lock == after_alone_q && peek_after_board == after_board_q);
          assert (peek_after_held == after_held_q);
        end
        if (peek_state == LOCK && has_after) begin
          assert (after_known_q && peek_after_lock == after_alone_q && (!own_q || !after_held_q));
          assert (peek_after_board == after_board_q && !peek_after_held && (!own_q || fresh_q));
        end
        if (!has_after && (ahead || (early && !awaits)) && !resumed_q) assert (!peek_after_lock);
        if (early && !resumed_q && !awaits) assert (!peek_after_lock && !peek_after_held);
        if ((answers || peek_state == FETCH) && !resumed_q) begin
          assert (!peek_after_lock && !peek_after_held);
        end
        if (!has_after && routes && peek_for == FOR_BEFORE) assert (!peek_after_held);
        if (((ahead && peek_state > LOCK) || peek_state == RUN) && fresh_q && has_after) begin
          assert (after_known_q && (!after_alone_q || locked_after_q));
        end
        // In the routine, and behind it.
        if (ran_q) assert (!paused_q && !failed_q);
        if ((peek_state >= RUNNING && peek_state <= GAP4) || behind) begin
          assert (!has_q && !wrote_q && !gave_q && ran_q && sent_q == resumed_q);
          if (peek_state == COLLECT || peek_state == GIVE) assert (peek_for == FOR_STORE);
          if (peek_state != COLLECT && peek_state != GIVE && peek_state != SEND) begin
            assert (!collected_q);
          end
          assert (!refused_q);
          if (routes || ((peek_state == COMMAND || gap) && !gone_q)) assert (peek_row_due);
          if (peek_state == COMMAND || gap) begin
            assert ((!own_q && !(ends_q && !gone_q)) || peek_finish_due || (has_after && !gone_q));
            if (has_after) assert (peek_for == FOR_STORE);
          end
          if (gone_q) assert (!peek_row_due && !ends_q && (peek_finish_due || !own_q));
          if (peek_state >= COLLECT) assert (!peek_row_due);
        end
        if (gone_q) assert (!peek_row_due && !ends_q && peek_state != LAST);
        if (peek_state == SENT) assert (has_q && !gone_q);
        if (peek_state != PICK && !over_q) assert (started_q);
        if (!gone_q && peek_state != PICK) assert (started_q);
        if (peek_state > DECIDE && peek_state < SEND) assert (peek_phase == FETCHES);
        // A turn's end.
        if (peek_state == PICK) begin
          assert (ran_q == over_q);
          assert (over_q || paused_q || failed_q || sent_q || (stored_q && !started_q));
          if (over_q && has_after && !gone_q) assert (wrote_q || gave_q || refused_q);
          if (own_q) assert (peek_finish_due);
          if (peek_row_due) assert (peek_phase == FETCHES && !has_q && !gone_q && !send_before_q);
          else if (started_q && !gone_q) assert (has_q == (phase_q != FETCHES));
          if (peek_finish_due) assert (over_q && (started_q || gone_q) && !wrote_q);
          if (ends_q && !gone_q && started_q) assert (peek_finish_due || wrote_q);
          if (failed_q || paused_q) begin
            assert (!own_q && !ends_q && next_q == row_i[10:0] && !ran_q && !sent_q && !gone_q);
            assert (peek_row_due || phase_q == FETCHES);
            if (peek_row_due) begin
              assert ({peek_status, peek_status_due} ==
                      (stored_q ? {answer_q, 1'b1} : row_i[22:14]));
            end
          end
        end
      end
    end
  end

  // ---- clocks of a turn, beside those in which it waits --------------------------------------------------------------------
  localparam [5:0] MOST = 6'd45;  // behind the one that picks it
  reg [5:0] clocks_q;
  reg [5:0] left;  // at most, with this one
  wire waits = (copies && !copy_done_i) || (peek_state == SEND && sending_i) || awaits ||
      (peek_state == RUNNING && !done_i) || (peek_state == COMMAND && !command_last_i);
  always @(posedge clk_i) begin
    if (look) clocks_q <= 6'd0;
    else if (!waits) clocks_q <= clocks_q + 6'd1;
  end
  always @* begin
    case (peek_state)
      PICK: left = {5'd0, peek_finish_due};
      ROW: left = MOST;
      STEP: begin
        left = row_phase == STORES ? (ran_q ? 6'd4 : 6'd44) : row_phase == LOADS ? 6'd28 : 6'd41;
      end
      DECIDE: left = phase_q == STORES ? (ran_q ? 6'd3 : 6'd43) : loads ? 6'd27 : 6'd40;
      ANSWER: left = ran_q ? 6'd2 : 6'd42;
      STORED: left = ran_q ? 6'd1 : 6'd41;
      FETCH: left = 6'd40;
      READ, TAKE, ROUTE, ROUTED: begin
        case (peek_for)
          FOR_AFTER: left = 6'd36;
          FOR_BEFORE: left = 6'd32;
          FOR_LOAD: left = 6'd23;
          default: left = 6'd8;
        endcase
        left = left + {4'd0, ~peek_state[1:0]};  // READ is 8, ROUTED 11
      end
      LOCK: left = 6'd31;
      GET: left = 6'd23;
      PUT: left = 6'd22;
      STATUS: left = 6'd21;
      SETTLE: left = 6'd20;
      RUN: left = 6'd19;
      RUNNING: left = 6'd18;
      LAST: left = 6'd17;
      COMMAND: left = 6'd16;
      GAP1: left = 6'd15;
      GAP2: left = 6'd14;
      GAP3: left = 6'd13;
      GAP4: left = 6'd12;
      COLLECT: left = 6'd7;
      GIVE: left = 6'd2;
      SEND: left = over_q ? 6'd6 : 6'd30;
      SENT: left = over_q ? 6'd5 : 6'd29;
      default: left = ran_q ? 6'd4 : 6'd28;
    endcase
  end
  always @* if (begun_q && turn_q) assert ({1'b0, clocks_q} + {1'b0, left} <= {1'b0, MOST});

  // ---- it happens ------------------------------------------------------------------------------------------------------------
  always @* begin
    // An answer, and the next step's routine and STORE in the same turn.
    cover (begun_q && look && turn_q && over_q && wrote_q && !resumed_q && row_i[12:11] == STORES);
    // In place: data come, the routine runs.
    cover (begun_q && look && turn_q && over_q && resumed_q && loaded_q);
    // Own memory, before and behind the routine.
    cover (begun_q && look && turn_q && loaded_q && gave_q);
    // It stops its own task, which has a STORE to come.
    cover (begun_q && look && turn_q && gone_q && has_after && !wrote_q);
    cover (begun_q && full && has_before && has_after);
    cover (begun_q && held && !has_before);
    cover (begun_q && full && stored_q && task_block_valid_i);
    cover (begun_q && look && paused_q);
    cover (begun_q && lock && locked_q);
    cover (begun_q && stopped_q && own_q && fresh_q);
  end

endmodule

`default_nettype wire

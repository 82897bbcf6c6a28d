// SPDX-License-Identifier: Apache-2.0
// Table of tasks (hdl/flow/flow_tasks.v), any task: its flags change by an operation on it, as the table at the top of that file
// has it, two clocks after it is given, whatever was given before and after it and for whom; its row by the engine's writes, a
// start or the program's start; a task is told to be ready exactly if it is started, does not wait and is not in PAUSE. PEEK and the bus read
// what was written last. A block leaves a task once: taken by the engine, or freed; one that comes for a task that does not
// wait for it is freed and counted. The walk does each task once, what the bus asks for is done behind it.
`default_nettype none
`include "rung_controller.vh"
`include "rung_flow.vh"
`include "flow_ops.vh"

module flow_tasks_proof (
    input wire         clk_i,
    input wire         rst_ni,
    input wire         first_i,
    input wire         engine_valid_i,
    input wire  [ 3:0] engine_op_i,
    input wire  [ 6:0] engine_task_i,
    input wire  [ 4:0] engine_block_i,
    input wire         engine_free_i,
    input wire         come_valid_i,
    input wire  [ 6:0] come_task_i,
    input wire  [ 4:0] come_block_i,
    input wire         row_write_i,
    input wire  [ 6:0] row_task_i,
    input wire  [22:0] row_i,
    input wire  [10:0] row_view_i,
    input wire         load_write_i,
    input wire  [ 6:0] load_addr_i,
    input wire  [15:0] load_data_i,
    input wire         sel_register_i,
    input wire  [ 7:0] addr_i,
    input wire         read_i,
    input wire         write_i,
    input wire  [15:0] wdata_i,
    // inside of it
    input wire  [34:0] peek_watched,
    input wire  [ 9:0] peek_flags_word,
    input wire  [ 9:0] peek_flags_read,
    input wire         peek_again,
    input wire  [ 9:0] peek_written,
    input wire  [ 9:0] peek_flags,
    input wire  [15:0] peek_first_word,
    input wire  [15:0] peek_first_read,
    input wire  [15:0] peek_first,
    input wire  [22:0] peek_row_word,
    input wire  [ 2:0] peek_flags_seen,
    input wire  [12:0] peek_row_seen,
    input wire  [ 2:0] peek_view_flags,
    input wire  [12:0] peek_view_row,
    input wire         peek_look_valid,
    input wire  [16:0] peek_look,
    input wire         peek_op_valid,
    input wire  [16:0] peek_op,
    input wire         peek_walking,
    input wire  [ 6:0] peek_walk,
    input wire         peek_bus_valid,
    input wire  [ 7:0] peek_bus,
    input wire  [ 6:0] peek_view
);

  localparam [6:0] LAST = `RUNG_FLOW_TASKS - 1;
  (* anyconst *) wire [6:0] watched;

  wire walking, come_ready, peek_waits, peek_ask, peek_skip, peek_has, ready_valid, ready;
  wire free_valid, late;
  wire [4:0] peek_block, free_block;
  wire [22:0] row;
  wire [6:0] ready_task;
  wire [15:0] rdata;
  flow_tasks tasks (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .first_i       (first_i),
      .walking_o     (walking),
      .engine_valid_i(engine_valid_i),
      .engine_op_i   (engine_op_i),
      .engine_task_i (engine_task_i),
      .engine_block_i(engine_block_i),
      .engine_free_i (engine_free_i),
      .come_valid_i  (come_valid_i),
      .come_ready_o  (come_ready),
      .come_task_i   (come_task_i),
      .come_block_i  (come_block_i),
      .peek_waits_o  (peek_waits),
      .peek_ask_o    (peek_ask),
      .peek_skip_o   (peek_skip),
      .peek_has_o    (peek_has),
      .peek_block_o  (peek_block),
      .row_o         (row),
      .row_write_i   (row_write_i),
      .row_task_i    (row_task_i),
      .row_i         (row_i),
      .row_view_i    (row_view_i),
      .ready_valid_o (ready_valid),
      .ready_task_o  (ready_task),
      .ready_o       (ready),
      .free_valid_o  (free_valid),
      .free_block_o  (free_block),
      .late_o        (late),
      .load_write_i  (load_write_i),
      .load_addr_i   (load_addr_i),
      .load_data_i   (load_data_i),
      .sel_register_i(sel_register_i),
      .addr_i        (addr_i),
      .read_i        (read_i),
      .write_i       (write_i),
      .wdata_i       (wdata_i),
      .rdata_o       (rdata)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  // ---- what the bus asks for, and the walk ---------------------------------------------------------------------------
  reg asks_q, go_q;
  reg [6:0] asks_task_q, view_q;
  reg walks_q;
  reg [6:0] walk_q;
  reg due_q;  // the watched task has its INIT to come
  reg [6:0] walked_q;  // clocks of the walk, beside those that others took
  reg watch_q;  // the watched task is as the program's start made it, or what became of it
  wire bus_write = sel_register_i && write_i;
  wire asks_now = bus_write && addr_i == `RUNG_REG_FLOW_TASK_CONTINUE;
  wire others = engine_valid_i || come_valid_i;
  wire gives_bus = asks_q && !walks_q && !others;
  wire gives_init = walks_q && !others;
  always @(posedge clk_i) begin
    if (!rst_ni) asks_q <= 1'b0;
    else if (asks_now) asks_q <= 1'b1;
    else if (gives_bus || first_i) asks_q <= 1'b0;
    if (asks_now) {go_q, asks_task_q} <= {wdata_i[0], view_q};
    if (!rst_ni) view_q <= 7'd0;
    else if (bus_write && addr_i == `RUNG_REG_FLOW_TASK) begin
      view_q <= wdata_i > {9'd0, LAST} ? LAST : wdata_i[6:0];
    end
    if (!rst_ni) walks_q <= 1'b0;
    else if (first_i) walks_q <= 1'b1;
    else if (gives_init && walk_q == LAST) walks_q <= 1'b0;
    if (first_i) walk_q <= 7'd0;
    else if (gives_init) walk_q <= walk_q + 7'd1;
    if (!rst_ni) due_q <= 1'b0;
    else if (first_i) due_q <= 1'b1;
    else if (gives_init && walk_q == watched) due_q <= 1'b0;
    if (first_i) walked_q <= 7'd0;
    else if (gives_init) walked_q <= walked_q + 7'd1;
  end

  // ---- operations: given, looked up, done ---------------------------------------------------------------------------
  wire given = others || gives_bus || gives_init;
  wire [3:0] given_op = engine_valid_i ? engine_op_i : come_valid_i ? `FLOW_OP_COME :
      gives_init ? `FLOW_OP_INIT : go_q ? `FLOW_OP_GO : `FLOW_OP_ASK;
  wire [6:0] given_task = engine_valid_i ? engine_task_i : come_valid_i ? come_task_i :
      gives_init ? walk_q : asks_task_q;
  wire [4:0] given_block = engine_valid_i ? engine_block_i : come_block_i;
  reg look_q, do_q;
  reg [3:0] look_op_q, op_q;
  reg [6:0] look_task_q, task_q;
  reg [4:0] look_block_q, block_q;
  reg look_free_q, free_q;
  reg known_q;  // its first step has been loaded
  reg [15:0] look_first_q, first_q, loaded_q;
  wire does = do_q && task_q == watched;
  initial {look_q, do_q} = 2'b00;
  always @(posedge clk_i) begin
    {look_q, do_q} <= {rst_ni && given, rst_ni && look_q};
    {look_op_q, look_task_q, look_block_q} <= {given_op, given_task, given_block};
    {op_q, task_q, block_q, free_q} <= {look_op_q, look_task_q, look_block_q, look_free_q};
    look_free_q <= engine_valid_i && engine_free_i;
    if (!begun_q) known_q <= 1'b0;
    else if (load_write_i && load_addr_i == watched) known_q <= 1'b1;
    if (load_write_i && load_addr_i == watched) loaded_q <= load_data_i;
    {look_first_q, first_q} <= {loaded_q, look_first_q};
  end

  // ---- the watched task --------------------------------------------------------------------------------------------
  reg started_q, waits_q, paused_q, ask_q, skip_q, has_q;
  reg [3:0] its_block_q;
  reg row_known_q;
  reg [22:0] row_q;
  reg [12:0] seen_q;
  reg ready_q;  // as the ready vector was told
  wire comes = op_q == `FLOW_OP_COME && waits_q && block_q == {1'b0, its_block_q};
  wire vanishes = op_q == `FLOW_OP_COME && !comes;
  wire begins = (op_q == `FLOW_OP_START && !started_q) || op_q == `FLOW_OP_INIT;
  wire stops = op_q == `FLOW_OP_STOP || op_q == `FLOW_OP_INIT;
  wire gives_block = stops && has_q && !waits_q;
  wire continues = op_q == `FLOW_OP_GO && paused_q;
  wire ends = op_q == `FLOW_OP_STOP || op_q == `FLOW_OP_END;
  wire rests = op_q == `FLOW_OP_WAIT || op_q == `FLOW_OP_PAUSE;
  initial {started_q, waits_q, paused_q, ask_q, skip_q, has_q, its_block_q} = 10'd0;
  always @(posedge clk_i) begin
    if (does) begin
      if (ends || begins) begin
        {waits_q, paused_q, ask_q, skip_q, has_q, its_block_q} <= 9'd0;
        started_q <= op_q == `FLOW_OP_INIT ? first_q[15] : op_q == `FLOW_OP_START;
      end
      case (op_q)
        `FLOW_OP_TAKE: {has_q, skip_q} <= 2'b00;
        `FLOW_OP_WAIT: {waits_q, has_q, skip_q, its_block_q} <= {3'b110, block_q[3:0]};
        `FLOW_OP_COME: if (comes) waits_q <= 1'b0;
        `FLOW_OP_PAUSE: {paused_q, ask_q} <= 2'b10;
        `FLOW_OP_GO: {paused_q, ask_q, skip_q} <= {2'b00, paused_q};
        `FLOW_OP_ASK: ask_q <= started_q && !paused_q;
        default: ;
      endcase
    end
    if (!begun_q) row_known_q <= 1'b0;
    else if (row_writes) row_known_q <= 1'b1;
    if (does && begins) {row_q, seen_q} <= {12'd0, first_q[10:0], 2'd0, first_q[10:0]};
    else if (row_write_i && row_task_i == watched) begin
      {row_q, seen_q} <= {row_i, row_i[12:11], row_view_i};
    end
    if (!rst_ni) {ready_q, watch_q} <= 2'b00;
    else begin
      if (ready_valid && ready_task == watched) ready_q <= ready;
      if (does && op_q == `FLOW_OP_INIT) watch_q <= 1'b1;
    end
  end

  // ---- who uses it ---------------------------------------------------------------------------------------------------
  wire starts_soon = look_q && (look_op_q == `FLOW_OP_START || look_op_q == `FLOW_OP_INIT);
  wire starts_now = do_q && (op_q == `FLOW_OP_START || op_q == `FLOW_OP_INIT);
  wire peeks = engine_valid_i && engine_op_i == `FLOW_OP_PEEK;
  always @* begin
    assume (watched <= LAST);
    if (engine_valid_i) begin
      assume (engine_op_i <= `FLOW_OP_PAUSE);
      assume (!engine_free_i || engine_op_i == `FLOW_OP_TAKE || engine_op_i == `FLOW_OP_END ||
              engine_op_i == `FLOW_OP_FREE);
    end
    // A task's request has a task's block.
    assume (!engine_valid_i || engine_op_i != `FLOW_OP_WAIT || engine_block_i < 5'd16);
    assume (!come_valid_i || come_block_i < 5'd16);
    // What waits, pauses, goes on or ends is in its turn: ready, and not stopped in it (flow_step).
    if (does && (rests || op_q == `FLOW_OP_TAKE || op_q == `FLOW_OP_END)) begin
      assume (started_q && !waits_q && !paused_q);
    end
    // A row is not written when the task is started, not read when it is written, nor while a program starts (flow_step).
    assume (!row_write_i || !(starts_now || walking));
    assume (!peeks || !(starts_now || starts_soon || walking));
    assume (!peeks || !row_write_i || row_task_i != engine_task_i);
    // Who loads a program loads all first steps, while no round runs, and a clock before the program starts at least.
    if (given && (given_op == `FLOW_OP_START || given_op == `FLOW_OP_INIT)) begin
      assume (!load_write_i && (given_task != watched || known_q));
    end
  end

  // ---- what PEEK and the bus see -------------------------------------------------------------------------------------
  reg peeked_q;  // the last PEEK that is done is of it
  reg [3:0] peek_q;
  reg [3:0] peek_block_q;
  reg rowed_q, rowed_known_q;  // the last row that was read is its
  reg [22:0] rowed_row_q;
  // The bus sees what it was in the last clock in which it was not written.
  reg shown_q, shown_row_q;
  reg [2:0] shown_flags_q;
  reg [12:0] shown_seen_q;
  wire writes = does && ((op_q == `FLOW_OP_START && !started_q) ||
      (op_q != `FLOW_OP_START && op_q != `FLOW_OP_PEEK && op_q != `FLOW_OP_FREE));
  wire row_writes = (row_write_i && row_task_i == watched) || (does && begins);
  reg read_q, read_state_q, read_step_q, read_view_q;
  reg [15:0] read_data_q;
  wire [1:0] phase = shown_flags_q[2] ? 2'd3 : shown_flags_q[0] ? shown_seen_q[12:11] : 2'd0;
  always @(posedge clk_i) begin
    if (!begun_q) peeked_q <= 1'b0;
    else if (do_q && op_q == `FLOW_OP_PEEK) peeked_q <= task_q == watched;
    if (do_q && op_q == `FLOW_OP_PEEK) begin
      {peek_q, peek_block_q} <= {waits_q, ask_q, skip_q, has_q, its_block_q};
    end
    if (!begun_q) rowed_q <= 1'b0;
    else if (peeks) rowed_q <= engine_task_i == watched && row_known_q;
    if (peeks) rowed_row_q <= row_q;
    shown_q <= begun_q && view_q == watched && (shown_q || !writes);
    if (!writes) shown_flags_q <= {paused_q, waits_q, started_q};
    shown_row_q <= begun_q && view_q == watched && (row_writes ? shown_row_q : row_known_q);
    if (!row_writes) shown_seen_q <= seen_q;
    read_q <= begun_q && sel_register_i && read_i;
    read_state_q <= addr_i == `RUNG_REG_FLOW_TASK_STATE && shown_q && shown_row_q;
    read_step_q <= addr_i == `RUNG_REG_FLOW_TASK_STEP && shown_row_q;
    read_view_q <= addr_i == `RUNG_REG_FLOW_TASK;
    read_data_q <= addr_i == `RUNG_REG_FLOW_TASK ? {9'd0, view_q} :
        addr_i == `RUNG_REG_FLOW_TASK_STEP ? {5'd0, shown_seen_q[10:0]} :
        {12'd0, shown_flags_q[1:0], phase};
  end

  // ---- blocks --------------------------------------------------------------------------------------------------------
  reg freed_q, freed_known_q, late_q;
  reg [4:0] freed_block_q;
  always @(posedge clk_i) begin
    freed_known_q <= !do_q || task_q == watched || free_q;
    freed_q <= rst_ni && do_q && (free_q || (task_q == watched && (gives_block || vanishes)));
    late_q <= rst_ni && does && vanishes;
    freed_block_q <= task_q == watched && gives_block ? {1'b0, its_block_q} : block_q;
  end

  always @* begin
    if (begun_q) begin
      assert (come_ready == !engine_valid_i);
      // The ready vector.
      assert ((ready_valid && ready_task == watched) ==
              (does && (ends || rests || begins || comes || continues)));
      if (ready_valid && ready_task == watched) begin
        assert (ready == (comes || continues || (op_q == `FLOW_OP_START || (op_q == `FLOW_OP_INIT &&
                first_q[15]))));
      end
      if (watch_q) assert (ready_q == (started_q && !waits_q && !paused_q));
      if (watch_q && !started_q) assert (!waits_q && !paused_q && !has_q && !ask_q);
      // PEEK, the bus.
      if (peeked_q) begin
        assert ({peek_waits, peek_ask, peek_skip, peek_has} == peek_q);
        assert (peek_block == {1'b0, peek_block_q});
      end
      if (rowed_q) assert (row == rowed_row_q);
      if (read_q && (read_view_q || read_state_q || read_step_q)) assert (rdata == read_data_q);
      if (!read_q) assert (rdata == 16'd0 || !warm_q);
      // Blocks.
      if (freed_known_q && warm_q) begin
        assert (free_valid == freed_q && (!freed_q || free_block == freed_block_q));
        if (!freed_q) assert (!late);
      end
      if (late_q) assert (late && free_valid);
      // The walk.
      assert (walking == (walks_q || first_i || (look_q && look_op_q == `FLOW_OP_INIT) ||
                          (do_q && op_q == `FLOW_OP_INIT)));
      if (!walks_q) assert (!due_q);
      if (walks_q) assert (walked_q <= LAST && due_q == (walk_q <= watched));
    end
  end
  reg warm_q;
  always @(posedge clk_i) warm_q <= begun_q;

  // ---- for the induction ---------------------------------------------------------------------------------------------
  wire [9:0] flags = {its_block_q, has_q, skip_q, ask_q, paused_q, waits_q, started_q};
  wire its_look = look_q && look_task_q == watched;
  always @* begin
    assume (peek_watched == {5{watched}});
    if (!begun_q) assume (!peek_op_valid);  // as configured
    if (begun_q) begin
      assert (peek_flags_word == flags && peek_flags_seen == flags[2:0]);
      if (its_look) assert ((peek_again ? peek_written : peek_flags_read) == flags);
      if (does) assert (peek_flags == flags);
      if (known_q) assert (peek_first_word == loaded_q);
      if (its_look && (look_op_q == `FLOW_OP_START || look_op_q == `FLOW_OP_INIT))
        assert (peek_first_read == look_first_q);
      if (does && (op_q == `FLOW_OP_START || op_q == `FLOW_OP_INIT))
        assert (peek_first == first_q);
      if (row_known_q) assert (peek_row_word == row_q);
      if (row_known_q) assert (peek_row_seen == seen_q);
      if (shown_q) assert (peek_view_flags == shown_flags_q);
      if (shown_row_q) assert (peek_view_row == shown_seen_q);
      assert (peek_look_valid == look_q && peek_op_valid == do_q);
      if (look_q) begin
        assert (peek_look == {look_op_q, look_task_q, look_block_q, look_free_q});
      end
      if (do_q) assert (peek_op == {op_q, task_q, block_q, free_q});
      assert (!look_q || look_op_q <= `FLOW_OP_ASK);
      assert (!do_q || op_q <= `FLOW_OP_ASK);
      if (look_free_q) assert (look_op_q >= `FLOW_OP_TAKE && look_op_q <= `FLOW_OP_FREE);
      if (do_q && free_q) assert (op_q >= `FLOW_OP_TAKE && op_q <= `FLOW_OP_FREE);
      assert (peek_walking == walks_q && peek_bus_valid == asks_q && peek_view == view_q);
      if (walks_q) assert (peek_walk == walk_q && walk_q == walked_q);
      if (asks_q) assert (peek_bus == {go_q, asks_task_q});
      assert (view_q <= LAST);
      if (watch_q && waits_q) assert (!paused_q && has_q);
      if (waits_q) assert (has_q);
    end
  end

  reg ran_q, stored_q, waited_q;  // the program started it, it waited, its data came
  always @(posedge clk_i) begin
    ran_q <= begun_q && (ran_q || (does && op_q == `FLOW_OP_INIT && first_q[15]));
    waited_q <= begun_q && (waited_q || (does && ran_q && op_q == `FLOW_OP_WAIT));
    stored_q <= begun_q && (stored_q || (does && waited_q && comes));
  end
  always @* begin
    cover (begun_q && stored_q && freed_q && op_q == `FLOW_OP_STOP && free_valid);
    cover (begun_q && watch_q && paused_q && asks_q && go_q && asks_task_q == watched);
    cover (begun_q && waited_q && late && late_q);
    cover (begun_q && read_q && read_state_q && rdata == 16'd7);
    cover (begun_q && peeked_q && peek_skip && rowed_q && row[10:0] == 11'd1234);
  end

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// The table of tasks. A task has flags (started, waits for its data, ...), a row (its step and what it is about
// to do there), and its first step, which is loaded. Everything that happens to a task is an operation: given
// in one clock, looked up in the next and done in the one after that, engine before completions before bus, which waits for the walk that starts a
// program. What an operation changes of a task's readiness goes to flow_ready.v, blocks that it frees to the pool and
// the locks.
//   PEEK   the row into row_o in the next clock, flags into peek_*_o in the third, both until the next PEEK
//   START  if it is not started: it is, at its first step       STOP   it is not; a block with data is freed
//   TAKE   the block is the engine's; a breakpoint is passed     END    it is not started
//   FREE   nothing else                                           WAIT   it waits, for op_block
//   PAUSE  it is in PAUSE                                          COME   op_block has its data: it waits no more
//   INIT   as at a program's start                                GO, ASK  as flow_task_continue says
// engine_free_i with TAKE, END, FREE: op_block is free.
// COME for a block that the task does not wait for (it was stopped) frees it, and late_o counts it.
`default_nettype none
`include "rung_controller.vh"
`include "rung_flow.vh"
`include "flow_ops.vh"

module flow_tasks (
    input  wire        clk_i,
    input  wire        rst_ni,
    // program's start: first_i a pulse; no round while walking_o is 1
    input  wire        first_i,
    output wire        walking_o,
    // engine's operations
    input  wire        engine_valid_i,
    input  wire [ 3:0] engine_op_i,
    input  wire [ 6:0] engine_task_i,
    input  wire [ 4:0] engine_block_i,
    input  wire        engine_free_i,
    // completions
    input  wire        come_valid_i,
    output wire        come_ready_o,
    input  wire [ 6:0] come_task_i,
    input  wire [ 4:0] come_block_i,
    // what PEEK gives
    output wire        peek_waits_o,
    output wire        peek_ask_o,
    output wire        peek_skip_o,
    output wire        peek_has_o,
    output wire [ 4:0] peek_block_o,
    output wire [22:0] row_o,
    // a row is written; view: its step as the bus shall see it
    input  wire        row_write_i,
    input  wire [ 6:0] row_task_i,
    input  wire [22:0] row_i,
    input  wire [10:0] row_view_i,
    // to the ready vector
    output wire        ready_valid_o,
    output wire [ 6:0] ready_task_o,
    output wire        ready_o,
    // blocks that are free
    output wire        free_valid_o,
    output wire [ 4:0] free_block_o,
    output wire        late_o,
    // load: first steps
    input  wire        load_write_i,
    input  wire [ 6:0] load_addr_i,
    input  wire [15:0] load_data_i,
    // bus
    input  wire        sel_register_i,
    input  wire [ 7:0] addr_i,
    input  wire        read_i,
    input  wire        write_i,
    input  wire [15:0] wdata_i,
    output wire [15:0] rdata_o
);

  localparam [6:0] LAST = `RUNG_FLOW_TASKS - 1;
  localparam [1:0] PHASE_PAUSE = 2'd3;

  // ---- bus registers ------------------------------------------------------------------------------
  reg [6:0] view_q;
  reg bus_valid_q;
  reg bus_go_q;
  reg [6:0] bus_task_q;
  wire register_write = sel_register_i && write_i;
  wire bus_taken;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      view_q <= 7'd0;
      bus_valid_q <= 1'b0;
    end else begin
      if (register_write && addr_i == `RUNG_REG_FLOW_TASK) begin
        view_q <= wdata_i[15:0] > {9'd0, LAST} ? LAST : wdata_i[6:0];
      end
      if (register_write && addr_i == `RUNG_REG_FLOW_TASK_CONTINUE) bus_valid_q <= 1'b1;
      else if (bus_taken || first_i) bus_valid_q <= 1'b0;
    end
    if (register_write && addr_i == `RUNG_REG_FLOW_TASK_CONTINUE) begin
      bus_go_q   <= wdata_i[0];
      bus_task_q <= view_q;
    end
  end

  // ---- the walk ----------------------------------------------------------------------------------
  reg walking_q;
  reg [6:0] walk_q;
  // What the bus asks for waits until the walk is over, which would undo it; a walk that begins drops it.
  wire bus_asks = bus_valid_q && !walking_q;
  wire walk = walking_q && !engine_valid_i && !come_valid_i;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      walking_q <= 1'b0;
    end else if (first_i) begin
      walking_q <= 1'b1;
      walk_q <= 7'd0;
    end else if (walk) begin
      walking_q <= walk_q != LAST;
      walk_q <= walk_q + 7'd1;
    end
  end

  // ---- the operation: given ------------------------------------------------------------------------
  reg look_valid_q;
  reg [3:0] look_op_q;
  reg [6:0] look_task_q;
  reg [4:0] look_block_q;
  reg look_free_q;
  reg op_valid_q;
  reg [3:0] op_q;
  reg [6:0] task_q;
  reg [4:0] block_q;
  reg free_q;
  wire op_given = engine_valid_i || come_valid_i || bus_valid_q || walking_q;
  wire [6:0] op_task = engine_valid_i ? engine_task_i : come_valid_i ? come_task_i :
      bus_asks ? bus_task_q : walk_q;

  assign come_ready_o = !engine_valid_i;
  assign bus_taken = bus_asks && !engine_valid_i && !come_valid_i;

  always @(posedge clk_i) begin
    look_valid_q <= rst_ni && op_given;
    look_op_q <= engine_valid_i ? engine_op_i : come_valid_i ? `FLOW_OP_COME :
        bus_asks ? (bus_go_q ? `FLOW_OP_GO : `FLOW_OP_ASK) : `FLOW_OP_INIT;
    look_task_q <= op_task;
    look_block_q <= engine_valid_i ? engine_block_i : come_block_i;
    look_free_q <= engine_valid_i && engine_free_i;
    op_valid_q <= rst_ni && look_valid_q;
    {op_q, task_q, block_q, free_q} <= {look_op_q, look_task_q, look_block_q, look_free_q};
  end

  assign walking_o = walking_q || first_i || (look_valid_q && look_op_q == `FLOW_OP_INIT) ||
      (op_valid_q && op_q == `FLOW_OP_INIT);

  // ---- flags: the memory gives what they were before the last two operations -----------------------------
  wire [9:0] flags_read;
  wire [15:0] first_read;
  reg [9:0] flags_q;
  reg [15:0] first_q;
  reg again_q;  // the task that was being written when it was read
  reg [9:0] written_q;
  wire [9:0] flags = flags_q;
  wire [15:0] first = first_q;
  wire started = flags[0];
  wire waits = flags[1];
  wire paused = flags[2];
  wire has = flags[5];
  wire [3:0] block = flags[9:6];

  reg [9:0] flags_next;
  reg write_flags;
  reg set_ready;
  reg next_ready;
  reg init_row;
  reg free;
  reg free_own;  // the block that the flags name
  reg late;

  always @* begin
    flags_next = flags;
    write_flags = op_valid_q;
    {set_ready, next_ready, init_row, free_own, late} = 5'd0;
    free = free_q;
    case (op_q)
      `FLOW_OP_START: begin
        write_flags = op_valid_q && !started;
        flags_next = 10'd1;
        {set_ready, next_ready} = {!started, 1'b1};
        init_row = !started;
      end
      `FLOW_OP_STOP: begin
        flags_next = 10'd0;
        set_ready  = 1'b1;
        free_own   = has && !waits;
      end
      `FLOW_OP_TAKE: {flags_next[5:4], flags_next[3]} = {2'd0, flags[3]};
      `FLOW_OP_END: begin
        flags_next = 10'd0;
        set_ready  = 1'b1;
      end
      `FLOW_OP_WAIT: begin
        flags_next = {block_q[3:0], 1'b1, 1'b0, flags[3:2], 1'b1, flags[0]};
        set_ready  = 1'b1;
      end
      `FLOW_OP_PAUSE: begin
        flags_next[3:2] = 2'b01;
        set_ready = 1'b1;
      end
      `FLOW_OP_COME: begin
        if (waits && has && block == block_q[3:0]) begin
          flags_next[1] = 1'b0;
          {set_ready, next_ready} = 2'b11;
        end else begin
          free = 1'b1;
          late = 1'b1;
        end
      end
      `FLOW_OP_INIT: begin
        flags_next = {9'd0, first[15]};
        {set_ready, next_ready} = {1'b1, first[15]};
        init_row = 1'b1;
        free_own = has && !waits;
      end
      `FLOW_OP_GO: begin
        flags_next[4:2] = {paused, 1'b0, 1'b0};
        {set_ready, next_ready} = {paused, 1'b1};
      end
      `FLOW_OP_ASK: flags_next[3] = started && !paused;
      default: write_flags = 1'b0;  // PEEK, FREE
    endcase
  end

  always @(posedge clk_i) begin
    again_q   <= write_flags && op_task == task_q;
    written_q <= flags_next;
    if (write_flags && look_task_q == task_q) flags_q <= flags_next;
    else flags_q <= again_q ? written_q : flags_read;
    first_q <= first_read;
  end

  bank_ram #(
      .WIDTH(10),
      .DEPTH(128),
      .ADDR_BITS(7)
  ) flag_memory (
      .clk_i       (clk_i),
      .read_i      (op_given),
      .read_addr_i (op_task),
      .read_data_o (flags_read),
      .write_i     (write_flags),
      .write_addr_i(task_q),
      .write_data_i(flags_next)
  );

  bank_ram #(
      .WIDTH(16),
      .DEPTH(128),
      .ADDR_BITS(7),
      .CLEARED(0)
  ) first_steps (
      .clk_i       (clk_i),
      .read_i      (op_given),
      .read_addr_i (op_task),
      .read_data_o (first_read),
      .write_i     (load_write_i),
      .write_addr_i(load_addr_i),
      .write_data_i(load_data_i)
  );

  assign ready_valid_o = op_valid_q && set_ready;
  assign ready_task_o  = task_q;
  assign ready_o       = next_ready;

  reg free_valid_q;
  reg [4:0] free_block_q;
  reg late_q;
  always @(posedge clk_i) begin
    free_valid_q <= rst_ni && op_valid_q && (free || free_own);
    free_block_q <= free_own ? {1'b0, block} : block_q;
    late_q <= rst_ni && op_valid_q && late;
  end
  assign free_valid_o = free_valid_q;
  assign free_block_o = free_block_q;
  assign late_o = late_q;

  reg [8:0] peek_q;
  always @(posedge clk_i) if (op_valid_q && op_q == `FLOW_OP_PEEK) peek_q <= flags[9:1];
  assign peek_waits_o = peek_q[0];
  assign peek_ask_o = peek_q[2];
  assign peek_skip_o = peek_q[3];
  assign peek_has_o = peek_q[4];
  assign peek_block_o = {1'b0, peek_q[8:5]};
  wire unused_peek = &{1'b0, peek_q[1]};

  // ---- rows ----------------------------------------------------------------------------------------
  wire row_init = op_valid_q && init_row;
  wire row_write = row_init || row_write_i;
  wire [6:0] row_task = row_init ? task_q : row_task_i;
  wire [22:0] row_data = row_init ? {12'd0, first[10:0]} : row_i;

  bank_ram #(
      .WIDTH(23),
      .DEPTH(128),
      .ADDR_BITS(7),
      .CLEARED(0)
  ) rows (
      .clk_i       (clk_i),
      .read_i      (engine_valid_i && engine_op_i == `FLOW_OP_PEEK),
      .read_addr_i (op_task),
      .read_data_o (row_o),
      .write_i     (row_write),
      .write_addr_i(row_task),
      .write_data_i(row_data)
  );

  // ---- what the bus sees: copies of both ---------------------------------------------------------
  wire [2:0] view_flags;
  wire [12:0] view_row;

  bank_ram #(
      .WIDTH(3),
      .DEPTH(128),
      .ADDR_BITS(7)
  ) flags_seen (
      .clk_i       (clk_i),
      .read_i      (!(write_flags && task_q == view_q)),
      .read_addr_i (view_q),
      .read_data_o (view_flags),
      .write_i     (write_flags),
      .write_addr_i(task_q),
      .write_data_i(flags_next[2:0])
  );

  bank_ram #(
      .WIDTH(13),
      .DEPTH(128),
      .ADDR_BITS(7),
      .CLEARED(0)
  ) rows_seen (
      .clk_i       (clk_i),
      .read_i      (!(row_write && row_task == view_q)),
      .read_addr_i (view_q),
      .read_data_o (view_row),
      .write_i     (row_write),
      .write_addr_i(row_task),
      .write_data_i(row_init ? {2'd0, first[10:0]} : {row_i[12:11], row_view_i})
  );

  reg [15:0] rdata_q;
  wire [1:0] view_phase = view_flags[2] ? PHASE_PAUSE : view_row[12:11] & {2{view_flags[0]}};
  always @(posedge clk_i) begin
    rdata_q <= 16'd0;
    if (sel_register_i && read_i) begin
      case (addr_i)
        `RUNG_REG_FLOW_TASK: rdata_q <= {9'd0, view_q};
        `RUNG_REG_FLOW_TASK_STATE: rdata_q <= {12'd0, view_flags[1:0], view_phase};
        `RUNG_REG_FLOW_TASK_STEP: rdata_q <= {5'd0, view_row[10:0]};
        default: ;
      endcase
    end
  end
  assign rdata_o = rdata_q;

  wire unused_first = &{1'b0, first[14:11]};

endmodule

`default_nettype wire

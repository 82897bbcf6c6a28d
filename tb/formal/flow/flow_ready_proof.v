// SPDX-License-Identifier: Apache-2.0
// The next task (hdl/flow/flow_ready.v), of 20 here instead of 100: a task that is ready from a round's beginning to its turn has its
// turn in this round, and none has two. The turns of a round are in the order of the tasks' numbers, beginning behind the one
// that began the last round with a turn; so no task waits for more than 99 turns, whatever the others do.
// Any task: what is shown of it is shown of all. The engine is free to take its time; ready bits may be set in every clock, and
// taken away at least three clocks before the engine looks for the next task.
`default_nettype none
`include "rung_flow.vh"
// Two groups of 8 and a part of one, as 100 are twelve and a part.
`undef RUNG_FLOW_TASKS
`define RUNG_FLOW_TASKS 20

module flow_ready_proof (
    input wire       clk_i,
    input wire       rst_ni,
    input wire       op_valid_i,
    input wire [6:0] op_task_i,
    input wire       op_ready_i,
    input wire       act_i
);

  localparam [6:0] TASKS = `RUNG_FLOW_TASKS;

  wire begins, goes_around, picks;
  wire found, around;
  wire [6:0] next;
  flow_ready ready (
      .clk_i     (clk_i),
      .rst_ni    (rst_ni),
      .op_valid_i(op_valid_i),
      .op_task_i (op_task_i),
      .op_ready_i(op_ready_i),
      .begin_i   (begins),
      .around_i  (goes_around),
      .pick_i    (picks),
      .found_o   (found),
      .around_o  (around),
      .next_o    (next)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* assume (rst_ni == begun_q);

  // ---- the engine: it looks three clocks after what it has done, or later ------------------------------
  reg round_q;
  reg [1:0] wait_q;
  reg turn_q;  // a task has its turn
  wire looks = round_q && wait_q == 2'd0 && act_i && begun_q;
  assign begins = begun_q && !round_q && act_i;
  assign picks = looks && found;
  assign goes_around = looks && !found && !around;
  wire ends = looks && !found && around;
  wire unready = op_valid_i && !op_ready_i;

  always @(posedge clk_i) begin
    if (!begun_q) begin
      round_q <= 1'b0;
      wait_q  <= 2'd0;
      turn_q  <= 1'b0;
    end else begin
      if (begins) round_q <= 1'b1;
      else if (ends) round_q <= 1'b0;
      if (begins || picks || goes_around || unready) wait_q <= 2'd2;
      else if (wait_q != 2'd0) wait_q <= wait_q - 2'd1;
      if (picks) turn_q <= 1'b1;
      else if (looks) turn_q <= 1'b0;
    end
  end
  always @* begin
    assume (!op_valid_i || op_task_i < TASKS);
  end

  // ---- any task ------------------------------------------------------------------------------------------
  (* anyconst *) wire [6:0] watched;
  always @* assume (watched < TASKS);
  reg ready_q;  // it is ready
  reg steady_q;  // it has been since the round began
  reg had_q;  // it has had its turn in this round
  reg [6:0] last_q;  // the last one that had a turn, in this round or before it
  reg [6:0] first_q;  // the one behind which this round began
  reg began_q;  // this round has had a turn
  reg [6:0] began_by_q;  // the first of the last round that had one

  always @(posedge clk_i) begin
    if (!begun_q) ready_q <= 1'b0;
    else if (op_valid_i && op_task_i == watched) ready_q <= op_ready_i;

    if (begins) begin
      steady_q <= ready_q && !(unready && op_task_i == watched);
      had_q <= 1'b0;
      began_q <= 1'b0;
      first_q <= began_by_q;
    end else begin
      if (!ready_q || (unready && op_task_i == watched)) steady_q <= 1'b0;
      if (picks && next == watched) had_q <= 1'b1;
      if (picks) began_q <= 1'b1;
    end
    if (picks) last_q <= next;
    else if (begins) last_q <= began_by_q;
    if (!begun_q) began_by_q <= TASKS - 7'd1;
    else if (picks && !began_q) began_by_q <= next;
  end

  reg ended_q;  // a turn ended in the clock before, this task's
  reg [6:0] ended_task_q;
  always @(posedge clk_i) begin
    ended_q <= begun_q && looks && turn_q;
    ended_task_q <= last_q;
  end
  always @* begin
    // Only a turn, or what goes on between rounds, takes a ready bit away; that of its own task may come in the clock
    // that looks for the next one, or the one behind it (flow_step).
    if (unready && round_q) begin
      assume ((turn_q && !looks) || (turn_q && looks && op_task_i == last_q) ||
              (ended_q && op_task_i == ended_task_q));
    end
  end

  // How far behind the round's beginning a task stands.
  function automatic [6:0] place(input reg [6:0] number, input reg [6:0] first);
    place = number > first ? number - first - 7'd1 : number + (TASKS - 7'd1) - first;
  endfunction

  always @* begin
    if (begun_q) begin
      if (picks) assert (next < TASKS);
      if (picks) assert (!began_q || place(next, first_q) > place(last_q, first_q));
      if (picks && next == watched) assert (!had_q);
      if (ends && steady_q) assert (had_q);
      // It is not passed over.
      if (picks && steady_q && !had_q) begin
        assert (place(next, first_q) <= place(watched, first_q));
      end
    end
  end

  // ---- for the induction -----------------------------------------------------------------------------------
  (* hierconn *) wire [23:0] \ready.ready_q ;
  (* hierconn *) wire [6:0] \ready.began_q ;
  (* hierconn *) wire [6:0] \ready.limit_q ;
  (* hierconn *) wire \ready.begun_q ;
  (* hierconn *) wire \ready.around_q ;
  (* hierconn *) wire [2:0] \ready.above_group_q ;
  (* hierconn *) wire [2:0] \ready.mark_group_q ;
  (* hierconn *) wire [7:0] \ready.above_bit_q ;
  reg all_q;  // around, and no turn since
  wire [15:0] above = 16'hfffe << last_q[6:3];
  wire [15:0] mark = 16'd1 << last_q[6:3];
  wire [7:0] bits = 8'hfe << last_q[2:0];
  always @(posedge clk_i) begin
    if (begins || picks) all_q <= 1'b0;
    else if (goes_around) all_q <= 1'b1;
  end
  integer t;
  always @* begin
    if (begun_q) begin
      assert (\ready.ready_q [23:20] == 4'd0);
      for (t = 0; t < 20; t = t + 1) begin
        if (t[6:0] == watched) assert (\ready.ready_q [t] == ready_q);
      end
      assert (began_by_q < TASKS && \ready.began_q == began_by_q);
      if (round_q) begin
        assert (last_q < TASKS && first_q < TASKS);
        assert (\ready.limit_q == first_q);
        assert (\ready.begun_q == began_q && \ready.around_q == around);
        if (!began_q) assert (last_q == first_q && began_by_q == first_q);
        if (!began_q) assert (!had_q);
        if (all_q) assert (around);
        if (all_q)
          assert (\ready.above_group_q == 3'h7);
          else begin
            assert (\ready.above_group_q == above[2:0]);
            assert (\ready.mark_group_q == mark[2:0]);
            assert (\ready.above_bit_q == bits);
          end
        // What has been passed: in the first pass above the beginning, in the second up to it.
        if (!around) assert (last_q >= first_q && (!began_q || last_q > first_q));
        if (around && !all_q) assert (last_q <= first_q && began_q);
        if (all_q && began_q) assert (last_q > first_q);
        if (steady_q) assert (ready_q);
        if (steady_q && !had_q) begin
          assert (!began_q || place(last_q, first_q) < place(watched, first_q));
          if (around) assert (watched <= first_q);
        end
        if (had_q) assert (place(last_q, first_q) >= place(watched, first_q));
      end
    end
  end

  always @* begin
    cover (begun_q && ends && steady_q && first_q == 7'd11 && watched == 7'd3);
  end

endmodule

`default_nettype wire

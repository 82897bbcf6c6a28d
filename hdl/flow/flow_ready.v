// SPDX-License-Identifier: Apache-2.0
// Which tasks are ready, and the next one to have its turn: one of 100, in one clock. A round begins with the task
// behind the one that began the round before, and goes once around; a task has its turn when next_o is picked,
// and none again in this round. A ready bit that changes in a clock (op_valid_i), begin_i and pick_i
// show in found_o and next_o two clocks later.
`default_nettype none
`include "rung_flow.vh"

module flow_ready (
    input  wire       clk_i,
    input  wire       rst_ni,
    // ready vector
    input  wire       op_valid_i,
    input  wire [6:0] op_task_i,
    input  wire       op_ready_i,
    // turns
    input  wire       begin_i,
    input  wire       pick_i,
    output wire       found_o,
    output wire [6:0] next_o
);

  localparam TASKS = `RUNG_FLOW_TASKS;
  localparam [6:0] LAST = TASKS - 1;

  // ---- the bits above a task's, and the task's -------------------------------------------------------
  reg found_q;
  reg [6:0] next_q;
  reg [6:0] began_q;  // the task that began the last round
  reg begun_q;  // no turn yet in this one
  wire [6:0] edge_task = begin_i ? began_q : next_q;
  wire [15:0] edge_group = 16'd1 << edge_task[6:3];
  wire [15:0] above_group = 16'hfffe << edge_task[6:3];
  wire [7:0] above_bit = 8'hfe << edge_task[2:0];
  wire [15:0] op_group = 16'd1 << op_task_i[6:3];
  wire [7:0] op_bit = 8'd1 << op_task_i[2:0];

  // ---- turns: first the tasks from mark on, then from 0 to below limit ------------------------------
  reg [127:0] ready_q;
  reg [127:0] behind_q;  // tasks behind the last one that had its turn
  reg [127:0] limit_q;  // tasks from the round's first one on
  reg around_q;  // the last turn was of one below it
  wire [127:0] upper = ready_q & behind_q & ~(limit_q & {128{around_q}});
  wire [127:0] lower = ready_q & ~limit_q & {128{!around_q}};
  wire [127:0] above;
  wire [127:0] op_at;
  genvar g;
  generate
    for (g = 0; g < 16; g = g + 1) begin : g_group
      assign above[8*g+:8] = {8{above_group[g]}} | ({8{edge_group[g]}} & above_bit);
      assign op_at[8*g+:8] = {8{op_group[g] && op_valid_i}} & op_bit;
    end
  endgenerate

  // The lowest bit of each: group, then bit of the group.
  reg [15:0] upper_any, lower_any;
  reg [3:0] upper_group, lower_group;
  reg [7:0] upper_bits, lower_bits;
  reg [2:0] upper_bit, lower_bit;
  integer i;
  always @* begin
    upper_group = 4'd0;
    lower_group = 4'd0;
    for (i = 15; i >= 0; i = i - 1) begin
      upper_any[i] = |upper[8*i+:8];
      lower_any[i] = |lower[8*i+:8];
      if (upper_any[i]) upper_group = i[3:0];
      if (lower_any[i]) lower_group = i[3:0];
    end
    upper_bits = upper[{upper_group, 3'd0}+:8];
    lower_bits = lower[{lower_group, 3'd0}+:8];
    upper_bit  = 3'd0;
    lower_bit  = 3'd0;
    for (i = 7; i >= 0; i = i - 1) begin
      if (upper_bits[i]) upper_bit = i[2:0];
      if (lower_bits[i]) lower_bit = i[2:0];
    end
  end

  reg from_lower_q;

  always @(posedge clk_i) begin
    found_q <= |upper_any || |lower_any;
    next_q <= |upper_any ? {upper_group, upper_bit} : {lower_group, lower_bit};
    from_lower_q <= !(|upper_any);

    if (!rst_ni) begin
      ready_q <= 128'd0;
      began_q <= LAST;
    end else begin
      // The bits above the last task are never set, and go.
      for (i = 0; i < TASKS; i = i + 1) if (op_at[i]) ready_q[i] <= op_ready_i;
      if (pick_i && begun_q) began_q <= next_q;
    end
    if (begin_i) limit_q <= above;
    if (begin_i || pick_i) behind_q <= above;
    if (begin_i) {begun_q, around_q} <= 2'b10;
    else if (pick_i) {begun_q, around_q} <= {1'b0, around_q || from_lower_q};
  end

  assign found_o = found_q;
  assign next_o  = next_q;

endmodule

`default_nettype wire

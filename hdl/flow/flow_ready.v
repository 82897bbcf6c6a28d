// SPDX-License-Identifier: Apache-2.0
// Which tasks are ready, and the next one to have its turn: one of 100, in one clock. A round goes from the task
// behind the one that began the round before up to the last, and then, when around_i says so, from 0 to that one.
// next_o has its turn with pick_i, and none again in this round. A ready bit that changes
// (op_valid_i), begin_i, pick_i and around_i show in found_o and next_o three clocks later.
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
    input  wire       around_i,
    input  wire       pick_i,
    output wire       found_o,
    output wire       around_o,
    output wire [6:0] next_o
);

  localparam TASKS = `RUNG_FLOW_TASKS;
  localparam GROUPS = (TASKS + 7) / 8;
  localparam [6:0] LAST = TASKS - 1;

  // ---- the course of the round -----------------------------------------------------------------------
  reg any_q;
  reg found_q;
  reg [6:0] next_q;
  reg [6:0] began_q;  // the task that began the last round that had a turn
  reg [6:0] limit_q;  // the last one of this round
  reg begun_q;  // this one has had a turn
  reg around_q;

  always @(posedge clk_i) begin
    if (!rst_ni) began_q <= LAST;
    else if (pick_i && !begun_q) began_q <= next_q;
    if (begin_i) begin
      {begun_q, around_q} <= 2'b00;
      limit_q <= began_q;
    end else begin
      if (pick_i) begun_q <= 1'b1;
      if (around_i) around_q <= 1'b1;
    end
  end

  assign around_o = around_q;
  assign found_o = found_q;
  assign next_o = next_q;

  // ---- tasks that may be next: above a mark, kept as groups of 8 and bits of the group ---------------------
  reg [GROUPS-1:0] above_group_q;
  reg [GROUPS-1:0] mark_group_q;
  reg [7:0] above_bit_q;
  wire [6:0] mark = begin_i ? began_q : next_q;
  wire [15:0] above_group = 16'hfffe << mark[6:3];
  wire [15:0] mark_group = 16'd1 << mark[6:3];

  always @(posedge clk_i) begin
    if (around_i) begin
      above_group_q <= {GROUPS{1'b1}};
    end else if (begin_i || pick_i) begin
      above_group_q <= above_group[GROUPS-1:0];
      mark_group_q  <= mark_group[GROUPS-1:0];
      above_bit_q   <= 8'hfe << mark[2:0];
    end
  end

  // ---- the lowest of them that is ready ----------------------------------------------------------------
  reg [8*GROUPS-1:0] ready_q;
  wire [15:0] op_group = {15'd0, op_valid_i} << op_task_i[6:3];
  wire [7:0] op_bit = 8'd1 << op_task_i[2:0];
  reg [8*GROUPS-1:0] may;
  reg [GROUPS-1:0] any;
  reg [2:0] lowest_of[0:GROUPS-1];
  reg below;  // a group below has one
  reg [3:0] group;
  reg [2:0] lowest;
  integer i, j, k;

  always @* begin
    for (i = 0; i < 8 * GROUPS; i = i + 1) begin
      may[i] = ready_q[i] && (above_group_q[i/8] || (mark_group_q[i/8] && above_bit_q[i%8]));
    end
    // The lowest of each group, and the first group that has one, side by side.
    group  = 4'd0;
    lowest = 3'd0;
    for (i = 0; i < GROUPS; i = i + 1) begin
      any[i] = |may[8*i+:8];
      lowest_of[i] = 3'd0;
      for (k = 7; k >= 0; k = k - 1) if (may[8*i+k]) lowest_of[i] = k[2:0];
    end
    for (i = 0; i < GROUPS; i = i + 1) begin
      below = 1'b0;
      for (k = 0; k < i; k = k + 1) below = below || any[k];
      group  = group | ({4{any[i] && !below}} & i[3:0]);
      lowest = lowest | ({3{any[i] && !below}} & lowest_of[i]);
    end
  end

  always @(posedge clk_i) begin
    any_q   <= |any;
    found_q <= any_q && !(around_q && next_q > limit_q);
    next_q  <= {group, lowest};
    // Bits above the last task stay 0.
    for (j = 0; j < 8 * GROUPS; j = j + 1) begin
      if (!rst_ni || j >= TASKS) ready_q[j] <= 1'b0;
      else if (op_group[j/8] && op_bit[j%8]) ready_q[j] <= op_ready_i;
    end
  end

  wire unused = &{1'b0, above_group[15:GROUPS], mark_group[15:GROUPS], op_group[15:GROUPS]};

endmodule

`default_nettype wire

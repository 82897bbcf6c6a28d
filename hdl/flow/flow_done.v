// SPDX-License-Identifier: Apache-2.0
// Completions of requests, link before panel: keeps the status of each block, and tells whose data have come:
// the task's that the block belongs to (owner_*, written when its request goes out) by an operation
// COME, or the command's, by came_o, bit n for block 16 + n, until clear_i for that block.
`default_nettype none
`include "rung_flow.vh"

module flow_done (
    input  wire       clk_i,
    input  wire       rst_ni,
    input  wire       link_done_valid_i,
    output wire       link_done_ready_o,
    input  wire [4:0] link_done_block_i,
    input  wire [7:0] link_done_status_i,
    input  wire       panel_done_valid_i,
    output wire       panel_done_ready_o,
    input  wire [4:0] panel_done_block_i,
    input  wire [7:0] panel_done_status_i,
    // a request goes out
    input  wire       owner_write_i,
    input  wire [4:0] owner_block_i,
    input  wire [6:0] owner_task_i,
    // tasks
    output wire       come_valid_o,
    input  wire       come_ready_i,
    output wire [6:0] come_task_o,
    output wire [4:0] come_block_o,
    // commands
    output wire [8:0] came_o,
    // status of a block, in the next clock
    input  wire [4:0] status_block_i,
    output wire [7:0] status_o
);

  localparam [4:0] FIRST_EVENT = `RUNG_FLOW_TASK_BLOCKS;

  // ---- one at a time -------------------------------------------------------------------------------
  reg taken_q;
  reg [4:0] block_q;
  reg [7:0] status_q;
  wire of_task = block_q < FIRST_EVENT;
  wire go_on = !of_task || come_ready_i;

  assign link_done_ready_o  = !taken_q;
  assign panel_done_ready_o = !taken_q && !link_done_valid_i;

  always @(posedge clk_i) begin
    if (!taken_q) begin
      block_q  <= link_done_valid_i ? link_done_block_i : panel_done_block_i;
      status_q <= link_done_valid_i ? link_done_status_i : panel_done_status_i;
    end
    if (!rst_ni) taken_q <= 1'b0;
    else if (!taken_q) taken_q <= link_done_valid_i || panel_done_valid_i;
    else taken_q <= !go_on;
  end

  // ---- status and owner of each block --------------------------------------------------------------
  (* ram_style = "distributed" *) reg [7:0] statuses[0:31];
  (* ram_style = "distributed" *) reg [6:0] owners[0:15];

  always @(posedge clk_i) begin
    if (taken_q) statuses[block_q] <= status_q;
    if (owner_write_i && owner_block_i < FIRST_EVENT) owners[owner_block_i[3:0]] <= owner_task_i;
  end

  reg [7:0] status_out_q;
  always @(posedge clk_i) status_out_q <= statuses[status_block_i];
  assign status_o = status_out_q;
  assign come_valid_o = taken_q && of_task;
  assign come_task_o = owners[block_q[3:0]];
  assign come_block_o = block_q;

  reg [8:0] came_q;
  integer i;
  always @(posedge clk_i) begin
    for (i = 0; i < 9; i = i + 1) begin
      if (owner_write_i && owner_block_i == FIRST_EVENT + i[4:0]) came_q[i] <= 1'b0;
      else if (taken_q && block_q == FIRST_EVENT + i[4:0]) came_q[i] <= 1'b1;
    end
    if (!rst_ni) came_q <= 9'd0;
  end
  assign came_o = came_q;

endmodule

`default_nettype wire

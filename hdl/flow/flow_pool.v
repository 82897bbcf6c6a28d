// SPDX-License-Identifier: Apache-2.0
// Temporary storage of transfers: blocks of 32 words in one memory, and which of them are free. Blocks 0 to 15
// are for tasks, 16 to 23 for event commands, 24 for the PC's command, 25 is the engine's own for what it
// carries from device to device within a turn.
// Clients, in this order: engine, whose accesses are always taken, link, panel. An access happens in a clock
// with valid and ready; rdata is there in the clock after a read, and stays until the client's next one.
// Block 24 is also the bus's (registers flow_pc_data): its reads answer in the clock after read_i, else 0;
// its writes count only while pc_waiting_i is 1.
// Free blocks: *_valid_o offers the block of the lowest number, *_take_i takes it; free_valid_i gives a task's
// back, event_free_valid_i an event's.
`default_nettype none
`include "rung_controller.vh"
`include "rung_flow.vh"

module flow_pool (
    input  wire        clk_i,
    input  wire        rst_ni,
    // engine
    input  wire        engine_valid_i,
    input  wire        engine_write_i,
    input  wire [ 9:0] engine_addr_i,
    input  wire [15:0] engine_wdata_i,
    output wire [15:0] engine_rdata_o,
    // link
    input  wire        link_valid_i,
    output wire        link_ready_o,
    input  wire        link_write_i,
    input  wire [ 9:0] link_addr_i,
    input  wire [15:0] link_wdata_i,
    output wire [15:0] link_rdata_o,
    // panel
    input  wire        panel_valid_i,
    output wire        panel_ready_o,
    input  wire        panel_write_i,
    input  wire [ 9:0] panel_addr_i,
    input  wire [15:0] panel_wdata_i,
    output wire [15:0] panel_rdata_o,
    // free blocks
    output wire        task_valid_o,
    output wire [ 4:0] task_block_o,
    input  wire        task_take_i,
    input  wire        free_valid_i,
    input  wire [ 4:0] free_block_i,
    output wire        event_valid_o,
    output wire [ 4:0] event_block_o,
    input  wire        event_take_i,
    input  wire        event_free_valid_i,
    input  wire [ 4:0] event_free_block_i,
    // bus
    input  wire        pc_waiting_i,
    input  wire        sel_register_i,
    input  wire [ 7:0] addr_i,
    input  wire        read_i,
    input  wire        write_i,
    input  wire [15:0] wdata_i,
    output wire [15:0] rdata_o
);

  localparam [4:0] PC_BLOCK = `RUNG_FLOW_PC_BLOCK;
  localparam [4:0] FIRST_EVENT = `RUNG_FLOW_TASK_BLOCKS;
  localparam [7:0] PC_DATA = `RUNG_REG_FLOW_PC_DATA;

  // ---- whose turn it is ------------------------------------------------------------------------
  assign link_ready_o  = !engine_valid_i;
  assign panel_ready_o = !engine_valid_i && !link_valid_i;
  wire link = link_valid_i && link_ready_o;
  wire panel = panel_valid_i && panel_ready_o;
  wire access = engine_valid_i || link || panel;
  wire write = engine_valid_i ? engine_write_i : link ? link_write_i : panel_write_i;
  wire [9:0] addr = engine_valid_i ? engine_addr_i : link ? link_addr_i : panel_addr_i;
  wire [15:0] wdata = engine_valid_i ? engine_wdata_i : link ? link_wdata_i : panel_wdata_i;
  wire in_pc = addr[9:5] == PC_BLOCK;
  wire do_read = access && !write;
  wire do_write = access && write;

  // ---- the blocks; the PC's in memories of its own, one that the clients read and one for the bus ----------
  wire [15:0] block_data;
  wire [15:0] pc_data;
  wire [15:0] bus_data;
  wire bus = sel_register_i && addr_i[7:5] == PC_DATA[7:5];
  wire bus_write = bus && write_i && pc_waiting_i;
  wire pc_write = bus_write || (do_write && in_pc);
  wire [4:0] pc_addr = bus_write ? addr_i[4:0] : addr[4:0];
  wire [15:0] pc_wdata = bus_write ? wdata_i : wdata;

  bank_ram #(
      .WIDTH(16),
      .DEPTH(1024),
      .ADDR_BITS(10),
      .CLEARED(0)
  ) blocks (
      .clk_i       (clk_i),
      .read_i      (do_read),
      .read_addr_i (addr),
      .read_data_o (block_data),
      .write_i     (do_write && !in_pc),
      .write_addr_i(addr),
      .write_data_i(wdata)
  );

  bank_ram #(
      .WIDTH(16),
      .DEPTH(32),
      .ADDR_BITS(5),
      .CLEARED(0)
  ) pc_block (
      .clk_i       (clk_i),
      .read_i      (do_read),
      .read_addr_i (addr[4:0]),
      .read_data_o (pc_data),
      .write_i     (pc_write),
      .write_addr_i(pc_addr),
      .write_data_i(pc_wdata)
  );

  bank_ram #(
      .WIDTH(16),
      .DEPTH(32),
      .ADDR_BITS(5),
      .CLEARED(0)
  ) bus_block (
      .clk_i       (clk_i),
      .read_i      (bus && read_i),
      .read_addr_i (addr_i[4:0]),
      .read_data_o (bus_data),
      .write_i     (pc_write),
      .write_addr_i(pc_addr),
      .write_data_i(pc_wdata)
  );

  // ---- answers -----------------------------------------------------------------------------------
  reg from_pc_q;
  reg bus_read_q;
  reg [2:0] fresh_q;  // read in the clock before: engine, link, panel
  reg [15:0] engine_q, link_q, panel_q;
  wire [15:0] data = from_pc_q ? pc_data : block_data;

  always @(posedge clk_i) begin
    bus_read_q <= bus && read_i;
    fresh_q <= {engine_valid_i && !engine_write_i, link && !link_write_i, panel && !panel_write_i};
    if (do_read) from_pc_q <= in_pc;
    if (fresh_q[2]) engine_q <= data;
    if (fresh_q[1]) link_q <= data;
    if (fresh_q[0]) panel_q <= data;
  end

  assign engine_rdata_o = fresh_q[2] ? data : engine_q;
  assign link_rdata_o = fresh_q[1] ? data : link_q;
  assign panel_rdata_o = fresh_q[0] ? data : panel_q;
  assign rdata_o = bus_data & {16{bus_read_q}};

  // ---- free blocks -------------------------------------------------------------------------------
  reg [15:0] task_free_q;
  reg [7:0] event_free_q;
  reg [3:0] task_lowest;
  reg [2:0] event_lowest;
  integer i;

  always @* begin
    task_lowest = 4'd0;
    event_lowest = 3'd0;
    for (i = 15; i >= 0; i = i - 1) if (task_free_q[i]) task_lowest = i[3:0];
    for (i = 7; i >= 0; i = i - 1) if (event_free_q[i]) event_lowest = i[2:0];
  end

  assign task_valid_o  = |task_free_q;
  assign task_block_o  = {1'b0, task_lowest};
  assign event_valid_o = |event_free_q;
  assign event_block_o = FIRST_EVENT + {2'b0, event_lowest};

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      task_free_q  <= 16'hffff;
      event_free_q <= 8'hff;
    end else begin
      if (task_take_i) task_free_q[task_lowest] <= 1'b0;
      if (free_valid_i && free_block_i < FIRST_EVENT) task_free_q[free_block_i[3:0]] <= 1'b1;
      if (event_take_i) event_free_q[event_lowest] <= 1'b0;
      if (event_free_valid_i) event_free_q[event_free_block_i[2:0]] <= 1'b1;
    end
  end

  wire unused = &{1'b0, event_free_block_i[4:3]};

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// What a program of flow tasks loads (spaces flow_steps, flow_transfers and flow_setup of hdl/isa/flow.toml; first
// steps: flow_tasks.v): steps, transfers, setup registers and boards, and a breakpoint for each step. A row is there
// in the clock after its read, and stays until the next one. Loading word 0 of a step takes its
// breakpoint away. Tables are to be loaded while no round runs; breakpoints (registers flow_break_*) change at any
// time. Reset makes the setup registers 0, and leaves memories and boards alone: who loads a program loads all boards.
`default_nettype none
`include "rung_controller.vh"
`include "rung_flow.vh"

module flow_tables (
    input  wire        clk_i,
    input  wire        rst_ni,
    // a step
    input  wire        step_read_i,
    input  wire [10:0] step_i,
    output wire [15:0] step_entry_o,
    output wire [15:0] step_end_o,
    output wire [ 7:0] step_before_o,
    output wire [ 7:0] step_after_o,
    output wire        step_break_o,
    // a transfer
    input  wire        transfer_read_i,
    input  wire [ 7:0] transfer_i,
    output wire [15:0] transfer_resource_o,
    output wire [15:0] transfer_first_o,
    output wire [15:0] transfer_count_o,
    output wire [15:0] transfer_head_o,
    // setup
    output wire [ 1:0] enable_o,
    output wire [ 3:0] unit_o,
    output wire [15:0] next_word_o,
    output wire [15:0] task_word_o,
    output wire [15:0] status_word_o,
    output wire [15:0] link_timeout_o,
    output wire [15:0] panel_timeout_o,
    output wire [ 7:0] panel_unit_o,
    output wire [19:0] panel_baud_o,
    output wire [ 1:0] panel_parity_o,
    input  wire [ 3:0] board_i,
    output wire [ 3:0] board_o,              // its attributes, in the same clock
    // load
    input  wire        steps_write_i,
    input  wire        transfers_write_i,
    input  wire        setup_write_i,
    input  wire [15:0] load_addr_i,
    input  wire [15:0] load_data_i,
    // bus
    input  wire        sel_register_i,
    input  wire [ 7:0] addr_i,
    input  wire        read_i,
    input  wire        write_i,
    input  wire [15:0] wdata_i,
    output wire [15:0] rdata_o
);

  localparam STEPS = `RUNG_FLOW_STEPS;
  localparam TRANSFERS = `RUNG_FLOW_TRANSFERS;
  localparam [11:0] FIRST_BOARD = 12'd4;  // address 64 and up, 16 at a time

  // ---- steps and transfers: a memory a word, as wide as that word needs ----------------------------
  wire loads_step = steps_write_i && load_addr_i[15:13] == 3'd0;
  wire loads_transfer = transfers_write_i && load_addr_i[15:10] == 6'd0;
  wire [47:0] step_row;
  wire [63:0] transfer_row;
  genvar k;
  generate
    for (k = 0; k < 4; k = k + 1) begin : g_step
      localparam WIDTH = k < 2 ? 16 : 8;
      localparam AT = k < 3 ? 16 * k : 40;
      bank_ram #(
          .WIDTH(WIDTH),
          .DEPTH(STEPS),
          .ADDR_BITS(11),
          .CLEARED(0)
      ) memory (
          .clk_i       (clk_i),
          .read_i      (step_read_i),
          .read_addr_i (step_i),
          .read_data_o (step_row[AT+:WIDTH]),
          .write_i     (loads_step && load_addr_i[1:0] == k[1:0]),
          .write_addr_i(load_addr_i[12:2]),
          .write_data_i(load_data_i[WIDTH-1:0])
      );
    end
    for (k = 0; k < 4; k = k + 1) begin : g_transfer
      bank_ram #(
          .WIDTH(16),
          .DEPTH(TRANSFERS),
          .ADDR_BITS(8),
          .CLEARED(0)
      ) memory (
          .clk_i       (clk_i),
          .read_i      (transfer_read_i),
          .read_addr_i (transfer_i),
          .read_data_o (transfer_row[16*k+:16]),
          .write_i     (loads_transfer && load_addr_i[1:0] == k[1:0]),
          .write_addr_i(load_addr_i[9:2]),
          .write_data_i(load_data_i)
      );
    end
  endgenerate
  assign {step_after_o, step_before_o, step_end_o, step_entry_o} = step_row;
  assign {transfer_head_o, transfer_count_o, transfer_first_o, transfer_resource_o} = transfer_row;

  // ---- breakpoints: written when no step is read ------------------------------------------------------
  reg [10:0] break_step_q;
  reg break_valid_q;
  reg break_q;
  reg [10:0] break_addr_q;
  wire register_write = sel_register_i && write_i;
  wire break_write = break_valid_q && !step_read_i;

  always @(posedge clk_i) begin
    if (register_write && addr_i == `RUNG_REG_FLOW_BREAK_STEP) break_step_q <= wdata_i[10:0];
    if (!rst_ni) begin
      break_valid_q <= 1'b0;
    end else if (loads_step && load_addr_i[1:0] == 2'd0) begin
      break_valid_q <= 1'b1;
      break_q <= 1'b0;
      break_addr_q <= load_addr_i[12:2];
    end else if (register_write && addr_i == `RUNG_REG_FLOW_BREAK) begin
      break_valid_q <= 1'b1;
      break_q <= wdata_i[0];
      break_addr_q <= break_step_q;
    end else if (break_write) begin
      break_valid_q <= 1'b0;
    end
  end

  bank_ram #(
      .WIDTH(1),
      .DEPTH(STEPS),
      .ADDR_BITS(11)
  ) breakpoints (
      .clk_i       (clk_i),
      .read_i      (step_read_i),
      .read_addr_i (step_i),
      .read_data_o (step_break_o),
      .write_i     (break_write),
      .write_addr_i(break_addr_q),
      .write_data_i(break_q)
  );

  reg [15:0] rdata_q;
  always @(posedge clk_i) begin
    rdata_q <= 16'd0;
    if (sel_register_i && read_i && addr_i == `RUNG_REG_FLOW_BREAK_STEP) begin
      rdata_q <= {5'd0, break_step_q};
    end
  end
  assign rdata_o = rdata_q;

  // ---- setup -------------------------------------------------------------------------------------
  reg [1:0] enable_q;
  reg [3:0] unit_q;
  reg [15:0] next_word_q, task_word_q, status_word_q, link_timeout_q, panel_timeout_q;
  reg [7:0] panel_unit_q;
  reg [19:0] panel_baud_q;
  reg [1:0] panel_parity_q;
  (* ram_style = "distributed" *) reg [3:0] boards[0:15];

  wire loads_board = setup_write_i && load_addr_i[15:4] == FIRST_BOARD;
  always @(posedge clk_i) if (loads_board) boards[load_addr_i[3:0]] <= load_data_i[3:0];
  assign board_o = boards[board_i];

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      enable_q <= 2'd0;
      unit_q <= 4'd0;
      {next_word_q, task_word_q, status_word_q} <= 48'd0;
      {link_timeout_q, panel_timeout_q, panel_unit_q} <= 40'd0;
      {panel_baud_q, panel_parity_q} <= 22'd0;
    end else if (setup_write_i) begin
      case (load_addr_i)
        `RUNG_FLOW_SETUP_ENABLE: enable_q <= load_data_i[1:0];
        `RUNG_FLOW_SETUP_UNIT: unit_q <= load_data_i[3:0];
        `RUNG_FLOW_SETUP_NEXT_WORD: next_word_q <= load_data_i;
        `RUNG_FLOW_SETUP_TASK_WORD: task_word_q <= load_data_i;
        `RUNG_FLOW_SETUP_STATUS_WORD: status_word_q <= load_data_i;
        `RUNG_FLOW_SETUP_LINK_TIMEOUT: link_timeout_q <= load_data_i;
        `RUNG_FLOW_SETUP_PANEL_TIMEOUT: panel_timeout_q <= load_data_i;
        `RUNG_FLOW_SETUP_PANEL_UNIT: panel_unit_q <= load_data_i[7:0];
        `RUNG_FLOW_SETUP_PANEL_BAUD_LOW: panel_baud_q[15:0] <= load_data_i;
        `RUNG_FLOW_SETUP_PANEL_BAUD_HIGH: panel_baud_q[19:16] <= load_data_i[3:0];
        `RUNG_FLOW_SETUP_PANEL_PARITY: panel_parity_q <= load_data_i[1:0];
        default: ;
      endcase
    end
  end

  assign enable_o = enable_q;
  assign unit_o = unit_q;
  assign next_word_o = next_word_q;
  assign task_word_o = task_word_q;
  assign status_word_o = status_word_q;
  assign link_timeout_o = link_timeout_q;
  assign panel_timeout_o = panel_timeout_q;
  assign panel_unit_o = panel_unit_q;
  assign panel_baud_o = panel_baud_q;
  assign panel_parity_o = panel_parity_q;

  wire unused = &{1'b0, wdata_i[15:11]};

endmodule

`default_nettype wire

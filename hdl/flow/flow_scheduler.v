// SPDX-License-Identifier: Apache-2.0
// Flow tasks on one processor (README.md): a round takes the place of a scan. Stands between scan_controller.v
// (round_i, round_done_o), the ladder's scan (ladder_ports.v: ladder_o, ladder_done_i) and the processor, whose runs
// of routines it starts (start_o, with range_i 1: entry_o, end_o); at the devices' port and at the device map it
// is one more client beside host_exchange.v. Without flows (enable) a round is the ladder's scan, in the same
// clocks. first_i with or before round_i: tasks are as at a program's start. give_up_i: the round ends here.
`default_nettype none
`include "rung_controller.vh"
`include "rung_flow.vh"
`include "flow_ops.vh"

module flow_scheduler #(
    parameter integer WORD_POINTS = 472  // of the device map
) (
    input  wire         clk_i,
    input  wire         rst_ni,
    // round
    input  wire         first_i,
    input  wire         give_up_i,
    input  wire         round_i,
    output wire         round_done_o,
    output wire         ladder_o,
    input  wire         ladder_done_i,
    // processor: a routine, and the words that it writes
    output wire         start_o,
    output wire [ 15:0] entry_o,
    output wire [ 15:0] end_o,
    input  wire         done_i,
    input  wire [  1:0] write_valid_i,
    input  wire [ 31:0] write_addr_i,
    input  wire [ 31:0] write_data_i,
    // device map and devices
    output wire         map_read_o,
    output wire         map_words_o,
    output wire [ 15:0] map_point_o,
    input  wire         map_mapped_i,
    input  wire [ 14:0] map_device_i,
    output wire         host_valid_o,
    output wire         host_write_o,
    output wire         host_words_o,
    output wire [ 14:0] host_addr_o,
    output wire [ 15:0] host_data_o,
    input  wire         host_rvalid_i,
    input  wire [ 15:0] host_rdata_i,
    // pool: engine's accesses, blocks
    output wire         mem_valid_o,
    output wire         mem_write_o,
    output wire [  9:0] mem_addr_o,
    output wire [ 15:0] mem_wdata_o,
    input  wire [ 15:0] mem_rdata_i,
    input  wire         task_block_valid_i,
    input  wire [  4:0] task_block_i,
    output wire         task_block_take_o,
    output wire         task_free_valid_o,
    output wire [  4:0] task_free_block_o,
    input  wire         event_block_valid_i,
    input  wire [  4:0] event_block_i,
    output wire         event_block_take_o,
    output wire         pc_waiting_o,
    // requests: one set of fields for both
    output wire         link_req_valid_o,
    input  wire         link_req_ready_i,
    output wire         panel_req_valid_o,
    input  wire         panel_req_ready_i,
    output wire [  4:0] req_block_o,
    output wire         req_write_o,
    output wire [  7:0] req_unit_o,
    output wire [  7:0] req_board_o,
    output wire [ 15:0] req_first_o,
    output wire [  5:0] req_count_o,
    // completions
    input  wire         link_done_valid_i,
    output wire         link_done_ready_o,
    input  wire [  4:0] link_done_block_i,
    input  wire [  7:0] link_done_status_i,
    input  wire         panel_done_valid_i,
    output wire         panel_done_ready_o,
    input  wire [  4:0] panel_done_block_i,
    input  wire [  7:0] panel_done_status_i,
    // event commands and replies
    input  wire         event_valid_i,
    output wire         event_ready_o,
    input  wire         event_write_i,
    input  wire [  7:0] event_board_i,
    input  wire [ 15:0] event_first_i,
    input  wire [  5:0] event_count_i,
    input  wire [  7:0] event_from_i,
    input  wire [  7:0] event_tag_i,
    output wire         reply_valid_o,
    input  wire         reply_ready_i,
    output wire [  4:0] reply_block_o,
    output wire         reply_write_o,
    output wire [  7:0] reply_status_o,
    output wire [  5:0] reply_count_o,
    output wire [  7:0] reply_to_o,
    output wire [  7:0] reply_tag_o,
    // setup of link and panel, and their counters
    output wire [  3:0] unit_o,
    output wire [ 15:0] link_timeout_o,
    output wire [ 15:0] panel_timeout_o,
    output wire [  7:0] panel_unit_o,
    output wire [ 19:0] panel_baud_o,
    output wire [  1:0] panel_parity_o,
    input  wire [ 15:0] late_i,
    input  wire [127:0] link_counters_i,     // link_upper_bad lowest
    input  wire [ 31:0] panel_counters_i,    // panel_bad lowest
    // load
    input  wire         steps_write_i,
    input  wire         transfers_write_i,
    input  wire         tasks_write_i,
    input  wire         setup_write_i,
    input  wire [ 15:0] load_addr_i,
    input  wire [ 15:0] load_data_i,
    // bus: select, address and data in the clock of read_i or write_i; rdata_o in the clock after read_i, else 0
    input  wire         sel_register_i,
    input  wire [  7:0] addr_i,
    input  wire         read_i,
    input  wire         write_i,
    input  wire [ 15:0] wdata_i,
    output wire [ 15:0] rdata_o
);

  wire [15:0] step_entry;
  wire [15:0] step_end;
  wire [7:0] step_before;
  wire [7:0] step_after;
  wire step_break;
  wire [15:0] transfer_resource;
  wire [15:0] transfer_first;
  wire [15:0] transfer_count;
  wire [15:0] transfer_head;
  wire [1:0] enable;
  wire [15:0] next_word;
  wire [15:0] task_word;
  wire [15:0] status_word;
  wire [3:0] attributes;
  wire [15:0] tables_rdata;
  wire walking;
  wire come_ready;
  wire peek_waits;
  wire peek_ask;
  wire peek_skip;
  wire peek_has;
  wire [4:0] peek_block;
  wire [22:0] row;
  wire ready_valid;
  wire [6:0] ready_task;
  wire ready;
  wire free_valid;
  wire [4:0] free_block;
  wire vanished;
  wire [15:0] tasks_rdata;
  wire found;
  wire around;
  wire [6:0] next;
  wire steps_done;
  wire steps_busy;
  wire pick;
  wire go_around;
  wire step_op_valid;
  wire [3:0] step_op;
  wire [6:0] step_op_task;
  wire [4:0] step_op_block;
  wire step_op_free;
  wire row_write;
  wire [6:0] row_task;
  wire [22:0] row_next;
  wire [10:0] row_view;
  wire step_read;
  wire [10:0] step;
  wire transfer_read;
  wire [7:0] transfer;
  wire step_take;
  wire step_lock;
  wire [3:0] step_lock_board;
  wire step_send;
  wire step_write;
  wire [4:0] step_block;
  wire step_copy_start;
  wire copy_put;
  wire step_copy_to_block;
  wire step_copy_mapped;
  wire [4:0] step_copy_block;
  wire step_copy_head;
  wire [15:0] copy_put_data;
  wire command_take;
  wire pool_full;
  wire step_held;
  wire step_failed;
  wire wrote_next;
  wire [10:0] wrote_step;
  wire wrote_end;
  wire commands_wait;
  wire [7:0] command;
  wire command_known;
  wire command_last;
  wire commands_done;
  wire command_take_route;
  wire [15:0] command_resource;
  wire [15:0] command_first;
  wire [15:0] command_count;
  wire command_lock;
  wire command_free;
  wire command_send;
  wire command_write;
  wire [4:0] command_block;
  wire command_copy_start;
  wire command_held;
  wire command_failed;
  wire executed;
  wire suspended;
  wire [15:0] commands_rdata;
  wire [1:0] way;
  wire gives_up;
  wire exclusive;
  wire held;
  wire [3:0] board;
  wire [15:0] first;
  wire [5:0] count;
  wire sending;
  wire come_valid;
  wire [6:0] come_task;
  wire [4:0] come_block;
  wire [8:0] came;
  wire [7:0] status;
  wire copy_done;
  wire begins;
  wire start_commands;
  wire start_steps;
  wire of_steps;
  wire ladder;
  wire round_done;
  wire [15:0] registers_rdata;
  wire flows = enable[0];
  wire failures = step_failed || command_failed;
  wire holds = step_held || command_held;
  wire [5:0] counted = {vanished, suspended, executed, failures, holds, pool_full};
  wire send = step_send || command_send;
  wire [4:0] block = of_steps ? step_block : command_block;
  // A task's lock is taken in the clock that takes its block, or in the next one.
  wire [4:0] lock_block = !of_steps ? command_block : task_block_take_o ? task_block_i : step_block;

  // ---- tables -----------------------------------------------------------------------------------------

  flow_tables tables (
      .clk_i              (clk_i),
      .rst_ni             (rst_ni),
      .step_read_i        (step_read),
      .step_i             (step),
      .step_entry_o       (step_entry),
      .step_end_o         (step_end),
      .step_before_o      (step_before),
      .step_after_o       (step_after),
      .step_break_o       (step_break),
      .transfer_read_i    (transfer_read),
      .transfer_i         (transfer),
      .transfer_resource_o(transfer_resource),
      .transfer_first_o   (transfer_first),
      .transfer_count_o   (transfer_count),
      .transfer_head_o    (transfer_head),
      .enable_o           (enable),
      .unit_o             (unit_o),
      .next_word_o        (next_word),
      .task_word_o        (task_word),
      .status_word_o      (status_word),
      .link_timeout_o     (link_timeout_o),
      .panel_timeout_o    (panel_timeout_o),
      .panel_unit_o       (panel_unit_o),
      .panel_baud_o       (panel_baud_o),
      .panel_parity_o     (panel_parity_o),
      .board_i            (board),
      .board_o            (attributes),
      .steps_write_i      (steps_write_i),
      .transfers_write_i  (transfers_write_i),
      .setup_write_i      (setup_write_i),
      .load_addr_i        (load_addr_i),
      .load_data_i        (load_data_i),
      .sel_register_i     (sel_register_i),
      .addr_i             (addr_i),
      .read_i             (read_i),
      .write_i            (write_i),
      .wdata_i            (wdata_i),
      .rdata_o            (tables_rdata)
  );

  // ---- tasks and their turns --------------------------------------------------------------------------

  flow_tasks tasks (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .first_i       (first_i),
      .walking_o     (walking),
      .engine_valid_i(step_op_valid || command_free),
      .engine_op_i   (step_op_valid ? step_op : `FLOW_OP_FREE),
      .engine_task_i (step_op_task),
      .engine_block_i(step_op_valid ? step_op_block : command_block),
      .engine_free_i (step_op_valid ? step_op_free : 1'b1),
      .come_valid_i  (come_valid),
      .come_ready_o  (come_ready),
      .come_task_i   (come_task),
      .come_block_i  (come_block),
      .peek_waits_o  (peek_waits),
      .peek_ask_o    (peek_ask),
      .peek_skip_o   (peek_skip),
      .peek_has_o    (peek_has),
      .peek_block_o  (peek_block),
      .row_o         (row),
      .row_write_i   (row_write),
      .row_task_i    (row_task),
      .row_i         (row_next),
      .row_view_i    (row_view),
      .ready_valid_o (ready_valid),
      .ready_task_o  (ready_task),
      .ready_o       (ready),
      .free_valid_o  (free_valid),
      .free_block_o  (free_block),
      .late_o        (vanished),
      .load_write_i  (tasks_write_i && load_addr_i[15:7] == 9'd0),
      .load_addr_i   (load_addr_i[6:0]),
      .load_data_i   (load_data_i),
      .sel_register_i(sel_register_i),
      .addr_i        (addr_i),
      .read_i        (read_i),
      .write_i       (write_i),
      .wdata_i       (wdata_i),
      .rdata_o       (tasks_rdata)
  );

  assign task_free_valid_o = free_valid;
  assign task_free_block_o = free_block;

  flow_ready readiness (
      .clk_i     (clk_i),
      .rst_ni    (rst_ni),
      .op_valid_i(ready_valid),
      .op_task_i (ready_task),
      .op_ready_i(ready),
      .begin_i   (begins),
      .around_i  (go_around),
      .pick_i    (pick),
      .found_o   (found),
      .around_o  (around),
      .next_o    (next)
  );

  flow_step turns (
      .clk_i             (clk_i),
      .rst_ni            (rst_ni),
      .start_i           (start_steps),
      .stop_i            (give_up_i),
      .done_o            (steps_done),
      .busy_o            (steps_busy),
      .in_place_i        (enable[1]),
      .command_held_i    (command_held),
      .found_i           (found),
      .around_i          (around),
      .next_i            (next),
      .pick_o            (pick),
      .around_o          (go_around),
      .op_valid_o        (step_op_valid),
      .op_o              (step_op),
      .op_task_o         (step_op_task),
      .op_block_o        (step_op_block),
      .op_free_o         (step_op_free),
      .peek_waits_i      (peek_waits),
      .peek_ask_i        (peek_ask),
      .peek_skip_i       (peek_skip),
      .peek_has_i        (peek_has),
      .peek_block_i      (peek_block),
      .row_i             (row),
      .row_write_o       (row_write),
      .row_task_o        (row_task),
      .row_o             (row_next),
      .row_view_o        (row_view),
      .step_read_o       (step_read),
      .step_o            (step),
      .step_entry_i      (step_entry),
      .step_end_i        (step_end),
      .step_before_i     (step_before),
      .step_after_i      (step_after),
      .step_break_i      (step_break),
      .transfer_read_o   (transfer_read),
      .transfer_o        (transfer),
      .take_o            (step_take),
      .way_i             (way),
      .gives_up_i        (gives_up),
      .exclusive_i       (exclusive),
      .held_i            (held),
      .board_i           (board),
      .lock_o            (step_lock),
      .lock_board_o      (step_lock_board),
      .send_o            (step_send),
      .write_o           (step_write),
      .block_o           (step_block),
      .sending_i         (sending),
      .status_i          (status),
      .task_block_valid_i(task_block_valid_i),
      .task_block_i      (task_block_i),
      .task_block_take_o (task_block_take_o),
      .copy_start_o      (step_copy_start),
      .copy_put_o        (copy_put),
      .copy_to_block_o   (step_copy_to_block),
      .copy_mapped_o     (step_copy_mapped),
      .copy_block_o      (step_copy_block),
      .copy_head_o       (step_copy_head),
      .copy_put_data_o   (copy_put_data),
      .copy_done_i       (copy_done),
      .start_o           (start_o),
      .entry_o           (entry_o),
      .end_o             (end_o),
      .done_i            (done_i),
      .wrote_next_i      (wrote_next),
      .wrote_step_i      (wrote_step),
      .wrote_end_i       (wrote_end),
      .commands_i        (commands_wait),
      .command_i         (command),
      .command_known_i   (command_known),
      .command_last_i    (command_last),
      .command_take_o    (command_take),
      .full_o            (pool_full),
      .held_o            (step_held),
      .failed_o          (step_failed)
  );

  flow_writes writes (
      .clk_i        (clk_i),
      .rst_ni       (rst_ni),
      .next_word_i  (next_word),
      .task_word_i  (task_word),
      .routine_i    (start_o),
      .write_valid_i(write_valid_i),
      .write_addr_i (write_addr_i),
      .write_data_i (write_data_i),
      .next_o       (wrote_next),
      .step_o       (wrote_step),
      .end_o        (wrote_end),
      .commands_o   (commands_wait),
      .command_o    (command),
      .known_o      (command_known),
      .last_o       (command_last),
      .take_i       (command_take)
  );

  // ---- commands ---------------------------------------------------------------------------------------

  flow_commands commands (
      .clk_i              (clk_i),
      .rst_ni             (rst_ni),
      .start_i            (start_commands),
      .stop_i             (give_up_i),
      .done_o             (commands_done),
      .in_place_i         (enable[1]),
      .unit_i             (unit_o),
      .event_valid_i      (event_valid_i),
      .event_ready_o      (event_ready_o),
      .event_block_i      (event_block_i),
      .event_block_valid_i(event_block_valid_i),
      .event_write_i      (event_write_i),
      .event_board_i      (event_board_i),
      .event_first_i      (event_first_i),
      .event_count_i      (event_count_i),
      .event_from_i       (event_from_i),
      .event_tag_i        (event_tag_i),
      .reply_valid_o      (reply_valid_o),
      .reply_ready_i      (reply_ready_i),
      .reply_block_o      (reply_block_o),
      .reply_write_o      (reply_write_o),
      .reply_status_o     (reply_status_o),
      .reply_count_o      (reply_count_o),
      .reply_to_o         (reply_to_o),
      .reply_tag_o        (reply_tag_o),
      .came_i             (came),
      .status_i           (status),
      .take_o             (command_take_route),
      .resource_o         (command_resource),
      .first_o            (command_first),
      .count_o            (command_count),
      .way_i              (way),
      .gives_up_i         (gives_up),
      .exclusive_i        (exclusive),
      .held_i             (held),
      .lock_o             (command_lock),
      .free_o             (command_free),
      .send_o             (command_send),
      .write_o            (command_write),
      .block_o            (command_block),
      .sending_i          (sending),
      .copy_start_o       (command_copy_start),
      .copy_done_i        (copy_done),
      .held_o             (command_held),
      .failed_o           (command_failed),
      .executed_o         (executed),
      .suspended_o        (suspended),
      .pc_waiting_o       (pc_waiting_o),
      .sel_register_i     (sel_register_i),
      .addr_i             (addr_i),
      .read_i             (read_i),
      .write_i            (write_i),
      .wdata_i            (wdata_i),
      .rdata_o            (commands_rdata)
  );

  assign event_block_take_o = event_valid_i && event_ready_o;

  // ---- what both use: routes, locks and requests, completions, copies ---------------------------------

  flow_route #(
      .WORD_POINTS(WORD_POINTS)
  ) route (
      .clk_i            (clk_i),
      .rst_ni           (rst_ni),
      .unit_i           (unit_o),
      .attributes_i     (attributes),
      .take_i           (of_steps ? step_take : command_take_route),
      .resource_i       (of_steps ? transfer_resource : command_resource),
      .first_i          (of_steps ? transfer_first : command_first),
      .count_i          (of_steps ? transfer_count : command_count),
      .way_o            (way),
      .gives_up_o       (gives_up),
      .exclusive_o      (exclusive),
      .held_o           (held),
      .board_o          (board),
      .first_o          (first),
      .count_o          (count),
      .lock_i           (step_lock || command_lock),
      .lock_board_i     (of_steps ? step_lock_board : board),
      .lock_block_i     (lock_block),
      .free_valid_i     (free_valid),
      .free_block_i     (free_block),
      .send_i           (send),
      .write_i          (of_steps ? step_write : command_write),
      .block_i          (block),
      .sending_o        (sending),
      .link_req_valid_o (link_req_valid_o),
      .link_req_ready_i (link_req_ready_i),
      .panel_req_valid_o(panel_req_valid_o),
      .panel_req_ready_i(panel_req_ready_i),
      .req_block_o      (req_block_o),
      .req_write_o      (req_write_o),
      .req_unit_o       (req_unit_o),
      .req_board_o      (req_board_o),
      .req_first_o      (req_first_o),
      .req_count_o      (req_count_o)
  );

  flow_done completions (
      .clk_i              (clk_i),
      .rst_ni             (rst_ni),
      .link_done_valid_i  (link_done_valid_i),
      .link_done_ready_o  (link_done_ready_o),
      .link_done_block_i  (link_done_block_i),
      .link_done_status_i (link_done_status_i),
      .panel_done_valid_i (panel_done_valid_i),
      .panel_done_ready_o (panel_done_ready_o),
      .panel_done_block_i (panel_done_block_i),
      .panel_done_status_i(panel_done_status_i),
      .owner_write_i      (send),
      .owner_block_i      (block),
      .owner_task_i       (row_task),
      .come_valid_o       (come_valid),
      .come_ready_i       (come_ready),
      .come_task_o        (come_task),
      .come_block_o       (come_block),
      .came_o             (came),
      .status_block_i     (block),
      .status_o           (status)
  );

  flow_copy copy (
      .clk_i        (clk_i),
      .rst_ni       (rst_ni),
      .stop_i       (give_up_i),
      .start_i      (step_copy_start || command_copy_start),
      .put_i        (copy_put),
      .to_block_i   (of_steps ? step_copy_to_block : !command_write),
      .mapped_i     (!of_steps || step_copy_mapped),
      .first_i      (copy_put ? status_word : of_steps && step_copy_head ? transfer_head : first),
      .count_i      (count),
      .block_i      (of_steps ? step_copy_block : command_block),
      .put_data_i   (copy_put_data),
      .done_o       (copy_done),
      .mem_valid_o  (mem_valid_o),
      .mem_write_o  (mem_write_o),
      .mem_addr_o   (mem_addr_o),
      .mem_wdata_o  (mem_wdata_o),
      .mem_rdata_i  (mem_rdata_i),
      .map_read_o   (map_read_o),
      .map_words_o  (map_words_o),
      .map_point_o  (map_point_o),
      .map_mapped_i (map_mapped_i),
      .map_device_i (map_device_i),
      .host_valid_o (host_valid_o),
      .host_write_o (host_write_o),
      .host_words_o (host_words_o),
      .host_addr_o  (host_addr_o),
      .host_data_o  (host_data_o),
      .host_rvalid_i(host_rvalid_i),
      .host_rdata_i (host_rdata_i)
  );

  // ---- the round --------------------------------------------------------------------------------------

  flow_round round (
      .clk_i          (clk_i),
      .rst_ni         (rst_ni),
      .flows_i        (flows),
      .give_up_i      (give_up_i),
      .round_i        (round_i),
      .round_done_o   (round_done_o),
      .walking_i      (walking),
      .busy_i         (steps_busy),
      .begin_o        (begins),
      .commands_o     (start_commands),
      .commands_done_i(commands_done),
      .steps_o        (start_steps),
      .steps_done_i   (steps_done),
      .of_steps_o     (of_steps),
      .ladder_o       (ladder_o),
      .ladder_done_i  (ladder_done_i),
      .flow_ladder_o  (ladder),
      .flow_done_o    (round_done)
  );

  // ---- registers --------------------------------------------------------------------------------------

  flow_registers registers (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .clear_i       (first_i),
      .round_i       (round_i && flows),
      .round_done_i  (round_done),
      .ladder_i      (ladder),
      .ladder_done_i (round_done),
      .count_i       (counted),
      .late_i        (late_i),
      .link_i        (link_counters_i),
      .panel_i       (panel_counters_i),
      .sel_register_i(sel_register_i),
      .addr_i        (addr_i),
      .read_i        (read_i),
      .rdata_o       (registers_rdata)
  );

  assign rdata_o = tables_rdata | tasks_rdata | commands_rdata | registers_rdata;

endmodule

`default_nettype wire

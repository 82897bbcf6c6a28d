// SPDX-License-Identifier: Apache-2.0
// All of the flow tasks' hardware for a controller: scheduler, pool, link and the panel's line (README.md). Its
// borders are those of flow_scheduler.v (round, processor, devices, load, bus) and the pins of the lines.
`default_nettype none
`include "rung_flow.vh"

module flow_block #(
    parameter integer CLOCK_HZ    = 25000000,  // of clk_i
    parameter integer WORD_POINTS = 472        // of the device map
) (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        millisecond_i,
    // round
    input  wire        first_i,
    input  wire        give_up_i,
    input  wire        round_i,
    output wire        round_done_o,
    output wire        ladder_o,
    input  wire        ladder_done_i,
    // processor
    output wire        start_o,
    output wire [15:0] entry_o,
    output wire [15:0] end_o,
    input  wire        done_i,
    input  wire [ 1:0] write_valid_i,
    input  wire [31:0] write_addr_i,
    input  wire [31:0] write_data_i,
    // device map and devices
    output wire        map_read_o,
    output wire        map_words_o,
    output wire [15:0] map_point_o,
    input  wire        map_mapped_i,
    input  wire [14:0] map_device_i,
    output wire        host_valid_o,
    output wire        host_write_o,
    output wire        host_words_o,
    output wire [14:0] host_addr_o,
    output wire [15:0] host_data_o,
    input  wire        host_rvalid_i,
    input  wire [15:0] host_rdata_i,
    // load: steps lowest, transfers, tasks, setup
    input  wire [ 3:0] load_write_i,
    input  wire [15:0] load_addr_i,
    input  wire [15:0] load_data_i,
    // bus
    input  wire        sel_register_i,
    input  wire [ 7:0] addr_i,
    input  wire        read_i,
    input  wire        write_i,
    input  wire [15:0] wdata_i,
    output wire [15:0] rdata_o,
    // lines
    input  wire        upper_rx_i,
    output wire        upper_tx_o,
    input  wire        lower_rx_i,
    output wire        lower_tx_o,
    input  wire        panel_rx_i,
    output wire        panel_tx_o,
    output wire        panel_de_o
);

  // ---- pool ------------------------------------------------------------------------------------
  wire engine_valid;
  wire engine_write;
  wire [9:0] engine_addr;
  wire [15:0] engine_wdata;
  wire [15:0] engine_rdata;
  wire link_valid;
  wire link_ready;
  wire link_write;
  wire [9:0] link_addr;
  wire [15:0] link_wdata;
  wire [15:0] link_rdata;
  wire panel_valid;
  wire panel_ready;
  wire panel_write;
  wire [9:0] panel_addr;
  wire [15:0] panel_wdata;
  wire [15:0] panel_rdata;
  wire task_block_valid;
  wire [4:0] task_block;
  wire task_block_take;
  wire task_free_valid;
  wire [4:0] task_free_block;
  wire event_block_valid;
  wire [4:0] event_block;
  wire event_block_take;
  wire reply_done_valid;
  wire [4:0] reply_done_block;
  wire pc_waiting;
  wire [15:0] pool_rdata;

  flow_pool pool (
      .clk_i             (clk_i),
      .rst_ni            (rst_ni),
      .engine_valid_i    (engine_valid),
      .engine_write_i    (engine_write),
      .engine_addr_i     (engine_addr),
      .engine_wdata_i    (engine_wdata),
      .engine_rdata_o    (engine_rdata),
      .link_valid_i      (link_valid),
      .link_ready_o      (link_ready),
      .link_write_i      (link_write),
      .link_addr_i       (link_addr),
      .link_wdata_i      (link_wdata),
      .link_rdata_o      (link_rdata),
      .panel_valid_i     (panel_valid),
      .panel_ready_o     (panel_ready),
      .panel_write_i     (panel_write),
      .panel_addr_i      (panel_addr),
      .panel_wdata_i     (panel_wdata),
      .panel_rdata_o     (panel_rdata),
      .task_valid_o      (task_block_valid),
      .task_block_o      (task_block),
      .task_take_i       (task_block_take),
      .free_valid_i      (task_free_valid),
      .free_block_i      (task_free_block),
      .event_valid_o     (event_block_valid),
      .event_block_o     (event_block),
      .event_take_i      (event_block_take),
      .event_free_valid_i(reply_done_valid),
      .event_free_block_i(reply_done_block),
      .pc_waiting_i      (pc_waiting),
      .sel_register_i    (sel_register_i),
      .addr_i            (addr_i),
      .read_i            (read_i),
      .write_i           (write_i),
      .wdata_i           (wdata_i),
      .rdata_o           (pool_rdata)
  );

  // ---- scheduler -------------------------------------------------------------------------------
  wire link_req_valid;
  wire link_req_ready;
  wire panel_req_valid;
  wire panel_req_ready;
  wire [4:0] req_block;
  wire req_write;
  wire [7:0] req_unit;
  wire [7:0] req_board;
  wire [15:0] req_first;
  wire [5:0] req_count;
  wire link_done_valid;
  wire link_done_ready;
  wire [4:0] link_done_block;
  wire [7:0] link_done_status;
  wire panel_done_valid;
  wire panel_done_ready;
  wire [4:0] panel_done_block;
  wire [7:0] panel_done_status;
  wire event_valid;
  wire event_ready;
  wire event_write;
  wire [7:0] event_board;
  wire [15:0] event_first;
  wire [5:0] event_count;
  wire [7:0] event_from;
  wire [7:0] event_tag;
  wire reply_valid;
  wire reply_ready;
  wire [4:0] reply_block;
  wire reply_write;
  wire [7:0] reply_status;
  wire [5:0] reply_count;
  wire [7:0] reply_to;
  wire [7:0] reply_tag;
  wire [3:0] unit;
  wire [15:0] link_timeout;
  wire [15:0] panel_timeout;
  wire [7:0] panel_unit;
  wire [19:0] panel_baud;
  wire [1:0] panel_parity;
  wire [15:0] late;
  wire [127:0] link_counters;
  wire [31:0] panel_counters;
  wire [15:0] scheduler_rdata;

  flow_scheduler #(
      .WORD_POINTS(WORD_POINTS)
  ) scheduler (
      .clk_i              (clk_i),
      .rst_ni             (rst_ni),
      .first_i            (first_i),
      .give_up_i          (give_up_i),
      .round_i            (round_i),
      .round_done_o       (round_done_o),
      .ladder_o           (ladder_o),
      .ladder_done_i      (ladder_done_i),
      .start_o            (start_o),
      .entry_o            (entry_o),
      .end_o              (end_o),
      .done_i             (done_i),
      .write_valid_i      (write_valid_i),
      .write_addr_i       (write_addr_i),
      .write_data_i       (write_data_i),
      .map_read_o         (map_read_o),
      .map_words_o        (map_words_o),
      .map_point_o        (map_point_o),
      .map_mapped_i       (map_mapped_i),
      .map_device_i       (map_device_i),
      .host_valid_o       (host_valid_o),
      .host_write_o       (host_write_o),
      .host_words_o       (host_words_o),
      .host_addr_o        (host_addr_o),
      .host_data_o        (host_data_o),
      .host_rvalid_i      (host_rvalid_i),
      .host_rdata_i       (host_rdata_i),
      .mem_valid_o        (engine_valid),
      .mem_write_o        (engine_write),
      .mem_addr_o         (engine_addr),
      .mem_wdata_o        (engine_wdata),
      .mem_rdata_i        (engine_rdata),
      .task_block_valid_i (task_block_valid),
      .task_block_i       (task_block),
      .task_block_take_o  (task_block_take),
      .task_free_valid_o  (task_free_valid),
      .task_free_block_o  (task_free_block),
      .event_block_valid_i(event_block_valid),
      .event_block_i      (event_block),
      .event_block_take_o (event_block_take),
      .pc_waiting_o       (pc_waiting),
      .link_req_valid_o   (link_req_valid),
      .link_req_ready_i   (link_req_ready),
      .panel_req_valid_o  (panel_req_valid),
      .panel_req_ready_i  (panel_req_ready),
      .req_block_o        (req_block),
      .req_write_o        (req_write),
      .req_unit_o         (req_unit),
      .req_board_o        (req_board),
      .req_first_o        (req_first),
      .req_count_o        (req_count),
      .link_done_valid_i  (link_done_valid),
      .link_done_ready_o  (link_done_ready),
      .link_done_block_i  (link_done_block),
      .link_done_status_i (link_done_status),
      .panel_done_valid_i (panel_done_valid),
      .panel_done_ready_o (panel_done_ready),
      .panel_done_block_i (panel_done_block),
      .panel_done_status_i(panel_done_status),
      .event_valid_i      (event_valid),
      .event_ready_o      (event_ready),
      .event_write_i      (event_write),
      .event_board_i      (event_board),
      .event_first_i      (event_first),
      .event_count_i      (event_count),
      .event_from_i       (event_from),
      .event_tag_i        (event_tag),
      .reply_valid_o      (reply_valid),
      .reply_ready_i      (reply_ready),
      .reply_block_o      (reply_block),
      .reply_write_o      (reply_write),
      .reply_status_o     (reply_status),
      .reply_count_o      (reply_count),
      .reply_to_o         (reply_to),
      .reply_tag_o        (reply_tag),
      .unit_o             (unit),
      .link_timeout_o     (link_timeout),
      .panel_timeout_o    (panel_timeout),
      .panel_unit_o       (panel_unit),
      .panel_baud_o       (panel_baud),
      .panel_parity_o     (panel_parity),
      .late_i             (late),
      .link_counters_i    (link_counters),
      .panel_counters_i   (panel_counters),
      .steps_write_i      (load_write_i[0]),
      .transfers_write_i  (load_write_i[1]),
      .tasks_write_i      (load_write_i[2]),
      .setup_write_i      (load_write_i[3]),
      .load_addr_i        (load_addr_i),
      .load_data_i        (load_data_i),
      .sel_register_i     (sel_register_i),
      .addr_i             (addr_i),
      .read_i             (read_i),
      .write_i            (write_i),
      .wdata_i            (wdata_i),
      .rdata_o            (scheduler_rdata)
  );

  assign rdata_o = pool_rdata | scheduler_rdata;

  // ---- lines -----------------------------------------------------------------------------------
  link link (
      .clk_i              (clk_i),
      .rst_ni             (rst_ni),
      .unit_i             (unit),
      .timeout_ms_i       (link_timeout),
      .millisecond_i      (millisecond_i),
      .upper_rx_i         (upper_rx_i),
      .upper_tx_o         (upper_tx_o),
      .lower_rx_i         (lower_rx_i),
      .lower_tx_o         (lower_tx_o),
      .link_req_valid_i   (link_req_valid),
      .link_req_ready_o   (link_req_ready),
      .link_req_block_i   (req_block),
      .link_req_write_i   (req_write),
      .link_req_unit_i    (req_unit),
      .link_req_board_i   (req_board),
      .link_req_first_i   (req_first),
      .link_req_count_i   (req_count),
      .link_done_valid_o  (link_done_valid),
      .link_done_ready_i  (link_done_ready),
      .link_done_block_o  (link_done_block),
      .link_done_status_o (link_done_status),
      .event_block_valid_i(event_block_valid),
      .event_block_i      (event_block),
      .event_valid_o      (event_valid),
      .event_ready_i      (event_ready),
      .event_write_o      (event_write),
      .event_board_o      (event_board),
      .event_first_o      (event_first),
      .event_count_o      (event_count),
      .event_from_o       (event_from),
      .event_tag_o        (event_tag),
      .reply_valid_i      (reply_valid),
      .reply_ready_o      (reply_ready),
      .reply_block_i      (reply_block),
      .reply_write_i      (reply_write),
      .reply_status_i     (reply_status),
      .reply_count_i      (reply_count),
      .reply_to_i         (reply_to),
      .reply_tag_i        (reply_tag),
      .reply_done_valid_o (reply_done_valid),
      .reply_done_block_o (reply_done_block),
      .mem_valid_o        (link_valid),
      .mem_ready_i        (link_ready),
      .mem_write_o        (link_write),
      .mem_addr_o         (link_addr),
      .mem_wdata_o        (link_wdata),
      .mem_rdata_i        (link_rdata),
      .upper_bad_o        (link_counters[0+:16]),
      .upper_full_o       (link_counters[16+:16]),
      .upper_again_o      (link_counters[32+:16]),
      .upper_lost_o       (link_counters[48+:16]),
      .lower_bad_o        (link_counters[64+:16]),
      .lower_full_o       (link_counters[80+:16]),
      .lower_again_o      (link_counters[96+:16]),
      .lower_lost_o       (link_counters[112+:16]),
      .late_o             (late)
  );

  panel_client #(
      .CLOCK_HZ(CLOCK_HZ)
  ) panel (
      .clk_i              (clk_i),
      .rst_ni             (rst_ni),
      .baud_step_i        (panel_baud),
      .parity_i           (panel_parity),
      .unit_i             (panel_unit),
      .timeout_ms_i       (panel_timeout),
      .millisecond_i      (millisecond_i),
      .rx_i               (panel_rx_i),
      .tx_o               (panel_tx_o),
      .de_o               (panel_de_o),
      .panel_req_valid_i  (panel_req_valid),
      .panel_req_ready_o  (panel_req_ready),
      .panel_req_block_i  (req_block),
      .panel_req_write_i  (req_write),
      .panel_req_first_i  (req_first),
      .panel_req_count_i  (req_count),
      .panel_done_valid_o (panel_done_valid),
      .panel_done_ready_i (panel_done_ready),
      .panel_done_block_o (panel_done_block),
      .panel_done_status_o(panel_done_status),
      .mem_valid_o        (panel_valid),
      .mem_ready_i        (panel_ready),
      .mem_write_o        (panel_write),
      .mem_addr_o         (panel_addr),
      .mem_wdata_o        (panel_wdata),
      .mem_rdata_i        (panel_rdata),
      .bad_o              (panel_counters[0+:16]),
      .timeouts_o         (panel_counters[16+:16])
  );

endmodule

`default_nettype wire

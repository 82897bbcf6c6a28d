// SPDX-License-Identifier: Apache-2.0
// Bench top: the flow scheduler with its pool, the device map, and a processor behind its ladder's ports, wired as in a
// controller. The other sides of link, panel, bus, load and scan controller are the test's.
`default_nettype none

module flow_bench #(
    parameter integer MPU          = 3,
    parameter integer STEPS        = 256,
    parameter integer BIT_DEVICES  = 1024,
    parameter integer WORD_DEVICES = 256,
    parameter integer MUL_LATENCY  = 18,
    parameter integer DIV_LATENCY  = 19,
    parameter integer WORD_POINTS  = 64
) (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        core_rst_ni,
    // scan controller
    input  wire        first_i,
    input  wire        give_up_i,
    input  wire        round_i,
    output wire        round_done_o,
    // what the processor does
    output wire        start_o,
    output wire        done_o,
    output wire        ladder_o,
    output wire        ladder_done_o,
    output wire [ 1:0] write_valid_o,
    output wire [31:0] write_addr_o,
    output wire [31:0] write_data_o,
    // load: ladder_ports.v, device map, flow spaces 12 to 15
    input  wire        load_valid_i,
    input  wire        load_write_i,
    input  wire [ 2:0] load_space_i,
    input  wire        map_write_i,
    input  wire [ 3:0] flow_write_i,
    input  wire [19:0] load_addr_i,
    input  wire [15:0] load_data_i,
    output wire        load_rvalid_o,
    output wire [15:0] load_rdata_o,
    // pool: link and panel
    input  wire        link_mem_valid_i,
    output wire        link_mem_ready_o,
    input  wire        link_mem_write_i,
    input  wire [ 9:0] link_mem_addr_i,
    input  wire [15:0] link_mem_wdata_i,
    output wire [15:0] link_mem_rdata_o,
    input  wire        panel_mem_valid_i,
    output wire        panel_mem_ready_o,
    input  wire        panel_mem_write_i,
    input  wire [ 9:0] panel_mem_addr_i,
    input  wire [15:0] panel_mem_wdata_i,
    output wire [15:0] panel_mem_rdata_o,
    // requests, completions
    output wire        link_req_valid_o,
    input  wire        link_req_ready_i,
    output wire        panel_req_valid_o,
    input  wire        panel_req_ready_i,
    output wire [ 4:0] req_block_o,
    output wire        req_write_o,
    output wire [ 7:0] req_unit_o,
    output wire [ 7:0] req_board_o,
    output wire [15:0] req_first_o,
    output wire [ 5:0] req_count_o,
    input  wire        link_done_valid_i,
    output wire        link_done_ready_o,
    input  wire [ 4:0] link_done_block_i,
    input  wire [ 7:0] link_done_status_i,
    input  wire        panel_done_valid_i,
    output wire        panel_done_ready_o,
    input  wire [ 4:0] panel_done_block_i,
    input  wire [ 7:0] panel_done_status_i,
    // event commands and replies
    output wire        event_block_valid_o,
    output wire [ 4:0] event_block_o,
    input  wire        event_valid_i,
    output wire        event_ready_o,
    input  wire        event_write_i,
    input  wire [ 7:0] event_board_i,
    input  wire [15:0] event_first_i,
    input  wire [ 5:0] event_count_i,
    input  wire [ 7:0] event_from_i,
    input  wire [ 7:0] event_tag_i,
    output wire        reply_valid_o,
    input  wire        reply_ready_i,
    output wire [ 4:0] reply_block_o,
    output wire        reply_write_o,
    output wire [ 7:0] reply_status_o,
    output wire [ 5:0] reply_count_o,
    output wire [ 7:0] reply_to_o,
    output wire [ 7:0] reply_tag_o,
    input  wire        reply_done_valid_i,
    input  wire [ 4:0] reply_done_block_i,
    // bus
    input  wire [ 7:0] addr_i,
    input  wire        read_i,
    input  wire        write_i,
    input  wire [15:0] wdata_i,
    output wire [15:0] rdata_o
);

  wire ladder;
  wire ladder_done;
  wire flow_start;
  wire [15:0] entry;
  wire [15:0] end_step;
  wire core_done;
  wire [1:0] write_valid;
  wire [31:0] write_addr;
  wire [31:0] write_data;
  wire map_read;
  wire map_words;
  wire [15:0] map_point;
  wire map_mapped;
  wire [14:0] map_device;
  wire flow_host_valid;
  wire flow_host_write;
  wire flow_host_words;
  wire [14:0] flow_host_addr;
  wire [15:0] flow_host_data;
  wire host_rvalid;
  wire [15:0] host_rdata;
  wire mem_valid;
  wire mem_write;
  wire [9:0] mem_addr;
  wire [15:0] mem_wdata;
  wire [15:0] mem_rdata;
  wire task_block_valid;
  wire [4:0] task_block;
  wire task_block_take;
  wire task_free_valid;
  wire [4:0] task_free_block;
  wire event_block_take;
  wire pc_waiting;
  wire [15:0] pool_rdata;
  wire [15:0] scheduler_rdata;

  assign start_o = flow_start;
  assign done_o = core_done;
  assign ladder_o = ladder;
  assign ladder_done_o = ladder_done;
  assign write_valid_o = write_valid;
  assign write_addr_o = write_addr;
  assign write_data_o = write_data;
  assign load_rvalid_o = host_rvalid;
  assign load_rdata_o = host_rdata;
  assign rdata_o = pool_rdata | scheduler_rdata;

  flow_scheduler #(
      .WORD_POINTS(WORD_POINTS)
  ) scheduler (
      .clk_i              (clk_i),
      .rst_ni             (rst_ni),
      .first_i            (first_i),
      .give_up_i          (give_up_i),
      .round_i            (round_i),
      .round_done_o       (round_done_o),
      .ladder_o           (ladder),
      .ladder_done_i      (ladder_done),
      .start_o            (flow_start),
      .entry_o            (entry),
      .end_o              (end_step),
      .done_i             (core_done),
      .write_valid_i      (write_valid),
      .write_addr_i       (write_addr),
      .write_data_i       (write_data),
      .map_read_o         (map_read),
      .map_words_o        (map_words),
      .map_point_o        (map_point),
      .map_mapped_i       (map_mapped),
      .map_device_i       (map_device),
      .host_valid_o       (flow_host_valid),
      .host_write_o       (flow_host_write),
      .host_words_o       (flow_host_words),
      .host_addr_o        (flow_host_addr),
      .host_data_o        (flow_host_data),
      .host_rvalid_i      (host_rvalid),
      .host_rdata_i       (host_rdata),
      .mem_valid_o        (mem_valid),
      .mem_write_o        (mem_write),
      .mem_addr_o         (mem_addr),
      .mem_wdata_o        (mem_wdata),
      .mem_rdata_i        (mem_rdata),
      .task_block_valid_i (task_block_valid),
      .task_block_i       (task_block),
      .task_block_take_o  (task_block_take),
      .task_free_valid_o  (task_free_valid),
      .task_free_block_o  (task_free_block),
      .event_block_valid_i(event_block_valid_o),
      .event_block_i      (event_block_o),
      .event_block_take_o (event_block_take),
      .pc_waiting_o       (pc_waiting),
      .link_req_valid_o   (link_req_valid_o),
      .link_req_ready_i   (link_req_ready_i),
      .panel_req_valid_o  (panel_req_valid_o),
      .panel_req_ready_i  (panel_req_ready_i),
      .req_block_o        (req_block_o),
      .req_write_o        (req_write_o),
      .req_unit_o         (req_unit_o),
      .req_board_o        (req_board_o),
      .req_first_o        (req_first_o),
      .req_count_o        (req_count_o),
      .link_done_valid_i  (link_done_valid_i),
      .link_done_ready_o  (link_done_ready_o),
      .link_done_block_i  (link_done_block_i),
      .link_done_status_i (link_done_status_i),
      .panel_done_valid_i (panel_done_valid_i),
      .panel_done_ready_o (panel_done_ready_o),
      .panel_done_block_i (panel_done_block_i),
      .panel_done_status_i(panel_done_status_i),
      .event_valid_i      (event_valid_i),
      .event_ready_o      (event_ready_o),
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
      // verilator lint_off PINCONNECTEMPTY
      .unit_o             (),
      .link_timeout_o     (),
      .panel_timeout_o    (),
      .panel_unit_o       (),
      .panel_baud_o       (),
      .panel_parity_o     (),
      // verilator lint_on PINCONNECTEMPTY
      .late_i             (16'd1000),
      .link_counters_i    ({16'd8, 16'd7, 16'd6, 16'd5, 16'd4, 16'd3, 16'd2, 16'd1}),
      .panel_counters_i   ({16'd10, 16'd9}),
      .steps_write_i      (flow_write_i[0]),
      .transfers_write_i  (flow_write_i[1]),
      .tasks_write_i      (flow_write_i[2]),
      .setup_write_i      (flow_write_i[3]),
      .load_addr_i        (load_addr_i[15:0]),
      .load_data_i        (load_data_i),
      .sel_register_i     (1'b1),
      .addr_i             (addr_i),
      .read_i             (read_i),
      .write_i            (write_i),
      .wdata_i            (wdata_i),
      .rdata_o            (scheduler_rdata)
  );

  flow_pool pool (
      .clk_i             (clk_i),
      .rst_ni            (rst_ni),
      .engine_valid_i    (mem_valid),
      .engine_write_i    (mem_write),
      .engine_addr_i     (mem_addr),
      .engine_wdata_i    (mem_wdata),
      .engine_rdata_o    (mem_rdata),
      .link_valid_i      (link_mem_valid_i),
      .link_ready_o      (link_mem_ready_o),
      .link_write_i      (link_mem_write_i),
      .link_addr_i       (link_mem_addr_i),
      .link_wdata_i      (link_mem_wdata_i),
      .link_rdata_o      (link_mem_rdata_o),
      .panel_valid_i     (panel_mem_valid_i),
      .panel_ready_o     (panel_mem_ready_o),
      .panel_write_i     (panel_mem_write_i),
      .panel_addr_i      (panel_mem_addr_i),
      .panel_wdata_i     (panel_mem_wdata_i),
      .panel_rdata_o     (panel_mem_rdata_o),
      .task_valid_o      (task_block_valid),
      .task_block_o      (task_block),
      .task_take_i       (task_block_take),
      .free_valid_i      (task_free_valid),
      .free_block_i      (task_free_block),
      .event_valid_o     (event_block_valid_o),
      .event_block_o     (event_block_o),
      .event_take_i      (event_block_take),
      .event_free_valid_i(reply_done_valid_i),
      .event_free_block_i(reply_done_block_i),
      .pc_waiting_i      (pc_waiting),
      .sel_register_i    (1'b1),
      .addr_i            (addr_i),
      .read_i            (read_i),
      .write_i           (write_i),
      .wdata_i           (wdata_i),
      .rdata_o           (pool_rdata)
  );

  device_map #(
      .BIT_POINTS  (16),
      .WORD_POINTS (WORD_POINTS),
      .BIT_DEVICES (BIT_DEVICES),
      .WORD_DEVICES(WORD_DEVICES)
  ) map (
      .clk_i       (clk_i),
      .read_i      (map_read),
      .words_i     (map_words),
      .point_i     (map_point),
      .mapped_o    (map_mapped),
      .device_o    (map_device),
      .bit_write_i (1'b0),
      .word_write_i(map_write_i),
      .write_addr_i(load_addr_i[15:0]),
      .write_data_i(load_data_i)
  );

  wire ports_start;
  wire load_valid;
  wire load_write;
  wire [2:0] load_space;
  wire [19:0] load_addr;
  wire [15:0] load_data;
  wire load_rvalid;
  wire [15:0] load_rdata;
  wire [2:0] flow_space = flow_host_words ? 3'd3 : 3'd2;

  ladder_ports #(
      .BIT_DEVICES (BIT_DEVICES),
      .WORD_DEVICES(WORD_DEVICES)
  ) ports (
      .clk_i          (clk_i),
      .rst_ni         (rst_ni),
      .exchange_rst_ni(core_rst_ni),
      .rx_i           (1'b1),
      .adc_i          (128'd0),
      .persist_ready_i(1'b0),
      .pwm_on_i       (1'b0),
      .duty_valid_i   (1'b0),
      .duty_i         (16'd0),
      .hz_i           (32'd0),
      // verilator lint_off PINCONNECTEMPTY
      .tx_o           (),
      .pwm_o          (),
      .keep_valid_o   (),
      .keep_index_o   (),
      .keep_value_o   (),
      .busy_o         (),
      // verilator lint_on PINCONNECTEMPTY
      .scan_i         (ladder),
      .done_o         (ladder_done),
      .host_valid_i   (flow_host_valid || load_valid_i),
      .host_write_i   (flow_host_valid ? flow_host_write : load_write_i),
      .host_space_i   (flow_host_valid ? flow_space : load_space_i),
      .host_addr_i    (flow_host_valid ? {5'd0, flow_host_addr} : load_addr_i),
      .host_data_i    (flow_host_valid ? flow_host_data : load_data_i),
      .host_rvalid_o  (host_rvalid),
      .host_rdata_o   (host_rdata),
      .start_o        (ports_start),
      .done_i         (core_done),
      .load_valid_o   (load_valid),
      .load_write_o   (load_write),
      .load_space_o   (load_space),
      .load_addr_o    (load_addr),
      .load_data_o    (load_data),
      .load_rvalid_i  (load_rvalid),
      .load_rdata_i   (load_rdata)
  );

  processor #(
      .MPU         (MPU),
      .STEPS       (STEPS),
      .BIT_DEVICES (BIT_DEVICES),
      .WORD_DEVICES(WORD_DEVICES),
      .MUL_LATENCY (MUL_LATENCY),
      .DIV_LATENCY (DIV_LATENCY)
  ) mpu (
      .clk_i        (clk_i),
      .rst_ni       (core_rst_ni),
      .start_i      (flow_start || ports_start),
      .done_o       (core_done),
      // verilator lint_off PINCONNECTEMPTY
      .error_o      (),
      .clocks_o     (),
      // verilator lint_on PINCONNECTEMPTY
      .range_i      (flow_start),
      .entry_i      (entry),
      .end_i        (end_step),
      .write_valid_o(write_valid),
      .write_addr_o (write_addr),
      .write_data_o (write_data),
      .load_valid_i (load_valid),
      .load_write_i (load_write),
      .load_space_i (load_space),
      .load_addr_i  (load_addr),
      .load_data_i  (load_data),
      .load_rvalid_o(load_rvalid),
      .load_rdata_o (load_rdata)
  );

endmodule

`default_nettype wire

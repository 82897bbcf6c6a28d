// SPDX-License-Identifier: Apache-2.0
// The link between units: a chain of point-to-point lines, each unit with an upper and a lower side. What the
// scheduler sees is in README.md: requests with their completions, event commands with their replies.
//
// link_hop        a side: frames with CRC, acknowledged, repeated, kept in order and single; its receive ring
// link_table      own requests and replies until they are sent and complete
// link_dispatch   moves records: through, to the pool, to the scheduler; own frames to the sides; timeouts
//
// unit_i 0: no unit of a link; both sides are held in reset, requests run into their timeouts. DIVISOR: clocks a bit,
// 6 and more, the same for all units. timeout_ms_i up to 32767; a request's may be a millisecond longer, and a frame's
// time. done_ready_i and mem_ready_i have to come soon: what waits for them holds up the rest.
// Four block RAMs of 16 kbit: the rings, the buffers to send from, the table. ECP5: some 2,100 LUTs with carry chains and
// LUT memory, 80 MHz at speed grade 6.
`default_nettype none
`include "rung_flow.vh"

module link #(
    parameter integer DIVISOR = `RUNG_LINK_DIVISOR
) (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire [ 3:0] unit_i,
    input  wire [15:0] timeout_ms_i,
    input  wire        millisecond_i,
    // pins
    input  wire        upper_rx_i,
    output wire        upper_tx_o,
    input  wire        lower_rx_i,
    output wire        lower_tx_o,
    // requests
    input  wire        link_req_valid_i,
    output wire        link_req_ready_o,
    input  wire [ 4:0] link_req_block_i,
    input  wire        link_req_write_i,
    input  wire [ 7:0] link_req_unit_i,
    input  wire [ 7:0] link_req_board_i,
    input  wire [15:0] link_req_first_i,
    input  wire [ 5:0] link_req_count_i,
    output wire        link_done_valid_o,
    input  wire        link_done_ready_i,
    output wire [ 4:0] link_done_block_o,
    output wire [ 7:0] link_done_status_o,
    // event commands
    input  wire        event_block_valid_i,
    input  wire [ 4:0] event_block_i,
    output wire        event_valid_o,
    input  wire        event_ready_i,
    output wire        event_write_o,
    output wire [ 7:0] event_board_o,
    output wire [15:0] event_first_o,
    output wire [ 5:0] event_count_o,
    output wire [ 7:0] event_from_o,
    output wire [ 7:0] event_tag_o,
    input  wire        reply_valid_i,
    output wire        reply_ready_o,
    input  wire [ 4:0] reply_block_i,
    input  wire        reply_write_i,
    input  wire [ 7:0] reply_status_i,
    input  wire [ 5:0] reply_count_i,
    input  wire [ 7:0] reply_to_i,
    input  wire [ 7:0] reply_tag_i,
    output wire        reply_done_valid_o,
    output wire [ 4:0] reply_done_block_o,
    // pool
    output wire        mem_valid_o,
    input  wire        mem_ready_i,
    output wire        mem_write_o,
    output wire [ 9:0] mem_addr_o,
    output wire [15:0] mem_wdata_o,
    input  wire [15:0] mem_rdata_i,
    // counters
    output wire [15:0] upper_bad_o,
    output wire [15:0] upper_full_o,
    output wire [15:0] upper_again_o,
    output wire [15:0] upper_lost_o,
    output wire [15:0] lower_bad_o,
    output wire [15:0] lower_full_o,
    output wire [15:0] lower_again_o,
    output wire [15:0] lower_lost_o,
    output wire [15:0] late_o
);

  localparam integer BITS = $clog2(DIVISOR);
  // verilator lint_off WIDTH
  localparam [BITS-1:0] BIT_END = DIVISOR - 1;
  // verilator lint_on WIDTH

  reg [BITS-1:0] divider_q;
  reg tick_q;
  reg hop_rst_nq;

  always @(posedge clk_i) begin
    if (!rst_ni || divider_q == BIT_END) divider_q <= {BITS{1'b0}};
    else divider_q <= divider_q + {{BITS - 1{1'b0}}, 1'b1};
    tick_q <= divider_q == BIT_END;
    hop_rst_nq <= rst_ni && unit_i != 4'd0;
  end

  wire [15:0] deadline;
  wire [1:0] find_class;
  wire [1:0] found;
  wire ring_read;
  wire [6:0] ring_index;
  wire [7:0] upper_ring_data;
  wire [7:0] lower_ring_data;
  wire [1:0] ring_free;
  wire [3:0] lane_free;
  wire [3:0] lane_commit;
  wire [6:0] lane_length;
  wire lane_write;
  wire [8:0] lane_addr;
  wire [7:0] lane_data;
  wire [1:0] down;
  wire [4:0] table_block;
  wire table_open;
  wire table_queued;
  wire table_lower;
  wire table_sent;
  wire table_ended;
  wire table_read;
  wire [1:0] table_word;
  wire [15:0] table_data;
  wire event_given;
  wire [3:0] event_use;
  wire upper_lane;
  wire [6:0] upper_index;
  wire lower_lane;
  wire [6:0] lower_index;

  // ---- buffers to send from: read for the two sides in turn ----
  reg phase_q;  // the next read is for the lower side
  reg [7:0] upper_byte_q;
  reg [7:0] lower_byte_q;
  wire [7:0] buffer_data;

  always @(posedge clk_i) begin
    phase_q <= rst_ni && !phase_q;
    if (phase_q) upper_byte_q <= buffer_data;
    else lower_byte_q <= buffer_data;
  end

  bank_ram #(
      .WIDTH(8),
      .DEPTH(512),
      .ADDR_BITS(9),
      .CLEARED(0)
  ) buffers (
      .clk_i       (clk_i),
      .read_i      (1'b1),
      .read_addr_i (phase_q ? {1'b1, lower_lane, lower_index} : {1'b0, upper_lane, upper_index}),
      .read_data_o (buffer_data),
      .write_i     (lane_write),
      .write_addr_i(lane_addr),
      .write_data_i(lane_data)
  );

  link_hop #(
      .DIVISOR(DIVISOR),
      .FROM_LOWER(0)
  ) upper (
      .clk_i        (clk_i),
      .rst_ni       (hop_rst_nq),
      .unit_i       (unit_i),
      .bit_tick_i   (tick_q),
      .rx_i         (upper_rx_i),
      .tx_o         (upper_tx_o),
      .find_class_i (find_class),
      .found_o      (found[0]),
      .read_i       (ring_read),
      .read_index_i (ring_index),
      .read_data_o  (upper_ring_data),
      .free_i       (ring_free[0]),
      .lane_free_o  (lane_free[1:0]),
      .lane_commit_i(lane_commit[1:0]),
      .lane_length_i(lane_length),
      .lane_o       (upper_lane),
      .lane_index_o (upper_index),
      .lane_data_i  (upper_byte_q),
      .down_o       (down[0]),
      .bad_o        (upper_bad_o),
      .full_o       (upper_full_o),
      .again_o      (upper_again_o),
      .lost_o       (upper_lost_o)
  );

  link_hop #(
      .DIVISOR(DIVISOR),
      .FROM_LOWER(1)
  ) lower (
      .clk_i        (clk_i),
      .rst_ni       (hop_rst_nq),
      .unit_i       (unit_i),
      .bit_tick_i   (tick_q),
      .rx_i         (lower_rx_i),
      .tx_o         (lower_tx_o),
      .find_class_i (find_class),
      .found_o      (found[1]),
      .read_i       (ring_read),
      .read_index_i (ring_index),
      .read_data_o  (lower_ring_data),
      .free_i       (ring_free[1]),
      .lane_free_o  (lane_free[3:2]),
      .lane_commit_i(lane_commit[3:2]),
      .lane_length_i(lane_length),
      .lane_o       (lower_lane),
      .lane_index_o (lower_index),
      .lane_data_i  (lower_byte_q),
      .down_o       (down[1]),
      .bad_o        (lower_bad_o),
      .full_o       (lower_full_o),
      .again_o      (lower_again_o),
      .lost_o       (lower_lost_o)
  );

  link_table own (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .unit_i        (unit_i),
      .deadline_i    (deadline),
      .req_valid_i   (link_req_valid_i),
      .req_ready_o   (link_req_ready_o),
      .req_block_i   (link_req_block_i),
      .req_write_i   (link_req_write_i),
      .req_unit_i    (link_req_unit_i),
      .req_board_i   (link_req_board_i),
      .req_first_i   (link_req_first_i),
      .req_count_i   (link_req_count_i),
      .reply_valid_i (reply_valid_i),
      .reply_ready_o (reply_ready_o),
      .reply_block_i (reply_block_i),
      .reply_write_i (reply_write_i),
      .reply_status_i(reply_status_i),
      .reply_count_i (reply_count_i),
      .reply_to_i    (reply_to_i),
      .reply_tag_i   (reply_tag_i),
      .event_given_i (event_given),
      .event_block_i (event_block_i[2:0]),
      .event_use_i   (event_use),
      .block_i       (table_block),
      .open_o        (table_open),
      .queued_o      (table_queued),
      .lower_o       (table_lower),
      .sent_i        (table_sent),
      .ended_i       (table_ended),
      .read_i        (table_read),
      .read_word_i   (table_word),
      .read_data_o   (table_data)
  );

  link_dispatch dispatch (
      .clk_i              (clk_i),
      .rst_ni             (rst_ni),
      .unit_i             (unit_i),
      .timeout_ms_i       (timeout_ms_i),
      .millisecond_i      (millisecond_i),
      .deadline_o         (deadline),
      .find_class_o       (find_class),
      .found_i            (found),
      .ring_read_o        (ring_read),
      .ring_index_o       (ring_index),
      .upper_data_i       (upper_ring_data),
      .lower_data_i       (lower_ring_data),
      .ring_free_o        (ring_free),
      .lane_free_i        (lane_free),
      .lane_commit_o      (lane_commit),
      .lane_length_o      (lane_length),
      .lane_write_o       (lane_write),
      .lane_addr_o        (lane_addr),
      .lane_data_o        (lane_data),
      .down_i             (down),
      .table_block_o      (table_block),
      .table_open_i       (table_open),
      .table_queued_i     (table_queued),
      .table_lower_i      (table_lower),
      .table_sent_o       (table_sent),
      .table_ended_o      (table_ended),
      .table_read_o       (table_read),
      .table_word_o       (table_word),
      .table_data_i       (table_data),
      .mem_valid_o        (mem_valid_o),
      .mem_ready_i        (mem_ready_i),
      .mem_write_o        (mem_write_o),
      .mem_addr_o         (mem_addr_o),
      .mem_wdata_o        (mem_wdata_o),
      .mem_rdata_i        (mem_rdata_i),
      .done_valid_o       (link_done_valid_o),
      .done_ready_i       (link_done_ready_i),
      .done_block_o       (link_done_block_o),
      .done_status_o      (link_done_status_o),
      .event_block_valid_i(event_block_valid_i),
      .event_block_i      (event_block_i),
      .event_valid_o      (event_valid_o),
      .event_ready_i      (event_ready_i),
      .event_write_o      (event_write_o),
      .event_board_o      (event_board_o),
      .event_first_o      (event_first_o),
      .event_count_o      (event_count_o),
      .event_from_o       (event_from_o),
      .event_tag_o        (event_tag_o),
      .event_given_o      (event_given),
      .event_use_o        (event_use),
      .reply_done_valid_o (reply_done_valid_o),
      .reply_done_block_o (reply_done_block_o),
      .late_o             (late_o)
  );

endmodule

`default_nettype wire

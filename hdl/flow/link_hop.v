// SPDX-License-Identifier: Apache-2.0
// One side of the link: UART, frames that come with their receive ring, frames that go. See link_receive.v,
// receive_ring.v and link_send.v.
`default_nettype none

module link_hop #(
    parameter integer DIVISOR = 16,
    parameter integer FROM_LOWER = 0  // 1: the side with the higher unit numbers
) (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire [ 3:0] unit_i,
    input  wire        bit_tick_i,
    // pins
    input  wire        rx_i,
    output wire        tx_o,
    // records that have come
    input  wire [ 1:0] find_class_i,
    output wire        found_o,
    input  wire        read_i,
    input  wire [ 6:0] read_index_i,
    output wire [ 7:0] read_data_o,
    input  wire        free_i,
    // frames to send
    output wire [ 1:0] lane_free_o,
    input  wire [ 1:0] lane_commit_i,
    input  wire [ 6:0] lane_length_i,
    output wire        lane_o,
    output wire [ 6:0] lane_index_o,
    input  wire [ 7:0] lane_data_i,
    // state and counters
    output wire        down_o,
    output wire [15:0] bad_o,
    output wire [15:0] full_o,
    output wire [15:0] again_o,
    output wire [15:0] lost_o
);

  wire line;
  wire rx_valid;
  wire [7:0] rx_data;
  wire rx_error;
  wire tx_valid;
  wire [7:0] tx_data;
  wire tx_ready;
  wire tx_busy;
  wire ring_begin;
  wire ring_write;
  wire [6:0] ring_index;
  wire [7:0] ring_data;
  wire ring_commit;
  wire [1:0] ring_class;
  wire any_room;
  wire request_room;
  wire answer_valid;
  wire [7:0] answer_head;
  wire answer_taken;
  wire ack_valid;
  wire [1:0] ack_code;
  wire ack_sequence;

  link_uart_rx #(
      .DIVISOR(DIVISOR)
  ) uart_rx (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .rx_i   (rx_i),
      .line_o (line),
      .valid_o(rx_valid),
      .data_o (rx_data),
      .error_o(rx_error)
  );

  link_receive #(
      .FROM_LOWER(FROM_LOWER)
  ) receive (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .unit_i        (unit_i),
      .bit_tick_i    (bit_tick_i),
      .line_i        (line),
      .byte_valid_i  (rx_valid),
      .byte_i        (rx_data),
      .byte_error_i  (rx_error),
      .begin_o       (ring_begin),
      .write_o       (ring_write),
      .write_index_o (ring_index),
      .write_data_o  (ring_data),
      .commit_o      (ring_commit),
      .commit_class_o(ring_class),
      .any_room_i    (any_room),
      .request_room_i(request_room),
      .answer_valid_o(answer_valid),
      .answer_head_o (answer_head),
      .answer_taken_i(answer_taken),
      .ack_valid_o   (ack_valid),
      .ack_code_o    (ack_code),
      .ack_sequence_o(ack_sequence),
      .bad_o         (bad_o),
      .full_o        (full_o)
  );

  receive_ring ring (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .begin_i       (ring_begin),
      .write_i       (ring_write),
      .write_index_i (ring_index),
      .write_data_i  (ring_data),
      .commit_i      (ring_commit),
      .commit_class_i(ring_class),
      .any_room_o    (any_room),
      .request_room_o(request_room),
      .find_class_i  (find_class_i),
      .found_o       (found_o),
      .read_i        (read_i),
      .read_index_i  (read_index_i),
      .read_data_o   (read_data_o),
      .free_i        (free_i)
  );

  link_send send (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .bit_tick_i    (bit_tick_i),
      .free_o        (lane_free_o),
      .commit_i      (lane_commit_i),
      .length_i      (lane_length_i),
      .read_lane_o   (lane_o),
      .read_index_o  (lane_index_o),
      .read_data_i   (lane_data_i),
      .byte_valid_o  (tx_valid),
      .byte_o        (tx_data),
      .byte_ready_i  (tx_ready),
      .byte_busy_i   (tx_busy),
      .answer_valid_i(answer_valid),
      .answer_head_i (answer_head),
      .answer_taken_o(answer_taken),
      .ack_valid_i   (ack_valid),
      .ack_code_i    (ack_code),
      .ack_sequence_i(ack_sequence),
      .down_o        (down_o),
      .again_o       (again_o),
      .lost_o        (lost_o)
  );

  link_uart_tx #(
      .DIVISOR(DIVISOR)
  ) uart_tx (
      .clk_i  (clk_i),
      .rst_ni (rst_ni),
      .valid_i(tx_valid),
      .data_i (tx_data),
      .ready_o(tx_ready),
      .busy_o (tx_busy),
      .tx_o   (tx_o)
  );

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// Who reads and writes devices beside the program, each in a phase of its own: what is loaded, the I/O list
// (latch, refresh), flow tasks, the host exchange; and the map from Modbus points to devices that the last two
// share. Gives the one access a clock to the processor's port.
`default_nettype none
`include "rung_controller.vh"

module device_accesses #(
    parameter integer INPUTS       = 32,
    parameter integer BIT_POINTS   = 1024,
    parameter integer WORD_POINTS  = 472,
    parameter integer BIT_DEVICES  = 1024,
    parameter integer WORD_DEVICES = 256
) (
    input  wire              clk_i,
    input  wire              rst_ni,
    // I/O list: io_list.v
    input  wire [       8:0] latch_count_i,
    input  wire [       7:0] refresh_first_i,
    input  wire [       8:0] refresh_count_i,
    input  wire              latch_i,
    input  wire              refresh_i,
    input  wire              refreshing_i,
    input  wire [INPUTS-1:0] pins_i,
    input  wire [      15:0] status_i,
    input  wire [      47:0] ticks_i,
    output wire [       2:0] adc_channel_o,
    input  wire [      15:0] adc_i,
    output wire              value_valid_o,
    output wire [       3:0] value_kind_o,
    output wire [       7:0] value_index_o,
    output wire [      15:0] value_o,
    output wire              forced_o,
    // exchange: host_exchange.v
    input  wire              exchange_i,
    input  wire              give_up_i,
    // flow tasks: the map, and accesses
    input  wire              flow_map_read_i,
    input  wire              flow_map_words_i,
    input  wire [      15:0] flow_map_point_i,
    output wire              map_mapped_o,
    output wire [      14:0] map_device_o,
    input  wire              flow_valid_i,
    input  wire              flow_write_i,
    input  wire              flow_words_i,
    input  wire [      14:0] flow_addr_i,
    input  wire [      15:0] flow_data_i,
    // what is loaded, always a write
    input  wire              load_valid_i,
    input  wire [       2:0] load_space_i,
    input  wire [      19:0] load_addr_i,
    input  wire [      15:0] load_data_i,
    // the processor's port
    output wire              host_valid_o,
    output wire              host_write_o,
    output wire [       2:0] host_space_o,
    output wire [      19:0] host_addr_o,
    output wire [      15:0] host_data_o,
    input  wire              host_rvalid_i,
    input  wire [      15:0] host_rdata_i,
    // list and map are loaded
    input  wire              io_write_i,
    input  wire              bit_map_write_i,
    input  wire              word_map_write_i,
    input  wire [      15:0] space_addr_i,
    input  wire [      15:0] space_data_i,
    // bus
    input  wire              sel_buffer_i,
    input  wire              sel_register_i,
    input  wire [       7:0] addr_i,
    input  wire              read_i,
    input  wire              write_i,
    input  wire [      15:0] wdata_i,
    output wire [      15:0] rdata_o
);

  localparam [2:0] SPACE_BITS = `RUNG_SPACE_BITS;
  localparam [2:0] SPACE_WORDS = `RUNG_SPACE_WORDS;

  wire list_valid;
  wire list_write;
  wire list_words;
  wire [14:0] list_addr;
  wire [15:0] list_data;
  wire exchange_valid;
  wire exchange_write;
  wire exchange_words;
  wire [14:0] exchange_addr;
  wire [15:0] exchange_data;
  wire exchange_map_read;
  wire exchange_map_words;
  wire [15:0] exchange_map_point;

  io_list #(
      .INPUTS(INPUTS)
  ) list (
      .clk_i          (clk_i),
      .rst_ni         (rst_ni),
      .latch_count_i  (latch_count_i),
      .refresh_first_i(refresh_first_i),
      .refresh_count_i(refresh_count_i),
      .latch_i        (latch_i),
      .refresh_i      (refresh_i),
      .refreshing_i   (refreshing_i),
      .pins_i         (pins_i),
      .status_i       (status_i),
      .ticks_i        (ticks_i),
      .adc_channel_o  (adc_channel_o),
      .adc_i          (adc_i),
      .host_valid_o   (list_valid),
      .host_write_o   (list_write),
      .host_words_o   (list_words),
      .host_addr_o    (list_addr),
      .host_data_o    (list_data),
      .host_rvalid_i  (host_rvalid_i),
      .host_rdata_i   (host_rdata_i),
      .value_valid_o  (value_valid_o),
      .value_kind_o   (value_kind_o),
      .value_index_o  (value_index_o),
      .value_o        (value_o),
      .forced_o       (forced_o),
      .write_i        (io_write_i),
      .write_addr_i   (space_addr_i[8:0]),
      .write_data_i   (space_data_i),
      .sel_register_i (sel_register_i),
      .bus_addr_i     (addr_i),
      .bus_write_i    (write_i),
      .bus_wdata_i    (wdata_i[9:0])
  );

  device_map #(
      .BIT_POINTS  (BIT_POINTS),
      .WORD_POINTS (WORD_POINTS),
      .BIT_DEVICES (BIT_DEVICES),
      .WORD_DEVICES(WORD_DEVICES)
  ) map (
      .clk_i       (clk_i),
      .read_i      (exchange_map_read || flow_map_read_i),
      .words_i     (flow_map_read_i ? flow_map_words_i : exchange_map_words),
      .point_i     (flow_map_read_i ? flow_map_point_i : exchange_map_point),
      .mapped_o    (map_mapped_o),
      .device_o    (map_device_o),
      .bit_write_i (bit_map_write_i),
      .word_write_i(word_map_write_i),
      .write_addr_i(space_addr_i),
      .write_data_i(space_data_i)
  );

  host_exchange exchange (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .start_i       (exchange_i),
      .restart_i     (give_up_i),
      .map_read_o    (exchange_map_read),
      .map_words_o   (exchange_map_words),
      .map_point_o   (exchange_map_point),
      .map_mapped_i  (map_mapped_o),
      .map_device_i  (map_device_o),
      .host_valid_o  (exchange_valid),
      .host_write_o  (exchange_write),
      .host_words_o  (exchange_words),
      .host_addr_o   (exchange_addr),
      .host_data_o   (exchange_data),
      .host_rvalid_i (host_rvalid_i),
      .host_rdata_i  (host_rdata_i),
      .sel_buffer_i  (sel_buffer_i),
      .sel_register_i(sel_register_i),
      .addr_i        (addr_i),
      .read_i        (read_i),
      .write_i       (write_i),
      .wdata_i       (wdata_i),
      .rdata_o       (rdata_o)
  );

  // Phases do not overlap, so at most one of the four has an access.
  wire from_load = !list_valid && !exchange_valid && !flow_valid_i;
  wire words = list_valid ? list_words : flow_valid_i ? flow_words_i : exchange_words;
  wire write = list_valid ? list_write : flow_valid_i ? flow_write_i : exchange_write;
  wire [14:0] addr = list_valid ? list_addr : flow_valid_i ? flow_addr_i : exchange_addr;
  assign host_valid_o = !from_load || load_valid_i;
  assign host_write_o = from_load || write;
  assign host_space_o = from_load ? load_space_i : words ? SPACE_WORDS : SPACE_BITS;
  assign host_addr_o = from_load ? load_addr_i : {5'd0, addr};
  assign host_data_o = from_load ? load_data_i :
      list_valid ? list_data : flow_valid_i ? flow_data_i : exchange_data;

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// A controller without its micro-sequencer: everything on its bus (hdl/isa/controller.toml, README.md). The
// bytes of the host's line are ports (host_uart.v).
`default_nettype none
`include "rung_controller.vh"

module controller_bus #(
    parameter integer MPU           = 2,                // 1, 2 or 3
    parameter integer CLOCK_HZ      = 12000000,         // of clk_i
    parameter integer CLOCKS_PER_MS = CLOCK_HZ / 1000,
    // configuration and board: `RUNG_<CONFIG>_MAP, `RUNG_BOARD_<NAME>
    parameter integer CONFIG_ID     = 2,
    parameter integer BIT_POINTS    = 1024,
    parameter integer WORD_POINTS   = 472,
    parameter integer BOARD_ID      = 0,
    parameter integer INPUTS        = 32,
    parameter integer OUTPUTS       = 32,
    parameter integer FLASH_BASE    = 0,
    parameter integer FLOW          = 0,                // 1: with flow tasks (hdl/flow)
    // the processor's own
    parameter integer STEPS         = 512,
    parameter integer BIT_DEVICES   = 1024,
    parameter integer WORD_DEVICES  = 256,
    parameter integer MUL_DSP       = 0,
    parameter integer MUL_LATENCY   = 18,
    parameter integer DIV_LATENCY   = 19,
    parameter integer MUL32_LATENCY = 34,
    parameter integer DIV32_LATENCY = 37
) (
    input  wire               clk_i,
    input  wire               rst_ni,
    // pins
    input  wire [ INPUTS-1:0] in_i,
    output wire [OUTPUTS-1:0] out_o,
    input  wire [      127:0] adc_i,
    output wire               pwm_o,
    input  wire               rx_i,
    output wire               tx_o,
    output wire               flash_csn_o,
    output wire               flash_sck_o,
    output wire               flash_mosi_o,
    input  wire               flash_miso_i,
    input  wire               run_switch_i,
    // lines of flow tasks
    // verilator lint_off UNUSEDSIGNAL
    input  wire               upper_rx_i,
    input  wire               lower_rx_i,
    input  wire               panel_rx_i,
    // verilator lint_on UNUSEDSIGNAL
    output wire               upper_tx_o,
    output wire               lower_tx_o,
    output wire               panel_tx_o,
    output wire               panel_de_o,
    // lamps
    output wire               run_o,
    output wire               fault_o,
    output wire               forced_o,
    output wire               line_o,
    // bytes of the host's line
    output wire [       19:0] baud_step_o,
    output wire [        1:0] parity_o,
    input  wire               host_rx_active_i,
    input  wire               host_rx_valid_i,
    input  wire [        7:0] host_rx_data_i,
    input  wire               host_rx_error_i,
    output wire               host_tx_valid_o,
    output wire [        7:0] host_tx_data_o,
    input  wire               host_tx_ready_i,
    input  wire               host_tx_busy_i,
    // bus: data of a read in the next clock
    input  wire [       15:0] mem_addr_i,
    input  wire               mem_read_i,
    input  wire               mem_write_i,
    input  wire [       15:0] mem_wdata_i,
    output wire [       15:0] mem_rdata_o
);

  localparam [15:0] RX_FRAME = `RUNG_MICRO_RX_FRAME;
  localparam [15:0] TX_FRAME = `RUNG_MICRO_TX_FRAME;
  localparam [15:0] BUFFER = `RUNG_MICRO_EXCHANGE_BUFFER;
  localparam [15:0] REGISTERS = `RUNG_MICRO_REGISTERS;
  localparam [3:0] REFRESH_PIN = `RUNG_REFRESH_PIN;
  localparam [3:0] REFRESH_PWM = `RUNG_REFRESH_PWM;

  // ---- bus -------------------------------------------------------------------------------------
  wire sel_rx_frame = mem_addr_i[15:8] == RX_FRAME[15:8];
  wire sel_tx_frame = mem_addr_i[15:8] == TX_FRAME[15:8];
  wire sel_buffer = mem_addr_i[15:8] == BUFFER[15:8];
  wire sel_register = mem_addr_i[15:8] == REGISTERS[15:8];
  wire [7:0] addr = mem_addr_i[7:0];
  wire [15:0] line_rdata;
  wire [15:0] flash_rdata;
  wire [15:0] crc_rdata;
  wire [15:0] exchange_rdata;
  wire [15:0] scan_rdata;
  wire [15:0] statistics_rdata;
  wire [15:0] input_rdata;
  wire [15:0] output_rdata;
  wire [15:0] keep_rdata;
  wire [15:0] flow_rdata;
  wire [15:0] milliseconds;

  // Registers that are constants, and the firmware's clock.
  reg [15:0] constant_rdata_q;
  always @(posedge clk_i) begin
    constant_rdata_q <= 16'd0;
    if (sel_register && mem_read_i) begin
      case (addr)
        `RUNG_REG_MILLISECONDS: constant_rdata_q <= milliseconds;
        `RUNG_REG_BOARD_ID: constant_rdata_q <= BOARD_ID[15:0];
        `RUNG_REG_CONFIG_ID: constant_rdata_q <= CONFIG_ID[15:0];
        `RUNG_REG_MPU: constant_rdata_q <= MPU[15:0];
        `RUNG_REG_FLASH_BASE: constant_rdata_q <= FLASH_BASE[15:0];
        default: ;
      endcase
    end
  end

  assign mem_rdata_o = line_rdata | flash_rdata | crc_rdata | exchange_rdata | scan_rdata |
      statistics_rdata | input_rdata | output_rdata | keep_rdata | flow_rdata | constant_rdata_q;

  rtu_line #(
      .CLOCK_HZ(CLOCK_HZ)
  ) line (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .sel_rx_frame_i(sel_rx_frame),
      .sel_tx_frame_i(sel_tx_frame),
      .sel_register_i(sel_register),
      .addr_i        (addr),
      .read_i        (mem_read_i),
      .write_i       (mem_write_i),
      .wdata_i       (mem_wdata_i),
      .rdata_o       (line_rdata),
      .baud_step_o   (baud_step_o),
      .parity_o      (parity_o),
      .rx_active_i   (host_rx_active_i),
      .rx_valid_i    (host_rx_valid_i),
      .rx_data_i     (host_rx_data_i),
      .rx_error_i    (host_rx_error_i),
      .tx_valid_o    (host_tx_valid_o),
      .tx_data_o     (host_tx_data_o),
      .tx_ready_i    (host_tx_ready_i),
      .tx_busy_i     (host_tx_busy_i),
      .active_o      (line_o)
  );

  flash_port flash (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .csn_o         (flash_csn_o),
      .sck_o         (flash_sck_o),
      .mosi_o        (flash_mosi_o),
      .miso_i        (flash_miso_i),
      .sel_register_i(sel_register),
      .addr_i        (addr),
      .read_i        (mem_read_i),
      .write_i       (mem_write_i),
      .wdata_i       (mem_wdata_i),
      .rdata_o       (flash_rdata)
  );

  crc32 crc (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .sel_register_i(sel_register),
      .addr_i        (addr),
      .read_i        (mem_read_i),
      .write_i       (mem_write_i),
      .wdata_i       (mem_wdata_i),
      .rdata_o       (crc_rdata)
  );

  // ---- what is loaded --------------------------------------------------------------------------
  wire idle;
  wire restore;
  wire load_host_valid;
  wire [2:0] load_host_space;
  wire [19:0] load_host_addr;
  wire [15:0] load_host_data;
  wire io_write;
  wire bit_map_write;
  wire word_map_write;
  wire setup_write;
  // verilator lint_off UNUSEDSIGNAL
  wire [3:0] flow_write;
  // verilator lint_on UNUSEDSIGNAL
  wire [15:0] space_addr;
  wire [15:0] space_data;

  load_spaces spaces (
      .clk_i           (clk_i),
      .rst_ni          (rst_ni),
      .idle_i          (idle),
      .restore_i       (restore),
      .host_valid_o    (load_host_valid),
      .host_space_o    (load_host_space),
      .host_addr_o     (load_host_addr),
      .host_data_o     (load_host_data),
      .io_write_o      (io_write),
      .bit_map_write_o (bit_map_write),
      .word_map_write_o(word_map_write),
      .setup_write_o   (setup_write),
      .flow_write_o    (flow_write),
      .addr_o          (space_addr),
      .data_o          (space_data),
      .sel_register_i  (sel_register),
      .addr_i          (addr),
      .write_i         (mem_write_i),
      .wdata_i         (mem_wdata_i)
  );

  wire [8:0] latch_count;
  wire [7:0] refresh_first;
  wire [8:0] refresh_count;
  wire [11:0] exchange_points;
  wire [31:0] period;
  wire [31:0] watchdog;
  wire [15:0] filter_clocks;
  wire [31:0] pwm_hz;
  wire [23:0] adc_route;
  wire [5*INPUTS-1:0] filter_setup;
  wire [3*OUTPUTS-1:0] output_setup;

  setup_registers #(
      .INPUTS (INPUTS),
      .OUTPUTS(OUTPUTS)
  ) setup (
      .clk_i            (clk_i),
      .rst_ni           (rst_ni),
      .write_i          (setup_write),
      .addr_i           (space_addr[7:0]),
      .data_i           (space_data),
      .latch_count_o    (latch_count),
      .refresh_first_o  (refresh_first),
      .refresh_count_o  (refresh_count),
      .exchange_points_o(exchange_points),
      .period_o         (period),
      .watchdog_o       (watchdog),
      .filter_clocks_o  (filter_clocks),
      .pwm_hz_o         (pwm_hz),
      .adc_route_o      (adc_route),
      .filter_o         (filter_setup),
      .output_o         (output_setup)
  );

  // ---- scans -----------------------------------------------------------------------------------
  wire millisecond;
  wire run_switch;
  wire latch;
  wire first;
  wire scan;
  wire done;
  wire error;
  wire scanning;
  wire refresh;
  wire refreshing;
  wire refresh_end;
  wire exchange_start;
  wire give_up;
  wire safe;
  wire core_rst_n;
  wire counted;
  wire [31:0] clocks;
  wire overrun;
  wire clear;

  run_switch debounce (
      .clk_i        (clk_i),
      .rst_ni       (rst_ni),
      .pin_i        (run_switch_i),
      .millisecond_i(millisecond),
      .run_o        (run_switch)
  );

  scan_controller scans (
      .clk_i            (clk_i),
      .rst_ni           (rst_ni),
      .latch_count_i    (latch_count),
      .refresh_count_i  (refresh_count),
      .exchange_points_i(exchange_points),
      .period_i         (period),
      .watchdog_i       (watchdog),
      .run_switch_i     (run_switch),
      .latch_o          (latch),
      .first_o          (first),
      .scan_o           (scan),
      .done_i           (done),
      .error_i          (error),
      .scanning_o       (scanning),
      .refresh_o        (refresh),
      .refreshing_o     (refreshing),
      .refresh_end_o    (refresh_end),
      .exchange_o       (exchange_start),
      .give_up_o        (give_up),
      .active_o         (run_o),
      .fault_o          (fault_o),
      .safe_o           (safe),
      .idle_o           (idle),
      .core_rst_no      (core_rst_n),
      .restore_o        (restore),
      .counted_o        (counted),
      .clocks_o         (clocks),
      .overrun_o        (overrun),
      .clear_o          (clear),
      .sel_register_i   (sel_register),
      .addr_i           (addr),
      .read_i           (mem_read_i),
      .write_i          (mem_write_i),
      .wdata_i          (mem_wdata_i),
      .rdata_o          (scan_rdata)
  );

  scan_statistics statistics (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .counted_i     (counted),
      .clocks_i      (clocks),
      .overrun_i     (overrun),
      .clear_i       (clear),
      .sel_register_i(sel_register),
      .addr_i        (addr),
      .read_i        (mem_read_i),
      .rdata_o       (statistics_rdata)
  );

  // ---- time, inputs, outputs -------------------------------------------------------------------
  wire [47:0] ticks;
  wire [5:0] relays;
  wire [INPUTS-1:0] inputs;
  wire [127:0] adc_held;
  wire value_valid;
  wire [3:0] value_kind;
  wire [7:0] value_index;
  wire [15:0] value;
  reg first_q;  // of the scan under way

  always @(posedge clk_i) if (latch) first_q <= first;

  wire [15:0] status = {6'd0, relays, !first_q, first_q, 1'b1, 1'b0};

  time_base #(
      .CLOCKS_PER_MS(CLOCKS_PER_MS)
  ) time_base (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .capture_i     (latch),
      .first_i       (first),
      .ticks_o       (ticks),
      .relays_o      (relays),
      .millisecond_o (millisecond),
      .milliseconds_o(milliseconds)
  );

  input_pins #(
      .INPUTS(INPUTS)
  ) input_pins (
      .clk_i          (clk_i),
      .rst_ni         (rst_ni),
      .in_i           (in_i),
      .adc_i          (adc_i),
      .filter_clocks_i(filter_clocks),
      .filter_i       (filter_setup),
      .latch_i        (latch),
      .held_o         (inputs),
      .adc_held_o     (adc_held),
      .sel_register_i (sel_register),
      .addr_i         (addr),
      .read_i         (mem_read_i),
      .rdata_o        (input_rdata)
  );

  output_pins #(
      .OUTPUTS(OUTPUTS)
  ) output_pins (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .out_o         (out_o),
      .setup_i       (output_setup),
      .begin_i       (refresh),
      .value_valid_i (value_valid && value_kind == REFRESH_PIN),
      .value_pin_i   (value_index),
      .value_i       (value[0]),
      .end_i         (refresh_end),
      .safe_i        (safe),
      .sel_register_i(sel_register),
      .addr_i        (addr),
      .read_i        (mem_read_i),
      .rdata_o       (output_rdata)
  );

  wire pwm_on;
  wire duty_valid;
  wire [15:0] duty;

  pwm_entry pwm_entry (
      .clk_i        (clk_i),
      .rst_ni       (rst_ni),
      .begin_i      (refresh),
      .value_valid_i(value_valid && value_kind == REFRESH_PWM),
      .value_i      (value),
      .end_i        (refresh_end),
      .safe_i       (safe),
      .on_o         (pwm_on),
      .duty_valid_o (duty_valid),
      .duty_o       (duty)
  );

  // ---- devices: lists, exchange, flow tasks --------------------------------------------------------
  wire ladder;
  wire ladder_done;
  wire [2:0] adc_channel;
  wire [15:0] latch_sample;
  wire [15:0] port_sample;
  wire flow_map_read;
  wire flow_map_words;
  wire [15:0] flow_map_point;
  // verilator lint_off UNUSEDSIGNAL
  wire map_mapped;
  wire [14:0] map_device;
  // verilator lint_on UNUSEDSIGNAL
  wire flow_valid;
  wire flow_access_write;
  wire flow_words;
  wire [14:0] flow_addr;
  wire [15:0] flow_data;
  wire host_valid;
  wire host_write;
  wire [2:0] host_space;
  wire [19:0] host_addr;
  wire [15:0] host_data;
  wire host_rvalid;
  wire [15:0] host_rdata;

  adc_select adc_select (
      .clk_i          (clk_i),
      .adc_i          (adc_held),
      .route_i        (adc_route),
      .latch_channel_i(adc_channel),
      .latch_sample_o (latch_sample),
      .scan_i         (ladder),
      .scanning_i     (scanning),
      .port_sample_o  (port_sample)
  );

  device_accesses #(
      .INPUTS      (INPUTS),
      .BIT_POINTS  (BIT_POINTS),
      .WORD_POINTS (WORD_POINTS),
      .BIT_DEVICES (BIT_DEVICES),
      .WORD_DEVICES(WORD_DEVICES)
  ) accesses (
      .clk_i           (clk_i),
      .rst_ni          (rst_ni),
      .latch_count_i   (latch_count),
      .refresh_first_i (refresh_first),
      .refresh_count_i (refresh_count),
      .latch_i         (latch),
      .refresh_i       (refresh),
      .refreshing_i    (refreshing),
      .pins_i          (inputs),
      .status_i        (status),
      .ticks_i         (ticks),
      .adc_channel_o   (adc_channel),
      .adc_i           (latch_sample),
      .value_valid_o   (value_valid),
      .value_kind_o    (value_kind),
      .value_index_o   (value_index),
      .value_o         (value),
      .forced_o        (forced_o),
      .exchange_i      (exchange_start),
      .give_up_i       (give_up),
      .flow_map_read_i (flow_map_read),
      .flow_map_words_i(flow_map_words),
      .flow_map_point_i(flow_map_point),
      .map_mapped_o    (map_mapped),
      .map_device_o    (map_device),
      .flow_valid_i    (flow_valid),
      .flow_write_i    (flow_access_write),
      .flow_words_i    (flow_words),
      .flow_addr_i     (flow_addr),
      .flow_data_i     (flow_data),
      .load_valid_i    (load_host_valid),
      .load_space_i    (load_host_space),
      .load_addr_i     (load_host_addr),
      .load_data_i     (load_host_data),
      .host_valid_o    (host_valid),
      .host_write_o    (host_write),
      .host_space_o    (host_space),
      .host_addr_o     (host_addr),
      .host_data_o     (host_data),
      .host_rvalid_i   (host_rvalid),
      .host_rdata_i    (host_rdata),
      .io_write_i      (io_write),
      .bit_map_write_i (bit_map_write),
      .word_map_write_i(word_map_write),
      .space_addr_i    (space_addr),
      .space_data_i    (space_data),
      .sel_buffer_i    (sel_buffer),
      .sel_register_i  (sel_register),
      .addr_i          (addr),
      .read_i          (mem_read_i),
      .write_i         (mem_write_i),
      .wdata_i         (mem_wdata_i),
      .rdata_o         (exchange_rdata)
  );

  // ---- the program -----------------------------------------------------------------------------
  wire persist_ready;
  wire keep_valid;
  wire [5:0] keep_index;
  wire [15:0] keep_value;
  wire ladder_start;
  wire step_start;
  wire [15:0] step_entry;
  wire [15:0] step_end;
  // verilator lint_off UNUSEDSIGNAL
  wire [1:0] core_write_valid;
  wire [31:0] core_write_addr;
  wire [31:0] core_write_data;
  // verilator lint_on UNUSEDSIGNAL
  wire core_done;
  wire load_valid;
  wire load_write;
  wire [2:0] load_space;
  wire [19:0] load_addr;
  wire [15:0] load_data;
  wire load_rvalid;
  wire [15:0] load_rdata;

  keep_port keep (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .ready_o       (persist_ready),
      .keep_valid_i  (keep_valid),
      .keep_index_i  (keep_index),
      .keep_value_i  (keep_value),
      .sel_register_i(sel_register),
      .addr_i        (addr),
      .read_i        (mem_read_i),
      .write_i       (mem_write_i),
      .wdata_i       (mem_wdata_i),
      .rdata_o       (keep_rdata)
  );

  ladder_ports #(
      .BIT_DEVICES (BIT_DEVICES),
      .WORD_DEVICES(WORD_DEVICES),
      .CLOCK_HZ    (CLOCK_HZ)
  ) ports (
      .clk_i          (clk_i),
      .rst_ni         (rst_ni),
      .exchange_rst_ni(core_rst_n),
      .rx_i           (rx_i),
      .tx_o           (tx_o),
      .pwm_o          (pwm_o),
      .pwm_on_i       (pwm_on),
      .duty_valid_i   (duty_valid),
      .duty_i         (duty),
      .hz_i           (pwm_hz),
      .adc_i          ({8{port_sample}}),
      .persist_ready_i(persist_ready),
      .keep_valid_o   (keep_valid),
      .keep_index_o   (keep_index),
      .keep_value_o   (keep_value),
      .scan_i         (ladder),
      // verilator lint_off PINCONNECTEMPTY
      .busy_o         (),
      // verilator lint_on PINCONNECTEMPTY
      .done_o         (ladder_done),
      .host_valid_i   (host_valid),
      .host_write_i   (host_write),
      .host_space_i   (host_space),
      .host_addr_i    (host_addr),
      .host_data_i    (host_data),
      .host_rvalid_o  (host_rvalid),
      .host_rdata_o   (host_rdata),
      .start_o        (ladder_start),
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
      .MPU          (MPU),
      .STEPS        (STEPS),
      .BIT_DEVICES  (BIT_DEVICES),
      .WORD_DEVICES (WORD_DEVICES),
      .MUL_DSP      (MUL_DSP),
      .MUL_LATENCY  (MUL_LATENCY),
      .DIV_LATENCY  (DIV_LATENCY),
      .MUL32_LATENCY(MUL32_LATENCY),
      .DIV32_LATENCY(DIV32_LATENCY)
  ) mpu (
      .clk_i        (clk_i),
      .rst_ni       (core_rst_n),
      .start_i      (ladder_start || step_start),
      .done_o       (core_done),
      .error_o      (error),
      // verilator lint_off PINCONNECTEMPTY
      .clocks_o     (),
      // verilator lint_on PINCONNECTEMPTY
      .range_i      (step_start),
      .entry_i      (step_entry),
      .end_i        (step_end),
      .write_valid_o(core_write_valid),
      .write_addr_o (core_write_addr),
      .write_data_o (core_write_data),
      .load_valid_i (load_valid),
      .load_write_i (load_write),
      .load_space_i (load_space),
      .load_addr_i  (load_addr),
      .load_data_i  (load_data),
      .load_rvalid_o(load_rvalid),
      .load_rdata_o (load_rdata)
  );

  // ---- flow tasks: a round of them around the ladder's scan --------------------------------------
  generate
    if (FLOW != 0) begin : gen_flow
      flow_block #(
          .CLOCK_HZ   (CLOCK_HZ),
          .WORD_POINTS(WORD_POINTS)
      ) flow (
          .clk_i         (clk_i),
          .rst_ni        (rst_ni),
          .millisecond_i (millisecond),
          .first_i       (latch && first),
          .give_up_i     (give_up),
          .round_i       (scan),
          .round_done_o  (done),
          .ladder_o      (ladder),
          .ladder_done_i (ladder_done),
          .start_o       (step_start),
          .entry_o       (step_entry),
          .end_o         (step_end),
          .done_i        (core_done),
          .write_valid_i (core_write_valid),
          .write_addr_i  (core_write_addr),
          .write_data_i  (core_write_data),
          .map_read_o    (flow_map_read),
          .map_words_o   (flow_map_words),
          .map_point_o   (flow_map_point),
          .map_mapped_i  (map_mapped),
          .map_device_i  (map_device),
          .host_valid_o  (flow_valid),
          .host_write_o  (flow_access_write),
          .host_words_o  (flow_words),
          .host_addr_o   (flow_addr),
          .host_data_o   (flow_data),
          .host_rvalid_i (host_rvalid),
          .host_rdata_i  (host_rdata),
          .load_write_i  (flow_write),
          .load_addr_i   (space_addr),
          .load_data_i   (space_data),
          .sel_register_i(sel_register),
          .addr_i        (addr),
          .read_i        (mem_read_i),
          .write_i       (mem_write_i),
          .wdata_i       (mem_wdata_i),
          .rdata_o       (flow_rdata),
          .upper_rx_i    (upper_rx_i),
          .upper_tx_o    (upper_tx_o),
          .lower_rx_i    (lower_rx_i),
          .lower_tx_o    (lower_tx_o),
          .panel_rx_i    (panel_rx_i),
          .panel_tx_o    (panel_tx_o),
          .panel_de_o    (panel_de_o)
      );
    end else begin : gen_no_flow
      assign ladder = scan;
      assign done = ladder_done;
      assign step_start = 1'b0;
      assign step_entry = 16'd0;
      assign step_end = 16'd0;
      assign flow_map_read = 1'b0;
      assign flow_map_words = 1'b0;
      assign flow_map_point = 16'd0;
      assign flow_valid = 1'b0;
      assign flow_access_write = 1'b0;
      assign flow_words = 1'b0;
      assign flow_addr = 15'd0;
      assign flow_data = 16'd0;
      assign flow_rdata = 16'd0;
      assign upper_tx_o = 1'b1;
      assign lower_tx_o = 1'b1;
      assign panel_tx_o = 1'b1;
      assign panel_de_o = 1'b0;
    end
  endgenerate

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// The controller without its micro-sequencer, whose bus is ports here (README.md): processor, device ports,
// scan side, host line and flash put together, and the registers of controller.toml decoded. The host line is met at its bytes.
`default_nettype none
`include "rung_controller.vh"

module controller_bus #(
    parameter integer MPU           = 3,
    parameter integer CLOCK_HZ      = 25000000,
    parameter integer CLOCKS_PER_MS = CLOCK_HZ / 1000,
    parameter integer CONFIG_ID     = 1,
    parameter integer BIT_POINTS    = 1024,
    parameter integer WORD_POINTS   = 512,
    parameter integer BOARD_ID      = 0,
    parameter integer INPUTS        = 32,  // at most 64
    parameter integer OUTPUTS       = 32,  // at most 64
    parameter integer FLASH_BASE    = 0,
    parameter integer STEPS         = 256,
    parameter integer BIT_DEVICES   = 1024,
    parameter integer WORD_DEVICES  = 256,
    parameter integer MUL_DSP       = 0,
    parameter integer MUL_LATENCY   = 20,
    parameter integer DIV_LATENCY   = 20,
    parameter integer MUL32_LATENCY = 40,
    parameter integer DIV32_LATENCY = 40
) (
    input  wire               clk_i,
    input  wire               rst_ni,
    // the micro-sequencer's bus
    input  wire [       15:0] mem_addr_i,
    input  wire               mem_read_i,
    input  wire               mem_write_i,
    input  wire [       15:0] mem_wdata_i,
    output wire [       15:0] mem_rdata_o,
    // pins of the plant
    input  wire [ INPUTS-1:0] in_i,
    output wire [OUTPUTS-1:0] out_o,
    input  wire [      127:0] adc_i,
    output wire               pwm_o,
    input  wire               rx_i,
    output wire               tx_o,
    // bytes of the host line
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
    // flash
    output wire               flash_csn_o,
    output wire               flash_sck_o,
    output wire               flash_mosi_o,
    input  wire               flash_miso_i,
    // operation
    input  wire               run_switch_i,
    output wire               run_o,
    output wire               fault_o,
    output wire               forced_o,
    output wire               line_o
);

  localparam integer BIT_ADDR = $clog2(BIT_DEVICES);
  localparam integer WORD_ADDR = $clog2(WORD_DEVICES);
  localparam [2:0] SPACE_BITS = `RUNG_SPACE_BITS;
  localparam [2:0] SPACE_WORDS = `RUNG_SPACE_WORDS;
  localparam [2:0] SPACE_LENGTH = `RUNG_SPACE_LENGTH;
  // From a device access to its answer: port_exchange.v.
  localparam integer ANSWER_CLOCKS = 8;
  localparam [2:0] SWITCH_SAMPLES = 3'd5;  // milliseconds that the RUN switch has to be steady

  // ---- the bus ---------------------------------------------------------------------------------------
  wire [7:0] number = mem_addr_i[7:0];
  wire sel_rx_frame = mem_addr_i[15:8] == 8'h20;
  wire sel_tx_frame = mem_addr_i[15:8] == 8'h21;
  wire sel_buffer = mem_addr_i[15:12] == 4'h3;
  wire sel_register = mem_addr_i[15:12] == 4'h4;
  wire write = mem_write_i && sel_register;
  wire unused_addr = &{1'b0, mem_addr_i[11:8]};

  wire [15:0] line_rdata, flash_rdata, crc_rdata, buffer_rdata;
  reg [15:0] register_q;
  reg buffer_selected_q;
  always @(posedge clk_i) buffer_selected_q <= mem_read_i && sel_buffer;
  assign mem_rdata_o = line_rdata | flash_rdata | crc_rdata | register_q |
      (buffer_selected_q ? buffer_rdata : 16'd0);

  // ---- loading -----------------------------------------------------------------------------------------
  reg [3:0] load_space_q;
  reg [19:0] load_addr_q;
  wire load = write && number == `RUNG_REG_LOAD_DATA;
  always @(posedge clk_i) begin
    if (write && number == `RUNG_REG_LOAD_SPACE) begin
      load_space_q <= mem_wdata_i[3:0];
      load_addr_q[19:16] <= mem_wdata_i[11:8];
    end else if (write && number == `RUNG_REG_LOAD_ADDRESS) begin
      load_addr_q[15:0] <= mem_wdata_i;
    end else if (load) begin
      load_addr_q <= load_addr_q + 20'd1;
    end
  end
  wire load_processor = load && load_space_q <= `RUNG_SPACE_PORTS;
  wire load_setup = load && load_space_q == `RUNG_SPACE_SETUP;

  // ---- setup, pins, time ---------------------------------------------------------------------------------
  wire [8:0] latch_count, refresh_count;
  wire [7:0] refresh_first;
  wire [11:0] exchange_points;
  wire [31:0] period, watchdog, pwm_hz;
  wire [15:0] filter_clocks;
  wire [23:0] adc_route;
  wire [4*INPUTS-1:0] filter_samples;
  wire [INPUTS-1:0] invert_in;
  wire [OUTPUTS-1:0] safe, hold, invert_out;

  controller_setup #(
      .INPUTS (INPUTS),
      .OUTPUTS(OUTPUTS)
  ) setup (
      .clk_i            (clk_i),
      .rst_ni           (rst_ni),
      .write_i          (load_setup),
      .addr_i           (load_addr_q[7:0]),
      .data_i           (mem_wdata_i),
      .latch_count_o    (latch_count),
      .refresh_first_o  (refresh_first),
      .refresh_count_o  (refresh_count),
      .exchange_points_o(exchange_points),
      .period_o         (period),
      .watchdog_o       (watchdog),
      .filter_clocks_o  (filter_clocks),
      .pwm_hz_o         (pwm_hz),
      .adc_route_o      (adc_route),
      .filter_samples_o (filter_samples),
      .invert_in_o      (invert_in),
      .safe_o           (safe),
      .hold_o           (hold),
      .invert_out_o     (invert_out)
  );

  reg [15:0] sample_clock_q;
  reg sample_q;
  always @(posedge clk_i) begin
    sample_q <= rst_ni && sample_clock_q == 16'd0;
    sample_clock_q <= !rst_ni || sample_clock_q == 16'd0 ? filter_clocks : sample_clock_q - 16'd1;
  end

  wire [INPUTS-1:0] levels;
  genvar n;
  generate
    for (n = 0; n < INPUTS; n = n + 1) begin : gen_input
      input_filter filter (
          .clk_i    (clk_i),
          .rst_ni   (rst_ni),
          .sample_i (sample_q),
          .samples_i(filter_samples[4*n+:4]),
          .invert_i (invert_in[n]),
          .pin_i    (in_i[n]),
          .level_o  (levels[n])
      );
    end
  endgenerate

  wire latch, first, next_first;
  wire [15:0] ticks_1, ticks_10, ticks_100, milliseconds;
  wire [5:0] relays;
  wire millisecond;

  time_base #(
      .CLOCKS_PER_MS(CLOCKS_PER_MS)
  ) time_base (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .latch_i       (latch),
      .first_i       (first),
      .ticks_1_o     (ticks_1),
      .ticks_10_o    (ticks_10),
      .ticks_100_o   (ticks_100),
      .relays_o      (relays),
      .milliseconds_o(milliseconds),
      .millisecond_o (millisecond)
  );

  wire run_switch;
  input_filter switch (
      .clk_i    (clk_i),
      .rst_ni   (rst_ni),
      .sample_i (millisecond),
      .samples_i({1'b0, SWITCH_SAMPLES}),
      .invert_i (1'b0),
      .pin_i    (run_switch_i),
      .level_o  (run_switch)
  );

  // What a scan sees of the inputs.
  reg [63:0] held_q;
  reg [127:0] adc_q;
  reg [9:0] status_q;
  always @(posedge clk_i) begin
    if (latch) begin
      held_q <= {{64 - INPUTS{1'b0}}, levels};
      adc_q  <= adc_i;
      status_q[3:0] <= {!first, first, 1'b1, 1'b0};
    end
    status_q[9:4] <= relays;
  end

  // ---- scans ----------------------------------------------------------------------------------------------
  wire list_done, scan, ports_done, refresh, phase, phase_done;
  wire running, idle, fault;
  wire [7:0] fault_number;
  wire [1:0] state;
  wire [31:0] scans, last, min, max;
  wire [15:0] overruns;

  scan_controller scan_controller (
      .clk_i           (clk_i),
      .rst_ni          (rst_ni),
      .command_i       (write && number == `RUNG_REG_SCAN_COMMAND),
      .command_number_i(mem_wdata_i[2:0]),
      .first_i         (write && number == `RUNG_REG_SCAN_FIRST),
      .fault_set_i     (write && number == `RUNG_REG_FAULT_SET),
      .period_i        (period),
      .watchdog_i      (watchdog),
      .run_switch_i    (run_switch),
      .latch_o         (latch),
      .latch_done_i    (list_done),
      .scan_o          (scan),
      .scan_done_i     (ports_done && !scan),
      .refresh_o       (refresh),
      .refresh_done_i  (list_done),
      .exchange_o      (phase),
      .exchange_done_i (phase_done),
      .running_o       (running),
      .idle_o          (idle),
      .fault_o         (fault),
      .fault_number_o  (fault_number),
      .state_o         (state),
      .next_first_o    (next_first),
      .first_o         (first),
      .scans_o         (scans),
      .last_o          (last),
      .min_o           (min),
      .max_o           (max),
      .overruns_o      (overruns)
  );

  // A fault holds the processor in reset; what the reset takes away is given back after it.
  reg scan_rst_n_q;
  reg [15:0] length_q;
  reg [3:0] restore_q;
  always @(posedge clk_i) begin
    scan_rst_n_q <= rst_ni && !fault;
    if (load_processor && load_space_q[2:0] == SPACE_LENGTH) length_q <= mem_wdata_i;
    restore_q <= fault ? 4'd15 : restore_q == 4'd0 ? 4'd0 : restore_q - 4'd1;
  end
  wire restore_length = restore_q == 4'd1 && rst_ni;

  wire io_valid, io_write, io_word;
  wire [15:0] io_addr, io_data;
  wire answer_valid;
  wire [15:0] answer_data;
  wire pin_valid, pin_level, duty_valid;
  wire [5:0] pin;
  wire [15:0] duty;

  io_list #(
      .ANSWER_CLOCKS(ANSWER_CLOCKS),
      .ADDR_BITS    (BIT_ADDR > WORD_ADDR ? BIT_ADDR : WORD_ADDR)
  ) io_list (
      .clk_i          (clk_i),
      .rst_ni         (scan_rst_n_q),
      .list_write_i   (load && load_space_q == `RUNG_SPACE_IO),
      .list_addr_i    (load_addr_q[8:0]),
      .list_data_i    (mem_wdata_i),
      .force_write_i  (write && number == `RUNG_REG_FORCE_ENTRY),
      .force_entry_i  (mem_wdata_i[7:0]),
      .force_data_i   (mem_wdata_i[9:8]),
      .latch_count_i  (latch_count),
      .refresh_first_i(refresh_first),
      .refresh_count_i(refresh_count),
      .latch_i        (latch),
      .refresh_i      (refresh),
      .done_o         (list_done),
      .pins_i         (held_q),
      .status_i       (status_q),
      .ticks_1_i      (ticks_1),
      .ticks_10_i     (ticks_10),
      .ticks_100_i    (ticks_100),
      .adc_i          (adc_q),
      .access_valid_o (io_valid),
      .access_write_o (io_write),
      .access_word_o  (io_word),
      .access_addr_o  (io_addr),
      .access_data_o  (io_data),
      .answer_valid_i (answer_valid),
      .answer_data_i  (answer_data),
      .pin_valid_o    (pin_valid),
      .pin_o          (pin),
      .pin_level_o    (pin_level),
      .pwm_valid_o    (duty_valid),
      .pwm_duty_o     (duty),
      .forced_o       (forced_o)
  );

  wire refreshed = list_done && refreshing_q;
  reg refreshing_q;
  always @(posedge clk_i) begin
    if (latch) refreshing_q <= 1'b0;
    else if (refresh) refreshing_q <= 1'b1;
  end

  wire [OUTPUTS-1:0] out_levels;
  output_pins #(
      .OUTPUTS(OUTPUTS)
  ) output_pins (
      .clk_i    (clk_i),
      .rst_ni   (rst_ni),
      .running_i(running),
      .clear_i  (latch && first),
      .valid_i  (pin_valid),
      .pin_i    (pin),
      .level_i  (pin_level),
      .refresh_i(refreshed),
      .safe_i   (safe),
      .hold_i   (hold),
      .invert_i (invert_out),
      .level_o  (out_levels),
      .pins_o   (out_o)
  );

  reg [15:0] next_duty_q;
  reg [15:0] duty_q;
  always @(posedge clk_i) begin
    if (latch && first) next_duty_q <= 16'd0;
    else if (duty_valid) next_duty_q <= duty;
    if (!running) duty_q <= 16'd0;
    else if (refreshed) duty_q <= next_duty_q;
  end

  // ---- the host's exchange -----------------------------------------------------------------------------------
  wire x_valid, x_write, x_word, x_busy, map_word, map_exists;
  wire [15:0] x_addr, x_data, map_address;
  wire [13:0] map_point;

  device_map #(
      .BIT_POINTS (BIT_POINTS),
      .WORD_POINTS(WORD_POINTS),
      .BIT_ADDR   (BIT_ADDR),
      .WORD_ADDR  (WORD_ADDR)
  ) device_map (
      .clk_i        (clk_i),
      .bit_write_i  (load && load_space_q == `RUNG_SPACE_BIT_MAP),
      .word_write_i (load && load_space_q == `RUNG_SPACE_WORD_MAP),
      .write_point_i(load_addr_q[13:0]),
      .write_data_i (mem_wdata_i),
      .point_i      (map_point),
      .word_i       (map_word),
      .exists_o     (map_exists),
      .address_o    (map_address)
  );

  host_exchange #(
      .ANSWER_CLOCKS(ANSWER_CLOCKS)
  ) host_exchange (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .write_i       (write),
      .register_i    (number),
      .buffer_write_i(mem_write_i && sel_buffer),
      .buffer_addr_i (number),
      .wdata_i       (mem_wdata_i),
      .buffer_data_o (buffer_rdata),
      .busy_o        (x_busy),
      .points_i      (exchange_points),
      .phase_i       (phase),
      .done_o        (phase_done),
      .point_o       (map_point),
      .word_o        (map_word),
      .exists_i      (map_exists),
      .address_i     (map_address),
      .access_valid_o(x_valid),
      .access_write_o(x_write),
      .access_word_o (x_word),
      .access_addr_o (x_addr),
      .access_data_o (x_data),
      .answer_valid_i(answer_valid),
      .answer_data_i (answer_data)
  );

  // ---- processor and device ports ------------------------------------------------------------------------------
  wire        start, done, error;
  wire        p_valid, p_write, p_rvalid;
  wire [ 2:0] p_space;
  wire [19:0] p_addr;
  wire [15:0] p_data, p_rdata;
  wire        keep_valid;
  wire [ 5:0] keep_index;
  wire [15:0] keep_value;
  reg         keep_ready_q, keep_asked_q;
  reg  [ 5:0] keep_index_q;
  reg  [15:0] keep_value_q;

  // One of the four has an access at a time: the list in its phases, the exchange in its own, and the
  // firmware and the length only while no scan runs.
  wire access_valid = io_valid || x_valid || load_processor || restore_length;
  wire [2:0] access_space = load_processor ? load_space_q[2:0] : restore_length ? SPACE_LENGTH :
      (io_valid ? io_word : x_word) ? SPACE_WORDS : SPACE_BITS;
  wire [19:0] access_addr = load_processor ? load_addr_q : {4'd0, io_valid ? io_addr : x_addr};
  wire [15:0] access_data = load_processor ? mem_wdata_i : restore_length ? length_q :
      io_valid ? io_data : x_data;
  wire access_write = load_processor || restore_length || (io_valid ? io_write : x_write);

  wire [127:0] port_samples;
  generate
    for (n = 0; n < 8; n = n + 1) begin : gen_adc
      assign port_samples[16*n+:16] = adc_i[{adc_route[3*n+:3], 4'd0}+:16];
    end
  endgenerate

  ladder_ports #(
      .BIT_DEVICES (BIT_DEVICES),
      .WORD_DEVICES(WORD_DEVICES),
      .CLOCK_HZ    (CLOCK_HZ)
  ) ports (
      .clk_i          (clk_i),
      .rst_ni         (rst_ni),
      .scan_rst_ni    (scan_rst_n_q),
      .rx_i           (rx_i),
      .tx_o           (tx_o),
      .pwm_o          (pwm_o),
      .pwm_on_i       (running),
      .pwm_given_i    (pwm_hz != 32'd0),
      .pwm_duty_i     (duty_q),
      .pwm_hz_i       (pwm_hz),
      .adc_i          (port_samples),
      .persist_ready_i(keep_ready_q),
      .keep_valid_o   (keep_valid),
      .keep_index_o   (keep_index),
      .keep_value_o   (keep_value),
      .scan_i         (scan),
      // verilator lint_off PINCONNECTEMPTY
      .busy_o         (),
      // verilator lint_on PINCONNECTEMPTY
      .done_o         (ports_done),
      .host_valid_i   (access_valid),
      .host_write_i   (access_write),
      .host_space_i   (access_space),
      .host_addr_i    (access_addr),
      .host_data_i    (access_data),
      .host_rvalid_o  (answer_valid),
      .host_rdata_o   (answer_data),
      .start_o        (start),
      .done_i         (done),
      .load_valid_o   (p_valid),
      .load_write_o   (p_write),
      .load_space_o   (p_space),
      .load_addr_o    (p_addr),
      .load_data_o    (p_data),
      .load_rvalid_i  (p_rvalid),
      .load_rdata_i   (p_rdata)
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
  ) processor (
      .clk_i        (clk_i),
      .rst_ni       (scan_rst_n_q),
      .start_i      (start),
      .done_o       (done),
      .error_o      (error),
      // verilator lint_off PINCONNECTEMPTY
      .clocks_o     (),
      // verilator lint_on PINCONNECTEMPTY
      .load_valid_i (p_valid),
      .load_write_i (p_write),
      .load_space_i (p_space),
      .load_addr_i  (p_addr),
      .load_data_i  (p_data),
      .load_rvalid_o(p_rvalid),
      .load_rdata_o (p_rdata)
  );

  // A value that the program wants kept waits for the firmware; until it is kept the memory is not ready.
  always @(posedge clk_i) begin
    if (keep_valid) begin
      keep_index_q <= keep_index;
      keep_value_q <= keep_value;
    end
    if (!rst_ni) begin
      keep_asked_q <= 1'b0;
      keep_ready_q <= 1'b0;
    end else if (keep_valid) begin
      keep_asked_q <= 1'b1;
      keep_ready_q <= 1'b0;
    end else if (write && number == `RUNG_REG_KEEP_DONE) begin
      keep_asked_q <= keep_asked_q && !mem_wdata_i[0];
      keep_ready_q <= mem_wdata_i[0];
    end
  end

  // ---- host line and flash ------------------------------------------------------------------------------------------
  rtu_line #(
      .CLOCK_HZ(CLOCK_HZ)
  ) line (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .sel_rx_frame_i(sel_rx_frame),
      .sel_tx_frame_i(sel_tx_frame),
      .sel_register_i(sel_register),
      .addr_i        (number),
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
      .addr_i        (number),
      .read_i        (mem_read_i),
      .write_i       (mem_write_i),
      .wdata_i       (mem_wdata_i),
      .rdata_o       (flash_rdata)
  );

  crc32 crc (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .sel_register_i(sel_register),
      .addr_i        (number),
      .read_i        (mem_read_i),
      .write_i       (mem_write_i),
      .wdata_i       (mem_wdata_i),
      .rdata_o       (crc_rdata)
  );

  // ---- registers to read ------------------------------------------------------------------------------------------
  wire [63:0] levels_64 = {{64 - INPUTS{1'b0}}, levels};
  wire [63:0] outputs_64 = {{64 - OUTPUTS{1'b0}}, out_levels};
  reg [15:0] high_q;  // of the low word read last
  reg [31:0] wide;
  reg [15:0] value;

  always @* begin
    wide = scans;
    if (number == `RUNG_REG_SCAN_LAST_LOW) wide = last;
    if (number == `RUNG_REG_SCAN_MIN_LOW) wide = min;
    if (number == `RUNG_REG_SCAN_MAX_LOW) wide = max;
    value = 16'd0;
    case (number)
      `RUNG_REG_EXCHANGE_STATUS: value = {15'd0, x_busy};
      `RUNG_REG_SCAN_STATUS: begin
        value = {fault_number, 2'd0, error, next_first, run_switch, idle, state};
      end
      `RUNG_REG_SCAN_COUNT_LOW, `RUNG_REG_SCAN_LAST_LOW, `RUNG_REG_SCAN_MIN_LOW,
          `RUNG_REG_SCAN_MAX_LOW:
      value = wide[15:0];
      `RUNG_REG_SCAN_COUNT_HIGH, `RUNG_REG_SCAN_LAST_HIGH, `RUNG_REG_SCAN_MIN_HIGH,
          `RUNG_REG_SCAN_MAX_HIGH:
      value = high_q;
      `RUNG_REG_SCAN_OVERRUNS: value = overruns;
      `RUNG_REG_MILLISECONDS: value = milliseconds;
      `RUNG_REG_INPUTS: value = levels_64[15:0];
      `RUNG_REG_INPUTS + 1: value = levels_64[31:16];
      `RUNG_REG_INPUTS + 2: value = levels_64[47:32];
      `RUNG_REG_INPUTS + 3: value = levels_64[63:48];
      `RUNG_REG_OUTPUTS: value = outputs_64[15:0];
      `RUNG_REG_OUTPUTS + 1: value = outputs_64[31:16];
      `RUNG_REG_OUTPUTS + 2: value = outputs_64[47:32];
      `RUNG_REG_OUTPUTS + 3: value = outputs_64[63:48];
      `RUNG_REG_KEEP_STATUS: value = {15'd0, keep_asked_q};
      `RUNG_REG_KEEP_INDEX: value = {10'd0, keep_index_q};
      `RUNG_REG_KEEP_VALUE: value = keep_value_q;
      `RUNG_REG_BOARD_ID: value = BOARD_ID[15:0];
      `RUNG_REG_CONFIG_ID: value = CONFIG_ID[15:0];
      `RUNG_REG_MPU: value = MPU[15:0];
      `RUNG_REG_FLASH_BASE: value = FLASH_BASE[15:0];
      default: ;
    endcase
  end

  wire is_wide = number == `RUNG_REG_SCAN_COUNT_LOW || number == `RUNG_REG_SCAN_LAST_LOW ||
      number == `RUNG_REG_SCAN_MIN_LOW || number == `RUNG_REG_SCAN_MAX_LOW;
  always @(posedge clk_i) begin
    register_q <= mem_read_i && sel_register ? value : 16'd0;
    if (mem_read_i && sel_register && is_wide) high_q <= wide[31:16];
  end

  assign run_o   = running;
  assign fault_o = fault;

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// A processor with its reset, serial link and device ports: what every board top holds. MPU chooses the
// processor; the parameters after CLOCK_HZ are the processor's own (see hdl/isa/configs.toml).
`default_nettype none

module board_core #(
    parameter integer MPU           = 3,         // 1, 2 or 3
    parameter integer CLOCK_HZ      = 12000000,  // of clk_i
    parameter integer STEPS         = 256,
    parameter integer BIT_DEVICES   = 1024,
    parameter integer WORD_DEVICES  = 256,
    parameter integer MUL_DSP       = 0,
    parameter integer MUL_LATENCY   = 20,
    parameter integer DIV_LATENCY   = 20,
    parameter integer MUL32_LATENCY = 40,        // this and the next: MPU1 only
    parameter integer DIV32_LATENCY = 40
) (
    input  wire clk_i,
    // serial link, see serial_link.v
    input  wire sck_i,
    input  wire csn_i,
    input  wire sdi_i,
    output wire sdo_o,
    // the program's own UART and PWM
    input  wire rx_i,
    output wire tx_o,
    output wire pwm_o,
    // for lamps
    output wire done_o,
    output wire busy_o,
    output wire error_o
);

  wire        rst_n;
  wire        scan;
  wire        scan_done;
  wire        scan_busy;
  wire        start;
  wire        done;
  wire        error;
  wire [31:0] clocks;
  wire        load_valid;
  wire        load_write;
  wire [ 2:0] load_space;
  wire [19:0] load_addr;
  wire [15:0] load_data;
  wire        load_rvalid;
  wire [15:0] load_rdata;
  wire        host_valid;
  wire        host_write;
  wire [ 2:0] host_space;
  wire [19:0] host_addr;
  wire [15:0] host_data;
  wire        host_rvalid;
  wire [15:0] host_rdata;

  power_on_reset power_on_reset (
      .clk_i (clk_i),
      .rst_no(rst_n)
  );

  serial_link link (
      .clk_i        (clk_i),
      .rst_ni       (rst_n),
      .sck_i        (sck_i),
      .csn_i        (csn_i),
      .sdi_i        (sdi_i),
      .sdo_o        (sdo_o),
      .start_o      (scan),
      .done_i       (scan_done),
      .busy_i       (scan_busy),
      .error_i      (error),
      .clocks_i     (clocks),
      .load_valid_o (host_valid),
      .load_write_o (host_write),
      .load_space_o (host_space),
      .load_addr_o  (host_addr),
      .load_data_o  (host_data),
      .load_rvalid_i(host_rvalid),
      .load_rdata_i (host_rdata)
  );

  ladder_ports #(
      .BIT_DEVICES (BIT_DEVICES),
      .WORD_DEVICES(WORD_DEVICES),
      .CLOCK_HZ    (CLOCK_HZ)
  ) ports (
      .clk_i          (clk_i),
      .rst_ni         (rst_n),
      .exchange_rst_ni(rst_n),
      .rx_i           (rx_i),
      .tx_o           (tx_o),
      .pwm_o          (pwm_o),
      .pwm_on_i       (1'b1),
      .duty_valid_i   (1'b0),
      .duty_i         (16'd0),
      .hz_i           (32'd0),
      .adc_i          (128'd0),
      .persist_ready_i(1'b0),
      // verilator lint_off PINCONNECTEMPTY
      .keep_valid_o   (),
      .keep_index_o   (),
      .keep_value_o   (),
      // verilator lint_on PINCONNECTEMPTY
      .scan_i         (scan),
      .busy_o         (scan_busy),
      .done_o         (scan_done),
      .host_valid_i   (host_valid),
      .host_write_i   (host_write),
      .host_space_i   (host_space),
      .host_addr_i    (host_addr),
      .host_data_i    (host_data),
      .host_rvalid_o  (host_rvalid),
      .host_rdata_o   (host_rdata),
      .start_o        (start),
      .done_i         (done),
      .load_valid_o   (load_valid),
      .load_write_o   (load_write),
      .load_space_o   (load_space),
      .load_addr_o    (load_addr),
      .load_data_o    (load_data),
      .load_rvalid_i  (load_rvalid),
      .load_rdata_i   (load_rdata)
  );

  reg [2:0] lamps_q;

  always @(posedge clk_i) lamps_q <= {scan_done, scan_busy, error};

  assign {done_o, busy_o, error_o} = lamps_q;

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
      .rst_ni       (rst_n),
      .start_i      (start),
      .done_o       (done),
      .error_o      (error),
      .clocks_o     (clocks),
      .range_i      (1'b0),
      .entry_i      (16'd0),
      .end_i        (16'd0),
      // verilator lint_off PINCONNECTEMPTY
      .write_valid_o(),
      .write_addr_o (),
      .write_data_o (),
      // verilator lint_on PINCONNECTEMPTY
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

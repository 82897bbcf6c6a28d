// SPDX-License-Identifier: Apache-2.0
// Board top for the ULX3S with an ECP5-85F: MPU4 behind the serial link. The inputs come in bit by bit, one a clock, as
// from shift registers at the terminals, and are latched by every start. Lamps: 0 done, 1 busy, 2 error.
`default_nettype none
`include "rung_wide.vh"

module ulx3s_wide #(
    parameter SLOTS = 16,
    parameter WORD_ADDR = 9,
    parameter DIVIDERS = 2
) (
    input  wire       clk_25mhz_i,
    input  wire       sck_i,
    input  wire       csn_i,
    input  wire       sdi_i,
    output wire       sdo_o,
    input  wire       inputs_i,
    output wire       wifi_gpio0_o,
    output wire [7:0] led_o
);

  localparam INPUTS = 256;

  wire rst_n;
  wire start, done, busy, error;
  wire [31:0] clocks;
  wire load_valid, load_write, load_rvalid;
  wire [2:0] load_space;
  wire [19:0] load_addr;
  wire [15:0] load_data;
  wire [15:0] load_rdata;
  reg [INPUTS-1:0] inputs_q;
  reg [2:0] lamps_q;
  always @(posedge clk_25mhz_i) begin
    inputs_q <= {inputs_q[INPUTS-2:0], inputs_i};
    lamps_q  <= {error, busy, done};
  end
  assign led_o = {5'b0, lamps_q};
  // Low would hand the board over to its ESP32.
  assign wifi_gpio0_o = 1'b1;

  power_on_reset power_on_reset (
      .clk_i (clk_25mhz_i),
      .rst_no(rst_n)
  );

  serial_link link (
      .clk_i        (clk_25mhz_i),
      .rst_ni       (rst_n),
      .sck_i        (sck_i),
      .csn_i        (csn_i),
      .sdi_i        (sdi_i),
      .sdo_o        (sdo_o),
      .start_o      (start),
      .done_i       (done),
      .busy_i       (busy),
      .error_i      (error),
      .clocks_i     (clocks),
      .load_valid_o (load_valid),
      .load_write_o (load_write),
      .load_space_o (load_space),
      .load_addr_o  (load_addr),
      .load_data_o  (load_data),
      .load_rvalid_i(load_rvalid),
      .load_rdata_i (load_rdata)
  );

  mpu4 #(
      .SLOTS(SLOTS),
      .DIVIDERS(DIVIDERS),
      .WORD_ADDR(WORD_ADDR),
      .INPUTS(INPUTS)
  ) mpu (
      .clk_i        (clk_25mhz_i),
      .rst_ni       (rst_n),
      .start_i      (start),
      .in_i         (inputs_q),
      .done_o       (done),
      .busy_o       (busy),
      .error_o      (error),
      .clocks_o     (clocks),
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

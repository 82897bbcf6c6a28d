// SPDX-License-Identifier: Apache-2.0
// Board top for the ULX3S with an ECP5-85F: one processor in the `ecp5` configuration behind the serial
// link, with the UART and the PWM output of its program. Lamps: 0 done, 1 busy, 2 error. The processor
// runs on the board's 25 MHz clock; the clock that place and route reaches is in reports/area-timing.md.
`default_nettype none
`include "rung_isa.vh"

module ulx3s #(
    parameter integer MPU = 3  // 1, 2 or 3
) (
    input  wire       clk_25mhz_i,
    input  wire       sck_i,
    input  wire       csn_i,
    input  wire       sdi_i,
    output wire       sdo_o,
    input  wire       rx_i,
    output wire       tx_o,
    output wire       pwm_o,
    output wire       wifi_gpio0_o,
    output wire [7:0] led_o
);

  wire done;
  wire busy;
  wire error;

  assign led_o = {5'b0, error, busy, done};

  // Low would hand the board over to its ESP32.
  assign wifi_gpio0_o = 1'b1;

  generate
    if (MPU == 1) begin : gen_mpu1
      board_core #(
          .MPU(1),
          .CLOCK_HZ(`RUNG_ECP5_CLOCK_HZ),
          `RUNG_ECP5_MPU1
      ) core (
          .clk_i  (clk_25mhz_i),
          .sck_i  (sck_i),
          .csn_i  (csn_i),
          .sdi_i  (sdi_i),
          .sdo_o  (sdo_o),
          .rx_i   (rx_i),
          .tx_o   (tx_o),
          .pwm_o  (pwm_o),
          .done_o (done),
          .busy_o (busy),
          .error_o(error)
      );
    end else if (MPU == 2) begin : gen_mpu2
      board_core #(
          .MPU(2),
          .CLOCK_HZ(`RUNG_ECP5_CLOCK_HZ),
          `RUNG_ECP5_MPU2
      ) core (
          .clk_i  (clk_25mhz_i),
          .sck_i  (sck_i),
          .csn_i  (csn_i),
          .sdi_i  (sdi_i),
          .sdo_o  (sdo_o),
          .rx_i   (rx_i),
          .tx_o   (tx_o),
          .pwm_o  (pwm_o),
          .done_o (done),
          .busy_o (busy),
          .error_o(error)
      );
    end else begin : gen_mpu3
      board_core #(
          .MPU(3),
          .CLOCK_HZ(`RUNG_ECP5_CLOCK_HZ),
          `RUNG_ECP5_MPU3
      ) core (
          .clk_i  (clk_25mhz_i),
          .sck_i  (sck_i),
          .csn_i  (csn_i),
          .sdi_i  (sdi_i),
          .sdo_o  (sdo_o),
          .rx_i   (rx_i),
          .tx_o   (tx_o),
          .pwm_o  (pwm_o),
          .done_o (done),
          .busy_o (busy),
          .error_o(error)
      );
    end
  endgenerate

endmodule
`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// Board top for the iCE40-HX8K breakout: one processor in the `hx8k` configuration behind the serial
// link, with the UART and the PWM output of its program. Lamps: D9 done, D8 busy, D7 error. The
// processor runs on the board's 12 MHz clock; the clock that place and route reaches is in
// reports/area-timing.md.
`default_nettype none
`include "rung_isa.vh"

module hx8k #(
    parameter integer MPU = 3  // 1, 2 or 3
) (
    input  wire       clk_12mhz_i,
    input  wire       sck_i,
    input  wire       csn_i,
    input  wire       sdi_i,
    output wire       sdo_o,
    input  wire       rx_i,
    output wire       tx_o,
    output wire       pwm_o,
    output wire [7:0] led_o
);

  wire done;
  wire busy;
  wire error;

  assign led_o = {5'b0, error, busy, done};

  generate
    if (MPU == 1) begin : gen_mpu1
      board_core #(
          .MPU(1),
          .CLOCK_HZ(`RUNG_HX8K_CLOCK_HZ),
          `RUNG_HX8K_MPU1
      ) core (
          .clk_i  (clk_12mhz_i),
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
          .CLOCK_HZ(`RUNG_HX8K_CLOCK_HZ),
          `RUNG_HX8K_MPU2
      ) core (
          .clk_i  (clk_12mhz_i),
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
          .CLOCK_HZ(`RUNG_HX8K_CLOCK_HZ),
          `RUNG_HX8K_MPU3
      ) core (
          .clk_i  (clk_12mhz_i),
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

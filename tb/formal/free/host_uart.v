// SPDX-License-Identifier: Apache-2.0
// Any line whatever, in the place of hdl/controller/host_uart.v: any bytes and errors come, and each that is sent takes any time,
// in which it is busy from the clock on that follows its ready.
`default_nettype none

module host_uart (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire [19:0] baud_step_i,
    input  wire [ 1:0] parity_i,
    input  wire        rx_i,
    output wire        tx_o,
    output wire        de_o,
    output wire        rx_active_o,
    output wire        rx_valid_o,
    output wire [ 7:0] rx_data_o,
    output wire        rx_error_o,
    input  wire        tx_valid_i,
    input  wire [ 7:0] tx_data_i,
    output wire        tx_ready_o,
    output wire        tx_busy_o
);

  (* anyseq *) wire rx_active;
  (* anyseq *) wire rx_valid;
  (* anyseq *) wire [7:0] rx_data;
  (* anyseq *) wire rx_error;
  (* anyseq *) wire tx_ready;
  (* anyseq *) wire tx_busy;
  assign {tx_o, de_o} = {1'b1, tx_busy};
  assign {rx_active_o, rx_valid_o, rx_data_o, rx_error_o} = {
    rx_active, rx_valid, rx_data, rx_error
  };
  assign {tx_ready_o, tx_busy_o} = {tx_ready, tx_busy};

  reg taken_q;
  always @(posedge clk_i) taken_q <= rst_ni && tx_valid_i && tx_ready;
  always @* begin
    assume (!(rx_valid && rx_error));
    if (taken_q) assume (tx_busy);
  end

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// A processor's device ports with the board's UART and PWM behind them, and the registers that the host
// sets. Load port accesses to space 5 are these registers, written between scans, 0 after reset:
//   0   bit ports of the program in bits 1:0, word ports in bits 14:8; both 0: the program has no ports
//   1   baud rate, low 16 bits of baud_step_i (uart_tx.v)   2   its high 4 bits
// All other accesses go to the processor. exchange_rst_ni resets the exchange alone, with the processor.
// ADC and lasting memory as in port_exchange.v. pwm_on_i 0: the PWM output is off at once. duty_valid_i: duty_i
// and hz_i take the place of what the program's ports say.
`default_nettype none

module ladder_ports #(
    parameter integer BIT_DEVICES  = 1024,
    parameter integer WORD_DEVICES = 256,
    parameter integer CLOCK_HZ     = 12000000
) (
    input  wire         clk_i,
    input  wire         rst_ni,
    input  wire         exchange_rst_ni,
    // pins
    input  wire         rx_i,
    output wire         tx_o,
    output wire         pwm_o,
    // PWM
    input  wire         pwm_on_i,
    input  wire         duty_valid_i,
    input  wire [ 15:0] duty_i,
    input  wire [ 31:0] hz_i,
    // ADC and lasting memory
    input  wire [127:0] adc_i,
    input  wire         persist_ready_i,
    output wire         keep_valid_o,
    output wire [  5:0] keep_index_o,
    output wire [ 15:0] keep_value_o,
    // from the host
    input  wire         scan_i,
    output wire         busy_o,
    output wire         done_o,
    input  wire         host_valid_i,
    input  wire         host_write_i,
    input  wire [  2:0] host_space_i,
    input  wire [ 19:0] host_addr_i,
    input  wire [ 15:0] host_data_i,
    output wire         host_rvalid_o,
    output wire [ 15:0] host_rdata_o,
    // the processor
    output wire         start_o,
    input  wire         done_i,
    output wire         load_valid_o,
    output wire         load_write_o,
    output wire [  2:0] load_space_o,
    output wire [ 19:0] load_addr_o,
    output wire [ 15:0] load_data_o,
    input  wire         load_rvalid_i,
    input  wire [ 15:0] load_rdata_i
);

  localparam [2:0] SPACE_PORTS = 3'd5;
  localparam [19:0] COUNTS = 20'd0;
  localparam [19:0] BAUD_LOW = 20'd1;
  localparam [19:0] BAUD_HIGH = 20'd2;

  reg [1:0] port_bits_q;
  reg [6:0] port_words_q;
  reg [19:0] baud_step_q;

  wire ours = host_space_i == SPACE_PORTS;
  wire host_ready;
  wire write = host_valid_i && host_ready && host_write_i && ours;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      port_bits_q  <= 2'd0;
      port_words_q <= 7'd0;
      baud_step_q  <= 20'd0;
    end else if (write) begin
      if (host_addr_i == COUNTS) begin
        port_bits_q  <= host_data_i[1:0];
        port_words_q <= host_data_i[14:8];
      end
      if (host_addr_i == BAUD_LOW) baud_step_q[15:0] <= host_data_i;
      if (host_addr_i == BAUD_HIGH) baud_step_q[19:16] <= host_data_i[3:0];
    end
  end

  wire rx_valid;
  wire [7:0] rx_data;
  wire tx_valid;
  wire tx_ready;
  wire [7:0] tx_data;
  wire [15:0] duty;
  wire [31:0] hz;

  uart_rx receiver (
      .clk_i          (clk_i),
      .rst_ni         (rst_ni),
      .baud_step_i    (baud_step_q),
      .parity_i       (2'd0),
      .rx_i           (rx_i),
      .valid_o        (rx_valid),
      .data_o         (rx_data),
      // verilator lint_off PINCONNECTEMPTY
      .active_o       (),
      .framing_error_o(),
      .parity_error_o ()
      // verilator lint_on PINCONNECTEMPTY
  );

  uart_tx transmitter (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni),
      .baud_step_i(baud_step_q),
      .parity_i   (2'd0),
      .two_stops_i(1'b0),
      .valid_i    (tx_valid),
      .data_i     (tx_data),
      .ready_o    (tx_ready),
      // verilator lint_off PINCONNECTEMPTY
      .busy_o     (),
      // verilator lint_on PINCONNECTEMPTY
      .tx_o       (tx_o)
  );

  pwm #(
      .CLOCK_HZ(CLOCK_HZ)
  ) pwm (
      .clk_i (clk_i),
      .rst_ni(rst_ni && pwm_on_i),
      .duty_i(duty_valid_i ? duty_i : duty),
      .hz_i  (duty_valid_i ? hz_i : hz),
      .pwm_o (pwm_o)
  );

  port_exchange #(
      .BIT_DEVICES (BIT_DEVICES),
      .WORD_DEVICES(WORD_DEVICES)
  ) exchange (
      .clk_i          (clk_i),
      .rst_ni         (exchange_rst_ni),
      .scan_i         (scan_i),
      .busy_o         (busy_o),
      .done_o         (done_o),
      .port_bits_i    (port_bits_q),
      .port_words_i   (port_words_q),
      .rx_valid_i     (rx_valid),
      .rx_data_i      (rx_data),
      .tx_ready_i     (tx_ready),
      .tx_valid_o     (tx_valid),
      .tx_data_o      (tx_data),
      .pwm_duty_o     (duty),
      .pwm_hz_o       (hz),
      .adc_i          (adc_i),
      .persist_ready_i(persist_ready_i),
      .restore_valid_i(1'b0),
      .restore_index_i(6'd0),
      .restore_value_i(16'd0),
      // verilator lint_off PINCONNECTEMPTY
      .rx_lost_o      (),
      .restore_ready_o(),
      // verilator lint_on PINCONNECTEMPTY
      .keep_valid_o   (keep_valid_o),
      .keep_index_o   (keep_index_o),
      .keep_value_o   (keep_value_o),
      .host_valid_i   (host_valid_i && !ours),
      .host_ready_o   (host_ready),
      .host_write_i   (host_write_i),
      .host_space_i   (host_space_i),
      .host_addr_i    (host_addr_i),
      .host_data_i    (host_data_i),
      .host_rvalid_o  (host_rvalid_o),
      .host_rdata_o   (host_rdata_o),
      .start_o        (start_o),
      .done_i         (done_i),
      .load_valid_o   (load_valid_o),
      .load_write_o   (load_write_o),
      .load_space_o   (load_space_o),
      .load_addr_o    (load_addr_o),
      .load_data_o    (load_data_o),
      .load_rvalid_i  (load_rvalid_i),
      .load_rdata_i   (load_rdata_i)
  );

endmodule

`default_nettype wire

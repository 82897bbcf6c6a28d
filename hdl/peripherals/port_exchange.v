// SPDX-License-Identifier: Apache-2.0
// Device ports (hdl/isa/ports.toml): stands at a processor's load port, and around each of its scans
// carries the ports between the processor's devices and the controller's peripherals.
//
// A scan: scan_i is looked at while busy_o is 0. Edges, counted from the one that samples scan_i as 1:
//   1 to 13    the ports that the controller drives go into the devices, as they were at edge 0 (the ADC's
//              samples: as they are at edges 5 to 12, channel 0 first)
//   14         the processor samples its start; its own scan takes n clocks, a constant of the program
//   14 + n     the processor's done is sampled; what the program has done is read from here
//   30 + n     PWM has changed; tx_valid_o and keep_valid_o are 1 from this edge to the next
//   32 + n     done_o is sampled as 1, busy_o as 0, and scan_i is looked at again
// A program has port_bits_i bit ports and port_words_i word ports, counted from port 0: the others are not
// written, and what is read at their place counts for nothing. With both 0 the program has no ports:
// nothing is read or written, the processor samples its start at edge 2, and done_o is 1 at edge 3 + n.
// So a scan takes n + 32 or n + 3 clocks, whatever happens at the ports.
//
// UART: a byte received waits until the program takes it, and a newer one replaces it, even if it has come
// while the scan ran; rx_lost_o is 1 for a clock when a byte was replaced that nobody took. A byte
// to send leaves in one clock with tx_valid_o; the program finds the transmitter ready if tx_ready_i was 1
// at edge 0, and from the clock after tx_valid_o on tx_ready_i has to tell the truth about it.
// PWM: duty and frequency change together, and are 0 if the program does not have them; one that has only
// the low word of the frequency stays below 65,536 Hz.
// Lasting memory: persist_ready_i says that it can be used and that the devices hold its values.
// keep_valid_o is 1 for a clock when keep_value_o is to be kept as value keep_index_o; from the next clock
// on persist_ready_i is 0 until it is kept.
//
// Between scans the load port is the host's, and restore_* write persist values at the start, in each
// an access in every clock that has valid and ready at 1; the host goes first. Accesses reach the processor
// a clock later, and a host's read answers in the eighth clock. rst_ni as for the processor.
`default_nettype none
`include "rung_isa.vh"

module port_exchange #(
    parameter integer BIT_DEVICES  = 1024,
    parameter integer WORD_DEVICES = 256
) (
    input  wire         clk_i,
    input  wire         rst_ni,
    // scan
    input  wire         scan_i,
    output wire         busy_o,
    output wire         done_o,
    input  wire [  1:0] port_bits_i,      // constant while a scan runs, 0 to 3
    input  wire [  6:0] port_words_i,     // constant while a scan runs, 0 to 64
    // UART
    input  wire         rx_valid_i,
    input  wire [  7:0] rx_data_i,
    output wire         rx_lost_o,
    input  wire         tx_ready_i,
    output wire         tx_valid_o,
    output wire [  7:0] tx_data_o,
    // PWM
    output wire [ 15:0] pwm_duty_o,
    output wire [ 31:0] pwm_hz_o,
    // ADC: the samples side by side, channel 0 lowest
    input  wire [127:0] adc_i,
    // lasting memory
    input  wire         persist_ready_i,
    output wire         keep_valid_o,
    output wire [  5:0] keep_index_o,
    output wire [ 15:0] keep_value_o,
    input  wire         restore_valid_i,
    output wire         restore_ready_o,
    input  wire [  5:0] restore_index_i,
    input  wire [ 15:0] restore_value_i,
    // the host's load port
    input  wire         host_valid_i,
    output wire         host_ready_o,
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

  localparam [2:0] SPACE_BITS = 3'd2;
  localparam [2:0] SPACE_WORDS = 3'd3;
  localparam LAST_BIT = BIT_DEVICES - 1;
  localparam LAST_WORD = WORD_DEVICES - 1;

  localparam [2:0] IDLE = 3'd0;
  localparam [2:0] BEFORE = 3'd1;
  localparam [2:0] START = 3'd2;
  localparam [2:0] STARTED = 3'd3;  // the processor's done is still that of the scan before
  localparam [2:0] RUN = 3'd4;
  localparam [2:0] AFTER = 3'd5;

  // Slots of BEFORE: three flags, the byte, then the channels of the ADC.
  localparam [3:0] WRITE_RX_FULL = 4'd0;
  localparam [3:0] WRITE_TX_READY = 4'd1;
  localparam [3:0] WRITE_PERSIST_READY = 4'd2;
  localparam [3:0] WRITE_RX_DATA = 4'd3;
  localparam [3:0] FIRST_ADC = 4'd4;
  localparam [3:0] LAST_WRITE = 4'd11;
  // Slots of AFTER. The index comes first: its answer is there when the value it names is asked for.
  localparam [3:0] READ_INDEX = 4'd0;
  localparam [3:0] READ_RX_FULL = 4'd1;
  localparam [3:0] READ_TX_READY = 4'd2;
  localparam [3:0] READ_PERSIST_READY = 4'd3;
  localparam [3:0] READ_TX_DATA = 4'd4;
  localparam [3:0] READ_DUTY = 4'd5;
  localparam [3:0] READ_HZ_LOW = 4'd6;
  localparam [3:0] READ_HZ_HIGH = 4'd7;
  localparam [3:0] READ_VALUE = 4'd8;
  localparam [3:0] NO_SLOT = 4'd15;

  // ---- the course of a scan --------------------------------------------------------------------
  reg [2:0] state_q;
  reg [3:0] slot_q;  // of an access in BEFORE and AFTER
  reg [3:0] answer_q;  // the read that is answered next
  reg done_q;
  reg finish_q;  // all answers are there
  wire idle = state_q == IDLE;
  wire ports_used = |port_bits_i || |port_words_i;
  wire answer = state_q == AFTER && load_rvalid_i;
  wire last_answer = answer && answer_q == READ_VALUE;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q  <= IDLE;
      done_q   <= 1'b0;
      finish_q <= 1'b0;
    end else begin
      finish_q <= last_answer;
      case (state_q)
        IDLE: begin
          if (scan_i) begin
            state_q <= ports_used ? BEFORE : START;
            done_q  <= 1'b0;
          end
        end
        BEFORE: if (slot_q == LAST_WRITE) state_q <= START;
        START: state_q <= STARTED;
        STARTED: state_q <= RUN;
        RUN: begin
          if (done_i) begin
            state_q <= ports_used ? AFTER : IDLE;
            done_q  <= !ports_used;
          end
        end
        default: begin
          if (finish_q) begin
            state_q <= IDLE;
            done_q  <= 1'b1;
          end
        end
      endcase
    end

    if (state_q != BEFORE && state_q != AFTER) slot_q <= 4'd0;
    else if (slot_q != NO_SLOT) slot_q <= slot_q + 4'd1;
    if (state_q != AFTER) answer_q <= 4'd0;
    else if (answer) answer_q <= answer_q + 4'd1;
  end

  assign busy_o = !idle;
  assign done_o = done_q;

  // ---- what the program finds: flags as they are when the scan is taken -------------------------
  wire has_rx = |port_bits_i && port_words_i > `RUNG_PORT_UART_RX_DATA;
  wire has_tx = port_bits_i > `RUNG_PORT_UART_TX_READY && port_words_i > `RUNG_PORT_UART_TX_DATA;
  wire has_pwm = port_words_i > `RUNG_PORT_PWM_HZ_LOW;
  wire has_pwm_high = port_words_i > `RUNG_PORT_PWM_HZ_HIGH;
  wire has_persist = port_bits_i > `RUNG_PORT_PERSIST_READY &&
      port_words_i > `RUNG_PORT_PERSIST_VALUE;

  reg kept_rx_q;  // the program has left the flag as it found it
  reg kept_tx_q;
  reg kept_persist_q;
  reg rx_full_q;
  reg rx_newer_q;  // the waiting byte is not the one that the program found
  reg rx_lost_q;
  reg rx_lost_too_q;
  reg [7:0] rx_data_q;
  reg found_rx_q;
  reg found_tx_q;
  reg found_persist_q;
  reg [7:0] found_data_q;

  wire rx_taken = last_answer && found_rx_q && !kept_rx_q;
  wire rx_left = last_answer && found_rx_q && kept_rx_q;
  // The program has found the waiting byte, and whether it takes it is not known yet.
  wire rx_open = idle ? scan_i && has_rx : found_rx_q && !rx_newer_q;

  wire lost_waiting = rx_valid_i && rx_full_q && !rx_open;
  wire lost_left = rx_left && (rx_newer_q || rx_valid_i);

  always @(posedge clk_i) begin
    if (idle) begin
      found_rx_q <= rx_full_q && has_rx;
      found_tx_q <= tx_ready_i && has_tx;
      found_persist_q <= persist_ready_i && has_persist;
      found_data_q <= rx_data_q;
    end else if (last_answer) begin
      found_rx_q <= 1'b0;
    end
    if (rx_valid_i) rx_data_q <= rx_data_i;

    if (!rst_ni) begin
      rx_full_q  <= 1'b0;
      rx_newer_q <= 1'b0;
      rx_lost_q <= 1'b0;
      rx_lost_too_q <= 1'b0;
    end else begin
      if (rx_valid_i) rx_full_q <= 1'b1;
      else if (rx_taken && !rx_newer_q) rx_full_q <= 1'b0;

      if (rx_valid_i) rx_newer_q <= 1'b1;
      else if (idle) rx_newer_q <= 1'b0;

      // Two may be lost at once: the one that the program has left and the one that came after it.
      rx_lost_q <= lost_waiting || lost_left || rx_lost_too_q;
      rx_lost_too_q <= lost_waiting && lost_left;
    end
  end

  assign rx_lost_o = rx_lost_q;

  // ---- what the program has done ----------------------------------------------------------------
  reg [ 5:0] index_q;
  reg        index_valid_q;
  reg [ 7:0] tx_data_q;
  reg        tx_valid_q;
  reg        keep_valid_q;
  reg [15:0] keep_value_q;
  reg [15:0] new_duty_q;
  reg [15:0] new_hz_low_q;
  reg [15:0] new_hz_high_q;
  reg [15:0] duty_q;
  reg [31:0] hz_q;

  always @(posedge clk_i) begin
    if (answer) begin
      case (answer_q)
        READ_INDEX: begin
          index_q <= load_rdata_i[5:0];
          index_valid_q <= load_rdata_i < {9'd0, port_words_i} - `RUNG_PORT_PERSIST_VALUE;
        end
        READ_RX_FULL: kept_rx_q <= load_rdata_i[0];
        READ_TX_READY: kept_tx_q <= load_rdata_i[0];
        READ_PERSIST_READY: kept_persist_q <= load_rdata_i[0];
        READ_TX_DATA: tx_data_q <= load_rdata_i[7:0];
        READ_DUTY: new_duty_q <= load_rdata_i;
        READ_HZ_LOW: new_hz_low_q <= load_rdata_i;
        READ_HZ_HIGH: new_hz_high_q <= load_rdata_i & {16{has_pwm_high}};
        default: keep_value_q <= load_rdata_i;
      endcase
    end

    if (!rst_ni) begin
      tx_valid_q <= 1'b0;
      keep_valid_q <= 1'b0;
    end else begin
      tx_valid_q <= last_answer && found_tx_q && !kept_tx_q;
      keep_valid_q <= last_answer && found_persist_q && !kept_persist_q && index_valid_q;
    end

    if (!rst_ni || !has_pwm) begin
      duty_q <= 16'd0;
      hz_q   <= 32'd0;
    end else if (last_answer) begin
      duty_q <= new_duty_q;
      hz_q   <= {new_hz_high_q, new_hz_low_q};
    end
  end

  assign tx_valid_o   = tx_valid_q;
  assign tx_data_o    = tx_data_q;
  assign keep_valid_o = keep_valid_q;
  assign keep_index_o = index_q;
  assign keep_value_o = keep_value_q;
  assign pwm_duty_o   = duty_q;
  assign pwm_hz_o     = hz_q;

  // ---- accesses of the exchange ----------------------------------------------------------------
  reg port_word;  // else a bit
  reg [6:0] port;
  reg [15:0] port_data;

  always @* begin
    port_word = 1'b1;
    port = `RUNG_PORT_ADC + {3'd0, slot_q - FIRST_ADC};
    port_data = adc_i[{slot_q[2:0]-FIRST_ADC[2:0], 4'd0}+:16];
    if (state_q == BEFORE) begin
      case (slot_q)
        WRITE_RX_FULL: begin
          port_word = 1'b0;
          port = `RUNG_PORT_UART_RX_FULL;
          port_data = {15'd0, found_rx_q};
        end
        WRITE_TX_READY: begin
          port_word = 1'b0;
          port = `RUNG_PORT_UART_TX_READY;
          port_data = {15'd0, found_tx_q};
        end
        WRITE_PERSIST_READY: begin
          port_word = 1'b0;
          port = `RUNG_PORT_PERSIST_READY;
          port_data = {15'd0, found_persist_q};
        end
        WRITE_RX_DATA: begin
          port = `RUNG_PORT_UART_RX_DATA;
          port_data = {8'd0, found_data_q};
        end
        default: ;
      endcase
    end else begin
      case (slot_q)
        READ_INDEX: port = `RUNG_PORT_PERSIST_INDEX;
        READ_RX_FULL: begin
          port_word = 1'b0;
          port = `RUNG_PORT_UART_RX_FULL;
        end
        READ_TX_READY: begin
          port_word = 1'b0;
          port = `RUNG_PORT_UART_TX_READY;
        end
        READ_PERSIST_READY: begin
          port_word = 1'b0;
          port = `RUNG_PORT_PERSIST_READY;
        end
        READ_TX_DATA: port = `RUNG_PORT_UART_TX_DATA;
        READ_DUTY: port = `RUNG_PORT_PWM_DUTY;
        READ_HZ_LOW: port = `RUNG_PORT_PWM_HZ_LOW;
        READ_HZ_HIGH: port = `RUNG_PORT_PWM_HZ_HIGH;
        default: port = `RUNG_PORT_PERSIST_VALUE + {1'b0, index_q};
      endcase
    end
  end

  wire port_exists = port_word ? port < port_words_i : port < {5'd0, port_bits_i};
  wire port_write = state_q == BEFORE && port_exists;
  wire port_read = state_q == AFTER && slot_q <= READ_VALUE;
  // The sizes are powers of two: counting down from the last device is an exclusive-or.
  wire [19:0] port_addr = (port_word ? LAST_WORD[19:0] : LAST_BIT[19:0]) ^ {13'd0, port};
  wire [6:0] restore_port = `RUNG_PORT_PERSIST_VALUE + {1'b0, restore_index_i};

  // ---- the processor's load port ----------------------------------------------------------------
  reg start_q;
  reg load_valid_q;
  reg load_write_q;
  reg [2:0] load_space_q;
  reg [19:0] load_addr_q;
  reg [15:0] load_data_q;
  reg host_rvalid_q;
  reg [15:0] host_rdata_q;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      start_q <= 1'b0;
      load_valid_q <= 1'b0;
      host_rvalid_q <= 1'b0;
    end else begin
      start_q <= state_q == START;
      load_valid_q <= idle ? host_valid_i || restore_valid_i : port_write || port_read;
      host_rvalid_q <= load_rvalid_i && state_q != AFTER;
    end

    if (idle && host_valid_i) begin
      load_write_q <= host_write_i;
      load_space_q <= host_space_i;
      load_addr_q  <= host_addr_i;
      load_data_q  <= host_data_i;
    end else if (idle) begin
      load_write_q <= 1'b1;
      load_space_q <= SPACE_WORDS;
      load_addr_q  <= LAST_WORD[19:0] ^ {13'd0, restore_port};
      load_data_q  <= restore_value_i;
    end else begin
      load_write_q <= state_q == BEFORE;
      load_space_q <= port_word ? SPACE_WORDS : SPACE_BITS;
      load_addr_q  <= port_addr;
      load_data_q  <= port_data;
    end
    host_rdata_q <= load_rdata_i;
  end

  assign start_o         = start_q;
  assign load_valid_o    = load_valid_q;
  assign load_write_o    = load_write_q;
  assign load_space_o    = load_space_q;
  assign load_addr_o     = load_addr_q;
  assign load_data_o     = load_data_q;
  assign host_ready_o    = idle;
  assign restore_ready_o = idle && !host_valid_i;
  assign host_rvalid_o   = host_rvalid_q;
  assign host_rdata_o    = host_rdata_q;

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// Modbus RTU framing between the bytes of host_uart.v and the micro-sequencer: buffers rx_frame and tx_frame,
// registers line_* of hdl/isa/controller.toml.
//
// Receiving: a frame ends when no byte has come for the silence of the registers (24 bits are used). Shorter
// pauses are nothing: the standard would drop a frame with one of more than 1.5 characters in it, but clients
// behind USB adapters make them. Silence is counted from the middle of a stop bit to that of a start bit; with
// 3.5 characters less a bit, 37.5 bits, frames 3.5 characters apart are told apart even if their sender is
// 2 % too fast. A frame of 4 to 256 bytes, all good, with a right CRC waits in rx_frame until
// line_take; any other is counted and dropped. Frames that begin while one waits, or between line_send and
// the end of what is sent, are dropped and counted as lost, but not what comes while de_o of the UART
// (tx_busy_i) is 1, nor a byte that began then: on RS-485 that is our own.
//
// Sending: after line_send, as soon as the line is silent; a request has ended with silence, so that nothing
// is lost by it. On a line that is never silent it begins after 256 bytes: no flood can hold back a
// reply for ever. Then tx_frame and its CRC leave without gaps. line_send is ignored while sending and for a
// length that is none.
//
// Bus: select, address and data in the clock of read_i or write_i; rdata_o in the clock after read_i, else 0.
// The block RAM of the buffers is shared: the line's own accesses, one a byte, wait for a clock in which the
// bus leaves the RAM's port alone. One in 64 is enough at 13 clocks a bit.
// Bytes come at least 12 clocks apart; one that comes before the one before is stored spoils its frame.
`default_nettype none
`include "rung_controller.vh"

module rtu_line #(
    parameter integer CLOCK_HZ = 12000000  // for the settings after reset: 19,200 baud, even parity
) (
    input  wire        clk_i,
    input  wire        rst_ni,
    // bus
    input  wire        sel_rx_frame_i,
    input  wire        sel_tx_frame_i,
    input  wire        sel_register_i,
    input  wire [ 7:0] addr_i,
    input  wire        read_i,
    input  wire        write_i,
    input  wire [15:0] wdata_i,
    output wire [15:0] rdata_o,
    // UART
    output wire [19:0] baud_step_o,
    output wire [ 1:0] parity_o,
    input  wire        rx_active_i,
    input  wire        rx_valid_i,
    input  wire [ 7:0] rx_data_i,
    input  wire        rx_error_i,
    output wire        tx_valid_o,
    output wire [ 7:0] tx_data_o,
    input  wire        tx_ready_i,
    input  wire        tx_busy_i,
    // a frame comes or goes
    output wire        active_o
);

  localparam [7:0] STATUS = `RUNG_REG_LINE_STATUS;
  localparam [7:0] LENGTH = `RUNG_REG_LINE_LENGTH;
  localparam [7:0] TAKE = `RUNG_REG_LINE_TAKE;
  localparam [7:0] SEND = `RUNG_REG_LINE_SEND;
  localparam [7:0] BAUD_LOW = `RUNG_REG_LINE_BAUD_LOW;
  localparam [7:0] BAUD_HIGH = `RUNG_REG_LINE_BAUD_HIGH;
  localparam [7:0] PARITY = `RUNG_REG_LINE_PARITY;
  localparam [7:0] SILENCE_LOW = `RUNG_REG_LINE_SILENCE_LOW;
  localparam [7:0] SILENCE_HIGH = `RUNG_REG_LINE_SILENCE_HIGH;
  localparam [7:0] BAD_CRC = `RUNG_REG_LINE_BAD_CRC;
  localparam [7:0] BAD_BYTE = `RUNG_REG_LINE_BAD_BYTE;
  localparam [7:0] LOST = `RUNG_REG_LINE_LOST;

  // verilator lint_off WIDTH
  localparam [63:0] CLOCK = CLOCK_HZ;
  // verilator lint_on WIDTH
  localparam [63:0] STEP_19200 = (64'd8 * 64'd1048576 * 64'd19200 + CLOCK / 64'd2) / CLOCK;
  localparam [63:0] SILENCE_19200 = CLOCK * 64'd75 / 64'd38400;  // 37.5 bits
  localparam [1:0] EVEN = 2'd2;

  localparam [8:0] SHORTEST = 9'd4;
  localparam [8:0] LONGEST = 9'd256;
  localparam [8:0] CRC_BYTES = 9'd2;
  localparam [15:0] MOST_TO_SEND = 16'd254;
  localparam [15:0] POLYNOMIAL = 16'ha001;

  // What is being sent. The states from FETCH on are those in which the line is ours.
  localparam [2:0] IDLE = 3'd0;
  localparam [2:0] WAIT = 3'd1;  // for silence
  localparam [2:0] FETCH = 3'd2;  // a byte of tx_frame
  localparam [2:0] FETCHED = 3'd3;
  localparam [2:0] OFFER = 3'd4;  // it to the UART
  localparam [2:0] OFFER_LOW = 3'd5;  // the CRC
  localparam [2:0] OFFER_HIGH = 3'd6;
  localparam [2:0] DRAIN = 3'd7;

  wire register_write = sel_register_i && write_i;
  wire register_read = sel_register_i && read_i;
  wire send_valid = wdata_i != 16'd0 && wdata_i <= MOST_TO_SEND;

  // ---- settings ----
  reg [19:0] baud_step_q;
  reg [ 1:0] parity_q;
  reg [23:0] silence_q;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      baud_step_q <= STEP_19200[19:0];
      parity_q <= EVEN;
      silence_q <= SILENCE_19200[23:0];
    end else if (register_write) begin
      if (addr_i == BAUD_LOW) baud_step_q[15:0] <= wdata_i;
      if (addr_i == BAUD_HIGH) baud_step_q[19:16] <= wdata_i[3:0];
      if (addr_i == PARITY) parity_q <= wdata_i[1:0];
      if (addr_i == SILENCE_LOW) silence_q[15:0] <= wdata_i;
      if (addr_i == SILENCE_HIGH) silence_q[23:16] <= wdata_i[7:0];
    end
  end

  // ---- bytes that count, and silence ----
  reg [ 2:0] state_q;
  reg        echo_q;  // the byte that comes in began while we were sending
  reg [23:0] rest_q;  // of the silence
  reg [ 8:0] index_q;  // of the byte to send; in WAIT bytes that came

  wire       ours = tx_busy_i || (state_q != IDLE && state_q != WAIT);
  wire       any_byte = rx_valid_i || rx_error_i;
  wire       byte_in = any_byte && !ours && !echo_q;
  wire       silent = rest_q == 24'd0;

  always @(posedge clk_i) begin
    if (!rst_ni) echo_q <= 1'b0;
    else echo_q <= rx_active_i && (ours || echo_q);

    if (!rst_ni || rx_active_i || any_byte) rest_q <= silence_q;
    else if (!silent) rest_q <= rest_q - 24'd1;
  end

  // ---- receiving, sending ----
  reg        open_q;  // a frame has begun and not ended
  reg        drop_q;  // it is lost
  reg        bad_q;  // it has a bad byte or is too long
  reg        waits_q;  // a good one waits
  reg [ 8:0] length_q;  // of the frame in rx_frame, with CRC
  reg [ 7:0] byte_q;  // received and not yet stored, or fetched and not yet sent
  reg        store_q;
  reg [ 7:0] to_send_q;
  reg [15:0] crc_q;
  reg [ 3:0] crc_left_q;  // bits of the byte under way
  reg [15:0] bad_crc_q;
  reg [15:0] bad_byte_q;
  reg [15:0] lost_q;

  wire       port_free = !((sel_rx_frame_i || sel_tx_frame_i) && (read_i || write_i));
  wire       store = store_q && port_free;
  wire       fetch = state_q == FETCH && port_free;
  wire       crc_busy = crc_left_q != 4'd0;
  wire       first = byte_in && !open_q;
  wire       may_begin = !waits_q && state_q == IDLE;
  wire       keep = open_q ? !drop_q : may_begin;  // the byte belongs to a frame that is received
  wire [8:0] place = open_q ? length_q : 9'd0;
  wire       frame_end = open_q && silent && !byte_in;
  wire       frame_bad = bad_q || length_q < SHORTEST || crc_q != 16'd0;
  wire       begin_sending = state_q == WAIT && !open_q && silent && !crc_busy && !store_q;
  wire       force_sending = state_q == WAIT && index_q[8] && !crc_busy && !store_q && !any_byte;
  wire       sent = state_q == OFFER && tx_ready_i && !crc_busy;

  always @(posedge clk_i) begin
    if (byte_in && keep) begin
      byte_q   <= rx_data_i;
      length_q <= place;
      bad_q    <= (open_q && bad_q) || rx_error_i || store_q || crc_busy || place == LONGEST;
    end else if (store) begin
      length_q <= length_q + 9'd1;
    end else if (state_q == FETCHED) begin
      byte_q <= ram_data;
    end

    if (store || sent) begin
      crc_q <= {crc_q[15:8], crc_q[7:0] ^ byte_q};
      crc_left_q <= 4'd8;
    end else if (crc_busy) begin
      crc_q <= {1'b0, crc_q[15:1]} ^ (crc_q[0] ? POLYNOMIAL : 16'd0);
      crc_left_q <= crc_left_q - 4'd1;
    end
    if ((first && keep) || begin_sending || force_sending) crc_q <= 16'hffff;

    if (!rst_ni) begin
      open_q <= 1'b0;
      drop_q <= 1'b0;
      waits_q <= 1'b0;
      store_q <= 1'b0;
      length_q <= 9'd0;
      crc_left_q <= 4'd0;
      bad_crc_q <= 16'd0;
      bad_byte_q <= 16'd0;
      lost_q <= 16'd0;
    end else begin
      if (byte_in) begin
        open_q <= 1'b1;
        drop_q <= !keep;
      end else if (frame_end || force_sending) begin
        open_q <= 1'b0;
      end
      if (byte_in && keep) store_q <= rx_valid_i && place != LONGEST;
      else if (store) store_q <= 1'b0;

      if (frame_end && !drop_q && !frame_bad) waits_q <= 1'b1;
      else if (register_write && addr_i == TAKE) waits_q <= 1'b0;

      if ((frame_end || force_sending) && open_q && !drop_q && (frame_bad || !frame_end)) begin
        bad_crc_q <= bad_crc_q + 16'd1;
      end
      if (byte_in && rx_error_i) bad_byte_q <= bad_byte_q + 16'd1;
      if (first && !keep) lost_q <= lost_q + 16'd1;
    end
  end

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q <= IDLE;
    end else begin
      case (state_q)
        IDLE:
        if (register_write && addr_i == SEND && send_valid) begin
          state_q <= WAIT;
          to_send_q <= wdata_i[7:0];
          index_q <= 9'd0;
        end
        WAIT:
        if (begin_sending || force_sending) begin
          state_q <= FETCH;
          index_q <= 9'd0;
        end else if (byte_in && !index_q[8]) begin
          index_q <= index_q + 9'd1;
        end
        FETCH: if (port_free) state_q <= FETCHED;
        FETCHED: state_q <= OFFER;
        OFFER:
        if (sent) begin
          index_q <= index_q + 9'd1;
          state_q <= index_q[7:0] + 8'd1 == to_send_q ? OFFER_LOW : FETCH;
        end
        OFFER_LOW: if (tx_ready_i && !crc_busy) state_q <= OFFER_HIGH;
        OFFER_HIGH: if (tx_ready_i) state_q <= DRAIN;
        // The UART is busy from the clock on that follows its ready.
        default: if (!tx_busy_i) state_q <= IDLE;
      endcase
    end
  end

  assign tx_valid_o = (!crc_busy && (state_q == OFFER || state_q == OFFER_LOW)) ||
      state_q == OFFER_HIGH;
  assign tx_data_o = state_q == OFFER ? byte_q : state_q == OFFER_LOW ? crc_q[7:0] : crc_q[15:8];

  // ---- buffers: rx_frame below tx_frame ----
  wire bus_write = (sel_rx_frame_i || sel_tx_frame_i) && write_i;
  wire bus_read = (sel_rx_frame_i || sel_tx_frame_i) && read_i;
  wire [7:0] ram_data;

  bank_ram #(
      .WIDTH(8),
      .DEPTH(512),
      .ADDR_BITS(9),
      .CLEARED(0)
  ) frames (
      .clk_i       (clk_i),
      .read_i      (bus_read || fetch),
      .read_addr_i (bus_read ? {sel_tx_frame_i, addr_i} : {1'b1, index_q[7:0]}),
      .read_data_o (ram_data),
      .write_i     (bus_write || store),
      .write_addr_i(bus_write ? {sel_tx_frame_i, addr_i} : {1'b0, length_q[7:0]}),
      .write_data_i(bus_write ? wdata_i[7:0] : byte_q)
  );

  // ---- reads ----
  reg ram_read_q;
  reg [15:0] rdata_q;
  wire [8:0] without_crc = length_q - CRC_BYTES;

  always @(posedge clk_i) begin
    ram_read_q <= bus_read;
    rdata_q <= 16'd0;
    if (register_read) begin
      case (addr_i)
        STATUS:   rdata_q <= {14'd0, state_q != IDLE, waits_q};
        LENGTH:   rdata_q <= {7'd0, without_crc};
        BAD_CRC:  rdata_q <= bad_crc_q;
        BAD_BYTE: rdata_q <= bad_byte_q;
        LOST:     rdata_q <= lost_q;
        default:  rdata_q <= 16'd0;
      endcase
    end
  end

  assign rdata_o = rdata_q | {8'd0, ram_data & {8{ram_read_q}}};
  assign baud_step_o = baud_step_q;
  assign parity_o = parity_q;
  assign active_o = open_q || state_q != IDLE;

endmodule

`default_nettype wire

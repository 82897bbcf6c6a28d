// SPDX-License-Identifier: Apache-2.0
// Modbus RTU client for the touch panel: the requests of the scheduler (README.md), one at a time, in the order in
// which they came, as FC 3 and FC 16 to unit_i. Each is complete once: done; refused for an exception, or for a count
// that cannot be; no_reply at its deadline, timeout_ms_i and up to a millisecond after it was accepted (up to 32767),
// however far it has come. Words of a read are in the block only with done; with another status it may hold anything.
//
// A frame ends with a silence of 40 bits, from the middle of its stop bit, and of 1.75 ms; none is sent before that, so
// that 3.5 characters are between frames, also behind two stop bits.
// What is no answer to the request (wrong CRC, unit, function, count) is counted in bad_o, and the answer is still
// awaited. What comes while de_o is 1 is our own.
//
// Late answers: an answer in Modbus RTU does not say which request it belongs to. After a request that has got none,
// the next one therefore has a probe before it, FC 8 (return query data), and is sent only after the probe's
// answer, an exception will do: a server answers in order, so that nothing older can come any more. Each probe has a
// number, which its echo brings back: one that was sent before the request says nothing of it. A panel that has once
// answered a probe always has to, until the reset. One that has not may not know FC 8 at all: two probes without an
// answer, each as long as its request's timeout, have to do. A reset ends before a program is loaded; that takes longer
// than any panel.
`default_nettype none
`include "rung_flow.vh"

module panel_client #(
    parameter integer CLOCK_HZ = 25000000
) (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire [19:0] baud_step_i,          // as in uart_tx.v
    input  wire [ 1:0] parity_i,
    input  wire [ 7:0] unit_i,
    input  wire [15:0] timeout_ms_i,
    input  wire        millisecond_i,
    // pins
    input  wire        rx_i,
    output wire        tx_o,
    output wire        de_o,
    // requests
    input  wire        panel_req_valid_i,
    output wire        panel_req_ready_o,
    input  wire [ 4:0] panel_req_block_i,
    input  wire        panel_req_write_i,
    input  wire [15:0] panel_req_first_i,
    input  wire [ 5:0] panel_req_count_i,
    output wire        panel_done_valid_o,
    input  wire        panel_done_ready_i,
    output wire [ 4:0] panel_done_block_o,
    output wire [ 7:0] panel_done_status_o,
    // pool
    output wire        mem_valid_o,
    input  wire        mem_ready_i,
    output wire        mem_write_o,
    output wire [ 9:0] mem_addr_o,
    output wire [15:0] mem_wdata_o,
    input  wire [15:0] mem_rdata_i,
    // counters
    output wire [15:0] bad_o,
    output wire [15:0] timeouts_o
);

  localparam [7:0] STATUS_DONE = `RUNG_FLOW_STATUS_DONE;
  localparam [7:0] NO_REPLY = `RUNG_FLOW_STATUS_NO_REPLY;
  localparam [7:0] REFUSED = `RUNG_FLOW_STATUS_REFUSED;
  localparam [6:0] READ = 7'd3;
  localparam [6:0] WRITE = 7'd16;
  localparam [6:0] PROBE = 7'd8;
  localparam [5:0] MOST_WORDS = `RUNG_FLOW_BLOCK_WORDS;
  localparam [0:0] LAST_PROBE = 1'd1;

  // Numbers of bytes in a frame: those of a request, then an answer.
  localparam [6:0] HEAD_BYTES = 7'd6;  // unit, function, first, count
  localparam [6:0] FIRST_DATA = 7'd7;
  localparam [6:0] COUNT_AT = 7'd2;
  localparam [6:0] NUMBER_AT = 7'd4;  // of a probe
  localparam [6:0] FIRST_WORD = 7'd3;
  localparam [6:0] EXCEPTION_BYTES = 7'd5;
  localparam [6:0] WRITTEN_BYTES = 7'd8;
  localparam [6:0] TOO_LONG = 7'd127;

  localparam [2:0] IDLE = 3'd0;
  localparam [2:0] GAP = 3'd1;  // until the line is silent
  localparam [2:0] SEND = 3'd2;
  localparam [2:0] DRAIN = 3'd3;
  localparam [2:0] AWAIT = 3'd4;
  localparam [2:0] DONE = 3'd5;

  localparam [8:0] SILENCE = 9'd320;  // eighths of a bit
  localparam [8:0] TWO_BITS = 9'd16;
  localparam integer LEAST = CLOCK_HZ / 4000 * 7;
  localparam integer LEAST_BITS = $clog2(LEAST + 1);
  // verilator lint_off WIDTH
  localparam [LEAST_BITS-1:0] LEAST_CLOCKS = LEAST;
  // verilator lint_on WIDTH

  // ---- requests that wait ----
  (* ram_style = "distributed" *) reg [43:0] waiting[0:31];
  reg [5:0] put_q;
  reg [5:0] take_q;
  reg [15:0] now_q;
  reg [2:0] state_q;
  wire [5:0] waits = put_q - take_q;
  wire put = panel_req_valid_i && panel_req_ready_o;
  wire take = state_q == IDLE && waits != 6'd0;

  always @(posedge clk_i) begin
    if (!rst_ni) now_q <= 16'd0;
    else if (millisecond_i) now_q <= now_q + 16'd1;

    // A begun millisecond does not count.
    if (put) begin
      waiting[put_q[4:0]] <= {
        now_q + timeout_ms_i + 16'd1,
        panel_req_block_i,
        panel_req_write_i,
        panel_req_first_i,
        panel_req_count_i
      };
    end
    if (!rst_ni) begin
      put_q  <= 6'd0;
      take_q <= 6'd0;
    end else begin
      if (put) put_q <= put_q + 6'd1;
      if (take) take_q <= take_q + 6'd1;
    end
  end

  // ---- the request under way ----
  reg [15:0] deadline_q;
  reg [4:0] block_q;
  reg write_q;
  reg [15:0] first_q;
  reg [5:0] count_q;

  always @(posedge clk_i) begin
    if (take) {deadline_q, block_q, write_q, first_q, count_q} <= waiting[take_q[4:0]];
  end

  wire possible = count_q != 6'd0 && count_q <= MOST_WORDS;
  // A value of now_q in the last 2^15 ms has passed.
  wire overdue = ((now_q - deadline_q) & 16'h8000) == 16'd0;

  // ---- UART ----
  wire rx_active;
  wire rx_valid;
  wire [7:0] rx_data;
  wire rx_error;
  wire tx_valid;
  wire [7:0] tx_data;
  wire tx_ready;
  wire tx_busy;

  host_uart uart (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni),
      .baud_step_i(baud_step_i),
      .parity_i   (parity_i),
      .rx_i       (rx_i),
      .tx_o       (tx_o),
      .de_o       (de_o),
      .rx_active_o(rx_active),
      .rx_valid_o (rx_valid),
      .rx_data_o  (rx_data),
      .rx_error_o (rx_error),
      .tx_valid_i (tx_valid),
      .tx_data_i  (tx_data),
      .tx_ready_o (tx_ready),
      .tx_busy_o  (tx_busy)
  );

  // ---- silence, and bytes that count ----
  reg [19:0] phase_q;
  reg [8:0] eighths_q;
  reg [LEAST_BITS-1:0] clocks_q;
  reg echo_q;  // the byte that comes in began while we were sending
  wire ours = tx_busy || state_q == SEND || state_q == DRAIN;
  wire any_byte = rx_valid || rx_error;
  wire byte_in = any_byte && !ours && !echo_q;
  wire silent = eighths_q == SILENCE && clocks_q == LEAST_CLOCKS;
  wire [20:0] phase = {1'b0, phase_q} + {1'b0, baud_step_i};

  always @(posedge clk_i) begin
    if (!rst_ni || rx_active || any_byte || tx_busy) begin
      phase_q   <= 20'd0;
      eighths_q <= 9'd0;
      clocks_q  <= {LEAST_BITS{1'b0}};
    end else begin
      phase_q <= phase[19:0];
      if (phase[20] && eighths_q != SILENCE) eighths_q <= eighths_q + 9'd1;
      if (eighths_q >= TWO_BITS && clocks_q != LEAST_CLOCKS)
        clocks_q <= clocks_q + {{LEAST_BITS - 1{1'b0}}, 1'b1};
    end
    if (!rst_ni) echo_q <= 1'b0;
    else echo_q <= rx_active && (ours || echo_q);
  end

  // ---- sending ----
  reg synced_q;  // no answer to an older request can come
  reg [7:0] probe_q;  // number of the last probe
  reg fetched_q;  // the word to send is in mem_rdata_i
  reg [6:0] index_q;
  wire crc_busy;
  wire [15:0] crc;
  wire [6:0] function_code = !synced_q ? PROBE : write_q ? WRITE : READ;
  wire with_words = synced_q && write_q;
  wire [6:0] crc_at = with_words ? FIRST_DATA + {count_q, 1'b0} : HEAD_BYTES;
  wire [5:0] data_index = index_q[5:0] - FIRST_DATA[5:0];
  wire sending = state_q == SEND;
  wire data_byte = with_words && index_q >= FIRST_DATA && index_q < crc_at;
  wire fetch = sending && data_byte && !fetched_q;
  wire sent = tx_valid && tx_ready;
  wire sent_last = sent && index_q == crc_at + 7'd1;
  wire begin_sending = state_q == GAP && silent && !tx_busy;

  reg [7:0] head_byte;
  always @(*) begin
    case (index_q[2:0])
      3'd0: head_byte = unit_i;
      3'd1: head_byte = {1'b0, function_code};
      3'd2: head_byte = synced_q ? first_q[15:8] : 8'd0;
      3'd3: head_byte = synced_q ? first_q[7:0] : 8'd0;
      3'd4: head_byte = synced_q ? 8'd0 : probe_q;
      3'd5: head_byte = {2'd0, count_q};
      default: head_byte = {1'b0, count_q, 1'b0};
    endcase
  end

  assign tx_valid = sending && !crc_busy && (!data_byte || fetched_q);
  assign tx_data = index_q == crc_at ? crc[7:0] : index_q == crc_at + 7'd1 ? crc[15:8] :
      !data_byte ? head_byte : data_index[0] ? mem_rdata_i[7:0] : mem_rdata_i[15:8];

  always @(posedge clk_i) begin
    if (!rst_ni) probe_q <= 8'd0;
    else if (begin_sending && !synced_q) probe_q <= probe_q + 8'd1;
    if (!sending) index_q <= 7'd0;
    else if (sent) index_q <= index_q + 7'd1;
    if (!sending || (sent && data_byte && data_index[0])) fetched_q <= 1'b0;
    else if (fetch && mem_ready_i) fetched_q <= 1'b1;
  end

  // ---- receiving ----
  reg open_q;  // a frame has begun and not ended
  reg spoiled_q;
  reg unit_right_q;
  reg form_right_q;
  reg number_right_q;  // of a probe's echo
  reg [7:0] function_q;
  reg [6:0] length_q;
  reg [15:0] word_q;
  reg store_q;  // a word to the pool
  reg [4:0] store_index_q;
  wire first_byte = byte_in && !open_q;
  wire [6:0] place = open_q ? length_q : 7'd0;
  wire [6:0] place_word = place - FIRST_WORD;
  wire awaiting = state_q == AWAIT;
  wire word_byte = awaiting && synced_q && !write_q && function_q == {1'b0, READ} && unit_right_q &&
      form_right_q && open_q && place >= FIRST_WORD && place_word[6:1] < count_q;
  wire store_ended = store_q && mem_ready_i;
  reg expected;

  always @(*) begin
    expected = 1'b1;
    if (!write_q) begin
      if (place == COUNT_AT) expected = rx_data == {1'b0, count_q, 1'b0};
    end else begin
      case (place)
        7'd2: expected = rx_data == first_q[15:8];
        7'd3: expected = rx_data == first_q[7:0];
        7'd4: expected = rx_data == 8'd0;
        7'd5: expected = rx_data == {2'd0, count_q};
        default: expected = 1'b1;
      endcase
    end
  end

  link_crc check (
      .clk_i  (clk_i),
      .start_i(first_byte || begin_sending),
      .byte_i (byte_in || (sent && index_q < crc_at)),
      .data_i (sending ? tx_data : rx_data),
      .busy_o (crc_busy),
      .crc_o  (crc)
  );

  always @(posedge clk_i) begin
    if (byte_in) begin
      length_q  <= place == TOO_LONG ? TOO_LONG : place + 7'd1;
      spoiled_q <= (open_q && spoiled_q) || rx_error || crc_busy || place == TOO_LONG || store_q;
      if (place == 7'd0) unit_right_q <= rx_data == unit_i;
      if (place == 7'd1) function_q <= rx_data;
      if (place == 7'd0 || place == NUMBER_AT) number_right_q <= open_q && rx_data == probe_q;
      form_right_q <= (!open_q || form_right_q) && expected;
      if (word_byte) begin
        word_q <= {word_q[7:0], rx_data};
        store_index_q <= place_word[5:1];
      end
    end
    if (!rst_ni || !awaiting) store_q <= 1'b0;
    else if (byte_in && word_byte && place_word[0]) store_q <= 1'b1;
    else if (store_ended) store_q <= 1'b0;

    if (!rst_ni || begin_sending) open_q <= 1'b0;
    else if (byte_in) open_q <= 1'b1;
    else if (silent && !store_q) open_q <= 1'b0;
  end

  // ---- what an answer says ----
  wire ends = awaiting && open_q && silent && !byte_in && !store_q;
  wire right = ends && !spoiled_q && !crc_busy && crc == 16'd0 && unit_right_q;
  wire [6:0] length = write_q ? WRITTEN_BYTES : EXCEPTION_BYTES + {count_q, 1'b0};
  wire of_probe = function_q[6:0] == PROBE;
  wire ours_right = right && synced_q && function_q == {1'b0, function_code} && form_right_q &&
      length_q == length;
  wire exception = right && synced_q && function_q == {1'b1, function_code} &&
      length_q == EXCEPTION_BYTES;
  wire probed = right && !synced_q && of_probe && (function_q[7] || number_right_q);
  // An answer to something else is bad only where there can be none.
  wire bad = ends && !ours_right && !exception && !(right && (!synced_q || of_probe));

  // ---- one request ----
  reg [7:0] status_q;
  reg known_q;  // the panel has answered a probe
  reg [0:0] probes_q;  // without an answer
  reg [15:0] bad_q;
  reg [15:0] timeouts_q;
  wire under_way = sending || state_q == DRAIN || awaiting;
  wire answered = ours_right || exception;
  wire expired = ((state_q == GAP && possible) || under_way) && overdue && !answered;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q <= IDLE;
    end else if (expired) begin
      state_q <= DONE;  // a frame that is cut off here is not executed
    end else begin
      case (state_q)
        IDLE: if (take) state_q <= GAP;
        GAP:
        if (!possible) state_q <= DONE;
        else if (begin_sending) state_q <= SEND;
        SEND: if (sent_last) state_q <= DRAIN;
        // The UART is busy from the clock on that follows its ready.
        DRAIN: if (!tx_busy) state_q <= AWAIT;
        AWAIT:
        if (answered) state_q <= DONE;
        else if (probed) state_q <= GAP;
        default: if (panel_done_ready_i) state_q <= IDLE;
      endcase
    end

    if (state_q == GAP && !possible) status_q <= REFUSED;
    else if (expired) status_q <= NO_REPLY;
    else if (answered) status_q <= exception ? REFUSED : STATUS_DONE;

    if (!rst_ni) begin
      synced_q <= 1'b1;
      known_q <= 1'b0;
      probes_q <= 1'b0;
      bad_q <= 16'd0;
      timeouts_q <= 16'd0;
    end else begin
      if (probed) begin
        synced_q <= 1'b1;
        known_q  <= 1'b1;
      end else if (expired && under_way && synced_q) begin
        synced_q <= 1'b0;
        probes_q <= 1'b0;
      end else if (expired && awaiting) begin
        synced_q <= !known_q && probes_q == LAST_PROBE;
        probes_q <= 1'b1;
      end
      if (bad) bad_q <= bad_q + 16'd1;
      if (expired) timeouts_q <= timeouts_q + 16'd1;
    end
  end

  assign panel_req_ready_o = !waits[5];
  assign panel_done_valid_o = state_q == DONE;
  assign panel_done_block_o = block_q;
  assign panel_done_status_o = status_q;
  assign mem_valid_o = fetch || store_q;
  assign mem_write_o = store_q;
  assign mem_addr_o = {block_q, store_q ? store_index_q : data_index[5:1]};
  assign mem_wdata_o = word_q;
  assign bad_o = bad_q;
  assign timeouts_o = timeouts_q;

endmodule

`default_nettype wire

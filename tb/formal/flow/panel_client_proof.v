// SPDX-License-Identifier: Apache-2.0
// The panel's client (hdl/flow/panel_client.v), any request of it, over a line that does anything. Each request is complete once, in the order
// in which they came: refused if its count cannot be; done or refused if a frame has come that is its answer in CRC, unit,
// function, length and echo; no_reply as soon as its timeout and a millisecond have passed, and not before. What is sent is it.
// The panel answers in order and at any time: while an answer to an older request may still come no request is sent, and
// none is answered. That none can come is known from the echo of a probe that was sent behind it, or, of a panel that has never
// answered one, from two probes' time.
`default_nettype none
`include "rung_flow.vh"

module panel_client_proof (
    input wire          clk_i,
    input wire          rst_ni,
    input wire          millisecond_i,
    input wire          req_valid_i,
    input wire [   4:0] req_block_i,
    input wire          req_write_i,
    input wire [  15:0] req_first_i,
    input wire [   5:0] req_count_i,
    input wire          done_ready_i,
    input wire          mem_ready_i,
    input wire [  15:0] mem_rdata_i,
    // inside of it
    input wire [1407:0] peek_waiting,
    input wire [   5:0] peek_put,
    input wire [   5:0] peek_take,
    input wire [  15:0] peek_now,
    input wire [   2:0] peek_state,
    input wire [  15:0] peek_deadline,
    input wire [  27:0] peek_request,
    input wire [   7:0] peek_status,
    input wire          peek_synced,
    input wire          peek_known,
    input wire          peek_probes,
    input wire [   6:0] peek_index,
    input wire          peek_sent,
    input wire [   7:0] peek_sent_data,
    input wire          peek_byte,
    input wire [   7:0] peek_data,
    input wire          peek_first_byte,
    input wire          peek_open,
    input wire [   6:0] peek_length,
    input wire          peek_unit_right,
    input wire          peek_form_right,
    input wire [   7:0] peek_function,
    input wire          peek_ends,
    input wire [  15:0] peek_crc,
    input wire          peek_probed,
    input wire [   7:0] peek_probe,
    input wire          peek_number_right
);

  (* anyconst *) wire [19:0] baud_step;
  (* anyconst *) wire [1:0] parity;
  (* anyconst *) wire [7:0] unit;
  (* anyconst *) wire [15:0] timeout;
  (* anyconst *) wire [5:0] watched;  // number of the request, modulo 64

  wire tx, de, req_ready, done_valid, mem_valid, mem_write;
  wire [4:0] done_block;
  wire [7:0] done_status;
  wire [9:0] mem_addr;
  wire [15:0] mem_wdata, bad, timeouts;
  panel_client #(
      .CLOCK_HZ(4000)
  ) client (
      .clk_i              (clk_i),
      .rst_ni             (rst_ni),
      .baud_step_i        (baud_step),
      .parity_i           (parity),
      .unit_i             (unit),
      .timeout_ms_i       (timeout),
      .millisecond_i      (millisecond_i),
      .rx_i               (1'b1),
      .tx_o               (tx),
      .de_o               (de),
      .panel_req_valid_i  (req_valid_i),
      .panel_req_ready_o  (req_ready),
      .panel_req_block_i  (req_block_i),
      .panel_req_write_i  (req_write_i),
      .panel_req_first_i  (req_first_i),
      .panel_req_count_i  (req_count_i),
      .panel_done_valid_o (done_valid),
      .panel_done_ready_i (done_ready_i),
      .panel_done_block_o (done_block),
      .panel_done_status_o(done_status),
      .mem_valid_o        (mem_valid),
      .mem_ready_i        (mem_ready_i),
      .mem_write_o        (mem_write),
      .mem_addr_o         (mem_addr),
      .mem_wdata_o        (mem_wdata),
      .mem_rdata_i        (mem_rdata_i),
      .bad_o              (bad),
      .timeouts_o         (timeouts)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* assume (rst_ni == begun_q);

  // ---- requests: accepted, and complete, in order ------------------------------------------------------------
  reg [5:0] accepted_q, complete_q;
  wire accepts = req_valid_i && req_ready && rst_ni;
  wire completes = done_valid && done_ready_i;
  wire [5:0] waiting = accepted_q - complete_q;
  reg live_q;
  reg [4:0] block_q;
  reg write_q;
  reg [15:0] first_q;
  reg [5:0] count_q;
  reg [16:0] elapsed_q;  // milliseconds since it was accepted
  wire accepted = accepts && accepted_q == watched;
  wire its_turn = live_q && complete_q == watched;
  wire possible = count_q >= 6'd1 && count_q <= `RUNG_FLOW_BLOCK_WORDS;
  wire over = elapsed_q > {1'b0, timeout};
  always @* begin
    assume (timeout < 16'h8000);
    // Completions are taken, so that nobody waits half a minute longer than he has to.
    if (live_q) assume (elapsed_q < {1'b0, timeout} + 17'h8000);
  end
  reg [2:0] turn_q;  // clocks that it has had the turn and been over time, or impossible
  always @(posedge clk_i) begin
    if (!rst_ni) {accepted_q, complete_q} <= 12'd0;
    else begin
      accepted_q <= accepted_q + {5'd0, accepts};
      complete_q <= complete_q + {5'd0, completes};
    end
    if (!rst_ni) live_q <= 1'b0;
    else if (accepted) live_q <= 1'b1;
    else if (completes && its_turn) live_q <= 1'b0;
    if (accepted) {block_q, write_q} <= {req_block_i, req_write_i};
    if (accepted) {first_q, count_q} <= {req_first_i, req_count_i};
    if (accepted) elapsed_q <= {16'd0, millisecond_i};
    else elapsed_q <= elapsed_q + {16'd0, millisecond_i};
    if (!its_turn || !(over || !possible)) turn_q <= 3'd0;
    else if (turn_q != 3'd7) turn_q <= turn_q + 3'd1;
  end

  // ---- frames: what is sent, what comes -------------------------------------------------------------------------
  localparam [7:0] PROBE = 8'd8;
  reg [7:0] probe_q;  // the last probe's number
  reg [7:0] rx_unit_q, rx_function_q, rx_2_q, rx_3_q, rx_4_q, rx_5_q;
  reg [6:0] rx_length_q;
  reg [15:0] rx_crc_q;  // when it ended
  wire [7:0] function_code = write_q ? 8'd16 : 8'd3;
  reg [7:0] tx_function_q;  // of the frame under way
  always @(posedge clk_i) begin
    if (peek_sent && peek_index == 7'd1) tx_function_q <= peek_sent_data;
    if (peek_sent && peek_index == 7'd4 && tx_function_q == PROBE) probe_q <= peek_sent_data;
    if (peek_byte) begin
      rx_length_q <= peek_first_byte ? 7'd1 : rx_length_q == 7'd127 ? 7'd127 : rx_length_q + 7'd1;
      if (peek_first_byte) rx_unit_q <= peek_data;
      else begin
        if (rx_length_q == 7'd1) rx_function_q <= peek_data;
        if (rx_length_q == 7'd2) rx_2_q <= peek_data;
        if (rx_length_q == 7'd3) rx_3_q <= peek_data;
        if (rx_length_q == 7'd4) rx_4_q <= peek_data;
        if (rx_length_q == 7'd5) rx_5_q <= peek_data;
      end
    end
    if (peek_ends) rx_crc_q <= peek_crc;
  end
  wire echoes = rx_3_q == first_q[7:0] && rx_2_q == first_q[15:8] && rx_4_q == 8'd0 &&
      rx_5_q == {2'd0, count_q};
  wire answers = rx_crc_q == 16'd0 && rx_unit_q == unit && rx_function_q == function_code &&
      (write_q ? rx_length_q == 7'd8 && echoes :
       rx_length_q == 7'd5 + {count_q, 1'b0} && rx_2_q == {1'b0, count_q, 1'b0});
  wire excepts = rx_crc_q == 16'd0 && rx_unit_q == unit &&
      rx_function_q == (function_code | 8'h80) && rx_length_q == 7'd5;

  // ---- answers that may still come ---------------------------------------------------------------------------------
  // An older request has gone out without an answer. Only the echo of a probe that was sent behind it says that its answer
  // cannot come; a panel that has never answered a probe has answered within the time of two of them. A probe's exception
  // has no number: a panel that answers so is not in this proof.
  reg late_q;
  reg begun_frame_q;  // some of the request under way has gone out
  reg probe_sent_q;  // all of its last probe has
  reg probe_out_q;  // the last probe was sent behind that older request
  reg unanswered_q;  // one has had its time since
  reg ever_q;  // the panel has answered a probe
  reg awaited_q;  // an answer, in the clock before
  reg done_valid_q;
  wire ends_now = done_valid && !done_valid_q;
  wire no_reply = ends_now && done_status == `RUNG_FLOW_STATUS_NO_REPLY;
  wire echoed = peek_probed && rx_4_q == probe_q && rx_length_q >= 7'd5;
  wire in_vain = no_reply && probe_sent_q && awaited_q;
  wire forgets = in_vain && unanswered_q && !ever_q;
  always @* begin
    if (peek_probed) assume (rx_function_q == PROBE);
    // No byte is its own CRC.
    if (peek_ends && peek_crc == 16'd0) assume (rx_length_q >= 7'd2);
  end
  always @(posedge clk_i) begin
    awaited_q <= peek_state == 3'd4;
    done_valid_q <= rst_ni && done_valid && !completes;
    if (!rst_ni || ends_now) begun_frame_q <= 1'b0;
    else if (peek_sent && peek_index == 7'd1 && peek_sent_data != PROBE) begun_frame_q <= 1'b1;
    if (!rst_ni || ends_now || echoed) probe_sent_q <= 1'b0;
    else if (peek_sent && peek_index == 7'd7 && tx_function_q == PROBE) probe_sent_q <= 1'b1;
    if (!rst_ni) {late_q, probe_out_q, unanswered_q, ever_q} <= 4'd0;
    else begin
      if (no_reply && begun_frame_q) {late_q, probe_out_q, unanswered_q} <= 3'b100;
      else if (forgets || (echoed && probe_out_q)) late_q <= 1'b0;
      else if (in_vain) unanswered_q <= 1'b1;
      if (peek_sent && peek_index == 7'd4 && tx_function_q == PROBE) probe_out_q <= 1'b1;
      if (echoed) ever_q <= 1'b1;
    end
  end

  always @* begin
    if (begun_q) begin
      // Each is complete once, in order.
      assert (waiting <= 6'd33);
      if (done_valid) assert (waiting != 6'd0);
      if (done_valid && its_turn) assert (done_block == block_q);
      if (done_valid_q) assert (done_valid && done_status == status_q &&
          done_block == done_block_q);
      if (waiting < 6'd32) assert (req_ready);
      if (ends_now && its_turn) begin
        case (done_status)
          `RUNG_FLOW_STATUS_DONE: assert (possible && answers && begun_frame_q && !late_q);
          `RUNG_FLOW_STATUS_REFUSED: begin
            assert (!possible || (excepts && begun_frame_q && !late_q));
          end
          default: assert (done_status == `RUNG_FLOW_STATUS_NO_REPLY && possible && over);
        endcase
      end
      if (its_turn && turn_q >= 3'd3) assert (done_valid);
      // What is sent is it, or a probe; it is not sent while an older answer may come.
      if (peek_sent && its_turn) begin
        if (peek_index == 7'd0) assert (peek_sent_data == unit);
        if (peek_index == 7'd1) assert (peek_sent_data == PROBE || peek_sent_data == function_code);
        if (peek_index == 7'd1 && late_q) assert (peek_sent_data == PROBE);
        if (tx_function_q != PROBE) begin
          if (peek_index == 7'd2) assert (peek_sent_data == first_q[15:8]);
          if (peek_index == 7'd3) assert (peek_sent_data == first_q[7:0]);
          if (peek_index == 7'd4) assert (peek_sent_data == 8'd0);
          if (peek_index == 7'd5) assert (peek_sent_data == {2'd0, count_q});
          if (write_q && peek_index == 7'd6) assert (peek_sent_data == {1'b0, count_q, 1'b0});
        end
      end
      // Words are those of its block.
      if (mem_valid && its_turn) assert (mem_addr[9:5] == block_q && mem_addr[4:0] < count_q);
      if (mem_valid && its_turn) assert (mem_write == !write_q);
    end
  end
  reg [7:0] status_q;
  reg [4:0] done_block_q;
  always @(posedge clk_i) {status_q, done_block_q} <= {done_status, done_block};

  // ---- for the induction ----------------------------------------------------------------------------------------
  localparam [2:0] IDLE = 3'd0;
  localparam [2:0] GAP = 3'd1;
  localparam [2:0] SEND = 3'd2;
  localparam [2:0] DRAIN = 3'd3;
  localparam [2:0] AWAIT = 3'd4;
  localparam [2:0] DONE = 3'd5;
  wire [5:0] place = watched - complete_q;  // of the request in the queue
  wire [15:0] due = peek_now - elapsed_q[15:0] + timeout + 16'd1;
  wire under_way = its_turn && peek_state != IDLE;
  wire whole = peek_state == DRAIN || peek_state == AWAIT;
  always @* begin
    if (begun_q) begin
      assert (peek_state <= DONE && peek_put == accepted_q && done_valid == (peek_state == DONE));
      assert (peek_take == complete_q + {5'd0, peek_state != IDLE});
      if (peek_state != IDLE) assert (waiting != 6'd0);
      assert (accepted_q - peek_take <= 6'd32);
      if (live_q) assert (place < waiting);
      if (live_q && !under_way) begin
        assert (peek_waiting[44*watched[4:0]+:44] == {due, block_q, write_q, first_q, count_q});
      end
      if (under_way) begin
        assert (peek_deadline == due && peek_request == {block_q, write_q, first_q, count_q});
      end
      if (peek_state >= SEND && peek_state <= AWAIT) begin
        assert (peek_request[5:0] >= 6'd1 && peek_request[5:0] <= `RUNG_FLOW_BLOCK_WORDS);
      end
      if (peek_state == SEND &&
          peek_index >= 7'd2) assert ((tx_function_q == PROBE) == !peek_synced);
      if (under_way && peek_state == SEND && peek_index >= 7'd2 &&
          peek_synced) assert (tx_function_q == function_code);
      if (peek_state == GAP) assert (peek_index == 7'd0);
      if (under_way && whole && peek_synced) assert (begun_frame_q);
      if (peek_state == SEND && peek_index >= 7'd2 && peek_synced) assert (begun_frame_q);
      if (peek_state == SEND && peek_index >= 7'd5 &&
          !peek_synced) assert (probe_q == peek_probe && probe_out_q);
      if (whole && !peek_synced) assert (probe_q == peek_probe && probe_out_q && probe_sent_q);
      if (begun_frame_q) assert (peek_state >= SEND);
      if (begun_frame_q && !done_valid) assert (peek_synced);
      if (probe_sent_q && !done_valid) assert (!peek_synced && whole);
      if (peek_state == IDLE || (peek_state == DONE && done_valid_q)) assert (!begun_frame_q &&
          !probe_sent_q);
      if (its_turn && turn_q >= 3'd1) assert (peek_state != IDLE);
      if (its_turn && turn_q >= 3'd2) assert (done_valid);
      // Late answers.
      assert (ever_q == peek_known);
      if (late_q && !ends_now) assert (!peek_synced && (unanswered_q == peek_probes || ever_q));
      if (late_q && ends_now) begin
        assert (!begun_frame_q && (no_reply || done_status == `RUNG_FLOW_STATUS_REFUSED));
        if (in_vain) assert (peek_probes && (forgets || !peek_synced));
        else assert (!peek_synced && (unanswered_q == peek_probes || ever_q));
      end
      if (no_reply && begun_frame_q) assert (!peek_synced && !peek_probes);
      // The frame that comes.
      if (peek_state == SEND || peek_state == DRAIN) assert (!peek_open);
      if (peek_state == AWAIT && under_way && peek_open && peek_form_right) begin
        if (write_q && rx_length_q >= 7'd3) assert (rx_2_q == first_q[15:8]);
        if (!write_q && rx_length_q >= 7'd3) assert (rx_2_q == {1'b0, count_q, 1'b0});
        if (write_q && rx_length_q >= 7'd4) assert (rx_3_q == first_q[7:0]);
        if (write_q && rx_length_q >= 7'd5) assert (rx_4_q == 8'd0);
        if (write_q && rx_length_q >= 7'd6) assert (rx_5_q == {2'd0, count_q});
      end
      if (peek_open) begin
        assert (rx_length_q == peek_length && rx_length_q >= 7'd1);
        assert (peek_unit_right == (rx_unit_q == unit));
        if (rx_length_q >= 7'd2) assert (peek_function == rx_function_q);
        if (rx_length_q >= 7'd5) assert (peek_number_right == (rx_4_q == peek_probe));
        else assert (!peek_number_right);
      end
    end
  end
  always @* begin
    cover (begun_q && no_reply && its_turn && timeout == 16'd1);
    cover (begun_q && ends_now && its_turn && !possible && waiting == 6'd2);
  end

endmodule

`default_nettype wire

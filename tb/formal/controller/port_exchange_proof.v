// SPDX-License-Identifier: Apache-2.0
// Device ports (hdl/peripherals/port_exchange.v) beside a processor whose scan takes any number of clocks and whose devices
// hold anything: the edges of a scan are those of the file's top; each port that the controller drives and the program
// has is written once, with what it has to be, and no other device is; what the program leaves in its ports is done, in its
// clock, and nothing else ever is; of the bytes received each is taken by the program once, waits, or is told to be lost; the
// host's and the restored accesses reach the processor once and unchanged, between scans only.
// A flag is offered only with the words that belong to it: rx_full with rx_data, tx_ready with tx_data, persist_ready with a value.
`default_nettype none
`include "rung_isa.vh"

module port_exchange_proof (
    input wire         clk_i,
    input wire         rst_ni,
    input wire         scan_i,
    input wire [  1:0] port_bits_i,
    input wire [  6:0] port_words_i,
    input wire         rx_valid_i,
    input wire [  7:0] rx_data_i,
    input wire         tx_ready_i,
    input wire [127:0] adc_i,
    input wire         persist_ready_i,
    input wire         restore_valid_i,
    input wire [  5:0] restore_index_i,
    input wire [ 15:0] restore_value_i,
    input wire         host_valid_i,
    input wire         host_write_i,
    input wire [  2:0] host_space_i,
    input wire [ 19:0] host_addr_i,
    input wire [ 15:0] host_data_i,
    input wire         done_i,
    input wire [ 15:0] load_rdata_i
);

  localparam [19:0] LAST_BIT = 20'd1023;
  localparam [19:0] LAST_WORD = 20'd255;
  localparam [2:0] BITS = 3'd2;
  localparam [2:0] WORDS = 3'd3;

  wire busy, done, rx_lost, tx_valid, keep_valid, restore_ready, host_ready, host_rvalid, start;
  wire load_valid, load_write;
  wire [2:0] load_space;
  wire [5:0] keep_index;
  wire [7:0] tx_data;
  wire [15:0] keep_value, duty, host_rdata, load_data;
  wire [19:0] load_addr;
  wire [31:0] hz;
  wire load_rvalid;

  port_exchange exchange (
      .clk_i          (clk_i),
      .rst_ni         (rst_ni),
      .scan_i         (scan_i),
      .busy_o         (busy),
      .done_o         (done),
      .port_bits_i    (port_bits_i),
      .port_words_i   (port_words_i),
      .rx_valid_i     (rx_valid_i),
      .rx_data_i      (rx_data_i),
      .rx_lost_o      (rx_lost),
      .tx_ready_i     (tx_ready_i),
      .tx_valid_o     (tx_valid),
      .tx_data_o      (tx_data),
      .pwm_duty_o     (duty),
      .pwm_hz_o       (hz),
      .adc_i          (adc_i),
      .persist_ready_i(persist_ready_i),
      .keep_valid_o   (keep_valid),
      .keep_index_o   (keep_index),
      .keep_value_o   (keep_value),
      .restore_valid_i(restore_valid_i),
      .restore_ready_o(restore_ready),
      .restore_index_i(restore_index_i),
      .restore_value_i(restore_value_i),
      .host_valid_i   (host_valid_i),
      .host_ready_o   (host_ready),
      .host_write_i   (host_write_i),
      .host_space_i   (host_space_i),
      .host_addr_i    (host_addr_i),
      .host_data_i    (host_data_i),
      .host_rvalid_o  (host_rvalid),
      .host_rdata_o   (host_rdata),
      .start_o        (start),
      .done_i         (done_i),
      .load_valid_o   (load_valid),
      .load_write_o   (load_write),
      .load_space_o   (load_space),
      .load_addr_o    (load_addr),
      .load_data_o    (load_data),
      .load_rvalid_i  (load_rvalid),
      .load_rdata_i   (load_rdata_i)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  // ---- the edges of a scan ---------------------------------------------------------------------
  localparam [1:0] BETWEEN = 2'd0;
  localparam [1:0] BEFORE = 2'd1;  // edge_q: the number of the next edge
  localparam [1:0] RUNS = 2'd2;
  localparam [1:0] AFTER = 2'd3;  // edge_q: the next edge less 14 + n

  reg [1:0] part_q;
  reg [4:0] edge_q;
  reg done_q;
  wire used = port_bits_i != 2'd0 || port_words_i != 7'd0;
  wire [4:0] start_edge = used ? 5'd14 : 5'd2;
  wire decides = part_q == AFTER && edge_q == 5'd16;  // edge 30 + n
  wire decided = part_q == AFTER && edge_q == 5'd17;

  reg [1:0] bits_q;
  reg [6:0] words_q;
  always @(posedge clk_i) begin
    {bits_q, words_q} <= {port_bits_i, port_words_i};
    if (!rst_ni) begin
      part_q <= BETWEEN;
      done_q <= 1'b0;
    end else begin
      case (part_q)
        BETWEEN: begin
          if (scan_i) begin
            part_q <= BEFORE;
            edge_q <= 5'd1;
            done_q <= 1'b0;
          end
        end
        BEFORE: begin
          edge_q <= edge_q + 5'd1;
          if (edge_q == start_edge) part_q <= RUNS;
        end
        RUNS: begin
          if (done_i) begin
            part_q <= used ? AFTER : BETWEEN;
            edge_q <= 5'd1;
            done_q <= !used;
          end
        end
        default: begin
          edge_q <= edge_q + 5'd1;
          if (decided) begin
            part_q <= BETWEEN;
            done_q <= 1'b1;
          end
        end
      endcase
    end
  end
  // A program's counts stay as they are while it runs.
  always @* if (part_q != BETWEEN) assume ({bits_q, words_q} == {port_bits_i, port_words_i});
  always @* assume (port_words_i <= 7'd64);

  always @* begin
    if (begun_q) begin
      assert (busy == (part_q != BETWEEN) && done == done_q);
      assert (start == (part_q == BEFORE && edge_q == start_edge));
    end
  end

  // ---- the processor: a read is answered in the sixth clock, with anything -------------------------
  // read, host's, word, device
  reg [22:0] asked_q[0:5];
  wire between_q = part_q == BETWEEN || (part_q == BEFORE && edge_q == 5'd1);
  wire reads = load_valid && !load_write;
  integer i;
  always @(posedge clk_i) begin
    for (i = 1; i < 6; i = i + 1) asked_q[i] <= asked_q[i-1];
    asked_q[0] <= {reads, between_q, load_space == WORDS, load_addr};
    if (!rst_ni) for (i = 0; i < 6; i = i + 1) asked_q[i][22] <= 1'b0;
  end
  assign load_rvalid = asked_q[5][22];
  wire answered = load_rvalid && !asked_q[5][21];
  wire answered_word = asked_q[5][20];
  wire [19:0] answered_port = (answered_word ? LAST_WORD : LAST_BIT) - asked_q[5][19:0];
  wire [2:0] answered_place = answered_port >= 20'd6 ? 3'd6 : answered_port[2:0];

  // ---- between scans -------------------------------------------------------------------------------
  reg host_q;
  reg restore_q;
  reg [39:0] access_q;  // write, space, address, data
  reg rvalid_q;
  reg [15:0] rdata_q;
  always @(posedge clk_i) begin
    host_q <= rst_ni && host_valid_i && host_ready;
    restore_q <= rst_ni && restore_valid_i && restore_ready;
    access_q <= host_valid_i ? {host_write_i, host_space_i, host_addr_i, host_data_i} : {
        1'b1, WORDS, LAST_WORD - 20'd16 - {14'd0, restore_index_i}, restore_value_i};
    rvalid_q <= rst_ni && load_rvalid && asked_q[5][21];
    rdata_q <= load_rdata_i;
  end
  always @* begin
    if (begun_q) begin
      assert (host_ready == (part_q == BETWEEN));
      assert (restore_ready == (part_q == BETWEEN && !host_valid_i));
      if (between_q) assert (load_valid == (host_q || restore_q));
      if (host_q || restore_q) begin
        assert (load_valid && {load_write, load_space, load_addr, load_data} == access_q);
      end
      assert (host_rvalid == rvalid_q);
      if (rvalid_q) assert (host_rdata == rdata_q);
    end
  end

  // ---- what the program finds ----------------------------------------------------------------------
  // Bytes received, by their number: the last one waits until it is taken.
  reg [3:0] received_q;
  reg [3:0] taken_q;
  reg [3:0] told_q;  // to be lost
  reg [7:0] byte_q;
  reg waits_q;
  reg found_q;  // the program has found a byte, and it is not known whether it takes it
  reg newer_q;  // the one that waits has come after it
  reg [7:0] found_byte_q;
  reg tx_q, persist_q;
  wire has_rx = port_bits_i >= 2'd1 && port_words_i >= 7'd1;
  wire has_tx = port_bits_i >= 2'd2 && port_words_i >= 7'd2;
  wire has_pwm = port_words_i >= 7'd4;
  wire has_pwm_high = port_words_i >= 7'd5;
  wire has_persist = port_bits_i == 2'd3 && port_words_i >= 7'd17;
  wire left_rx;
  wire takes = decides && found_q && !left_rx;

  always @(posedge clk_i) begin
    if (rx_valid_i) byte_q <= rx_data_i;
    newer_q <= rx_valid_i || (newer_q && part_q != BETWEEN);
    if (part_q == BETWEEN) begin
      found_byte_q <= byte_q;
      tx_q <= tx_ready_i && has_tx;
      persist_q <= persist_ready_i && has_persist;
    end
    if (!rst_ni) begin
      {received_q, taken_q, told_q} <= 12'd0;
      {waits_q, found_q} <= 2'b00;
    end else begin
      if (rx_valid_i) received_q <= received_q + 4'd1;
      if (takes) taken_q <= taken_q + 4'd1;
      if (rx_lost) told_q <= told_q + 4'd1;
      if (part_q == BETWEEN) found_q <= scan_i && waits_q && has_rx;
      else if (decides) found_q <= 1'b0;
      waits_q <= rx_valid_i || (waits_q && !(takes && !newer_q));
    end
  end
  // Bytes of a UART do not come in two clocks one behind the other.
  reg received_last_q;
  always @(posedge clk_i) received_last_q <= rx_valid_i;
  always @* if (begun_q && received_last_q) assume (!rx_valid_i);

  wire in_scan = part_q != BETWEEN;
  wire [3:0] held = {3'd0, waits_q} + {3'd0, in_scan && found_q && newer_q};
  wire [3:0] untold = received_q - taken_q - held - told_q;
  always @* begin
    if (begun_q) begin
      assert (untold <= 4'd2);
      assert (rx_lost == (untold != 4'd0));
    end
  end

  // Any port: it is written once if the controller drives it and the program has it.
  (* anyconst *) wire port_word;
  (* anyconst *) wire [6:0] port;
  wire adc = port_word && port >= 7'd8 && port < 7'd16;
  wire driven = port_word ? (port == 7'd0 || adc) && port < port_words_i :
      port < {5'd0, port_bits_i};
  wire [2:0] space = port_word ? WORDS : BITS;
  wire [19:0] device = (port_word ? LAST_WORD : LAST_BIT) - {13'd0, port};
  reg [15:0] sample_q;  // of the channel, as it was at its edge
  reg [15:0] expected;
  reg written_q;
  wire this_port = load_valid && load_write && load_space == space && load_addr == device;
  wire [19:0] number = (load_space == WORDS ? LAST_WORD : LAST_BIT) - load_addr;
  always @* begin
    expected = sample_q;
    if (!port_word) begin
      expected = {15'd0, port == 7'd0 ? found_q : port == 7'd1 ? tx_q : persist_q};
    end else if (port == 7'd0) begin
      expected = {8'd0, found_byte_q};
    end
  end
  always @(posedge clk_i) begin
    if (part_q == BEFORE && edge_q == {2'd0, port[2:0]} + 5'd5) begin
      sample_q <= adc_i[{port[2:0], 4'd0}+:16];
    end
    if (part_q != BEFORE) written_q <= 1'b0;
    else if (!between_q && this_port) written_q <= 1'b1;
  end
  always @* begin
    if (begun_q && part_q == BEFORE && !between_q) begin
      if (this_port) begin
        assert (driven && !written_q && edge_q <= 5'd13);
        // Without a byte what is at its place is anything.
        if (!port_word || port != 7'd0 || found_q) assert (load_data == expected);
        if (adc) assert (edge_q > {2'd0, port[2:0]} + 5'd5);
      end
      if (load_valid) begin
        assert (load_write && used);
        if (load_space == BITS) assert (number < {18'd0, port_bits_i});
        else assert (load_space == WORDS && number < {13'd0, port_words_i});
      end
      if (start && driven) assert (written_q);
    end
    if (begun_q && part_q == RUNS) assert (!load_valid);
    if (begun_q && part_q == AFTER && load_valid) assert (!load_write);
  end

  // ---- what the program has done ----------------------------------------------------------------------
  reg left_rx_q, left_tx_q, left_persist_q;
  reg [2:0] bits_seen_q;  // answered since the program's end, as the next
  reg [6:0] words_seen_q;
  reg [15:0] sent_q, duty_q, hz_low_q, hz_high_q, index_q, value_q;
  reg [19:0] value_port_q;
  assign left_rx = answered && !answered_word && answered_port == 20'd0 ? load_rdata_i[0] :
      left_rx_q;

  always @(posedge clk_i) begin
    if (part_q != AFTER) begin
      bits_seen_q  <= 3'd0;
      words_seen_q <= 7'd0;
    end else if (answered) begin
      if (answered_word) words_seen_q[answered_place] <= 1'b1;
      else bits_seen_q[answered_place] <= 1'b1;
    end
    if (answered && !answered_word) begin
      case (answered_port)
        20'd0: left_rx_q <= load_rdata_i[0];
        20'd1: left_tx_q <= load_rdata_i[0];
        20'd2: left_persist_q <= load_rdata_i[0];
        default: ;
      endcase
    end
    if (answered && answered_word) begin
      case (answered_port)
        20'd1: sent_q <= load_rdata_i;
        20'd2: duty_q <= load_rdata_i;
        20'd3: hz_low_q <= load_rdata_i;
        20'd4: hz_high_q <= load_rdata_i;
        20'd5: index_q <= load_rdata_i;
        default: {value_port_q, value_q} <= {answered_port, load_rdata_i};
      endcase
    end
  end

  reg was_reset_q;
  reg had_pwm_q;
  reg [47:0] pwm_q;
  always @(posedge clk_i) begin
    was_reset_q <= !rst_ni;
    had_pwm_q <= has_pwm;
    pwm_q <= {duty, hz};
  end
  wire [16:0] kept_port = {1'b0, index_q} + 17'd16;
  always @* begin
    if (begun_q) begin
      assert (tx_valid == (decided && tx_q && !left_tx_q));
      if (tx_valid) assert (bits_seen_q[1] && words_seen_q[1] && tx_data == sent_q[7:0]);
      assert (keep_valid == (decided && persist_q && !left_persist_q &&
                             kept_port < {10'd0, port_words_i}));
      if (keep_valid) begin
        assert (keep_index == index_q[5:0] && keep_value == value_q);
        assert (value_port_q == {3'd0, kept_port});
      end
      if (decided) assert (&bits_seen_q && &words_seen_q[6:1]);
      if (takes) assert (bits_seen_q[0]);
      if (was_reset_q || !had_pwm_q) assert ({duty, hz} == 48'd0);
      else if (!decided) assert ({duty, hz} == pwm_q);
      else assert ({duty, hz} == {duty_q, has_pwm_high ? hz_high_q : 16'd0, hz_low_q});
    end
  end

  // ---- for the induction ---------------------------------------------------------------------------
  (* hierconn *) wire [2:0] \exchange.state_q ;
  (* hierconn *) wire [3:0] \exchange.slot_q ;
  (* hierconn *) wire [3:0] \exchange.answer_q ;
  (* hierconn *) wire \exchange.finish_q ;
  (* hierconn *) wire \exchange.kept_rx_q ;
  (* hierconn *) wire \exchange.kept_tx_q ;
  (* hierconn *) wire \exchange.kept_persist_q ;
  (* hierconn *) wire \exchange.rx_full_q ;
  (* hierconn *) wire \exchange.rx_newer_q ;
  (* hierconn *) wire \exchange.rx_lost_too_q ;
  (* hierconn *) wire [7:0] \exchange.rx_data_q ;
  (* hierconn *) wire \exchange.found_rx_q ;
  (* hierconn *) wire \exchange.found_tx_q ;
  (* hierconn *) wire \exchange.found_persist_q ;
  (* hierconn *) wire [7:0] \exchange.found_data_q ;
  (* hierconn *) wire [5:0] \exchange.index_q ;
  (* hierconn *) wire \exchange.index_valid_q ;
  (* hierconn *) wire [7:0] \exchange.tx_data_q ;
  (* hierconn *) wire [15:0] \exchange.keep_value_q ;
  (* hierconn *) wire [15:0] \exchange.new_duty_q ;
  (* hierconn *) wire [15:0] \exchange.new_hz_low_q ;
  (* hierconn *) wire [15:0] \exchange.new_hz_high_q ;

  // The read of a slot behind the program: word, device.
  function automatic [20:0] read_of(input reg [4:0] slot, input reg [5:0] index);
    case (slot)
      5'd0: read_of = {1'b1, LAST_WORD - 20'd5};
      5'd1: read_of = {1'b0, LAST_BIT};
      5'd2: read_of = {1'b0, LAST_BIT - 20'd1};
      5'd3: read_of = {1'b0, LAST_BIT - 20'd2};
      5'd8: read_of = {1'b1, LAST_WORD - 20'd16 - {14'd0, index}};
      default: read_of = {1'b1, LAST_WORD + 20'd3 - {15'd0, slot}};
    endcase
  endfunction

  wire [4:0] slot_now = edge_q - 5'd2;  // of what is shown at the load port
  wire [5:0] index_now = \exchange.index_q ;
  integer k;
  reg [4:0] slot_k;
  always @* begin
    slot_k = 5'd0;
    if (begun_q) begin
      if (part_q == BETWEEN) begin
        assert (\exchange.state_q == 3'd0);
        assert (!\exchange.finish_q );
        assert (!found_q);
      end else begin
        assert (edge_q != 5'd0 && edge_q <= 5'd17);
        assert (\exchange.found_rx_q == found_q);
        assert (\exchange.found_tx_q == tx_q && \exchange.found_persist_q == persist_q);
        if (found_q) assert (\exchange.rx_newer_q == newer_q);
        if (found_q) assert (\exchange.found_data_q == found_byte_q);
        if (found_q) assert (has_rx);
        if (tx_q) assert (has_tx);
        if (persist_q) assert (has_persist);
      end
      assert (\exchange.rx_full_q == waits_q);
      if (waits_q) assert (\exchange.rx_data_q == byte_q);
      assert (untold == {3'd0, rx_lost} + {3'd0, \exchange.rx_lost_too_q });
      if (found_q && !newer_q) assert (waits_q);
      if (\exchange.rx_lost_too_q ) assert (rx_lost && received_last_q);

      if (part_q == BEFORE) begin
        assert (edge_q <= start_edge);
        assert (\exchange.state_q == (edge_q == start_edge ? 3'd3 :
                                      edge_q + 5'd1 == start_edge ? 3'd2 : 3'd1));
        if (used && edge_q <= 5'd12) assert (\exchange.slot_q == edge_q[3:0] - 4'd1);
        if (used) begin
          for (k = 0; k < 6; k = k + 1) if (k + 2 < edge_q) assert (!asked_q[k][22]);
          if (driven && !port_word) assert (written_q == (edge_q > {port[4:0]} + 5'd2));
          if (driven && port_word && port == 7'd0) assert (written_q == (edge_q > 5'd5));
          if (driven && adc) begin
            assert (written_q == (edge_q > {2'd0, port[2:0]} + 5'd6));
          end
          if (!driven) assert (!written_q);
        end
      end
      if (part_q == RUNS) assert (\exchange.state_q == 3'd4);
      if (part_q != AFTER) begin
        for (k = 0; k < 6; k = k + 1) if (asked_q[k][22]) assert (asked_q[k][21]);
        if (part_q == RUNS && used) for (k = 0; k < 6; k = k + 1) assert (!asked_q[k][22]);
      end else begin
        assert (used);
        assert (\exchange.state_q == 3'd5 && \exchange.finish_q == decided);
        assert (\exchange.slot_q == (edge_q >= 5'd16 ? 4'd15 : edge_q[3:0] - 4'd1));
        assert (\exchange.answer_q == (edge_q <= 5'd8 ? 4'd0 : edge_q[3:0] - 4'd8));
        assert (load_valid == (edge_q >= 5'd2 && edge_q <= 5'd10));
        if (load_valid) begin
          assert ({load_space == WORDS, load_addr} == read_of(slot_now, index_now));
        end
        for (k = 0; k < 6; k = k + 1) begin
          slot_k = edge_q - 5'd3 - k[4:0];
          assert (asked_q[k][22] == (edge_q >= 5'd3 + k && slot_k <= 5'd8));
          if (asked_q[k][22]) begin
            assert (!asked_q[k][21]);
            assert (asked_q[k][20:0] == read_of(slot_k, index_now));
          end
        end
        if (edge_q > 5'd8) begin
          assert (words_seen_q[5] && index_now == index_q[5:0]);
          assert (\exchange.index_valid_q == (kept_port < {10'd0, port_words_i}) || !has_persist);
        end
        if (edge_q > 5'd9) assert (bits_seen_q[0] && \exchange.kept_rx_q == left_rx_q);
        if (edge_q > 5'd10) assert (bits_seen_q[1] && \exchange.kept_tx_q == left_tx_q);
        if (edge_q > 5'd11) assert (bits_seen_q[2] && \exchange.kept_persist_q == left_persist_q);
        if (edge_q > 5'd12) assert (words_seen_q[1] && \exchange.tx_data_q == sent_q[7:0]);
        if (edge_q > 5'd13) assert (words_seen_q[2] && \exchange.new_duty_q == duty_q);
        if (edge_q > 5'd14) assert (words_seen_q[3] && \exchange.new_hz_low_q == hz_low_q);
        if (edge_q > 5'd15) begin
          assert (words_seen_q[4]);
          assert (\exchange.new_hz_high_q == (has_pwm_high ? hz_high_q : 16'd0));
        end
        if (decided) begin
          assert (words_seen_q[6] && \exchange.keep_value_q == value_q);
          assert (value_port_q == {14'd0, index_q[5:0]} + 20'd16);
        end
      end
    end
  end

`ifdef RUNG_NARROW
  reg [2:0] age_q;
  initial age_q = 3'd0;
  always @(posedge clk_i) if (age_q != 3'd3) age_q <= age_q + 3'd1;
  always @* begin
    assume (begun_q == rst_ni && scan_i == (age_q == 3'd3) && done_i);
    assume (!host_valid_i && !restore_valid_i);
    assume (port_bits_i == 2'd3 && port_words_i == 7'd20 && adc_i == 128'd0);
    assume (tx_ready_i && persist_ready_i);
  end
`endif
  // A scan in which a byte is taken, one sent and a value kept; two lost bytes told one behind the other.
  reg took_q;
  reg lost_last_q;
  always @(posedge clk_i) begin
    took_q <= takes;
    lost_last_q <= rx_lost;
  end
  always @* begin
    cover (begun_q && took_q && tx_valid && keep_valid && keep_index == 6'd3 && hz == 32'h00050007);
    cover (begun_q && rx_lost && lost_last_q && decided_q);
  end
  reg decided_q;
  always @(posedge clk_i) decided_q <= decided;

endmodule

`default_nettype wire

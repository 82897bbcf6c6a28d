// SPDX-License-Identifier: Apache-2.0
// Host exchange (hdl/controller/host_exchange.v): a request that is pending at the beginning of a phase is carried out in it, all
// of its points, writes before reads, one a clock, each once, and it is over W + R + 13 clocks later at most (mask: R + 25), fewer
// than the phase has; nothing is read or written at any other time. A word of a write is the buffer's, and goes to the device
// that the map names, or vanishes; a word that is read is in the buffer when the request is done, 0 without an answer. A phase
// that is given up leaves the request pending. Any word of either.
`default_nettype none
`include "rung_controller.vh"

module host_exchange_proof (
    input wire        clk_i,
    input wire        start_i,
    input wire        restart_i,
    input wire        map_mapped_i,
    input wire [14:0] map_device_i,
    input wire        host_rvalid_i,
    input wire [15:0] host_rdata_i,
    input wire        sel_buffer_i,
    input wire        sel_register_i,
    input wire [ 7:0] addr_i,
    input wire        read_i,
    input wire        write_i,
    input wire [15:0] wdata_i
);

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;

  wire map_read, map_words, host_valid, host_write, host_words;
  wire [15:0] map_point, host_data, rdata;
  wire [14:0] host_addr;
  host_exchange exchange (
      .clk_i         (clk_i),
      .rst_ni        (begun_q),
      .start_i       (start_i),
      .restart_i     (restart_i),
      .map_read_o    (map_read),
      .map_words_o   (map_words),
      .map_point_o   (map_point),
      .map_mapped_i  (map_mapped_i),
      .map_device_i  (map_device_i),
      .host_valid_o  (host_valid),
      .host_write_o  (host_write),
      .host_words_o  (host_words),
      .host_addr_o   (host_addr),
      .host_data_o   (host_data),
      .host_rvalid_i (host_rvalid_i),
      .host_rdata_i  (host_rdata_i),
      .sel_buffer_i  (sel_buffer_i),
      .sel_register_i(sel_register_i),
      .addr_i        (addr_i),
      .read_i        (read_i),
      .write_i       (write_i),
      .wdata_i       (wdata_i),
      .rdata_o       (rdata)
  );

  // ---- the request, as it was written ------------------------------------------------------------------------
  reg pending_q;
  reg run_q;
  reg [4:0] control_q;  // mask, raw, words, read, write
  reg [15:0] write_first_q, read_first_q;
  reg [11:0] write_count_q, read_count_q;
  wire register = sel_register_i && write_i;
  wire asks = register && addr_i == `RUNG_REG_EXCHANGE_CONTROL;
  wire words = control_q[2] || control_q[4];
  wire raw = control_q[3];
  wire mask = control_q[4];
  wire done;
  always @* begin
    // Registers and buffer are left alone while a request runs; one is posted when the one before is done.
    assume (!(run_q || start_i) || !(register || (sel_buffer_i && (write_i || read_i))));
    assume (!asks || !pending_q);
    assume (!(sel_buffer_i && sel_register_i));
    assume (!register || (addr_i != `RUNG_REG_EXCHANGE_WRITE_COUNT &&
                          addr_i != `RUNG_REG_EXCHANGE_READ_COUNT) || wdata_i < 16'd8);
    // The phase has room for the request: see below.
    assume (!(start_i && run_q));
  end
  always @(posedge clk_i) begin
    if (register) begin
      case (addr_i)
        `RUNG_REG_EXCHANGE_CONTROL: control_q <= wdata_i[4:0];
        `RUNG_REG_EXCHANGE_WRITE_FIRST: write_first_q <= wdata_i;
        `RUNG_REG_EXCHANGE_WRITE_COUNT: write_count_q <= wdata_i[11:0];
        `RUNG_REG_EXCHANGE_READ_FIRST: read_first_q <= wdata_i;
        `RUNG_REG_EXCHANGE_READ_COUNT: read_count_q <= wdata_i[11:0];
        default: ;
      endcase
    end
    pending_q <= begun_q && (asks || (pending_q && !done));
  end

  // ---- its clocks: clock_q is 1 in the one behind start_i -------------------------------------------------------
  reg  [13:0] clock_q;
  wire [13:0] writes = {2'd0, control_q[0] ? write_count_q : 12'd0};
  wire [13:0] reads = {2'd0, control_q[1] ? read_count_q : 12'd0};
  wire [13:0] write_clocks = !control_q[0] ? 14'd0 : writes == 14'd0 ? 14'd1 : writes;
  wire [13:0] setup_at = mask ? 14'd13 : write_clocks + 14'd1;
  wire [13:0] read_clocks = reads == 14'd0 ? 14'd1 : reads;
  wire [13:0] done_at = reads == 14'd0 ? setup_at + 14'd2 : setup_at + 14'd11 + reads;
  assign done = run_q && clock_q == done_at;
  always @(posedge clk_i) begin
    run_q   <= begun_q && !restart_i && ((start_i && pending_q && !run_q) || (run_q && !done));
    clock_q <= run_q ? clock_q + 14'd1 : 14'd1;
  end
  function automatic write_at(input reg [13:0] at);
    write_at = run_q && (mask ? at == 14'd12 : at >= 14'd1 && at <= writes);
  endfunction
  function automatic read_at(input reg [13:0] at);
    read_at = run_q && ((mask && at == 14'd1) || (at > setup_at && at <= setup_at + reads));
  endfunction

  // ---- any word --------------------------------------------------------------------------------------------------
  (* hierconn *) wire [7:0] \exchange.buffer.watched ;
  (* hierconn *) wire [15:0] \exchange.buffer.word_q ;
  (* hierconn *) wire [15:0] \exchange.buffer.read_data_q ;
  wire [13:0] place = {6'd0, \exchange.buffer.watched };
  wire [13:0] answer_place = {7'd0, \exchange.buffer.watched [6:0]};
  wire of_answer = \exchange.buffer.watched [7];
  reg mapped_q;
  reg [14:0] device_q;
  reg [15:0] answer_q;
  wire [15:0] answer = host_rvalid_i ? host_rdata_i : 16'd0;
  wire answers = run_q && clock_q == setup_at + 14'd11 + answer_place && answer_place < reads;
  reg [15:0] buffer_q;  // the watched word, as the request found it
  reg done_q;
  always @(posedge clk_i) begin
    {mapped_q, device_q} <= {map_mapped_i, map_device_i};
    if (answers) answer_q <= answer;
    if (!run_q) buffer_q <= \exchange.buffer.word_q ;
    done_q <= begun_q && done && !restart_i && words && of_answer && answer_place < reads &&
        reads <= 14'd128;
  end

  wire access = (write_at(clock_q - 14'd2) || read_at(clock_q - 14'd2)) && clock_q >= 14'd3;
  wire here = !mask && words && !of_answer && write_at(clock_q - 14'd2) && clock_q == place + 14'd3;
  wire [15:0] point = write_at(
      clock_q
  ) ? write_first_q + (mask ? 16'd0 : {2'd0, clock_q} - 16'd1) :
      mask && clock_q == 14'd1 ? write_first_q : read_first_q + {2'd0, clock_q - setup_at} - 16'd1;
  reg [14:0] point_1_q, point_2_q;
  always @(posedge clk_i) {point_1_q, point_2_q} <= {point[14:0], point_1_q};
  always @* begin
    if (begun_q) begin
      assert (map_read == (write_at(clock_q) || read_at(clock_q)));
      if (map_read) assert (map_point == point && map_words == words);
      assert (host_valid == (access && (raw || mapped_q)));
      if (host_valid) begin
        assert (host_words == words && host_write == write_at(clock_q - 14'd2));
        assert (host_addr == (raw ? point_2_q : device_q));
      end
      if (here && host_valid) assert (host_data == buffer_q);
      // Bounded, and within writes + reads + 32.
      if (run_q && !mask) assert (clock_q <= writes + reads + 14'd13);
      if (run_q && mask) assert (clock_q <= reads + 14'd25);
      if (done_q) assert (\exchange.buffer.word_q == answer_q);
    end
  end

  // ---- for the induction -------------------------------------------------------------------------------------------
  (* hierconn *) wire [2:0] \exchange.state_q ;
  (* hierconn *) wire \exchange.pending_q ;
  (* hierconn *) wire [15:0] \exchange.point_q ;
  (* hierconn *) wire [11:0] \exchange.left_q ;
  (* hierconn *) wire [11:0] \exchange.index_q ;
  (* hierconn *) wire [11:0] \exchange.unanswered_q ;
  (* hierconn *) wire [11:0] \exchange.got_q ;
  (* hierconn *) wire [7:0] \exchange.await_q ;
  (* hierconn *) wire \exchange.looked_q ;
  (* hierconn *) wire \exchange.access_q ;
  (* hierconn *) wire \exchange.read_q ;
  (* hierconn *) wire \exchange.with_write_q ;
  (* hierconn *) wire \exchange.with_read_q ;
  (* hierconn *) wire \exchange.words_q ;
  (* hierconn *) wire \exchange.raw_q ;
  (* hierconn *) wire \exchange.mask_q ;
  (* hierconn *) wire [15:0] \exchange.write_first_q ;
  (* hierconn *) wire [11:0] \exchange.write_count_q ;
  (* hierconn *) wire [15:0] \exchange.read_first_q ;
  (* hierconn *) wire [11:0] \exchange.read_count_q ;
  (* hierconn *) wire \exchange.store_q ;
  (* hierconn *) wire [6:0] \exchange.store_addr_q ;
  (* hierconn *) wire [15:0] \exchange.store_data_q ;
  (* hierconn *) wire \exchange.looked_write_q ;
  (* hierconn *) wire \exchange.looked_mask_q ;
  (* hierconn *) wire [14:0] \exchange.looked_point_q ;
  wire [13:0] came = clock_q <= setup_at + 14'd11 ? 14'd0 :
      clock_q - setup_at - 14'd11 > reads ? reads : clock_q - setup_at - 14'd11;
  reg [4:0] set_q;
  always @(posedge clk_i) begin
    if (!begun_q) set_q <= 5'd0;
    else if (register) begin
      set_q <= set_q | {addr_i == `RUNG_REG_EXCHANGE_CONTROL,
                        addr_i == `RUNG_REG_EXCHANGE_WRITE_FIRST,
                        addr_i == `RUNG_REG_EXCHANGE_WRITE_COUNT,
                        addr_i == `RUNG_REG_EXCHANGE_READ_FIRST,
                        addr_i == `RUNG_REG_EXCHANGE_READ_COUNT};
    end
  end
  always @* assume (!asks || &set_q[3:0]);
  integer i;
  always @* begin
    if (begun_q) begin
      if (set_q[2]) assert (write_count_q < 12'd8);
      if (set_q[0]) assert (read_count_q < 12'd8);
      assert (\exchange.pending_q == pending_q);
      if (run_q) assert (pending_q);
      if (pending_q) assert (&set_q);
      if (set_q[4]) begin
        assert ({\exchange.mask_q , \exchange.raw_q } == control_q[4:3]);
        assert ({\exchange.with_read_q , \exchange.with_write_q } == control_q[1:0]);
        assert (\exchange.words_q == words);
      end
      if (set_q[3]) assert (\exchange.write_first_q == write_first_q);
      if (set_q[2]) assert (\exchange.write_count_q == write_count_q);
      if (set_q[1]) assert (\exchange.read_first_q == read_first_q);
      if (set_q[0]) assert (\exchange.read_count_q == read_count_q);
      if (!run_q) begin
        assert (\exchange.state_q == 3'd0 && \exchange.await_q == 8'd0);
        assert (!\exchange.looked_q && !\exchange.access_q && !\exchange.read_q );
      end else begin
        assert (clock_q >= 14'd1 && clock_q <= done_at);
        assert (\exchange.looked_q == (clock_q >= 14'd2 && (write_at(
            clock_q - 14'd1
        ) || read_at(
            clock_q - 14'd1
        ))));
        assert (\exchange.read_q == (clock_q >= 14'd3 && read_at(clock_q - 14'd2)));
        if (\exchange.looked_q ) begin
          assert (\exchange.looked_write_q == write_at(clock_q - 14'd1));
          assert (\exchange.looked_point_q == point_1_q);
          assert (\exchange.looked_mask_q == (mask && clock_q == 14'd13));
          if (words && !mask && !of_answer && clock_q == place + 14'd2 &&
              \exchange.looked_write_q ) begin
            assert (\exchange.buffer.read_data_q == buffer_q);
          end
        end
        for (i = 0; i < 8; i = i + 1) begin
          assert (\exchange.await_q [i] == (clock_q >= 14'd4 + i && read_at(clock_q - 14'd3 - i)));
        end
        if (clock_q < setup_at && !mask) begin
          assert (\exchange.state_q == 3'd4 && \exchange.index_q == clock_q[11:0] - 12'd1);
          assert ({2'd0, \exchange.left_q } == writes - clock_q + 14'd1);
          assert (\exchange.point_q == write_first_q + {2'd0, clock_q} - 16'd1);
        end
        if (clock_q < setup_at && mask) begin
          assert (\exchange.state_q == (clock_q == 14'd1 ? 3'd1 : clock_q == 14'd12 ? 3'd3 : 3'd2));
          assert (\exchange.point_q == write_first_q);
        end
        if (clock_q == setup_at) assert (\exchange.state_q == 3'd5);
        if (clock_q > setup_at) begin
          assert (\exchange.state_q == (clock_q <= setup_at + read_clocks ? 3'd6 : 3'd7));
          assert ({2'd0, \exchange.unanswered_q } == reads - came);
          assert ({2'd0, \exchange.got_q } == came);
          if (clock_q <= setup_at + read_clocks) begin
            assert ({2'd0, \exchange.left_q } == reads - (clock_q - setup_at - 14'd1));
            assert (\exchange.point_q == read_first_q + {2'd0, clock_q - setup_at} - 16'd1);
          end
          if (words && of_answer && \exchange.store_q ) begin
            assert (\exchange.store_addr_q == came[6:0] - 7'd1);
            if (came == answer_place + 14'd1) assert (\exchange.store_data_q == answer_q);
          end
          if (words && answer_place < reads && clock_q == setup_at + 14'd12 + answer_place) begin
            assert (\exchange.store_q );
          end
          if (words && of_answer && reads <= 14'd128 && came > answer_place + 14'd1) begin
            assert (\exchange.buffer.word_q == answer_q);
          end
        end
        if (clock_q <= setup_at) assert (!\exchange.store_q );
        if (!of_answer) assert (\exchange.buffer.word_q == buffer_q);
      end
    end
  end

`ifdef RUNG_NARROW
  always @*
    assume ((!asks || wdata_i[4:0] == 5'd15) && map_mapped_i && host_rvalid_i);
  always @* assume (!register || addr_i == `RUNG_REG_EXCHANGE_CONTROL || wdata_i <= 16'd1);
`endif
  always @* cover (begun_q && done && writes == 14'd1 && reads == 14'd1);

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// Copies (hdl/flow/flow_copy.v) between a memory of blocks, a device map and devices, of which this keeps one word, one point and one
// device, any of them: when a copy is done the word is the device's or the device has the word, whichever way it went, and
// nothing else has been written; a point without a device reads 0, and its write vanishes. A copy takes the clocks of its page;
// what is stopped does nothing more. The processor does not write devices meanwhile.
`default_nettype none

module flow_copy_proof (
    input wire        clk_i,
    input wire        rst_ni,
    input wire        stop_i,
    input wire        start_i,
    input wire        put_i,
    input wire        to_block_i,
    input wire        mapped_i,
    input wire [15:0] first_i,
    input wire [ 5:0] count_i,
    input wire [ 4:0] block_i,
    input wire [15:0] put_data_i,
    input wire [15:0] mem_rdata_i,
    input wire        map_mapped_i,
    input wire [14:0] map_device_i,
    input wire        host_rvalid_i,
    input wire [15:0] host_rdata_i,
    // inside of it
    input wire [15:0] peek_point,
    input wire [ 5:0] peek_left,
    input wire [ 5:0] peek_unanswered,
    input wire [ 4:0] peek_block,
    input wire [ 4:0] peek_index,
    input wire        peek_to_block,
    input wire        peek_mapped,
    input wire        peek_looked,
    input wire        peek_looked_last,
    input wire [14:0] peek_looked_device,
    input wire        peek_access_last,
    input wire        peek_read,
    input wire [ 7:0] peek_await,
    input wire        peek_answered
);

  (* anyconst *) wire [9:0] place;  // of the word
  (* anyconst *) wire [14:0] device;
  (* anyconst *) wire [15:0] point;
  (* anyconst *) wire there;  // the point has a device: this one, which is no other point's

  wire done, mem_valid, mem_write, map_read, map_words, host_valid, host_write, host_words;
  wire [9:0] mem_addr;
  wire [15:0] mem_wdata, map_point, host_data;
  wire [14:0] host_addr;
  flow_copy copy (
      .clk_i        (clk_i),
      .rst_ni       (rst_ni),
      .stop_i       (stop_i),
      .start_i      (start_i),
      .put_i        (put_i),
      .to_block_i   (to_block_i),
      .mapped_i     (mapped_i),
      .first_i      (first_i),
      .count_i      (count_i),
      .block_i      (block_i),
      .put_data_i   (put_data_i),
      .done_o       (done),
      .mem_valid_o  (mem_valid),
      .mem_write_o  (mem_write),
      .mem_addr_o   (mem_addr),
      .mem_wdata_o  (mem_wdata),
      .mem_rdata_i  (mem_rdata_i),
      .map_read_o   (map_read),
      .map_words_o  (map_words),
      .map_point_o  (map_point),
      .map_mapped_i (map_mapped_i),
      .map_device_i (map_device_i),
      .host_valid_o (host_valid),
      .host_write_o (host_write),
      .host_words_o (host_words),
      .host_addr_o  (host_addr),
      .host_data_o  (host_data),
      .host_rvalid_i(host_rvalid_i),
      .host_rdata_i (host_rdata_i)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  // ---- the copy that was started ---------------------------------------------------------------------
  reg to_block_q, mapped_q;
  reg [15:0] first_q;
  reg [5:0] count_q;
  reg [4:0] block_q;
  reg [5:0] clock_q;  // 1 in the clock after start_i, and on; 0: none goes on
  wire going = clock_q != 6'd0;
  wire starts = start_i && rst_ni && !stop_i;
  wire [5:0] last = count_q + (to_block_q ? 6'd11 : 6'd2);
  reg put_q;  // in the clock before
  reg [15:0] put_first_q, put_data_q;
  always @* begin
    assume (!(start_i && put_i) && !(going && (start_i || put_i)));
    if (start_i) assume (count_i >= 6'd1 && count_i <= 6'd32);
  end
  always @(posedge clk_i) begin
    if (!rst_ni || stop_i || clock_q == last) clock_q <= starts ? 6'd1 : 6'd0;
    else if (start_i) clock_q <= 6'd1;
    else if (going) clock_q <= clock_q + 6'd1;
    if (starts) begin
      {to_block_q, mapped_q} <= {to_block_i, mapped_i};
      {first_q, count_q, block_q} <= {first_i, count_i, block_i};
    end
    put_q <= put_i && rst_ni && !stop_i;
    {put_first_q, put_data_q} <= {first_i, put_data_i};
  end

  // ---- the world around it: a word, a point, a device ---------------------------------------------------
  reg [15:0] word_q, value_q;
  reg word_read_q, point_read_q, map_read_q;
  reg [7:0] read_q;  // of any device, the newest lowest
  reg [7:0] device_read_q;
  reg [127:0] read_values_q;
  wire device_here = host_valid && host_addr == device;
  always @(posedge clk_i) begin
    if (mem_valid && mem_write && mem_addr == place) word_q <= mem_wdata;
    word_read_q  <= mem_valid && !mem_write && mem_addr == place;
    point_read_q <= map_read && map_point == point;
    map_read_q   <= map_read;
    if (device_here && host_write) value_q <= host_data;
    read_q <= {read_q[6:0], host_valid && !host_write};
    device_read_q <= {device_read_q[6:0], device_here && !host_write};
    read_values_q <= {read_values_q[111:0], value_q};
    if (!begun_q) {read_q, device_read_q} <= 16'd0;
  end
  reg [15:0] read_word_q;
  always @(posedge clk_i) read_word_q <= word_q;
  always @* begin
    if (word_read_q) assume (mem_rdata_i == read_word_q);
    if (point_read_q) assume (map_mapped_i == there && (!there || map_device_i == device));
    if (map_read_q && !point_read_q) assume (!map_mapped_i || map_device_i != device);
    assume (host_rvalid_i == read_q[7]);
    if (device_read_q[7]) assume (host_rdata_i == read_values_q[127:112]);
  end

  // ---- what the copy is to do with them ---------------------------------------------------------------
  wire [15:0] offset = mapped_q ? point - first_q : {1'b0, device - first_q[14:0]};
  // It is one of the copy's; of a mapped one, its point.
  wire of_device = offset < {10'd0, count_q};
  wire of_word = place[9:5] == block_q && {1'b0, place[4:0]} < count_q;
  wire same = of_device && of_word && offset[4:0] == place[4:0];
  wire exists = !mapped_q || there;
  reg done_q;
  always @(posedge clk_i) done_q <= done && begun_q && rst_ni && !stop_i && !start_i && !put_i;

  wire put_here = put_q && put_first_q[14:0] == device;
  reg put_here_q;
  reg [15:0] put_value_q;
  always @(posedge clk_i) begin
    put_here_q  <= put_here && begun_q && !stop_i && rst_ni;
    put_value_q <= put_data_q;
  end
  always @* begin
    if (begun_q) begin
      assert (done == (going && clock_q == last));
      if (done && to_block_q && same) assert (word_q == (exists ? value_q : 16'd0));
      if (done_q && !to_block_q && same && exists) assert (value_q == word_q);
      if (put_here_q) assert (value_q == put_value_q);
      // Nothing else is written or asked.
      if (mem_valid) assert (going && (mem_addr != place || of_word) && mem_write == to_block_q);
      if (host_valid) assert (going || put_q);
      if (map_read) assert (going && mapped_q && map_words);
      if (device_here) begin
        assert (host_words);
        if (put_q) assert (host_write && put_first_q[14:0] == device);
        else assert (host_write == !to_block_q && of_device && exists);
        if (!put_q) assert (clock_q == offset[5:0] + 6'd3);  // once
      end
    end
  end

  // ---- for the induction --------------------------------------------------------------------------------
  wire [5:0] issued = clock_q - 6'd1;  // words that have been asked for
  wire [5:0] answered = clock_q <= 6'd11 ? 6'd0 : clock_q - 6'd11;
  wire [5:0] since = clock_q - 6'd3 - place[4:0];  // clocks since the word's device was read
  integer k;
  always @* begin
    if (begun_q) begin
      assert (clock_q <= 6'd43);
      if (going) begin
        assert (count_q >= 6'd1 && count_q <= 6'd32 && clock_q <= last);
        assert (!put_q || clock_q == 6'd1);
        assert (peek_to_block == to_block_q && peek_mapped == mapped_q && peek_block == block_q);
        assert (peek_left == (issued < count_q ? count_q - issued : 6'd0));
        if (issued <= count_q) assert (peek_point == first_q + {10'd0, issued});
        if (to_block_q) begin
          assert ({1'b0, peek_index} == answered || answered[5]);
          assert (peek_unanswered == count_q - answered);
        end else begin
          if (issued < count_q) assert (peek_index == issued[4:0]);
          assert (peek_unanswered == 6'd0);
        end
        assert (peek_looked == (issued >= 6'd1 && issued <= count_q));
        assert (peek_looked_last == (!to_block_q && issued == count_q));
        if (peek_looked) assert (peek_looked_device == first_q[14:0] + {9'd0, issued - 6'd1});
        assert (peek_access_last == (!to_block_q && issued == count_q + 6'd1));
        assert (peek_read == (to_block_q && issued >= 6'd2 && issued <= count_q + 6'd1));
        for (k = 0; k < 8; k = k + 1) begin
          assert (peek_await[k] == (to_block_q && issued >= k[5:0] + 6'd3 &&
              issued <= count_q + k[5:0] + 6'd2));
        end
        assert (peek_answered == (to_block_q && clock_q == last));
        assert (point_read_q == (mapped_q && of_device && clock_q == offset[5:0] + 6'd2));
        assert (word_read_q == (!to_block_q && of_word && clock_q == {1'b0, place[4:0]} + 6'd2));
        if (same && clock_q == {1'b0, place[4:0]} + 6'd3) begin
          assert (host_valid == exists && (!exists || host_addr == device));
        end
        // The word's device, on its way back.
        if (to_block_q && same) begin
          for (k = 0; k < 8; k = k + 1) begin
            if (clock_q > {1'b0, place[4:0]} + 6'd3 && since == k[5:0] + 6'd1) begin
              assert (device_read_q[k] == exists && read_q[k] == exists);
              if (exists) assert (read_values_q[16*k+:16] == value_q);
            end
          end
          if (answered > {1'b0, place[4:0]}) assert (word_q == (exists ? value_q : 16'd0));
        end
        if (!to_block_q && same) begin
          if (exists && clock_q == {1'b0, place[4:0]} + 6'd3)
            assert (host_valid && host_data == word_q && host_addr == device);
          if (exists && clock_q > {1'b0, place[4:0]} + 6'd3) assert (value_q == word_q);
        end
      end else begin
        assert (peek_left == 6'd0 && !peek_looked && !peek_looked_last && !peek_access_last);
        assert (!peek_read && peek_await == 8'd0 && !peek_answered && peek_unanswered == 6'd0);
        assert (host_valid == put_q);
      end
      if (put_q)
        assert (host_valid && host_write && host_addr == put_first_q[14:0] &&
            host_data == put_data_q);
    end
  end

  always @* begin
    cover (begun_q && done && to_block_q && same && exists && mapped_q && place[4:0] == 5'd2 &&
        word_q == 16'h1234);
    cover (begun_q && done_q && !to_block_q && same && exists && mapped_q &&
        place[4:0] == 5'd2 && value_q == 16'h1234);
    cover (begun_q && done && to_block_q && same && !exists);
  end

endmodule

`default_nettype wire

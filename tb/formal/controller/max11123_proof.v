// SPDX-License-Identifier: Apache-2.0
// MAX11123 converter (hdl/peripherals/max11123.v) with a chip at its pins that answers each frame with any 16 bits, the next one
// HALF - 2 clocks behind each falling edge. What the chip sees: the clock rests at 1 where csn_o changes, between two
// changes of the two are HALF clocks at least, data stand HALF clocks behind a rising edge and HALF - 1 behind it, a frame is 16 bits and
// begins 36 * HALF clocks behind the one before. Frames are a reset, three registers, then channels 0 to 7 in turn, for ever
// (the words are the data sheet's fields). What the program sees: from the third channel's frame on, the answers of each
// channel, the last one whole, changed in one clock at its frame's end; never any other; 0 since a reset.
`default_nettype none

module max11123_proof #(
    parameter integer HALF = 4
) (
    input wire clk_i,
    input wire rst_ni,
    input wire miso_i
);

  wire csn, sck, mosi;
  wire [127:0] samples;
  max11123 #(
      .HALF(HALF)
  ) adc (
      .clk_i    (clk_i),
      .rst_ni   (rst_ni),
      .csn_o    (csn),
      .sck_o    (sck),
      .mosi_o   (mosi),
      .miso_i   (miso_i),
      .samples_o(samples)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  // ---- the chip --------------------------------------------------------------------------------------
  localparam [7:0] LONG = 2 * HALF;
  (* anyseq *) wire [15:0] any;
  reg csn_q, sck_q, mosi_q;
  reg [4:0] falls_q;  // in this frame
  reg [4:0] bits_q;
  reg [15:0] word_q;
  reg [15:0] answer_q;
  reg [7:0] since_q;  // clocks since csn or sck changed, to LONG
  reg [7:0] steady_q;  // since mosi changed, to LONG
  reg [9:0] clocks_q;  // since the frame's beginning
  reg first_q;  // there was none yet

  wire fall = sck_q && !sck;
  wire rise = !sck_q && sck;
  wire begins = csn_q && !csn;
  wire ends = !csn_q && csn;
  wire change = fall || rise || begins || ends;
  wire [4:0] falls = falls_q + {4'd0, fall};
  wire [7:0] since = change ? 8'd0 : since_q;
  wire answers = !csn && falls != 5'd0 && (sck || since + 8'd3 >= HALF);
  wire [4:0] place = 5'd16 - falls;
  always @* if (answers) assume (miso_i == answer_q[place[3:0]]);

  // ---- frames ----------------------------------------------------------------------------------------
  reg [2:0] frames_q;  // ended since a reset, to 6
  reg [2:0] channel_q;
  reg [15:0] expected;
  always @* begin
    case (frames_q)
      3'd0: expected = 16'b0_0000_0000_10_00_0_0_0;  // mode control: reset
      3'd1: expected = 16'b10000_00000000000;  // configuration
      3'd2: expected = 16'b10001_00000000000;  // unipolar
      3'd3: expected = 16'b10010_00000000000;  // bipolar
      // mode control: manual, channel, no reset, awake, answers with channel, converts with csn
      default: expected = {1'b0, 4'b0001, 1'b0, channel_q, 2'b00, 2'b00, 1'b1, 1'b1, 1'b0};
    endcase
  end

  (* anyconst *) wire [2:0] channel;
  wire [15:0] sample = samples[16*channel+:16];
  reg [11:0] value_q;
  wire takes = frames_q == 3'd6 && answer_q[15:12] == {1'b0, channel};
  wire [11:0] value = takes ? answer_q[11:0] : value_q;

  always @(posedge clk_i) begin
    csn_q <= csn || !rst_ni;
    sck_q <= sck || !rst_ni;
    mosi_q <= mosi;
    falls_q <= csn || !rst_ni ? 5'd0 : falls;
    bits_q <= csn || !rst_ni ? 5'd0 : bits_q + {4'd0, rise};
    if (rise) word_q <= {word_q[14:0], mosi};
    if (csn || !rst_ni) answer_q <= any;
    since_q <= !rst_ni ? LONG : since == LONG ? LONG : since + 8'd1;
    steady_q <= mosi != mosi_q ? 8'd1 : steady_q >= LONG ? LONG : steady_q + 8'd1;
    clocks_q <= begins ? 10'd1 : clocks_q + 10'd1;
    if (!rst_ni) begin
      frames_q <= 3'd0;
      channel_q <= 3'd0;
      value_q <= 12'd0;
      first_q <= 1'b1;
    end else begin
      if (begins) first_q <= 1'b0;
      if (ends) begin
        if (frames_q != 3'd6) frames_q <= frames_q + 3'd1;
        if (frames_q >= 3'd4) channel_q <= channel_q + 3'd1;
        value_q <= value;
      end
    end
  end

  always @* begin
    if (begun_q) begin
      if (csn) assert (sck);
      if (begins || ends) assert (sck && sck_q);
      if (change) assert (since_q >= HALF);
      if (rise) assert (steady_q >= HALF && mosi == mosi_q);
      if (!csn && mosi != mosi_q) assert (sck && since_q + 8'd1 >= HALF);
      if (begins && !first_q) assert (clocks_q == 36 * HALF);
      if (ends) assert (bits_q == 5'd16 && word_q == expected);
      assert (sample == {4'd0, value_q} ||
              (sample == {4'd0, value} && (ends || (!csn && bits_q == 5'd16))));
      if (ends) assert (sample == {4'd0, value});
    end
  end

  // ---- for the induction: where the hardware is, and the pins a clock behind it ---------------------------
  (* hierconn *) wire [$clog2(HALF)-1:0] \adc.divider_q ;
  (* hierconn *) wire [5:0] \adc.half_q ;
  (* hierconn *) wire [3:0] \adc.frame_q ;
  (* hierconn *) wire \adc.answers_q ;
  (* hierconn *) wire [15:0] \adc.send_q ;
  (* hierconn *) wire [15:0] \adc.received_q ;
  (* hierconn *) wire \adc.miso_q ;
  wire [5:0] half = \adc.half_q ;
  wire [7:0] clock = \adc.divider_q ;
  reg [5:0] half_q;
  reg [7:0] clock_q;
  reg fresh_q;  // since a reset, to the second half
  always @(posedge clk_i) begin
    half_q  <= rst_ni ? half : 6'd0;
    clock_q <= rst_ni ? clock : 8'd0;
    fresh_q <= !rst_ni || (fresh_q && half == 6'd0);
  end

  function automatic low(input reg [5:0] at);
    low = at[0] && at >= 6'd3 && at != 6'd35;
  endfunction
  function automatic [4:0] halves(input reg [5:0] at, input reg [5:0] from);
    reg [5:0] passed;
    begin
      passed = at - from;
      halves = at < from ? 5'd0 : passed[5:1] == 5'd16 ? 5'd16 : passed[5:1] + 5'd1;
    end
  endfunction

  wire last_clock = half_q == 6'd35 && clock_q == HALF - 1;
  wire first_clock = half_q == 6'd0 && clock_q == 8'd0 && !fresh_q;
  wire ahead = last_clock || first_clock;  // the hardware is in the next frame
  wire [5:0] behind = clock_q != 8'd0 ? half_q : half_q == 6'd0 ? 6'd35 : half_q - 6'd1;
  wire [2:0] frame = {1'b0, frames_q} + {3'd0, ahead} > 4'd6 ? 3'd6 : frames_q + {2'd0, ahead};
  wire [2:0] next_channel = channel_q + {2'd0, ahead && frames_q >= 3'd4};
  wire [9:0] at = half_q * HALF + clock_q;
  wire [4:0] sent = halves(behind, 6'd4);
  wire [4:0] unsent = 5'd16 - sent;
  wire [4:0] left = 5'd16 - halves(half, 6'd4);
  wire [5:0] shifted = (half - 6'd3) >> 1;
  wire [5:0] shifted_before = (half_q - 6'd3) >> 1;
  wire [15:0] shown_before = expected << shifted_before;
  wire [4:0] coming = 5'd16 - halves(half, 6'd3);

  always @* begin
    if (begun_q) begin
      assert (half <= 6'd35 && clock < HALF && half_q <= 6'd35 && clock_q < HALF);
      if (!fresh_q || clock_q != 8'd0 || half != 6'd0 || clock != 8'd0) begin
        assert (clock == (clock_q == HALF - 1 ? 8'd0 : clock_q + 8'd1));
        assert (half == (clock_q != HALF - 1 ? half_q : half_q == 6'd35 ? 6'd0 : half_q + 6'd1));
      end
      if (fresh_q) assert (half_q == 6'd0 && first_q && frames_q == 3'd0);
      assert (csn == (half_q < 6'd2) && sck == !low(half_q));
      assert (csn_q == (behind < 6'd2 || (fresh_q && half_q == 6'd0)));
      assert (sck_q == !low(behind));
      if (!(fresh_q && half_q == 6'd0)) begin
        assert (falls_q == (behind < 6'd3 ? 5'd0 : halves(behind, 6'd3)));
        assert (bits_q == sent);
        if (behind >= 6'd4) begin
          assert (word_q << unsent == (expected >> unsent) << unsent);
        end
      end else begin
        assert (falls_q == 5'd0 && bits_q == 5'd0);
      end
      if (half_q >= 6'd2 && half_q <= 6'd34) assert (since == clock_q);
      if (half_q == 6'd35) assert (since == clock_q + HALF);
      if (half_q < 6'd2) assert (since >= clock_q + (half_q == 6'd1 ? HALF : 0));
      assert (since_q <= LONG && steady_q <= LONG);
      assert (first_q == (first_q && at <= 2 * HALF));
      if (at > 2 * HALF) assert (!first_q && clocks_q == at - 2 * HALF);
      else if (!first_q) assert (clocks_q == at + 34 * HALF);

      assert (\adc.frame_q == (frame < 3'd4 ? {1'b0, frame} : {1'b1, next_channel}));
      assert (\adc.answers_q == (frame == 3'd6));
      if (frames_q < 3'd4) assert (channel_q == 3'd0);
      if (frames_q >= 3'd4 && frames_q < 3'd6) assert (channel_q == frames_q - 3'd4);
      assert (frames_q <= 3'd6);
      if (half >= 6'd3) assert (\adc.send_q == expected << shifted);
      if (half_q >= 6'd3 && half >= 6'd3) assert (mosi_q == shown_before[15]);
      if (half[0] && half >= 6'd3 && clock != 8'd0) assert (steady_q >= clock);
      if (!half[0] && half >= 6'd4) begin
        assert (mosi == mosi_q && steady_q >= (clock + HALF > LONG ? LONG : clock + HALF));
      end
      if (half >= 6'd4) begin
        assert (\adc.received_q << left == (answer_q >> left) << left);
      end
      if (low(half) && clock == HALF - 1) assert (\adc.miso_q == answer_q[coming[3:0]]);
      assert (sample == {4'd0, ahead ? value : value_q});
    end
  end

`ifdef RUNG_NARROW
  always @* assume (begun_q == rst_ni && any == 16'h39ab);
`endif
  // The first frame's end. (Sampling takes 7 frames: out of reach of a search from a reset.)
  always @* begin
    cover (begun_q && ends && word_q == 16'h0040);
  end

endmodule

`default_nettype wire

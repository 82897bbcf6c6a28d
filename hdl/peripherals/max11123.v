// SPDX-License-Identifier: Apache-2.0
// MAX11123 converter (12 bits, 8 channels): reads channels 0 to 7 in turn, for ever. samples_o holds the
// last sample of channel n in bits 16n + 11 to 16n, the bits above it are 0; all are 0 after reset. A
// sample changes in one clock, never bit by bit.
// SPI as the chip wants it: the clock rests at 1, data change at its falling edge and are taken at its rising
// edge, a frame is 16 bits between two edges of csn_o. After a reset and the registers for single-ended
// unipolar inputs, each frame selects a channel (manual mode, external clock), and the answers bear the number of
// their channel in bits 15:12: which frame an answer belongs to need not be known. An answer with a
// channel above 7, such as the ones of a line without a chip, is dropped.
// HALF: clocks of half a period of sck_o, 3 or more; the chip takes 16 MHz at most, and has HALF - 2 clocks
// from a falling edge to its bit at miso_i. A sample is at most 10 frames of 36 * HALF clocks old: 58 us at
// 25 MHz with HALF = 4.
`default_nettype none

module max11123 #(
    parameter integer HALF = 4
) (
    input  wire         clk_i,
    input  wire         rst_ni,
    // pins
    output wire         csn_o,
    output wire         sck_o,
    output wire         mosi_o,
    input  wire         miso_i,
    // to the program
    output wire [127:0] samples_o
);

  // Words to the chip: mode control, or a register's number in bits 15:11 and its contents
  localparam [15:0] RESET_ALL = 16'h0040;
  localparam [15:0] CONFIGURATION = 16'h8000;  // external reference, no averaging, no echo
  localparam [15:0] SINGLE_ENDED = 16'h8800;  // unipolar register: no pairs, against ground
  localparam [15:0] UNIPOLAR = 16'h9000;  // bipolar register: no channel
  localparam [15:0] SELECT = 16'h0806;  // manual mode, answers with channel; channel in bits 10:7

  // Halves of a frame: pause, csn falls, 16 times clock low and high, csn rises
  localparam [5:0] BEGIN = 6'd2;
  localparam [5:0] FIRST_LOW = 6'd3;
  localparam [5:0] LAST = 6'd35;
  localparam integer DIVIDER_BITS = $clog2(HALF);
  localparam [31:0] DIVIDER_TOP = HALF - 1;

  reg [DIVIDER_BITS-1:0] divider_q;
  reg [5:0] half_q;
  reg [3:0] frame_q;  // 0 to 3: settings; 8 + n: channel n
  reg answers_q;  // a channel was selected two frames ago: what comes is an answer
  reg [15:0] send_q;
  reg [15:0] received_q;
  reg csn_q;
  reg sck_q;
  reg miso_q;
  reg [127:0] samples_q;

  wire half_end = divider_q == DIVIDER_TOP[DIVIDER_BITS-1:0];
  wire low_half = half_q[0] && half_q >= FIRST_LOW && half_q != LAST;
  wire frame_end = half_end && half_q == LAST;

  reg [15:0] word;

  always @* begin
    case (frame_q)
      4'd0: word = RESET_ALL;
      4'd1: word = CONFIGURATION;
      4'd2: word = SINGLE_ENDED;
      4'd3: word = UNIPOLAR;
      default: word = SELECT | {5'd0, 1'b0, frame_q[2:0], 7'd0};
    endcase
  end

  integer n;

  always @(posedge clk_i) begin
    miso_q <= miso_i;

    if (!rst_ni) begin
      divider_q <= {DIVIDER_BITS{1'b0}};
      half_q <= 6'd0;
      frame_q <= 4'd0;
      answers_q <= 1'b0;
      csn_q <= 1'b1;
      sck_q <= 1'b1;
      samples_q <= 128'd0;
    end else begin
      divider_q <= half_end ? {DIVIDER_BITS{1'b0}} : divider_q + 1'b1;
      if (half_end) half_q <= half_q == LAST ? 6'd0 : half_q + 6'd1;

      // Pins follow the half by a clock.
      csn_q <= half_q < BEGIN;
      sck_q <= !low_half;
      if (frame_end) begin
        // 3 to 8: behind the settings come the channels
        frame_q <= frame_q == 4'd3 ? 4'd8 : frame_q == 4'd15 ? 4'd8 : frame_q + 4'd1;
        // The first two channel frames still answer to what was there before.
        if (frame_q == 4'd9) answers_q <= 1'b1;
        for (n = 0; n < 8; n = n + 1) begin
          if (answers_q && received_q[15:12] == n[3:0]) samples_q[16*n+:12] <= received_q[11:0];
        end
      end
    end

    if (half_end && half_q == BEGIN) send_q <= word;
    else if (half_end && half_q > FIRST_LOW && !half_q[0]) send_q <= {send_q[14:0], 1'b0};
    if (half_end && low_half) received_q <= {received_q[14:0], miso_q};
  end

  assign csn_o = csn_q;
  assign sck_o = sck_q;
  assign mosi_o = send_q[15];
  assign samples_o = samples_q;

endmodule

`default_nettype wire

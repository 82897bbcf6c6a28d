// SPDX-License-Identifier: Apache-2.0
// A program's time: ticks since the latch before, and clock relays, held at each latch. Time begins with the
// latch that first_i marks: that one is t = 0, and a latch CLOCKS_PER_MS * n clocks later is t = n ms. The prescalers are
// chained and never reset in between, so no tick is lost however long a program runs; relay p is
// floor(2t / p) mod 2. milliseconds_o is a clock of its own, which no program resets.
`default_nettype none

module time_base #(
    parameter integer CLOCKS_PER_MS = 25000  // 2 or more
) (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        latch_i,        // for one clock: a latch begins
    input  wire        first_i,        // with latch_i: time begins
    output wire [15:0] ticks_1_o,      // from the clock after latch_i on, each 32,767 at most
    output wire [15:0] ticks_10_o,
    output wire [15:0] ticks_100_o,
    output wire [ 5:0] relays_o,       // of 10, 100, 200, 1,000, 2,000, 60,000 ms
    output wire [15:0] milliseconds_o,
    output wire        millisecond_o   // for one clock each millisecond
);

  localparam integer BITS = $clog2(CLOCKS_PER_MS);
  localparam integer LAST = CLOCKS_PER_MS - 1;

  // ---- the program's milliseconds ----------------------------------------------------------------
  reg [BITS-1:0] clock_q;  // of the millisecond
  reg ms_q;  // a millisecond ends

  wire begins = latch_i && first_i;

  always @(posedge clk_i) begin
    if (begins) begin
      clock_q <= {{BITS - 1{1'b0}}, 1'b1};
      ms_q <= LAST == 0;
    end else begin
      clock_q <= clock_q == LAST[BITS-1:0] ? {BITS{1'b0}} : clock_q + 1'b1;
      ms_q <= clock_q == LAST[BITS-1:0];
    end
  end

  // ---- chained prescalers: what counts 5 ms counts to 10, 50, ... ----------------------------------
  reg [2:0] by5_q;  // to 5 ms
  reg by10_q;  // 5 to 10
  reg [3:0] by50_q;  // 5 to 50
  reg by100_q;  // 50 to 100
  reg [2:0] by500_q;  // 100 to 500
  reg by1000_q;  // 500 to 1,000
  reg [4:0] by30000_q;  // 1,000 to 30,000
  reg [5:0] relays_q;

  wire at5 = ms_q && by5_q == 3'd4;
  wire at10 = at5 && by10_q;
  wire at50 = at5 && by50_q == 4'd9;
  wire at100 = at50 && by100_q;
  wire at500 = at100 && by500_q == 3'd4;
  wire at1000 = at500 && by1000_q;
  wire at30000 = at1000 && by30000_q == 5'd29;
  wire [5:0] relays = relays_q ^ {at30000, at1000, at500, at100, at50, at5};

  always @(posedge clk_i) begin
    if (begins) begin
      by5_q <= 3'd0;
      by10_q <= 1'b0;
      by50_q <= 4'd0;
      by100_q <= 1'b0;
      by500_q <= 3'd0;
      by1000_q <= 1'b0;
      by30000_q <= 5'd0;
      relays_q <= 6'd0;
    end else begin
      if (ms_q) by5_q <= at5 ? 3'd0 : by5_q + 3'd1;
      if (at5) by10_q <= !by10_q;
      if (at5) by50_q <= at50 ? 4'd0 : by50_q + 4'd1;
      if (at50) by100_q <= !by100_q;
      if (at100) by500_q <= at500 ? 3'd0 : by500_q + 3'd1;
      if (at500) by1000_q <= !by1000_q;
      if (at1000) by30000_q <= at30000 ? 5'd0 : by30000_q + 5'd1;
      relays_q <= relays;
    end
  end

  // ---- what the program sees -----------------------------------------------------------------------
  tick_count ticks_1 (
      .clk_i  (clk_i),
      .latch_i(latch_i),
      .first_i(first_i),
      .tick_i (ms_q),
      .ticks_o(ticks_1_o)
  );
  tick_count ticks_10 (
      .clk_i  (clk_i),
      .latch_i(latch_i),
      .first_i(first_i),
      .tick_i (at10),
      .ticks_o(ticks_10_o)
  );
  tick_count ticks_100 (
      .clk_i  (clk_i),
      .latch_i(latch_i),
      .first_i(first_i),
      .tick_i (at100),
      .ticks_o(ticks_100_o)
  );

  reg [5:0] held_q;
  always @(posedge clk_i) if (latch_i) held_q <= first_i ? 6'd0 : relays;
  assign relays_o = held_q;

  // ---- the firmware's milliseconds -----------------------------------------------------------------
  reg [BITS-1:0] free_clock_q;
  reg free_ms_q;
  reg [15:0] milliseconds_q;
  always @(posedge clk_i) begin
    if (!rst_ni) begin
      free_clock_q <= {BITS{1'b0}};
      free_ms_q <= 1'b0;
      milliseconds_q <= 16'd0;
    end else begin
      free_clock_q <= free_clock_q == LAST[BITS-1:0] ? {BITS{1'b0}} : free_clock_q + 1'b1;
      free_ms_q <= free_clock_q == LAST[BITS-1:0];
      if (free_ms_q) milliseconds_q <= milliseconds_q + 16'd1;
    end
  end
  assign milliseconds_o = milliseconds_q;
  assign millisecond_o  = free_ms_q;

endmodule

`default_nettype wire

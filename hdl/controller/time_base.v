// SPDX-License-Identifier: Apache-2.0
// Time of a program, as INTERFACES.md has it, and the firmware's milliseconds. capture_i is 1 in the clock
// of a latch; what the latch shows is in the outputs from the next clock until the next capture_i:
//   ticks_o   ticks of 1, 10 and 100 ms (lowest first) since the capture before, at most 32,767 each
//   relays_o  clock relays of 10, 100, 200, 1,000, 2,000 and 60,000 ms (lowest first)
// With first_i the capture is t = 0: all of them are 0. A capture n clocks later is at t = n / CLOCKS_PER_MS
// ms, to the clock, in no matter how many years: each prescaler counts what the one before it has counted.
// millisecond_o is 1 for a clock each millisecond, and milliseconds_o counts them, whatever programs do.
`default_nettype none

module time_base #(
    parameter integer CLOCKS_PER_MS = 12000  // 2 to 2^20
) (
    input  wire        clk_i,
    input  wire        rst_ni,
    input  wire        capture_i,
    input  wire        first_i,
    output wire [47:0] ticks_o,
    output wire [ 5:0] relays_o,
    output wire        millisecond_o,
    output wire [15:0] milliseconds_o
);

  localparam integer BITS = $clog2(CLOCKS_PER_MS);
  localparam integer LAST = CLOCKS_PER_MS - 1;
  localparam [BITS-1:0] LAST_CLOCK = LAST[BITS-1:0];
  localparam [2:0] LAST_OF_5 = 3'd4;
  localparam [4:0] LAST_OF_30 = 5'd29;
  localparam [14:0] MOST_TICKS = 15'h7fff;

  wire restart = capture_i && first_i;

  // ---- prescalers: each register changes in the clock in which its time is reached --------------
  reg [BITS-1:0] clock_q;
  reg [2:0] of_5_q;  // milliseconds of 5
  reg [2:0] of_50_q;  // tens of milliseconds of 50
  reg [2:0] of_500_q;  // hundreds of milliseconds of 500
  reg [4:0] of_30_s_q;  // seconds of 30
  reg [5:0] relays_q;
  // The ends of 1, 5, 10, 50, 100, 500, 1,000 and 30,000 ms. A relay that has just gone off ends a period.
  wire end_1 = clock_q == LAST_CLOCK;
  wire end_5 = end_1 && of_5_q == LAST_OF_5;
  wire end_10 = end_5 && relays_q[0];
  wire end_50 = end_10 && of_50_q == LAST_OF_5;
  wire end_100 = end_50 && relays_q[1];
  wire end_500 = end_100 && of_500_q == LAST_OF_5;
  wire end_1000 = end_500 && relays_q[3];
  wire end_30000 = end_1000 && of_30_s_q == LAST_OF_30;

  always @(posedge clk_i) begin
    if (!rst_ni || restart) begin
      // The clock of the capture is the first of the first millisecond.
      clock_q <= {{BITS - 1{1'b0}}, 1'b1};
      of_5_q <= 3'd0;
      of_50_q <= 3'd0;
      of_500_q <= 3'd0;
      of_30_s_q <= 5'd0;
      relays_q <= 6'd0;
    end else begin
      clock_q <= end_1 ? {BITS{1'b0}} : clock_q + 1'b1;
      if (end_1) of_5_q <= end_5 ? 3'd0 : of_5_q + 3'd1;
      if (end_10) of_50_q <= end_50 ? 3'd0 : of_50_q + 3'd1;
      if (end_100) of_500_q <= end_500 ? 3'd0 : of_500_q + 3'd1;
      if (end_1000) of_30_s_q <= end_30000 ? 5'd0 : of_30_s_q + 5'd1;
      relays_q <= relays_q ^ {end_30000, end_1000, end_500, end_100, end_50, end_5};
    end
  end

  reg [5:0] relays_held_q;

  always @(posedge clk_i) if (capture_i) relays_held_q <= first_i ? 6'd0 : relays_q;

  assign relays_o = relays_held_q;

  // ---- ticks since the last capture -------------------------------------------------------------
  wire [2:0] tick = {end_100, end_10, end_1};

  genvar i;
  generate
    for (i = 0; i < 3; i = i + 1) begin : g_ticks
      reg [14:0] count_q;
      reg [14:0] held_q;
      always @(posedge clk_i) begin
        if (capture_i) held_q <= first_i ? 15'd0 : count_q;
        if (!rst_ni || restart) count_q <= 15'd0;
        else if (capture_i) count_q <= {14'd0, tick[i]};
        else if (tick[i] && count_q != MOST_TICKS) count_q <= count_q + 15'd1;
      end
      assign ticks_o[16*i+:16] = {1'b0, held_q};
    end
  endgenerate

  // ---- the firmware's clock ---------------------------------------------------------------------
  reg [BITS-1:0] own_clock_q;
  reg millisecond_q;
  reg [15:0] milliseconds_q;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      own_clock_q <= {BITS{1'b0}};
      millisecond_q <= 1'b0;
      milliseconds_q <= 16'd0;
    end else begin
      own_clock_q   <= own_clock_q == LAST_CLOCK ? {BITS{1'b0}} : own_clock_q + 1'b1;
      millisecond_q <= own_clock_q == LAST_CLOCK;
      if (millisecond_q) milliseconds_q <= milliseconds_q + 16'd1;
    end
  end

  assign millisecond_o  = millisecond_q;
  assign milliseconds_o = milliseconds_q;

endmodule

`default_nettype wire

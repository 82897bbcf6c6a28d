// SPDX-License-Identifier: Apache-2.0
// Time of a program (hdl/controller/time_base.v): ticks and clock relays are those of a wall clock that was set to 0 by
// the last first capture: a relay of period p is floor(2t/p) mod 2, ticks are the milliseconds, tens and hundreds of
// them that the clock has passed since the capture before, at most 32,767. The firmware's milliseconds come
// every CLOCKS_PER_MS clocks, whatever is captured. Captures are free in every clock.
`default_nettype none

module time_base_proof #(
    parameter integer CLOCKS_PER_MS = 3
) (
    input wire clk_i,
    input wire rst_ni,
    input wire capture_i,
    input wire first_i
);

  wire [47:0] ticks;
  wire [5:0] relays;
  wire millisecond;
  wire [15:0] milliseconds;
  time_base #(
      .CLOCKS_PER_MS(CLOCKS_PER_MS)
  ) base (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .capture_i     (capture_i),
      .first_i       (first_i),
      .ticks_o       (ticks),
      .relays_o      (relays),
      .millisecond_o (millisecond),
      .milliseconds_o(milliseconds)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  // ---- a wall clock: as it is in this clock --------------------------------------------------------
  localparam integer LAST = CLOCKS_PER_MS - 1;
  wire set = !rst_ni || (capture_i && first_i);
  reg [7:0] clock_q;
  reg [3:0] ms_q;  // digits: milliseconds, tens, hundreds
  reg [3:0] ten_q;
  reg [3:0] hundred_q;
  reg [5:0] second_q;
  wire ends_ms = clock_q == LAST[7:0];
  wire ends_ten = ends_ms && ms_q == 4'd9;
  wire ends_hundred = ends_ten && ten_q == 4'd9;
  wire ends_second = ends_hundred && hundred_q == 4'd9;

  always @(posedge clk_i) begin
    if (set) begin
      clock_q <= 8'd1;  // the clock of the capture itself was the first of the first millisecond
      {ms_q, ten_q, hundred_q, second_q} <= 18'd0;
    end else begin
      clock_q <= ends_ms ? 8'd0 : clock_q + 8'd1;
      if (ends_ms) ms_q <= ends_ten ? 4'd0 : ms_q + 4'd1;
      if (ends_ten) ten_q <= ends_hundred ? 4'd0 : ten_q + 4'd1;
      if (ends_hundred) hundred_q <= ends_second ? 4'd0 : hundred_q + 4'd1;
      if (ends_second) second_q <= second_q == 6'd59 ? 6'd0 : second_q + 6'd1;
    end
  end

  wire [5:0] now = {
    second_q >= 6'd30, second_q[0], hundred_q >= 4'd5, hundred_q[0], ten_q >= 4'd5, ms_q >= 4'd5
  };

  // ---- ticks since the capture before, without an end -------------------------------------------------
  wire [2:0] tick = {ends_hundred, ends_ten, ends_ms};
  reg known_q;  // there was a capture
  reg [5:0] relays_q;
  always @(posedge clk_i) begin
    known_q <= begun_q && (capture_i || known_q);
    if (capture_i) relays_q <= first_i ? 6'd0 : now;
  end
  always @* if (begun_q && known_q) assert (relays == relays_q);

  (* hierconn *) wire [14:0] \base.g_ticks[0].count_q ;
  (* hierconn *) wire [14:0] \base.g_ticks[1].count_q ;
  (* hierconn *) wire [14:0] \base.g_ticks[2].count_q ;
  wire [44:0] counts = {
    \base.g_ticks[2].count_q , \base.g_ticks[1].count_q , \base.g_ticks[0].count_q
  };
  genvar i;
  generate
    for (i = 0; i < 3; i = i + 1) begin : g_ticks
      reg  [39:0] since_q;  // a capture comes in 13 hours at 12 MHz
      reg  [15:0] held_q;
      wire [15:0] most = since_q > 40'd32767 ? 16'd32767 : since_q[15:0];
      always @(posedge clk_i) begin
        if (set) since_q <= 40'd0;
        else if (capture_i) since_q <= {39'd0, tick[i]};
        else since_q <= since_q + {39'd0, tick[i]};
        if (capture_i) held_q <= first_i ? 16'd0 : most;
      end
      always @* begin
        assume (since_q != 40'hffffffffff);
        if (begun_q && known_q) assert (ticks[16*i+:16] == held_q);
        if (begun_q) assert ({1'b0, counts[15*i+:15]} == most);
      end
    end
  endgenerate

  // ---- the firmware's clock ------------------------------------------------------------------------
  reg [ 7:0] own_q;
  reg [15:0] milliseconds_q;
  always @(posedge clk_i) begin
    own_q <= !rst_ni || own_q == LAST[7:0] ? 8'd0 : own_q + 8'd1;
    if (!rst_ni) milliseconds_q <= 16'd0;
    else if (millisecond) milliseconds_q <= milliseconds_q + 16'd1;
  end
  reg ready_q;  // own_q was not reset in the clock before
  always @(posedge clk_i) ready_q <= begun_q && rst_ni;
  always @* begin
    if (begun_q) assert (milliseconds == milliseconds_q);
    if (begun_q) assert (millisecond == (ready_q && own_q == 8'd0));
  end

  // ---- for the induction: prescalers against the wall clock's digits ----------------------------------
  (* hierconn *) wire [$clog2(CLOCKS_PER_MS)-1:0] \base.clock_q ;
  (* hierconn *) wire [$clog2(CLOCKS_PER_MS)-1:0] \base.own_clock_q ;
  (* hierconn *) wire [2:0] \base.of_5_q ;
  (* hierconn *) wire [2:0] \base.of_50_q ;
  (* hierconn *) wire [2:0] \base.of_500_q ;
  (* hierconn *) wire [4:0] \base.of_30_s_q ;
  (* hierconn *) wire [5:0] \base.relays_q ;
  always @* begin
    if (begun_q) begin
      assert (clock_q < CLOCKS_PER_MS && clock_q == \base.clock_q );
      assert (own_q < CLOCKS_PER_MS && own_q == \base.own_clock_q );
      assert (ms_q <= 4'd9 && ten_q <= 4'd9 && hundred_q <= 4'd9 && second_q <= 6'd59);
      assert (\base.relays_q == now);
      assert (\base.of_5_q == ms_q % 4'd5 && \base.of_50_q == ten_q % 4'd5);
      assert (\base.of_500_q == hundred_q % 4'd5 && \base.of_30_s_q == second_q % 6'd30);
    end
  end

  always @* begin
    cover (known_q && relays[0] && ticks[15:0] == 16'd2);
    cover (known_q && ticks[31:16] == 16'd1);
  end

endmodule

`default_nettype wire

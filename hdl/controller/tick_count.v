// SPDX-License-Identifier: Apache-2.0
// Ticks of one base since the latch before, held at each latch: part of time_base.v. A tick in the clock of
// a latch counts for that latch.
`default_nettype none

module tick_count (
    input  wire        clk_i,
    input  wire        latch_i,
    input  wire        first_i,  // with latch_i: none
    input  wire        tick_i,
    output wire [15:0] ticks_o
);

  localparam [14:0] MOST = 15'h7fff;

  reg [14:0] count_q;
  reg [14:0] held_q;
  wire [14:0] count = tick_i && count_q != MOST ? count_q + 15'd1 : count_q;

  always @(posedge clk_i) begin
    count_q <= latch_i ? 15'd0 : count;
    if (latch_i) held_q <= first_i ? 15'd0 : count;
  end

  assign ticks_o = {1'b0, held_q};

endmodule

`default_nettype wire

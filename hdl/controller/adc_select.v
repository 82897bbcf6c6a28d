// SPDX-License-Identifier: Apache-2.0
// Which analogue sample is needed: one selector for the latch list, which names a channel, and for the
// device ports, to which it shows, behind scan_i, the channels that route_i names. port_exchange.v takes the
// sample of port n at edge 5 + n, counted from the one that samples scan_i.
`default_nettype none

module adc_select (
    input  wire         clk_i,
    input  wire [127:0] adc_i,            // 8 samples of 16 bits, channel 0 lowest
    input  wire [ 23:0] route_i,          // channel of port n in bits 3n + 2 to 3n
    // latch: the sample in the same clock
    input  wire [  2:0] latch_channel_i,
    output wire [ 15:0] latch_sample_o,
    // device ports
    input  wire         scan_i,
    input  wire         scanning_i,
    output wire [ 15:0] port_sample_o
);

  // In clock 4 + n, clock 0 being that of scan_i, port n is looked up, and its sample shown in the next one.
  localparam [2:0] CLOCK_1 = 3'd5;

  reg [2:0] port_q;
  reg [15:0] sample_q;
  wire [2:0] channel = scanning_i ? route_i[{2'd0, port_q}*3+:3] : latch_channel_i;
  wire [15:0] sample = adc_i[{channel, 4'd0}+:16];

  always @(posedge clk_i) begin
    port_q   <= scan_i ? CLOCK_1 : port_q + 3'd1;
    sample_q <= sample;
  end

  assign latch_sample_o = sample;
  assign port_sample_o  = sample_q;

endmodule

`default_nettype wire

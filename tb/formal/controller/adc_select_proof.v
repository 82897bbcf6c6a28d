// SPDX-License-Identifier: Apache-2.0
// Which analogue sample is needed (hdl/controller/adc_select.v): the latch list gets the channel that it names, in the same
// clock. A scan's port n gets the channel that its route names, at edge 5 + n after the one that samples scan_i, which is when
// port_exchange.v takes it; whatever was selected before, and whenever the scan began.
`default_nettype none

module adc_select_proof (
    input wire         clk_i,
    input wire [127:0] adc_i,
    input wire [ 23:0] route_i,
    input wire [  2:0] latch_channel_i,
    input wire         scan_i,
    input wire         scanning_i
);

  wire [15:0] latch_sample, port_sample;
  adc_select select (
      .clk_i          (clk_i),
      .adc_i          (adc_i),
      .route_i        (route_i),
      .latch_channel_i(latch_channel_i),
      .latch_sample_o (latch_sample),
      .scan_i         (scan_i),
      .scanning_i     (scanning_i),
      .port_sample_o  (port_sample)
  );

  // Any channel, and any port that its route names.
  (* anyconst *) wire [2:0] channel;
  (* anyconst *) wire [2:0] port;
  wire [15:0] sample = adc_i[16*channel+:16];
  wire routed = route_i[3*port+:3] == channel;
  reg [15:0] sample_q;
  reg routed_q;

  reg scans_q;
  initial scans_q = 1'b0;
  reg [3:0] edge_q;  // the next edge's number, the last scan_i's own being 0
  always @(posedge clk_i) begin
    scans_q <= scan_i || (scans_q && edge_q != 4'd12);
    edge_q <= scan_i ? 4'd1 : edge_q + 4'd1;
    sample_q <= sample;
    routed_q <= routed;
  end
  // A scan is under way in the clock of scan_i and those behind it.
  always @* if (scans_q) assume (scanning_i);

  wire taken = scans_q && edge_q == {1'b0, port} + 4'd5;
  always @* begin
    if (!scanning_i && latch_channel_i == channel) assert (latch_sample == sample);
    if (taken && routed_q) assert (port_sample == sample_q);
  end

  // For the induction.
  (* hierconn *) wire [2:0] \select.port_q ;
  (* hierconn *) wire [15:0] \select.sample_q ;
  wire [3:0] ahead = edge_q + 4'd4;
  always @* begin
    if (scans_q) begin
      assert (edge_q >= 4'd1 && edge_q <= 4'd12);
      assert (\select.port_q == ahead[2:0]);
      if (taken && routed_q) assert (\select.sample_q == sample_q);
    end
  end

  always @* cover (taken && port == 3'd6 && routed_q && channel == 3'd2 && port_sample == 16'h0abc);

endmodule

`default_nettype wire

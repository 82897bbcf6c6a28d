// SPDX-License-Identifier: Apache-2.0
// Wishbone slave in front of one RAM port: the first word of an access after one wait clock, each
// further word of an incrementing burst of at most 8 words (CTI 010, aligned lines) in the next clock.
`default_nettype none

module yard_wishbone (
    input  wire        clk_i,
    input  wire        rst_ni,
    // bus
    input  wire        cyc_i,
    input  wire        stb_i,
    input  wire        we_i,
    input  wire [29:0] adr_i,
    input  wire [ 3:0] sel_i,
    input  wire [ 2:0] cti_i,
    output wire        ack_o,
    // RAM port; address bit 29 is the marks' space
    output wire [13:0] ram_addr_o,
    output wire [ 3:0] ram_we_o,
    output wire        mark_we_o
);

  localparam [2:0] INCREMENTING = 3'b010;

  reg  ack_q;
  wire streaming = ack_q && cti_i == INCREMENTING;
  wire write = cyc_i && stb_i && we_i && !ack_q;

  always @(posedge clk_i) begin
    if (!rst_ni) ack_q <= 1'b0;
    else ack_q <= cyc_i && stb_i && (!ack_q || streaming);
  end

  assign ack_o      = ack_q;
  assign ram_addr_o = {adr_i[13:3], adr_i[2:0] + {2'b0, streaming}};
  assign ram_we_o   = {4{write && !adr_i[29]}} & sel_i;
  assign mark_we_o  = write && adr_i[29];

endmodule
`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// Serial link between four pins and a processor: SPI mode 0, frames of 64 bits, highest bit first.
// All ports of the processor pass through it, so nothing of the processor can be optimised away, and
// every path between the two is registered on both sides.
//
// Frame to the processor, carried out when csn rises after exactly 64 bits:
//   63 start a scan   62 load port access   61 write   58:56 space   51:32 address   31:16 data
// Frame from it, in the same 64 bits, as it was when csn fell:
//   63 done   62 busy   61 error   47:32 data of the last load port read   31:0 clocks of the last scan
// sck must be slower than a quarter of clk_i; csn stays high for at least four clocks between frames.
`default_nettype none

module serial_link (
    input  wire        clk_i,
    input  wire        rst_ni,
    // pins
    input  wire        sck_i,
    input  wire        csn_i,
    input  wire        sdi_i,
    output wire        sdo_o,
    // processor: control
    output wire        start_o,
    input  wire        done_i,
    input  wire        busy_i,
    input  wire        error_i,
    input  wire [31:0] clocks_i,
    // processor: load port
    output wire        load_valid_o,
    output wire        load_write_o,
    output wire [ 2:0] load_space_o,
    output wire [19:0] load_addr_o,
    output wire [15:0] load_data_o,
    input  wire        load_rvalid_i,
    input  wire [15:0] load_rdata_i
);

  localparam [6:0] FRAME_BITS = 7'd64;

  // Pins brought into the clock domain, one more stage to see edges.
  reg [2:0] sck_q;
  reg [2:0] csn_q;
  reg [1:0] sdi_q;
  reg sck_rise_q;
  reg csn_fall_q;
  reg csn_rise_q;
  reg sdi_bit_q;

  always @(posedge clk_i) begin
    sck_q      <= {sck_q[1:0], sck_i};
    csn_q      <= {csn_q[1:0], csn_i};
    sdi_q      <= {sdi_q[0], sdi_i};
    sck_rise_q <= !sck_q[2] && sck_q[1] && !csn_q[1];
    csn_fall_q <= csn_q[2] && !csn_q[1];
    csn_rise_q <= !csn_q[2] && csn_q[1];
    sdi_bit_q  <= sdi_q[1];
  end

  // What the processor says, registered before it enters a frame.
  reg done_q;
  reg busy_q;
  reg error_q;
  reg [31:0] clocks_q;
  reg [15:0] rdata_q;

  always @(posedge clk_i) begin
    done_q   <= done_i;
    busy_q   <= busy_i;
    error_q  <= error_i;
    clocks_q <= clocks_i;
    if (load_rvalid_i) rdata_q <= load_rdata_i;
  end

  // One register is both frames: it is filled when csn falls, and each bit that leaves makes room for
  // one that comes in.
  reg [63:0] frame_q;
  reg [ 6:0] count_q;
  reg        sdo_q;
  reg        whole_q;

  always @(posedge clk_i) begin
    if (csn_fall_q) begin
      frame_q <= {done_q, busy_q, error_q, 13'h0, rdata_q, clocks_q};
      count_q <= 7'd0;
    end else if (sck_rise_q) begin
      frame_q <= {frame_q[62:0], sdi_bit_q};
      // One bit too many counts as too many for good.
      if (!count_q[6] || count_q[5:0] == 6'd0) count_q <= count_q + 7'd1;
    end
    // The other side samples at the rising edge, so the bit may change only after the falling one.
    if (!sck_q[2]) sdo_q <= frame_q[63];
    whole_q <= count_q == FRAME_BITS;
  end

  // Access and start: one clock, and until the processor has taken it.
  reg access_q;
  reg start_q;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      access_q <= 1'b0;
      start_q  <= 1'b0;
    end else begin
      access_q <= csn_rise_q && whole_q && frame_q[62];
      if (csn_rise_q && whole_q && frame_q[63]) start_q <= 1'b1;
      else if (busy_q) start_q <= 1'b0;
    end
  end

  assign sdo_o        = sdo_q;
  assign start_o      = start_q;
  assign load_valid_o = access_q;
  assign load_write_o = frame_q[61];
  assign load_space_o = frame_q[58:56];
  assign load_addr_o  = frame_q[51:32];
  assign load_data_o  = frame_q[31:16];

endmodule
`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// Flash port (hdl/controller/flash_port.v): of a byte that is written, the flash, which looks at mosi at each rising edge of
// sck, sees exactly its eight bits, highest first; what it puts on miso is read as the byte's answer; it takes
// 16 * HALF_CLOCKS clocks, and what is written meanwhile changes nothing. The flash is selected and left only by the register;
// the clock rests at 0 between bytes. No byte is lost or doubled, in any number of them.
`default_nettype none
`include "rung_controller.vh"

module flash_port_proof #(
    parameter integer HALF_CLOCKS = 1
) (
    input wire        clk_i,
    input wire        rst_ni,
    input wire        miso_i,
    input wire        sel_register_i,
    input wire [ 7:0] addr_i,
    input wire        read_i,
    input wire        write_i,
    input wire [15:0] wdata_i
);

  wire csn;
  wire sck;
  wire mosi;
  wire [15:0] rdata;
  flash_port #(
      .HALF_CLOCKS(HALF_CLOCKS)
  ) port (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .csn_o         (csn),
      .sck_o         (sck),
      .mosi_o        (mosi),
      .miso_i        (miso_i),
      .sel_register_i(sel_register_i),
      .addr_i        (addr_i),
      .read_i        (read_i),
      .write_i       (write_i),
      .wdata_i       (wdata_i),
      .rdata_o       (rdata)
  );

  reg begun_q;
  initial begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  wire write = sel_register_i && write_i;
  localparam [5:0] CLOCKS = 16 * HALF_CLOCKS;

  // ---- the port as its page has it: clocks of the byte that are left -----------------------------------
  reg [5:0] left_q;
  reg [7:0] byte_q;
  reg csn_q;
  wire take = write && addr_i == `RUNG_REG_FLASH_DATA && left_q == 6'd0;
  always @(posedge clk_i) begin
    if (!rst_ni) left_q <= 6'd0;
    else if (take) left_q <= CLOCKS;
    else if (left_q != 6'd0) left_q <= left_q - 6'd1;
    if (rst_ni && take) byte_q <= wdata_i[7:0];
    if (!rst_ni) csn_q <= 1'b1;
    else if (write && addr_i == `RUNG_REG_FLASH_SELECT) csn_q <= !wdata_i[0];
  end
  wire [5:0] gone = CLOCKS - left_q;  // clocks of the byte behind us

  // ---- a flash: what it has seen of this byte, and what it has answered ---------------------------------
  reg sck_q;
  reg [7:0] seen_q;
  reg [3:0] rises_q;
  reg [7:0] said_q;
  reg answered_q;  // a byte has ended since the reset
  wire rises = sck && !sck_q;
  // In its clock sck falls, and miso is taken: it is high, and this half ends.
  wire falls = left_q != 6'd0 && gone % (2 * HALF_CLOCKS) == 2 * HALF_CLOCKS - 1;
  always @(posedge clk_i) begin
    sck_q <= sck;
    if (take) begin
      seen_q  <= 8'd0;
      rises_q <= 4'd0;
    end else if (rises) begin
      seen_q  <= {seen_q[6:0], mosi};
      rises_q <= rises_q + 4'd1;
    end
    if (rst_ni && falls) said_q <= {said_q[6:0], miso_i};
    if (!rst_ni) answered_q <= 1'b0;
    else if (left_q == 6'd1) answered_q <= 1'b1;
  end

  reg data_read_q;
  reg busy_read_q;
  reg was_busy_q;
  reg [7:0] before_q;
  always @(posedge clk_i) begin
    data_read_q <= begun_q && sel_register_i && read_i && addr_i == `RUNG_REG_FLASH_DATA &&
        left_q == 6'd0 && answered_q;
    busy_read_q <= begun_q && sel_register_i && read_i && addr_i == `RUNG_REG_FLASH_BUSY;
    was_busy_q <= left_q != 6'd0;
    before_q <= said_q;
  end

  reg was_reset_q;
  always @(posedge clk_i) was_reset_q <= !rst_ni;
  always @* begin
    if (begun_q) begin
      assert (csn == csn_q);
      assert (sck == (left_q != 6'd0 && gone % (2 * HALF_CLOCKS) >= HALF_CLOCKS));
      // The byte has ended: eight rising edges, and the flash has the byte.
      if (left_q == 6'd0 && was_busy_q && !was_reset_q) begin
        assert (rises_q == 4'd8);
        assert (seen_q == byte_q);
      end
      if (data_read_q) assert (rdata == {8'd0, before_q});
      if (busy_read_q) assert (rdata == {15'd0, was_busy_q});
    end
  end

  // ---- for the induction ---------------------------------------------------------------------------
  (* hierconn *) wire [7:0] \port.out_q ;
  (* hierconn *) wire [7:0] \port.in_q ;
  (* hierconn *) wire \port.busy_q ;
  (* hierconn *) wire \port.clock_q ;
  (* hierconn *) wire [2:0] \port.bit_q ;
  wire [3:0] bits = gone / (2 * HALF_CLOCKS);  // that are behind us
  always @* begin
    if (begun_q) begin
      assert (left_q <= CLOCKS);
      assert (\port.busy_q == (left_q != 6'd0));
      if (left_q != 6'd0) begin
        assert (\port.clock_q == gone % HALF_CLOCKS);
        assert (\port.bit_q == bits[2:0]);
        assert (\port.out_q == byte_q << bits);
        assert (rises_q == (gone == 6'd0 ? 4'd0 : (gone - 6'd1 + HALF_CLOCKS) / (2 * HALF_CLOCKS)));
        assert (seen_q == byte_q >> (4'd8 - rises_q));
      end
      if (answered_q)
        assert (\port.in_q == said_q);
        else if (left_q != 6'd0) assert ((\port.in_q ^ said_q) << (4'd8 - bits) == 8'd0);
    end
  end

  always @* begin
    cover (begun_q && data_read_q && rdata == 16'h005a && byte_q == 8'ha5);
  end

endmodule

`default_nettype wire

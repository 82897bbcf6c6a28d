// SPDX-License-Identifier: Apache-2.0
// The device that a Modbus point is: one look-up a clock. point_i counts the points of the bit areas or, with
// words_i, of the word areas (hdl/isa/modbus.toml); in the clock after read_i mapped_o says whether it is a
// device and device_o which. Written as spaces bit_map and word_map: bit 15 set: it is one.
// The last word device has no point: its number stands for none, so that an entry of 256 word devices is as
// wide as a block RAM of an iCE40 is.
`default_nettype none

module device_map #(
    parameter integer BIT_POINTS   = 1024,
    parameter integer WORD_POINTS  = 472,
    parameter integer BIT_DEVICES  = 1024,  // a power of two, to 2^15, as the next
    parameter integer WORD_DEVICES = 256
) (
    input  wire        clk_i,
    // look-up
    input  wire        read_i,
    input  wire        words_i,
    input  wire [15:0] point_i,
    output wire        mapped_o,
    output wire [14:0] device_o,
    // load
    input  wire        bit_write_i,
    input  wire        word_write_i,
    input  wire [15:0] write_addr_i,
    input  wire [15:0] write_data_i
);

  localparam integer BIT_POINT = $clog2(BIT_POINTS);
  localparam integer WORD_POINT = $clog2(WORD_POINTS);
  localparam integer BIT_ADDR = $clog2(BIT_DEVICES);
  localparam integer WORD_ADDR = $clog2(WORD_DEVICES);
  localparam [15:0] LAST_BIT_POINT = BIT_POINTS[15:0] - 16'd1;
  localparam [15:0] LAST_WORD_POINT = WORD_POINTS[15:0] - 16'd1;

  wire [ BIT_ADDR:0] bit_entry;
  wire [WORD_ADDR-1:0] word_entry;
  localparam [WORD_ADDR-1:0] NONE = {WORD_ADDR{1'b1}};

  bank_ram #(
      .WIDTH(BIT_ADDR + 1),
      .DEPTH(BIT_POINTS),
      .ADDR_BITS(BIT_POINT),
      .CLEARED(0)
  ) bit_map (
      .clk_i       (clk_i),
      .read_i      (read_i),
      .read_addr_i (point_i[BIT_POINT-1:0]),
      .read_data_o (bit_entry),
      .write_i     (bit_write_i && write_addr_i <= LAST_BIT_POINT),
      .write_addr_i(write_addr_i[BIT_POINT-1:0]),
      .write_data_i({write_data_i[15], write_data_i[BIT_ADDR-1:0]})
  );

  bank_ram #(
      .WIDTH(WORD_ADDR),
      .DEPTH(WORD_POINTS),
      .ADDR_BITS(WORD_POINT),
      .CLEARED(0)
  ) word_map (
      .clk_i       (clk_i),
      .read_i      (read_i),
      .read_addr_i (point_i[WORD_POINT-1:0]),
      .read_data_o (word_entry),
      .write_i     (word_write_i && write_addr_i <= LAST_WORD_POINT),
      .write_addr_i(write_addr_i[WORD_POINT-1:0]),
      .write_data_i(write_data_i[15] ? write_data_i[WORD_ADDR-1:0] : NONE)
  );

  reg words_q;
  reg exists_q;

  always @(posedge clk_i) begin
    words_q  <= words_i;
    exists_q <= point_i <= (words_i ? LAST_WORD_POINT : LAST_BIT_POINT);
  end

  wire [14:0] bit_device = {{15 - BIT_ADDR{1'b0}}, bit_entry[BIT_ADDR-1:0]};
  wire [14:0] word_device = {{15 - WORD_ADDR{1'b0}}, word_entry};

  assign mapped_o = exists_q && (words_q ? word_entry != NONE : bit_entry[BIT_ADDR]);
  assign device_o = words_q ? word_device : bit_device;

  // verilator lint_off UNUSEDSIGNAL
  wire unused = &{1'b0, write_data_i[14:0]};
  // verilator lint_on UNUSEDSIGNAL

endmodule

`default_nettype wire

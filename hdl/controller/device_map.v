// SPDX-License-Identifier: Apache-2.0
// Which device a Modbus point is: one table for bit points, one for word points, written by the firmware while no
// exchange waits, a word every three clocks at most. The answer to point_i comes in the next clock.
// Whether a word point is a device stands in the bit points' table, so that both are as wide as block RAMs are on
// iCE40 (1,024 words of 4 bits, 512 of 8): a write there keeps the other table's bits.
`default_nettype none

module device_map #(
    parameter integer BIT_POINTS = 1024,
    parameter integer WORD_POINTS = 512,
    parameter integer BIT_ADDR = 10,  // bits of a bit device's number
    parameter integer WORD_ADDR = 8
) (
    input  wire        clk_i,
    input  wire        bit_write_i,
    input  wire        word_write_i,
    input  wire [13:0] write_point_i,
    input  wire [15:0] write_data_i,   // bit 15: the point is a device
    input  wire [13:0] point_i,
    input  wire        word_i,
    output wire        exists_o,
    output wire [15:0] address_o
);

  localparam integer BIT_POINT = $clog2(BIT_POINTS);
  localparam integer WORD_POINT = $clog2(WORD_POINTS);

  localparam integer POINT = BIT_POINT > WORD_POINT ? BIT_POINT : WORD_POINT;
  localparam integer WORD_EXISTS = BIT_ADDR + 1;

  (* no_rw_check *) reg [WORD_EXISTS:0] bit_ram[0:(1<<POINT)-1];
  (* no_rw_check *) reg [WORD_ADDR-1:0] word_ram[0:WORD_POINTS-1];
  reg [WORD_EXISTS:0] bit_q;
  reg [WORD_ADDR-1:0] word_data_q;
  reg word_q;
  reg bit_write_q, word_write_q;
  reg [POINT-1:0] write_point_q;
  reg [BIT_ADDR:0] write_data_q;
  wire write = bit_write_i || word_write_i;

  always @(posedge clk_i) begin
    bit_write_q   <= bit_write_i;
    word_write_q  <= word_write_i;
    write_point_q <= write_point_i[POINT-1:0];
    write_data_q  <= {write_data_i[15], write_data_i[BIT_ADDR-1:0]};
    if (bit_write_q || word_write_q) begin
      bit_ram[write_point_q] <= bit_write_q ? {bit_q[WORD_EXISTS], write_data_q} :
          {write_data_q[BIT_ADDR], bit_q[BIT_ADDR:0]};
    end
    bit_q <= bit_ram[write ? write_point_i[POINT-1:0] : point_i[POINT-1:0]];
  end
  always @(posedge clk_i) begin
    if (word_write_i) word_ram[write_point_i[WORD_POINT-1:0]] <= write_data_i[WORD_ADDR-1:0];
    word_data_q <= word_ram[point_i[WORD_POINT-1:0]];
    word_q <= word_i;
  end

  assign exists_o = bit_q[word_q ? WORD_EXISTS : BIT_ADDR];
  assign address_o = word_q ? {{16 - WORD_ADDR{1'b0}}, word_data_q} :
      {{16 - BIT_ADDR{1'b0}}, bit_q[BIT_ADDR-1:0]};
  wire unused = &{1'b0, write_point_i, point_i, write_data_i};

endmodule

`default_nettype wire

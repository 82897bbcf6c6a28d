// SPDX-License-Identifier: Apache-2.0
// Which device a Modbus point is: one table for bit points, one for word points, written by the firmware. The
// answer to point_i comes in the next clock.
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

  reg [BIT_ADDR:0] bit_ram[0:BIT_POINTS-1];
  reg [WORD_ADDR:0] word_ram[0:WORD_POINTS-1];
  reg [BIT_ADDR:0] bit_q;
  reg [WORD_ADDR:0] word_data_q;
  reg word_q;

  always @(posedge clk_i) begin
    if (bit_write_i) begin
      bit_ram[write_point_i[BIT_POINT-1:0]] <= {write_data_i[15], write_data_i[BIT_ADDR-1:0]};
    end
    bit_q <= bit_ram[point_i[BIT_POINT-1:0]];
  end
  always @(posedge clk_i) begin
    if (word_write_i) begin
      word_ram[write_point_i[WORD_POINT-1:0]] <= {write_data_i[15], write_data_i[WORD_ADDR-1:0]};
    end
    word_data_q <= word_ram[point_i[WORD_POINT-1:0]];
    word_q <= word_i;
  end

  assign exists_o = word_q ? word_data_q[WORD_ADDR] : bit_q[BIT_ADDR];
  assign address_o = word_q ? {{16 - WORD_ADDR{1'b0}}, word_data_q[WORD_ADDR-1:0]} :
      {{16 - BIT_ADDR{1'b0}}, bit_q[BIT_ADDR-1:0]};
  wire unused = &{1'b0, write_point_i, point_i, write_data_i};

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// CRC-16 as Modbus has it, a bit a clock: start_i begins a new one, byte_i adds data_i, in the same clock also as the
// first byte of a new one. busy_o is 1 for the eight clocks behind byte_i, in which there must be no other. Over a
// frame with its CRC, low byte first, it comes to 0.
`default_nettype none

module link_crc (
    input  wire        clk_i,
    input  wire        start_i,
    input  wire        byte_i,
    input  wire [ 7:0] data_i,
    output wire        busy_o,
    output wire [15:0] crc_o
);

  localparam [15:0] POLYNOMIAL = 16'ha001;

  reg [15:0] crc_q;
  reg [ 7:0] left_q;  // a 1 for each bit of the byte still to come
  wire [15:0] base = start_i ? 16'hffff : crc_q;

  always @(posedge clk_i) begin
    if (byte_i) begin
      crc_q  <= base ^ {8'd0, data_i};
      left_q <= 8'hff;
    end else if (start_i) begin
      crc_q  <= 16'hffff;
      left_q <= 8'h00;
    end else if (left_q[0]) begin
      crc_q  <= {1'b0, crc_q[15:1]} ^ (crc_q[0] ? POLYNOMIAL : 16'd0);
      left_q <= {1'b0, left_q[7:1]};
    end
  end

  assign busy_o = left_q[0];
  assign crc_o  = crc_q;

endmodule

`default_nettype wire

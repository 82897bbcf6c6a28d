// SPDX-License-Identifier: Apache-2.0
// 64 KB of block RAM for a soft core used as a yardstick: one read port for instructions, one port for
// data with byte enables. Both take one clock. In simulation +ram=FILE fills it (hexadecimal words).
`default_nettype none

module yard_ram (
    input  wire        clk_i,
    // instructions: word address
    input  wire [13:0] i_addr_i,
    output reg  [31:0] i_rdata_o,
    // data: word address, write enable of each byte
    input  wire [13:0] d_addr_i,
    input  wire [ 3:0] d_we_i,
    input  wire [31:0] d_wdata_i,
    output reg  [31:0] d_rdata_o
);

  reg [31:0] memory[0:16383];

`ifdef YARD_SIMULATION
  reg [2047:0] file;
  initial if ($value$plusargs("ram=%s", file)) $readmemh(file, memory);
`endif

  always @(posedge clk_i) i_rdata_o <= memory[i_addr_i];

  always @(posedge clk_i) begin
    if (d_we_i[0]) memory[d_addr_i][7:0] <= d_wdata_i[7:0];
    if (d_we_i[1]) memory[d_addr_i][15:8] <= d_wdata_i[15:8];
    if (d_we_i[2]) memory[d_addr_i][23:16] <= d_wdata_i[23:16];
    if (d_we_i[3]) memory[d_addr_i][31:24] <= d_wdata_i[31:24];
    d_rdata_o <= memory[d_addr_i];
  end

endmodule
`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// One block RAM (or a few side by side): one write port, one read port with registered data.
// Reading the word that is being written gives an undefined value; nobody may use it. The
// simulation gives the complement of the old word, so that a test fails if somebody does.
`default_nettype none

module bank_ram #(
    parameter WIDTH = 16,  // bits of a word
    parameter DEPTH = 256,  // words
    parameter ADDR_BITS = 8,  // bits of an address
    parameter CLEARED = 1  // 1: all words are 0 when the FPGA has been configured
) (
    input  wire                 clk_i,
    // read: data_o belongs to the address of the last clock in which read_i was 1
    input  wire                 read_i,
    input  wire [ADDR_BITS-1:0] read_addr_i,
    output wire [    WIDTH-1:0] read_data_o,
    // write
    input  wire                 write_i,
    input  wire [ADDR_BITS-1:0] write_addr_i,
    input  wire [    WIDTH-1:0] write_data_i
);

  (* no_rw_check, ram_style = "block" *) reg [WIDTH-1:0] words[0:DEPTH-1];
  reg [WIDTH-1:0] read_data_q;

  // The copies of a bank have to start alike; the bitstream sees to it. The instruction memory goes
  // without: Yosys takes minutes over its many words.
  generate
    if (CLEARED != 0) begin : g_cleared
      integer i;
      initial for (i = 0; i < DEPTH; i = i + 1) words[i] = {WIDTH{1'b0}};
    end
  endgenerate

  always @(posedge clk_i) begin
    if (write_i) words[write_addr_i] <= write_data_i;
`ifdef RUNG_RETIRE
    if (read_i) begin
      read_data_q <= words[read_addr_i] ^ {WIDTH{write_i && write_addr_i == read_addr_i}};
    end
`else
    if (read_i) read_data_q <= words[read_addr_i];
`endif
  end

  assign read_data_o = read_data_q;

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// Stands in for hdl/core/bank_ram.v: a block RAM of which one word is kept, any one; what is read from the others is
// anything. So what is shown of that word is shown of each, in a memory of any size, and an induction can name it:
// `watched` and `word_q`. A read of it in the clock of its write gives the complement of the old word, as there.
`default_nettype none

module bank_ram #(
    parameter WIDTH = 16,
    parameter DEPTH = 256,
    parameter ADDR_BITS = 8,
    parameter CLEARED = 1
) (
    input  wire                 clk_i,
    input  wire                 read_i,
    input  wire [ADDR_BITS-1:0] read_addr_i,
    output wire [    WIDTH-1:0] read_data_o,
    input  wire                 write_i,
    input  wire [ADDR_BITS-1:0] write_addr_i,
    input  wire [    WIDTH-1:0] write_data_i
);

  (* anyconst *) wire [ADDR_BITS-1:0] watched;
  (* anyseq *) wire [WIDTH-1:0] other;
  reg [WIDTH-1:0] word_q;
  reg [WIDTH-1:0] read_data_q;
  wire write = write_i && write_addr_i == watched;

  generate
    if (CLEARED != 0) begin : g_cleared
      initial word_q = {WIDTH{1'b0}};
    end
  endgenerate

  always @(posedge clk_i) begin
    if (write) word_q <= write_data_i;
    if (read_i) read_data_q <= read_addr_i == watched ? word_q ^ {WIDTH{write}} : other;
  end

  assign read_data_o = read_data_q;

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// Indexed access of one slot: the register ix, which IX sets at the end of its EX, and what it
// replaces in ID1: a source (rs, and operand a of MPU2 and MPU3) or the destination (rd, operand c;
// MPU1's only bit operand too, even if it is read). It is replaced before the memories and before the
// compares of forwarding, so that they see an indexed access like any other. The opcode is decoded
// in IF3, since the addresses have no time for it.
`default_nettype none
`include "rung_isa.vh"

module index_unit #(
    parameter IX_BITS = 10  // bits of the longest device number
) (
    input  wire                     clk_i,
    // IF3: opcode that ID1 has next, unless it holds
    input  wire [`RUNG_OP_BITS-1:0] f3_op_i,
    input  wire                     d1_hold_i,
    // ID1
    output wire                     d1_source_o,
    output wire                     d1_dest_o,
    output wire [      IX_BITS-1:0] d1_ix_o,
    // ID1: opcode as issued; EX: its sum
    input  wire [`RUNG_OP_BITS-1:0] d1_op_i,
    input  wire [      IX_BITS-1:0] x_sum_i
);

  reg d1_source_q;
  reg d1_dest_q;
  reg d2_ix_we_q;
  reg d3_ix_we_q;
  reg x_ix_we_q;
  reg [IX_BITS-1:0] ix_q;
  always @(posedge clk_i) begin
    if (!d1_hold_i) begin
      d1_source_q <= f3_op_i == `RUNG_OP_MVX || f3_op_i == `RUNG_OP_MVBX;
      d1_dest_q <= f3_op_i == `RUNG_OP_STX || f3_op_i == `RUNG_OP_LDX ||
          f3_op_i == `RUNG_OP_SETX || f3_op_i == `RUNG_OP_RSTX;
    end
    d2_ix_we_q <= d1_op_i == `RUNG_OP_IX;
    d3_ix_we_q <= d2_ix_we_q;
    x_ix_we_q  <= d3_ix_we_q;
    if (x_ix_we_q) ix_q <= x_sum_i;
  end

  assign d1_source_o = d1_source_q;
  assign d1_dest_o   = d1_dest_q;
  assign d1_ix_o     = ix_q;

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// Shift registers between a few pins and a hard-wired program, so that a program with any number of
// inputs and outputs can be placed and routed, and every path to and from it is registered.
//   With HOST 0 only inputs, clock relays and ticks go in and outputs come out.
//   With HOST 1 there is also what a host costs that reads and writes every device: a frame carries
//   an address and 16 bits of data; each group of 16 bits of the state can be read, and replaced.
`default_nettype none

module hardwired_link #(
    parameter integer HOST    = 0,
    parameter integer INPUTS  = 1,  // all that goes in before a scan: inputs, clock relays, ticks
    parameter integer OUTPUTS = 1,
    parameter integer STATE   = 1
) (
    input  wire               clk_i,
    input  wire               rst_i,
    // pins
    input  wire               sdi_i,
    input  wire               shift_i,
    input  wire               frame_i,       // a frame is whole: carry it out
    output wire               sdo_o,
    // program
    output wire [ INPUTS-1:0] in_o,
    input  wire [OUTPUTS-1:0] out_i,
    input  wire               busy_i,
    output wire               state_load_o,
    output wire [  STATE-1:0] state_o,
    input  wire [  STATE-1:0] state_i
);

  localparam integer GROUPS = (STATE + 15) / 16;
  localparam integer BLOCKS = (GROUPS + 15) / 16;  // of 16 groups
  localparam integer LINE_BITS = $clog2(16 * BLOCKS);
  localparam integer PADDED = 256 * BLOCKS;
  localparam integer CONTROL = 33;  // 32 write, 31:16 address, 15:0 data

  reg sdi_q;
  reg shift_q;
  reg frame_q;
  reg [INPUTS-1:0] shift_in_q;
  reg [INPUTS-1:0] in_q;
  reg [OUTPUTS-1:0] out_q;

  always @(posedge clk_i) begin
    sdi_q   <= sdi_i;
    shift_q <= shift_i;
    frame_q <= frame_i;
    if (shift_q) shift_in_q <= (shift_in_q << 1) | {{INPUTS - 1{1'b0}}, sdi_q};
    if (frame_q) in_q <= shift_in_q;
    if (frame_q) out_q <= out_i;
    else if (shift_q) out_q <= out_q << 1;
    if (rst_i) in_q <= {INPUTS{1'b0}};
  end
  assign in_o = in_q;

  generate
    if (HOST != 0) begin : gen_host
      reg [CONTROL-1:0] control_q;
      reg [CONTROL-1:0] command_q;
      reg write_q;
      // A read takes two clocks: one group of each block, then one of these.
      reg [16*BLOCKS-1:0] block_q;
      reg [15:0] read_q;
      wire [PADDED-1:0] now = {{PADDED - STATE{1'b0}}, state_i};
      wire [16*GROUPS-1:0] next;
      wire [15:0] line = {command_q[31:20], 4'b0};
      wire unused = &{1'b0, line, command_q[CONTROL-1], next};
      genvar g;
      genvar b;
      for (b = 0; b < BLOCKS; b = b + 1) begin : gen_block
        wire [255:0] here = now[256*b+:256];
        always @(posedge clk_i) block_q[16*b+:16] <= here[{command_q[19:16], 4'b0}+:16];
      end
      for (g = 0; g < GROUPS; g = g + 1) begin : gen_group
        assign next[16*g+:16] = command_q[31:16] == g ? command_q[15:0] : now[16*g+:16];
      end
      always @(posedge clk_i) begin
        if (shift_q) control_q <= {control_q[CONTROL-2:0], shift_in_q[INPUTS-1]};
        if (frame_q) command_q <= control_q;
        write_q <= frame_q & control_q[CONTROL-1];
        read_q <= block_q[line[LINE_BITS-1:0]+:16];
      end
      assign state_load_o = write_q & ~busy_i;
      assign state_o = next[STATE-1:0];
      assign sdo_o = out_q[OUTPUTS-1] ^ (^read_q);
    end else begin : gen_pins
      wire unused = &{1'b0, busy_i, state_i};
      assign state_load_o = 1'b0;
      assign state_o = {STATE{1'b0}};
      assign sdo_o = out_q[OUTPUTS-1];
    end
  endgenerate

endmodule

// SPDX-License-Identifier: Apache-2.0
// The bit side of MPU1 (paper, 4.2): one contact or coil a clock, with one operand `a` that is
// read or written, the accumulator exc, a block stack (LD, LDI, LDX push; ANB, ORB, POP pop) and a
// branch stack (MPS, MRD, MPP). GET gathers the operand in acc; a test of the word side writes `a`.
`default_nettype none
`include "rung_isa.vh"

module contact_unit #(
    parameter BIT_ADDR   = 10,  // bits of a bit device's number
    parameter FIELD_BITS = 43,  // bits of one slot's instruction below its opcode
    parameter WORD_ADDR  = 8
) (
    input  wire                       clk_i,
    input  wire                       scan_start_i,
    // ID1: opcode as issued, and the instruction's fields below it
    input  wire [  `RUNG_OP_BITS-1:0] d1_op_i,
    input  wire [     FIELD_BITS-1:0] d1_fields_i,
    // ID1: for an indexed access, what takes the place of `a`
    input  wire                       d1_ix_dest_i,
    input  wire [       BIT_ADDR-1:0] d1_ix_i,
    output wire [       BIT_ADDR-1:0] d1_addr_o,
    // ID2: memory data
    input  wire                       d2_bank_i,
    // the devices that are written: steps in ID2, ID3 and EX, the one
    // before (w_) and the one before that (v_)
    output wire [       BIT_ADDR-1:0] d2_dest_o,
    output wire [       BIT_ADDR-1:0] d3_dest_o,
    output wire [       BIT_ADDR-1:0] x_dest_o,
    input  wire [       BIT_ADDR-1:0] w_dest_i,
    input  wire                       w_we_i,
    input  wire                       w_value_i,
    input  wire                       v_value_i,
    // EX: a test of the word side is executed; its result, 0 if there is none
    input  wire                       x_test_we_i,
    input  wire                       x_test_i,
    // EX: the write, exc before and after, and acc
    output wire                       x_we_o,
    output wire                       x_value_o,
    output wire                       x_exc_o,
    output wire                       x_exc_next_o,
    output wire [`RUNG_WORD_BITS-1:0] x_acc_o
);

  localparam LOOKUP = 0;
  `include "fields.vh"
  localparam BLOCKS = `RUNG_BLOCK_STACK;
  localparam BRANCHES = `RUNG_BRANCH_STACK;

  // ---- ID1 -------------------------------------------------------------------------------------
  wire d1_u = d1_fields_i[U_AT];
  assign d1_addr_o = d1_ix_dest_i ? d1_ix_i : d1_fields_i[A_AT+:BIT_ADDR];

  // ---- ID2 -------------------------------------------------------------------------------------
  reg [`RUNG_OP_BITS-1:0] d2_op_q;
  reg d2_u_q;
  reg [BIT_ADDR-1:0] d2_dest_q;
  always @(posedge clk_i) begin
    d2_op_q   <= d1_op_i;
    d2_u_q    <= d1_u;
    d2_dest_q <= d1_addr_o;
  end
  assign d2_dest_o = d2_dest_q;

  // ---- ID3: decode -----------------------------------------------------------------------------
  reg [`RUNG_OP_BITS-1:0] d3_op_q;
  reg d3_u_q;
  reg [BIT_ADDR-1:0] d3_dest_q;
  always @(posedge clk_i) begin
    d3_op_q   <= d2_op_q;
    d3_u_q    <= d2_u_q;
    d3_dest_q <= d2_dest_q;
  end
  assign d3_dest_o = d3_dest_q;

  wire d3_pop = d3_op_q == `RUNG_OP_POP;
  wire d3_block = d3_op_q == `RUNG_OP_ANB || d3_op_q == `RUNG_OP_ORB || d3_pop;
  wire d3_branch = d3_op_q == `RUNG_OP_MRD || d3_op_q == `RUNG_OP_MPP;
  wire d3_invert = d3_op_q == `RUNG_OP_LDI || d3_op_q == `RUNG_OP_ANI || d3_op_q == `RUNG_OP_ORI;
  wire d3_push_block = d3_op_q == `RUNG_OP_LD || d3_op_q == `RUNG_OP_LDI || d3_op_q == `RUNG_OP_LDX;
  wire d3_and = d3_op_q == `RUNG_OP_AND || d3_op_q == `RUNG_OP_ANI || d3_op_q == `RUNG_OP_ANB;
  wire d3_or = d3_op_q == `RUNG_OP_OR || d3_op_q == `RUNG_OP_ORI || d3_op_q == `RUNG_OP_ORB;
  wire d3_set = d3_op_q == `RUNG_OP_SET || d3_op_q == `RUNG_OP_SETX;
  wire d3_rst = d3_op_q == `RUNG_OP_RST || d3_op_q == `RUNG_OP_RSTX;
  wire d3_test = d3_op_q == `RUNG_OP_EQ || d3_op_q == `RUNG_OP_LT || d3_op_q == `RUNG_OP_LTU ||
      d3_op_q == `RUNG_OP_LTC || d3_op_q == `RUNG_OP_TB;

  // ---- EX --------------------------------------------------------------------------------------
  reg x_block_q, x_branch_q, x_invert_q, x_load_q, x_and_q, x_or_q, x_inv_q;
  reg x_push_block_q, x_push_branch_q, x_pop_branch_q;
  reg x_out_q, x_set_q, x_known_q, x_gated_q, x_always_q, x_get_q, x_u_q;
  reg [BIT_ADDR-1:0] x_dest_q;
  reg exc_q;
  reg [BLOCKS-1:0] block_q;
  reg [BRANCHES-1:0] branch_q;
  reg [`RUNG_WORD_BITS-1:0] acc_q;
  always @(posedge clk_i) begin
    x_block_q <= d3_block;
    x_branch_q <= d3_branch;
    x_invert_q <= d3_invert;
    x_load_q <= d3_push_block || d3_branch || d3_pop;
    x_inv_q <= d3_op_q == `RUNG_OP_INV;
    x_and_q <= d3_and;
    x_or_q <= d3_or;
    x_push_block_q <= d3_push_block;
    x_push_branch_q <= d3_op_q == `RUNG_OP_MPS;
    x_pop_branch_q <= d3_op_q == `RUNG_OP_MPP;
    x_out_q <= d3_op_q == `RUNG_OP_OUT;
    x_set_q <= d3_set;
    x_known_q <= d3_set || d3_rst || d3_test;
    x_get_q <= d3_op_q == `RUNG_OP_GET;
    x_u_q <= d3_u_q;
    x_gated_q <= (d3_set || d3_rst) && !d3_u_q;
    x_always_q <= ((d3_set || d3_rst) && d3_u_q) || d3_op_q == `RUNG_OP_OUT;
    x_dest_q <= d3_dest_q;
  end
  assign x_dest_o = x_dest_q;

  wire x_device;
  operand #(
      .WIDTH(1),
      .ADDR_BITS(BIT_ADDR),
      .WRITERS(1)
  ) operand (
      .clk_i(clk_i),
      .d1_addr_i(d1_addr_o),
      .d2_dest_i(d2_dest_q),
      .d3_dest_i(d3_dest_q),
      .x_dest_i(x_dest_q),
      .w_dest_i(w_dest_i),
      .d2_bank_i(d2_bank_i),
      .d3_device_i(1'b1),
      .d3_other_i(1'b0),
      .x_we_i(x_we_o),
      .w_we_i(w_we_i),
      .w_data_i(w_value_i),
      .v_data_i(v_value_i),
      .x_value_o(x_device)
  );

  reg  x_exc_next;
  wire x_contact = x_block_q ? block_q[0] : x_branch_q ? branch_q[0] : x_device ^ x_invert_q;
  always @* begin
    x_exc_next = exc_q;
    if (x_load_q) x_exc_next = x_contact;
    if (x_and_q) x_exc_next = exc_q && x_contact;
    if (x_or_q) x_exc_next = exc_q || x_contact;
    if (x_inv_q) x_exc_next = !exc_q;
  end

  // An instruction that writes no bit gives the operand, which is how the host reads a device.
  assign x_we_o = x_always_q || (x_gated_q && exc_q) || x_test_we_i;
  assign x_value_o = (x_out_q ? exc_q : x_known_q ? x_set_q : x_device) || x_test_i;
  assign x_exc_o = exc_q;
  assign x_exc_next_o = x_exc_next;
  assign x_acc_o = acc_q;

  always @(posedge clk_i) begin
    exc_q <= x_exc_next;
    if (x_push_block_q) block_q <= {block_q[BLOCKS-2:0], exc_q};
    if (x_block_q) block_q <= {1'b0, block_q[BLOCKS-1:1]};
    if (x_push_branch_q) branch_q <= {branch_q[BRANCHES-2:0], exc_q};
    if (x_pop_branch_q) branch_q <= {1'b0, branch_q[BRANCHES-1:1]};
    if (x_get_q) acc_q <= {acc_q[`RUNG_WORD_BITS-2:0] & {`RUNG_WORD_BITS - 1{!x_u_q}}, x_device};
    if (scan_start_i) begin
      exc_q <= 1'b0;
      block_q <= {BLOCKS{1'b0}};
      branch_q <= {BRANCHES{1'b0}};
      acc_q <= {`RUNG_WORD_BITS{1'b0}};
    end
  end

endmodule

`default_nettype wire

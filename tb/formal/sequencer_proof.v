// SPDX-License-Identifier: Apache-2.0
// Constant latency (hdl/core/sequencer.v): a step stays one clock in ID1, or, with a waiting MUL, DIV, MULD
// or DIVD, the longest of their latencies and one more, of which the first is its first pass and the last
// its last pass. Opcodes are free.
`default_nettype none
`include "rung_isa.vh"

module sequencer_proof #(
    parameter SLOTS = 1,
    parameter MUL_LATENCY = 18,
    parameter DIV_LATENCY = 19,
    parameter MUL32_LATENCY = 34,
    parameter DIV32_LATENCY = 37
) (
    input wire clk_i,
    input wire rst_ni,
    input wire [SLOTS*`RUNG_OP_BITS-1:0] op_i,
    input wire peek_waits,
    input wire peek_waiting,
    input wire [2:0] peek_kind,  // mul32, div, mul
    input wire [5:0] peek_count
);

  wire first, last, hold;
  sequencer #(
      .SLOTS(SLOTS),
      .MUL_LATENCY(MUL_LATENCY),
      .DIV_LATENCY(DIV_LATENCY),
      .MUL32_LATENCY(MUL32_LATENCY),
      .DIV32_LATENCY(DIV32_LATENCY)
  ) sequencer (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .f3_op_i(op_i),
      .d1_first_o(first),
      .d1_last_o(last),
      .d1_hold_o(hold)
  );

  // ---- the step in ID1, and how long it has been there ------------------------------------------
  function automatic [5:0] latency(input reg [`RUNG_OP_BITS-1:0] op);
    case (op)
      `RUNG_OP_MUL: latency = MUL_LATENCY;
      `RUNG_OP_DIV: latency = DIV_LATENCY;
      `RUNG_OP_MULD: latency = MUL32_LATENCY;
      `RUNG_OP_DIVD: latency = DIV32_LATENCY;
      default: latency = 6'd0;
    endcase
  endfunction

  reg started_q;
  initial started_q = 1'b0;
  reg [SLOTS*`RUNG_OP_BITS-1:0] ops_q;
  reg [5:0] since_q;
  reg [5:0] longest;
  integer i;
  always @* begin
    longest = 6'd0;
    for (i = 0; i < SLOTS; i = i + 1) begin
      if (latency(ops_q[i*`RUNG_OP_BITS+:`RUNG_OP_BITS]) > longest)
        longest = latency(ops_q[i*`RUNG_OP_BITS+:`RUNG_OP_BITS]);
      // Only MPU1 has the 32-bit ones that wait.
      if (SLOTS > 1) begin
        assume (op_i[i*`RUNG_OP_BITS+:`RUNG_OP_BITS] != `RUNG_OP_MULD);
        assume (op_i[i*`RUNG_OP_BITS+:`RUNG_OP_BITS] != `RUNG_OP_DIVD);
      end
    end
  end
  always @(posedge clk_i) begin
    if (!rst_ni) begin
      started_q <= 1'b1;
      ops_q <= {SLOTS * `RUNG_OP_BITS{1'b0}};
      since_q <= 6'd0;
    end else if (since_q == longest) begin
      ops_q <= op_i;
      since_q <= 6'd0;
    end else begin
      since_q <= since_q + 6'd1;
    end
  end

  function automatic has(input reg [`RUNG_OP_BITS-1:0] op);
    integer j;
    begin
      has = 1'b0;
      for (j = 0; j < SLOTS; j = j + 1)
        if (ops_q[j*`RUNG_OP_BITS+:`RUNG_OP_BITS] == op) has = 1'b1;
    end
  endfunction

  always @* begin
    if (started_q) begin
      assert (first == (since_q == 6'd0));
      assert (last == (longest != 6'd0 && since_q == longest));
      assert (hold == (since_q != longest));
      // its registers
      assert (since_q <= longest);
      assert (peek_waits == (longest != 6'd0));
      assert (peek_waiting == (since_q != 6'd0));
      if (peek_waits)
        assert (peek_kind == {has(`RUNG_OP_MULD), has(`RUNG_OP_DIV), has(`RUNG_OP_MUL)});
      if (since_q != 6'd0) assert (peek_count == longest - since_q);
    end
  end

  always @* begin
    cover (started_q && last && longest == MUL_LATENCY);
    cover (started_q && last && longest == DIV_LATENCY);
  end

endmodule

`default_nettype wire

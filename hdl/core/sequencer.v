// SPDX-License-Identifier: Apache-2.0
// Keeps a step with a waiting MUL or DIV in ID1 until its result can be collected. The step is
// issued twice: in the first pass MUL and DIV start their unit (and everything else is done), in
// the last pass they collect, latency clocks later; in between the slots get NOPs and the fetch
// stages hold.
`default_nettype none
`include "rung_isa.vh"

module sequencer #(
    parameter SLOTS = 1,
    parameter MUL_LATENCY = 18,  // clocks from the first pass to the last, 2 to 31
    parameter DIV_LATENCY = 19  // the same; a step with both kinds takes the longer
) (
    input  wire                           clk_i,
    input  wire                           rst_ni,
    // IF3: the opcodes of the step that ID1 has next, unless it holds; slot 0 lowest
    input  wire [SLOTS*`RUNG_OP_BITS-1:0] f3_op_i,
    // ID1: first pass (of any step), last pass (of a waiting one), more passes to come
    output wire                           d1_first_o,
    output wire                           d1_last_o,
    output wire                           d1_hold_o
);

  // ---- IF3 -------------------------------------------------------------------------------------
  reg f3_mul;
  reg f3_div;
  integer i;
  always @* begin
    f3_mul = 1'b0;
    f3_div = 1'b0;
    for (i = 0; i < SLOTS; i = i + 1) begin
      if (f3_op_i[i*`RUNG_OP_BITS+:`RUNG_OP_BITS] == `RUNG_OP_MUL) f3_mul = 1'b1;
      if (f3_op_i[i*`RUNG_OP_BITS+:`RUNG_OP_BITS] == `RUNG_OP_DIV) f3_div = 1'b1;
    end
  end

  // ---- ID1: d1_hold_o has far to go, so little may stand before it -----------------------------
  reg d1_mul_q;
  reg d1_div_q;
  reg d1_waits_q;
  always @(posedge clk_i) begin
    if (!rst_ni) begin
      d1_waits_q <= 1'b0;
    end else if (!d1_hold_o) begin
      d1_mul_q   <= f3_mul;
      d1_div_q   <= f3_div;
      d1_waits_q <= f3_mul || f3_div;
    end
  end

  localparam BOTH_LATENCY = MUL_LATENCY > DIV_LATENCY ? MUL_LATENCY : DIV_LATENCY;
  wire [31:0] d1_latency = !d1_mul_q ? DIV_LATENCY : !d1_div_q ? MUL_LATENCY : BOTH_LATENCY;

  reg d1_waiting_q;
  reg d1_last_q;
  reg [4:0] d1_count_q;
  wire d1_begin = d1_waits_q && !d1_waiting_q;

  always @(posedge clk_i) begin
    if (d1_begin) begin
      d1_count_q <= d1_latency[4:0] - 5'd1;
    end else begin
      d1_count_q <= d1_count_q - 5'd1;
    end
    if (!rst_ni) begin
      d1_waiting_q <= 1'b0;
      d1_last_q <= 1'b0;
    end else begin
      d1_waiting_q <= d1_begin || (d1_waiting_q && !d1_last_q);
      d1_last_q <= d1_waiting_q && d1_count_q == 5'd1;
    end
  end

  wire unused_latency = &{1'b0, d1_latency[31:5]};

  assign d1_first_o = !d1_waiting_q;
  assign d1_last_o  = d1_last_q;
  assign d1_hold_o  = d1_begin || (d1_waiting_q && !d1_last_q);

endmodule

`default_nettype wire

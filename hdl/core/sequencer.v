// SPDX-License-Identifier: Apache-2.0
// Keeps a step with a waiting MUL, DIV, MULD or DIVD in ID1 until its result can be collected. The
// step is issued twice: in the first pass these start their unit (and everything else is done), in
// the last pass they collect, latency clocks later; in between the slots get NOPs and the fetch
// stages hold.
`default_nettype none
`include "rung_isa.vh"

module sequencer #(
    parameter SLOTS = 1,
    parameter MUL_LATENCY = 18,  // clocks from the first pass to the last, 2 to 63
    parameter DIV_LATENCY = 19,  // the same; a step with both kinds takes the longer
    parameter MUL32_LATENCY = 34,  // of MULD and DIVD: MPU1's, whose steps have one instruction
    parameter DIV32_LATENCY = 37
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
  reg f3_mul, f3_div, f3_mul32, f3_div32;
  integer i;
  always @* begin
    {f3_mul, f3_div, f3_mul32, f3_div32} = 4'd0;
    for (i = 0; i < SLOTS; i = i + 1) begin
      if (f3_op_i[i*`RUNG_OP_BITS+:`RUNG_OP_BITS] == `RUNG_OP_MUL) f3_mul = 1'b1;
      if (f3_op_i[i*`RUNG_OP_BITS+:`RUNG_OP_BITS] == `RUNG_OP_DIV) f3_div = 1'b1;
      if (f3_op_i[i*`RUNG_OP_BITS+:`RUNG_OP_BITS] == `RUNG_OP_MULD) f3_mul32 = 1'b1;
      if (f3_op_i[i*`RUNG_OP_BITS+:`RUNG_OP_BITS] == `RUNG_OP_DIVD) f3_div32 = 1'b1;
    end
  end

  // ---- ID1: d1_hold_o has far to go, so little may stand before it -----------------------------
  reg d1_mul_q, d1_div_q, d1_mul32_q, d1_waits_q;
  always @(posedge clk_i) begin
    if (!rst_ni) begin
      d1_waits_q <= 1'b0;
    end else if (!d1_hold_o) begin
      d1_mul_q   <= f3_mul;
      d1_div_q   <= f3_div;
      d1_mul32_q <= f3_mul32;
      d1_waits_q <= f3_mul || f3_div || f3_mul32 || f3_div32;
    end
  end

  localparam BOTH_LATENCY = MUL_LATENCY > DIV_LATENCY ? MUL_LATENCY : DIV_LATENCY;
  reg [31:0] d1_latency;
  always @* begin
    d1_latency = d1_mul32_q ? MUL32_LATENCY : DIV32_LATENCY;
    if (d1_mul_q) d1_latency = MUL_LATENCY;
    if (d1_div_q) d1_latency = d1_mul_q ? BOTH_LATENCY : DIV_LATENCY;
  end

  reg d1_waiting_q;
  reg d1_last_q;
  reg [5:0] d1_count_q;
  wire d1_begin = d1_waits_q && !d1_waiting_q;

  always @(posedge clk_i) begin
    if (d1_begin) begin
      d1_count_q <= d1_latency[5:0] - 6'd1;
    end else begin
      d1_count_q <= d1_count_q - 6'd1;
    end
    if (!rst_ni) begin
      d1_waiting_q <= 1'b0;
      d1_last_q <= 1'b0;
    end else begin
      d1_waiting_q <= d1_begin || (d1_waiting_q && !d1_last_q);
      d1_last_q <= d1_waiting_q && d1_count_q == 6'd1;
    end
  end

  wire unused_latency = &{1'b0, d1_latency[31:6]};

  assign d1_first_o = !d1_waiting_q;
  assign d1_last_o  = d1_last_q;
  assign d1_hold_o  = d1_begin || (d1_waiting_q && !d1_last_q);

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// The multiply-divide unit of one slot; signed operands of 16 or 32 bits, whose high words LDH has
// set before. It holds one operation: the operands are taken at the end of EX, and the result's words
// stay until the next start.
// First clock after EX by which an instruction that collects may be in EX itself (the latency):
//   MUL with MUL_DSP = 1  3: product of the operand registers into a register, ID3, EX
//   MUL with MUL_DSP = 0 18: sixteen add-and-shift steps, ID3, EX
//   DIV                  19: |dividend|, sixteen restoring steps, ID3 (which applies the signs), EX
//   MULD                 34: thirty-two add-and-shift steps, ID3, EX
//   DIVD                 37: |dividend| in two clocks, thirty-two restoring steps, a clock for the
//                            carries between the result's words, ID3, EX
// Division truncates towards 0, the remainder has the dividend's sign; the most negative number
// divided by -1 is itself.
`default_nettype none
`include "rung_isa.vh"

module muldiv #(
    parameter MUL_DSP = 1  // 1: 16-bit products in a multiplier block, 0: by iteration
) (
    input  wire                       clk_i,
    input  wire                       rst_ni,
    input  wire                       scan_start_i,  // forgets the last scan's operation
    // EX: x_start_i with x_executed_i = 0 leaves the unit without a valid result; x_wide_i is 1 for
    // 32 bits; with x_high_i the operands are the high words of later starts
    input  wire                       x_start_i,
    input  wire                       x_executed_i,
    input  wire                       x_div_i,
    input  wire                       x_wide_i,
    input  wire                       x_high_i,
    input  wire [`RUNG_WORD_BITS-1:0] x_s1_i,
    input  wire [`RUNG_WORD_BITS-1:0] x_s2_i,
    // ID3: word 0 to 3 of the result (product; quotient and remainder); valid if executed and not
    // divided by 0
    input  wire [                1:0] d3_word_i,
    output wire [`RUNG_WORD_BITS-1:0] d3_result_o,
    output wire                       d3_valid_o,
    // an executed division by 0, in the clock after its EX
    output wire                       w_div_by_0_o
);

  reg first_q;  // the clock after EX
  reg second_q;  // the clock after that, of DIVD
  reg run_q;  // one of the sixteen or thirty-two steps
  reg [4:0] count_q;
  reg div_q;
  reg wide_q;
  reg valid_q;
  reg negative_q;  // the dividend's sign
  reg [15:0] high1_q;  // of LDH
  reg [15:0] high2_q;
  reg [31:0] divisor_q;  // or multiplicand
  reg [31:0] high_q;  // partial remainder, or upper half of the product
  reg [31:0] low_q;  // dividend becoming quotient, or multiplier becoming lower half

  // One adder for both: the partial remainder less |divisor|, or the partial product plus the
  // multiplicand, which the multiplier's sign bit subtracts. 16-bit operations use it with their
  // operands extended; only where low_q's top is differs. Add or subtract is known a clock before,
  // since so many bits wait for it.
  wire last = count_q == 5'd31;
  reg subtract_q;
  always @(posedge clk_i) begin
    subtract_q <= !x_start_i && (div_q ? !divisor_q[31] : count_q == 5'd30);
  end
  wire dividend_bit = wide_q ? low_q[31] : low_q[15];
  wire [32:0] augend = div_q ? {high_q, dividend_bit} : {high_q[31], high_q};
  wire [32:0] addend = {divisor_q[31], divisor_q} & {33{div_q | low_q[0]}};
  wire [33:0] chain = {augend, 1'b1} + {addend ^ {33{subtract_q}}, subtract_q};
  wire [32:0] sum = chain[33:1];
  wire unused_chain = &{1'b0, chain[0]};

  // One negation of a word for both ends of a division. That of an upper word goes on from its
  // lower one: there is a carry if that is 0.
  wire [2:0] d3_select = {wide_q, d3_word_i};
  reg low_zero_q;
  reg high_zero_q;
  reg [15:0] magnitude;
  reg carry;
  reg sign;
  always @* begin
    if (first_q) begin
      {magnitude, carry, sign} = {low_q[15:0], 1'b1, wide_q ? low_q[31] : low_q[15]};
    end else if (second_q) begin
      {magnitude, carry, sign} = {low_q[31:16], low_zero_q, negative_q};
    end else begin
      case (d3_select)
        3'b000, 3'b100: {magnitude, carry} = {low_q[15:0], 1'b1};
        3'b101: {magnitude, carry} = {low_q[31:16], low_zero_q};
        3'b111: {magnitude, carry} = {high_q[31:16], high_zero_q};
        default: {magnitude, carry} = {high_q[15:0], 1'b1};
      endcase
      sign = negative_q ^ (divisor_q[31] && (wide_q ? !d3_word_i[1] : !d3_word_i[0]));
    end
  end
  wire negate = div_q && sign;
  wire [15:0] signed_word = (magnitude ^ {16{negate}}) + {15'd0, negate && carry};

  always @(posedge clk_i) begin
    if (x_high_i) begin
      high1_q <= x_s1_i;
      high2_q <= x_s2_i;
    end
    low_zero_q  <= low_q[15:0] == 16'd0;
    high_zero_q <= high_q[15:0] == 16'd0;

    if (x_start_i) begin
      div_q <= x_div_i;
      wide_q <= x_wide_i;
      divisor_q <= {x_wide_i ? high2_q : {16{x_s2_i[15]}}, x_s2_i};
      high_q <= 32'd0;
      low_q <= {high1_q, x_s1_i};
      count_q <= x_wide_i ? 5'd0 : 5'd16;
    end else if (first_q && div_q) begin
      negative_q  <= sign;
      low_q[15:0] <= signed_word;
    end else if (second_q) begin
      low_q[31:16] <= signed_word;
    end else if (run_q) begin
      count_q <= count_q + 5'd1;
      if (div_q) begin
        high_q <= sum[32] ? {high_q[30:0], dividend_bit} : sum[31:0];
        low_q  <= {low_q[30:0], !sum[32]};
      end else begin
        {high_q, low_q} <= {sum, low_q[31:1]};
        if (!wide_q) low_q[15] <= sum[0];
      end
    end
  end

  assign w_div_by_0_o = first_q && div_q && valid_q && divisor_q == 32'd0;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      first_q <= 1'b0;
      second_q <= 1'b0;
      run_q <= 1'b0;
      valid_q <= 1'b0;
    end else begin
      first_q  <= x_start_i;
      second_q <= first_q && div_q && wide_q && !x_start_i;
      if (x_start_i) begin
        run_q <= !x_div_i && (x_wide_i || MUL_DSP == 0);
      end else if (first_q && div_q) begin
        run_q <= !wide_q;
      end else if (second_q) begin
        run_q <= 1'b1;
      end else if (last) begin
        run_q <= 1'b0;
      end
      if (scan_start_i) begin
        valid_q <= 1'b0;
      end else if (x_start_i) begin
        valid_q <= x_executed_i;
      end else if (w_div_by_0_o) begin
        valid_q <= 1'b0;
      end
    end
  end

  generate
    if (MUL_DSP != 0) begin : g_dsp
      reg [31:0] product_q;
      always @(posedge clk_i) begin
        if (first_q) product_q <= $signed(low_q[15:0]) * $signed(divisor_q[15:0]);
      end
      wire [15:0] product_word = d3_word_i[0] ? product_q[31:16] : product_q[15:0];
      assign d3_result_o = div_q || wide_q ? signed_word : product_word;
    end else begin : g_no_dsp
      assign d3_result_o = signed_word;
    end
  endgenerate
  assign d3_valid_o = valid_q;

endmodule

`default_nettype wire

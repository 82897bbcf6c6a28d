// SPDX-License-Identifier: Apache-2.0
// The multiply-divide unit (hdl/core/muldiv.v), full width, without bound: whatever is started whenever,
// from the latency on all words of the result are there, until the next start. A product is the sum of s2
// times the weight of each bit of s1, the sign bit's weight being negative; a division's result is a
// quotient and a remainder, smaller than the divisor, with quotient * divisor + remainder = dividend, by
// magnitude. Both are followed bit by bit, so that a step is small for the solver.
`default_nettype none
`include "rung_isa.vh"

module muldiv_proof #(
    parameter MUL_DSP = 0,
    parameter MUL_LATENCY = 18,
    parameter DIV_LATENCY = 19,
    parameter MUL32_LATENCY = 34,
    parameter DIV32_LATENCY = 37
) (
    input wire clk_i,
    input wire scan_start_i,
    input wire start_i,
    input wire executed_i,
    input wire div_i,
    input wire wide_i,
    input wire ldh_i,
    input wire [15:0] s1_i,
    input wire [15:0] s2_i,
    input wire [1:0] word_i,
    // the unit's registers
    input wire peek_first,
    input wire peek_second,
    input wire peek_run,
    input wire [4:0] peek_count,
    input wire peek_div,
    input wire peek_wide,
    input wire peek_negative,
    input wire peek_subtract,
    input wire [15:0] peek_high1,
    input wire [15:0] peek_high2,
    input wire [31:0] peek_divisor,
    input wire [31:0] peek_high,
    input wire [31:0] peek_low,
    // with MUL_DSP: the block's product, and the other operations' word, which is the same without
    input wire [31:0] peek_product,
    input wire [15:0] peek_word
);

  reg reset_q;
  initial reset_q = 1'b1;
  always @(posedge clk_i) reset_q <= 1'b0;
  wire start = start_i && !reset_q;

  wire [15:0] result;
  wire valid, div_by_0;
  muldiv #(
      .MUL_DSP(MUL_DSP)
  ) unit (
      .clk_i(clk_i),
      .rst_ni(!reset_q),
      .scan_start_i(scan_start_i),
      .x_start_i(start),
      .x_executed_i(executed_i),
      .x_div_i(div_i),
      .x_wide_i(wide_i),
      .x_high_i(ldh_i),
      .x_s1_i(s1_i),
      .x_s2_i(s2_i),
      .d3_word_i(word_i),
      .d3_result_o(result),
      .d3_valid_o(valid),
      .w_div_by_0_o(div_by_0)
  );
  // An instruction is LDH or a start.
  always @* assume (!(start_i && ldh_i));

  // ---- the operation, and the clocks since its EX (0: none yet) --------------------------------
  reg [5:0] after_q;
  initial after_q = 6'd0;
  reg div_q, wide_q, valid_q;
  initial valid_q = 1'b0;
  reg [15:0] high1_q, high2_q;
  reg signed [31:0] s1_q, s2_q;
  wire by_0 = div_q && s2_q == 32'd0;
  // The unit starts without a valid operation; LDH's words are any.
  always @* if (reset_q) assume (high1_q == peek_high1 && high2_q == peek_high2);
  always @(posedge clk_i) begin
    if (start) after_q <= 6'd1;
    else if (after_q != 6'd0 && after_q != 6'd63) after_q <= after_q + 6'd1;
    if (start) begin
      div_q  <= div_i;
      wide_q <= wide_i;
      s1_q   <= wide_i ? {high1_q, s1_i} : {{16{s1_i[15]}}, s1_i};
      s2_q   <= wide_i ? {high2_q, s2_i} : {{16{s2_i[15]}}, s2_i};
    end
    if (ldh_i) begin
      high1_q <= s1_i;
      high2_q <= s2_i;
    end
    if (scan_start_i || reset_q) valid_q <= 1'b0;
    else if (start) valid_q <= executed_i;
    else if (by_0) valid_q <= 1'b0;
  end

  wire iterates = div_q || wide_q || MUL_DSP == 0;
  wire [5:0] width = wide_q ? 6'd32 : 6'd16;
  wire [5:0] lead = !div_q ? 6'd1 : wide_q ? 6'd3 : 6'd2;  // clocks ahead of the first step
  wire stepping = iterates && after_q >= lead && after_q < lead + width;
  wire stepped = after_q >= lead + width;
  wire [5:0] latency = div_q ? (wide_q ? DIV32_LATENCY : DIV_LATENCY) :
      wide_q ? MUL32_LATENCY : MUL_LATENCY;

  // ---- product: half of it and s2 at the top's weight for each bit of s1, the lowest first ------
  reg signed [63:0] product_q;
  reg [31:0] bits_q;  // of s1, those to come
  reg [31:0] mask_q;  // where those are
  wire signed [63:0] top = wide_q ? {s2_q[31], s2_q, 31'd0} : {{17{s2_q[31]}}, s2_q, 15'd0};
  wire last = after_q + 6'd1 == lead + width;
  wire signed [63:0] half = {product_q[63], product_q[63:1]};
  always @(posedge clk_i) begin
    if (start) begin
      product_q <= 64'd0;
      bits_q <= wide_i ? {high1_q, s1_i} : {16'd0, s1_i};
      mask_q <= wide_i ? 32'hFFFFFFFF : 32'h0000FFFF;
    end else if (stepping) begin
      product_q <= !bits_q[0] ? half : last ? half - top : half + top;
      bits_q <= {1'b0, bits_q[31:1]};
      mask_q <= {1'b0, mask_q[31:1]};
    end
  end

  // In a multiplier block: of the registers that are shown to be s1 and s2 then.
  reg [31:0] block_q;
  always @(posedge clk_i) begin
    if (after_q == 6'd1) block_q <= $signed(peek_low[15:0]) * $signed(peek_divisor[15:0]);
  end

  // ---- division: the dividend's upper bits so far, the quotient's, and divisor times them -------
  wire [31:0] dividend = s1_q[31] ? -s1_q : s1_q;
  wire [31:0] divisor = s2_q[31] ? -s2_q : s2_q;
  reg [31:0] taken_q, left_q, quotient_q;
  reg [31:0] ones_q;  // where those to come are
  reg [32:0] times_q;
  reg new_bit_q;
  wire [31:0] aligned = wide_q ? dividend : {dividend[15:0], 16'd0};
  wire [31:0] quotient = new_bit_q ? {quotient_q[30:0], peek_low[0]} : quotient_q;
  wire [32:0] times = !new_bit_q ? times_q :
      {times_q[31:0], 1'b0} + (peek_low[0] ? {1'b0, divisor} : 33'd0);
  always @(posedge clk_i) begin
    if (start || after_q < lead) begin
      taken_q <= 32'd0;
      left_q <= aligned;
      ones_q <= wide_q ? 32'hFFFFFFFF : 32'hFFFF0000;
      quotient_q <= 32'd0;
      times_q <= 33'd0;
    end else begin
      if (stepping) begin
        {taken_q, left_q} <= {taken_q[30:0], left_q, 1'b0};
        ones_q <= {ones_q[30:0], 1'b0};
      end
      quotient_q <= quotient;
      times_q <= times;
    end
    new_bit_q <= stepping && !start;
  end

  // ---- what the registers have to be -----------------------------------------------------------
  always @* begin
    if (!reset_q) begin
      assert (high1_q == peek_high1 && high2_q == peek_high2);
      assert (valid == valid_q);
      assert (div_by_0 == (valid_q && by_0 && after_q == 6'd1));
      if (by_0 && after_q > 6'd1) assert (!valid_q);
      assert (peek_first == (after_q == 6'd1));
      assert (peek_run == stepping);
      if (after_q == 6'd0) assert (!peek_second && !valid_q);
    end
    if (after_q != 6'd0) begin
      assert (peek_div == div_q && peek_wide == wide_q && peek_divisor == s2_q);
      assert (peek_second == (div_q && wide_q && after_q == 6'd2));
      if (stepping) begin
        assert (peek_count == (wide_q ? 5'd0 : 5'd16) + after_q[4:0] - lead[4:0]);
        assert (peek_subtract == (div_q ? !s2_q[31] : peek_count == 5'd31));
      end
      if (after_q < lead) assert (peek_count == (wide_q ? 5'd0 : 5'd16));
      if (!wide_q) assert (s1_q[31:15] == {17{s1_q[15]}} && s2_q[31:15] == {17{s2_q[15]}});
    end
    if (!div_q && !iterates) begin
      if (after_q == 6'd1) assert (peek_low[15:0] == s1_q[15:0]);
      if (after_q > 6'd1) assert (peek_product == block_q);
    end
  end

  wire [5:0] steps = after_q < lead ? 6'd0 : stepped ? width : after_q - lead;
  always @* begin
    if (MUL_DSP == 0 && !div_q && after_q != 6'd0) begin
      assert ((wide_q ? {peek_high, peek_low} : {{16{peek_high[31]}}, peek_high, peek_low[15:0]}) ==
              (product_q | {32'd0, bits_q}));
      assert (mask_q == (wide_q ? 32'hFFFFFFFF : 32'h0000FFFF) >> steps);
      assert ((product_q[31:0] & mask_q) == 32'd0 && (bits_q & ~mask_q) == 32'd0);
    end
    if (MUL_DSP == 0 && div_q && after_q != 6'd0 && after_q < lead) begin
      assert (peek_high == 32'd0);
      assert (peek_low[15:0] == (after_q == 6'd1 ? s1_q[15:0] : dividend[15:0]));
      if (wide_q) assert (peek_low[31:16] == s1_q[31:16]);
    end
    if (div_q && after_q > 6'd1) assert (peek_negative == s1_q[31]);
    if (MUL_DSP == 0 && div_q && after_q >= lead) begin
      assert (ones_q == (wide_q ? 32'hFFFFFFFF : 32'hFFFF0000) << steps);
      assert ({taken_q, left_q} == {32'd0, aligned} << steps);
      assert ((left_q & ~ones_q) == 32'd0);
      if (wide_q) begin
        assert (peek_low == (left_q | quotient) && (quotient & ones_q) == 32'd0);
      end else begin
        assert (peek_low[15:0] == (left_q[31:16] | quotient[15:0]));
        assert ((quotient & ones_q >> 16) == 32'd0 && quotient[31:16] == 16'd0);
      end
      if (!by_0) begin
        assert (times + {1'b0, peek_high} == {1'b0, taken_q});
        assert (peek_high < divisor);
      end
    end
  end

  // ---- the result ------------------------------------------------------------------------------
  reg [63:0] expected;
  always @* begin
    expected = product_q;
    if (MUL_DSP != 0 && !wide_q) expected = {32'd0, block_q};
    if (div_q) begin
      expected[31:0]  = s1_q[31] != s2_q[31] ? -quotient : quotient;
      expected[63:32] = s1_q[31] ? -peek_high : peek_high;
      if (!wide_q) expected[31:16] = expected[47:32];
    end
  end
  wire there = after_q != 6'd0 && after_q >= latency - 6'd1;
  always @* begin
    if (there && valid && (wide_q || !word_i[1])) begin
      if (MUL_DSP == 0 || !iterates) assert (result == expected[16*word_i+:16]);
    end
    if (MUL_DSP != 0 && iterates && after_q != 6'd0) assert (result == peek_word);
  end

  always @* begin
    cover (there && valid && !div_q && wide_q && s1_q[31] && !s2_q[31] && word_i == 2'd1);
    cover (there && valid && div_q && !wide_q && s1_q[31] && result == 16'hFF12);
    cover (after_q == 6'd40 && by_0);
  end

endmodule

`default_nettype wire

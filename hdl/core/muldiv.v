// SPDX-License-Identifier: Apache-2.0
// The multiply-divide unit of one slot; signed 16-bit operands. It holds one operation: the
// operands are taken at the end of EX, and product, or quotient and remainder, stay until the next
// start.
// First clock after EX by which an instruction that collects may be in EX itself (the latency):
//   MUL with MUL_DSP = 1  3: product of the operand registers into a register, ID3, EX
//   MUL with MUL_DSP = 0 18: sixteen add-and-shift steps, ID3, EX
//   DIV                  19: |dividend|, sixteen restoring steps, ID3 (which applies the signs), EX
// Division truncates towards 0, the remainder has the dividend's sign, -32768 / -1 is -32768.
`default_nettype none
`include "rung_isa.vh"

module muldiv #(
    parameter MUL_DSP = 1  // 1: multiplier block, 0: the divider's registers and adder
) (
    input  wire                       clk_i,
    input  wire                       rst_ni,
    input  wire                       scan_start_i,  // forgets the last scan's operation
    // EX: x_start_i with x_executed_i = 0 leaves the unit without a valid result
    input  wire                       x_start_i,
    input  wire                       x_executed_i,
    input  wire                       x_div_i,
    input  wire [`RUNG_WORD_BITS-1:0] x_s1_i,
    input  wire [`RUNG_WORD_BITS-1:0] x_s2_i,
    // ID3: low word or quotient, high word or remainder; valid if executed and not divided by 0
    input  wire                       d3_high_i,
    output wire [`RUNG_WORD_BITS-1:0] d3_result_o,
    output wire                       d3_valid_o,
    // an executed division by 0, in the clock after its EX
    output wire                       w_div_by_0_o
);

  reg first_q;  // the clock after EX
  reg run_q;  // one of the sixteen steps
  reg [3:0] count_q;
  reg div_q;
  reg valid_q;
  reg negative_q;  // the dividend's sign
  reg [15:0] divisor_q;  // or multiplicand
  reg [15:0] high_q;  // partial remainder, or high word of the product
  reg [15:0] low_q;  // dividend becoming quotient, or multiplier becoming low word

  // One adder for both: the partial remainder less |divisor|, or the partial product plus the
  // multiplicand, which the multiplier's sign bit subtracts.
  wire last = count_q == 4'd15;
  wire subtract = div_q ? !divisor_q[15] : last;
  wire [16:0] augend = div_q ? {high_q, low_q[15]} : {high_q[15], high_q};
  wire [16:0] addend = {divisor_q[15], divisor_q} & {17{div_q | low_q[0]}};
  wire [16:0] sum = augend + (addend ^ {17{subtract}}) + {16'd0, subtract};

  // One negation for both ends of a division.
  wire take_high = d3_high_i && !first_q;
  wire [15:0] magnitude = take_high ? high_q : low_q;
  wire sign = first_q ? low_q[15] : negative_q ^ (!d3_high_i & divisor_q[15]);
  wire negate = div_q && sign;
  wire [15:0] signed_value = (magnitude ^ {16{negate}}) + {15'd0, negate};

  always @(posedge clk_i) begin
    if (x_start_i) begin
      div_q <= x_div_i;
      divisor_q <= x_s2_i;
      high_q <= 16'd0;
      low_q <= x_s1_i;
      count_q <= 4'd0;
    end else if (first_q && div_q) begin
      negative_q <= low_q[15];
      low_q <= signed_value;
    end else if (run_q) begin
      count_q <= count_q + 4'd1;
      if (div_q) begin
        high_q <= sum[16] ? {high_q[14:0], low_q[15]} : sum[15:0];
        low_q  <= {low_q[14:0], !sum[16]};
      end else begin
        {high_q, low_q} <= {sum, low_q[15:1]};
      end
    end
  end

  assign w_div_by_0_o = first_q && div_q && valid_q && divisor_q == 16'd0;

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      first_q <= 1'b0;
      run_q   <= 1'b0;
      valid_q <= 1'b0;
    end else begin
      first_q <= x_start_i;
      if (x_start_i) begin
        run_q <= !x_div_i && MUL_DSP == 0;
      end else if (first_q && div_q) begin
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
        if (first_q) product_q <= $signed(low_q) * $signed(divisor_q);
      end
      wire [15:0] product_word = d3_high_i ? product_q[31:16] : product_q[15:0];
      assign d3_result_o = div_q ? signed_value : product_word;
    end else begin : g_no_dsp
      assign d3_result_o = signed_value;
    end
  endgenerate
  assign d3_valid_o  = valid_q;

endmodule

`default_nettype wire

// SPDX-License-Identifier: Apache-2.0
// The divider of a word unit of MPU4: signed, towards 0, the remainder with the dividend's sign; the most negative
// number divided by -1 is itself. A pipeline of two quotient bits a stage, one start a clock:
//   EX operands   +1 operand registers   +2 magnitudes   +3 first digit, threefold divisor   +4 to +10 digits
//   +11 quotient with its sign (ID3 of QUO)   +12 remainder (ID3 of REM)
// which are the distances `div` and `div` + 1 of hdl/isa/wide.toml.
`default_nettype none

module wide_divider (
    input  wire        clk_i,
    input  wire [15:0] x_s1_i,
    input  wire [15:0] x_s2_i,
    // ID3 of QUO, ID3 of REM: the result; the divisor is 0
    output wire [15:0] d3_quotient_o,
    output wire [15:0] d3_remainder_o,
    output wire        d3_zero_o,
    output wire        d3_zero_late_o
);

  localparam DIGITS = 8;

  // ---- +1, +2: magnitudes ----------------------------------------------------------------------
  reg [15:0] s1_q;
  reg [15:0] s2_q;
  reg [15:0] dividend_q;
  reg [15:0] divisor_q;
  reg quotient_sign_q, remainder_sign_q;
  always @(posedge clk_i) begin
    s1_q <= x_s1_i;
    s2_q <= x_s2_i;
    dividend_q <= (s1_q ^ {16{s1_q[15]}}) + {15'd0, s1_q[15]};
    divisor_q <= (s2_q ^ {16{s2_q[15]}}) + {15'd0, s2_q[15]};
    quotient_sign_q <= s1_q[15] ^ s2_q[15];
    remainder_sign_q <= s1_q[15];
  end

  // ---- +3: the first digit, of two bits, needs no subtraction ----------------------------------
  // Element 0 of each is this stage's, element i that of digit i + 1.
  reg [15:0] divisor[0:DIGITS-1];
  reg [16:0] triple[0:DIGITS-1];
  reg [15:0] partial[0:DIGITS-1];  // remainder
  reg [15:0] low[0:DIGITS-1];  // digits of the dividend to come, those of the quotient below them
  reg [DIGITS-1:0] quotient_sign;
  reg [DIGITS-1:0] remainder_sign;
  wire [1:0] first = dividend_q[15:14];
  wire above_3 = divisor_q[15:2] != 14'd0;
  reg [1:0] first_digit;
  reg [1:0] first_rest;
  always @* begin
    first_digit = 2'd0;
    first_rest  = first;
    case ({
      above_3, divisor_q[1:0]
    })
      3'd1: {first_digit, first_rest} = {first, 2'd0};
      3'd2: {first_digit, first_rest} = {1'b0, first[1], 1'b0, first[0]};
      3'd3: if (first == 2'd3) {first_digit, first_rest} = {2'd1, 2'd0};
      default: ;
    endcase
  end
  always @(posedge clk_i) begin
    divisor[0] <= divisor_q;
    triple[0] <= {1'b0, divisor_q} + {divisor_q, 1'b0};
    partial[0] <= {14'd0, first_rest};
    low[0] <= {dividend_q[13:0], first_digit};
    quotient_sign <= {quotient_sign[DIGITS-2:0], quotient_sign_q};
    remainder_sign <= {remainder_sign[DIGITS-2:0], remainder_sign_q};
  end

  // ---- +4 to +10: the others, by the divisor taken once, twice and three times -----------------
  genvar i;
  generate
    for (i = 1; i < DIGITS; i = i + 1) begin : g_digit
      wire [17:0] all = {partial[i-1], low[i-1][15:14]};
      wire [18:0] less_1 = {1'b0, all} - {3'd0, divisor[i-1]};
      wire [18:0] less_2 = {1'b0, all} - {2'd0, divisor[i-1], 1'b0};
      wire [18:0] less_3 = {1'b0, all} - {2'd0, triple[i-1]};
      wire [1:0] digit = !less_2[18] ? {1'b1, !less_3[18]} : {1'b0, !less_1[18]};
      wire [15:0] rest = !less_3[18] ? less_3[15:0] : !less_2[18] ? less_2[15:0] :
          !less_1[18] ? less_1[15:0] : all[15:0];
      // Less than the divisor, so the upper bits are 0.
      wire unused_upper = &{1'b0, less_1[17:16], less_2[17:16], less_3[17:16]};
      always @(posedge clk_i) begin
        divisor[i] <= divisor[i-1];
        triple[i] <= triple[i-1];
        partial[i] <= rest;
        low[i] <= {low[i-1][13:0], digit};
      end
    end
  endgenerate

  // ---- +11, +12: signs -------------------------------------------------------------------------
  wire negative = quotient_sign[DIGITS-1];
  wire negative_rest = remainder_sign[DIGITS-1];
  reg [15:0] quotient_q;
  reg [15:0] rest_q;
  reg [15:0] remainder_q;
  reg zero_q, zero_late_q;
  always @(posedge clk_i) begin
    quotient_q <= (low[DIGITS-1] ^ {16{negative}}) + {15'd0, negative};
    rest_q <= (partial[DIGITS-1] ^ {16{negative_rest}}) + {15'd0, negative_rest};
    remainder_q <= rest_q;
    zero_q <= divisor[DIGITS-1] == 16'd0;
    zero_late_q <= zero_q;
  end
  assign d3_quotient_o = quotient_q;
  assign d3_remainder_o = remainder_q;
  assign d3_zero_o = zero_q;
  assign d3_zero_late_o = zero_late_q;
  wire unused_triple = &{1'b0, triple[DIGITS-1]};

endmodule

`default_nettype wire

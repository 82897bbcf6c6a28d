// SPDX-License-Identifier: Apache-2.0
// The divider of a word unit of MPU4: signed, towards 0, the remainder with the dividend's sign; the most
// negative number divided by -1 is itself. One division at a time, started in EX:
//   +1  magnitudes   +2 to +17  sixteen restoring steps   +18  quotient (ID3 of QUO)   +19  remainder
// The results are those words exactly then (hdl/isa/wide.toml, [distance]); a start in +18 or later is right.
`default_nettype none

module wide_divider (
    input  wire        clk_i,
    // EX
    input  wire        x_start_i,
    input  wire [15:0] x_s1_i,
    input  wire [15:0] x_s2_i,
    // ID3 of QUO, ID3 of REM
    output wire [15:0] d3_quotient_o,
    output wire [15:0] d3_remainder_o,
    // the divisor is 0: in ID3 of QUO, in ID3 of REM
    output wire        d3_zero_o,
    output wire        d3_zero_late_o
);

  reg first_q;
  reg dividend_sign_q;
  reg quotient_sign_q;
  reg zero_q;
  reg [15:0] divisor_q;  // its magnitude
  reg [15:0] high_q;  // partial remainder
  reg [15:0] low_q;  // dividend, bit by bit becoming the quotient

  wire [16:0] chain = {high_q, low_q[15]} - {1'b0, divisor_q};
  always @(posedge clk_i) begin
    first_q <= x_start_i;
    if (x_start_i) begin
      low_q <= x_s1_i;
      divisor_q <= x_s2_i;
      high_q <= 16'd0;
    end else if (first_q) begin
      dividend_sign_q <= low_q[15];
      quotient_sign_q <= low_q[15] ^ divisor_q[15];
      zero_q <= divisor_q == 16'd0;
      low_q <= (low_q ^ {16{low_q[15]}}) + {15'd0, low_q[15]};
      divisor_q <= (divisor_q ^ {16{divisor_q[15]}}) + {15'd0, divisor_q[15]};
    end else begin
      high_q <= chain[16] ? {high_q[14:0], low_q[15]} : chain[15:0];
      low_q  <= {low_q[14:0], !chain[16]};
    end
  end

  // Sixteen steps are done in the clock in which the quotient's instruction is in ID3. The steps go on after
  // that, so the remainder is taken in that clock, for the next one.
  reg [15:0] remainder_q;
  reg remainder_sign_q;
  reg zero_late_q;
  always @(posedge clk_i) begin
    remainder_q <= high_q;
    remainder_sign_q <= dividend_sign_q;
    zero_late_q <= zero_q;
  end
  assign d3_quotient_o = (low_q ^ {16{quotient_sign_q}}) + {15'd0, quotient_sign_q};
  assign d3_remainder_o = (remainder_q ^ {16{remainder_sign_q}}) + {15'd0, remainder_sign_q};
  assign d3_zero_o = zero_q;
  assign d3_zero_late_o = zero_late_q;

endmodule

`default_nettype wire

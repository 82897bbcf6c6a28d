// SPDX-License-Identifier: Apache-2.0
#include "hardwired/units.hpp"

#include <fmt/format.h>

namespace rung::hardwired {
namespace {

// {0}: name of the module
constexpr std::string_view kMul16 = R"(
// The signed product of two words: operands in one clock, the product two clocks later.
module {0} (
    input  wire        clk_i,
    input  wire [15:0] a_i,
    input  wire [15:0] b_i,
    output wire [31:0] result_o
);
  reg [15:0] a_q;
  reg [15:0] b_q;
  reg [31:0] product_q;
  always @(posedge clk_i) begin
    a_q <= a_i;
    b_q <= b_i;
    product_q <= $signed(a_q) * $signed(b_q);
  end
  assign result_o = product_q;
endmodule
)";

constexpr std::string_view kMul32 = R"(
// The signed product of two double words, three clocks later: four products of halves, then their sum.
module {0} (
    input  wire        clk_i,
    input  wire [31:0] a_i,
    input  wire [31:0] b_i,
    output wire [63:0] result_o
);
  reg [31:0] a_q;
  reg [31:0] b_q;
  reg [31:0] low_q;
  reg signed [32:0] middle_a_q;
  reg signed [32:0] middle_b_q;
  reg signed [31:0] high_q;
  reg [63:0] product_q;
  // The low halves have no sign.
  wire signed [16:0] a_low = $signed({{1'b0, a_q[15:0]}});
  wire signed [16:0] b_low = $signed({{1'b0, b_q[15:0]}});
  wire signed [15:0] a_high = $signed(a_q[31:16]);
  wire signed [15:0] b_high = $signed(b_q[31:16]);
  wire signed [33:0] middle = middle_a_q + middle_b_q;
  always @(posedge clk_i) begin
    a_q <= a_i;
    b_q <= b_i;
    low_q <= a_q[15:0] * b_q[15:0];
    middle_a_q <= a_high * b_low;
    middle_b_q <= b_high * a_low;
    high_q <= a_high * b_high;
    product_q <= {{high_q, low_q}} + {{{{14{{middle[33]}}}}, middle, 16'b0}};
  end
  assign result_o = product_q;
endmodule
)";

// {0}: name, {1}: width, {2}: quotient bits a clock, {3}: steps - 1, {4}: these bits
constexpr std::string_view kDiv = R"(
// Quotient towards 0 (low half of the result) and remainder with the dividend's sign (high half) of
// {1} bits, a division a clock: operands, magnitudes, {2} bits of the quotient in each clock, signs.
// By 0: zero_o with the result's clock, and a result that nobody takes.
module {0} (
    input  wire        clk_i,
    input  wire [{1}-1:0] a_i,
    input  wire [{1}-1:0] b_i,
    output wire [2*{1}-1:0] result_o,
    output wire        zero_o
);
  localparam WIDTH = {1};
  localparam LAST = {3};  // the number of the last step
  reg [WIDTH-1:0] a_q;
  reg [WIDTH-1:0] b_q;
  // Before step s, from bit s * 2 * WIDTH: {{remainder, what is left of the dividend, quotient}}.
  reg [2*WIDTH*(LAST+2)-1:0] rest_q;
  reg [WIDTH*(LAST+2)-1:0] divisor_q;
  reg [LAST+1:0] negative_q;        // the quotient is, in each step
  reg [LAST+1:0] negative_rest_q;   // the remainder is
  reg [LAST+1:0] zero_q;

  always @(posedge clk_i) begin
    a_q <= a_i;
    b_q <= b_i;
    rest_q[0+:2*WIDTH] <= {{{{WIDTH{{1'b0}}}}, a_q[WIDTH-1] ? ~a_q + 1'b1 : a_q}};
    divisor_q[0+:WIDTH] <= b_q[WIDTH-1] ? ~b_q + 1'b1 : b_q;
    negative_q <= {{negative_q[LAST:0], a_q[WIDTH-1] ^ b_q[WIDTH-1]}};
    negative_rest_q <= {{negative_rest_q[LAST:0], a_q[WIDTH-1]}};
    zero_q <= {{zero_q[LAST:0], b_q == {{WIDTH{{1'b0}}}}}};
  end

  genvar s;
  generate
    for (s = 0; s <= LAST; s = s + 1) begin : g_step
      wire [WIDTH-1:0] divisor = divisor_q[s*WIDTH+:WIDTH];
      wire [2*WIDTH-1:0] rest0 = rest_q[s*2*WIDTH+:2*WIDTH];
{4}      always @(posedge clk_i) begin
        rest_q[(s+1)*2*WIDTH+:2*WIDTH] <= rest{2};
        divisor_q[(s+1)*WIDTH+:WIDTH] <= divisor;
      end
    end
  endgenerate

  wire [WIDTH-1:0] quotient = rest_q[(LAST+1)*2*WIDTH+:WIDTH];
  wire [WIDTH-1:0] remainder = rest_q[(LAST+1)*2*WIDTH+WIDTH+:WIDTH];
  reg [WIDTH-1:0] quotient_q;
  reg [WIDTH-1:0] remainder_q;
  reg zero_out_q;
  always @(posedge clk_i) begin
    quotient_q <= negative_q[LAST+1] ? ~quotient + 1'b1 : quotient;
    remainder_q <= negative_rest_q[LAST+1] ? ~remainder + 1'b1 : remainder;
    zero_out_q <= zero_q[LAST+1];
  end
  assign result_o = {{remainder_q, quotient_q}};
  assign zero_o = zero_out_q;
endmodule
)";

// One bit of the quotient, number {0} of a step. {1}: {0} + 1
constexpr std::string_view kDivBit =
    R"(      wire [WIDTH:0] difference{0} = rest{0}[2*WIDTH-1:WIDTH-1] - {{1'b0, divisor}};
      wire [2*WIDTH-1:0] rest{1} = difference{0}[WIDTH]
          ? {{rest{0}[2*WIDTH-2:0], 1'b0}}
          : {{difference{0}[WIDTH-1:0], rest{0}[WIDTH-2:0], 1'b1}};
)";

std::string divider(const std::string& name, int width, int bits) {
  std::string step;
  for (int bit = 0; bit < bits; ++bit) step += fmt::format(fmt::runtime(kDivBit), bit, bit + 1);
  return fmt::format(fmt::runtime(kDiv), name, width, bits, width / bits - 1, step);
}

}  // namespace

std::string unit_module(const Unit& unit, std::string_view prefix) {
  const std::string name = fmt::format("{}_{}", prefix, unit.name);
  switch (unit.op) {
    case core::Op::Mul:
      return fmt::format(fmt::runtime(kMul16), name);
    case core::Op::Mul32:
      return fmt::format(fmt::runtime(kMul32), name);
    case core::Op::Div:
      return divider(name, 16, 2);
    default:
      return divider(name, 32, 1);
  }
}

}  // namespace rung::hardwired

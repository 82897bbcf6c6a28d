// SPDX-License-Identifier: Apache-2.0
// The proof's decoder beside the encoder, and what a term's functions are.
#include "prove/decode.hpp"

#include <gtest/gtest.h>

#include "programs/random_source.hpp"
#include "prove/solver.hpp"

namespace rung::prove {
namespace {

// Random bits: where the compiler's decoder sees an instruction, this one sees the same.
TEST(Decode, AsTheCompilersOwn) {
  RandomSource random(1);
  int seen = 0;
  for (const isa::Config& config : isa::configs()) {
    for (const isa::Mpu mpu : {isa::Mpu::Mpu1, isa::Mpu::Mpu2, isa::Mpu::Mpu3}) {
      for (const isa::OpcodeInfo& info : isa::opcodes()) {
        if (!(mpu == isa::Mpu::Mpu1 ? info.on_mpu1 : info.on_slot)) continue;
        for (int i = 0; i < 50; ++i) {
          isa::SlotInstruction instruction;
          instruction.opcode = info.opcode;
          const int top = isa::slot_bits(mpu, config) - isa::constant::op_bits;
          std::uint64_t bits = random.bits() & ((std::uint64_t{1} << top) - 1);
          bits |= static_cast<std::uint64_t>(info.opcode) << top;
          const auto expected = isa::decode(bits, mpu, config);
          if (!expected) continue;
          ++seen;
          auto found = prove::decode(bits, mpu, config);
          ASSERT_TRUE(found);
          // A row and its lowest bit, which is the flag of others, are read here without asking.
          const bool flagged = info.gate == isa::Gate::Exc || info.opcode == isa::Opcode::Get;
          if (info.format == isa::Format::Bit) {
            if (flagged) found->row = 0;
            if (!flagged) found->always = false;
          }
          EXPECT_EQ(*found, *expected) << info.name;
        }
      }
    }
  }
  EXPECT_GT(seen, 500);
}

std::uint16_t value(const Terms& terms, const Word& word, const Model& model) {
  const std::vector<bool> bits = terms.evaluate(word, model);
  std::uint16_t out = 0;
  for (std::size_t i = 0; i < 16; ++i)
    out = static_cast<std::uint16_t>(out | (bits[i] ? 1U << i : 0U));
  return out;
}

TEST(Terms, AreWhatTheirNamesSay) {
  RandomSource random(2);
  Terms terms;
  const Word a = terms.word_variable();
  const Word b = terms.word_variable();
  const Bit in = terms.variable();
  Bit carry = in;
  Bit borrow = in;
  const Word sum = terms.add(a, b, carry);
  const Word difference = terms.subtract(a, b, borrow);
  const Word rotated = terms.rotate_left(a, b);
  const Bit tests[] = {terms.equal(a, b),
                       terms.less(a, b, in),
                       terms.less_signed(a, b, in),
                       terms.pick(a, b),
                       carry,
                       borrow};
  const std::vector<Word> product = terms.call(Function::Multiply16, {a, b});
  const std::vector<Word> quotient = terms.call(Function::Divide16, {a, b});
  for (int i = 0; i < 2000; ++i) {
    const auto x = static_cast<std::uint16_t>(random.percent(30) ? random.below(3) : random.bits());
    const auto y = static_cast<std::uint16_t>(random.percent(30) ? x : random.bits());
    const int c = random.below(2);
    Model model{{node_of(in), c != 0}};
    for (std::size_t n = 0; n < 16; ++n) {
      model[node_of(a[n])] = (x >> n & 1) != 0;
      model[node_of(b[n])] = (y >> n & 1) != 0;
    }
    const auto sx = static_cast<std::int16_t>(x);
    const auto sy = static_cast<std::int16_t>(y);
    EXPECT_EQ(value(terms, sum, model), static_cast<std::uint16_t>(x + y + c));
    EXPECT_EQ(value(terms, difference, model), static_cast<std::uint16_t>(x - y - c));
    EXPECT_EQ(value(terms, rotated, model),
              static_cast<std::uint16_t>(x << (y & 15) | x >> (16 - (y & 15)) % 32));
    const std::vector<bool> found = terms.evaluate(tests, model);
    EXPECT_EQ(found[0], x == y);
    EXPECT_EQ(found[1], x - c < y);
    EXPECT_EQ(found[2], sx - c < sy);
    EXPECT_EQ(found[3], (x >> (y & 15) & 1) != 0);
    EXPECT_EQ(found[4], x + y + c > 0xffff);
    EXPECT_EQ(found[5], x - y - c < 0);
    EXPECT_EQ(value(terms, product[0], model), static_cast<std::uint16_t>(sx * sy));
    EXPECT_EQ(value(terms, product[1], model), static_cast<std::uint16_t>(sx * sy >> 16));
    if (y == 0) continue;
    EXPECT_EQ(value(terms, quotient[0], model), static_cast<std::uint16_t>(sx / sy));
    EXPECT_EQ(value(terms, quotient[1], model), static_cast<std::uint16_t>(sx % sy));
  }
}

TEST(Solver, ProvesRefutesAndLeavesOpen) {
  Terms terms;
  const Word a = terms.word_variable();
  const Word b = terms.word_variable();
  Bit carry = kFalse;
  const Word sum = terms.add(a, b, carry);
  Bit borrow = kFalse;
  const Word back = terms.subtract(sum, b, borrow);
  Solver solver(terms, 10);
  EXPECT_EQ(solver.ask(terms.differ(back, a), 0).verdict, Verdict::Never);
  // One of 2^32 starts: no simulation meets it.
  const Bit rare =
      terms.both(terms.equal(a, Terms::constant(12345)), terms.equal(b, Terms::constant(54321)));
  const Answer answer = solver.ask(rare, 0);
  EXPECT_EQ(answer.verdict, Verdict::Possible);
  EXPECT_EQ(value(terms, a, answer.model), 12345);
  // Of a product only that equal operands give equal results.
  const Word c = terms.call(Function::Multiply16, {a, Terms::constant(2)})[0];
  Bit none = kFalse;
  EXPECT_EQ(solver.ask(terms.differ(c, terms.add(a, a, none)), 0).verdict, Verdict::Unknown);
  // No time: no answer, and it is said.
  Solver late(terms, -1);
  EXPECT_EQ(late.ask(terms.differ(back, a), 0).verdict, Verdict::Unknown);
}

}  // namespace
}  // namespace rung::prove

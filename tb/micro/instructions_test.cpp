// SPDX-License-Identifier: Apache-2.0
// Each instruction with operands at the corners, against what hdl/controller/micro/README.md says
// of it.
#include <gtest/gtest.h>

#include <array>
#include <functional>

#include "micro_isa.hpp"
#include "sequencer.hpp"

namespace rung::tb {
namespace {

using namespace micro;
using Word = std::uint16_t;

constexpr std::array<Word, 12> kCorners{0,      1,      2,      5,      0x7FF,  0x800,
                                        0x7FFF, 0x8000, 0x8001, 0xFFFE, 0xFFFF, 0x5A5A};
constexpr Word kAt = 17;

Word word(int opcode, int operand) { return static_cast<Word>(opcode | operand); }

void load(std::vector<Word>& code, Word value) {
  code.push_back(word(kLOADI, value & 0x7FF));
  code.push_back(word(kORH, value >> 11));
}

// acc and ram[17] as given, then `middle`; what acc and ram[17] are after it.
std::array<Word, 2> after(Sequencer& sequencer, Word acc, Word ram,
                          const std::vector<Word>& middle) {
  std::vector<Word> code;
  load(code, ram);
  code.push_back(word(kSTORE, kAt));
  load(code, acc);
  code.insert(code.end(), middle.begin(), middle.end());
  code.insert(code.end(), {word(kOUT, 1), word(kLOAD, kAt), word(kOUT, 2)});
  code.push_back(word(kJUMP, static_cast<int>(code.size())));
  const auto got = sequencer.run(code, 2, 2000);
  if (got.size() != 2 || !got[0].write || got[0].address != 1) return {0xBAD, 0xBAD};
  return {got[0].value, got[1].value};
}

struct Case {
  const char* name;
  int code;
  std::function<Word(Word, Word)> acc;  // of acc and the operand
};

TEST(Micro, Arithmetic) {
  Sequencer sequencer;
  const std::array<Case, 6> cases{{
      {"LOAD", kLOAD, [](Word, Word n) { return n; }},
      {"ADD", kADD, [](Word a, Word n) { return static_cast<Word>(a + n); }},
      {"SUB", kSUB, [](Word a, Word n) { return static_cast<Word>(a - n); }},
      {"AND", kAND, [](Word a, Word n) { return static_cast<Word>(a & n); }},
      {"OR", kOR, [](Word a, Word n) { return static_cast<Word>(a | n); }},
      {"XOR", kXOR, [](Word a, Word n) { return static_cast<Word>(a ^ n); }},
  }};
  const std::array<int, 6> immediate{kLOADI, kADDI, kSUBI, kANDI, kORI, kXORI};
  for (const Word acc : kCorners) {
    for (const Word ram : kCorners) {
      for (std::size_t i = 0; i < cases.size(); ++i) {
        const Word number = ram & 0x7FF;
        EXPECT_EQ(after(sequencer, acc, ram, {word(cases[i].code, kAt)}),
                  (std::array<Word, 2>{cases[i].acc(acc, ram), ram}))
            << cases[i].name << ' ' << acc << ' ' << ram;
        EXPECT_EQ(after(sequencer, acc, ram, {word(immediate[i], number)}),
                  (std::array<Word, 2>{cases[i].acc(acc, number), ram}))
            << cases[i].name << "I " << acc << ' ' << number;
      }
      EXPECT_EQ(after(sequencer, acc, ram, {word(kSTORE, kAt)}), (std::array<Word, 2>{acc, acc}));
      EXPECT_EQ(after(sequencer, acc, ram, {word(kCLEAR, kAt)}), (std::array<Word, 2>{acc, 0}));
      const Word more = static_cast<Word>(ram + 1);
      const Word less = static_cast<Word>(ram - 1);
      EXPECT_EQ(after(sequencer, acc, ram, {word(kINC, kAt)}), (std::array<Word, 2>{more, more}));
      EXPECT_EQ(after(sequencer, acc, ram, {word(kDEC, kAt)}), (std::array<Word, 2>{less, less}));
    }
    EXPECT_EQ(after(sequencer, acc, 0, {kNOT})[0], static_cast<Word>(~acc));
    for (int bits = 0; bits < 16; ++bits) {
      EXPECT_EQ(after(sequencer, acc, 0, {word(kSHIFT, bits)})[0], static_cast<Word>(acc << bits));
      EXPECT_EQ(after(sequencer, acc, 0, {word(kSHIFT, 16 + bits)})[0], acc >> bits);
    }
  }
}

// A comparison leaves acc alone; TEST and both branches go by it, over a JUMP, a CALL and a RETURN
// as well, but not behind another instruction or a second time.
TEST(Micro, Comparisons) {
  Sequencer sequencer;
  for (const Word acc : kCorners) {
    for (const Word ram : kCorners) {
      const Word number = ram & 0x7FF;
      const std::array<std::pair<Word, bool>, 4> compares{{{word(kEQ, kAt), acc == ram},
                                                           {word(kLTU, kAt), acc < ram},
                                                           {word(kEQI, number), acc == number},
                                                           {word(kLTUI, number), acc < number}}};
      for (const auto& [compare, truth] : compares) {
        EXPECT_EQ(after(sequencer, acc, ram, {compare})[0], acc);
        EXPECT_EQ(after(sequencer, acc, ram, {compare, kTEST})[0], truth ? 1 : 0);
        // the code begins at 5
        EXPECT_EQ(after(sequencer, acc, ram, {compare, word(kJZ, 8), word(kLOADI, 77)})[0],
                  truth ? 77 : acc);
        EXPECT_EQ(after(sequencer, acc, ram, {compare, word(kJNZ, 8), word(kLOADI, 77)})[0],
                  truth ? acc : 77);
        EXPECT_EQ(after(sequencer, acc, ram,
                        {word(kJUMP, 8), compare, kRETURN, word(kCALL, 6), word(kJUMP, 10),
                         word(kJZ, 12), word(kLOADI, 77)})[0],
                  truth ? 77 : acc);
        EXPECT_EQ(after(sequencer, acc, ram,
                        {compare, word(kSTORE, 3), word(kJZ, 9), word(kLOADI, 77)})[0],
                  acc != 0 ? 77 : 0);
        EXPECT_EQ(
            after(sequencer, acc, ram, {compare, word(kJZ, 7), word(kJZ, 9), word(kLOADI, 77)})[0],
            acc != 0 ? 77 : 0);
      }
    }
    EXPECT_EQ(after(sequencer, acc, 0, {word(kJZ, 7), word(kLOADI, 77)})[0], acc != 0 ? 77 : 0);
    EXPECT_EQ(after(sequencer, acc, 0, {word(kJNZ, 7), word(kLOADI, 77)})[0], acc != 0 ? acc : 77);
  }
}

TEST(Micro, Indexed) {
  Sequencer sequencer;
  // ram[3 + 14], by acc, by x from acc and from RAM; a base before RAM's first word wraps
  EXPECT_EQ(after(sequencer, 14, 999, {word(kLOADX, 3)})[0], 999);
  EXPECT_EQ(after(sequencer, 18, 999, {word(kLOADX, 1023)})[0], 999);
  EXPECT_EQ(after(sequencer, 14, 999, {kSETX, word(kLOADI, 55), word(kSTOREX, 3)})[1], 55);
  EXPECT_EQ(after(sequencer, 18, 999, {kSETX, word(kLOADI, 55), word(kSTOREX, 1023)})[1], 55);
  EXPECT_EQ(after(sequencer, 14, 999,
                  {word(kSTORE, 9), word(kLOADI, 55), word(kINDEX, 9), word(kSTOREX, 3)}),
            (std::array<Word, 2>{55, 55}));
}

TEST(Micro, Bus) {
  Sequencer sequencer;
  const std::vector<Word> code{word(kIN, 1023), kSETX,        kINX,          kOUTX,
                               word(kOUT, 512), word(kIN, 0), word(kOUT, 1), word(kJUMP, 7)};
  const auto got = sequencer.run(code, 6, 2000);
  const Word first = input(0, 1023);
  const Word second = input(1, first);
  const Word third = input(4, 0);
  EXPECT_EQ(got, (std::vector<Access>{{false, 1023, first},
                                      {false, first, second},
                                      {true, first, second},
                                      {true, 512, second},
                                      {false, 0, third},
                                      {true, 1, third}}));
}

// 16 returns are kept, and RAM is 0 after each reset.
TEST(Micro, ReturnsAndReset) {
  Sequencer sequencer;
  std::vector<Word> code;
  code.insert(code.end(), {word(kCALL, 4), word(kLOADI, 99), word(kOUT, 0), word(kJUMP, 3)});
  for (int depth = 1; depth <= 16; ++depth) {
    const int next = 4 * (depth + 1);
    code.insert(code.end(),
                {depth == 16 ? word(kLOAD, 100) : word(kCALL, next),
                 depth == 16 ? word(kADDI, 16) : word(kLOADI, depth), word(kOUT, depth), kRETURN});
  }
  for (int again = 0; again < 2; ++again) {
    const auto got = sequencer.run(code, 17, 4000);
    ASSERT_EQ(got.size(), 17U);
    for (int i = 0; i < 16; ++i) {
      EXPECT_EQ(got[static_cast<std::size_t>(i)],
                (Access{true, static_cast<Word>(16 - i), static_cast<Word>(16 - i)}));
    }
    EXPECT_EQ(got[16], (Access{true, 0, 99}));
  }
}

}  // namespace
}  // namespace rung::tb

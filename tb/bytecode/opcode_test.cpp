// SPDX-License-Identifier: Apache-2.0
// Every instruction of the byte code, by hand.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "bytecode/hand_made.hpp"

namespace rung::tb {
namespace {

using bytecode::Code;
using Bytes = std::vector<std::uint8_t>;

// What one piece of code does with its devices.
struct Step {
  std::string what;
  Bytes code;
  std::vector<int> words;        // before: from word 0 on
  std::vector<int> bits;         // before: from bit 0 on
  std::vector<int> words_after;  // from word 0 on; those beyond stay as they were
  std::vector<int> bits_after;
  bool error = false;
};

constexpr int kLow = 0x5678;

const std::vector<Step> kSteps = {
    {"LD, OUT", op(Code::LD, 0) + op(Code::OUT, 1), {}, {1, 0}, {}, {1, 1}},
    {"OUT of 0", op(Code::LD, 0) + op(Code::OUT, 1), {}, {0, 1}, {}, {0, 0}},
    {"LDI", op(Code::LDI, 0) + op(Code::OUT, 1), {}, {0, 0}, {}, {0, 1}},
    {"AND", op(Code::LD, 0) + op(Code::AND, 1) + op(Code::OUT, 2), {}, {1, 0, 1}, {}, {1, 0, 0}},
    {"ANI", op(Code::LD, 0) + op(Code::ANI, 1) + op(Code::OUT, 2), {}, {1, 0, 0}, {}, {1, 0, 1}},
    {"ANI of 1", op(Code::LD, 0) + op(Code::ANI, 1) + op(Code::OUT, 2), {}, {1, 1}, {}, {1, 1, 0}},
    {"OR", op(Code::LD, 0) + op(Code::OR, 1) + op(Code::OUT, 2), {}, {0, 1}, {}, {0, 1, 1}},
    {"ORI", op(Code::LD, 0) + op(Code::ORI, 1) + op(Code::OUT, 2), {}, {0, 0}, {}, {0, 0, 1}},
    {"ORI of 1",
     op(Code::LD, 0) + op(Code::ORI, 1) + op(Code::OUT, 2),
     {},
     {0, 1, 1},
     {},
     {0, 1, 0}},
    {"BLD, ANB",
     op(Code::LD, 0) + op(Code::BLD, 1) + op(Code::ANB) + op(Code::OUT, 2),
     {},
     {0, 1, 1},
     {},
     {0, 1, 0}},
    {"BLDI, ORB",
     op(Code::LD, 0) + op(Code::BLDI, 1) + op(Code::ORB) + op(Code::OUT, 2),
     {},
     {1, 1},
     {},
     {1, 1, 1}},
    {"POP",
     op(Code::LD, 0) + op(Code::BLD, 1) + op(Code::POP) + op(Code::OUT, 2),
     {},
     {1, 0},
     {},
     {1, 0, 1}},
    {"INV", op(Code::LD, 0) + op(Code::INV) + op(Code::OUT, 1), {}, {0, 0}, {}, {0, 1}},
    {"MPS, MRD, MPP",
     op(Code::LD, 0) + op(Code::MPS) + op(Code::AND, 1) + op(Code::MRD) + op(Code::OUT, 2) +
         op(Code::AND, 1) + op(Code::MPP) + op(Code::OUT, 3),
     {},
     {1, 0},
     {},
     {1, 0, 1, 1}},
    {"SET", op(Code::LD, 0) + op(Code::SET, 1), {}, {1, 0}, {}, {1, 1}},
    {"SET under 0",
     op(Code::LD, 0) + op(Code::SET, 1) + op(Code::SET, 2),
     {},
     {0, 0, 1},
     {},
     {0, 0, 1}},
    {"RST", op(Code::LD, 0) + op(Code::RST, 1), {}, {1, 1}, {}, {1, 0}},
    {"RST under 0",
     op(Code::LD, 0) + op(Code::RST, 1) + op(Code::RST, 2),
     {},
     {0, 1},
     {},
     {0, 1, 0}},
    {"IF under 1", op(Code::LD, 0) + op(Code::IF, 2) + op(Code::ON, 1), {}, {1, 0}, {}, {1, 1}},
    {"IF under 0",
     op(Code::LD, 0) + op(Code::IF, 4) + op(Code::ON, 1) + op(Code::ON, 2) + op(Code::ON, 3),
     {},
     {0, 0},
     {},
     {0, 0, 0, 1}},
    {"ON, OFF", op(Code::ON, 0) + op(Code::OFF, 1), {}, {0, 1}, {}, {1, 0}},
    {"MOV", op(Code::MOV, 0, 1), {-3, 0}, {}, {-3, -3}, {}},
    {"ADD", op(Code::ADD, 0, 1, 2), {32767, 2}, {}, {32767, 2, -32767}, {}},
    {"SUB", op(Code::SUB, 0, 1, 2), {-32768, 1}, {}, {-32768, 1, 32767}, {}},
    {"WAND", op(Code::WAND, 0, 1, 2), {0x0FF0, 0x3C3C}, {}, {0x0FF0, 0x3C3C, 0x0C30}, {}},
    {"WOR", op(Code::WOR, 0, 1, 2), {0x0FF0, 0x3C3C}, {}, {0x0FF0, 0x3C3C, 0x3FFC}, {}},
    {"WXOR", op(Code::WXOR, 0, 1, 2), {0x0FF0, 0x3C3C}, {}, {0x0FF0, 0x3C3C, 0x33CC}, {}},
    {"ROL", op(Code::ROL, 0, 1, 2), {0x1234, 20}, {}, {0x1234, 20, 0x2341}, {}},
    {"ROL by 0", op(Code::ROL, 0, 1, 2), {0x1234, 16}, {}, {0x1234, 16, 0x1234}, {}},
    {"MINU", op(Code::MINU, 0, 1, 2), {-1, 5}, {}, {-1, 5, 5}, {}},
    {"ADD32", op(Code::ADD32, 0, 1, 2, 3, 0, 1), {-1, 1, 1, 2}, {}, {0, 4, 1, 2}, {}},
    {"SUB32", op(Code::SUB32, 0, 1, 2, 3, 4, 5), {0, 1, 1, 0}, {}, {0, 1, 1, 0, -1, 0}, {}},
    {"MUL, one word", op(Code::MUL, 0, 1, 1, 2), {-300, 300}, {}, {-300, 300, -24464, 0}, {}},
    {"MUL, two words", op(Code::MUL, 0, 1, 2, 2, 3), {-300, 300}, {}, {-300, 300, -24464, -2}, {}},
    {"MUL of the least", op(Code::MUL, 0, 0, 2, 2, 3), {-32768}, {}, {-32768, 0, 0, 16384}, {}},
    {"DIV", op(Code::DIV, 0, 1, 2, 2, 3), {-7, 2}, {}, {-7, 2, -3, -1}, {}},
    {"DIV, one word", op(Code::DIV, 0, 1, 1, 2), {7, -2}, {}, {7, -2, -3, 0}, {}},
    {"DIV of the least",
     op(Code::DIV, 0, 1, 2, 2, 3),
     {-32768, -1},
     {},
     {-32768, -1, -32768, 0},
     {}},
    {"DIV by 0",
     op(Code::DIV, 0, 1, 2, 2, 3) + op(Code::ON, 0),
     {9, 0, 5, 6},
     {},
     {9, 0, 5, 6},
     {1},
     true},
    {"MUL32",
     op(Code::MUL32, 0, 1, 2, 3, 4, 4, 5, 6, 7),
     {0, 1, -2, -1},  // 65536 * -2
     {},
     {0, 1, -2, -1, 0, -2, -1, -1},
     {}},
    {"MUL32 of the least, two words",
     op(Code::MUL32, 0, 1, 2, 3, 2, 4, 5),
     {0, -32768, kLow, 0},
     {},
     {0, -32768, kLow, 0, 0, 0, 0},
     {}},
    {"DIV32",
     op(Code::DIV32, 0, 1, 2, 3, 4, 4, 5, 6, 7),
     {-100001 & 0xFFFF, -2, 1000, 0},  // -100001 / 1000
     {},
     {-100001 & 0xFFFF, -2, 1000, 0, -100, -1, -1, -1},
     {}},
    {"DIV32 of the least",
     op(Code::DIV32, 0, 1, 2, 3, 4, 4, 5, 6, 7),
     {0, -32768, -1, -1, 9, 9, 9, 9},
     {},
     {0, -32768, -1, -1, 0, -32768, 0, 0},
     {}},
    {"DIV32 by 0",
     op(Code::DIV32, 0, 1, 2, 3, 1, 4),
     {5, 0, 0, 0, 7},
     {},
     {5, 0, 0, 0, 7},
     {},
     true},
    {"EQ", op(Code::EQ, 0, 1, 0) + op(Code::EQ, 0, 2, 1), {4, 4, 5}, {0, 1}, {}, {1, 0}},
    {"LT", op(Code::LT, 0, 1, 0) + op(Code::LT, 1, 0, 1), {-1, 1}, {0, 1}, {}, {1, 0}},
    {"LT of equal ones", op(Code::LT, 0, 1, 0), {3, 3}, {1}, {}, {0}},
    {"LTU", op(Code::LTU, 0, 1, 0) + op(Code::LTU, 1, 0, 1), {-1, 1}, {1, 0}, {}, {0, 1}},
    {"LT32",
     op(Code::LT32, 0, 1, 2, 3, 0) + op(Code::LT32, 2, 3, 0, 1, 1),
     {-1, -1, 0, 0},
     {0, 1},
     {},
     {1, 0}},
    {"LT32 by the low words", op(Code::LT32, 0, 1, 2, 3, 0), {1, 7, -1, 7}, {0}, {}, {1}},
    {"TB", op(Code::TB, 0, 15, 0) + op(Code::TB, 0, 0, 1), {-32768}, {0, 1}, {}, {1, 0}},
    {"GATHER", op(Code::GATHER, 4, 0, 1, 2, 3, 1), {0, -1}, {1, 0, 1, 1}, {0, 13}, {}},
    {"LOADW", op(Code::LOADW, 0, 2, 3, 1), {2, 0, 10, 11, 12, 13}, {}, {2, 12}, {}},
    {"LOADW outside", op(Code::LOADW, 0, 2, 3, 1), {3, 9, 10, 11, 12, 13}, {}, {3, 0}, {}},
    {"LOADW below", op(Code::LOADW, 0, 2, 3, 1), {-1, 9, 10, 11, 12, 13}, {}, {-1, 0}, {}},
    {"STOREW", op(Code::STOREW, 0, 2, 3, 1), {1, 9}, {}, {1, 9, 0, 9, 0}, {}},
    {"STOREW outside", op(Code::STOREW, 0, 2, 3, 1), {3, 9}, {}, {3, 9, 0, 0, 0, 0}, {}},
    {"LOADB", op(Code::LOADB, 0, 1, 3, 0), {2}, {0, 0, 0, 1}, {}, {1}},
    {"LOADB outside", op(Code::LOADB, 0, 1, 3, 0), {3}, {1, 1, 1, 1, 1}, {}, {0}},
    {"SETB", op(Code::SETB, 0, 1, 3), {1}, {}, {}, {0, 0, 1, 0}},
    {"SETB outside", op(Code::SETB, 0, 1, 3), {3}, {}, {}, {0, 0, 0, 0, 0}},
    {"RSTB", op(Code::RSTB, 0, 1, 3), {1}, {1, 1, 1, 1}, {}, {1, 1, 0, 1}},
    {"a number of two bytes", op(Code::LD, 0x80, 1) + op(Code::OUT, 0x80, 0), {}, {0, 1}, {}, {1}},
};

// The instructions of a piece of code, by the operands that they have.
std::vector<Code> instructions_of(const Bytes& code) {
  std::vector<Code> found;
  for (std::size_t at = 0; at < code.size();) {
    found.push_back(static_cast<Code>(code[at++]));
    int times = 1;
    for (const char kind : bytecode::info(found.back()).operands) {
      if (kind == 'c') {
        times = code[at++];
        continue;
      }
      const int numbers = kind == 'a' || kind == 'A' || kind == 't' ? 2 : times;
      for (int i = 0; i < numbers; ++i) at += code[at] >= 0x80 ? 2 : 1;
      times = 1;
    }
  }
  return found;
}

TEST(Opcode, EachDoesWhatThePageSays) {
  std::set<Code> seen = {Code::END};
  for (const Step& step : kSteps) {
    SCOPED_TRACE(step.what);
    HandMade file;
    file.code = step.code + op(Code::END);
    Loaded loaded(file.bytes());
    ASSERT_EQ(loaded.error(), RUNG_VM_OK) << rung_vm_error_text(loaded.error());
    rung_vm* vm = &loaded.vm();
    for (std::size_t i = 0; i < step.words.size(); ++i) {
      rung_vm_set_word(vm, static_cast<std::uint16_t>(i), static_cast<std::int16_t>(step.words[i]));
    }
    for (std::size_t i = 0; i < step.bits.size(); ++i) {
      rung_vm_set_bit(vm, static_cast<std::uint16_t>(i), static_cast<std::uint8_t>(step.bits[i]));
    }
    rung_vm_scan(vm, 0);
    for (std::size_t i = 0; i < 16; ++i) {
      int expected = i < step.words.size() ? step.words[i] : 0;
      if (i < step.words_after.size()) expected = step.words_after[i];
      EXPECT_EQ(rung_vm_word(vm, static_cast<std::uint16_t>(i)),
                static_cast<std::int16_t>(expected))
          << "word " << i;
    }
    for (std::size_t i = 0; i < 8; ++i) {
      int expected = i < step.bits.size() ? step.bits[i] : 0;
      if (i < step.bits_after.size()) expected = step.bits_after[i];
      EXPECT_EQ(rung_vm_bit(vm, static_cast<std::uint16_t>(i)), expected) << "bit " << i;
    }
    EXPECT_EQ(vm->error != 0, step.error);
    for (const Code code : instructions_of(step.code)) seen.insert(code);
  }
  EXPECT_EQ(seen.size(), bytecode::codes().size());
}

}  // namespace
}  // namespace rung::tb

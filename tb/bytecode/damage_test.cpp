// SPDX-License-Identifier: Apache-2.0
// What the interpreter refuses, and that nothing it accepts does any harm.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "bytecode/hand_made.hpp"
#include "bytecode/vm_engine.hpp"
#include "melsec/list.hpp"
#include "programs/random_source.hpp"

namespace rung::tb {
namespace {

using bytecode::Code;

// A program with something in every section but ports: constants, ticks, a clock, names; blocks,
// branches, a guard, an indexed word.
std::string file_of_a_list() {
  Diagnostics diagnostics;
  const auto source = decode_text(
      "LD X0\nOR X1\nLD M8013\nORI X2\nANB\nMPS\nAND X3\nOUT Y0\nMPP\nOUT T0 K25\n"
      "LD X4\nADD D0 K300 D1\nMOV D0Z0 D2\nDIV D1 K7 D4\nEND\n",
      "damage.il", diagnostics);
  const auto program = parse_list(*source, Dialect::Fx, diagnostics);
  EXPECT_TRUE(program);
  return bytecode_of(*program);
}

rung_vm_error load(const std::string& file) { return Loaded(file).error(); }

TEST(Damage, AnyBitThatFlipsIsRefused) {
  const std::string file = file_of_a_list();
  ASSERT_EQ(load(file), RUNG_VM_OK);
  for (std::size_t at = 0; at < file.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = file;
      damaged[at] = static_cast<char>(damaged[at] ^ 1 << bit);
      EXPECT_NE(load(damaged), RUNG_VM_OK) << "byte " << at << ", bit " << bit;
    }
  }
}

TEST(Damage, AnyOtherLengthIsRefused) {
  const std::string file = file_of_a_list();
  for (std::size_t size = 0; size < file.size(); ++size) {
    EXPECT_NE(load(file.substr(0, size)), RUNG_VM_OK) << size;
    EXPECT_NE(load(with_crc(file.substr(0, size))), RUNG_VM_OK) << size;
  }
  EXPECT_EQ(load(file + '\0'), RUNG_VM_BAD_SIZE);
  EXPECT_EQ(load(with_crc(file + '\0')), RUNG_VM_BAD_SIZE);
}

// Files whose check sum is right, but that a tool other than ours may have made: accepted or not,
// nothing may go out of bounds. The sanitizers watch.
TEST(Damage, WhateverIsAcceptedRunsWithoutHarm) {
  const std::string file = file_of_a_list();
  RandomSource random(8);
  int accepted = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string other = file;
    for (int k = random.below(3); k >= 0; --k) {
      other[static_cast<std::size_t>(random.below(static_cast<int>(file.size()) - 12)) + 12] =
          static_cast<char>(random.bits());
    }
    Loaded loaded(with_crc(other));
    if (loaded.error() != RUNG_VM_OK) continue;
    ++accepted;
    for (int scan = 0; scan < 3; ++scan) rung_vm_scan(&loaded.vm(), 10000);
  }
  EXPECT_GT(accepted, 1000);
}

TEST(Damage, OtherVersionsAreRefused) {
  HandMade file;
  file.code = op(Code::END);
  EXPECT_EQ(load(file.bytes()), RUNG_VM_OK);
  file.minor = RUNG_FORMAT_MINOR + 1;
  EXPECT_EQ(load(file.bytes()), RUNG_VM_BAD_VERSION);
  file.minor = RUNG_FORMAT_MINOR;
  for (const int major : {0, RUNG_FORMAT_MAJOR + 1}) {
    file.major = major;
    EXPECT_EQ(load(file.bytes()), RUNG_VM_BAD_VERSION);
  }
}

struct Wrong {
  const char* what;
  std::vector<std::uint8_t> code;
  rung_vm_error error;
};

// The devices of HandMade: bits 0 to 7, words 0 to 15, a constant at 16; two deep.
const std::vector<Wrong> kWrong = {
    {"nothing", {}, RUNG_VM_BAD_OPCODE},
    {"no END", op(Code::LD, 0), RUNG_VM_BAD_OPCODE},
    {"something behind END", op(Code::END) + op(Code::END), RUNG_VM_BAD_OPCODE},
    {"an unknown opcode", op(static_cast<Code>(47)) + op(Code::END), RUNG_VM_BAD_OPCODE},
    {"a bit too high", op(Code::LD, 8) + op(Code::END), RUNG_VM_BAD_OPERAND},
    {"a word too high", op(Code::MOV, 17, 0) + op(Code::END), RUNG_VM_BAD_OPERAND},
    {"half an operand", op(Code::LD, 0x80), RUNG_VM_BAD_OPERAND},
    {"a constant as target", op(Code::MOV, 0, 16) + op(Code::END), RUNG_VM_BAD_OPERAND},
    {"a constant in a window", op(Code::STOREW, 0, 14, 3, 0) + op(Code::END), RUNG_VM_BAD_OPERAND},
    {"a window beyond the constants", op(Code::LOADW, 0, 14, 4, 0) + op(Code::END),
     RUNG_VM_BAD_OPERAND},
    {"a window that ends too high", op(Code::SETB, 0, 6, 3) + op(Code::END), RUNG_VM_BAD_OPERAND},
    {"a window of nothing", op(Code::SETB, 0, 0, 0) + op(Code::END), RUNG_VM_BAD_OPERAND},
    {"a bit number of 16", op(Code::TB, 0, 16, 0) + op(Code::END), RUNG_VM_BAD_OPERAND},
    {"no bits to gather", op(Code::GATHER, 0, 0) + op(Code::END), RUNG_VM_BAD_OPERAND},
    {"17 bits to gather",
     op(Code::GATHER, 17, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0) + op(Code::END),
     RUNG_VM_BAD_OPERAND},
    {"three words of a product", op(Code::MUL, 0, 1, 3, 2, 3, 4) + op(Code::END),
     RUNG_VM_BAD_OPERAND},
    {"five words of a product", op(Code::MUL32, 0, 1, 2, 3, 5, 4, 5, 6, 7, 8) + op(Code::END),
     RUNG_VM_BAD_OPERAND},
    {"IF over nothing", op(Code::IF, 0) + op(Code::END), RUNG_VM_BAD_OPERAND},
    {"IF over END", op(Code::IF, 3) + op(Code::ON, 0) + op(Code::END), RUNG_VM_BAD_OPERAND},
    {"IF into an instruction", op(Code::IF, 1) + op(Code::ON, 0) + op(Code::END),
     RUNG_VM_BAD_OPERAND},
    {"IF over a contact", op(Code::IF, 2) + op(Code::LD, 0) + op(Code::END), RUNG_VM_BAD_OPERAND},
    {"IF in IF", op(Code::IF, 4) + op(Code::IF, 2) + op(Code::ON, 0) + op(Code::END),
     RUNG_VM_BAD_OPERAND},
    {"blocks too deep", op(Code::BLD, 0) + op(Code::BLDI, 0) + op(Code::BLD, 0) + op(Code::END),
     RUNG_VM_BAD_STACK},
    {"ANB without a block", op(Code::LD, 0) + op(Code::ANB) + op(Code::END), RUNG_VM_BAD_STACK},
    {"branches too deep", op(Code::MPS) + op(Code::MPS) + op(Code::MPS) + op(Code::END),
     RUNG_VM_BAD_STACK},
    {"MRD without a branch", op(Code::MRD) + op(Code::END), RUNG_VM_BAD_STACK},
    {"MPP without a branch", op(Code::MPS) + op(Code::MPP) + op(Code::MPP) + op(Code::END),
     RUNG_VM_BAD_STACK},
};

TEST(Damage, WrongCodeIsRefusedWithItsReason) {
  for (const Wrong& wrong : kWrong) {
    HandMade file;
    file.constants = {5};
    file.code = wrong.code;
    EXPECT_EQ(load(file.bytes()), wrong.error) << wrong.what;
  }
}

TEST(Damage, WrongSectionsAreRefused) {
  const auto with = [](auto change) {
    HandMade file;
    file.code = op(Code::END);
    change(file);
    return load(file.bytes());
  };
  EXPECT_EQ(with([](HandMade& f) { f.ticks = {15, 0, 1, 0, 0, 0}; }), RUNG_VM_OK);
  EXPECT_EQ(with([](HandMade& f) { f.ticks = {16, 0, 1, 0, 0, 0}; }), RUNG_VM_BAD_HEADER);
  EXPECT_EQ(with([](HandMade& f) { f.ticks = {15, 0, 0, 0, 0, 0}; }), RUNG_VM_BAD_HEADER);
  EXPECT_EQ(with([](HandMade& f) { f.ticks = {15, 0, 0, 0, 0, 0x80}; }), RUNG_VM_BAD_HEADER);
  EXPECT_EQ(with([](HandMade& f) { f.driven = {7, 0, 4, 1, 0, 0, 0}; }), RUNG_VM_OK);
  EXPECT_EQ(with([](HandMade& f) { f.driven = {8, 0, 4, 1, 0, 0, 0}; }), RUNG_VM_BAD_HEADER);
  EXPECT_EQ(with([](HandMade& f) { f.driven = {7, 0, 5, 1, 0, 0, 0}; }), RUNG_VM_BAD_HEADER);
  EXPECT_EQ(with([](HandMade& f) { f.driven = {7, 0, 4, 0, 0, 0, 0}; }), RUNG_VM_BAD_HEADER);
  EXPECT_EQ(with([](HandMade& f) { f.driven = {7, 0, 0, 1, 0, 0, 0}; }), RUNG_VM_BAD_HEADER);
  EXPECT_EQ(with([](HandMade& f) { f.ports = {1, 0, 15, 0}; }), RUNG_VM_OK);
  EXPECT_EQ(with([](HandMade& f) { f.ports = {0, 0, 15, 0}; }), RUNG_VM_BAD_HEADER);
  EXPECT_EQ(with([](HandMade& f) { f.ports = {2, 0, 0, 0}; }), RUNG_VM_BAD_HEADER);
  const auto name = [&](std::vector<std::uint8_t> bytes) {
    return with([&](HandMade& f) {
      f.names = std::move(bytes);
      f.names_count = 1;
    });
  };
  EXPECT_EQ(name({2, 7, 0, 1, 0, 'X'}), RUNG_VM_OK);
  EXPECT_EQ(name({2, 8, 0, 1, 0, 'X'}), RUNG_VM_BAD_HEADER);
  EXPECT_EQ(name({1, 16, 0, 1, 0, 'D'}), RUNG_VM_BAD_HEADER);
  EXPECT_EQ(name({2, 7, 0, 0, 0}), RUNG_VM_BAD_HEADER);
  EXPECT_EQ(name({2, 7, 0, 2, 0, 'X'}), RUNG_VM_BAD_HEADER);
  EXPECT_EQ(name({8, 7, 0, 1, 0, 'X'}), RUNG_VM_BAD_HEADER);
  EXPECT_EQ(name({2, 7, 0, 1, 0, 'X', 'X'}), RUNG_VM_BAD_HEADER);
  EXPECT_EQ(with([](HandMade& f) { f.bits = 0x8001; }), RUNG_VM_BAD_HEADER);
  EXPECT_EQ(with([](HandMade& f) { f.words = 0x8001; }), RUNG_VM_BAD_HEADER);
}

TEST(Damage, LessMemoryThanNeededIsRefused) {
  Loaded loaded(file_of_a_list());
  ASSERT_EQ(loaded.error(), RUNG_VM_OK);
  const std::string file = file_of_a_list();
  const auto* image = reinterpret_cast<const std::uint8_t*>(file.data());
  for (int which = 0; which < 3; ++which) {
    rung_vm_memory memory = loaded.needs();
    --(which == 0 ? memory.times_count : which == 1 ? memory.words_count : memory.bits_count);
    rung_vm vm;
    EXPECT_EQ(rung_vm_load(&vm, image, file.size(), &memory), RUNG_VM_SMALL_MEMORY) << which;
  }
}

TEST(Damage, EveryErrorHasItsText) {
  std::set<std::string> texts;
  for (int error = RUNG_VM_OK; error < RUNG_VM_ERRORS; ++error) {
    texts.insert(rung_vm_error_text(static_cast<rung_vm_error>(error)));
  }
  EXPECT_EQ(texts.size(), static_cast<std::size_t>(RUNG_VM_ERRORS));
  EXPECT_EQ(texts.count(rung_vm_error_text(RUNG_VM_ERRORS)), 0U);
}

}  // namespace
}  // namespace rung::tb

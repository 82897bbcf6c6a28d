// SPDX-License-Identifier: Apache-2.0
// Programs of the micro-sequencer's language, compiled natively and by scripts/micro: the same accesses to the bus
// in the same order. seed_<n> is a random one: generate.py n 1 DIR writes it and its listing.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "sequencer.hpp"

namespace rung::tb {
namespace {

using u16 = unsigned short;

constexpr std::size_t kMost = 600;  // accesses compared
constexpr int kPolls = 4;

struct Enough {};

struct Bus {
  std::vector<Access> accesses;
  void add(const Access& access) {
    accesses.push_back(access);
    if (accesses.size() == kMost) throw Enough{};
  }
  u16 io_read(u16 address) {
    const u16 value = input(accesses.size(), address);
    add({false, address, value});
    return value;
  }
  void io_write(u16 address, u16 value) { add({true, address, value}); }
};

#include "micro_programs.inc"

template <typename Program>
std::vector<Access> run() {
  Program program{};
  try {
    program.firmware_reset();
    for (int i = 0; i < kPolls; ++i) program.firmware_poll();
  } catch (const Enough&) {
  }
  return program.accesses;
}

struct Compiled {
  const char* name;
  std::vector<std::uint16_t> words;
  std::vector<Access> (*native)();
};

const std::vector<Compiled>& programs() {
  static const std::vector<Compiled> all{
#include "micro_table.inc"
  };
  return all;
}

TEST(Micro, Programs) {
  Sequencer sequencer;
  std::size_t compared = 0;
  for (const Compiled& program : programs()) {
    const std::vector<Access> expected = program.native();
    const std::vector<Access> actual = sequencer.run(program.words, expected.size(), 4000000);
    compared += expected.size();
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_LT(i, actual.size()) << program.name << ": access " << i << " does not come";
      ASSERT_EQ(actual[i], expected[i])
          << fmt::format("{}: access {}: {} {:#x} {:#x}, natively {} {:#x} {:#x}", program.name, i,
                         actual[i].write ? "write" : "read", actual[i].address, actual[i].value,
                         expected[i].write ? "write" : "read", expected[i].address, expected[i].value);
    }
  }
  EXPECT_GT(compared, programs().size() * 20) << "the programs do something";
}

}  // namespace
}  // namespace rung::tb

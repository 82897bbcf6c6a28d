// SPDX-License-Identifier: Apache-2.0
// Three units in a chain, Verilated, whose lines carry garbage between and over good frames.
#include <gtest/gtest.h>

#include "Vlink.h"
#include "controller/rtu_bus.hpp"
#include "fuzz/hardware_readers.hpp"
#include "fuzz/input.hpp"
#include "fuzz/require.hpp"
#include "link/link_chain.hpp"

namespace rung::fuzz {
namespace {

constexpr int kUnits = 3;
constexpr std::uint64_t kBit = 6;  // clocks, the model's
constexpr int kMostOps = 30;
constexpr std::uint64_t kClocksPerMs = 500;
constexpr int kTimeoutMs = 100;
// Neighbours have begun anew by then.
constexpr std::uint64_t kSettles = 20'000;

// Levels of a line, a clock each, with these bytes on it; idle around them for as long as ends a
// frame.
std::deque<bool> levels_of(const std::vector<std::uint8_t>& bytes) {
  std::deque<bool> levels;
  const auto put = [&](bool level, std::size_t bits) {
    levels.insert(levels.end(), bits * kBit, level);
  };
  put(true, flow::link_gap + 2);
  for (const std::uint8_t byte : bytes) {
    put(false, 1);
    for (int i = 0; i < 8; ++i) put((byte >> i & 1) != 0, 1);
    put(true, 1);
  }
  put(true, flow::link_gap + 2);
  return levels;
}

}  // namespace

// What the world of the bench says holds: each command is executed at most once, by the unit that
// it is for, with its own words; each request ends once, with an answer that is its own. And when
// the lines are quiet again, a request in either direction is done.
void read_link(std::string_view bytes) {
  Input input(bytes);
  tb::World world(1);
  tb::LinkChain<Vlink> chain(world, {kUnits, static_cast<int>(kBit), kClocksPerMs, kTimeoutMs});
  for (int ops = 0; !input.empty() && ops < kMostOps; ++ops) {
    const unsigned what = input.below(8);
    const unsigned place = input.below(2 * (kUnits - 1));
    tb::Line& line = place % 2 == 0 ? chain.down[place / 2] : chain.up[place / 2];
    switch (what) {
      case 0:
      case 1:
      case 2: {
        const int from = 1 + static_cast<int>(input.below(kUnits));
        const int to = 1 + (from + static_cast<int>(input.below(kUnits - 1))) % kUnits;
        chain.unit(from).ask(to, what == 0, 1 + static_cast<int>(input.below(32)));
        break;
      }
      case 3: {  // a frame of garbage
        std::vector<std::uint8_t> garbage = input.bytes(input.below(80));
        // Nobody can tell one with a right CRC from a good frame.
        if (!garbage.empty() && tb::modbus_crc(garbage) == 0) garbage.back() ^= 1;
        line.play(levels_of(garbage));
        break;
      }
      case 4:
        line.disturb(tb::Line::Fault::invert, world.now + 1 + input.below(2 * kBit));
        break;
      case 5:
        line.disturb(input.below(2) != 0 ? tb::Line::Fault::low : tb::Line::Fault::high,
                     world.now + kBit * (1 + input.below(300)));
        break;
      case 6: {
        auto& unit = chain.unit(1 + static_cast<int>(input.below(kUnits)));
        unit.hold(!unit.held());
        chain.steps(20);  // a reset that no clock sees is none
        break;
      }
      default:
        break;
    }
    chain.steps(input.below(1500));
  }
  for (int n = 1; n <= kUnits; ++n) chain.unit(n).hold(false);
  while (chain.playing()) chain.steps(100);
  chain.finish(4 * kTimeoutMs * kClocksPerMs);
  chain.steps(kSettles);
  for (const bool write : {false, true}) {
    chain.alone(1, kUnits, write, 5);
    chain.alone(kUnits, 1, write, 32);
  }
  require(!testing::Test::HasFailure(), "the bench has found a fault");
}

}  // namespace rung::fuzz

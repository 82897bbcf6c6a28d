// SPDX-License-Identifier: Apache-2.0
// What was in a processor in each clock of a scan.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace rung::view {

// An instruction of the code.
struct RecordedCode {
  std::string text;
  int origin = -1;  // the source's instruction, -1: none
  int row = -1;     // of the LUT, if it looks one up
};

// An operand that did not come from the memory: a, b, c of a look-up, 1 and 2 of a word
// instruction; written by the step so many steps before.
struct Forwarded {
  char operand = 'a';
  int distance = 1;
};

// One slot in EX.
struct RecordedSlot {
  bool completes = false;  // an instruction's last pass; else the rest means nothing
  bool exc_before = false, exc_after = false;
  std::uint8_t function = 0;  // the LUT's row
  std::uint8_t operands = 0;  // a, b, c, of which c is the lowest; on MPU1 c is the device
  std::uint16_t s1 = 0, s2 = 0;
  std::vector<Forwarded> forwarded;
  std::string written;  // the device's name; empty: nothing is written
  std::int16_t value = 0;
};

enum class Stage : std::uint8_t { If1, If2, If3, Id1, Id2, Id3, Ex };
inline constexpr int kStages = 7;

struct RecordedClock {
  std::array<int, kStages> steps{};  // the step in each stage, -1: none
  std::vector<RecordedSlot> slots;
};

struct RecordedProcessor {
  int mpu = 0;
  std::vector<std::vector<RecordedCode>> code;  // [step][slot]
  std::vector<RecordedClock> clocks;            // of the last scan
};

}  // namespace rung::view

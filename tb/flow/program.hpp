// SPDX-License-Identifier: Apache-2.0
// A program of flow tasks as tests write it: routines of moves, steps, transfers, tasks, boards.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "isa/isa.hpp"
#include "rung_flow.hpp"

namespace rung::tb::flow {

// Word devices of the tests' programs. Routines write what the test shall see to kLog.
inline constexpr int kNextWord = 1;
inline constexpr int kTaskWord = 2;
inline constexpr int kStatusWord = 3;
inline constexpr int kLog = 4;
inline constexpr int kFirstData = 16;    // words that transfers carry, to 127
inline constexpr int kFirstPoint = 128;  // word of point 0 of the device map
inline constexpr int kWords = 256;
inline constexpr int kPoints = 64;
inline constexpr std::uint16_t kEnds = 0xffff;
inline constexpr int kUnit = 5;  // this one
inline constexpr int kScratchBlock = rung::flow::flow_pc_block + 1;

// Point -> word; every seventh is one that no program has.
inline bool mapped(int point) { return point % 7 != 3; }

// to <- constant, or word `from`
struct Move {
  int to = 0;
  bool constant = true;
  std::uint16_t value = 0;
  int from = 0;
};
inline Move set(int to, int value) { return {to, true, static_cast<std::uint16_t>(value), 0}; }
inline Move copy(int to, int from) { return {to, false, 0, from}; }
inline Move start(int task) { return set(kTaskWord, 256 + task); }
inline Move stop(int task) { return set(kTaskWord, task); }
inline Move next(int step) { return set(kNextWord, step); }
inline Move ends() { return set(kNextWord, kEnds); }
inline Move log(int value) { return set(kLog, value); }

struct Transfer {
  int unit = kUnit;
  int board = 0;
  int first = 0;
  int count = 1;
  int head = kFirstData;
};

struct Step {
  std::vector<Move> routine;
  int before = 0;  // transfers, 0: none
  int after = 0;
};

struct Task {
  int first = 0;
  bool starts = true;
};

struct Program {
  std::vector<Move> ladder;
  std::vector<Step> steps;
  std::vector<Transfer> transfers{Transfer{}};  // number 0 is none
  std::vector<Task> tasks;
  std::array<int, rung::flow::flow_boards> boards{};
  bool in_place = false;
  bool packed = false;  // moves that may stand beside each other do

  int add(const Transfer& transfer) {
    transfers.push_back(transfer);
    return static_cast<int>(transfers.size()) - 1;
  }
};

inline constexpr int kThere = 1 << rung::flow::board_bit_there;
inline constexpr int kOverLink = 1 << rung::flow::board_bit_over_link;
inline constexpr int kExclusive = 1 << rung::flow::board_bit_exclusive;
inline constexpr int kPanel = 1 << rung::flow::board_bit_panel;

// Boards that are there in every test.
enum Board { kMemory = 0, kSlow = 1, kAlone = 2, kAloneMemory = 3, kInPlace = 4, kNobody = 9 };
inline std::array<int, rung::flow::flow_boards> usual_boards() {
  std::array<int, rung::flow::flow_boards> boards{};
  boards[kMemory] = kThere;
  boards[kSlow] = kThere | kOverLink | kPanel;
  boards[kAlone] = kThere | kOverLink | kPanel | kExclusive;
  boards[kAloneMemory] = kThere | kExclusive;
  boards[kInPlace] = kThere | kPanel;
  return boards;
}

Program random_program(std::mt19937& random, int tasks, bool in_place);

}  // namespace rung::tb::flow

// SPDX-License-Identifier: Apache-2.0
// What an image of a program with flow tasks has beside its ladder: where the steps' routines stand
// behind the ladder's, and the tables of the task hardware (hdl/isa/flow.toml).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "source/diagnostics.hpp"

namespace rung::image {

struct FlowStep {
  std::string name;
  int task = 0;
  // Its routine in the instruction memory: from `entry` to before `end`.
  int entry = 0;
  int end = 0;
  // Numbers of the transfers before and behind it; 0: none.
  int read = 0;
  int write = 0;
  std::int64_t clocks = 0;  // of its routine, from start to done
  std::vector<int> next;    // steps it may lead to
  bool added = false;       // by a wait
  SourcePosition position;
  std::string text;  // of its head
};

// `count` variables of a board from `first` on, and as many words from `address` on.
struct FlowTransfer {
  int board = 0;  // index into FlowImage::boards
  int first = 0;
  int count = 0;
  int address = 0;
};

struct FlowBoard {
  std::string name;
  int unit = 1;
  int number = 0;
  bool over_link = false;
  bool exclusive = false;
  bool panel = false;
};

struct FlowTask {
  std::string name;
  int first = 0;  // step
  bool starts = false;
};

struct FlowImage {
  int unit = 1;
  // Word devices through which steps and the task hardware speak.
  int next_word = 0;
  int task_word = 0;
  int status_word = 0;
  int ladder_steps = 0;  // length of the ladder's routine, which begins at step 0
  std::vector<FlowBoard> boards;
  std::vector<FlowTransfer> transfers;  // number 1 first
  std::vector<FlowTask> tasks;
  std::vector<FlowStep> steps;  // one task after the other

  // Of number `transfer`, which is not 0.
  const FlowTransfer& transfer(int transfer) const {
    return transfers.at(static_cast<std::size_t>(transfer) - 1);
  }
  const FlowBoard& board_of(const FlowTransfer& transfer) const {
    return boards.at(static_cast<std::size_t>(transfer.board));
  }
  // What the hardware of this unit is told of a board of its own, see [[board_bit]].
  static int bits(const FlowBoard& board);
  // A task that wants its data gives the processor up.
  bool waits(const FlowTransfer& transfer) const {
    const FlowBoard& board = board_of(transfer);
    return board.over_link || board.panel || board.unit != unit;
  }
};

}  // namespace rung::image

// SPDX-License-Identifier: Apache-2.0
#include "flow/program.hpp"

namespace rung::tb::flow {

Program random_program(std::mt19937& random, int tasks, bool in_place) {
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  Program program;
  program.boards = usual_boards();
  program.in_place = in_place;
  program.packed = true;
  const int transfers = 1 + below(12);
  for (int i = 0; i < transfers; ++i) {
    Transfer t;
    constexpr int kUsual[] = {kMemory, kSlow, kAlone, kAloneMemory, kSlow, kInPlace, kNobody};
    t.board = kUsual[below(7)];
    t.count = below(12) == 0 ? rung::flow::flow_block_words : 1 + below(5);
    t.first = below(kPoints + 1 - t.count) + (below(15) == 0 ? 20 : 0);
    t.head = kFirstData + below(kFirstPoint - kFirstData - t.count + 1);
    if (below(4) == 0) t.unit = 1 + below(15);
    if (below(40) == 0) t.unit = below(2) * 200;
    if (below(40) == 0) t.board = 17;
    program.add(t);
  }
  const int steps = 1 + below(24);
  for (int n = 0; n < steps; ++n) {
    Step step;
    step.routine.push_back(log(n));
    step.routine.push_back(copy(kLog, kStatusWord));
    for (int i = below(4); i > 0; --i) {
      const int data = kFirstData + below(kWords - kFirstData);
      switch (below(8)) {
        case 0:
          step.routine.push_back(set(data, below(65536)));
          break;
        case 1:
          step.routine.push_back(copy(kLog, data));
          break;
        case 2:
          step.routine.push_back(copy(kFirstData + below(kWords - kFirstData), data));
          break;
        case 3:
          step.routine.push_back(start(below(tasks)));
          break;
        case 4:
          step.routine.push_back(stop(below(tasks)));
          break;
        case 5:
          if (below(3) == 0) step.routine.push_back(ends());
          break;
        default:
          step.routine.push_back(next(below(steps)));
          break;
      }
    }
    if (below(3) == 0) step.before = 1 + below(transfers);
    if (below(3) == 0) step.after = 1 + below(transfers);
    program.steps.push_back(step);
  }
  for (int n = 0; n < tasks; ++n) program.tasks.push_back({below(steps), below(3) != 0});
  for (int i = below(6); i > 0; --i) {
    program.ladder.push_back(set(kFirstData + below(kWords - kFirstData), below(65536)));
  }
  return program;
}

}  // namespace rung::tb::flow

// SPDX-License-Identifier: Apache-2.0
// Can a term be 1? Asked of the simulation first, then of CaDiCaL, which gets the smallest part of
// the graph that answers.
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "prove/terms.hpp"

namespace rung::prove {

enum class Verdict : std::uint8_t { Never, Possible, Unknown };

struct Answer {
  Verdict verdict = Verdict::Never;
  Model model;  // Possible: values of the variables with which the term is 1
};

struct Effort {
  std::int64_t structure = 0;   // questions that equal structure answered
  std::int64_t simulation = 0;  // that a random start answered
  std::int64_t solver = 0;      // that went to CaDiCaL
};

class Solver {
 public:
  // After `seconds` every question is Unknown.
  Solver(const Terms& terms, double seconds);

  // A value that has been proven equal on both sides: a proof may take it as free.
  void cut(Bit bit);
  void cut(const Word& word);

  // Whether `bit` can be 1. What has been cut is taken as free at first; when that does not
  // suffice, only what is older than the node `since`, and in the end nothing.
  Answer ask(Bit bit, NodeId since);

  // The same with little effort: what has been cut and is older than the node `free` is taken as
  // free. Unknown where that does not do.
  Answer ask_quickly(Bit bit, NodeId free);

  const Effort& effort() const { return effort_; }

 private:
  // 10 if it can be 1 (the model is then filled), 20 if not, 0: no answer within the limits.
  int solve(Bit bit, NodeId free, int conflicts, Model& model, bool& used_cuts);
  bool out_of_time() const { return std::chrono::steady_clock::now() > end_; }

  const Terms& terms_;
  std::chrono::steady_clock::time_point end_;
  std::vector<bool> cut_;
  Effort effort_;
};

}  // namespace rung::prove

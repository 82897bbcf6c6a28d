// SPDX-License-Identifier: Apache-2.0
// Values of the image in the program's place: where a value that a step has computed is proven to
// be one that the program has computed too, the program's is taken from there on. So what is left
// to prove of a later step is about that step alone.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "prove/solver.hpp"
#include "prove/terms.hpp"

namespace rung::prove {

class Sweep {
 public:
  // What the graph holds now is the program's.
  Sweep(Terms& terms, Solver& solver);

  // A value of the program that is proven to be this one; `bit` itself if none is found.
  Bit represent(Bit bit);
  Word represent(const Word& word);

 private:
  // Whether one was found; `again`: those to be tried are others now.
  bool find(NodeId node, bool& again);
  // The newest of the program's values that are near below it.
  NodeId newest_of(NodeId node) const;
  void sort();
  // The same for a value and its inverse.
  std::uint64_t key_of(Bit bit) const;

  Terms& terms_;
  Solver& solver_;
  NodeId end_;  // of the program's nodes
  std::unordered_map<std::uint64_t, std::vector<NodeId>> by_simulation_;
  std::unordered_map<NodeId, Bit> represented_;
};

}  // namespace rung::prove

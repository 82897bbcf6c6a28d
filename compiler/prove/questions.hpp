// SPDX-License-Identifier: Apache-2.0
// The questions of one routine's proof, and what becomes of an answer that is not the one hoped
// for.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "prove/prove.hpp"

namespace rung::prove {

class Questions {
 public:
  // `name`: what messages call a place of `start`.
  Questions(const Terms& terms, const Start& start, Solver& solver,
            std::function<std::string(Place)> name, std::size_t meaning,
            const ProofOptions& options, Proof& proof)
      : terms_(terms),
        start_(start),
        solver_(solver),
        name_(std::move(name)),
        meaning_(meaning),
        options_(options),
        proof_(proof) {}

  // True if `bad` is proven to be 0 always. `image` and `program`: the two values that differ.
  bool ask(Bit bad, NodeId since, int source, const std::string& what, const Bit* image = nullptr,
           const Bit* program = nullptr, std::size_t bits = 1);
  // What is wrong whatever the scan starts with; false.
  bool fail(int source, std::string what);
  // As many findings as are wanted.
  bool full() const { return found_ >= options_.findings; }
  std::size_t found() const { return found_; }

 private:
  int number(const Bit* bits, std::size_t count, const Model& model) const;
  void explain(Bit bad, const Model& model, Finding& finding) const;
  void add(Finding finding);

  const Terms& terms_;
  const Start& start_;
  Solver& solver_;
  std::function<std::string(Place)> name_;
  std::size_t meaning_;
  const ProofOptions& options_;
  Proof& proof_;
  std::size_t found_ = 0;
};

}  // namespace rung::prove

// SPDX-License-Identifier: Apache-2.0
// The three processors as engines that must agree with the reference.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>

#include "agree/case.hpp"
#include "harness/processor.hpp"

namespace rung::tb {

class Processors {
 public:
  // Runs at most so many scans of a case.
  explicit Processors(std::size_t most_scans);

  // The first difference on any processor, or what a pass of the compiler found wrong with another,
  // or nothing. Counts programs that a processor's memories do not hold.
  std::string run(const Case& one);

  int runs() const { return runs_; }
  int refused() const { return refused_; }

 private:
  std::string run_all(const Case& one);
  std::string run_on(Processor& processor, const Case& one);

  std::size_t most_scans_;
  std::array<std::unique_ptr<Processor>, 3> processors_;
  int runs_ = 0;
  int refused_ = 0;
};

}  // namespace rung::tb

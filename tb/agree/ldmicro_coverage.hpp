// SPDX-License-Identifier: Apache-2.0
// What random LDmicro programs do when they run, counted element by element in the reference: a
// generator whose programs never do something tests nothing of it.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "reference/reference.hpp"

namespace rung::tb {

class LdmicroCoverage {
 public:
  // Runs one scan of `reference`, which runs `program`, and counts of each element `NAME 0>1`: the
  // condition as it came in and as it went out; and of what it does, events such as `ADD wraps`.
  void run_scan(const Program& program, Reference& reference);
  // Counts the shape of a program: `branch without elements`, `name of both kinds`, ...
  void count_shape(const Program& program);

  void add(const LdmicroCoverage& other);
  std::uint64_t of(const std::string& key) const;
  const std::map<std::string, std::uint64_t>& all() const { return counts_; }

 private:
  void count(const std::string& key) { ++counts_[key]; }

  std::map<std::string, std::uint64_t> counts_;
};

}  // namespace rung::tb

// SPDX-License-Identifier: Apache-2.0
// One random program with what it is given, and how engines that ran it are compared.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "programs/random_melsec.hpp"
#include "rungs/program.hpp"
#include "trace/stimulus.hpp"

namespace rung::tb {

struct Case {
  std::uint64_t seed = 0;
  std::string text;
  Program program;
  std::vector<Device> devices;  // that the program names or its indexed operands reach
  std::int64_t tick_us = 10000;
  std::vector<std::vector<StimulusEvent>> events;  // of each scan

  int scans() const { return static_cast<int>(events.size()); }
};

// What an engine did with a case, scan by scan.
struct Behaviour {
  std::vector<std::vector<std::int16_t>> states;  // the values of all devices after it
  std::vector<std::vector<int>> sent;             // bytes, in it
  std::vector<bool> errors;  // whether it divided by zero; empty of an engine that is not asked
};

// Program number `seed`, of the families in `only` (all if empty).
std::string text_of(std::uint64_t seed, const std::vector<Family>& only);
// A program with the stimulus of `seed`; of a case that `text` is a part of, with the same events.
// Nothing, and why in `messages`, when `text` is refused.
std::optional<Case> make_case(std::uint64_t seed, const std::string& text, std::string& messages,
                              const Case* original = nullptr);

// What the reference does.
Behaviour run_reference(const Case& one);

// The first difference of `got`, which `engine` did, from `expected`, for a reader; empty if there
// is none.
std::string difference(const Case& one, const Behaviour& expected, const Behaviour& got,
                       const std::string& engine);

}  // namespace rung::tb

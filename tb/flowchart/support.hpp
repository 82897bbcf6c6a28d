// SPDX-License-Identifier: Apache-2.0
// What several tests of flow programs use.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "flowchart/read.hpp"
#include "reference/flow_rounds.hpp"
#include "rungs/devices.hpp"
#include "source/text_file.hpp"

namespace rung::flowchart {

struct ReadResult {
  std::optional<Flowchart> chart;
  std::string messages;  // as they are printed
};

inline ReadResult read_text_of(std::string_view text, const std::string& file = "t.flow") {
  Diagnostics diagnostics;
  ReadResult result;
  if (const auto source = decode_text(text, file, diagnostics)) {
    result.chart = parse(*source, diagnostics);
  }
  std::ostringstream out;
  diagnostics.print(out);
  result.messages = out.str();
  return result;
}

// A program that must be good and without any warning; an empty one, which fails the test, if not.
inline Flowchart good(std::string_view text) {
  ReadResult result = read_text_of(text);
  EXPECT_EQ(result.messages, "") << text;
  return result.chart ? std::move(*result.chart) : Flowchart{};
}

inline Device device(std::string_view name, Dialect dialect = Dialect::Fx) {
  return parse_device_name(name, dialect).value();
}

// The instructions of a step, one behind the other: "LD X0; OUT Y0".
inline std::string code(const Step& step) {
  std::string text;
  for (const Instruction& each : step.rungs.instructions) {
    if (!text.empty()) text += "; ";
    text += each.text;
  }
  return text;
}

// Rounds of a program, with devices by their names.
class Story {
 public:
  explicit Story(std::string_view text, std::int64_t tick_us = 10000)
      : chart_(good(text)), rounds_(chart_, tick_us) {}

  Story& set(std::string_view name, int value) {
    rounds_.set(device(name, chart_.dialect), static_cast<std::int16_t>(value));
    return *this;
  }
  int get(std::string_view name) const { return rounds_.get(device(name, chart_.dialect)); }
  Story& run(int rounds = 1) {
    for (int i = 0; i < rounds; ++i) rounds_.run_round();
    return *this;
  }
  FlowTaskState task(std::size_t number = 0) const { return rounds_.task(number); }
  // The named step that task `number` is at.
  std::string at(std::size_t number = 0) const { return chart_.steps.at(task(number).step).name; }
  const Flowchart& chart() const { return chart_; }
  FlowRounds& rounds() { return rounds_; }

 private:
  Flowchart chart_;
  FlowRounds rounds_;
};

// The number in an environment variable, or `otherwise`.
inline std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* value = std::getenv(name);
  return value == nullptr ? otherwise : std::strtoull(value, nullptr, 10);
}

}  // namespace rung::flowchart

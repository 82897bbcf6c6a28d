// SPDX-License-Identifier: Apache-2.0
// From what the lines say to the steps of the table.
#pragma once

#include <string>
#include <vector>

#include "flowchart/flowchart.hpp"
#include "flowchart/statements.hpp"

namespace rung::flowchart {

struct NamedStep {
  std::string name;
  SourcePosition position;
  std::string text;
  std::vector<Part> parts;
};
struct NamedTask {
  Token name;
  bool starts = false;
  std::vector<NamedStep> steps;
};

// Fills `chart.tasks` and `chart.steps`. `asked`: the tasks of which some condition asks whether
// they run. What does not fit the tables is an error; what nothing leads to, a warning.
void lay_out(const std::vector<NamedTask>& tasks, const std::vector<bool>& asked,
             const std::vector<bool>& started, Flowchart& chart, Diagnostics& diagnostics);

}  // namespace rung::flowchart

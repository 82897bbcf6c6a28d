// SPDX-License-Identifier: Apache-2.0
// The program on the language's page is one.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "support.hpp"

namespace rung::flowchart {
namespace {

TEST(FlowPage, ItsProgramIsGood) {
  std::ifstream page(std::string(RUNG_REPOSITORY) + "/compiler/FLOW.md");
  std::stringstream whole;
  whole << page.rdbuf();
  const std::string text = whole.str();
  const std::size_t first = text.find("```\n");
  const std::size_t last = text.find("```\n", first + 4);
  ASSERT_NE(last, std::string::npos);
  const std::filesystem::path folder = std::filesystem::path(RUNG_SCRATCH) / "flow_page";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "line.il") << "LD X5\nOUT Y5\nEND\n";
  std::ofstream(folder / "page.flow") << text.substr(first + 4, last - first - 4);
  Diagnostics diagnostics;
  const auto chart = read((folder / "page.flow").string(), diagnostics);
  std::ostringstream messages;
  diagnostics.print(messages);
  EXPECT_EQ(messages.str(), "");
  ASSERT_TRUE(chart);
  EXPECT_EQ(chart->tasks.size(), 2U);
  FlowRounds rounds(*chart);
  for (int i = 0; i < 10; ++i) rounds.run_round();
  EXPECT_TRUE(rounds.task(0).waits);
}

}  // namespace
}  // namespace rung::flowchart

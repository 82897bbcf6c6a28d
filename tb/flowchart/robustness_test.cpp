// SPDX-License-Identifier: Apache-2.0
// Garbage and mixed-up words: refused or accepted, never both, never a crash; what is accepted is
// whole, and runs. RUNG_SEED=N runs text N alone; RUNG_COUNT=N that many.
#include <gtest/gtest.h>

#include <functional>

#include "programs/random_source.hpp"
#include "rungs/structure.hpp"
#include "support.hpp"

namespace rung::flowchart {
namespace {

constexpr std::string_view kGood = R"(# all there is
dialect fx
unit 1
board MEMORY = unit 1 board 0
board PANEL = unit 1 board 1 panel link exclusive
board STORE = unit 2 board 0
task LIFT start
step UP
  read D100 count 4 from PANEL at 20
  Y0 = X0 and not (X1 or M3)
  D1.F = on
  set M3 if D0 > 5 and D3 / D4 <> 2
  reset M4
  D0 = D1 + 5 * -D2 - 3 % (D3 xor 0x1F)
  K4Y0 = TN0
  start OTHER if failed
  stop OTHER
  write D10 count 2 to STORE at 100
  when X0 and D0 > 5 goto DOWN
  when failed end
  when running OTHER goto UP
  wait 500 ms
  Y1 = off
  wait 2 s
step DOWN
  write D10 to MEMORY at 9
  goto UP
task OTHER
step ONE
  wait X0
step TWO
  D5 = D5 + 1
  when D5 = 10 end
)";

// True if it was accepted.
bool feed(const std::string& text, RandomSource& random) {
  const ReadResult result = read_text_of(text);
  const bool error = result.messages.find("error:") != std::string::npos;
  EXPECT_EQ(result.chart.has_value(), !error) << result.messages << text;
  if (!result.chart) return false;
  const Flowchart& chart = *result.chart;
  for (const Step& step : chart.steps) {
    EXPECT_LT(step.task, chart.tasks.size());
    for (const std::size_t next : step.next) EXPECT_EQ(chart.steps.at(next).task, step.task);
    std::vector<StructureItem> items;
    for (const Instruction& each : step.rungs.instructions) {
      items.push_back({effect_of(each.op), each.text, each.position});
    }
    Diagnostics diagnostics;
    check_structure("t", Dialect::Q, items, diagnostics);
    EXPECT_FALSE(diagnostics.has_errors()) << text;
  }
  FlowRounds rounds(chart);
  for (int i = 0; i < 30; ++i) {
    rounds.set({DeviceKind::X, static_cast<std::uint32_t>(random.below(3))},
               static_cast<std::int16_t>(random.below(2)));
    rounds.run_round();
    if (rounds.requests().empty() || random.percent(50)) continue;
    rounds.complete(rounds.requests().front().id, random.below(3), {1, 2, 3});
  }
  return true;
}

// A word of the good text, or any other.
std::string random_word(RandomSource& random) {
  static constexpr const char* kWords[] = {
      "dialect", "ladder", "unit",  "board", "panel", "link",  "exclusive", "task",
      "start",   "step",   "read",  "from",  "count", "at",    "set",       "reset",
      "stop",    "write",  "to",    "when",  "goto",  "end",   "wait",      "if",
      "running", "failed", "on",    "off",   "not",   "and",   "or",        "xor",
      "(",       ")",      "=",     "<",     "<>",    ">=",    "+",         "-",
      "*",       "/",      "%",     "\"",    "0",     "1",     "65535",     "0x7F",
      "ms",      "D0",     "X0",    "T0",    "CN200", "M8000", "K4X0",      "D0.3",
      "K9M99",   "UP",     "OTHER", "ONE",   "STORE", "\n",    "#",         "99999999999999999999",
      "V0",      "Z",      ".",     "W5",    "\t",    "\r",    "\xC3\xA4",  "\x01"};
  return kWords[random.below(static_cast<int>(std::size(kWords)))];
}

std::vector<std::string> split(std::string_view text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (c == ' ' || c == '\n') {
      if (c == '\n') words.emplace_back("\n");
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

std::string mutated(RandomSource& random) {
  std::vector<std::string> words = split(kGood);
  const auto any = [&] {
    return static_cast<std::ptrdiff_t>(random.below(static_cast<int>(words.size())));
  };
  for (int i = 1 + random.below(4); i > 0; --i) {
    const std::ptrdiff_t at = any();
    std::string& word = words[static_cast<std::size_t>(at)];
    switch (random.below(5)) {
      case 0:
        words.erase(words.begin() + at);
        break;
      case 1:
        words.insert(words.begin() + at, random_word(random));
        break;
      case 2:
        word = random_word(random);
        break;
      case 3:
        std::swap(word, words[static_cast<std::size_t>(any())]);
        break;
      default:
        if (word.empty()) break;
        word[static_cast<std::size_t>(random.below(static_cast<int>(word.size())))] =
            static_cast<char>(random.percent(80) ? 32 + random.below(95) : random.below(256));
    }
  }
  std::string text;
  for (const std::string& word : words) text += word == "\n" ? word : word + ' ';
  return text;
}

void run(const char* name, std::uint64_t count, const std::function<void(std::uint64_t)>& one) {
  const bool alone = std::getenv("RUNG_SEED") != nullptr;
  const std::uint64_t first = from_environment("RUNG_SEED", 0);
  if (alone) count = 1;
  count = from_environment("RUNG_COUNT", count);
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    one(seed);
    if (testing::Test::HasFailure()) {
      FAIL() << "replay: RUNG_SEED=" << seed << " build/test/tb/flowchart/unit_flowchart"
             << " --gtest_filter=FlowRobustness." << name;
    }
  }
}

TEST(FlowRobustness, TheGoodTextIsGood) {
  RandomSource random(1);
  EXPECT_TRUE(feed(std::string(kGood), random));
}

TEST(FlowRobustness, Bytes) {
  run("Bytes", 1000, [](std::uint64_t seed) {
    RandomSource random(seed);
    std::string text;
    for (int i = random.below(300); i > 0; --i) text += static_cast<char>(random.below(256));
    feed(text, random);
  });
}

TEST(FlowRobustness, Words) {
  run("Words", 1000, [](std::uint64_t seed) {
    RandomSource random(seed);
    std::string text = random.percent(50) ? "task A start\nstep S\n" : "";
    for (int i = random.below(80); i > 0; --i) {
      text += random_word(random) + (random.percent(15) ? "\n" : " ");
    }
    feed(text, random);
  });
}

TEST(FlowRobustness, Mutations) {
  int accepted = 0;
  run("Mutations", 1500, [&](std::uint64_t seed) {
    RandomSource random(seed);
    if (feed(mutated(random), random)) ++accepted;
  });
  // Both ways are taken.
  if (std::getenv("RUNG_SEED") == nullptr) {
    EXPECT_GT(accepted, 50);
  }
}

// Every beginning of it.
TEST(FlowRobustness, HalfTexts) {
  RandomSource random(1);
  for (std::size_t length = 0; length < kGood.size(); length += 3) {
    feed(std::string(kGood.substr(0, length)), random);
  }
}

}  // namespace
}  // namespace rung::flowchart

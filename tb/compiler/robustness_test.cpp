// SPDX-License-Identifier: Apache-2.0
// Garbage and half files: refused or accepted, never a crash, and never both.
#include <gtest/gtest.h>

#include <algorithm>

#include "backends/c_writer.hpp"
#include "backends/list_writer.hpp"
#include "programs/random_program.hpp"
#include "programs/random_source.hpp"
#include "reference/run.hpp"
#include "support.hpp"
#include "trace/trace.hpp"

namespace rung {
namespace {

// Takes the text through everything that can take it.
void feed(const std::string& text, const std::string& file = "t") {
  const ParseResult result = parse(text, std::nullopt, file);
  ASSERT_EQ(result.program.has_value(), result.messages.empty()) << result.messages;
  if (!result.program) return;
  Reference reference(*result.program);
  for (int scan = 0; scan < 3; ++scan) reference.run_scan();
  EXPECT_FALSE(to_c(*result.program).empty());
  const ParseResult again = parse(to_list(*result.program), result.program->dialect);
  ASSERT_TRUE(again.program) << again.messages << text;
  EXPECT_EQ(dump(*again.program), dump(*result.program));
}

TEST(Robustness, RandomBytes) {
  RandomSource random(1);
  for (int round = 0; round < 2000; ++round) {
    std::string bytes;
    if (random.percent(20)) bytes = "\xFF\xFE";
    const int length = random.below(200);
    for (int i = 0; i < length; ++i) bytes += static_cast<char>(random.below(256));
    feed(bytes);
  }
}

TEST(Robustness, RandomWords) {
  static constexpr const char* kWords[] = {
      "LD",  "LDI",   "AND", "OR",  "ANB",  "ORB",  "MPS", "MRD",   "MPP", "OUT",
      "SET", "RST",   "MOV", "MV",  "ADD",  "+",    "-",   "*",     "/",   "//",
      "(*",  "*)",    ";",   "#",   "X0",   "Y1",   "M2",  "D3",    "D4",  "K5",
      "K-1", "H1F",   "X8",  "T0",  "K50",  "12",   "END", "NOP",   "LDP", "CALL",
      "P0",  "FOO",   "D/",  "LD=", "D0.1", "K2X0", "\"",  "D7999", "MUL", "DIV",
      "SUB", "SM400", "\t",  ",",   "X",    "K",    "H",   "-",     "=",   "\xE3\x81\x82"};
  RandomSource random(2);
  int accepted = 0;
  for (int round = 0; round < 5000; ++round) {
    std::string text;
    const int length = random.below(30);
    for (int i = 0; i < length; ++i) {
      text += kWords[random.bits() % std::size(kWords)];
      text += random.percent(25) ? '\n' : ' ';
    }
    feed(text, "t.esc");
    accepted += parse(text, std::nullopt, "t.esc").program ? 1 : 0;
  }
  EXPECT_GT(accepted, 0);
}

TEST(Robustness, TruncatedAndChangedPrograms) {
  RandomSource random(3);
  for (const Dialect dialect : {Dialect::Paper, Dialect::Fx, Dialect::Q}) {
    RandomProgramOptions options;
    options.dialect = dialect;
    options.networks = 6;
    const std::string whole = random_program(5, options);
    for (std::size_t length = 0; length <= whole.size(); ++length) {
      feed(whole.substr(0, length));
    }
    for (int round = 0; round < 500; ++round) {
      std::string changed = whole;
      for (int i = 0; i <= random.below(3); ++i) {
        const std::size_t at = random.bits() % changed.size();
        if (random.percent(50)) {
          changed[at] = static_cast<char>(32 + random.below(95));
        } else {
          // A line lost, as a bad copy loses it.
          const std::size_t start = changed.rfind('\n', at) + 1;
          changed.erase(start, changed.find('\n', at) - start);
        }
      }
      feed(changed);
    }
  }
}

TEST(Robustness, LongLinesAndManyErrors) {
  feed(std::string(1000000, 'L') + "\nEND");
  feed("LD " + std::string(100000, '9') + "\nOUT Y0\nEND");
  std::string many;
  for (int i = 0; i < 20000; ++i) many += "FOO\n";
  const ParseResult result = parse(many);
  EXPECT_EQ(std::count(result.messages.begin(), result.messages.end(), '\n'), 2 * 20000 + 2);
}

TEST(Robustness, TruncatedAndChangedTraces) {
  const Program program = good_program(random_program(1, {}), Dialect::Fx);
  ReferenceRun run(program, true);
  std::string whole = to_json(run.header()) + "\n";
  for (int i = 0; i < 2; ++i) whole += to_json(run.scan({})) + "\n";
  RandomSource random(4);
  for (int round = 0; round < 1500; ++round) {
    std::string changed = whole.substr(0, random.bits() % (whole.size() + 1));
    for (int i = 0; i < 2 && !changed.empty() && random.percent(80); ++i) {
      changed[random.bits() % changed.size()] = static_cast<char>(random.below(256));
    }
    Diagnostics diagnostics;
    const auto trace = read_trace(changed, "t", diagnostics);
    ASSERT_EQ(trace.has_value(), !diagnostics.has_errors());
  }
}

TEST(Robustness, RandomStimuli) {
  static constexpr const char* kPieces[] = {"X0", "=",  "1", " ",  "\n", "*", "9",
                                            "_",  "D5", "-", "X8", "RX", "0"};
  RandomSource random(5);
  for (int round = 0; round < 3000; ++round) {
    std::string text = "X0=1";
    for (int i = random.below(20); i > 0; --i) text += kPieces[random.bits() % std::size(kPieces)];
    Diagnostics diagnostics;
    const auto source = decode_text(text, "s", diagnostics);
    ASSERT_TRUE(source);
    const auto stimulus = parse_stimulus(*source, Dialect::Fx, diagnostics);
    ASSERT_EQ(stimulus.has_value(), !diagnostics.has_errors());
  }
}

}  // namespace
}  // namespace rung

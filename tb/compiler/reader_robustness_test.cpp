// SPDX-License-Identifier: Apache-2.0
// Garbage, half files and mixed-up words for the readers of programs and comments: refused or
// accepted, never both, never a crash; what is accepted is written and reads back.
#include <gtest/gtest.h>

#include <array>

#include "backends/list_writer.hpp"
#include "melsec/comments.hpp"
#include "melsec/instructions.hpp"
#include "melsec/unsupported.hpp"
#include "programs/random_source.hpp"
#include "rungs/devices.hpp"
#include "rungs/special.hpp"
#include "support.hpp"

namespace rung {
namespace {

constexpr Dialect kDialects[] = {Dialect::Paper, Dialect::Fx, Dialect::Q};

// True if it was accepted.
bool feed(const std::string& text, std::optional<Dialect> dialect, const std::string& file) {
  const ParseResult result = parse(text, dialect, file);
  EXPECT_EQ(result.program.has_value(), result.messages.empty()) << result.messages << text;
  Diagnostics diagnostics;
  if (const auto source = decode_text(text, file, diagnostics)) {
    const auto comments = parse_comments(*source, dialect.value_or(Dialect::Fx), diagnostics);
    EXPECT_EQ(comments.has_value(), !diagnostics.has_errors()) << text;
  }
  if (!result.program) return false;
  EXPECT_FALSE(count(*result.program).run_lengths.size() > result.program->instructions.size());
  for (const Device device : named_devices(*result.program)) {
    const DeviceRange* range = find_device_range(device.kind, result.program->dialect);
    EXPECT_TRUE(find_special(device, result.program->dialect) != nullptr ||
                (range != nullptr && device.number >= range->first && device.number <= range->last))
        << device_name(device, result.program->dialect) << " of " << text;
  }
  const ParseResult again = parse(to_list(*result.program), result.program->dialect);
  EXPECT_TRUE(again.program) << again.messages << text;
  if (again.program) {
    EXPECT_EQ(dump(*again.program), dump(*result.program));
  }
  return true;
}

std::string random_operand(RandomSource& random) {
  static constexpr const char* kOperands[] = {
      "X0",   "Y17",  "M5",      "M7679",  "M8000",  "M8200", "M8029",  "L3",    "F2",
      "B1F",  "S20",  "SM400",   "SD5",    "T0",     "T511",  "ST5",    "C0",    "C200",
      "C235", "D0",   "D20",     "D7999",  "W1F",    "SW1",   "R5",     "V0",    "Z7",
      "V",    "TN0",  "CN200:H", "K0",     "K5",     "K-1",   "K32767", "K9999", "HFFFF",
      "K",    "K4X0", "K8M0",    "K1Y370", "K99M0",  "D0.F",  "D1.10",  "M0.1",  "D20Z0",
      "X0Z7", "D5V",  "K4X0Z1",  "P0",     "P1",     "P63",   "N0",     "N1",    "N9",
      "I5",   "E1.5", "\"AB\"",  "@D0",    "U0\\G1", ".",     "Z",      "K4",    "-",
      "0",    "12",   ",",       "D0,D1",  "ZV",     "K0.1",  ".F"};
  return kOperands[random.bits() % std::size(kOperands)];
}

std::string random_name(RandomSource& random) {
  static const std::vector<std::string_view> names = instruction_names();
  static const std::vector<std::string_view> others = unsupported_names();
  if (random.percent(3)) return std::string(others[random.bits() % others.size()]);
  if (random.percent(50)) {
    static constexpr const char* kCommon[] = {"LD",  "AND",  "OR",   "OUT", "LD",   "MPS", "MPP",
                                              "ANB", "END",  "MC",   "MCR", "STL",  "RET", "P0",
                                              "P1",  "FEND", "SRET", "FOR", "NEXT", "CJ",  "CALL"};
    return kCommon[random.bits() % std::size(kCommon)];
  }
  return std::string(names[random.bits() % names.size()]);
}

TEST(ReaderRobustness, RandomBytes) {
  RandomSource random(1);
  constexpr std::array<std::string_view, 5> kStarts = {"", "\xFF\xFE", "\xFE\xFF", "\xEF\xBB\xBF",
                                                       "\""};
  for (int round = 0; round < 3000; ++round) {
    std::string bytes(kStarts[random.bits() % kStarts.size()]);
    for (int i = random.below(200); i > 0; --i) bytes += static_cast<char>(random.below(256));
    feed(bytes, std::nullopt, round % 2 == 0 ? "t" : "t.csv");
  }
}

TEST(ReaderRobustness, RandomWords) {
  RandomSource random(2);
  int accepted = 0;
  for (int round = 0; round < 6000; ++round) {
    std::string text;
    for (int i = random.below(12); i > 0; --i) {
      text += random_name(random);
      for (int n = random.below(4); n > 0; --n) text += " " + random_operand(random);
      text += random.percent(80) ? "\n" : " ";
    }
    const auto dialect = kDialects[random.bits() % std::size(kDialects)];
    accepted += feed(text, dialect, "t.esc") ? 1 : 0;
  }
  EXPECT_GT(accepted, 0);
}

// One instruction with as many operands as it takes: often accepted.
TEST(ReaderRobustness, RandomOperands) {
  RandomSource random(3);
  const std::vector<std::string_view> names = instruction_names();
  int accepted = 0;
  for (int round = 0; round < 20000; ++round) {
    const std::string_view name = names[random.bits() % names.size()];
    const auto forms = find_instruction(name);
    std::string text = is_load(forms.front().row->op) ? "" : "LD X0\n";
    text += name;
    for (int n = operand_count(forms).most; n > 0; --n) text += " " + random_operand(random);
    if (!is_output(forms.front().row->op)) text += "\nOUT Y0";
    const auto dialect = kDialects[random.bits() % std::size(kDialects)];
    accepted += feed(text + "\nEND", dialect, "t") ? 1 : 0;
  }
  EXPECT_GT(accepted, 1000);
}

TEST(ReaderRobustness, RandomRows) {
  RandomSource random(4);
  int accepted = 0;
  for (int round = 0; round < 4000; ++round) {
    const char separator = random.percent(50) ? '\t' : ',';
    const bool quoted = random.percent(50);
    std::string text;
    const auto cell = [&](const std::string& contents) {
      const bool damaged = random.percent(1);
      text += quoted != damaged ? "\"" + contents + "\"" : contents;
      text += separator;
    };
    if (random.percent(80)) text += "\"A\"\n\"PLC\"\t\"FXCPU\"\n\"S\"\t\"L\"\t\"I\"\t\"D\"\n";
    for (int i = random.below(10); i > 0; --i) {
      const bool begins = random.percent(60);
      cell(begins ? "1" : "");
      cell(random.percent(5) ? "text" : "");
      cell(begins ? random_name(random) : random.percent(20) ? random_operand(random) : "");
      cell(random_operand(random));
      if (random.percent(20)) cell("");
      text += "\n";
    }
    text += "\"9\"\t\"\"\t\"END\"\n";
    accepted += feed(text, std::nullopt, "t.csv") ? 1 : 0;
  }
  EXPECT_GT(accepted, 0);
}

TEST(ReaderRobustness, TruncatedAndChangedPrograms) {
  const std::string whole =
      "\"A\"\n\"PLC\"\t\"FXCPU\"\n\"S\"\t\"L\"\t\"I\"\t\"D\"\n\"0\"\t\"\"\t\"LD\"\t\"X000\"\n"
      "\"1\"\t\"\"\t\"MOV\"\t\"K4X000\"\n\"\"\t\"\"\t\"\"\t\"D0Z0\"\n\"6\"\t\"\"\t\"END\"\n";
  RandomSource random(5);
  for (std::size_t length = 0; length <= whole.size(); ++length) {
    feed(whole.substr(0, length), std::nullopt, "t.csv");
  }
  for (int round = 0; round < 2000; ++round) {
    std::string changed = whole;
    for (int i = random.below(4); i >= 0; --i) {
      changed[random.bits() % changed.size()] = static_cast<char>(random.below(256));
    }
    feed(changed, std::nullopt, "t.csv");
  }
}

TEST(ReaderRobustness, LargeFiles) {
  feed(std::string(300000, '"'), std::nullopt, "t.csv");
  feed("\"" + std::string(300000, '\n'), std::nullopt, "t.csv");
  feed(std::string(300000, ','), std::nullopt, "t.csv");
  std::string calls = "LD X0\nCALL P1\nFEND\n";
  for (int i = 1; i < 3000; ++i) calls += fmt::format("P{}\nLD X0\nCALL P{}\nSRET\n", i, i + 1);
  EXPECT_FALSE(feed(calls + "END", std::nullopt, "t"));
  std::string loops;
  for (int i = 0; i < 20000; ++i) loops += "FOR K32767\n";
  EXPECT_FALSE(feed(loops + "END", std::nullopt, "t"));
  std::string zones;
  for (int i = 0; i < 5000; ++i) zones += "LD X0\nMC N0 M0\n";
  EXPECT_FALSE(feed(zones + "END", std::nullopt, "t"));
}

}  // namespace
}  // namespace rung

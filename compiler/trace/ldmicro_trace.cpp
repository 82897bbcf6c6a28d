// SPDX-License-Identifier: Apache-2.0
#include "trace/ldmicro_trace.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <utility>

#include "source/text_file.hpp"

namespace rung {
namespace {

// What is wrong with one line; becomes a diagnostic at that line. Not the text of an exception,
// which would end where a line has a byte 0.
struct BadLine {
  explicit BadLine(std::string text) : what(std::move(text)) {}
  std::string what;
};

constexpr std::string_view kBlanks = " \t\r";

// Cuts the first word off `line`; empty at its end.
std::string_view next_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
  const std::size_t end = std::min(line.find_first_of(kBlanks), line.size());
  const std::string_view word = line.substr(0, end);
  line.remove_prefix(end);
  return word;
}

std::optional<std::int64_t> whole_number(std::string_view text) {
  std::int64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, value);
  if (text.empty() || failure != std::errc() || stop != end) return std::nullopt;
  return value;
}

// A message of the simulator instead of a scan.
bool is_message(std::string_view line) {
  return line.starts_with("ERROR:") || line.starts_with("INTCODE FAILED");
}

class TraceReader {
 public:
  void line(std::string_view text, int number) {
    std::string_view rest = text;
    const std::string_view first = next_word(rest);
    if (first.empty()) return;
    if (is_message(text)) {
      if (!trace.stop) trace.stop = {number, shown_line(text)};
      return;
    }
    if (trace.stop) throw BadLine("a scan behind the place where the simulator stopped");
    TraceScan scan;
    scan.line = number;
    scan.scan = scan_number(first);
    scan.state.emplace();
    while (true) {
      const std::string_view word = next_word(rest);
      if (word.empty()) break;
      if (word == "DIVZERO_HALT") {
        trace.stop = {number, "a division by zero"};
        return;
      }
      value(word, scan);
    }
    trace.scans.push_back(std::move(scan));
  }

  LdmicroTrace trace;

 private:
  static std::string shown_line(std::string_view text) {
    return std::string(text.substr(0, text.find_last_not_of(kBlanks) + 1));
  }

  std::int64_t scan_number(std::string_view word) const {
    const auto number = word.ends_with(':') ? whole_number(word.substr(0, word.size() - 1))
                                            : std::optional<std::int64_t>();
    if (!number) {
      throw BadLine(fmt::format("{} is no number of a scan; a line is `0: NAME=value ... TX=byte`",
                                shown(word)));
    }
    const auto expected = static_cast<std::int64_t>(trace.scans.size());
    if (*number != expected) {
      throw BadLine(fmt::format("it holds scan {} where scan {} should be", *number, expected));
    }
    return *number;
  }

  static void value(std::string_view word, TraceScan& scan) {
    const std::size_t equals = std::min(word.find('='), word.size());
    const std::string_view name = word.substr(0, equals);
    const auto number = whole_number(word.substr(std::min(equals + 1, word.size())));
    const bool sent = name == "TX";
    const std::int64_t least = sent ? 0 : INT16_MIN;
    const std::int64_t most = sent ? UINT8_MAX : INT16_MAX;
    if (name.empty() || !number || *number < least || *number > most) {
      throw BadLine(
          fmt::format("{} is no name with a value from {} to {}", shown(word), least, most));
    }
    if (sent) {
      scan.tx.push_back(static_cast<int>(*number));
    } else {
      scan.state->push_back({std::string(name), static_cast<std::int32_t>(*number)});
    }
  }
};

}  // namespace

bool is_ldmicro_trace(std::string_view bytes) {
  bytes.remove_prefix(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
  return !bytes.empty() && ((bytes.front() >= '0' && bytes.front() <= '9') || is_message(bytes));
}

std::optional<LdmicroTrace> read_ldmicro_trace(std::string_view bytes, const std::string& file,
                                               Diagnostics& diagnostics) {
  TraceReader reader;
  int number = 0;
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    ++number;
    try {
      reader.line(bytes.substr(0, end), number);
    } catch (const BadLine& failure) {
      diagnostics.error(file, {number, 1}, failure.what);
      return std::nullopt;
    }
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
  }
  if (reader.trace.scans.empty() && !reader.trace.stop) {
    diagnostics.error(file, {}, "this is no trace: it is empty");
    return std::nullopt;
  }
  return std::move(reader.trace);
}

std::optional<TraceDifference> compare_shown(const TraceScan& expected, const TraceScan& got) {
  std::map<std::string, std::int32_t> shown_values;
  for (const TraceValue& each : *expected.state) shown_values[each.device] = each.value;
  std::map<std::string, std::int32_t> ours;
  for (const TraceValue& each : *got.state) ours[each.device] = each.value;
  const auto differ = [&](const std::string& name, std::string want, std::string have) {
    return TraceDifference{expected.scan, TraceAspect::State, name, std::move(want),
                           std::move(have)};
  };
  for (const auto& [name, value] : shown_values) {
    if (!ours.contains(name)) return differ(name, fmt::to_string(value), "nothing");
  }
  for (const auto& [name, value] : ours) {
    if (name.ends_with(":w") || ours.contains(name + ":w")) continue;
    const auto found = shown_values.find(name);
    const std::int32_t want = found == shown_values.end() ? 0 : found->second;
    if (want != value) return differ(name, fmt::to_string(want), fmt::to_string(value));
  }
  if (expected.tx == got.tx) return std::nullopt;
  return TraceDifference{expected.scan,
                         TraceAspect::Sent,
                         {},
                         fmt::format("[{}]", fmt::join(expected.tx, " ")),
                         fmt::format("[{}]", fmt::join(got.tx, " "))};
}

}  // namespace rung

// SPDX-License-Identifier: Apache-2.0
#include "device/console.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

namespace rung::device {
namespace {

constexpr int kHighestSample = 32767;
constexpr std::string_view kSpace = " \t\r";

std::string_view trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

std::optional<int> number_of(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::variant<BenchCommand, std::string> assignment(std::string_view name, std::string_view text,
                                                   const controller::Board& board) {
  const auto value = number_of(text);
  const auto pin = std::find(board.inputs.begin(), board.inputs.end(), name);
  if (pin != board.inputs.end()) {
    if (!value || (*value != 0 && *value != 1)) {
      return fmt::format("'{}': an input pin is 0 or 1: {}=1", text, name);
    }
    return BenchCommand{BenchCommand::Kind::Input, static_cast<int>(pin - board.inputs.begin()),
                        *value};
  }
  if (name.starts_with("adc")) {
    const auto channel = number_of(name.substr(3));
    if (channel && *channel >= 0 && *channel < board.adc) {
      if (!value || *value < 0 || *value > kHighestSample) {
        return fmt::format("'{}': a sample is 0 to {}: {}=512", text, kHighestSample, name);
      }
      return BenchCommand{BenchCommand::Kind::Adc, *channel, *value};
    }
  }
  return fmt::format("'{}': {} has the inputs {} to {}{}", name, board.name, board.inputs.front(),
                     board.inputs.back(),
                     board.adc > 0 ? fmt::format(" and adc0 to adc{}", board.adc - 1) : "");
}

}  // namespace

std::variant<BenchCommand, std::string> parse_bench_command(std::string_view line,
                                                            const controller::Board& board) {
  using Kind = BenchCommand::Kind;
  line = trim(line.substr(0, line.find('#')));
  if (line.empty()) return BenchCommand{};
  if (const std::size_t equal = line.find('='); equal != std::string_view::npos) {
    return assignment(trim(line.substr(0, equal)), trim(line.substr(equal + 1)), board);
  }
  const std::size_t gap = std::min(line.find_first_of(kSpace), line.size());
  const std::string_view word = line.substr(0, gap);
  const std::string_view rest = trim(line.substr(gap));
  if (word == "power" && (rest == "on" || rest == "off")) {
    return BenchCommand{Kind::Power, 0, rest == "on" ? 1 : 0};
  }
  if (word == "switch" && (rest == "run" || rest == "stop")) {
    return BenchCommand{Kind::Switch, 0, rest == "run" ? 1 : 0};
  }
  if (rest.empty() && word == "show") return BenchCommand{Kind::Show};
  if (rest.empty() && word == "help") return BenchCommand{Kind::Help};
  if (rest.empty() && (word == "quit" || word == "exit")) return BenchCommand{Kind::Quit};
  return fmt::format("'{}': no such command; 'help' lists them", line);
}

std::string bench_help(const controller::Board& board) {
  std::string text = fmt::format("  {}=1            level of an input pin ({} to {})\n",
                                 board.inputs.front(), board.inputs.front(), board.inputs.back());
  if (board.adc > 0) {
    text += fmt::format("  adc0=512         sample of an analogue channel (adc0 to adc{})\n",
                        board.adc - 1);
  }
  return text +
         "  power off|on     cut the supply, also in the middle of a flash write\n"
         "  switch run|stop  the RUN switch\n"
         "  show             time, state, pins that are 1\n"
         "  quit             end, as SIGTERM does\n";
}

}  // namespace rung::device

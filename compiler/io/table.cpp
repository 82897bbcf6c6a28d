// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "io/bind.hpp"
#include "rung_controller.hpp"

namespace rung::io {
namespace {

struct Row {
  std::string device, comment, at, how;
};

std::string comment_of(Device device, const Subject& subject) {
  for (const SubjectDevice& each : subject.devices) {
    if (each.device == device) return each.comment;
  }
  return {};
}

// Runs of devices as first-last.
std::string ranges(const std::vector<Device>& devices, const Subject& subject) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < devices.size();) {
    std::size_t end = i + 1;
    while (end < devices.size() && devices[end].kind == devices[i].kind &&
           devices[end].number == devices[end - 1].number + 1) {
      ++end;
    }
    const std::string first = subject.name(devices[i]);
    out.push_back(end - i == 1 ? first : first + "-" + subject.name(devices[end - 1]));
    i = end;
  }
  return out.empty() ? "none" : fmt::format("{}", fmt::join(out, " "));
}

std::vector<Row> rows_of(const Bindings& bindings, const Subject& subject) {
  const controller::Board& board = *bindings.board;
  std::vector<Row> rows;
  const auto add = [&](Device device, std::string_view at, std::string how) {
    rows.push_back(
        {subject.name(device), comment_of(device, subject), std::string(at), std::move(how)});
  };
  for (const Bindings::Input& each : bindings.inputs) {
    std::string how = "input";
    if (each.filter > 0) how += fmt::format(", {} equal samples", each.filter);
    if (each.invert) how += ", inverted";
    add(each.device, board.inputs[each.pin], how);
  }
  for (const SubjectDevice& each : subject.devices) {
    const bool bound = std::any_of(bindings.inputs.begin(), bindings.inputs.end(),
                                   [&](const auto& line) { return line.device == each.device; });
    if (each.device.kind == DeviceKind::X && !bound) add(each.device, "-", "input, only forced");
  }
  for (const Bindings::Output& each : bindings.outputs) {
    std::string how = "output, ";
    how += each.safe == Safe::Hold   ? "keeps its level"
           : each.safe == Safe::High ? "safe at 1"
                                     : "safe at 0";
    if (each.invert) how += ", inverted";
    add(each.device, board.outputs[each.pin], how);
  }
  for (const Bindings::Analog& each : bindings.analog) {
    add(each.device, fmt::format("adc{}", each.channel), "analogue");
  }
  if (bindings.pwm) {
    add(bindings.pwm->device, board.pwm[bindings.pwm->pin],
        fmt::format("PWM duty in per cent, {} Hz", bindings.pwm->hz));
  }
  if (bindings.ladder_pwm && !board.pwm.empty()) {
    rows.push_back({"SET PWM", "", std::string(board.pwm[0]), "PWM"});
  }
  if (bindings.ladder_uart && !board.uart.empty()) {
    rows.push_back({"UART", "", std::string(board.uart[0]), "the ladder's UART"});
  }
  return rows;
}

}  // namespace

std::string table(const Bindings& bindings, const Subject& subject) {
  const std::vector<Row> rows = rows_of(bindings, subject);
  std::size_t device = 6;
  std::size_t comment = 4;
  std::size_t at = 2;
  for (const Row& row : rows) {
    device = std::max(device, row.device.size());
    comment = std::max(comment, row.comment.size());
    at = std::max(at, row.at.size());
  }
  std::string text = fmt::format("board {}: {}\n", bindings.board->name, bindings.board->title);
  text +=
      fmt::format("{:<{}}  {:<{}}  {:<{}}  what\n", "device", device, "name", comment, "at", at);
  for (const Row& row : rows) {
    text += fmt::format("{:<{}}  {:<{}}  {:<{}}  {}\n", row.device, device, row.comment, comment,
                        row.at, at, row.how);
  }
  return text +
         fmt::format("kept over STOP and power loss: {}\n", ranges(bindings.latched, subject));
}

}  // namespace rung::io

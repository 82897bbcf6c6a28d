// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <map>

#include "cli/client_input.hpp"
#include "rung_controller.hpp"

namespace rung::cli {
namespace {

std::string flag_names(int flags) {
  static constexpr const char* kNames[] = {nullptr, "overrun seen", "something is forced",
                                           "latched devices restored",
                                           "division by 0 in the last scan"};
  std::string text = (flags & 1) != 0 ? "RUN switch on" : "RUN switch off";
  for (int bit = 1; bit < 5; ++bit) {
    if ((flags >> bit & 1) != 0) text += std::string(", ") + kNames[bit];
  }
  return text;
}

// Pins by name, those at 1.
std::string pins(const std::vector<std::string_view>& names,
                 const std::vector<std::uint16_t>& words) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if ((words.at(i / 16) >> i % 16 & 1) != 0) text += " " + std::string(names[i]);
  }
  return text.empty() ? " none" : text;
}

void print(const client::Identity& who, const client::Status& status) {
  const std::string config = client::config_name(who.config);
  fmt::print("controller:  board {}, configuration {}, MPU{}, register map {}\n",
             client::board_name(who.board), config, who.mpu, who.interface);
  if (who.tables != controller::tables) {
    fmt::print("tables:      {:04x}; this program has {:04x}: programs cannot be loaded\n",
               who.tables, controller::tables);
  }
  fmt::print("state:       {}{}{}\n", client::state_name(status.state),
             status.fault != 0 ? ", fault: " : "",
             status.fault != 0 ? client::fault_name(status.fault) : "");
  fmt::print("             {}\n", flag_names(status.flags));
  if (status.generation != 0) {
    fmt::print("program:     generation {}, {} bytes, CRC {:08x}, from copy {}\n",
               status.generation, 2 * std::uint64_t{status.length}, status.crc,
               status.flags >> 5 & 1);
  } else {
    fmt::print("program:     none\n");
  }
  fmt::print("scans:       {}; clocks last {}, least {}, most {}; overruns {}\n", status.scan_count,
             status.scan_last, status.scan_min, status.scan_max, status.overruns);
  fmt::print("requests:    {} taken, {} exceptions; at most {} points each\n", status.frames,
             status.exceptions, status.exchange_points);
  fmt::print("bad frames:  {}; bad bytes {}; lost frames {}\n", status.bad_frames, status.bad_bytes,
             status.lost_frames);
  fmt::print("forced:      {}; savings since power-up {}\n", status.forces, status.saves);
  for (const controller::Board& board : controller::boards()) {
    if (board.id != who.board) continue;
    fmt::print("inputs at 1: {}\n", pins(board.inputs, status.inputs).substr(1));
    fmt::print("outputs at 1: {}\n", pins(board.outputs, status.outputs).substr(1));
  }
}

int action_number(const std::string& action) {
  static const std::map<std::string, int> kActions = {
      {"run", 1},         {"stop", 2}, {"scan", 3},         {"clear-statistics", 4},
      {"leave-fault", 5}, {"save", 6}, {"clear-latched", 8}};
  return kActions.at(action);
}

}  // namespace

int info_command(const Options& options) {
  Diagnostics diagnostics;
  return with_controller(options, diagnostics, [&] {
    client::Controller controller(line_of(options, std::nullopt));
    print(controller.identity(), controller.status());
    return kDone;
  });
}

int control_command(const Options& options) {
  Diagnostics diagnostics;
  return with_controller(options, diagnostics, [&] {
    client::Controller controller(line_of(options, std::nullopt));
    controller.command(action_number(options.action));
    const client::Status status = controller.status();
    fmt::print("{}: {}{}{}\n", options.port, client::state_name(status.state),
               status.fault != 0 ? ", fault: " : "",
               status.fault != 0 ? client::fault_name(status.fault) : "");
    return kDone;
  });
}

}  // namespace rung::cli

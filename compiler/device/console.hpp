// SPDX-License-Identifier: Apache-2.0
// The lines that somebody types to the bench around a device.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "rung_controller.hpp"

namespace rung::device {

struct BenchCommand {
  enum class Kind { Nothing, Input, Adc, Power, Switch, Show, Help, Quit };
  Kind kind = Kind::Nothing;
  int index = 0;  // of an input pin or a channel
  int value = 0;
};

// The command, or what is wrong with it and what is right.
std::variant<BenchCommand, std::string> parse_bench_command(std::string_view line,
                                                            const controller::Board& board);

// The list of commands, for `help`.
std::string bench_help(const controller::Board& board);

}  // namespace rung::device

// SPDX-License-Identifier: Apache-2.0
#include "driver/peripherals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rung {
namespace {

constexpr double kFractionsABit = 8.0 * (1 << 20);
constexpr double kMostStep = 1 << 20;
// Down to here the receiver is known to bear a sender that is 2 % off (tb/peripherals).
constexpr double kLeastClocksABit = 13;
constexpr double kMostBaudError = 0.02;
constexpr double kClocksForPercent = 100;

std::string megahertz(const isa::Config& config) {
  return fmt::format("{} MHz", config.clock_hz / 1e6);
}

bool uses_uart(const Program& program) {
  return std::any_of(program.instructions.begin(), program.instructions.end(),
                     [](const Instruction& instruction) {
                       return instruction.op == Op::UartSend || instruction.op == Op::UartRecv ||
                              instruction.op == Op::FormattedString;
                     });
}

// The UART counts 8 * 2^20 fractions of a bit in a register of 20 bits (hdl/peripherals/uart_rx.v).
void check_baud(const Program& program, const isa::Config& config, Diagnostics& diagnostics) {
  const LdmicroSettings& settings = *program.ldmicro;
  const double clock = config.clock_hz;
  const double step = std::round(kFractionsABit * static_cast<double>(settings.baud) / clock);
  const auto highest = static_cast<std::int64_t>(clock / kLeastClocksABit);
  const std::string what = fmt::format("BAUD={}: the clock of configuration {}, {},", settings.baud,
                                       config.name, megahertz(config));
  if (step < 1 || step >= kMostStep) {
    diagnostics.error(
        program.file, settings.baud_position, what + " cannot make it",
        fmt::format("choose one from {} to {}", 1 + config.clock_hz / (1 << 23), highest));
    return;
  }
  const double made = step * clock / kFractionsABit;
  const double off =
      (made - static_cast<double>(settings.baud)) / static_cast<double>(settings.baud);
  if (std::abs(off) > kMostBaudError) {
    diagnostics.warning(program.file, settings.baud_position,
                        fmt::format("{} makes {:.1f}, {:+.1f} % off", what, made, 100 * off),
                        "choose a higher one");
  } else if (settings.baud > highest) {
    diagnostics.warning(
        program.file, settings.baud_position,
        fmt::format("{} has {:.1f} clocks a bit, too few for a sender that is 2 % off", what,
                    clock / static_cast<double>(settings.baud)),
        fmt::format("choose {} or less", highest));
  }
}

void check_pwm(const Program& program, const Instruction& pwm, const isa::Config& config,
               Diagnostics& diagnostics) {
  const std::int32_t hertz = pwm.operand(1).value;
  const double clocks = static_cast<double>(config.clock_hz) / hertz;
  const std::string remedy =
      fmt::format("choose {} Hz or less", static_cast<int>(config.clock_hz / kClocksForPercent));
  if (clocks < 2) {
    diagnostics.error(
        program.file, pwm.position,
        fmt::format("{}: the clock of configuration {}, {}, cannot make this frequency", pwm.text,
                    config.name, megahertz(config)),
        remedy);
  } else if (clocks < kClocksForPercent) {
    diagnostics.warning(
        program.file, pwm.position,
        fmt::format(
            "{}: with the clock of configuration {}, {}, the duty comes in steps of {:.1f} %",
            pwm.text, config.name, megahertz(config), 100 / clocks),
        remedy);
  }
}

}  // namespace

void check_peripherals(const Program& program, const isa::Config& config,
                       Diagnostics& diagnostics) {
  if (!program.ldmicro) return;
  if (uses_uart(program)) check_baud(program, config, diagnostics);
  for (const Instruction& instruction : program.instructions) {
    if (instruction.op == Op::SetPwm) check_pwm(program, instruction, config, diagnostics);
  }
}

}  // namespace rung

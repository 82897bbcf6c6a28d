// SPDX-License-Identifier: Apache-2.0
#include "driver/peripherals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rung {
namespace {

// The receiver looks at each bit several times; below this it cannot.
constexpr double kLeastClocksABit = 8;
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

// Bits last a whole number of clocks.
void check_baud(const Program& program, const isa::Config& config, Diagnostics& diagnostics) {
  const LdmicroSettings& settings = *program.ldmicro;
  const auto baud = static_cast<double>(settings.baud);
  const double clocks = std::round(config.clock_hz / baud);
  if (clocks < kLeastClocksABit) {
    diagnostics.error(
        program.file, settings.baud_position,
        fmt::format("BAUD={}: the clock of configuration {}, {}, cannot make it", settings.baud,
                    config.name, megahertz(config)),
        fmt::format("the highest is {}", static_cast<int>(config.clock_hz / kLeastClocksABit)));
    return;
  }
  const double made = config.clock_hz / clocks;
  if (std::abs(made - baud) <= kMostBaudError * baud) return;
  diagnostics.warning(
      program.file, settings.baud_position,
      fmt::format("BAUD={}: the clock of configuration {}, {}, makes {:.0f}, {:+.1f} % off",
                  settings.baud, config.name, megahertz(config), made, 100 * (made - baud) / baud),
      "choose a lower one, or one that divides the clock");
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

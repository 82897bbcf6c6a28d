// SPDX-License-Identifier: Apache-2.0
// LDmicro: timers, which count scans, counters, and shift registers.
#include "reference/reference.hpp"

namespace rung {
namespace {

std::int16_t wrapped(int value) { return static_cast<std::int16_t>(value); }

}  // namespace

void Reference::execute_timer(const Instruction& instruction) {
  const Device variable = instruction.operand(0).device;
  const int period = instruction.operand(1).value;
  const bool on = now_.result;
  // A TOF is not to run at power-up: it begins as one that has run out.
  const bool starts = instruction.op == Op::Tof && time_.scan == 0;
  const int value = starts ? period : get(variable);
  const bool runs = value < period;
  int next = value;
  switch (instruction.op) {
    case Op::Ton:
      next = !on ? 0 : runs ? value + 1 : value;
      now_.result = on && !runs;
      break;
    case Op::Tof:
      next = on ? 0 : runs ? value + 1 : value;
      now_.result = on || runs;
      break;
    default:
      next = on && runs ? value + 1 : value;
      now_.result = !runs;
  }
  change(variable, wrapped(next));
}

void Reference::execute_counter(const Instruction& instruction) {
  const Device variable = instruction.operand(0).device;
  const int limit = instruction.operand(1).value;
  std::int16_t value = get(variable);
  if (rises()) {
    value = wrapped(instruction.op == Op::Ctd ? value - 1 : value + 1);
    // A value that something else has put above the limit stays until then.
    if (instruction.op == Op::Ctc && value >= wrapped(limit + 1)) value = 0;
  }
  if (instruction.op != Op::Ctc) now_.result = value >= limit;
  change(variable, value);
}

// From the last stage, so that each one takes what the stage before it had.
void Reference::shift_stages(const Instruction& instruction) {
  if (!rises()) return;
  for (std::size_t i = instruction.operands.size(); i-- > 1;) {
    change(instruction.operand(i).device, get(instruction.operand(i - 1).device));
  }
}

}  // namespace rung

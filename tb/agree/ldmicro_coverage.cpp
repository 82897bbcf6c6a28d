// SPDX-License-Identifier: Apache-2.0
#include "agree/ldmicro_coverage.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <vector>

#include "rungs/ports.hpp"

namespace rung::tb {
namespace {

// What an element is counted as: its word in the file, of a COIL or CONTACTS with its kind.
std::string key_of(const Instruction& instruction) {
  switch (instruction.op) {
    case Op::And:
      return "CONTACTS";
    case Op::Ani:
      return "CONTACTS negated";
    case Op::Out:
      return "COIL";
    case Op::Outi:
      return "COIL negated";
    case Op::Set:
      return "COIL set";
    case Op::Rst:
      return "COIL reset";
    default:
      return instruction.text.substr(0, instruction.text.find(' '));
  }
}

std::int32_t value_of(const Reference& reference, const Operand& operand) {
  return operand.kind == Operand::Kind::Device ? reference.get(operand.device) : operand.value;
}

// The values of an instruction's operands, before it is executed.
std::vector<std::int32_t> values_of(const Reference& reference, const Instruction& instruction) {
  std::vector<std::int32_t> values;
  for (const Operand& operand : instruction.operands) {
    values.push_back(value_of(reference, operand));
  }
  return values;
}

bool beyond_16_bits(std::int64_t value) { return value < -32768 || value > 32767; }

// Of an executed ADD, SUB or MUL.
bool wraps(Op op, std::int64_t a, std::int64_t b) {
  return beyond_16_bits(op == Op::Add ? a + b : op == Op::Sub ? a - b : a * b);
}

const char* division(std::int32_t a, std::int32_t b) {
  if (b == 0) return "DIV by zero";
  if (a == -32768 && b == -1) return "DIV beyond 16 bits";
  return a % b != 0 && (a < 0) != (b < 0) ? "DIV rounds up" : nullptr;
}

// How many rows of a LOOK_UP_TABLE are taken, and where a PIECEWISE_LINEAR's index lies.
const char* look_up(const Instruction& instruction, std::int32_t index) {
  const bool same = instruction.operand(0) == instruction.operand(1);
  int taken = 0;
  for (std::size_t row = 0; row < instruction.table.size(); ++row) {
    if (index != static_cast<std::int32_t>(row)) continue;
    ++taken;
    if (same) index = instruction.table[row];
  }
  return taken == 0   ? "LOOK_UP_TABLE beyond"
         : taken == 1 ? "LOOK_UP_TABLE row"
                      : "LOOK_UP_TABLE several rows";
}

const char* interpolate(const Instruction& instruction, std::int32_t index) {
  const std::vector<std::int32_t>& points = instruction.table;
  if (points.size() < 4) return "PIECEWISE_LINEAR of one point";
  if (index < points[0]) return "PIECEWISE_LINEAR below";
  return index > points[points.size() - 2] ? "PIECEWISE_LINEAR above" : "PIECEWISE_LINEAR within";
}

// What an element did that the conditions do not show; nothing in most cases. `values` are those of
// its operands before, `on` the condition that came in.
const char* event(const Instruction& instruction, const std::vector<std::int32_t>& values, bool on,
                  const Reference& after) {
  switch (instruction.op) {
    case Op::Add:
    case Op::Sub:
    case Op::Mul:
      if (!on || !wraps(instruction.op, values[0], values[1])) return nullptr;
      return instruction.op == Op::Add   ? "ADD wraps"
             : instruction.op == Op::Sub ? "SUB wraps"
                                         : "MUL wraps";
    case Op::Div:
      return on ? division(values[0], values[1]) : nullptr;
    case Op::LookUpTable:
      return on ? look_up(instruction, values[1]) : nullptr;
    case Op::PiecewiseLinear:
      return on ? interpolate(instruction, values[1]) : nullptr;
    case Op::Ctu:
    case Op::Ctc: {
      const std::int32_t now = value_of(after, instruction.operand(0));
      if (now == values[0] || now == values[0] + 1) return nullptr;
      return instruction.op == Op::Ctu ? "CTU wraps" : "CTC begins again";
    }
    case Op::Ctd:
      return value_of(after, instruction.operand(0)) > values[0] ? "CTD wraps" : nullptr;
    case Op::ShiftRegister:
      return values_of(after, instruction) != values ? "SHIFT_REGISTER shifts" : nullptr;
    case Op::Ton:
    case Op::Tof:
    case Op::Rto:
      return values[0] > values[1] ? "timer beyond its limit"
             : values[0] < 0       ? "timer below zero"
                                   : nullptr;
    case Op::Persist:
      return values_of(after, instruction) != values ? "PERSIST restores" : nullptr;
    case Op::FormattedString:
      return values.empty() ? nullptr : values[0] < 0 ? "string below zero" : nullptr;
    default:
      return nullptr;
  }
}

}  // namespace

void LdmicroCoverage::run_scan(const Program& program, Reference& reference) {
  reference.begin_scan();
  while (true) {
    const std::size_t index = reference.next_instruction();
    if (index >= program.instructions.size()) break;
    const Instruction& instruction = program.instructions[index];
    const bool in = reference.result();
    const std::vector<std::int32_t> values = values_of(reference, instruction);
    const std::size_t sent = reference.sent().size();
    const bool memory_ready = reference.get(port::persist_ready) != 0;
    if (!reference.step()) break;
    const bool out = reference.result();
    if (instruction.op == Op::Rung) {
      count(out ? "rung on" : "rung off");
      continue;
    }
    if (is_frame(instruction.op)) continue;
    const std::string key = key_of(instruction);
    count(fmt::format("{} {:d}>{:d}", key, in, out));
    if (const char* what = event(instruction, values, in, reference)) count(what);
    if (reference.sent().size() > sent) count(key + " sends");
    if (memory_ready && reference.get(port::persist_ready) == 0) count("PERSIST keeps");
  }
}

void LdmicroCoverage::count_shape(const Program& program) {
  std::size_t depth = 0;
  std::vector<int> branches;
  for (std::size_t i = 0; i < program.instructions.size(); ++i) {
    const Op op = program.instructions[i].op;
    const Op before = i == 0 ? Op::Nop : program.instructions[i - 1].op;
    if (op == Op::Parallel) {
      count(fmt::format("PARALLEL in {}", depth++));
      branches.push_back(1);
    }
    if (op == Op::Branch) ++branches.back();
    if ((op == Op::Branch || op == Op::Join) && (before == Op::Parallel || before == Op::Branch)) {
      count("branch without elements");
    }
    if (op == Op::Join) {
      --depth;
      if (branches.back() == 1) count("PARALLEL of one branch");
      branches.pop_back();
    }
    if (op == Op::Rung && before == Op::Rung) count("rung without elements");
    if (op == Op::Comment) count("COMMENT");
  }
  for (const auto& [device, name] : program.names) {
    if (name.ends_with(":w")) count("name of both kinds");
  }
}

void LdmicroCoverage::add(const LdmicroCoverage& other) {
  for (const auto& [key, times] : other.counts_) counts_[key] += times;
}

std::uint64_t LdmicroCoverage::of(const std::string& key) const {
  const auto found = counts_.find(key);
  return found == counts_.end() ? 0 : found->second;
}

}  // namespace rung::tb

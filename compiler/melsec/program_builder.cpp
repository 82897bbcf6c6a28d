// SPDX-License-Identifier: Apache-2.0
#include "melsec/program_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "melsec/operands.hpp"
#include "melsec/ranges.hpp"
#include "melsec/suggest.hpp"
#include "rungs/devices.hpp"
#include "rungs/flow.hpp"
#include "rungs/structure.hpp"

namespace rung {
namespace {

std::string_view role_name(Role role) {
  switch (role) {
    case Role::Contact:
    case Role::Edge:
    case Role::Coil:
    case Role::Reset:
    case Role::Bit:
      return "the device";
    case Role::SourceBits:
    case Role::SourceBlock:
    case Role::SourceWords:
      return "first source";
    case Role::TargetBits:
    case Role::TargetBlock:
    case Role::TargetWords:
      return "first target";
    case Role::State:
      return "the state";
    case Role::Timer:
      return "timer";
    case Role::Counter:
      return "counter";
    case Role::Preset:
      return "preset";
    case Role::Target:
    case Role::WordTarget:
      return "target";
    case Role::Count:
      return "count";
    case Role::Repeats:
      return "how often";
    case Role::Pointer:
      return "the pointer";
    case Role::Level:
      return "nesting level";
    case Role::First:
      return "first device";
    case Role::Last:
      return "last device";
    case Role::Source:
    case Role::None:
      break;
  }
  return "source";
}

// What resolve_flow() looks at.
bool is_flow(Op op) {
  return op == Op::Mc || op == Op::Cj || op == Op::Call || op == Op::Stl ||
         effect_of(op) == Effect::Between;
}

// "two operands: source, target"
std::string operand_names(const SourceInstruction& row, Dialect dialect) {
  static constexpr std::string_view kNumbers[] = {"no", "one", "two", "three", "four"};
  const int most = operand_count(row, dialect).most;
  if (most == 0) return "no operand";
  if (operand_count(row, dialect).least == 2 && most == 3) {
    return "two operands (source, target) or three (source, source, target)";
  }
  std::string names;
  for (int i = 0; i < most; ++i) {
    if (i > 0) names += ", ";
    names += role_name(row.roles[static_cast<std::size_t>(i)]);
  }
  return fmt::format("{} operand{}: {}", kNumbers[most], most == 1 ? "" : "s", names);
}

// Turns the statements of one program into instructions.
class ProgramBuilder {
 public:
  ProgramBuilder(Program& program, Diagnostics& diagnostics)
      : program_(program), diagnostics_(diagnostics) {}

  void add(const Statement& statement) {
    const ListWord& name = statement.name;
    if (!statement.forms.empty()) {
      known(statement);
    } else if (statement.unsupported) {
      structure_.push_back({statement.unsupported->effect, name.upper, name.position});
      error(name, fmt::format("{}: {}", name.upper, statement.unsupported->reason),
            statement.unsupported->mend);
    } else if (is_label(name.upper)) {
      label(name);
    } else if (is_interrupt_label(name.upper)) {
      structure_.push_back({Effect::None, name.upper, name.position});
      error(name,
            fmt::format("{}: begins an interrupt program, which a constant scan cannot have",
                        name.upper),
            "do the work in the scan: it is shorter than a usual interrupt period");
    } else {
      structure_.push_back({Effect::Unknown, name.upper, name.position});
      unknown(name);
    }
  }

  const std::vector<StructureItem>& structure() const { return structure_; }
  // True if every label, jump, loop and zone of the source is in the program.
  bool flow_is_whole() const { return flow_is_whole_; }

 private:
  void unknown(const ListWord& name) {
    flow_is_whole_ = false;
    std::string mend;
    if (looks_like_operand(name.upper)) {
      mend = "this is an operand: its instruction stands before it, on the same line";
    } else if (const auto near = suggestion(name.upper); !near.empty()) {
      mend = fmt::format("did you mean {}?", near);
    }
    error(name, fmt::format("{} is not an instruction", shown(name.text)), std::move(mend));
  }

  // The search is slow, and a wrong file holds the same unknown words many times.
  std::string_view suggestion(const std::string& word) {
    const auto [found, is_new] = suggestions_.try_emplace(word);
    if (is_new) found->second = suggest_instruction(word);
    return found->second;
  }

  void label(const ListWord& name) {
    structure_.push_back({effect_of(Op::Label), name.upper, name.position});
    OperandReader reader(program_.file, program_.dialect, "label", diagnostics_);
    const auto pointer = reader.read(name, Role::Pointer, 16);
    flow_is_whole_ = flow_is_whole_ && pointer.has_value();
    if (!pointer) return;
    Instruction instruction;
    instruction.op = Op::Label;
    instruction.operands.push_back(*pointer);
    instruction.position = name.position;
    instruction.text = name.text;
    program_.instructions.push_back(std::move(instruction));
  }

  // The form that the name has in the dialect and with these operands.
  const InstructionForm* choose(const Statement& statement) const {
    const InstructionForm* chosen = nullptr;
    for (const InstructionForm& form : statement.forms) {
      if ((form.row->dialects & dialect_bit(program_.dialect)) == 0) continue;
      if (chosen == nullptr) chosen = &form;
      if (statement.operands.empty()) continue;
      // OUT is three instructions.
      const auto device = timer_or_counter(statement.operands[0].upper, program_.dialect);
      if (device && ((form.row->op == Op::OutT && is_timer(device->kind)) ||
                     (form.row->op == Op::OutC && is_counter(device->kind)))) {
        return &form;
      }
    }
    return chosen;
  }

  void known(const Statement& statement) {
    const Dialect dialect = program_.dialect;
    const std::string& name = statement.name.upper;
    const InstructionForm* form = choose(statement);
    if (form == nullptr) {
      flow_is_whole_ = false;
      const SourceInstruction& row = *statement.forms.front().row;
      structure_.push_back({effect_of(row.op), name, statement.name.position});
      const std::string_view other = instruction_name(row.op, dialect);
      std::string mend = other.empty() ? "" : fmt::format("write {}", other);
      for (const Dialect each : {Dialect::Fx, Dialect::Q}) {
        if (row.dialects != dialect_bit(each)) continue;
        mend += fmt::format("{}use --dialect {}", mend.empty() ? "" : ", or ", dialect_name(each));
      }
      error(statement.name,
            fmt::format("{}: no instruction of dialect {}", name, dialect_name(dialect)),
            std::move(mend));
      return;
    }
    structure_.push_back({effect_of(form->row->op), name, statement.name.position});
    Instruction instruction;
    instruction.op = form->row->op;
    instruction.width = form->width;
    instruction.pulse = form->pulse;
    instruction.relation = form->row->relation;
    instruction.position = statement.name.position;
    instruction.text = statement.name.text;
    for (const ListWord& operand : statement.operands) {
      instruction.text += ' ';
      instruction.text += operand.text;
    }
    if (operands(statement, *form->row, instruction)) {
      program_.instructions.push_back(std::move(instruction));
    } else if (is_flow(form->row->op)) {
      flow_is_whole_ = false;
    }
  }

  bool operands(const Statement& statement, const SourceInstruction& row, Instruction& out) {
    OperandReader reader(program_.file, program_.dialect, statement.name.upper, diagnostics_);
    const std::vector<ListWord>& words = statement.operands;
    // A device that is not there often brings operands of its own, and a comma makes one word of
    // two: that is then the one thing to report.
    const auto bad = std::find_if(words.begin(), words.end(), [](const ListWord& word) {
      return word.upper.find(',') != std::string::npos || unsupported_operand(word.upper);
    });
    if (bad != words.end()) {
      reader.refuse(*bad);
      return false;
    }
    // So is a timer that the dialect does not have, with its preset.
    const auto most = static_cast<std::size_t>(operand_count(row, program_.dialect).most);
    if (most > 0 && words.size() > most && !reader.read(words[0], row.roles[0], out.width)) {
      return false;
    }
    if (!right_count(statement, row)) return false;
    const std::size_t roles = static_cast<std::size_t>(row.operands());
    out.two_operand = words.size() < roles;
    bool good = true;
    for (std::size_t i = 0; i < words.size(); ++i) {
      const Role role = row.roles[out.two_operand ? i + 1 : i];
      if (role == Role::Preset && row.op == Op::OutC && !out.operands.empty() &&
          is_32_bit_counter(out.operands[0].device, program_.dialect)) {
        out.width = 32;
      }
      auto operand = reader.read(words[i], role, out.width);
      good = good && operand.has_value();
      if (operand) out.operands.push_back(*operand);
    }
    if (!good) return false;
    if (out.two_operand) out.operands.insert(out.operands.begin(), out.operands.back());
    out.double_width =
        program_.dialect != Dialect::Paper && (out.op == Op::Mul || out.op == Op::Div);
    if (out.op == Op::OutT) {
      out.base_us = timer_range(out.operands[0].device, program_.dialect).base_us;
      if (row.name == kHighSpeedTimer) out.base_us /= 10;
    }
    return check_ranges(out, row, words, program_.dialect, reader);
  }

  bool right_count(const Statement& statement, const SourceInstruction& row) {
    const OperandCount count = operand_count(row, program_.dialect);
    const int given = static_cast<int>(statement.operands.size());
    if (given >= count.least && given <= count.most) return true;
    const std::string& name = statement.name.upper;
    const std::string takes = operand_names(row, program_.dialect);
    if (given > count.most) {
      const ListWord& surplus = statement.operands[static_cast<std::size_t>(count.most)];
      error(surplus, fmt::format("{} {}: one operand too many", name, shown(surplus.upper)),
            fmt::format("{} takes {}", name, takes));
      return false;
    }
    std::string mend = fmt::format("{} takes {}", name, takes);
    if (row.has(kTwoOperands) && given == 2) {
      mend = fmt::format("write {0} {2} {1} {2}, or use --dialect paper", name,
                         shown(statement.operands[0].upper), shown(statement.operands[1].upper));
    }
    error(statement.name,
          fmt::format("{}: {} of its operands {} missing", name, count.least - given,
                      count.least - given == 1 ? "is" : "are"),
          std::move(mend));
    return false;
  }

  void error(const ListWord& word, std::string what, std::string mend = {}) {
    diagnostics_.error(program_.file, word.position, std::move(what), std::move(mend));
  }

  Program& program_;
  Diagnostics& diagnostics_;
  std::vector<StructureItem> structure_;
  bool flow_is_whole_ = true;
  std::unordered_map<std::string, std::string_view> suggestions_;
};

}  // namespace

Dialect dialect_of(const std::vector<Statement>& statements) {
  bool q = false;
  for (const Statement& statement : statements) {
    if (statement.forms.empty()) continue;
    const SourceInstruction& row = *statement.forms.front().row;
    const bool arithmetic = row.op >= Op::Add && row.op <= Op::Div;
    const bool is_q = row.dialects == dialect_bit(Dialect::Q);
    if (row.dialects == dialect_bit(Dialect::Paper) ||
        (arithmetic && !is_q && statement.operands.size() == 2)) {
      return Dialect::Paper;
    }
    q = q || (arithmetic && is_q);
  }
  return q ? Dialect::Q : Dialect::Fx;
}

std::optional<Program> build_program(const StatementList& list, const std::string& file,
                                     Dialect dialect, bool whole, Diagnostics& diagnostics) {
  const int errors_before = diagnostics.error_count();
  Program program;
  program.file = file;
  program.dialect = dialect;
  ProgramBuilder builder(program, diagnostics);
  for (const Statement& statement : list.statements) builder.add(statement);
  if (whole) {
    check_structure(program.file, dialect, builder.structure(), diagnostics);
    // Where a word was not understood, it may have been the label or zone that is missed.
    if (builder.flow_is_whole()) resolve_flow(program, diagnostics);
  }
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  program.networks = split_networks(program.instructions);
  return program;
}

}  // namespace rung

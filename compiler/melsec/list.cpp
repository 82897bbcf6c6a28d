// SPDX-License-Identifier: Apache-2.0
#include "melsec/list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <unordered_map>
#include <utility>

#include "melsec/operands.hpp"
#include "melsec/statements.hpp"
#include "melsec/suggest.hpp"
#include "rungs/structure.hpp"

namespace rung {
namespace {

Dialect dialect_of(const std::vector<Statement>& statements) {
  bool q = false;
  for (const Statement& statement : statements) {
    if (statement.known == nullptr) continue;
    const bool arithmetic = statement.known->form == OperandForm::Arithmetic;
    const bool is_q = statement.known->dialects == dialect_bit(Dialect::Q);
    if (statement.known->dialects == dialect_bit(Dialect::Paper) ||
        (arithmetic && !is_q && statement.operands.size() == 2)) {
      return Dialect::Paper;
    }
    q = q || is_q;
  }
  return q ? Dialect::Q : Dialect::Fx;
}

bool needs_end(const std::string& file) {
  std::string lower = file;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return !lower.ends_with(".esc");
}

std::string_view operand_names(const SourceInstruction& instruction, Dialect dialect) {
  switch (instruction.form) {
    case OperandForm::None:
      return "no operand";
    case OperandForm::Contact:
    case OperandForm::Coil:
    case OperandForm::Reset:
      return "one operand: the device";
    case OperandForm::Move:
      return "two operands: source, target";
    case OperandForm::Arithmetic:
      break;
  }
  return operand_count(instruction.form, dialect).least == 3
             ? "three operands: source, source, target"
             : "two operands (source, target) or three (source, source, target)";
}

// Turns the statements of one list into instructions.
class ListParser {
 public:
  ListParser(Program& program, Diagnostics& diagnostics)
      : program_(program), diagnostics_(diagnostics) {}

  void add(const Statement& statement) {
    if (statement.known != nullptr) {
      structure_.push_back(
          {effect_of(statement.known->op), statement.name.upper, statement.name.position});
      known(statement, *statement.known);
    } else if (statement.unsupported) {
      structure_.push_back(
          {statement.unsupported->effect, statement.name.upper, statement.name.position});
      error(statement.name,
            fmt::format("{}: {}", statement.name.upper, statement.unsupported->reason),
            statement.unsupported->mend);
    } else if (is_label(statement.name.upper)) {
      structure_.push_back({Effect::None, statement.name.upper, statement.name.position});
      error(statement.name,
            fmt::format("{}: a label; jumps, subroutines and interrupts are not supported yet",
                        statement.name.upper));
    } else {
      structure_.push_back({Effect::Unknown, statement.name.upper, statement.name.position});
      unknown(statement);
    }
  }

  const std::vector<StructureItem>& structure() const { return structure_; }

 private:
  void unknown(const Statement& statement) {
    std::string mend;
    if (looks_like_operand(statement.name.upper)) {
      mend = "this is an operand: its instruction stands before it, on the same line";
    } else if (const auto near = suggestion(statement.name.upper); !near.empty()) {
      mend = fmt::format("did you mean {}?", near);
    }
    error(statement.name, fmt::format("{} is not an instruction", shown(statement.name.text)),
          std::move(mend));
  }

  // The search is slow, and a wrong file holds the same unknown words many times.
  std::string_view suggestion(const std::string& word) {
    const auto [found, is_new] = suggestions_.try_emplace(word);
    if (is_new) found->second = suggest_instruction(word);
    return found->second;
  }

  void known(const Statement& statement, const SourceInstruction& row) {
    const Dialect dialect = program_.dialect;
    const std::string& name = statement.name.upper;
    if ((row.dialects & dialect_bit(dialect)) == 0) {
      std::string mend = fmt::format("write {}", instruction_name(row.op, dialect));
      if (row.dialects == dialect_bit(Dialect::Q)) mend += ", or use --dialect q";
      error(statement.name,
            fmt::format("{}: no instruction of dialect {}", name, dialect_name(dialect)),
            std::move(mend));
      return;
    }
    Instruction instruction;
    instruction.op = row.op;
    instruction.position = statement.name.position;
    instruction.text = statement.name.text;
    for (const ListWord& operand : statement.operands) {
      instruction.text += ' ';
      instruction.text += operand.text;
    }
    if (operands(statement, row, instruction)) {
      program_.instructions.push_back(std::move(instruction));
    }
  }

  bool operands(const Statement& statement, const SourceInstruction& row, Instruction& out) {
    OperandReader reader(program_.file, program_.dialect, statement.name.upper, diagnostics_);
    const std::vector<ListWord>& words = statement.operands;
    // A device that is not there yet often brings operands of its own (OUT T0 K50), and a comma
    // makes one word of two: that is then the one thing to report.
    const auto bad = std::find_if(words.begin(), words.end(), [](const ListWord& word) {
      return word.upper.find(',') != std::string::npos || unsupported_operand(word.upper);
    });
    if (bad != words.end()) {
      reader.source(*bad);
      return false;
    }
    if (!right_count(statement, row)) return false;
    switch (row.form) {
      case OperandForm::None:
        return true;
      case OperandForm::Contact:
        return assign(out.device, reader.contact(words[0]));
      case OperandForm::Coil:
        return assign(out.device, reader.coil(words[0]));
      case OperandForm::Reset:
        return assign(out.device, reader.coil_or_word(words[0]));
      case OperandForm::Move: {
        const bool good = assign(out.sources[0], reader.source(words[0]));
        return assign(out.device, reader.target(words[1], false)) && good;
      }
      case OperandForm::Arithmetic:
        break;
    }
    return arithmetic(words, reader, out);
  }

  bool arithmetic(const std::vector<ListWord>& words, OperandReader& reader, Instruction& out) {
    out.double_width =
        program_.dialect != Dialect::Paper && (out.op == Op::Mul || out.op == Op::Div);
    out.two_operand = words.size() == 2;
    bool good = assign(out.sources[out.two_operand ? 1 : 0], reader.source(words[0]));
    if (!out.two_operand) good = assign(out.sources[1], reader.source(words[1])) && good;
    good = assign(out.device, reader.target(words.back(), out.double_width)) && good;
    if (good && out.two_operand) {
      out.sources[0].constant = false;
      out.sources[0].device = out.device;
    }
    return good;
  }

  bool right_count(const Statement& statement, const SourceInstruction& row) {
    const OperandCount count = operand_count(row.form, program_.dialect);
    const int given = static_cast<int>(statement.operands.size());
    if (given >= count.least && given <= count.most) return true;
    const std::string& name = statement.name.upper;
    const std::string_view takes = operand_names(row, program_.dialect);
    if (given > count.most) {
      const ListWord& surplus = statement.operands[static_cast<std::size_t>(count.most)];
      error(surplus, fmt::format("{} {}: one operand too many", name, shown(surplus.upper)),
            fmt::format("{} takes {}", name, takes));
      return false;
    }
    std::string mend = fmt::format("{} takes {}", name, takes);
    if (row.form == OperandForm::Arithmetic && given == 2) {
      mend = fmt::format("write {0} {2} {1} {2}, or use --dialect paper", name,
                         shown(statement.operands[0].upper), shown(statement.operands[1].upper));
    }
    error(statement.name,
          fmt::format("{}: {} of its operands {} missing", name, count.least - given,
                      count.least - given == 1 ? "is" : "are"),
          std::move(mend));
    return false;
  }

  template <typename Value>
  static bool assign(Value& to, const std::optional<Value>& from) {
    if (from) to = *from;
    return from.has_value();
  }

  void error(const ListWord& word, std::string what, std::string mend = {}) {
    diagnostics_.error(program_.file, word.position, std::move(what), std::move(mend));
  }

  Program& program_;
  Diagnostics& diagnostics_;
  std::vector<StructureItem> structure_;
  std::unordered_map<std::string, std::string_view> suggestions_;
};

}  // namespace

std::optional<Program> parse_list(const SourceText& source, std::optional<Dialect> dialect,
                                  Diagnostics& diagnostics) {
  const int errors_before = diagnostics.error_count();
  const std::vector<ListLine> lines = split_words(source, diagnostics);
  const bool open_comment = diagnostics.error_count() > errors_before;
  const StatementList list = group_words(lines, source.file, diagnostics);
  if (lines.empty() && !open_comment) {
    diagnostics.error(source.file, {}, "there is no instruction in this file");
    return std::nullopt;
  }

  Program program;
  program.file = source.file;
  program.dialect = dialect.value_or(dialect_of(list.statements));
  ListParser parser(program, diagnostics);
  for (const Statement& statement : list.statements) parser.add(statement);
  if (!open_comment)
    check_structure(program.file, program.dialect, parser.structure(), diagnostics);
  if (!list.has_end && !open_comment && needs_end(source.file)) {
    diagnostics.error(source.file, list.end, "the program has no END",
                      "put END after its last instruction; if it was cut off, copy it again");
  }
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  program.networks = split_networks(program.instructions);
  return program;
}

}  // namespace rung

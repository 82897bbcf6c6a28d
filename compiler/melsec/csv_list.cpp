// SPDX-License-Identifier: Apache-2.0
#include "melsec/csv_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "melsec/csv.hpp"
#include "melsec/program_builder.hpp"

namespace rung {
namespace {

enum Column : std::size_t {
  kStep,
  kStatement,
  kInstruction,
  kOperand,
  kBlank,
  kPiStatement,
  kNote
};

bool is_number(const std::string& text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool is_name(const std::string& upper) {
  return upper == "END" || !find_instruction(upper).empty() || is_unsupported_name(upper) ||
         is_label(upper) || is_interrupt_label(upper);
}

// The words of a cell; all of them stand where the cell does.
std::vector<ListWord> words_of(const CsvCell& cell) {
  std::vector<ListWord> words;
  ListWord word;
  const auto end_word = [&] {
    if (word.text.empty()) return;
    word.position = cell.position;
    words.push_back(std::exchange(word, {}));
  };
  for (const char c : cell.text) {
    if (c == ' ' || c == '\t' || c == '\n') {
      end_word();
      continue;
    }
    word.text += c;
    word.upper += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  end_word();
  return words;
}

// The dialect of the controller that a title calls `FXCPU FX3U/FX3UC` or `QCPU (Q mode) Q03UDV`.
std::optional<Dialect> dialect_of_controller(std::string_view name) {
  if (name.starts_with("FX")) return Dialect::Fx;
  for (const std::string_view family : {"QCPU", "LCPU", "RCPU", "QSCPU", "QnACPU"}) {
    if (name.starts_with(family)) return Dialect::Q;
  }
  const bool model = name.size() >= 2 && name[1] >= '0' && name[1] <= '9';
  if (model && (name.front() == 'Q' || name.front() == 'L' || name.front() == 'R')) {
    return Dialect::Q;
  }
  return std::nullopt;
}

// A device-comment file has two columns; of a program at least the instructions stand in the third.
bool is_comment_file(const std::vector<CsvRow>& rows) {
  return rows.size() > 2 && std::all_of(rows.begin(), rows.end(), [](const CsvRow& row) {
           return row.text(kInstruction).empty() && row.text(kOperand).empty();
         });
}

class CsvListReader {
 public:
  CsvListReader(const SourceText& source, std::optional<Dialect> dialect, Diagnostics& diagnostics)
      : file_(source.file), dialect_(dialect), diagnostics_(diagnostics) {}

  CsvProgram read(const std::vector<CsvRow>& rows) {
    for (std::size_t i = head(rows); i < rows.size() && !after_end_; ++i) {
      row(rows[i]);
      if (!program_.list.has_end) program_.list.end = rows[i].cells.front().position;
    }
    return std::move(program_);
  }

 private:
  // Title, controller and headers; gives the index of the first row after them.
  std::size_t head(const std::vector<CsvRow>& rows) {
    std::size_t i = 0;
    const auto others_empty = [&](std::size_t from) {
      return std::all_of(
          rows[i].cells.begin() + static_cast<std::ptrdiff_t>(std::min(from, rows[i].cells.size())),
          rows[i].cells.end(), [](const CsvCell& cell) { return cell.text.empty(); });
    };
    if (i < rows.size() && others_empty(1)) ++i;
    if (i < rows.size() && !is_number(rows[i].text(kStep)) && !rows[i].text(kStep).empty() &&
        others_empty(2) && rows[i].cells.size() > 1) {
      controller(rows[i++].cells[1]);
    }
    if (i < rows.size() && !is_number(rows[i].text(kStep)) && !rows[i].text(kStep).empty() &&
        !is_name(rows[i].text(kInstruction))) {
      ++i;
    }
    return i;
  }

  void controller(const CsvCell& cell) {
    program_.dialect = dialect_of_controller(cell.text);
    if (program_.dialect || dialect_) return;
    diagnostics_.error(
        file_, cell.position,
        fmt::format("{}: not a controller whose programs are known here", shown(cell.text)),
        "the families are FX, Q, L and R; to read it as one of them use --dialect fx or "
        "--dialect q");
  }

  void row(const CsvRow& row) {
    if (!row.text(kStatement).empty()) text(row.cells[kStatement]);
    if (!row.text(kNote).empty()) text(row.cells[kNote]);
    std::vector<ListWord> words;
    if (row.cells.size() > kInstruction) words = words_of(row.cells[kInstruction]);
    const bool has_step = is_number(row.text(kStep));
    const bool begins = !words.empty() && (has_step || is_name(words.front().upper));
    if (row.cells.size() > kOperand) {
      const auto operands = words_of(row.cells[kOperand]);
      words.insert(words.end(), operands.begin(), operands.end());
    }
    if (words.empty()) return;
    if (begins) {
      instruction(row, std::move(words));
    } else if (program_.list.has_end || program_.list.statements.empty()) {
      diagnostics_.error(file_, words.front().position,
                         fmt::format("{}: an operand, and no instruction before it that takes it",
                                     shown(words.front().upper)),
                         "each instruction has a row, and its further operands the rows after it");
      after_end_ = true;
    } else {
      auto& operands = program_.list.statements.back().operands;
      operands.insert(operands.end(), words.begin(), words.end());
    }
  }

  void text(const CsvCell& cell) {
    program_.texts.push_back({program_.list.statements.size(), cell.raw, cell.position});
  }

  void instruction(const CsvRow& row, std::vector<ListWord> words) {
    Statement statement;
    statement.name = std::move(words.front());
    statement.operands.assign(words.begin() + 1, words.end());
    const std::string& name = statement.name.upper;
    if (program_.list.has_end) {
      diagnostics_.error(file_, statement.name.position,
                         fmt::format("{} stands after END, where nothing is executed", name),
                         "remove what follows END, or END itself");
      after_end_ = true;
      return;
    }
    program_.steps.push_back(step(row.text(kStep)));
    if (name == "END") {
      program_.list.has_end = true;
      program_.list.end = statement.name.position;
      return;
    }
    statement.forms = find_instruction(name);
    if (statement.forms.empty()) statement.unsupported = unsupported_instruction(name);
    program_.list.statements.push_back(std::move(statement));
  }

  static int step(const std::string& text) {
    int number = -1;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
  }

  const std::string& file_;
  std::optional<Dialect> dialect_;
  Diagnostics& diagnostics_;
  CsvProgram program_;
  bool after_end_ = false;
};

}  // namespace

bool is_csv_program(const SourceText& source) {
  // Texts may stand before the first instruction, but not so many.
  constexpr std::size_t kFirstLines = 200;
  for (std::size_t i = 0; i < std::min(source.lines.size(), kFirstLines); ++i) {
    const std::u32string& line = source.lines[i];
    if (!line.empty() && line.front() == U'"') return true;
    Diagnostics ignored;
    const std::vector<CsvRow> rows = read_csv({source.file, {line}}, ignored);
    if (rows.empty() || !is_number(rows[0].text(kStep)) || rows[0].cells.size() <= kOperand) {
      continue;
    }
    const std::vector<ListWord> words = words_of(rows[0].cells[kInstruction]);
    if (!words.empty() && is_name(words.front().upper)) return true;
  }
  return false;
}

CsvProgram read_csv_program(const SourceText& source, std::optional<Dialect> dialect,
                            Diagnostics& diagnostics) {
  const std::vector<CsvRow> rows = read_csv(source, diagnostics);
  return CsvListReader(source, dialect, diagnostics).read(rows);
}

std::optional<Program> parse_csv(const SourceText& source, std::optional<Dialect> dialect,
                                 Diagnostics& diagnostics) {
  const int errors_before = diagnostics.error_count();
  const std::vector<CsvRow> rows = read_csv(source, diagnostics);
  if (is_comment_file(rows)) {
    diagnostics.error(source.file, {}, "this is a file of device comments, not a program",
                      "give it with --comments beside the program");
    return std::nullopt;
  }
  const CsvProgram csv = CsvListReader(source, dialect, diagnostics).read(rows);
  // With a broken frame of the file, what is in it cannot be judged.
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  if (csv.list.statements.empty() && !csv.list.has_end) {
    diagnostics.error(source.file, {}, "there is no instruction in this file",
                      "a program has rows of step, line statement, instruction and operand");
    return std::nullopt;
  }
  if (!dialect) dialect = csv.dialect ? csv.dialect : dialect_of(csv.list.statements);
  auto program = build_program(csv.list, source.file, *dialect, true, diagnostics);
  if (!csv.list.has_end) {
    diagnostics.error(source.file, csv.list.end, "the program has no END",
                      "put END after its last instruction; if it was cut off, export it again");
    return std::nullopt;
  }
  return program;
}

}  // namespace rung

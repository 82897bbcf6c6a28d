// SPDX-License-Identifier: Apache-2.0
// Words grouped into instructions with their operands, before anything is known of the dialect.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "melsec/instructions.hpp"
#include "melsec/lexer.hpp"
#include "melsec/unsupported.hpp"

namespace rung {

// One instruction, or a label, as its words. At most one of `forms` and `unsupported` is set; with
// neither, the word is a label or no instruction at all.
struct Statement {
  ListWord name;
  std::vector<ListWord> operands;
  std::span<const InstructionForm> forms;  // all that have this name
  std::optional<Unsupported> unsupported;
};

struct StatementList {
  std::vector<Statement> statements;  // without END
  bool has_end = false;
  SourcePosition end;  // of END, or of the place after the last word
};

// Groups words: an instruction may follow another on the same line, after a blank or `/`; its
// operands stand on its own line; a number before an instruction is its step number and is
// ignored. Instructions after END and numbers without an instruction are errors.
StatementList group_words(const std::vector<ListLine>& lines, const std::string& file,
                          Diagnostics& diagnostics);

}  // namespace rung

// SPDX-License-Identifier: Apache-2.0
#include "melsec/list.hpp"

#include <algorithm>
#include <cctype>

#include "melsec/program_builder.hpp"

namespace rung {
namespace {

bool needs_end(const std::string& file) {
  std::string lower = file;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return !lower.ends_with(".esc");
}

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
  auto program = build_program(list, source.file, dialect.value_or(dialect_of(list.statements)),
                               !open_comment, diagnostics);
  if (!list.has_end && !open_comment && needs_end(source.file)) {
    diagnostics.error(source.file, list.end, "the program has no END",
                      "put END after its last instruction; if it was cut off, copy it again");
  }
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return program;
}

}  // namespace rung

// SPDX-License-Identifier: Apache-2.0
#include "melsec/melsec.hpp"

#include <algorithm>
#include <cctype>
#include <string>

#include "melsec/csv_list.hpp"
#include "melsec/list.hpp"

namespace rung {
namespace {

bool has_separator(const SourceText& source) {
  return std::any_of(source.lines.begin(), source.lines.end(), [](const std::u32string& line) {
    return line.find_first_of(U"\t,\"") != std::u32string::npos;
  });
}

// By its suffix; but a plain list stays one, whatever it is called.
bool is_csv(const SourceText& source) {
  std::string lower = source.file;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (lower.ends_with(".csv")) return has_separator(source);
  return is_csv_program(source);
}

}  // namespace

std::optional<Program> parse_melsec(const SourceText& source, std::optional<Dialect> dialect,
                                    Diagnostics& diagnostics) {
  return is_csv(source) ? parse_csv(source, dialect, diagnostics)
                        : parse_list(source, dialect, diagnostics);
}

}  // namespace rung

// SPDX-License-Identifier: Apache-2.0
// Text files in and out: decoding to lines of characters, and writing a file whole or not at all.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "source/diagnostics.hpp"

namespace rung {

// A decoded text. `lines[0]` is line 1; a column is an index into a line plus 1. Lines hold no line
// end; a text that ends with one has no empty last line.
struct SourceText {
  std::string file;  // as the user named it; "-" is standard input
  std::vector<std::u32string> lines;
};

// Largest file that is read; a list of 16,384 steps is a hundredth of it.
inline constexpr std::size_t kMaxSourceBytes = 64U << 20U;

// The bytes of `path`, or of standard input for "-". Nothing, with an error at 1:1, when it cannot
// be read or is larger than kMaxSourceBytes.
std::optional<std::string> read_bytes(const std::string& path, Diagnostics& diagnostics);

// `bytes` as text: UTF-8 or UTF-16 (either order) with or without byte order mark, or Shift-JIS
// where it is no UTF-8; lines end with LF, CRLF or CR. Nothing, with an error, when they are empty,
// binary, or not valid in their encoding.
std::optional<SourceText> decode_text(std::string_view bytes, const std::string& file,
                                      Diagnostics& diagnostics);

// read_bytes and decode_text.
std::optional<SourceText> read_text(const std::string& path, Diagnostics& diagnostics);

// `text` as UTF-8.
std::string to_utf8(std::u32string_view text);

// `word` (UTF-8) for a message: cut after 40 characters.
std::string shown(std::string_view word);

// Writes `contents` to `path`, or to standard output for "-": to a temporary name in the same
// directory first, then renamed, so that a failure leaves nothing behind and an old file untouched.
// What is not a regular file (a pipe, /dev/null) is written directly. False, with an error at 1:1,
// when that fails.
bool write_file(const std::string& path, std::string_view contents, Diagnostics& diagnostics);

}  // namespace rung

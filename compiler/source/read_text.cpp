// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <utf8.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <utility>

#include "source/code_page.hpp"
#include "source/text_file.hpp"

namespace rung {
namespace {

constexpr SourcePosition kWholeFile{1, 1};
constexpr std::string_view kEncodings = "save it as UTF-8, or as UTF-16 with a byte order mark";

// The place of the character after `text`.
SourcePosition end_of(std::u32string_view text) {
  SourcePosition position;
  for (const char32_t c : text) {
    if (c == U'\n') {
      ++position.line;
      position.column = 1;
    } else {
      ++position.column;
    }
  }
  return position;
}

// Characters that no text holds.
bool is_binary(char32_t c) {
  return (c < 0x20 && c != U'\t' && c != U'\n' && c != U'\r' && c != U'\f') ||
         (c >= 0x7F && c < 0xA0);
}

// As Windows writes Shift-JIS; nothing if the bytes are not valid in it.
std::optional<std::u32string> decode_shift_jis(std::string_view bytes) {
  const auto converted = decode(bytes, CodePage::Japanese);
  if (!converted) return std::nullopt;
  std::u32string text;
  utf8::unchecked::utf8to32(converted->begin(), converted->end(), std::back_inserter(text));
  return text;
}

// UTF-16 without a byte order mark, as far as it can be told: it begins with an ASCII character.
bool is_utf16(std::string_view bytes, bool big_endian) {
  return bytes.size() >= 4 && (bytes[0] == '\0') == big_endian &&
         (bytes[1] == '\0') != big_endian && (bytes[2] == '\0') == big_endian &&
         (bytes[3] == '\0') != big_endian;
}

std::optional<std::u32string> decode_utf8(std::string_view bytes, const std::string& file,
                                          Diagnostics& diagnostics) {
  std::u32string text;
  const auto bad = utf8::find_invalid(bytes.begin(), bytes.end());
  utf8::unchecked::utf8to32(bytes.begin(), bad, std::back_inserter(text));
  if (bad == bytes.end()) return text;
  // Japanese tools write Shift-JIS, and nothing in it says so.
  if (auto japanese = decode_shift_jis(bytes)) return japanese;
  diagnostics.error(file, end_of(text),
                    fmt::format("the byte 0x{:02X} is valid neither in UTF-8 nor in Shift-JIS",
                                static_cast<unsigned char>(*bad)),
                    std::string(kEncodings));
  return std::nullopt;
}

std::optional<std::u32string> decode_utf16(std::string_view bytes, bool big_endian,
                                           const std::string& file, Diagnostics& diagnostics) {
  std::u32string text;
  const std::size_t units = bytes.size() / 2;
  const auto unit = [&](std::size_t i) {
    const std::size_t low = 2 * i + (big_endian ? 1 : 0);
    const std::size_t high = 2 * i + (big_endian ? 0 : 1);
    return static_cast<char32_t>(static_cast<unsigned char>(bytes[low]) |
                                 static_cast<unsigned char>(bytes[high]) << 8);
  };
  const auto is_high = [](char32_t u) { return u >= 0xD800 && u < 0xDC00; };
  const auto is_low = [](char32_t u) { return u >= 0xDC00 && u < 0xE000; };
  for (std::size_t i = 0; i < units; ++i) {
    char32_t c = unit(i);
    if (is_high(c) && i + 1 < units && is_low(unit(i + 1))) {
      c = 0x10000 + ((c - 0xD800) << 10U) + (unit(++i) - 0xDC00);
    } else if (is_high(c) || is_low(c)) {
      diagnostics.error(file, end_of(text), "half a surrogate pair: not valid UTF-16",
                        std::string(kEncodings));
      return std::nullopt;
    }
    text.push_back(c);
  }
  if (bytes.size() % 2 != 0) {
    diagnostics.error(file, end_of(text), "the file ends within a UTF-16 character",
                      "it was cut off: copy or export it again");
    return std::nullopt;
  }
  return text;
}

std::vector<std::u32string> split_lines(std::u32string_view text) {
  std::vector<std::u32string> lines;
  std::u32string line;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != U'\n' && text[i] != U'\r') {
      line.push_back(text[i]);
      continue;
    }
    if (text[i] == U'\r' && i + 1 < text.size() && text[i + 1] == U'\n') ++i;
    lines.push_back(std::exchange(line, {}));
  }
  if (!line.empty()) lines.push_back(std::move(line));
  return lines;
}

}  // namespace

std::optional<std::string> read_bytes(const std::string& path, Diagnostics& diagnostics) {
  std::ifstream stream;
  if (path != "-") {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
      diagnostics.error(path, kWholeFile, "this is a directory, not a file");
      return std::nullopt;
    }
    stream.open(path, std::ios::binary);
    if (!stream) {
      diagnostics.error(path, kWholeFile, fmt::format("cannot open it: {}", std::strerror(errno)));
      return std::nullopt;
    }
  }
  std::istream& in = path == "-" ? std::cin : stream;
  std::string bytes;
  char buffer[1U << 16U];
  while (in.read(buffer, sizeof buffer) || in.gcount() > 0) {
    bytes.append(buffer, static_cast<std::size_t>(in.gcount()));
    if (bytes.size() > kMaxSourceBytes) {
      diagnostics.error(
          path, kWholeFile,
          fmt::format("larger than {} MiB: this is no program or trace", kMaxSourceBytes >> 20U));
      return std::nullopt;
    }
  }
  if (in.bad()) {
    diagnostics.error(path, kWholeFile, fmt::format("cannot read it: {}", std::strerror(errno)));
    return std::nullopt;
  }
  return bytes;
}

std::optional<SourceText> decode_text(std::string_view bytes, const std::string& file,
                                      Diagnostics& diagnostics) {
  std::optional<std::u32string> text;
  if (bytes.starts_with("\xFF\xFE")) {
    text = decode_utf16(bytes.substr(2), false, file, diagnostics);
  } else if (bytes.starts_with("\xFE\xFF")) {
    text = decode_utf16(bytes.substr(2), true, file, diagnostics);
  } else if (is_utf16(bytes, false) || is_utf16(bytes, true)) {
    text = decode_utf16(bytes, is_utf16(bytes, true), file, diagnostics);
  } else if (bytes.find('\0') != std::string_view::npos) {
    diagnostics.error(file, kWholeFile, "this is a binary file: it holds NUL bytes",
                      fmt::format("if it is text, {}", kEncodings));
  } else {
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    text = decode_utf8(bytes, file, diagnostics);
  }
  if (!text) return std::nullopt;
  if (text->empty()) {
    diagnostics.error(file, kWholeFile, "the file is empty");
    return std::nullopt;
  }
  for (std::size_t i = 0; i < text->size(); ++i) {
    if (!is_binary((*text)[i])) continue;
    diagnostics.error(file, kWholeFile,
                      fmt::format("this is a binary file: it holds the control character 0x{:02X}",
                                  static_cast<unsigned>((*text)[i])),
                      fmt::format("if it is text, {}", kEncodings));
    return std::nullopt;
  }
  return SourceText{file, split_lines(*text)};
}

std::optional<SourceText> read_text(const std::string& path, Diagnostics& diagnostics) {
  const std::optional<std::string> bytes = read_bytes(path, diagnostics);
  if (!bytes) return std::nullopt;
  return decode_text(*bytes, path, diagnostics);
}

std::string to_utf8(std::u32string_view text) {
  std::string bytes;
  for (const char32_t c : text) utf8::unchecked::append(c, std::back_inserter(bytes));
  return bytes;
}

std::string shown(std::string_view word) {
  constexpr int kMost = 40;
  auto end = word.begin();
  for (int i = 0; i < kMost && end != word.end(); ++i) utf8::unchecked::next(end);
  return std::string(word.begin(), end) + (end == word.end() ? "" : "...");
}

}  // namespace rung

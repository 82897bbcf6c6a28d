// SPDX-License-Identifier: Apache-2.0
// Windows' code pages of one or two bytes a character, to UTF-8 and back.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rung {

enum class CodePage : std::uint8_t {
  Japanese,  // 932, Microsoft's Shift-JIS
  Western,   // 1252
};

// Nothing if `bytes` are not valid in `page`.
std::optional<std::string> decode(std::string_view bytes, CodePage page);
// Nothing if the page lacks a character of `text`, which is valid UTF-8.
std::optional<std::string> encode(std::string_view text, CodePage page);

}  // namespace rung

// SPDX-License-Identifier: Apache-2.0
#include "source/code_page.hpp"

#include <iconv.h>

namespace rung {
namespace {

constexpr const char* kUtf8 = "UTF-8";

const char* name_of(CodePage page) { return page == CodePage::Japanese ? "CP932" : "CP1252"; }

std::optional<std::string> convert(std::string_view bytes, const char* from, const char* to) {
  const iconv_t converter = iconv_open(to, from);
  // NOLINTNEXTLINE: how iconv says that it does not know an encoding
  if (converter == reinterpret_cast<iconv_t>(-1)) return std::nullopt;
  std::string in(bytes);
  std::string out(3 * in.size() + 1, '\0');  // no character of these pages takes more in UTF-8
  char* read = in.data();
  char* write = out.data();
  std::size_t read_left = in.size();
  std::size_t write_left = out.size();
  const bool good = iconv(converter, &read, &read_left, &write, &write_left) == 0 && read_left == 0;
  iconv_close(converter);
  if (!good) return std::nullopt;
  out.resize(out.size() - write_left);
  return out;
}

}  // namespace

std::optional<std::string> decode(std::string_view bytes, CodePage page) {
  return convert(bytes, name_of(page), kUtf8);
}

std::optional<std::string> encode(std::string_view text, CodePage page) {
  return convert(text, kUtf8, name_of(page));
}

}  // namespace rung

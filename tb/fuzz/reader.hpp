// SPDX-License-Identifier: Apache-2.0
// A reader of outside bytes, as a function that takes any bytes. It must neither crash nor hang on
// them, and must say why when it refuses; what it accepts must hold together. A fault ends the
// program, for libFuzzer to see.
#pragma once

#include <string_view>

namespace rung::fuzz {

struct Reader {
  std::string_view name;  // of its corpus and its fuzzer
  void (*read)(std::string_view bytes);
};

}  // namespace rung::fuzz

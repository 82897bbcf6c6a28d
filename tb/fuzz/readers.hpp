// SPDX-License-Identifier: Apache-2.0
// The readers of files that people bring, each as a function that takes any bytes. A reader must
// neither crash nor hang on them, and must say why when it refuses; what it accepts must hold
// together. A fault ends the program, for libFuzzer to see.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace rung::fuzz {

struct Reader {
  std::string_view name;  // of its corpus and its fuzzer
  void (*read)(std::string_view bytes);
};

std::span<const Reader> readers();

}  // namespace rung::fuzz

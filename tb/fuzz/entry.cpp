// SPDX-License-Identifier: Apache-2.0
// libFuzzer's entry point for the reader that RUNG_READER names.
#include <algorithm>
#include <cstdint>

#include "fuzz/readers.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto readers = rung::fuzz::readers();
  static const auto reader = std::find_if(
      readers.begin(), readers.end(), [](const auto& each) { return each.name == RUNG_READER; });
  reader->read({reinterpret_cast<const char*>(data), size});
  return 0;
}

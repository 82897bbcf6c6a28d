// SPDX-License-Identifier: Apache-2.0
// libFuzzer's entry point for the reader that RUNG_READER names.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#ifdef RUNG_HARDWARE
#include "fuzz/hardware_readers.hpp"
#else
#include "fuzz/readers.hpp"
#endif

namespace {

std::span<const rung::fuzz::Reader> all() {
#ifdef RUNG_HARDWARE
  // Their benches are those of the tests: what one of them finds is a fault too.
  testing::GTEST_FLAG(break_on_failure) = true;
  return rung::fuzz::hardware_readers();
#else
  return rung::fuzz::readers();
#endif
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto readers = all();
  static const auto reader = std::find_if(
      readers.begin(), readers.end(), [](const auto& each) { return each.name == RUNG_READER; });
  reader->read({reinterpret_cast<const char*>(data), size});
  return 0;
}

// SPDX-License-Identifier: Apache-2.0
// libFuzzer's entry point for the reader that RUNG_READER names.
#include <gtest/gtest.h>

#include <cstdint>

#include "fuzz/bytecode_reader.hpp"
#include "fuzz/hardware_readers.hpp"
#include "fuzz/host_readers.hpp"
#include "fuzz/readers.hpp"

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  // Benches of the hardware are those of the tests: what one of them finds is a fault too.
  testing::GTEST_FLAG(break_on_failure) = true;
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rung::fuzz::RUNG_READER({reinterpret_cast<const char*>(data), size});
  return 0;
}

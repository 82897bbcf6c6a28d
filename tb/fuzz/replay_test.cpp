// SPDX-License-Identifier: Apache-2.0
// What fuzzing has found worth keeping (corpus/), read again with the sanitizers of the test build.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "fuzz/hardware_readers.hpp"
#include "fuzz/readers.hpp"

namespace rung::fuzz {
namespace {

class Corpus : public testing::TestWithParam<Reader> {};

TEST_P(Corpus, IsReadWithoutAFault) {
  const std::filesystem::path folder =
      std::filesystem::path(RUNG_REPOSITORY) / "tb/fuzz/corpus" / GetParam().name;
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    SCOPED_TRACE(entry.path());
    GetParam().read(bytes);
    ++files;
  }
  EXPECT_GT(files, 5) << folder;
}

std::string name_of(const testing::TestParamInfo<Reader>& info) {
  return std::string(info.param.name);
}

INSTANTIATE_TEST_SUITE_P(Readers, Corpus, testing::ValuesIn(readers().begin(), readers().end()),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Hardware, Corpus,
                         testing::ValuesIn(hardware_readers().begin(), hardware_readers().end()),
                         name_of);

}  // namespace
}  // namespace rung::fuzz

// SPDX-License-Identifier: Apache-2.0
// What fuzzing has found worth keeping (corpus/), read again with the sanitizers of the test build.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "fuzz/bytecode_reader.hpp"
#include "fuzz/hardware_readers.hpp"
#include "fuzz/host_readers.hpp"
#include "fuzz/readers.hpp"

namespace rung::fuzz {
namespace {

struct Reader {
  const char* name;  // of its corpus
  void (*read)(std::string_view bytes);
};

constexpr Reader kReaders[] = {
    {"list", read_list},
    {"csv", read_csv},
    {"ld", read_ld},
    {"comments", read_comments},
    {"stimulus", read_stimulus},
    {"trace", read_trace},
    {"ldmicro_trace", read_ldmicro_trace},
    {"image", read_image},
    {"bytecode", read_bytecode},
    {"io_map", read_io_map},
    {"load_file", read_load_file},
    {"flow", read_flow},
    {"mbap", read_mbap},
    {"console", read_console},
    {"view", read_view},
    {"modbus", read_modbus},
    {"flash", read_flash},
    {"rtu_line", read_rtu_line},
    {"panel", read_panel},
    {"link", read_link},
    {"controller", read_controller},
};

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

INSTANTIATE_TEST_SUITE_P(Readers, Corpus, testing::ValuesIn(kReaders),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace rung::fuzz

// SPDX-License-Identifier: Apache-2.0
// Reading and writing files, and the order of diagnostics.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "melsec/suggest.hpp"
#include "rungs/devices.hpp"
#include "support.hpp"

namespace rung {
namespace {

namespace fs = std::filesystem;

// A directory of its own, removed at the end.
class Files : public testing::Test {
 protected:
  Files() : directory_(fs::path(RUNG_SCRATCH) / fmt::format("source_test.{}", ::getpid())) {
    fs::create_directories(directory_);
  }
  ~Files() override { fs::remove_all(directory_); }

  std::string path(const std::string& name) const { return (directory_ / name).string(); }

  static std::string contents(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  int entries() const {
    return static_cast<int>(std::distance(fs::directory_iterator(directory_), {}));
  }

  fs::path directory_;
  Diagnostics diagnostics_;
};

TEST_F(Files, AreWrittenWholeAndReplaced) {
  EXPECT_TRUE(write_file(path("a"), "first", diagnostics_));
  EXPECT_EQ(contents(path("a")), "first");
  EXPECT_TRUE(write_file(path("a"), std::string("two\0", 4), diagnostics_));
  EXPECT_EQ(contents(path("a")), std::string("two\0", 4));
  EXPECT_EQ(entries(), 1) << "no temporary file is left";
  EXPECT_EQ(printed(diagnostics_), "");
}

TEST_F(Files, KeepTheModeOfTheOldOne) {
  ASSERT_TRUE(write_file(path("a"), "x", diagnostics_));
  fs::permissions(path("a"), fs::perms::owner_read | fs::perms::owner_write);
  ASSERT_TRUE(write_file(path("a"), "y", diagnostics_));
  EXPECT_EQ(fs::status(path("a")).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(Files, ALinkStaysALink) {
  ASSERT_TRUE(write_file(path("target"), "x", diagnostics_));
  fs::create_symlink("target", path("link"));
  ASSERT_TRUE(write_file(path("link"), "y", diagnostics_));
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(contents(path("target")), "y");
}

TEST_F(Files, WhatIsNoRegularFileIsWrittenDirectly) {
  EXPECT_TRUE(write_file("/dev/null", "x", diagnostics_));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(Files, AFailureLeavesNothingBehind) {
  EXPECT_FALSE(write_file(path("missing/a"), "x", diagnostics_));
  EXPECT_FALSE(write_file(directory_.string(), "x", diagnostics_));
  EXPECT_FALSE(write_file("/dev/full", "x", diagnostics_));
  EXPECT_EQ(entries(), 0);
  EXPECT_EQ(printed(diagnostics_),
            fmt::format("{0}/missing/a:1:1: error: cannot write it: No such file or directory\n"
                        "{0}:1:1: error: cannot write it: this is a directory\n"
                        "/dev/full:1:1: error: cannot write it: No space left on device\n",
                        directory_.string()));
}

TEST_F(Files, AFullDiskLeavesTheOldOne) {
  ASSERT_TRUE(write_file(path("a"), "old", diagnostics_));
  // A limit on the size of files stands for the full disk: the write fails half way.
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 1000;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const bool written = write_file(path("a"), std::string(5000, 'x'), diagnostics_);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_FALSE(written);
  EXPECT_EQ(printed(diagnostics_),
            fmt::format("{}:1:1: error: cannot write it: File too large\n", path("a")));
  EXPECT_EQ(contents(path("a")), "old");
  EXPECT_EQ(entries(), 1);
}

TEST_F(Files, ThatCannotBeRead) {
  EXPECT_FALSE(read_text(path("missing"), diagnostics_));
  EXPECT_FALSE(read_text(directory_.string(), diagnostics_));
  EXPECT_FALSE(read_text("/dev/zero", diagnostics_));
  EXPECT_EQ(printed(diagnostics_),
            fmt::format("{0}/missing:1:1: error: cannot open it: No such file or directory\n"
                        "{0}:1:1: error: this is a directory, not a file\n"
                        "/dev/zero:1:1: error: larger than 64 MiB: this is no program or trace\n",
                        directory_.string()));
}

TEST_F(Files, AreReadAsLines) {
  ASSERT_TRUE(write_file(path("a"), "a\r\n\r\n\xE3\x81\x82\rb", diagnostics_));
  const auto text = read_text(path("a"), diagnostics_);
  ASSERT_TRUE(text);
  EXPECT_EQ(text->lines, (std::vector<std::u32string>{U"a", U"", U"\u3042", U"b"}));
  EXPECT_EQ(to_utf8(text->lines[2]), "\xE3\x81\x82");
}

TEST(Encodings, GiveTheSameText) {
  const std::u32string text = U"LD X0 ; \u3042\uFF71\u4F4D";
  const auto utf16 = [&](bool big_endian) {
    std::string bytes;
    for (const char32_t c : text) {
      const char low = static_cast<char>(c & 0xFFU);
      const char high = static_cast<char>(c >> 8U);
      bytes += {big_endian ? high : low, big_endian ? low : high};
    }
    return bytes;
  };
  const std::string encoded[] = {to_utf8(text),
                                 "\xEF\xBB\xBF" + to_utf8(text),
                                 "\xFF\xFE" + utf16(false),
                                 utf16(false),
                                 "\xFE\xFF" + utf16(true),
                                 utf16(true),
                                 "LD X0 ; \x82\xA0\xB1\x88\xCA"};  // Shift-JIS
  for (const std::string& bytes : encoded) {
    Diagnostics diagnostics;
    const auto decoded = decode_text(bytes, "t", diagnostics);
    ASSERT_TRUE(decoded) << printed(diagnostics);
    EXPECT_EQ(decoded->lines, std::vector<std::u32string>{text});
  }
}

TEST(DiagnosticsOrder, IsThatOfTheSource) {
  Diagnostics diagnostics;
  diagnostics.error("b", {3, 1}, "third", "mend it");
  diagnostics.note("b", {1, 1}, "of the third");
  diagnostics.error("b", {2, 9}, "second");
  diagnostics.warning("b", {2, 3}, "first");
  diagnostics.error("a", {1, 1}, "of the file that came later");
  diagnostics.error("b", {2, 9}, "second, too");
  EXPECT_EQ(printed(diagnostics),
            "b:2:3: warning: first\n"
            "b:2:9: error: second\n"
            "b:2:9: error: second, too\n"
            "b:3:1: error: third\n"
            "    mend it\n"
            "b:1:1: note: of the third\n"
            "a:1:1: error: of the file that came later\n");
  EXPECT_EQ(diagnostics.error_count(), 4);
}

TEST(DeviceNames, AreReadAndWritten) {
  struct Row {
    Dialect dialect;
    const char* text;
    const char* name;  // null: no device
  };
  const Row rows[] = {
      {Dialect::Fx, "X000", "X0"},
      {Dialect::Fx, "y17", "Y17"},
      {Dialect::Fx, "X8", nullptr},
      {Dialect::Fx, "X400", nullptr},
      {Dialect::Paper, "M7679", "M7679"},
      {Dialect::Paper, "M7680", nullptr},
      {Dialect::Q, "x01f", "X1F"},
      {Dialect::Q, "XA", "XA"},
      {Dialect::Q, "X2000", nullptr},
      {Dialect::Q, "D12287", "D12287"},
      {Dialect::Fx, "", nullptr},
      {Dialect::Fx, "X", nullptr},
      {Dialect::Fx, "X-1", nullptr},
      {Dialect::Fx, "X 1", nullptr},
      {Dialect::Fx, "T007", "TS7"},
      {Dialect::Fx, "CN200:H", "CN200:h"},
      {Dialect::Fx, "CN199:H", nullptr},
      {Dialect::Fx, "M8013", "M8013"},
      {Dialect::Fx, "M8029", nullptr},
      {Dialect::Paper, "T0", nullptr},
      {Dialect::Q, "ST5", "STS5"},
      {Dialect::Q, "SM400", "SM400"},
      {Dialect::Q, "SM1880", nullptr},
      {Dialect::Fx, "D4294967296", nullptr},
      {Dialect::Fx, "D18446744073709551616", nullptr},
  };
  for (const Row& row : rows) {
    const auto device = parse_device_name(row.text, row.dialect);
    ASSERT_EQ(device.has_value(), row.name != nullptr) << row.text;
    if (device) {
      EXPECT_EQ(device_name(*device, row.dialect), row.name);
    }
  }
}

TEST(DeviceNames, OfEveryDeviceComeBack) {
  for (const DeviceRange& range : device_ranges()) {
    for (std::uint32_t number = range.first; number <= range.last; ++number) {
      const Device device{range.kind, number};
      ASSERT_EQ(parse_device_name(device_name(device, range.dialect), range.dialect), device);
    }
    const std::string beyond = device_name({range.kind, range.last + 1}, range.dialect);
    EXPECT_FALSE(parse_device_name(beyond, range.dialect)) << beyond;
  }
}

TEST(Suggestions, AreNear) {
  EXPECT_EQ(suggest_instruction("LDD"), "LD");
  EXPECT_EQ(suggest_instruction("OTU"), "OUT");
  EXPECT_EQ(suggest_instruction("ENDD"), "END");
  EXPECT_EQ(suggest_instruction("WANDD"), "WAND");
  EXPECT_EQ(suggest_instruction("XYZZY"), "");
  EXPECT_EQ(suggest_instruction(std::string(100000, 'A')), "");
}

}  // namespace
}  // namespace rung

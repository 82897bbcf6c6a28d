// SPDX-License-Identifier: Apache-2.0
// `rung translate --to ld`: what is written reads back as it was, and keeps to LDmicro 2.3's
// limits.
#include <gtest/gtest.h>

#include "ldmicro_support.hpp"
#include "programs/random_ldmicro.hpp"

namespace rung {
namespace {

TEST(LdmicroWriter, EveryElementAsItWas) {
  EXPECT_EQ(expect_ld_round_trip(good_ld(kEveryElement)), kEveryElement);
}

// 0.2, odd blanks, literals that are characters, a SERIES around one element or within another.
TEST(LdmicroWriter, NormalisesWhatItRead) {
  const Program program = good_ld(
      "LDmicro0.2\nCYCLE=20000 us at Timer1\nBAUD=9600 Hz\nVAR LIST\nEND\nIO LIST\n  Xa at 5 0 "
      "0\nEND\n"
      "PROGRAM\nRUNG 1\n  CONTACTS Xa 0 0\n\n  PARALLEL\n   SERIES\n    TON T 50000 0\n   END\n   "
      "OPEN\n"
      "  END\n  SERIES\n   CTU C 5 0 /\n  END\n  MOVE v 'x'\n  FORMATTED_STRING v "
      "a\\x20\\5\nEND\n");
  EXPECT_EQ(expect_ld_round_trip(program),
            "LDmicro0.1\n"
            "CYCLE=20000\n"
            "CRYSTAL=4000000\n"
            "BAUD=9600\n"
            "\n"
            "IO LIST\n"
            "    Xa at 5\n"
            "END\n"
            "\n"
            "PROGRAM\n"
            "RUNG\n"
            "    CONTACTS Xa 0\n"
            "    PARALLEL\n"
            "        TON T 50000\n"
            "        OPEN\n"
            "    END\n"
            "    CTU C 5\n"
            "    MOVE v 120\n"
            "    FORMATTED_STRING v 7 97 92 120 50 48 92 53\n"
            "END\n");
}

TEST(LdmicroWriter, BitAndVariableOfOneName) {
  expect_ld_round_trip(good_ld(ld_file(
      "CONTACTS a 0\nMOVE a b\nCOIL b 0 0 0\nREAD_ADC a\nSHIFT_REGISTER s 3\nCOIL s0 0 0 0")));
}

// In the code page in which the reader finds the same text again, or in UTF-8.
TEST(LdmicroWriter, Encodings) {
  const auto written = [](const std::string& note) {
    const std::string text = expect_ld_round_trip(good_ld(ld_file("COMMENT " + note)));
    const std::size_t begin = text.find("COMMENT ") + 8;
    return text.substr(begin, text.rfind("\nEND") - begin);
  };
  EXPECT_EQ(written("\u8868n\\r\\n\u8868"), "\x95\\\\n\\r\\n\x95\\\\");
  EXPECT_EQ(written("caf\u00E9"), "caf\xE9");
  EXPECT_EQ(written("\u8868 and \u00DF"), "\u8868 and \u00DF");
  // In code page 1252 these bytes would be Japanese to the reader.
  EXPECT_EQ(written("\u00E9t\u00E9s"), "\u00E9t\u00E9s");
}

// They keep to the limits, or it is said which one they pass.
TEST(LdmicroWriter, RandomPrograms) {
  int written = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Program program = good_ld(random_ldmicro(seed, ldmicro_options(seed)));
    Diagnostics diagnostics;
    if (to_ld(program, diagnostics)) {
      expect_ld_round_trip(program);
      ++written;
    } else {
      EXPECT_NE(printed(diagnostics).find("of which LDmicro 2.3"), std::string::npos);
    }
    ASSERT_FALSE(HasFailure()) << seed;
  }
  EXPECT_GT(written, 100);
}

std::string repeated(std::string_view line, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += fmt::format(fmt::runtime(line), i) + '\n';
  return text;
}

std::string numbers(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += fmt::format(" {}", i);
  return text;
}

struct Limit {
  const char* name;
  std::string within;  // written
  std::string beyond;  // not written
  const char* messages;
};

class LdmicroLimits : public testing::TestWithParam<Limit> {};

TEST_P(LdmicroLimits, AreKept) {
  expect_ld_round_trip(good_ld(GetParam().within));
  Diagnostics diagnostics;
  EXPECT_FALSE(to_ld(good_ld(GetParam().beyond), diagnostics));
  EXPECT_EQ(printed(diagnostics), GetParam().messages);
}

std::string rungs(int count) { return "LDmicro0.1\nPROGRAM\n" + repeated("RUNG\nOSR\nEND", count); }
std::string branches(int count) {
  return ld_file("PARALLEL\n" + repeated("OSR", count) + "END\nOSF");
}
std::string named(std::size_t length) { return ld_file("RES " + std::string(length, 'n')); }
std::string noted(std::size_t length) { return ld_file("COMMENT " + std::string(length, 'c')); }
std::string points(int count) {
  std::string table;
  for (int i = 0; i < count; ++i) table += fmt::format(" {} 0", i);
  return ld_file(fmt::format("PIECEWISE_LINEAR d i {}{}", count, table));
}
std::string looked_up(int count) {
  return ld_file(fmt::format("LOOK_UP_TABLE d i {} 0{}", count, numbers(count)));
}
std::string formatted(int count) {
  std::string codes;
  for (int i = 0; i < count; ++i) codes += " 65";
  return ld_file(fmt::format("FORMATTED_STRING (none) {}{}", count, codes));
}
std::string many_names(int count) {
  std::string text = "LDmicro0.1\nPROGRAM\n";
  for (int i = 0; i < count; ++i) {
    text += fmt::format("{}RES v{}\n", i % 15 == 0 ? i == 0 ? "RUNG\n" : "END\nRUNG\n" : "", i);
  }
  return text + "END\n";
}
// A line of 510 characters and some more.
std::string long_line(std::size_t more) {
  std::string line =
      "LOOK_UP_TABLE " + std::string(100, 'd') + " " + std::string(90 + more, 'i') + " 50 0";
  for (int i = 0; i < 50; ++i) line += " -1000";
  return line;
}
std::string japanese(int count) {
  std::string text = "COMMENT ";
  for (int i = 0; i < count; ++i) text += "\u8868";
  return ld_file(text);
}

const Limit kLimits[] = {
    {"Rungs", rungs(99), rungs(100),
     "t.ld:300:1: error: 100 rungs, of which LDmicro 2.3 holds 99\n"
     "    put rungs side by side into the branches of a PARALLEL, or write two programs\n"},
    {"ElementsInARow", ld_file(repeated("OSR", 15)), ld_file(repeated("OSR", 17)),
     "t.ld:19:1: error: element 16 of the row that begins in line 3, of which LDmicro 2.3 holds "
     "15\n"
     "    keep an inner result in a relay, in a rung of its own\n"},
    {"ElementsInASeries", ld_file("PARALLEL\nSERIES\n" + repeated("OSR", 15) + "END\nOSF\nEND"),
     ld_file("PARALLEL\nSERIES\n" + repeated("OSR", 16) + "END\nOSF\nEND"),
     "t.ld:21:1: error: element 16 of the row that begins in line 6, of which LDmicro 2.3 holds "
     "15\n"
     "    keep an inner result in a relay, in a rung of its own\n"},
    {"Branches", branches(15), branches(16),
     "t.ld:20:1: error: branch 16 of the PARALLEL that begins in line 4, of which LDmicro 2.3 "
     "holds 15\n"
     "    put a PARALLEL of its own around some of them\n"},
    {"Name", named(127), named(128),
     "t.ld:4:1: error: nnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnn...: a name of 128 letters, of "
     "which LDmicro 2.3 holds 127\n"
     "    give it a shorter name\n"},
    {"NameOfBitAndVariable",
     ld_file("RES " + std::string(127, 'n') + "\nCONTACTS " + std::string(127, 'n') + " 0"),
     ld_file("RES " + std::string(128, 'n') + "\nCONTACTS " + std::string(128, 'n') + " 0"),
     "t.ld:4:1: error: nnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnn...: a name of 128 letters, of "
     "which LDmicro 2.3 holds 127\n"
     "    give it a shorter name\n"
     "t.ld:5:1: error: nnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnn...: a name of 128 letters, of "
     "which LDmicro 2.3 holds 127\n"
     "    give it a shorter name\n"},
    {"Comment", noted(383), noted(384),
     "t.ld:4:1: error: COMMENT: 384 bytes, of which LDmicro 2.3 holds 383\n"
     "    part it into two rungs\n"},
    {"CommentInJapanese", japanese(127), japanese(192),
     "t.ld:4:1: error: COMMENT: 384 bytes, of which LDmicro 2.3 holds 383\n"
     "    part it into two rungs\n"},
    {"LookUpTable", looked_up(60), looked_up(61),
     "t.ld:4:1: error: LOOK_UP_TABLE d i 61 0 0 1 2 3 4 5 6 7 8...: 61 values, of which LDmicro "
     "2.3 holds 60\n"
     "    use two tables\n"},
    {"Points", points(30), points(31),
     "t.ld:4:1: error: PIECEWISE_LINEAR d i 31 0 0 1 0 2 0 3 0 ...: 31 points, of which LDmicro "
     "2.3 holds 30\n"
     "    use two tables\n"},
    {"String", formatted(59), formatted(60),
     "t.ld:4:1: error: FORMATTED_STRING (none) 60 65 65 65 65 6...: 60 characters, of which "
     "LDmicro 2.3 holds 59\n"
     "    send it as two strings, one behind the other\n"},
    {"Names", many_names(512), many_names(513),
     "t.ld:1:1: error: 513 names, of which LDmicro 2.3 holds 512\n"
     "    use one variable for several purposes, or write two programs\n"},
    {"Line", ld_file(long_line(0)), ld_file(long_line(1)),
     "t.ld:4:1: error: LOOK_UP_TABLE: a line of 511 characters, of which LDmicro 2.3 reads 510\n"
     "    use shorter names or texts, or smaller tables\n"},
    {"PinLine",
     "LDmicro0.1\nIO LIST\n" + std::string(68, 'X') + " at 12\nEND\nPROGRAM\nRUNG\nEND\n",
     "LDmicro0.1\nIO LIST\n" + std::string(69, 'X') + " at 12\nEND\nPROGRAM\nRUNG\nEND\n",
     "t.ld:1:1: error: IO LIST: the line of XXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXXX... has 79 "
     "characters, of which LDmicro 2.3 reads 78\n"
     "    give it a shorter name\n"},
    {"PinsOf02", "LDmicro0.2\nIO LIST\nAn at 1\nEND\nPROGRAM\nRUNG\nEND\n",
     "LDmicro0.2\nIO LIST\nPn at 1\nEND\nPROGRAM\nRUNG\nEND\n",
     "t.ld:1:1: error: IO LIST: Pn has a pin, which in LDmicro 2.3 only names with X, Y and A "
     "have\n"
     "    remove it from the IO LIST\n"},
    {"CommentBesideOthers", ld_file("COMMENT a"), ld_file("COMMENT a\nOSR"),
     "t.ld:4:1: error: COMMENT beside other elements, which LDmicro 2.3 cannot compile\n"
     "    give it a rung of its own\n"},
};
INSTANTIATE_TEST_SUITE_P(All, LdmicroLimits, testing::ValuesIn(kLimits),
                         [](const auto& info) { return std::string(info.param.name); });

// Indented it would be too long, so that it is not.
TEST(LdmicroWriter, LongLinesLoseTheirIndent) {
  const std::string line = long_line(0);
  ASSERT_EQ(line.size(), 510U);
  const std::string text = expect_ld_round_trip(good_ld(ld_file(line)));
  EXPECT_NE(text.find("\n" + line + "\n"), std::string::npos);
}

}  // namespace
}  // namespace rung

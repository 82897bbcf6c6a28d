// SPDX-License-Identifier: Apache-2.0
// Real lists that people have, where they are present beside the repository: each is accepted, or
// refused first of all for this instruction at this line. The files are no part of the project.
#include <gtest/gtest.h>

#include <filesystem>

#include "c_program.hpp"
#include "support.hpp"

namespace rung {
namespace {

namespace fs = std::filesystem;

struct RealList {
  const char* file;
  int networks;         // 0 if it is refused
  const char* refusal;  // how the first message begins after the file's name
};

constexpr RealList kLists[] = {
    {"super0415_wpg__demo_ANB-ORB.lst", 1, ""},
    {"super0415_wpg__demo_AND.lst", 1, ""},
    {"super0415_wpg__demo_DIV.lst", 1, ""},
    {"super0415_wpg__demo_MPS-MRD-MPP.lst", 1, ""},
    {"super0415_wpg__demo_OR.lst", 1, ""},
    {"super0415_wpg__demo_SET-RST.lst", 2, ""},
    {"ladder_drive__sample1.esc", 1, ""},
    {"kacper97_wpg__Automatic-Doors-GX-Mitshubishi-PLC.lst", 0, ":8:7: error: OUT T1: a timer"},
    {"kacper97_wpg__Batch-Processing-GX-Mitshubishi-PLC.lst", 0, ":6:7: error: OUT T1: a timer"},
    {"kacper97_wpg__Station-A-GX-Mitshubishi-PLC-State.lst", 0,
     ":1:6: error: LD M8002: a special relay"},
    {"kacper97_wpg__Station-A-GX-Mitshubishi-PLC.lst", 0, ":1:3: error: LDP: an edge contact"},
    {"ladder_drive__main.esc", 0, ":44:1: error: INV: the inversion of a result"},
    {"maelstro_wpg__PD_Controller.lst", 0, ":2:6: error: LD M8002: a special relay"},
    {"melsecai__practice_11_output.txt", 0, ":8:5: error: OUT T0: a timer"},
    {"super0415_wpg__DECO.lst", 0, ":2:3: error: DECO: a data operation"},
    {"super0415_wpg__PLSY-0.lst", 0, ":4:3: error: PLSY: pulse output, positioning hardware"},
    {"super0415_wpg__demo_ALT.lst", 0, ":2:3: error: ALT: an alternating coil"},
    {"super0415_wpg__demo_BMOV.lst", 0, ":2:3: error: BMOV: a transfer"},
    {"super0415_wpg__demo_CALL.lst", 0, ":1:3: error: P0: a label"},
    {"super0415_wpg__demo_CMP1.lst", 0, ":2:3: error: CMP: a compare"},
    {"super0415_wpg__demo_DEC.lst", 0, ":4:3: error: DEC: an increment"},
    {"super0415_wpg__demo_FEND.lst", 0, ":2:3: error: CALL: a subroutine call"},
    {"super0415_wpg__demo_INC.lst", 0, ":1:3: error: LDP: an edge contact"},
    {"super0415_wpg__demo_MOV.lst", 0, ":1:3: error: LDP: an edge contact"},
    {"super0415_wpg__demo_NEG.lst", 0, ":2:3: error: NEG: bit-wise logic"},
    {"super0415_wpg__demo_SWAP.lst", 0, ":2:3: error: SWAP: a transfer"},
    {"super0415_wpg__demo_WAND.lst", 0, ":1:3: error: LDP: an edge contact"},
    {"super0415_wpg__demo_\u4F4D\u79FB.lst", 0, ":2:3: error: ROR: a shift"},
    {"super0415_wpg__demo_\u5B9A\u65F6\u5668.lst", 0, ":2:7: error: OUT T250: a timer"},
};

const fs::path kFolder = fs::path(RUNG_REPOSITORY) / "../shared/programs/melsec";

ParseResult parse_file(const fs::path& path) {
  Diagnostics diagnostics;
  ParseResult result;
  if (const auto source = read_text(path.string(), diagnostics)) {
    result.program = parse_list(*source, std::nullopt, diagnostics);
  }
  result.messages = printed(diagnostics);
  return result;
}

TEST(Corpus, PlainListsAreAcceptedOrRefusedByInstructionAndLine) {
  if (!fs::exists(kFolder)) GTEST_SKIP() << "skipped: no corpus";
  for (const RealList& list : kLists) {
    const fs::path path = kFolder / list.file;
    ASSERT_TRUE(fs::exists(path)) << path;
    const ParseResult result = parse_file(path);
    ASSERT_EQ(result.program.has_value(), list.networks > 0) << list.file << result.messages;
    if (result.program) {
      EXPECT_EQ(static_cast<int>(result.program->networks.size()), list.networks) << list.file;
      EXPECT_EQ(result.messages, "");
    } else {
      const std::string start = path.string() + list.refusal;
      EXPECT_EQ(result.messages.substr(0, start.size()), start);
    }
  }
}

TEST(Corpus, AcceptedListsRunAsCAsOnTheReference) {
  if (!fs::exists(kFolder)) GTEST_SKIP() << "skipped: no corpus";
  RandomSource random(1);
  for (const RealList& list : kLists) {
    if (list.networks == 0) continue;
    const ParseResult result = parse_file(kFolder / list.file);
    ASSERT_TRUE(result.program);
    expect_c_equals_reference(*result.program, 1000, random);
    ASSERT_FALSE(HasFailure()) << list.file;
  }
}

// Other forms (exports as CSV) are not for this parser, but must not hurt it.
TEST(Corpus, EveryFileGivesAProgramOrMessages) {
  if (!fs::exists(kFolder)) GTEST_SKIP() << "skipped: no corpus";
  int files = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(kFolder)) {
    const ParseResult result = parse_file(entry.path());
    EXPECT_EQ(result.program.has_value(), result.messages.empty()) << entry.path();
    ++files;
  }
  EXPECT_GE(files, static_cast<int>(std::size(kLists)));
}

}  // namespace
}  // namespace rung

// SPDX-License-Identifier: Apache-2.0
// Real programs that people have, where they are present beside the repository: each is accepted,
// or refused first of all for this instruction at this line. The files are no part of the project.
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
    {"gxw2_ladder_converter__MAIN.csv", 52, ""},
    {"gxw2_shw98__01CmnPgm.csv", 0, ":9:9: error: ICPREWR1: for the LCPU's built-in high-speed"},
    {"gxw2_shw98__03MchOut.csv", 0, ":9:15: error: OUT SM1892: a special relay of the LCPU's"},
    {"gxw2_shw98__05Lcnt2.csv", 0, ":9:9: error: ICLTHRD1: for the LCPU's built-in high-speed"},
    {"gxw2_shw98__07SplCnt.csv", 0, ":9:15: error: OUT SM1896: a special relay of the LCPU's"},
    {"gxw2_shw98__09ChkOvr.csv", 0, ":8:14: error: LD SD1882.1: a special register of the"},
    {"gxw2_shw98__11ChkRsp.csv", 0, ":9:9: error: ICRCNT1: for the LCPU's built-in high-speed"},
    {"gxw2_shw98__13OutPwm.csv", 0, ":10:9: error: ICPWM1: for the LCPU's built-in high-speed"},
    {"gxw2_shw98__15Match.csv", 0, ":8:9: error: DI: a part of interrupt programs, which a"},
    {"gxw2_shw98__99TestWarnging.csv", 0,
     ":9:5: error: ICPREWR1: for the LCPU's built-in high-speed"},
    {"gxw2_shw98__device_comments.csv", 0, ":1:1: error: this is a file of device comments, not a"},
    {"kacper97_wpg__Automatic-Doors-GX-Mitshubishi-PLC.lst", 4, ""},
    {"kacper97_wpg__Batch-Processing-GX-Mitshubishi-PLC.lst", 10, ""},
    {"kacper97_wpg__Station-A-GX-Mitshubishi-PLC-State.lst", 3, ""},
    {"kacper97_wpg__Station-A-GX-Mitshubishi-PLC.lst", 19, ""},
    {"ladder_drive__main.esc", 7, ""},
    {"ladder_drive__sample1.esc", 1, ""},
    {"maelstro_wpg__PD_Controller.lst", 0,
     ":3:7: error: SET M8039: a special relay of constant scan,"},
    {"melsecai__practice_11_output.txt", 6, ""},
    {"melsecai__practice_17.csv", 9, ""},
    {"super0415_wpg__DECO.lst", 0, ":2:3: error: DECO: a data operation, not supported"},
    {"super0415_wpg__PLSY-0.lst", 0, ":4:3: error: PLSY: pulse output, positioning hardware"},
    {"super0415_wpg__demo_ALT.lst", 1, ""},
    {"super0415_wpg__demo_ANB-ORB.lst", 1, ""},
    {"super0415_wpg__demo_AND.lst", 1, ""},
    {"super0415_wpg__demo_BMOV.lst", 2, ""},
    {"super0415_wpg__demo_CALL.lst", 8, ""},
    {"super0415_wpg__demo_CMP1.lst", 2, ""},
    {"super0415_wpg__demo_DEC.lst", 2, ""},
    {"super0415_wpg__demo_DIV.lst", 1, ""},
    {"super0415_wpg__demo_FEND.lst", 0, ":4:3: error: P10: this subroutine has no"},
    {"super0415_wpg__demo_INC.lst", 1, ""},
    {"super0415_wpg__demo_MOV.lst", 1, ""},
    {"super0415_wpg__demo_MPS-MRD-MPP.lst", 1, ""},
    {"super0415_wpg__demo_NEG.lst", 1, ""},
    {"super0415_wpg__demo_OR.lst", 1, ""},
    {"super0415_wpg__demo_SET-RST.lst", 2, ""},
    {"super0415_wpg__demo_SWAP.lst", 1, ""},
    {"super0415_wpg__demo_WAND.lst", 12, ""},
    {"super0415_wpg__demo_\u4F4D\u79FB.lst", 4, ""},
    {"super0415_wpg__demo_\u5B9A\u65F6\u5668.lst", 3, ""},
};

const fs::path kFolder = fs::path(RUNG_REPOSITORY) / "../shared/programs/melsec";

ParseResult parse_file(const fs::path& path) {
  Diagnostics diagnostics;
  ParseResult result;
  if (const auto source = read_text(path.string(), diagnostics)) {
    result.program = parse_melsec(*source, std::nullopt, diagnostics);
  }
  result.messages = printed(diagnostics);
  return result;
}

TEST(Corpus, ProgramsAreAcceptedOrRefusedByInstructionAndLine) {
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

TEST(Corpus, AcceptedProgramsRunAsCAsOnTheReference) {
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

// The folder may hold more than we know.
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

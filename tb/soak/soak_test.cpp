// SPDX-License-Identifier: Apache-2.0
// A short soak with everything in it; `make soak` runs millions of scans (soak_main.cpp). And that
// a soak finds what is wrong.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>

#include "load/load_file.hpp"
#include "melsec/list.hpp"
#include "soak/session.hpp"

namespace rung::tb {
namespace {

TEST(Soak, EverythingOnce) {
  SoakOptions options;
  const char* const given = std::getenv("RUNG_SEED");
  options.seed = given != nullptr ? std::strtoull(given, nullptr, 10) : 1;
  options.scans = 1;
  options.least_scans = 100;
  options.most_scans = 300;
  options.swaps = {Swap::Running, Swap::Stopped, Swap::Again, Swap::WrongCrc,
                   Swap::Damaged, Swap::Trip,    Swap::Reset, Swap::Power};
  options.programs = 1 + options.swaps.size();
  const SoakResult result = run_soak(options);
  for (const auto& [name, count] : result.counts) fmt::print("{}: {}\n", name, count);
  EXPECT_EQ(result.difference, "")
      << "replay: RUNG_SEED=" << options.seed << " unit_soak --gtest_filter=Soak.EverythingOnce";
  for (const char* const what :
       {"answers", "writes", "broken_frames", "broken_downloads", "refused_downloads", "trips",
        "stops", "resets", "power_cuts", "statistics", "output_changes"}) {
    EXPECT_GT(result.counts.at(what), 0) << what;
  }
}

// What is found when the controller runs a program, and the reference one that is a little
// different.
std::string found_with(const std::function<void(SoakProgram&)>& change) {
  ControllerSetup setup;
  setup.board = "hx8k";
  setup.line = ControllerSetup::Line::Bytes;
  setup.flash_times =
      FlashTimes{.page_program = 200, .sector_erase = 500, .block_erase = 1000, .wake = 1};
  const auto machine = SimulatedController::make(setup);
  const auto right = make_soak_program(setup.board.data(), setup.clocks_per_ms, 1);
  auto wrong = std::make_shared<SoakProgram>(*right);
  change(*wrong);
  Watch watch(*machine, 1);
  Client client(*machine);
  client.advance = [&](std::uint64_t clocks) { watch.advance(clocks); };
  try {
    EXPECT_EQ(client.begin(right->file, load::crc32(right->file)), 0);
    EXPECT_EQ(client.windows(right->file), 0);
    watch.expect_start(wrong);
    EXPECT_EQ(client.commit(), 2);
    for (int i = 0; i < 200 && !watch.running(); ++i) watch.advance(1000);
    watch.advance(400 * static_cast<std::uint64_t>(right->timing.period));
    watch.expect_stop();
    client.command(2);
    watch.stopped();
    watch.advance(1000);
  } catch (const Difference& difference) {
    return difference.what();
  }
  EXPECT_GT(watch.scans(), 300);
  return {};
}

TEST(Soak, FindsNothingWhereNothingIsWrong) {
  EXPECT_EQ(found_with([](SoakProgram&) {}), "");
}

TEST(Soak, FindsAnOutputThatIsNotTheReferences) {
  const std::string found = found_with([](SoakProgram& program) {
    program.text.insert(program.text.find("LD ") + 2, "I");
    Diagnostics diagnostics;
    const auto source = decode_text(program.text, "wrong.il", diagnostics);
    program.program = parse_list(*source, program.program.dialect, diagnostics).value();
  });
  EXPECT_NE(found.find("and the reference has"), std::string::npos) << found;
}

TEST(Soak, FindsAScanOfAClockMore) {
  const std::string found = found_with([](SoakProgram& program) { --program.timing.period; });
  EXPECT_NE(found.find("the next scan begins at clock"), std::string::npos) << found;
}

TEST(Soak, FindsAnOutputThatIsNotSafe) {
  const std::string found = found_with([](SoakProgram& program) {
    program.safe ^= std::uint64_t{1} << 20;  // a pin that the board does not have
  });
  EXPECT_NE(found.find("are not safe"), std::string::npos) << found;
}

}  // namespace
}  // namespace rung::tb

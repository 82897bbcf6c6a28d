// SPDX-License-Identifier: Apache-2.0
// Inputs that are stuck or tremble, a watchdog that trips, the RUN switch, scans that do not fit
// their period.
#include <fmt/format.h>

#include "load/load_file.hpp"
#include "programs/random_source.hpp"
#include "reliability/two_programs.hpp"
#include "rung_controller.hpp"

namespace rung::tb {
namespace {

namespace c = controller;
using Pin = device::PinChange::Pin;

struct Set {
  std::unique_ptr<SimulatedController> controller;
  std::unique_ptr<Client> client;

  Set(const std::string& board, const Words& file) {
    controller = make_controller(board, 1);
    client = std::make_unique<Client>(*controller);
    install(*controller, *client, file);
    client->gap = 160;
  }
  // The least and the most clocks of a scan.
  std::pair<std::uint32_t, std::uint32_t> scans() {
    const Words words = client->read(c::holding_scan_min, 4);
    return {words[0] | words[1] << 16U, words[2] | static_cast<std::uint32_t>(words[3]) << 16U};
  }
};

TEST(Inputs, StuckAndTrembling) {
  std::string list, inputs;
  for (int n = 0; n < 8; ++n) list += fmt::format("LD X{0}\nOUT Y{0}\n", n);
  const char* const pins[] = {"t1", "t2", "t3", "r2", "r3", "r4", "r5", "r6"};
  const char* const outs[] = {"led0", "led1", "led2", "led3", "t5", "t6", "t7", "t8"};
  for (int n = 0; n < 8; ++n)
    inputs += fmt::format("X{} = {{ pin = \"{}\", filter = 3 }}\n", n, pins[n]);
  std::string outputs = "[outputs]\n";
  for (int n = 0; n < 8; ++n) outputs += fmt::format("Y{} = \"{}\"\n", n, outs[n]);
  Made made = make_program(
      list + "END\n",
      "board = \"hx8k\"\n[controller]\nexchange_points = 64\n[inputs]\n" + inputs + outputs);
  quicken(made.words);
  Set set("hx8k", made.words);
  set.client->command(4);
  const auto cycle = static_cast<std::uint32_t>(made.timing.cycle);
  const auto all = [&](bool level) {
    for (int n = 0; n < 8; ++n) set.controller->set_input(n, level);
  };
  // Stuck at either level
  for (const bool level : {true, false, true}) {
    all(level);
    set.controller->run(20'000);
    EXPECT_EQ(set.controller->outputs(), level ? 0xFFU : 0U);
    EXPECT_EQ(set.scans(), (std::pair{cycle, cycle}));
  }
  // A level never lasts three samples, which are 25 clocks apart.
  all(false);
  set.controller->run(5'000);
  set.controller->changes();
  std::uint64_t toggles = 0;
  for (const std::uint64_t every : {1U, 5U, 24U, 25U, 26U}) {
    bool level = false;
    for (std::uint64_t clocks = 0; clocks < count(20'000, 1'000'000); clocks += every) {
      level = !level;
      for (int n = 0; n < 8; ++n) set.controller->set_input(n, level != (n % 2 == 1));
      set.controller->run(every);
      ++toggles;
    }
    ASSERT_EQ(set.scans(), (std::pair{cycle, cycle})) << every;
    for (const auto& change : set.controller->changes()) {
      ASSERT_NE(static_cast<int>(change.pin), static_cast<int>(Pin::Output))
          << "toggled every " << every << " clocks: output " << change.index;
    }
    // It settles to 0 before the next.
    all(false);
    set.controller->run(2'000);
    set.controller->changes();
  }
  all(true);
  set.controller->run(2'000);
  EXPECT_EQ(set.controller->outputs(), 0xFFU);
  note("toggles", toggles * 8);
}

TEST(Watchdog, TripsAtItsClockAndCanBeLeft) {
  const TwoPrograms programs("hx8k");
  const load::Timing& timing = programs.old.timing;
  const auto with = [&](std::int64_t watchdog) {
    Words file = programs.old.words;
    EXPECT_TRUE(patch(file, c::space_setup, c::setup_watchdog_low, low(watchdog)));
    return file;
  };
  Set set("hx8k", with(timing.cycle));
  EXPECT_TRUE(programs.runs(*set.controller, false)) << "a scan of as many clocks as allowed";
  EXPECT_EQ(set.client->holding(c::holding_fault), 0);

  const std::int64_t refreshed = timing.latch + timing.scan + timing.refresh;
  std::uint64_t trips = 0;
  for (const std::int64_t watchdog : {timing.cycle - 1, timing.cycle - 20, refreshed + 10,
                                      refreshed - 4, timing.latch + 1, std::int64_t{1}}) {
    set.controller->changes();
    ASSERT_EQ(set.client->download(with(watchdog)), 2);
    set.controller->run(3'000);
    for (int times = 0; times < 3; ++times, ++trips) {
      EXPECT_EQ(set.client->holding(c::holding_state), 3) << watchdog;
      EXPECT_EQ(set.client->holding(c::holding_fault), 1) << watchdog;
      EXPECT_TRUE(set.controller->lamp(Pin::Fault));
      EXPECT_TRUE(programs.is_safe(*set.controller)) << watchdog;
      EXPECT_EQ(set.client->write(c::holding_command, {1}), 4) << "runs from a fault";
      // Outputs show the first scan only where its refresh lies before the trip, and no longer
      // than to the trip.
      std::uint64_t shown_at = 0, safe_at = 0;
      for (const auto& change : set.controller->changes()) {
        if (change.pin != Pin::Output || change.index != programs.y2) continue;
        (change.level ? shown_at : safe_at) = change.clock;
      }
      if (watchdog < refreshed) {
        EXPECT_EQ(shown_at, 0U) << watchdog;
      } else {
        EXPECT_NE(shown_at, 0U) << watchdog;
        EXPECT_LE(static_cast<std::int64_t>(safe_at - shown_at), watchdog - refreshed + 4);
      }
      set.client->command(5);
      EXPECT_EQ(set.client->holding(c::holding_state), 0);
      EXPECT_EQ(set.client->holding(c::holding_fault), 0);
      set.controller->run(2'000);
      EXPECT_TRUE(programs.is_safe(*set.controller));
      EXPECT_FALSE(set.controller->lamp(Pin::Fault));
      set.controller->changes();
      set.client->command(1);
      set.controller->run(3'000);
    }
  }
  // A program that is right again runs, out of the fault.
  ASSERT_EQ(set.client->download(programs.old.words), 2);
  EXPECT_TRUE(programs.runs(*set.controller, false));
  EXPECT_EQ(set.client->holding(c::holding_fault), 0);
  note("trips", trips);
}

TEST(RunSwitch, StopsAndRuns) {
  const TwoPrograms programs("hx8k");
  Set set("hx8k", programs.old.words);
  RandomSource random(base_seed());
  const std::uint64_t all = count(6, 200);
  for (std::uint64_t i = 0; i < all; ++i) {
    ASSERT_EQ(set.client->write(100, {low(i), low(i)}), 0);  // latched
    ASSERT_EQ(set.client->write(0, {77}), 0);                // not
    set.controller->run(random.bits() % 2'000);
    set.controller->set_run_switch(false);
    ASSERT_TRUE(run_until(
        *set.controller, [&] { return !set.controller->lamp(Pin::Run); }, 20'000));
    set.controller->run(200);
    ASSERT_TRUE(programs.is_safe(*set.controller));
    ASSERT_EQ(set.client->holding(c::holding_state), 0);
    ASSERT_EQ(set.client->write(c::holding_command, {1}), 4) << "runs against the switch";
    set.controller->set_run_switch(true);
    ASSERT_TRUE(run_until(
        *set.controller, [&] { return set.controller->lamp(Pin::Run); }, 2'000'000));
    ASSERT_TRUE(programs.runs(*set.controller, false));
    ASSERT_EQ(set.client->read(100, 2), (Words{low(i), low(i)}));
    ASSERT_EQ(set.client->holding(0), 0);
  }
  note("switched", all);
}

TEST(Overruns, AreCounted) {
  const TwoPrograms programs("hx8k");
  const auto cycle = static_cast<std::uint32_t>(programs.old.timing.cycle);
  const auto with = [&](std::uint32_t period) {
    Words file = programs.old.words;
    EXPECT_TRUE(patch(file, c::space_setup, c::setup_period_low, low(period)));
    return file;
  };
  Set set("hx8k", with(cycle + 50));
  set.client->command(4);
  set.controller->run(50'000);
  EXPECT_EQ(set.client->holding(c::holding_overruns), 0);
  EXPECT_EQ(set.scans(), (std::pair{cycle, cycle}));
  ASSERT_EQ(set.client->download(with(cycle - 10)), 2);
  set.client->command(4);
  std::uint32_t before = set.client->holding_long(c::holding_scan_count);
  const int overruns = set.client->holding(c::holding_overruns);
  set.controller->run(50'000);
  const std::uint32_t scans = set.client->holding_long(c::holding_scan_count) - before;
  const int more = set.client->holding(c::holding_overruns) - overruns;
  // The two are not read in the same scan.
  EXPECT_NEAR(more, static_cast<int>(scans), 60);
  EXPECT_GT(more, 100);
  EXPECT_EQ(set.scans(), (std::pair{cycle, cycle}));
  EXPECT_EQ(set.client->holding(c::holding_flags) & 2, 2);
  EXPECT_TRUE(programs.runs(*set.controller, false));
  note("overruns", static_cast<std::uint64_t>(more));
}

}  // namespace
}  // namespace rung::tb

// SPDX-License-Identifier: Apache-2.0
// The reference: timers and counters.
#include "reference_story.hpp"

namespace rung {
namespace {

// At 10 ms a scan, so that T200 and up (10 ms) get one tick a scan.
constexpr Story kTimers[] = {
    {"On", "LD X0, OUT T200 K2, LD T200, OUT Y0", "X0=1 | | | | X0=0 | X0=1 |",
     "Y0=0 | TN200=1 Y0=0 | TN200=2 TS200=1 Y0=1 | Y0=1 | TN200=0 TS200=0 Y0=0 | Y0=0 |"
     "TN200=1 Y0=0"},
    {"Retentive", "LD X0, OUT T246 K3, LD X1, RST T246", "X0=1 | | X0=0 | X0=1 | | X1=1 | X1=0 |",
     "| TN246=1 | | | TN246=2 | TN246=3 TS246=1 TN246=0 TS246=0 | TN246=1 | TN246=2", Dialect::Fx,
     1000},
    {"RetentiveKeepsItsContact", "LD X0, OUT T246 K1, LD T246, OUT Y0", "X0=1 | | X0=0 |",
     "Y0=0 | TN246=1 TS246=1 Y0=1 | Y0=1 | Y0=1", Dialect::Fx, 1000},
    {"PresetLowered", "LD X0, OUT T200 D0", "X0=1 D0=10 | | | D0=1",
     "| TN200=1 | TN200=2 | TN200=1 TS200=1"},
    {"PresetRaisedAfterwards", "LD X0, OUT T200 D0, LD T200, OUT Y0", "X0=1 D0=1 | | D0=5",
     "Y0=0 | TN200=1 TS200=1 Y0=1 | Y0=1"},
    {"PresetZero", "LD X0, OUT T200 D0", "X0=1 | | X0=0", "TS200=1 | | TS200=0"},
    {"NegativePresetIsLong", "LD X0, OUT T200 D0", "X0=1 D0=-1 | | TN200=32767 |",
     "| TN200=1 | TN200=-32768 | TN200=-32767"},
    // 65530 + 10 = 65536 + 4
    {"ValueWraps", "LD X0, OUT T200 D0", "X0=1 D0=-1 | TN200=-6", "| TN200=4", Dialect::Fx,
     100'000},
    {"TicksOfAScanAreUsedOnce", "LD X0, OUT T200 K5, LD X0, OUT T200 K5", "X0=1 | |",
     "| TN200=1 | TN200=2"},
    // In the last scan the first coil finds what the second one left before: on.
    {"TwoCoilsAgainstEachOther", "LDI X0, OUT T200 K5, LD X0, OUT T200 K5", "X0=1 | | X0=0",
     "| | TN200=1 TN200=0"},
    // The first coil used up the ticks, whatever its condition was.
    {"SecondCoilIsLate", "LD X1, OUT T200 K5, LD X0, OUT T200 K5", "X0=1 X1=1 | | X1=0 | X1=1",
     "| TN200=1 | TN200=0 | TN200=1"},
    {"ResetWhileOn", "LD X0, OUT T200 K3, LD X1, RST T200", "X0=1 | | X1=1 | X1=0",
     "| TN200=1 | TN200=2 TN200=0 | TN200=1"},
    {"ProgramWritesTheValue", "LD X0, OUT T200 K9, LDP X1, MOV K8 T200, LD T200, OUT Y0",
     "X0=1 X1=1 |", "TN200=8 Y0=0 | TN200=9 TS200=1 Y0=1"},
    {"Q100ms", "LD X0, OUT T0 K1", "X0=1 | |", "| TN0=1 TS0=1 |", Dialect::Q, 100'000},
    {"QHighSpeed", "LD X0, OUTH T0 K15", "X0=1 | |", "| TN0=10 | TN0=15 TS0=1", Dialect::Q,
     100'000},
    {"QRetentive", "LD X0, OUT ST0 K2, LD ST0, OUT Y0", "X0=1 | | X0=0 | X0=1 |",
     "Y0=0 | STN0=1 Y0=0 | Y0=0 | Y0=0 | STN0=2 STS0=1 Y0=1", Dialect::Q, 100'000},
};
INSTANTIATE_TEST_SUITE_P(Timers, ReferenceStory, testing::ValuesIn(kTimers), story_name);

constexpr Story kCounters[] = {
    {"Counts", "LD X0, OUT C0 K2, LD C0, OUT Y0, LD X1, RST C0",
     "X0=1 | X0=0 | X0=1 | X0=0 | X0=1 | X1=1",
     "CN0=1 Y0=0 | Y0=0 | CN0=2 CS0=1 Y0=1 | Y0=1 | Y0=1 | Y0=1 CN0=0 CS0=0"},
    {"HeldWhileItsResetIsDriven", "LD X0, OUT C0 K2, LD X1, RST C0",
     "X1=1 | X0=1 | X1=0 | X0=0 | X0=1", "| | | | CN0=1"},
    {"PresetZeroAndLess", "LD X0, OUT C0 D0, LD X0, OUT C1 D1", "D1=-5 | X0=1",
     "| CN0=1 CS0=1 CN1=1 CS1=1"},
    {"Wraps", "LD X0, OUT C0 K32767", "CN0=32767 X0=1", "CN0=-32768"},
    {"ZrstDoesNotHold", "LD X1, ZRST C0 C0, LD X0, OUT C0 K9", "X0=1 | X0=0 X1=1 | X0=1",
     "CN0=1 | CN0=0 | CN0=1"},
    {"OfQ", "LD X0, OUT C1023 K1, LD X1, RST C1023", "X0=1 | X1=1",
     "CN1023=1 CS1023=1 | CN1023=0 CS1023=0", Dialect::Q},
};
INSTANTIATE_TEST_SUITE_P(Counters, ReferenceStory, testing::ValuesIn(kCounters), story_name);

constexpr Story kWideCounters[] = {
    // Up past the preset of 1, then down past it, then below 0.
    {"UpAndDown", "LD X1, OUT M8200, LD X0, OUT C200 D0, LD C200, OUT Y0",
     "D0=1 X0=1 | X0=0 | X0=1 | X0=0 X1=1 | X0=1 | X0=0 | X0=1 | X0=0 | X0=1",
     "M8200=0 CN200=1 CS200=1 Y0=1 | M8200=0 Y0=1 | M8200=0 CN200=2 Y0=1 | M8200=1 Y0=1 |"
     "M8200=1 CN200=1 Y0=1 | M8200=1 Y0=1 | M8200=1 CS200=0 CN200=0 Y0=0 | M8200=1 Y0=0 |"
     "M8200=1 CN200=-1 CN200:h=-1 Y0=0"},
    {"RingUpwards", "LD X0, OUT C234 K5", "CN234=-1 CN234:h=32767 X0=1", "CN234=0 CN234:h=-32768"},
    {"RingDownwards", "LD X1, OUT M8234, LD X0, OUT C234 K5", "CN234:h=-32768 X0=1 X1=1",
     "M8234=1 CN234=-1 CN234:h=32767"},
    {"NegativePreset", "LD X0, OUT C200 K-1", "CN200=-2 CN200:h=-1 X0=1", "CN200=-1 CS200=1"},
    {"CountsIntoTheHighWord", "LD X0, OUT C200 K65536", "CN200=-1 X0=1",
     "CN200=0 CN200:h=1 CS200=1"},
    // 70000 = 65536 + 4464
    {"AsOperand", "LD X0, DMOV K70000 C200, DMOV C200 D0, DADD C200 K1 C201", "X0=1",
     "CN200=4464 CN200:h=1 D0=4464 D1=1 CN201=4465 CN201:h=1"},
    {"Reset", "LD X1, RST C200, LD X0, OUT C200 K9", "X0=1 | X1=1 CN200:h=7 | X0=0 X1=0 | X0=1",
     "CN200=1 | CN200=0 CN200:h=0 | | CN200=1"},
};
INSTANTIATE_TEST_SUITE_P(WideCounters, ReferenceStory, testing::ValuesIn(kWideCounters),
                         story_name);

// The scan in which the contact goes on; the coil goes on in `start`.
std::int64_t on_in_scan(const std::string& timer, int preset_value, std::int64_t tick_us,
                        std::int64_t start) {
  const Program program =
      story_program(fmt::format("LD X0, OUT {} K{}", timer, preset_value), Dialect::Fx);
  Reference reference(program, tick_us);
  const Device contact = *parse_device_name(timer, Dialect::Fx);
  for (std::int64_t scan = 0; scan < 20'000; ++scan) {
    if (scan == start) preset(reference, "X0=1", Dialect::Fx);
    reference.run_scan();
    if (reference.get(contact) != 0) return scan;
  }
  return -1;
}

// The first scan after the coil's in which the ticks since then reach the preset: at most one tick
// early, and one scan plus one tick late, against real time.
TEST(ReferenceTimers, AreAsAccurateAsTheirTicks) {
  struct Base {
    const char* timer;
    std::int64_t us;
  };
  for (const Base base : {Base{"T0", 100'000}, Base{"T200", 10'000}, Base{"T256", 1'000}}) {
    for (const std::int64_t tick : {100, 1'000, 7'300, 10'000, 100'000}) {
      for (const int ticks : {1, 2, 7, 15}) {
        for (const std::int64_t start : {0, 1, 13, 999}) {
          std::int64_t scan = start + 1;
          while (scan * tick / base.us - start * tick / base.us < ticks) ++scan;
          const std::int64_t on = on_in_scan(base.timer, ticks, tick, start);
          EXPECT_EQ(on, scan) << base.timer << " K" << ticks << " tick " << tick << " us, from "
                              << start;
          const std::int64_t passed = (on - start) * tick;
          EXPECT_GT(passed, ticks * base.us - base.us);
          EXPECT_LT(passed, ticks * base.us + base.us + tick);
        }
      }
    }
  }
}

}  // namespace
}  // namespace rung

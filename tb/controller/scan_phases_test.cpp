// SPDX-License-Identifier: Apache-2.0
// Scans of the controller: their clocks, their period, states, watchdog, the RUN switch.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "controller/scan_bus.hpp"
#include "programs/random_source.hpp"
#include "unit/instructions.hpp"

namespace rung::tb {
namespace {

namespace c = controller;
using isa::Opcode;

constexpr int kFlip = 20;    // a bit device
constexpr int kNotA = 0x0f;  // LUT row: not a

class Scans : public testing::Test {
 protected:
  // Y of all pins flips each scan; `more` instructions that do nothing.
  void load_flip(int more = 0) {
    bus_.load1(c::space_lut, 0, kNotA);
    std::vector<isa::SlotInstruction> steps = {
        look_up(Opcode::Luto, 0, device(kFlip), device(kFlip), device(kFlip))};
    for (int i = 0; i < more; ++i) steps.push_back(nop());
    bus_.load_steps(steps);
    program_clocks_ = static_cast<int>(steps.size()) + isa::constant::fill_clocks;
    std::vector<IoEntry> refresh;
    for (int i = 0; i < 32; ++i) refresh.push_back({c::refresh_pin, i, false, kFlip});
    bus_.load_io(latch_, refresh);
    refresh_count_ = static_cast<int>(refresh.size());
  }
  int expected(int points, bool ports = false) const {
    return static_cast<int>(latch_.size()) + 4 + program_clocks_ + (ports ? 33 : 4) +
           refresh_count_ + 15 + points + c::micro_exchange_clocks;
  }
  std::uint32_t last() { return bus_.read32(c::reg_scan_last_low); }
  std::uint32_t min() { return bus_.read32(c::reg_scan_min_low); }
  std::uint32_t max() { return bus_.read32(c::reg_scan_max_low); }

  // Clocks at which the pins changed while `count` clocks passed; they must change together.
  std::vector<std::int64_t> edges(std::int64_t count) {
    std::vector<std::int64_t> at;
    std::uint32_t before = bus_->out_o;
    for (std::int64_t i = 0; i < count; ++i) {
      bus_.clock();
      if (bus_->out_o != before) at.push_back(bus_.now);
      before = bus_->out_o;
      EXPECT_TRUE(before == 0 || before == 0xffffffff) << before;
    }
    return at;
  }

  ControllerBus bus_;
  std::vector<IoEntry> latch_ = {{c::latch_pin, 3, false, 5}, {c::latch_ticks, 0, true, 9}};
  int program_clocks_ = 0;
  int refresh_count_ = 0;
};

TEST_F(Scans, ClocksAreAConstantWhateverHappens) {
  RandomSource random(11);
  for (const int points : {0, 1, 16, 200}) {
    load_flip(points % 7);
    bus_.setup(c::setup_exchange_points, points);
    for (const bool ports : {false, true}) {
      bus_.load1(c::space_ports, 0, ports ? 64 << 8 | 3 : 0);
      bus_.command(ControllerBus::kClear);
      EXPECT_EQ(min(), 0xffffffff);
      EXPECT_EQ(max(), 0U);
      bus_.run();
      bus_.before = [&] { bus_->in_i = static_cast<std::uint32_t>(random.bits()); };
      bus_.wait_scans(1);
      const std::uint32_t begin = bus_.scans();
      while (bus_.scans() - begin < 60) {
        ExchangeRequest request;
        request.words = random.percent(50);
        request.raw = random.percent(50);
        const int write = random.below(points + 1);
        for (int i = 0; i < std::min(write, 100); ++i) {
          request.data.push_back(static_cast<std::uint16_t>(random.bits()));
        }
        request.read_count = random.below(std::min(points + 1 - write, 101));
        request.read_first = request.write_first = 50;
        bus_.exchange(request);
        bus_.clocks(random.below(400));
        ASSERT_EQ(last(), static_cast<std::uint32_t>(expected(points, ports)));
      }
      EXPECT_EQ(min(), static_cast<std::uint32_t>(expected(points, ports)));
      EXPECT_EQ(max(), static_cast<std::uint32_t>(expected(points, ports)));
      bus_.stop();
      bus_.before = {};
      bus_.load1(c::space_ports, 0, 0);
    }
  }
}

TEST_F(Scans, FreeRunningScansFollowEachOther) {
  load_flip();
  bus_.run();
  const auto at = edges(20000);
  ASSERT_GT(at.size(), 100U);
  for (std::size_t i = 1; i < at.size(); ++i) ASSERT_EQ(at[i] - at[i - 1], expected(0));
  EXPECT_EQ(bus_.read(c::reg_scan_overruns), 0);
}

TEST_F(Scans, APeriodIsExactAndOverrunsAreCounted) {
  load_flip();
  const int needs = expected(0);
  for (const int period : {needs - 1, needs, needs + 1, needs + 2, needs + 3, 777, 4000}) {
    bus_.setup32(c::setup_period_low, static_cast<std::uint32_t>(period));
    bus_.command(ControllerBus::kClear);
    bus_.run();
    const auto at = edges(20 * period + 200);
    ASSERT_GT(at.size(), 15U);
    for (std::size_t i = 1; i < at.size(); ++i) {
      ASSERT_EQ(at[i] - at[i - 1], std::max(period, needs)) << period;
    }
    bus_.command(ControllerBus::kStop);
    bus_.wait_idle();
    const int overruns = bus_.read(c::reg_scan_overruns);
    if (period >= needs) {
      EXPECT_EQ(overruns, 0) << period;
    } else {
      EXPECT_NEAR(overruns, static_cast<int>(at.size()), 2);
      EXPECT_GT(overruns, 10);
    }
  }
}

TEST_F(Scans, AWatchdogTripsAtItsClock) {
  load_flip(60);
  const int needs = expected(0);
  bus_.setup(c::setup_output + 3, 1);
  bus_.setup(c::setup_output + 4, 2);
  bus_.setup(c::setup_output + 5, 4);
  bus_.setup32(c::setup_watchdog_low, static_cast<std::uint32_t>(needs));
  bus_.run();
  bus_.wait_scans(10);
  EXPECT_EQ(bus_.state(), ControllerBus::kRunning) << "as many clocks as the watchdog allows";
  bus_.stop();
  // A scan that is too long: in whatever phase it is.
  constexpr int kPeriod = 3000;
  bus_.setup32(c::setup_period_low, kPeriod);
  for (const int watchdog : {needs - 1, needs - 20, needs - 60, needs / 2, 20, 4}) {
    bus_.setup32(c::setup_watchdog_low, 0);
    bus_.run();
    // The pins have changed: it is so long since the latch.
    const std::uint32_t safe = bus_->out_o;
    while (bus_->out_o == safe) bus_.clock();
    const std::int64_t latch = bus_.now - (needs - c::micro_exchange_clocks);
    bus_.clocks(500);
    bus_.setup32(c::setup_watchdog_low, static_cast<std::uint32_t>(watchdog));
    const std::uint32_t count = bus_.scans();
    while (bus_->fault_o == 0 && bus_.now < latch + 2 * kPeriod) bus_.clock();
    EXPECT_EQ(bus_.now, latch + kPeriod + watchdog);
    ASSERT_EQ(bus_->fault_o, 1) << watchdog;
    EXPECT_EQ(bus_->out_o & 8U, 8U);
    EXPECT_EQ(bus_->out_o & ~(8U | 16U | 32U), 0U);
    EXPECT_EQ(bus_->out_o & 32U, 32U) << "an inverted pin's safe level";
    EXPECT_EQ(bus_.scans(), count) << "a scan that did not end does not count";
    EXPECT_EQ(bus_.state(), ControllerBus::kFault);
    EXPECT_EQ(bus_.fault(), 1);
    // Reads give 0, nothing hangs.
    EXPECT_EQ(bus_.device_word(9), 0);
    bus_.command(ControllerBus::kRun);
    EXPECT_EQ(bus_.state(), ControllerBus::kFault);
    bus_.command(ControllerBus::kLeave);
    bus_.wait_idle();
    EXPECT_EQ(bus_.fault(), 0);
    // The program is still there, with its length.
    bus_.setup32(c::setup_watchdog_low, 0);
    bus_.run();
    bus_.wait_scans(3);
    EXPECT_EQ(last(), static_cast<std::uint32_t>(needs));
  }
}

TEST_F(Scans, StopRunOneScanAndTheFirst) {
  load_flip();
  EXPECT_EQ(bus_.status() & 0x1f, 0x1c) << "stopped, idle, RUN switch, first scan to come";
  const std::uint32_t count = bus_.scans();
  for (std::uint32_t i = 1; i <= 5; ++i) {
    bus_.command(ControllerBus::kOne);
    EXPECT_EQ(bus_.state(), ControllerBus::kOneScan);
    bus_.wait_idle();
    bus_.clocks(500);
    EXPECT_EQ(bus_.scans(), count + i);
    EXPECT_EQ(bus_.device_bit(kFlip), i % 2 != 0);
    EXPECT_EQ(bus_.status() & 0x10, 0);
    EXPECT_EQ(bus_->out_o, 0U);
  }
  bus_.run();
  bus_.clocks(1000);
  EXPECT_EQ(bus_->run_o, 1);
  bus_.command(ControllerBus::kStop);
  bus_.wait_idle();
  EXPECT_EQ(bus_->out_o, 0U);
  const std::uint32_t stopped = bus_.scans();
  bus_.clocks(1000);
  EXPECT_EQ(bus_.scans(), stopped);
  // A stop while it waits for its period is taken at once.
  bus_.setup32(c::setup_period_low, 100000);
  bus_.run();
  bus_.clocks(2000);
  bus_.command(ControllerBus::kStop);
  bus_.clocks(3);
  EXPECT_EQ(bus_.state(), ControllerBus::kStopped);
}

TEST_F(Scans, TheRunSwitchStopsAndHoldsBack) {
  load_flip();
  bus_.run();
  bus_.wait_scans(2);
  // Bounces of less than 7 ms are nothing.
  for (int i = 0; i < 50; ++i) {
    bus_->run_switch_i = i % 2 == 0 ? 0 : 1;
    bus_.clocks(6 * ControllerBus::kClocksPerMs);
    ASSERT_EQ(bus_.state(), ControllerBus::kRunning);
  }
  bus_->run_switch_i = 0;
  bus_.clocks(9 * ControllerBus::kClocksPerMs + 500);
  EXPECT_EQ(bus_.state(), ControllerBus::kStopped);
  EXPECT_EQ(bus_.status() & 8, 0);
  EXPECT_EQ(bus_->out_o, 0U);
  for (const int command : {ControllerBus::kRun, ControllerBus::kOne}) {
    bus_.command(command);
    bus_.clocks(500);
    EXPECT_EQ(bus_.state(), ControllerBus::kStopped);
  }
  bus_->run_switch_i = 1;
  bus_.clocks(9 * ControllerBus::kClocksPerMs);
  EXPECT_EQ(bus_.status() & 8, 8);
  EXPECT_EQ(bus_.state(), ControllerBus::kStopped) << "the firmware's to start it";
  bus_.run();
  bus_.wait_scans(2);
  EXPECT_EQ(bus_.state(), ControllerBus::kRunning);
}

TEST_F(Scans, AFaultOfTheFirmware) {
  load_flip();
  bus_.run();
  bus_.wait_scans(3);
  bus_.write(c::reg_fault_set, 1);
  EXPECT_EQ(bus_->fault_o, 1);
  EXPECT_EQ(bus_->out_o, 0U);
  EXPECT_EQ(bus_.fault(), 2);
  const std::uint32_t count = bus_.scans();
  bus_.clocks(2000);
  EXPECT_EQ(bus_.scans(), count);
  // Left in the very next clock, the processor is still reset for long enough.
  bus_.command(ControllerBus::kLeave);
  bus_.run();
  bus_.wait_scans(3);
  EXPECT_EQ(last(), static_cast<std::uint32_t>(expected(0)));
}

TEST_F(Scans, NothingIsLoadedIntoARunningProgram) {
  load_flip();
  bus_.run();
  bus_.wait_scans(2);
  bus_.load1(c::space_length, 0, 1);
  bus_.load1(c::space_words, 77, 0x1234);
  bus_.load1(c::space_ports, 0, 64 << 8 | 3);
  bus_.wait_scans(2);
  EXPECT_EQ(last(), static_cast<std::uint32_t>(expected(0)));
  EXPECT_EQ(bus_.device_word(77), 0);
}

TEST_F(Scans, HalfOfAValueIsNeverRead) {
  load_flip();
  bus_.run();
  bus_.wait_scans(3);
  const std::uint16_t low = bus_.read(c::reg_scan_last_low);
  bus_.clocks(1000);
  EXPECT_EQ(low | bus_.read(c::reg_scan_last_high) << 16, expected(0));
  EXPECT_EQ(bus_.read(c::reg_config_id), 2);
  EXPECT_EQ(bus_.read(c::reg_mpu), 2);
}

}  // namespace
}  // namespace rung::tb

// SPDX-License-Identifier: Apache-2.0
// What goes in and out of the controller: latch and refresh, forces, filters, safe states, analogue
// channels, PWM, the lasting memory.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "controller/scan_bus.hpp"
#include "programs/random_source.hpp"
#include "rungs/ports.hpp"
#include "unit/instructions.hpp"

namespace rung::tb {
namespace {

namespace c = controller;
using isa::Mpu;
using isa::Opcode;

class Pins : public testing::Test {
 protected:
  // A port's place in the processor's memories.
  static int port_at(Device port) {
    const isa::Config& config = ControllerBus::config();
    return (port.kind == DeviceKind::PB ? config.bit_devices : config.word_devices) - 1 -
           static_cast<int>(port.number);
  }
  // The pins follow devices 0 to 15, which follow the inputs 0 to 15.
  void load_through() {
    std::vector<IoEntry> latch, refresh;
    for (int i = 0; i < 16; ++i) {
      latch.push_back({c::latch_pin, i, false, i});
      refresh.push_back({c::refresh_pin, i, false, i});
    }
    bus_.load_steps({nop()});
    bus_.load_io(latch, refresh);
  }
  std::uint32_t out() { return bus_->out_o; }

  std::uint32_t in_on_ = 0, in_off_ = 0, out_on_ = 0, out_off_ = 0;  // forces
  RandomSource random_{31};
  ControllerBus bus_;
};

// Each input twice in the list, far apart, while the pins change in every clock: both see the same.
// And all outputs change in one clock: each two are equal at any time.
TEST_F(Pins, AScanSeesItsInputsAtOneTimeAndShowsItsOutputsAtOneTime) {
  std::vector<IoEntry> latch, refresh;
  for (int i = 0; i < 32; ++i) latch.push_back({c::latch_pin, i % 16, false, 100 + i});
  for (int i = 0; i < 32; ++i) refresh.push_back({c::refresh_pin, i, false, 100 + i});
  bus_.load_steps({nop()});
  bus_.load_io(latch, refresh);
  bus_.before = [&] { bus_->in_i = static_cast<std::uint32_t>(random_.bits()); };
  bus_.run();
  std::uint32_t before = 0;
  int changes = 0;
  for (int i = 0; i < 30000; ++i) {
    bus_.clock();
    ASSERT_EQ(out() & 0xffff, out() >> 16);
    changes += out() != before ? 1 : 0;
    before = out();
  }
  EXPECT_GT(changes, 150);
  EXPECT_LT(changes, 300) << "more than one change a scan";
}

TEST_F(Pins, StatusAndTicks) {
  std::vector<IoEntry> latch, refresh;
  for (int i = 0; i < 10; ++i) {
    latch.push_back({c::latch_status, i, false, 200 + i});
    refresh.push_back({c::refresh_pin, i, false, 200 + i});
  }
  for (int i = 0; i < 3; ++i) latch.push_back({c::latch_ticks, i, true, 10 + i});
  latch.push_back({c::latch_none, 0, false, 220});
  refresh.push_back({c::refresh_pin, 10, false, 220});
  bus_.poke(false, 220, 1);
  bus_.load_steps({nop()});
  bus_.load_io(latch, refresh);
  bus_.setup(c::setup_exchange_points, 3);
  // 7.325 ms: never a whole number of them.
  constexpr int kPeriod = 293;
  constexpr std::int64_t kTickUs = kPeriod * 1000 / ControllerBus::kClocksPerMs;
  bus_.setup32(c::setup_period_low, kPeriod);
  const std::uint32_t begin = bus_.scans();
  bus_.run();
  bus_.wait_scans(1);
  for (ScanTime time{0, kTickUs}; time.scan < 3000; ++time.scan) {
    ASSERT_EQ(bus_.scans() - begin, static_cast<std::uint32_t>(time.scan + 1));
    const std::int64_t now = time.scan * kTickUs;
    std::uint32_t want = 2 | (time.scan == 0 ? 4 : 8);
    const int periods[] = {10, 100, 200, 1000, 2000, 60000};
    for (int i = 0; i < 6; ++i) want |= (2 * now / (periods[i] * 1000) % 2) << (4 + i);
    ASSERT_EQ(out(), want) << "scan " << time.scan;
    // The exchange of the next scan, which is the next one's: its ticks.
    ExchangeRequest request;
    request.raw = request.words = true;
    request.read_first = 10;
    request.read_count = 3;
    const auto ticks = bus_.exchange(request);
    const ScanTime next{time.scan + 1, kTickUs};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int64_t bases[] = {1000, 10000, 100000};
      ASSERT_EQ(ticks[i], ticks_since_last(bases[i], next)) << "scan " << next.scan;
    }
    bus_.clocks(5);
    while (bus_.scans() - begin < static_cast<std::uint32_t>(time.scan + 2)) {
    }
  }
}

TEST_F(Pins, ForcesHoldInputsAndOutputs) {
  load_through();
  bus_.run();
  std::uint32_t on = 0, off = 0;
  for (int i = 0; i < 400; ++i) {
    const auto in = static_cast<std::uint32_t>(random_.bits()) & 0xffff;
    bus_->in_i = in;
    const int pin = random_.below(16);
    const int how = random_.below(4) == 0 ? 0 : 2 + random_.below(2);
    const bool output = random_.percent(50);
    bus_.force(output ? 16 + pin : pin, how);
    std::uint32_t& on_now = output ? out_on_ : in_on_;
    std::uint32_t& off_now = output ? out_off_ : in_off_;
    on_now &= ~(1U << pin);
    off_now &= ~(1U << pin);
    if (how == 2) off_now |= 1U << pin;
    if (how == 3) on_now |= 1U << pin;
    bus_.clocks(4);
    bus_.wait_scans(2);
    const std::uint32_t seen = (in & ~in_off_) | in_on_;
    ASSERT_EQ(out(), (seen & ~out_off_) | out_on_);
    ExchangeRequest request;
    request.raw = true;
    request.read_count = 16;
    bus_.setup(c::setup_exchange_points, 16);
    const auto bits = bus_.exchange(request);
    for (std::size_t k = 0; k < 16; ++k) {
      ASSERT_EQ(bits[k], seen >> k & 1) << "a device shows its input's force, not its output's";
    }
    bus_.clocks(600);
    ASSERT_EQ(bus_->forced_o != 0, (in_on_ | in_off_ | out_on_ | out_off_) != 0);
    on |= on_now;
    off |= off_now;
  }
  EXPECT_EQ(on & off, 0xffffU);
  for (int i = 0; i < 32; ++i) bus_.force(i, 0);
  bus_.clocks(1000);
  EXPECT_EQ(bus_->forced_o, 0);
  EXPECT_EQ(out(), bus_->in_i);
  // A force of the last entry of the list, and one that a load of its entry leaves in place; also
  // stopped.
  bus_.stop();
  bus_.force(255, 3);
  bus_.clocks(600);
  EXPECT_EQ(bus_->forced_o, 1);
  bus_.load1(c::space_io, 511, 0);
  bus_.clocks(600);
  EXPECT_EQ(bus_->forced_o, 1);
  bus_.force(255, 0);
  bus_.clocks(600);
  EXPECT_EQ(bus_->forced_o, 0);
}

TEST_F(Pins, AFilterWantsSoManyEqualSamples) {
  constexpr int kSpacing = 10;
  bus_.setup(c::setup_filter_clocks, kSpacing - 1);
  for (int i = 0; i < 16; ++i) bus_.setup(c::setup_filter + i, i);
  for (int i = 16; i < 32; ++i) bus_.setup(c::setup_filter + i, 16 | (i - 16));
  bus_.clocks(1000);
  const auto inputs = [&] {
    return bus_.read(c::reg_inputs) | std::uint32_t{bus_.read(c::reg_inputs + 1)} << 16;
  };
  EXPECT_EQ(inputs(), 0xffff0000);
  for (int round = 0; round < 20; ++round) {
    // A pulse that n samples see: filters of n and fewer show it, those of more do not.
    const int length = 1 + random_.below(15);
    bus_->in_i = 0xffffffff;
    std::uint32_t shown = 0;
    for (int i = 0; i < length * kSpacing - 2; i += 2) shown |= inputs() ^ 0xffff0000;
    bus_->in_i = 0;
    for (int i = 0; i < 400; i += 2) shown |= inputs() ^ 0xffff0000;
    EXPECT_EQ(inputs(), 0xffff0000);
    for (int n = 0; n < 16; ++n) {
      // Its samples are length or, with the ends of what the bus takes, one less or more.
      if (n >= length - 1 && n <= length + 1) continue;
      ASSERT_EQ(shown >> n & 1, n < length ? 1U : 0U) << n << " samples, pulse of " << length;
    }
    EXPECT_EQ(shown & 0xffff, shown >> 16);
  }
  // A level that is interrupted in time never comes through; without a filter two clocks later.
  std::uint32_t seen = 0;
  for (int i = 0; i < 200; ++i) {
    bus_->in_i = 0xffffffff;
    for (int k = 0; k < 4; ++k) bus_.clocks(kSpacing);
    bus_->in_i = 0;
    bus_.clocks(kSpacing + 2);
    seen |= inputs();
  }
  EXPECT_EQ(seen & 0xffc0, 0U);
}

TEST_F(Pins, AnExactFilter) {
  // One filter of n samples, a sample each clock: the edge comes through n clocks behind the two
  // registers.
  load_through();
  for (const int n : {0, 1, 2, 5, 15}) {
    bus_.setup(c::setup_filter, n);
    for (int clocks = 1; clocks < 20; ++clocks) {
      bus_->in_i = 0;
      bus_.clocks(40);
      ASSERT_EQ(bus_.read(c::reg_inputs), 0);
      bus_->in_i = 1;
      bus_.clocks(clocks);
      EXPECT_EQ(bus_.read(c::reg_inputs), clocks >= 2 + n ? 1 : 0) << n << ", " << clocks;
    }
  }
}

TEST_F(Pins, SafeStates) {
  EXPECT_EQ(out(), 0U) << "before any setup";
  load_through();
  // Pins 0 to 7: all eight setups. 8: no entry in the list below.
  for (int i = 0; i < 8; ++i) bus_.setup(c::setup_output + i, i);
  bus_.setup(c::setup_output + 20, 1);
  const std::uint32_t inverted = 0xf0;
  bus_.clocks(2);
  // A kept pin shows what it has shown: 0 since reset.
  EXPECT_EQ(out(), (0x22U | 1U << 20) ^ inverted);
  for (const std::uint32_t in : {0x00U, 0xffU, 0xa5U, 0x5aU}) {
    bus_->in_i = in;
    bus_.run();
    bus_.clocks(800);
    EXPECT_EQ(out(), (in | 1U << 20) ^ inverted);
    EXPECT_EQ(bus_.read(c::reg_outputs), in);
    EXPECT_EQ(bus_.read(c::reg_outputs + 1), 1U << 4);
    const std::uint32_t kept = (in & 0xcc) | 0x22 | 1U << 20;
    if ((in & 1) != 0) {
      bus_.command(ControllerBus::kStop);
      bus_.wait_idle();
    } else {
      bus_.write(c::reg_fault_set, 1);
    }
    bus_.clocks(2);
    EXPECT_EQ(out(), kept ^ inverted);
    EXPECT_EQ(bus_.read(c::reg_outputs), kept & 0xff);
    bus_->in_i = ~in;
    bus_.clocks(500);
    EXPECT_EQ(out(), kept ^ inverted);
    bus_.command(ControllerBus::kLeave);
    bus_.wait_idle();
    // Until the first refresh of the next run nothing changes.
    bus_.setup32(c::setup_period_low, 0);
    bus_.command(ControllerBus::kRun);
    for (int i = 0; i < 40; ++i) {
      bus_.clock();
      EXPECT_EQ(out(), kept ^ inverted);
    }
    bus_.clocks(500);
    EXPECT_EQ(out(), ((~in & 0xffff) | 1U << 20) ^ inverted);
    bus_.stop();
  }
  bus_.dut().reset();
  EXPECT_EQ(out(), 0U);
}

TEST_F(Pins, AnalogueChannels) {
  for (int i = 0; i < 4; ++i) {
    bus_->adc_i[static_cast<std::size_t>(i)] =
        static_cast<std::uint32_t>((0x1000 + 2 * i) | (0x1001 + 2 * i) << 16);
  }
  std::vector<IoEntry> latch;
  for (int i = 0; i < 8; ++i) latch.push_back({c::latch_adc, i, true, 30 + i});
  bus_.load_steps({nop()});
  bus_.load_io(latch, {});
  for (int i = 0; i < 8; ++i) bus_.setup(c::setup_adc_route + i, 7 - i);
  bus_.setup(c::setup_adc_route + 2, 2);
  bus_.load1(c::space_ports, 0, 16 << 8);
  bus_.run();
  bus_.wait_scans(2);
  bus_.stop();
  for (int i = 0; i < 8; ++i) {
    EXPECT_EQ(bus_.device_word(30 + i), 0x1000 + i);
    EXPECT_EQ(bus_.device_word(port_at(port::at(port::adc, i))), 0x1000 + (i == 2 ? 2 : 7 - i));
  }
}

TEST_F(Pins, DutyOfARefreshEntry) {
  const auto high_of = [&](int clocks) {
    int high = 0;
    for (int i = 0; i < clocks; ++i) {
      bus_.clock();
      high += bus_->pwm_o;
    }
    return high;
  };
  bus_.load_steps({nop()});
  bus_.load_io({}, {{c::refresh_pwm, 0, true, 50}});
  bus_.setup32(c::setup_pwm_hz_low, 120'000);  // of 12 MHz: 100 clocks
  bus_.poke(true, 50, 30);
  EXPECT_EQ(high_of(1000), 0);
  bus_.run();
  bus_.clocks(1000);
  EXPECT_EQ(high_of(1000), 300);
  bus_.poke(true, 50, 75);
  bus_.clocks(1000);
  EXPECT_EQ(high_of(1000), 750);
  bus_.stop();
  bus_.clock();
  EXPECT_EQ(high_of(1000), 0);
  bus_.run();
  bus_.clocks(1000);
  EXPECT_EQ(high_of(1000), 750);
  bus_.write(c::reg_fault_set, 0);
  EXPECT_EQ(high_of(1000), 0);
  bus_.command(ControllerBus::kLeave);
  bus_.wait_idle();
  // Without the entry the device ports have it again.
  bus_.load_io({}, {});
  bus_.load_steps({move_constant(10, port_at(port::pwm_duty)),
                   move_constant(60'000, port_at(port::pwm_hz_low))});
  bus_.load1(c::space_ports, 0, 4 << 8);
  bus_.run();
  bus_.clocks(2000);
  EXPECT_EQ(high_of(2000), 200);
}

TEST_F(Pins, TheLastingMemory) {
  const int ready = port_at(port::persist_ready);
  bus_.load_steps({coil(Mpu::Mpu2, Opcode::Rst, ready, true), with_constant(Opcode::Add, 40, 1, 40),
                   word(Opcode::Mv, 0, 40, port_at(port::at(port::persist_value, 5))),
                   move_constant(5, port_at(port::persist_index))});
  bus_.load1(c::space_ports, 0, 64 << 8 | 3);
  bus_.run();
  bus_.wait_scans(5);
  EXPECT_EQ(bus_.read(c::reg_keep_status), 0) << "not ready yet";
  for (int i = 0; i < 5; ++i) {
    bus_.write(c::reg_keep_done, 1);
    bus_.wait_scans(3);
    EXPECT_EQ(bus_.read(c::reg_keep_status), 1);
    EXPECT_EQ(bus_.read(c::reg_keep_index), 5);
    const int value = bus_.read(c::reg_keep_value);
    bus_.wait_scans(5);
    EXPECT_EQ(bus_.read(c::reg_keep_value), value) << "it waits until it is kept";
    EXPECT_LT(value, bus_.device_word(40));
    EXPECT_GE(value, bus_.device_word(40) - 10);
  }
  bus_.write(c::reg_keep_done, 1);
  bus_.write(c::reg_keep_done, 0);
  bus_.wait_scans(5);
  EXPECT_EQ(bus_.read(c::reg_keep_status), 0);
}

TEST_F(Pins, ADivisionByZeroShows) {
  bus_.load_steps({word(Opcode::Div, 60, 61, 62)});
  bus_.poke(true, 61, 1);
  bus_.run();
  bus_.wait_scans(2);
  EXPECT_EQ(bus_.status() & 0x20, 0);
  bus_.poke(true, 61, 0);
  bus_.wait_scans(2);
  EXPECT_EQ(bus_.status() & 0x20, 0x20);
}

}  // namespace
}  // namespace rung::tb

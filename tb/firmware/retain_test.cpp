// SPDX-License-Identifier: Apache-2.0
// What outlives a power cut: latched devices and PERSIST values.
#include "bench.hpp"

namespace rung::tb {
namespace {

namespace c = controller;

class Retain : public Bench {
 protected:
  Retain() { install(sample_program(1).words()); }

  // D2 to D5, M2 to M6 and the PERSIST values, made of a number
  void set(int number) {
    for (int n = 2; n <= 5; ++n) machine_->words[n] = static_cast<std::uint16_t>(number * 16 + n);
    for (int n = 2; n <= 6; ++n) machine_->bits[n] = (number >> (n - 2)) & 1;
    for (int n = 0; n < 3; ++n) persist(n) = static_cast<std::uint16_t>(number + n);
  }
  // The number they are made of; -1: of none, a mixture
  int get() {
    const int number = persist(0);
    bool whole = true;
    for (int n = 2; n <= 5 && number != 0; ++n)
      whole = whole && machine_->words[n] == ((number * 16 + n) & 0xFFFF);
    for (int n = 2; n <= 6; ++n) whole = whole && machine_->bits[n] == ((number >> (n - 2)) & 1);
    for (int n = 0; n < 3 && number != 0; ++n) whole = whole && persist(n) == number + n;
    return whole ? number : -1;
  }
  std::uint16_t& persist(int n) { return machine_->words[kWordDevices - 17 - n]; }
};

TEST_F(Retain, CommandSaves) {
  EXPECT_EQ(holding(c::holding_flags) & 8, 0);
  set(21);
  machine_->bits[7] = 1;  // kept, not latched
  command(6);
  poll(2);
  EXPECT_EQ(holding(c::holding_saves), 1);
  power_on();
  EXPECT_EQ(get(), 21);
  EXPECT_EQ(machine_->bits[7], 0);
  EXPECT_EQ(holding(c::holding_flags) & 8, 8);
  EXPECT_EQ(flash_.violations, 0);
}

TEST_F(Retain, PersistRequestSavesAtOnce) {
  set(3);
  machine_->keep_ready = false;
  machine_->keep_wanted = true;
  poll(1);
  EXPECT_TRUE(machine_->keep_ready);
  power_on();
  EXPECT_EQ(get(), 3);
}

TEST_F(Retain, PersistThatCannotBeSavedIsTriedAgain) {
  set(3);
  flash_.ignores_writes = true;
  machine_->keep_ready = false;
  machine_->keep_wanted = true;
  poll(100);
  EXPECT_FALSE(machine_->keep_ready);
  EXPECT_LT(flash_.writes, 40) << "not in every poll";
  flash_.ignores_writes = false;
  for (int n = 0; n < 4; ++n) {
    machine_->milliseconds_offset += 1000;
    poll(1);
  }
  EXPECT_TRUE(machine_->keep_ready);
  power_on();
  EXPECT_EQ(get(), 3);
}

TEST_F(Retain, StopSavesIfChanged) {
  set(4);
  command(2);
  poll(2);
  EXPECT_EQ(holding(c::holding_saves), 1);
  command(1);
  command(2);
  poll(2);
  EXPECT_EQ(holding(c::holding_saves), 1) << "nothing has changed";
  machine_->words[3] = 1;
  command(1);
  machine_->run_switch = false;
  poll(8);
  EXPECT_EQ(holding(c::holding_saves), 2);
}

TEST_F(Retain, TimeSavesIfChanged) {
  LoadFile file = sample_program(2);
  file.at(c::space_host, c::host_save_seconds, 5);
  install(file.words());
  const int saves = holding(c::holding_saves);
  set(9);
  const auto seconds = [&](int count) {
    for (int n = 0; n < count; ++n) {
      machine_->milliseconds_offset += 1000;
      poll(1);
    }
  };
  seconds(6);
  EXPECT_EQ(holding(c::holding_saves), saves + 1);
  seconds(20);
  EXPECT_EQ(holding(c::holding_saves), saves + 1);
  machine_->words[2] = 1;
  seconds(6);
  EXPECT_EQ(holding(c::holding_saves), saves + 2);
}

TEST_F(Retain, NewProgramKeepsValuesOfItsLayoutOnly) {
  set(5);
  install(sample_program(2).words());
  EXPECT_EQ(mark(), 2);
  EXPECT_EQ(get(), 5);
  LoadFile other = sample_program(3);
  other.retain_id = 7;
  other.at(c::space_host, c::host_retain_id, 7);
  install(other.words());
  EXPECT_EQ(persist(0), 0);
  EXPECT_EQ(machine_->words[2], 0);
  EXPECT_TRUE(machine_->keep_ready);
}

TEST_F(Retain, CommandClears) {
  set(6);
  machine_->bits[7] = 1;
  command(2);
  command(8);
  poll(2);
  for (int n = 0; n < 3; ++n) EXPECT_EQ(persist(n), 0);
  for (int n = 2; n <= 7; ++n) EXPECT_EQ(machine_->bits[n], 0);
  for (int n = 2; n <= 5; ++n) EXPECT_EQ(machine_->words[n], 0);
  power_on();
  EXPECT_EQ(machine_->words[2], 0);
}

// Slots of 64 bytes: the ring has 1,024.
TEST_F(Retain, RingGoesRound) {
  for (int n = 1; n <= 2100; ++n) {
    set(n);
    command(6);
    poll(1);
    if (n % 97 == 0) {
      power_on();
      ASSERT_EQ(get(), n);
    }
  }
  power_on();
  EXPECT_EQ(get(), 2100);
  EXPECT_EQ(flash_.violations, 0);
}

TEST_F(Retain, LargeRecords) {
  LoadFile file = sample_program(2);
  file.keep(3, 3, 10, static_cast<std::uint16_t>(kWordDevices - 50)).keep(4, 2, 300, 417);
  install(file.words());
  for (int round = 0; round < 40; ++round) {
    for (int n = 10; n < kWordDevices - 40; ++n)
      machine_->words[n] = static_cast<std::uint16_t>(n * 77 + round);
    for (int n = 300; n < 717; ++n) machine_->bits[n] = (n + round) % 3 == 0;
    const Words words = machine_->words;
    const Words bits = machine_->bits;
    command(6);
    poll(2);
    power_on();
    for (int n = 10; n < kWordDevices - 40; ++n) ASSERT_EQ(machine_->words[n], words[n]) << n;
    for (int n = 300; n < 717; ++n) ASSERT_EQ(machine_->bits[n], bits[n]) << n;
  }
  EXPECT_EQ(machine_->points_too_many, 0);
  EXPECT_EQ(flash_.violations, 0);
}

TEST_F(Retain, SmallExchanges) {
  LoadFile file = sample_program(2);
  file.at(c::space_setup, c::setup_exchange_points, 17).keep(4, 2, 300, 417);
  install(file.words());
  for (int n = 300; n < 717; ++n) machine_->bits[n] = n % 3 == 0;
  const Words bits = machine_->bits;
  command(6);
  poll(2);
  power_on();
  for (int n = 300; n < 717; ++n) ASSERT_EQ(machine_->bits[n], bits[n]) << n;
}

TEST_F(Retain, PowerCutsLeaveTheOldOrTheNewValues) {
  int last = 0;
  for (unsigned cut = 0; cut < 600; ++cut) {
    const int next = static_cast<int>(cut) + 100;
    set(next);
    flash_.cut_at(static_cast<int>(cut % 3), cut % 5 != 0, cut);
    try {
      for (int n = 0; n < 2; ++n) {
        command(6);
        poll(2);
      }
    } catch (const PowerCut&) {
    }
    power_on();
    ASSERT_EQ(machine_->state, 1);
    ASSERT_TRUE(get() == next || get() == last)
        << "cut " << cut << ": " << get() << ", before " << last;
    last = get();
  }
  EXPECT_GT(last, 600);
  EXPECT_EQ(flash_.violations, 0);
}

TEST_F(Retain, FlashThatIgnoresWritesKeepsTheNewest) {
  set(8);
  command(6);
  poll(2);
  set(9);
  flash_.stuck_busy = true;
  for (int n = 0; n < 40; ++n) {
    command(6);
    poll(2);
  }
  flash_.stuck_busy = false;
  power_on();
  EXPECT_TRUE(get() == 8 || get() == 9);
}

}  // namespace
}  // namespace rung::tb

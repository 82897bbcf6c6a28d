// SPDX-License-Identifier: Apache-2.0
// The port exchange with MPU1: what reaches the program, what it makes of it, and in how many
// clocks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <map>
#include <random>
#include <vector>

#include "peripherals/port_bench.hpp"
#include "unit/instructions.hpp"

namespace rung::tb {
namespace {

using isa::Mpu;
using isa::Opcode;
using Program = std::vector<isa::SlotInstruction>;

constexpr int kEnable = 5;                // bit device of the test's own
constexpr int kTaken = 6, kCount = 7;     // word devices
constexpr int kBefore = 14, kAfter = 18;  // edges, of port_exchange.v's header

isa::SlotInstruction ld(Device port) { return contact(Opcode::Ld, port_address(port)); }
isa::SlotInstruction also(Device port) { return contact(Opcode::And, port_address(port)); }
isa::SlotInstruction clear(Device port, bool always = false) {
  return coil(Mpu::Mpu1, Opcode::Rst, port_address(port), always);
}
isa::SlotInstruction count(int device) {
  isa::SlotInstruction out = word(Opcode::Add, device, 1, device, false);
  out.kind = isa::WordKind::DeviceConstant;
  return out;
}

// Sends back every byte as soon as it can.
Program echo() {
  return {ld(port::uart_rx_full), also(port::uart_tx_ready),
          word(Opcode::Mv, 0, port_address(port::uart_rx_data), port_address(port::uart_tx_data),
               false),
          clear(port::uart_rx_full), clear(port::uart_tx_ready)};
}

// Takes a byte where kEnable allows it, and counts.
Program take() {
  return {ld(port::uart_rx_full), contact(Opcode::And, kEnable),
          word(Opcode::Mv, 0, port_address(port::uart_rx_data), kTaken, false), count(kCount),
          clear(port::uart_rx_full)};
}

int clocks_of(const Program& program) {
  return static_cast<int>(program.size()) + isa::constant::fill_clocks;
}

TEST(Ports, AScanTakesTheSameClocksWhateverHappens) {
  PortBench bench;
  const Program program = echo();
  bench.load(program);
  const int n = clocks_of(program);
  std::mt19937 random(4);
  for (int i = 0; i < 200; ++i) {
    bench->tx_ready_i = random() & 1;
    const ScanTimes times = bench.scan([&](int) {
      bench->rx_valid_i = random() % 8 == 0;
      bench->rx_data_i = static_cast<std::uint8_t>(random());
      bench->persist_ready_i = random() & 1;
    });
    EXPECT_EQ(times.start, kBefore);
    EXPECT_EQ(times.done, kBefore + n);
    EXPECT_EQ(times.end, kBefore + n + kAfter);
    EXPECT_EQ(bench->clocks_o, static_cast<std::uint32_t>(n));
  }
  bench.ports(0, 0);
  const ScanTimes times = bench.scan();
  EXPECT_EQ(times.start, 2);
  EXPECT_EQ(times.done, 2 + n);
  EXPECT_EQ(times.end, 3 + n);
}

TEST(Ports, BackToBackScans) {
  PortBench bench;
  isa::SlotInstruction always = count(kCount);
  always.always = true;
  bench.load({always});
  for (const int bits : {3, 0}) {
    bench.ports(bits, 0);
    for (int i = 0; i < 10; ++i) bench.scan();
  }
  EXPECT_EQ(bench.read(PortBench::kWords, kCount), 20);
}

// A byte at every clock of the scan in which the one before it is taken: none is lost, none comes
// twice.
TEST(Ports, BytesComeAtAnyClock) {
  const int length = kBefore + clocks_of(echo()) + kAfter;
  for (int when = 0; when < length; ++when) {
    PortBench bench;
    bench.load(echo());
    std::vector<int> sent;
    int lost = 0;
    bench.after = [&] {
      if (bench->tx_valid_o != 0) sent.push_back(bench->tx_data_o);
      lost += bench->rx_lost_o;
    };
    bench->rx_valid_i = 1;
    bench->rx_data_i = 0xa1;
    bench.edge();
    bench.scan([&](int e) {
      bench->rx_valid_i = e == when;
      bench->rx_data_i = e == when ? 0xb2 : 0xff;
    });
    EXPECT_EQ(sent, std::vector<int>{0xa1}) << when;
    bench.scan();
    bench.scan();
    EXPECT_EQ(sent, (std::vector<int>{0xa1, 0xb2})) << when;
    EXPECT_EQ(lost, 0) << when;
  }
}

TEST(Ports, EveryByteIsTakenOrWaitsOrIsReportedLost) {
  PortBench bench;
  bench.load(take());
  std::mt19937 random(9);
  std::vector<int> arrived;
  int lost = 0, taken = 0;
  int pause = 0;  // bytes come no closer than bits do
  bench.before = [&] {
    bench->rx_valid_i = pause == 0 && random() % 32 == 0;
    pause = bench->rx_valid_i != 0 ? 8 : std::max(pause - 1, 0);
    bench->rx_data_i = static_cast<std::uint8_t>(random());
    if (bench->rx_valid_i != 0) arrived.push_back(bench->rx_data_i);
  };
  bench.after = [&] { lost += bench->rx_lost_o; };
  for (int i = 0; i < 2000; ++i) {
    bench.write(PortBench::kBits, kEnable, random() & 1);
    if ((random() & 7) == 0) bench.edges(static_cast<int>(random() % 100));
    const std::vector<int> before = arrived;
    bench.scan();
    const int now = bench.read(PortBench::kWords, kCount);
    ASSERT_TRUE(now == taken || now == taken + 1);
    if (now > taken) {
      ASSERT_FALSE(before.empty());
      // The last one that had come when the scan began.
      EXPECT_EQ(bench.read(PortBench::kWords, kTaken), before.back());
    }
    taken = now;
  }
  bench.before = nullptr;
  bench.edge();
  bench.write(PortBench::kBits, kEnable, 1);
  bench.scan();
  bench.scan();
  taken = bench.read(PortBench::kWords, kCount);
  EXPECT_EQ(static_cast<int>(arrived.size()), taken + lost);
  EXPECT_GT(lost, 100);
  EXPECT_GT(taken, 100);
}

TEST(Ports, OnlyAReadyTransmitterGetsAByte) {
  PortBench bench;
  bench.load(
      {clear(port::uart_tx_ready, true), move_constant(0x12c3, port_address(port::uart_tx_data))});
  int valid = 0;
  bench.after = [&] {
    if (bench->tx_valid_o == 0) return;
    ++valid;
    EXPECT_EQ(bench->tx_data_o, 0xc3);
  };
  for (const bool ready : {true, false, true, true, false}) {
    valid = 0;
    bench.scan([&](int e) { bench->tx_ready_i = e == 0 ? ready : !ready; });
    EXPECT_EQ(valid, ready ? 1 : 0);
  }
  // Without the port for the byte the program's bit is its own.
  bench.ports(2, 1);
  valid = 0;
  bench.scan([&](int) { bench->tx_ready_i = 1; });
  EXPECT_EQ(valid, 0);
  // A program that leaves the flag sends nothing.
  bench.ports(3, 64);
  bench.load({nop()});
  bench.scan();
  EXPECT_EQ(valid, 0);
}

TEST(Ports, PwmChangesAtOnceAndEndsWithItsPorts) {
  PortBench bench;
  std::vector<std::uint64_t> seen;
  bench.after = [&] {
    const std::uint64_t now = std::uint64_t{bench->pwm_duty_o} << 32 | bench->pwm_hz_o;
    if (seen.empty() || seen.back() != now) seen.push_back(now);
  };
  bench.load({move_constant(33, port_address(port::pwm_duty)),
              move_constant(0x4240, port_address(port::pwm_hz_low)),
              move_constant(0x000f, port_address(port::pwm_hz_high))});
  bench.scan();
  bench.load({move_constant(0xffff, port_address(port::pwm_duty)),
              move_constant(0x0001, port_address(port::pwm_hz_low)),
              move_constant(0x0010, port_address(port::pwm_hz_high))});
  bench.scan();
  bench.ports(3, 4);
  bench.scan();
  bench.ports(3, 3);
  bench.scan();
  EXPECT_EQ(seen, (std::vector<std::uint64_t>{0, 33ULL << 32 | 1000000, 0xffffULL << 32 | 0x100001,
                                              0xffffULL << 32 | 1, 0}));
}

// Every device before and after a scan of an empty program.
TEST(Ports, OnlyThePortsOfTheProgramAreWritten) {
  PortBench bench;
  bench.load({nop()});
  const int bits = port_config().bit_devices, words = port_config().word_devices;
  const std::pair<int, int> counts[] = {{0, 0}, {0, 1},  {1, 1},  {2, 2}, {3, 6},
                                        {0, 9}, {0, 16}, {2, 12}, {3, 64}};
  for (const auto& [port_bits, port_words] : counts) {
    bench.ports(port_bits, port_words);
    bench->rx_valid_i = 1;
    bench->rx_data_i = 0x5e;
    bench.edge();
    bench->tx_ready_i = 1;
    bench->persist_ready_i = 1;
    for (int i = 0; i < 8; ++i) {
      const auto sample = static_cast<std::uint32_t>(0x1100 * i + 3);
      auto& pair = bench->adc_i[static_cast<std::size_t>(i / 2)];
      pair = i % 2 == 0 ? sample : pair | sample << 16;
    }
    const auto filler = [](int i) { return static_cast<std::uint16_t>(0x8000 + 77 * i); };
    for (int i = 0; i < bits; ++i) bench.write(PortBench::kBits, i, i % 3 == 0);
    for (int i = 0; i < words; ++i) bench.write(PortBench::kWords, i, filler(i));
    std::map<int, int> bit_ports, word_ports;
    // A flag is offered only with the words that belong to it.
    bit_ports[port_address(port::uart_rx_full)] = port_words > 0;
    bit_ports[port_address(port::uart_tx_ready)] = port_words > 1;
    bit_ports[port_address(port::persist_ready)] = port_words > 16;
    word_ports[port_address(port::uart_rx_data)] = 0x5e;
    for (int i = 0; i < 8; ++i) word_ports[port_address(port::at(port::adc, i))] = 0x1100 * i + 3;
    bench.scan();
    for (int i = 0; i < bits; ++i) {
      const bool port = i >= bits - port_bits;
      EXPECT_EQ(bench.read(PortBench::kBits, i), port ? bit_ports.at(i) : (i % 3 == 0 ? 1 : 0))
          << i << " with " << port_bits << " and " << port_words;
    }
    for (int i = 0; i < words; ++i) {
      const bool port = i >= words - port_words && word_ports.count(i) != 0;
      EXPECT_EQ(bench.read(PortBench::kWords, i), port ? word_ports[i] : filler(i))
          << i << " with " << port_bits << " and " << port_words;
    }
  }
}

// A memory that takes some time to keep a value, as a flash does.
TEST(Ports, ValuesAreKeptAndComeBack) {
  PortBench bench;
  std::vector<std::uint16_t> kept(48);
  int busy = 0;
  bool booted = false;
  std::mt19937 random(6);
  // Restored in random clocks, the host between them.
  for (int i = 0; i < 48; ++i)
    kept[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(random());
  std::vector<std::uint16_t> expected = kept;
  for (int i = 0; i < 48;) {
    const bool host = random() % 3 == 0;
    bench->restore_valid_i = 1;
    bench->restore_index_i = static_cast<std::uint8_t>(i);
    bench->restore_value_i = kept[static_cast<std::size_t>(i)];
    if (host)
      bench.write(PortBench::kWords, 10 + i, static_cast<std::uint16_t>(1000 + i));
    else {
      bench->eval();
      ASSERT_EQ(bench->restore_ready_o, 1);
      bench.edge();
      ++i;
    }
  }
  bench->restore_valid_i = 0;
  booted = true;
  for (int i = 0; i < 48; ++i) {
    EXPECT_EQ(bench.word_of(port::at(port::persist_value, i)), kept[static_cast<std::size_t>(i)]);
  }

  bench.after = [&] {
    if (bench->keep_valid_o != 0) {
      ASSERT_LT(bench->keep_index_o, 48);
      ASSERT_EQ(busy, 0);
      kept[bench->keep_index_o] = bench->keep_value_o;
      busy = 500;
    } else if (busy > 0) {
      --busy;
    }
    // The edge that samples keep_valid_o is the one at which ready falls.
    bench->persist_ready_i = booted && busy == 0;
  };
  bench->persist_ready_i = 1;
  int writes = 0;
  for (int i = 0; i < 300; ++i) {
    const int index = static_cast<int>(random() % 48);
    const auto value = static_cast<std::uint16_t>(random());
    bench.load({ld(port::persist_ready),
                with_constant(Opcode::Mv, 0, static_cast<std::uint16_t>(index),
                              port_address(port::persist_index), false),
                with_constant(Opcode::Mv, 0, value,
                              port_address(port::at(port::persist_value, index)), false),
                clear(port::persist_ready)});
    const bool ready = busy == 0;
    bench.scan();
    if (ready) {
      expected[static_cast<std::size_t>(index)] = value;
      ++writes;
    }
    ASSERT_EQ(kept, expected) << i;
    for (int j = 0; j < 48; ++j) {
      if (i % 50 != 0) break;
      EXPECT_EQ(bench.word_of(port::at(port::persist_value, j)),
                expected[static_cast<std::size_t>(j)]);
    }
  }
  EXPECT_GT(writes, 30);
}

TEST(Ports, AnIndexWithoutAValueKeepsNothing) {
  PortBench bench;
  int valid = 0;
  bench.after = [&] { valid += bench->keep_valid_o; };
  bench->persist_ready_i = 1;
  const auto keep = [&](std::uint16_t index) {
    valid = 0;
    bench.load({move_constant(index, port_address(port::persist_index)),
                clear(port::persist_ready, true)});
    bench->persist_ready_i = 1;
    bench.scan();
    return valid;
  };
  EXPECT_EQ(keep(0), 1);
  EXPECT_EQ(keep(47), 1);
  EXPECT_EQ(keep(48), 0);
  EXPECT_EQ(keep(64), 0);
  EXPECT_EQ(keep(0x8001), 0);
  bench.ports(3, 16 + 5);
  EXPECT_EQ(keep(4), 1);
  EXPECT_EQ(keep(5), 0);
  bench.ports(3, 16);
  EXPECT_EQ(keep(0), 0);
}

TEST(Ports, TheHostsLastAccessComesBeforeTheProgram) {
  PortBench bench;
  bench.load({word(Opcode::Mv, 0, kTaken, kCount)});
  for (const int bits : {3, 0}) {
    bench.ports(bits, 0);
    bench->scan_i = 1;  // in the clock of the access
    const auto value = static_cast<std::uint16_t>(0x7700 + bits);
    bench.write(PortBench::kWords, kTaken, value);
    bench->scan_i = 0;
    bench.edges(100);
    EXPECT_EQ(bench->done_o, 1);
    EXPECT_EQ(bench.read(PortBench::kWords, kCount), value);
  }
}

TEST(Ports, AResetInAnyClockEndsTheScan) {
  const int length = kBefore + clocks_of(echo()) + kAfter;
  PortBench bench;
  for (int when = 0; when < length; ++when) {
    bench.load(echo());
    bench->scan_i = 1;
    bench.edge();
    bench->scan_i = 0;
    bench.edges(when);
    bench.reset();
    EXPECT_EQ(bench->busy_o, 0);
    EXPECT_EQ(bench->done_o, 0);
    bench.write(PortBench::kLength, 0, static_cast<std::uint16_t>(echo().size()));
    int sent = 0;
    bench.after = [&] { sent += bench->tx_valid_o; };
    bench->rx_valid_i = 1;
    bench->rx_data_i = static_cast<std::uint8_t>(when);
    bench.edge();
    EXPECT_EQ(bench.scan().end, length);
    EXPECT_EQ(sent, 1) << when;
    bench.after = nullptr;
  }
}

}  // namespace
}  // namespace rung::tb

// SPDX-License-Identifier: Apache-2.0
// The bench around the controller: line, lamps, reset and power, at the pins and at the bytes of
// the line.
#include "controller/simulated_controller.hpp"

#include <gtest/gtest.h>

#include "device/shared_line.hpp"

namespace rung::tb {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Line = ControllerSetup::Line;
using Lamp = device::PinChange::Pin;

Bytes with_crc(Bytes frame) {
  const std::uint16_t crc = device::rtu_crc(frame);
  frame.push_back(static_cast<std::uint8_t>(crc & 0xFF));
  frame.push_back(static_cast<std::uint8_t>(crc >> 8));
  return frame;
}

class Simulated : public testing::TestWithParam<Line> {
 protected:
  std::unique_ptr<SimulatedController> machine =
      SimulatedController::make({.board = "hx8k", .line = GetParam()});

  // Until it says that it has no program.
  void boot() {
    for (int i = 0; i < 1000 && !machine->lamp(Lamp::Fault); ++i) machine->run(1000);
    ASSERT_TRUE(machine->lamp(Lamp::Fault));
  }

  // Silence, a request with its CRC (its byte `bad` spoilt on the line), what comes back.
  Bytes ask(Bytes request, int bad = -1) {
    machine->run(2000);
    machine->receive();
    request = with_crc(std::move(request));
    for (int i = 0; i < static_cast<int>(request.size()); ++i) {
      const std::uint8_t byte = request[static_cast<std::size_t>(i)];
      i == bad ? machine->send_bad(byte) : machine->send(byte);
    }
    machine->run(20'000);
    return machine->receive();
  }

  // The value of a holding register; -1 without an answer.
  int holding(int address) {
    const Bytes reply = ask({1, 3, static_cast<std::uint8_t>(address >> 8),
                             static_cast<std::uint8_t>(address & 0xFF), 0, 1});
    if (reply.size() != 7 || device::rtu_crc(reply) != 0) return -1;
    return reply[3] << 8 | reply[4];
  }
};

TEST_P(Simulated, AnswersAndSaysWhoItIs) {
  boot();
  EXPECT_EQ(holding(controller::holding_identity), 0x5247);
  EXPECT_EQ(holding(controller::holding_board), 2);
  EXPECT_EQ(holding(controller::holding_tables), controller::tables);
  EXPECT_FALSE(machine->lamp(Lamp::Run));
  EXPECT_EQ(machine->flash().misuses(), std::vector<std::string>{});
}

TEST_P(Simulated, BadBytesAreSeenAndCounted) {
  boot();
  const int before = holding(controller::holding_bad_bytes);
  EXPECT_EQ(ask({1, 3, 0xE0, 0, 0, 1}, 2), Bytes{});
  EXPECT_EQ(holding(controller::holding_bad_bytes), before + 1);
}

TEST_P(Simulated, PowerAndReset) {
  boot();
  machine->set_power(false);
  EXPECT_FALSE(machine->lamp(Lamp::Fault));
  EXPECT_EQ(holding(controller::holding_identity), -1);
  const std::uint64_t off = machine->now();
  machine->run(1000);
  EXPECT_EQ(machine->now(), off + 1000);
  machine->set_power(true);
  boot();
  EXPECT_EQ(holding(controller::holding_identity), 0x5247);
  machine->reset();
  EXPECT_FALSE(machine->lamp(Lamp::Fault));
  boot();
  EXPECT_EQ(holding(controller::holding_identity), 0x5247);
}

INSTANTIATE_TEST_SUITE_P(Lines, Simulated, testing::Values(Line::Bits, Line::Bytes),
                         [](const auto& line) {
                           return line.param == Line::Bits ? "Bits" : "Bytes";
                         });

// A client whose line is set otherwise is not understood, and does no harm.
TEST(SimulatedLine, AnotherRateOrParity) {
  const auto machine = SimulatedController::make({.board = "hx8k"});
  for (int i = 0; i < 1000 && !machine->lamp(Lamp::Fault); ++i) machine->run(1000);
  EXPECT_NEAR(machine->clocks_per_bit(), 250'000 / 19'200.0, 0.01);
  EXPECT_EQ(machine->parity(), Parity::Even);
  const auto answered = [&] {
    machine->run(5000);
    machine->receive();
    for (const std::uint8_t byte : with_crc({1, 3, 0xE0, 0, 0, 1})) machine->send(byte);
    machine->run(30'000);
    return machine->receive().size() == 7;
  };
  const auto step = static_cast<std::uint32_t>(8.0 * (1 << 20) * 19'200 / 250'000);
  EXPECT_TRUE(answered());
  machine->fix_line(step, Parity::Odd);
  EXPECT_FALSE(answered());
  machine->fix_line(step / 2, Parity::Even);
  EXPECT_FALSE(answered());
  machine->fix_line(0, Parity::Even);
  EXPECT_TRUE(answered());
}

TEST(SimulatedSetup, WhatIsNotSimulated) {
  EXPECT_THROW(SimulatedController::make({.board = "ulx3s"}), std::runtime_error);
  EXPECT_THROW(SimulatedController::make({.board = "no"}), std::runtime_error);
  EXPECT_THROW(SimulatedController::make({.clocks_per_ms = 7}), std::runtime_error);
}

}  // namespace
}  // namespace rung::tb

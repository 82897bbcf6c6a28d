// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "device/shared_line.hpp"
#include "responder.hpp"

namespace rung::device {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Outcome = SharedLine::Outcome;

Bytes with_crc(Bytes frame) {
  const std::uint16_t crc = rtu_crc(frame);
  frame.push_back(static_cast<std::uint8_t>(crc & 0xFF));
  frame.push_back(static_cast<std::uint8_t>(crc >> 8));
  return frame;
}

const Bytes kRead{1, 3, 0, 0, 0, 1};

struct Line : testing::Test {
  tb::Responder machine;
  SharedLine line{machine};
  Bytes terminal;

  void run_ms(std::uint64_t ms) {
    for (std::uint64_t i = 0; i < ms * 5; ++i) {
      machine.run(tb::Responder::kClocksPerMs / 5);
      const Bytes bytes = line.step();
      terminal.insert(terminal.end(), bytes.begin(), bytes.end());
    }
  }
  // Milliseconds until the gateway has its answer.
  int until_answer(std::optional<SharedLine::Answer>& answer, int most) {
    for (int ms = 0; ms < most; ++ms) {
      run_ms(1);
      if ((answer = line.answer())) return ms;
    }
    return most;
  }
};

TEST(RtuCrc, OfTheSpecification) {
  EXPECT_EQ(rtu_crc(Bytes{0x02, 0x07}), 0x1241);
  EXPECT_EQ(rtu_crc(with_crc(kRead)), 0);
}

TEST_F(Line, TerminalIsAnswered) {
  machine.registers[0] = 0xABCD;
  line.from_terminal(with_crc(kRead));
  run_ms(40);
  EXPECT_EQ(terminal, with_crc({1, 3, 2, 0xAB, 0xCD}));
}

TEST_F(Line, GatewayIsAnsweredAndTheTerminalSeesNothing) {
  machine.registers[0] = 0x1234;
  line.request(kRead);
  std::optional<SharedLine::Answer> answer;
  EXPECT_LT(until_answer(answer, 100), 30);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->outcome, Outcome::Reply);
  EXPECT_EQ(answer->frame, (Bytes{1, 3, 2, 0x12, 0x34}));
  EXPECT_TRUE(terminal.empty());
}

TEST_F(Line, SilentUnitWrongCrcAndBroadcast) {
  std::optional<SharedLine::Answer> answer;
  machine.mute = true;
  line.request(kRead);
  EXPECT_NEAR(until_answer(answer, 3000), SharedLine::kReplyMs, 10);
  EXPECT_EQ(answer->outcome, Outcome::NoReply);

  machine.mute = false;
  machine.wrong_crc = true;
  line.request(kRead);
  EXPECT_LT(until_answer(answer, 3000), 30);
  EXPECT_EQ(answer->outcome, Outcome::NoReply);

  // A broadcast is done with its silence.
  line.request(Bytes{0, 6, 0, 2, 0, 9});
  EXPECT_LT(until_answer(answer, 3000), 15);
  EXPECT_EQ(answer->outcome, Outcome::NoReply);
  EXPECT_EQ(machine.registers[2], 9);
}

// A terminal that asks again at once leaves the gateway its turn, and their frames stay apart.
TEST_F(Line, TakeTurns) {
  const Bytes request = with_crc(kRead);
  const Bytes reply = with_crc({1, 3, 2, 0, 0});
  int terminal_replies = 0, gateway_replies = 0;
  line.from_terminal(request);
  line.request(kRead);
  for (int i = 0; i < 1000; ++i) {
    run_ms(1);
    if (terminal.size() == reply.size()) {
      EXPECT_EQ(terminal, reply);
      terminal.clear();
      ++terminal_replies;
      line.from_terminal(request);
    }
    if (const auto answer = line.answer()) {
      EXPECT_EQ(answer->outcome, Outcome::Reply);
      ++gateway_replies;
      line.request(kRead);
    }
  }
  EXPECT_GT(terminal_replies, 20);
  EXPECT_NEAR(terminal_replies, gateway_replies, 1);
  EXPECT_EQ(machine.bad_frames, 0);
}

// Half a request and then nothing: the gateway gets its turn, and later the terminal too.
TEST_F(Line, TerminalThatStopsHalfway) {
  line.from_terminal(Bytes{1, 3, 0});
  run_ms(5);
  line.request(kRead);
  std::optional<SharedLine::Answer> answer;
  EXPECT_NEAR(until_answer(answer, 1000), SharedLine::kTerminalIdleMs, 40);
  EXPECT_EQ(answer->outcome, Outcome::Reply);
  run_ms(10);
  line.from_terminal(with_crc(kRead));
  run_ms(40);
  EXPECT_EQ(terminal, with_crc({1, 3, 2, 0, 0}));
}

TEST_F(Line, FloodFromTheTerminalIsBoundedAndNoTurnIsSaid) {
  std::optional<SharedLine::Answer> answer;
  machine.mute = true;
  // Without end, and without a pause that could be a turn's end.
  line.from_terminal(Bytes(100, 0x55));
  line.request(kRead);
  const int took = [&] {
    for (int ms = 0; ms < 5000; ++ms) {
      EXPECT_LE(machine.sending(), 512U);
      line.from_terminal(Bytes(std::min<std::size_t>(line.room(), 100), 0x55));
      run_ms(1);
      if ((answer = line.answer())) return ms;
    }
    return 5000;
  }();
  EXPECT_LT(took, 5000);
  EXPECT_EQ(answer->outcome, Outcome::NoTurn);
}

}  // namespace
}  // namespace rung::device

// SPDX-License-Identifier: Apache-2.0
// One unit, number 2, and a neighbour above it that is a script: every byte of the frames, forms
// that cannot be, and what sequence bits, repeats and restarts do.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "Vlink_16.h"
#include "link/link_unit.hpp"
#include "link/world.hpp"
#include "peripherals/uart_lines.hpp"

namespace rung::tb {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr int kBit = flow::link_divisor;
constexpr int kTimeout = 10 * (11 + 2 * flow::flow_block_words) + flow::link_ack_timeout;
constexpr std::uint8_t kAnswer = flow::link_kind_answer << 6;
constexpr std::uint8_t kStart = flow::link_kind_start << 6;

Bytes with_crc(Bytes frame) {
  unsigned crc = 0xffff;
  for (const std::uint8_t byte : frame) {
    crc ^= byte;
    for (int i = 0; i < 8; ++i) crc = crc >> 1 ^ ((crc & 1) != 0 ? 0xa001 : 0);
  }
  frame.push_back(static_cast<std::uint8_t>(crc));
  frame.push_back(static_cast<std::uint8_t>(crc >> 8));
  return frame;
}
Bytes answer(int code, int sequence) {
  return {static_cast<std::uint8_t>(kAnswer | code << 1 | sequence)};
}

class LinkFrames : public testing::Test {
 protected:
  LinkFrames() : world(3), unit(world, 2, 100) { unit.pace = {20, 60, 0, 0, 4, true}; }

  // The clocks of `levels` and of so many bit times more.
  void run(const std::vector<bool>& levels, int bits) {
    for (const bool level : levels) clock(level);
    run_clocks(bits * kBit);
  }
  void clock(bool level) {
    unit.clock(level, true, world.now % 100000 == 0);
    sent.push_back(unit.upper_tx());
    ++world.now;
  }
  void run_clocks(int clocks) {
    for (int i = 0; i < clocks; ++i) clock(true);
  }
  void run_bits(int bits) { run({}, bits); }
  void send_raw(const Bytes& bytes, int bits = 60) {
    LineWriter line(kBit);
    line.idle(flow::link_gap + 2);
    for (const std::uint8_t byte : bytes) line.byte(byte);
    run(line.levels(), bits);
  }
  void send(const Bytes& frame, int bits = 60) { send_raw(with_crc(frame), bits); }

  // The frames that the unit has sent since, without CRC, which is checked; all but START if
  // `quiet`.
  std::vector<Bytes> take(bool with_start = false) {
    for (std::size_t quiet = 0; quiet < 12 * kBit;) {
      run_clocks(kBit);
      quiet = sent.back() ? quiet + kBit : 0;
    }
    const LineReader reader(sent, kBit);
    EXPECT_FALSE(reader.framing_error || reader.cut);
    sent.clear();
    std::vector<Bytes> frames;
    for (std::size_t i = 0; i < reader.bytes.size(); ++i) {
      const bool first = i == 0 || reader.starts[i] - reader.starts[i - 1] > 11 * kBit;
      if (first && i != 0) {
        EXPECT_GE(reader.starts[i] - reader.starts[i - 1],
                  static_cast<std::size_t>((10 + flow::link_gap) * kBit));
      }
      if (first) frames.emplace_back();
      frames.back().push_back(reader.bytes[i]);
    }
    std::vector<Bytes> good;
    for (Bytes& frame : frames) {
      Bytes body(frame.begin(), frame.end() - 2);
      EXPECT_EQ(frame, with_crc(body));
      if (with_start || body != Bytes{kStart}) good.push_back(body);
    }
    return good;
  }
  using Frames = std::vector<Bytes>;

  // A command of unit 1 that the unit has not seen.
  Bytes command(int sequence, bool write, int count, std::uint8_t tag = 0x33) {
    const std::size_t id = world.ask(1, 2, write, count);
    world.asked[id].forgotten = true;  // nobody waits here
    Bytes frame{static_cast<std::uint8_t>(sequence),
                2,
                0x91,
                static_cast<std::uint8_t>(write ? flow::link_type_write : flow::link_type_read),
                tag,
                static_cast<std::uint8_t>(World::board(id)),
                static_cast<std::uint8_t>(World::first(id) >> 8),
                static_cast<std::uint8_t>(World::first(id)),
                static_cast<std::uint8_t>(count)};
    for (int i = 0; write && i < count; ++i) {
      frame.push_back(static_cast<std::uint8_t>(World::word(id, i) >> 8));
      frame.push_back(static_cast<std::uint8_t>(World::word(id, i)));
    }
    return frame;
  }
  // Both directions know where they are.
  void begin() {
    send({kStart});
    run_bits(200);
    send(answer(flow::link_answer_started, 0));
    take();
  }
  int executions() const {
    int n = 0;
    for (const Asked& a : world.asked) n += a.executions;
    return n;
  }

  World world;
  LinkUnit<Vlink_16> unit;
  std::vector<bool> sent;
};

TEST_F(LinkFrames, SequenceBitsTellNewFromRepeated) {
  const Bytes early = command(0, true, 3);
  send(early);
  EXPECT_EQ(take(), Frames{answer(flow::link_answer_unknown, 0)});
  EXPECT_EQ(executions(), 0);
  send({kStart});
  send({kStart});  // as if the first answer had been lost
  EXPECT_EQ(take(),
            (Frames{answer(flow::link_answer_started, 0), answer(flow::link_answer_started, 0)}));
  for (int i = 0; i < 3; ++i) send(early);
  EXPECT_EQ(take(), Frames(3, answer(flow::link_answer_taken, 0)));
  EXPECT_EQ(executions(), 1);
  const Bytes next = command(1, false, 7);
  for (int i = 0; i < 2; ++i) send(next);
  EXPECT_EQ(take(), Frames(2, answer(flow::link_answer_taken, 1)));
  EXPECT_EQ(executions(), 2);
  // The neighbour restarts: bit 0 is new again, though the last one was 1 or 0.
  send(command(0, true, 1));
  send({kStart});
  send(command(0, true, 32));
  EXPECT_EQ(executions(), 4);
  // The unit restarts.
  unit.hold(true);
  run_bits(10);
  unit.hold(false);
  sent.clear();
  send(command(1, true, 1));
  EXPECT_EQ(take(), Frames{answer(flow::link_answer_unknown, 1)});
  EXPECT_EQ(executions(), 4);
}

TEST_F(LinkFrames, WhatCannotBeIsCountedAndNotAnswered) {
  begin();
  unit.pace.least = unit.pace.most = 1U << 30;  // no replies here
  struct Case {
    std::size_t byte;
    std::uint8_t value;
  };
  std::uint16_t bad = 0;
  int sequence = 0;
  for (const Case& c :
       {Case{0, 0x02}, Case{0, 0xc0}, Case{1, 0}, Case{1, 1}, Case{1, 0x12}, Case{2, 0}, Case{2, 2},
        Case{2, 3}, Case{3, 0}, Case{3, 5}, Case{3, 0x81}, Case{8, 0}, Case{8, 33}, Case{8, 200}}) {
    SCOPED_TRACE(testing::Message() << "byte " << c.byte << " is " << int{c.value});
    Bytes frame = command(sequence, c.byte % 2 == 0, 2);
    frame[c.byte] = c.value;
    send(frame, 100);
    EXPECT_EQ(take(), Frames{});
    EXPECT_EQ(unit->upper_bad_o, ++bad);
    // And a good one after it.
    send(command(sequence, true, 2));
    EXPECT_EQ(take(), Frames{answer(flow::link_answer_taken, sequence)});
    sequence ^= 1;
  }
}

TEST_F(LinkFrames, BrokenFramesAreCountedAndNotAnswered) {
  begin();
  unit.pace.least = unit.pace.most = 400 * kBit;  // the reply comes behind the answer
  const Bytes good = with_crc(command(0, true, 4));
  std::uint16_t bad = 0;
  for (std::size_t i = 0; i < good.size(); ++i) {
    Bytes frame = good;
    frame[i] ^= static_cast<std::uint8_t>(1 << i % 8);
    send_raw(frame, 800);  // a wrong count may make it longer: it ends with the silence
    EXPECT_EQ(unit->upper_bad_o, ++bad) << i;
    send_raw(Bytes(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(i)));  // cut
    if (i != 0) ++bad;
    EXPECT_EQ(unit->upper_bad_o, bad) << i;
  }
  // A pause within a frame is an end; a stop bit that is none spoils it.
  for (const bool stop : {true, false}) {
    LineWriter line(kBit);
    line.idle(flow::link_gap + 2);
    for (std::size_t i = 0; i < good.size(); ++i) {
      line.byte(good[i], stop || i != 6);
      if (i == 6) line.idle(stop ? flow::link_gap + 2 : 1);
    }
    run(line.levels(), 60);
  }
  EXPECT_GE(unit->upper_bad_o, bad + 2);
  EXPECT_EQ(take(), Frames{});
  EXPECT_EQ(executions(), 0);
  send_raw(good);
  EXPECT_EQ(take(), Frames{answer(flow::link_answer_taken, 0)});
  run_bits(400);
  EXPECT_EQ(executions(), 1);
}

TEST_F(LinkFrames, AFrameWithoutAnswerIsRepeatedThenGivenUp) {
  begin();
  ASSERT_TRUE(unit.ask(1, true, 5));
  run_bits(4 * (kTimeout + 300));
  Frames frames = take(true);
  ASSERT_GE(frames.size(), 5U);
  EXPECT_EQ(frames[0].size(), 19U);
  EXPECT_EQ(frames[0][0], 0);
  EXPECT_EQ(frames[0][1], 1);
  EXPECT_EQ(frames[0][2] & 15, 2);
  EXPECT_EQ(frames[0][3], flow::link_type_write);
  EXPECT_EQ(frames[0][8], 5);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(frames[0][static_cast<std::size_t>(9 + 2 * i)], World::word(0, i) >> 8);
    EXPECT_EQ(frames[0][static_cast<std::size_t>(10 + 2 * i)], World::word(0, i) & 0xff);
  }
  for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(frames[i], frames[0]);
  EXPECT_EQ(frames[4], Bytes{kStart});
  EXPECT_EQ(unit->upper_again_o, 3);
  EXPECT_EQ(unit->upper_lost_o, 1);
  // Nobody answers START either: a request waits, a reply is dropped.
  send(command(0, false, 1), 1500);
  EXPECT_EQ(unit->upper_lost_o, 2);
  ASSERT_TRUE(unit.ask(1, false, 2));
  run_bits(1000);
  EXPECT_EQ(unit->upper_lost_o, 2);
  sent.clear();
  send(answer(flow::link_answer_started, 0));  // maybe not while it waits for it
  run_bits(1000);
  send(answer(flow::link_answer_started, 0));
  run_bits(300);
  frames = take();
  ASSERT_FALSE(frames.empty());
  EXPECT_EQ(frames[0].size(), 9U);
  EXPECT_EQ(frames[0][0], 0);  // the first bit after START
}

TEST_F(LinkFrames, OnlyItsOwnAnswerCountsAndFullDoesNotWearItOut) {
  begin();
  ASSERT_TRUE(unit.ask(1, false, 9));
  run_bits(300);
  ASSERT_EQ(take().size(), 1U);
  send(answer(flow::link_answer_taken, 1));  // another bit's
  EXPECT_EQ(unit->upper_again_o, 0);
  for (std::uint16_t i = 1; i <= 10; ++i) {
    send(answer(flow::link_answer_full, 0), 320);
    EXPECT_EQ(take().size(), 1U);
    EXPECT_EQ(unit->upper_again_o, i);
  }
  EXPECT_EQ(unit->upper_lost_o, 0);
  // A reply that is ready goes before its next sending, with the same bit, as the request has not
  // been taken.
  send(command(0, false, 1), 100);
  EXPECT_EQ(take(), Frames{answer(flow::link_answer_taken, 0)});
  send(answer(flow::link_answer_full, 0), 100);
  Frames frames = take();
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0][0], 0);
  EXPECT_GE(frames[0][3], flow::link_type_read_reply);
  send(answer(flow::link_answer_taken, 0), 100);
  frames = take();
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0][0], 1);
  EXPECT_EQ(frames[0][3], flow::link_type_read);
}

TEST_F(LinkFrames, AfterTheNeighboursRestartNothingIsDoubled) {
  begin();
  ASSERT_TRUE(unit.ask(1, true, 2));
  run_bits(400);
  const Frames first = take();
  ASSERT_EQ(first.size(), 1U);
  // Its first sending was not taken: it comes again after START.
  send(answer(flow::link_answer_unknown, 0), 100);
  EXPECT_EQ(take(true), Frames{Bytes{kStart}});
  send(answer(flow::link_answer_started, 0), 400);
  EXPECT_EQ(take(), first);
  // A second sending: the first may have been taken, by what the neighbour has forgotten.
  run_bits(kTimeout + 100);
  EXPECT_EQ(take(), first);
  send(answer(flow::link_answer_unknown, 0), 100);
  EXPECT_EQ(take(true), Frames{Bytes{kStart}});
  send(answer(flow::link_answer_started, 0), 1200);
  EXPECT_EQ(take(), Frames{});
  EXPECT_EQ(unit->upper_lost_o, 1);
}

}  // namespace
}  // namespace rung::tb

// SPDX-License-Identifier: Apache-2.0
// Frames of noise and frames a little wrong, on the bytes of the line: at most one answer each,
// only to a right frame for this unit; scans of one length; no device changed but by a right
// request; and the controller still answers.
#include <fmt/format.h>

#include <map>

#include "programs/random_source.hpp"
#include "reliability/two_programs.hpp"
#include "rung_controller.hpp"

namespace rung::tb {
namespace {

namespace c = controller;

constexpr std::uint8_t kUnit = 1;
constexpr int kWords = 8;   // D0 to D7 are what the requests may touch
constexpr int kGuard = 16;  // D8 to D23 must stay as they are

std::uint16_t guard(int n) { return low(0xA500U + static_cast<unsigned>(n) * 257U); }

bool right_crc(const Bytes& frame) {
  return frame.size() >= 4 && with_crc(Bytes(frame.begin(), frame.end() - 2)) == frame;
}

class Frames : public testing::Test {
 protected:
  // Names the devices that requests touch and those that guard them: only they have addresses.
  static std::string touched() {
    std::string list = "LD M98\n";
    for (int n = 0; n < kWords + kGuard; n += 2) list += fmt::format("MOV D{} D{}\n", n, n + 1);
    for (int n = 0; n < 16; ++n) list += fmt::format("LD M{}\nAND M98\nOUT M{}\n", n, n + 16);
    return list;
  }

  // A request that is right in every way; it reads, or writes D0 to D7 and M0 to M15.
  Bytes good() {
    const auto word = [&] { return static_cast<std::uint16_t>(random_.below(0x10000)); };
    Bytes request;
    switch (random_.below(9)) {
      case 0:
        request = pdu(3, {low(static_cast<std::size_t>(random_.below(kWords))),
                          low(static_cast<std::size_t>(1 + random_.below(10)))});
        break;
      case 1:
        request = pdu(1, {low(static_cast<std::size_t>(random_.below(16))),
                          low(static_cast<std::size_t>(1 + random_.below(40)))});
        break;
      case 2:
        request = pdu(5, {low(static_cast<std::size_t>(random_.below(16))),
                          static_cast<std::uint16_t>(random_.percent(50) ? 0xFF00 : 0)});
        break;
      case 3:
        request = pdu(6, {low(static_cast<std::size_t>(random_.below(kWords))), word()});
        break;
      case 4: {
        const int count = 1 + random_.below(16);
        request = pdu(15, {0, low(static_cast<std::size_t>(count))});
        request.push_back(static_cast<std::uint8_t>((count + 7) / 8));
        for (int i = 0; i < (count + 7) / 8; ++i)
          request.push_back(static_cast<std::uint8_t>(word()));
        break;
      }
      case 5: {
        const int count = 1 + random_.below(kWords);
        request = pdu(16, {0, low(static_cast<std::size_t>(count))});
        request.push_back(static_cast<std::uint8_t>(2 * count));
        for (int i = 0; i < 2 * count; ++i) request.push_back(static_cast<std::uint8_t>(word()));
        break;
      }
      case 6:
        request = pdu(22, {low(static_cast<std::size_t>(random_.below(kWords))), word(), word()});
        break;
      case 7:
        request = pdu(8, {0, word()});
        break;
      default:
        request = {43, 14, 1, 0};
    }
    request.insert(request.begin(),
                   random_.percent(85) ? kUnit : static_cast<std::uint8_t>(random_.below(256)));
    return with_crc(request);
  }

  // What goes onto the line, and how often its bytes are to be errors of the line.
  Bytes frame(bool& bad_byte) {
    Bytes bytes = good();
    const auto at = [&](std::size_t size) {
      return static_cast<std::size_t>(random_.below(static_cast<int>(size)));
    };
    bad_byte = false;
    switch (random_.below(8)) {
      case 0:  // as it is
        break;
      case 1:  // bits flipped
        for (int flips = 1 + random_.below(4); flips > 0; --flips) {
          bytes[at(bytes.size())] ^= static_cast<std::uint8_t>(1 << random_.below(8));
        }
        break;
      case 2:
        bytes.resize(1 + at(bytes.size()));
        break;
      case 3:
        for (int more = 1 + random_.below(20); more > 0; --more) {
          bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at(bytes.size() + 1)),
                       static_cast<std::uint8_t>(random_.below(256)));
        }
        break;
      case 4: {  // noise
        bytes.assign(1 + at(random_.percent(5) ? 600 : 40), 0);
        for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random_.below(256));
        break;
      }
      case 5: {  // noise with a right CRC, mostly not of what can be written by it
        bytes.assign(2 + at(30), 0);
        for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random_.below(256));
        if (random_.percent(70)) bytes[0] = kUnit;
        bytes[1] = static_cast<std::uint8_t>(kReading[at(std::size(kReading))]);
        bytes = with_crc(bytes);
        break;
      }
      case 6: {  // right CRC, a count or a length wrong
        bytes.resize(bytes.size() - 2);
        if (bytes.size() > 4) {
          const std::size_t place = 4 + at(bytes.size() - 4);
          bytes[place] = static_cast<std::uint8_t>(random_.below(256));
        }
        if (random_.percent(30)) bytes.push_back(0);
        bytes = with_crc(bytes);
        break;
      }
      default:
        bad_byte = true;
    }
    return bytes;
  }

  // Functions of which no frame writes anything.
  static constexpr int kReading[] = {0,  1,  2,  3,  4,   7,   8,   9,   11,  12,  17, 20,
                                     24, 43, 64, 99, 100, 127, 128, 131, 200, 254, 255};

  const std::uint64_t seed_ = base_seed();
  RandomSource random_{seed_};
};

TEST_F(Frames, NoiseAndMutations) {
  const TwoPrograms programs("hx8k", touched());
  const auto controller = make_controller("hx8k", seed_);
  Client client(*controller);
  install(*controller, client, programs.old.words);
  client.gap = 160;
  Words guards;
  for (int n = 0; n < kGuard; ++n) guards.push_back(guard(n));
  ASSERT_EQ(client.write(kWords, guards), 0);
  client.command(4);
  ASSERT_TRUE(programs.runs(*controller, false));
  controller->changes();
  const auto generation = client.holding_long(c::holding_program_generation);

  const std::uint64_t frames = count(1200, 100'000);
  std::uint64_t answered = 0, exceptions = 0, silent = 0;
  Words known = client.read(0, kWords);
  std::uint64_t lost_before = static_cast<std::uint64_t>(client.holding(c::holding_lost_frames));
  for (std::uint64_t i = 0; i < frames; ++i) {
    bool bad_byte = false;
    const Bytes bytes = frame(bad_byte);
    const bool for_us = !bad_byte && right_crc(bytes) && bytes.size() <= 256 && bytes[0] == kUnit;
    const bool broadcast = !bad_byte && right_crc(bytes) && bytes[0] == 0;
    controller->run(160);
    ASSERT_TRUE(controller->receive().empty()) << "frame " << i << ": an answer to nothing";
    const std::size_t bad_at =
        static_cast<std::size_t>(random_.below(static_cast<int>(bytes.size())));
    for (std::size_t n = 0; n < bytes.size(); ++n) {
      if (bad_byte && n == bad_at) {
        controller->send_bad(bytes[n]);
      } else {
        controller->send(bytes[n]);
      }
    }
    const auto shown = [&] {
      std::string text = fmt::format("frame {} of seed {}:", i, seed_);
      for (const auto byte : bytes) text += fmt::format(" {:02x}", byte);
      return text;
    };
    // An answer takes longer than this after the last byte only if something hangs.
    Bytes answer;
    const std::uint64_t patience = for_us ? 40'000 : 1'500;
    std::uint64_t quiet = 0;
    while (quiet < (answer.empty() ? patience : 150)) {
      controller->run(50);
      quiet = controller->sending() > 0 ? 0 : quiet + 50;
      for (const auto byte : controller->receive()) {
        answer.push_back(byte);
        quiet = 0;
      }
    }
    if (for_us) {
      ASSERT_TRUE(right_crc(answer)) << shown();
      ASSERT_EQ(answer[0], kUnit) << shown();
      ASSERT_EQ(answer[1] & 0x7F, bytes[1] & 0x7F) << shown();
      ++answered;
      if ((answer[1] & 0x80) != 0) {
        ++exceptions;
        ASSERT_EQ(answer.size(), 5U) << shown();
      }
    } else {
      ASSERT_TRUE(answer.empty()) << shown();
      ++silent;
      if (broadcast) controller->run(4'000);
    }
    const bool may_write = (for_us && (answer[1] & 0x80) == 0) || broadcast;
    if (i % 16 == 15 || may_write) {
      const Words now = client.read(0, kWords);
      if (!may_write) {
        ASSERT_EQ(now, known) << shown();
      }
      known = now;
    }
    if (i % 64 == 63) {
      ASSERT_EQ(client.read(kWords, kGuard), guards) << shown();
      const Words scans = client.read(c::holding_scan_last, 6);
      ASSERT_EQ(scans[0], scans[2]) << shown();
      ASSERT_EQ(scans[0], scans[4]) << shown();
      ASSERT_TRUE(controller->changes().empty()) << shown();
    }
  }
  EXPECT_EQ(client.holding_long(c::holding_program_generation), generation);
  EXPECT_EQ(client.holding(c::holding_state), 1);
  EXPECT_EQ(static_cast<std::uint64_t>(client.holding(c::holding_lost_frames)), lost_before);
  EXPECT_TRUE(programs.runs(*controller, false));
  note("frames", frames);
  note("answered", answered);
  note("exceptions", exceptions);
  note("not_answered", silent);
}

// Requests one behind the other, not waiting for answers, while the plant's inputs change: what is
// lost is counted, scans stay as they are.
TEST_F(Frames, Flood) {
  const TwoPrograms programs("hx8k", touched());
  const auto controller = make_controller("hx8k", seed_);
  Client client(*controller);
  install(*controller, client, programs.old.words);
  client.gap = 160;
  client.command(4);
  std::uint64_t sent = 0, bytes = 0;
  const std::uint64_t all = count(400, 20'000);
  while (sent < all) {
    const Bytes frame = good();
    for (const auto byte : frame) controller->send(byte);
    // From no gap at all to just enough.
    controller->run(frame.size() * 16 + static_cast<std::uint64_t>(random_.below(130)));
    bytes += controller->receive().size();
    if (++sent % 8 == 0) controller->set_input(programs.x0, random_.percent(50));
  }
  controller->run(20'000);
  controller->receive();
  const Words scans = client.read(c::holding_scan_last, 6);
  EXPECT_EQ(scans[0], scans[2]);
  EXPECT_EQ(scans[0], scans[4]);
  EXPECT_EQ(scans[0], programs.old.timing.cycle);
  EXPECT_TRUE(programs.runs(*controller, false));
  EXPECT_GT(bytes, 0U);
  note("requests", sent);
  note("bytes_answered", bytes);
  note("lost", static_cast<std::uint64_t>(client.holding(c::holding_lost_frames)));
}

}  // namespace
}  // namespace rung::tb

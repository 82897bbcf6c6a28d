// SPDX-License-Identifier: Apache-2.0
// Random and mutated frames: whatever comes, an answer is one of the protocol's, nothing outside
// the request changes, and the firmware is there for the next one.
#include <cstdlib>
#include <random>

#include "bench.hpp"

namespace rung::tb {
namespace {

namespace c = controller;

constexpr int kFrames = kConfig == "ecp5" ? 100'000 : 20'000;

class Random : public Bench {
 protected:
  std::mt19937 random_;
  int up_to(int most) { return std::uniform_int_distribution<int>(0, most)(random_); }

  Bytes seed_frame() {
    static const int firsts[] = {
        0,      area("M").first, area("Y").first,        area("X").first,
        0x1F40, 0xE000,          c::holding_force_point, c::holding_load_command,
        0xE102, 0xE110,          c::holding_window,      0xFFFF};
    const int first = firsts[up_to(11)] + up_to(8);
    const int count = up_to(3) == 0 ? up_to(0xFFFF) : up_to(20);
    const auto word = [](int value) { return static_cast<std::uint16_t>(value); };
    static const int functions[] = {1, 2, 3, 4, 5, 6, 8, 15, 16, 22, 23, 43};
    const int function = functions[up_to(11)];
    Bytes out = pdu(function, {word(first), word(function == 5 ? up_to(1) * 0xFF00 : count)});
    if (function == 8) out = pdu(8, {word(up_to(1)), word(count)});
    if (function == 22) out = pdu(22, {word(first), word(up_to(0xFFFF)), word(up_to(0xFFFF))});
    if (function == 43)
      out = {43, 14, static_cast<std::uint8_t>(up_to(5)), static_cast<std::uint8_t>(up_to(4))};
    if (function == 23) {
      const Bytes more = pdu(0, {word(firsts[up_to(11)] + up_to(8)), word(count)});
      out.insert(out.end(), more.begin() + 1, more.end());
    }
    if (function == 15 || function == 16 || function == 23) {
      const int bytes = function == 15 ? (count + 7) / 8 : 2 * count;
      out.push_back(static_cast<std::uint8_t>(bytes));
      for (int n = 0; n < (bytes & 255) && out.size() < 253; ++n)
        out.push_back(static_cast<std::uint8_t>(up_to(255)));
    }
    out.insert(out.begin(), static_cast<std::uint8_t>(up_to(20) == 0 ? 0 : 17));
    return out;
  }

  void mutate(Bytes& frame) {
    switch (up_to(5)) {
      case 0:
        frame.resize(static_cast<std::size_t>(up_to(252)) + 2);
        break;
      case 1:
        frame[static_cast<std::size_t>(up_to(static_cast<int>(frame.size()) - 1))] ^= 1U
                                                                                      << up_to(7);
        break;
      case 2:
        for (auto& byte : frame) byte = static_cast<std::uint8_t>(up_to(255));
        frame[0] = 17;
        break;
      case 3:
        frame[1] = static_cast<std::uint8_t>(up_to(255));
        break;
      default:
        break;
    }
  }

  static void check_answer(const Bytes& frame, const Bytes& answer) {
    ASSERT_FALSE(answer.empty());
    ASSERT_EQ(answer[0], 17);
    ASSERT_EQ(answer[1] & 0x7F, frame[1] & 0x7F);
    if (((answer[1] ^ frame[1]) & 0x80) != 0 || frame[1] >= 128) {
      ASSERT_EQ(answer.size(), 3U);
      ASSERT_TRUE(answer[2] >= 1 && answer[2] <= 4);
      return;
    }
    if (frame[1] <= 4 || frame[1] == 23) {
      ASSERT_EQ(answer.size(), 3U + answer[2]);
      const int count = frame[4] << 8 | frame[5];
      ASSERT_EQ(answer[2], frame[1] <= 2 ? (count + 7) / 8 : 2 * count);
    }
  }
};

TEST_F(Random, Frames) {
  const char* given = std::getenv("RUNG_SEED");
  const unsigned seed = given != nullptr ? static_cast<unsigned>(std::strtoul(given, nullptr, 10))
                                         : std::random_device{}();
  SCOPED_TRACE("RUNG_SEED=" + std::to_string(seed) + " unit_firmware_" + std::string(kConfig) +
               " --gtest_filter=Random.Frames");
  random_.seed(seed);
  LoadFile file = sample_program(1);
  install(file.words());
  int answered = 0;
  int accepted = 0;
  for (int n = 0; n < kFrames; ++n) {
    Bytes frame = seed_frame();
    if (up_to(1) == 0) mutate(frame);
    const bool ours = frame[0] == 17 || frame[0] == 0;
    const Words bits = machine_->bits;
    const Words words = machine_->words;
    const Words bit_map = machine_->bit_map;
    const bool was_stopped = machine_->state == 0;
    machine_->sending = 0;
    const Bytes answer = send(frame);
    if (frame[0] == 17) {
      check_answer(frame, answer);
      ++answered;
      accepted += answer.size() > 1 && answer[1] < 128 ? 1 : 0;
    } else {
      ASSERT_TRUE(answer.empty());
    }
    if (HasFatalFailure() || HasFailure()) FAIL() << "frame " << n;
    // Devices change by writes, and by commands of a controller that is stopped; instructions
    // never.
    const bool writes = ours && (frame[1] == 5 || frame[1] == 6 || frame[1] == 15 ||
                                 frame[1] == 16 || frame[1] == 22 || frame[1] == 23);
    if (!writes) {
      ASSERT_EQ(machine_->bits, bits);
      ASSERT_EQ(machine_->words, words);
    }
    if (!was_stopped && machine_->state == 1) {
      for (int d = 8; d < kBitDevices; ++d) {
        const bool mapped = (d >= 100 && d < 108) || (d >= 200 && d < 208);
        if (!mapped) {
          ASSERT_EQ(machine_->bits[d], bits[d]) << d;
        }
      }
      for (int d = 8; d < kWordDevices; ++d) ASSERT_EQ(machine_->words[d], words[d]) << d;
    }
    ASSERT_EQ(mark(), 1);
    ASSERT_EQ(machine_->bit_map, bit_map);
    ASSERT_EQ(machine_->points_too_many, 0);
    ASSERT_EQ(machine_->loads_while_running, 0);
  }
  EXPECT_EQ(flash_.violations, 0);
  EXPECT_GT(answered, kFrames / 2);
  EXPECT_GT(accepted, kFrames / 20);
  // And it still works.
  EXPECT_EQ(ask(pdu(3, {0xE000, 1})), (Bytes{3, 2, 0x52, 0x47}));
  power_on();
  EXPECT_EQ(mark(), 1);
}

}  // namespace
}  // namespace rung::tb

// SPDX-License-Identifier: Apache-2.0
// LDmicro programs on the board top, from file to pins: the bytes on the real serial line are those
// that the reference sends, although the times differ, and the PWM output is as the program sets
// it.
#include "ldmicro/ldmicro.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "boards/board.hpp"
#include "driver/compile.hpp"
#include "peripherals/uart_lines.hpp"
#include "reference/reference.hpp"
#include "rungs/names.hpp"
#include "rungs/ports.hpp"

namespace rung::tb {
namespace {

constexpr double kClocksABit = 12e6 / 115200;

// Sends "v=-42" and a line's end at power-up and whenever Xa goes on, and sends back each byte
// received, raised by one; 30 % at 2 kHz.
constexpr std::string_view kFile =
    "LDmicro0.1\nCYCLE=1000\nCRYSTAL=12000000\nBAUD=115200\n\nPROGRAM\n"
    "RUNG\nMOVE v -42\nEND\n"
    "RUNG\nMOVE duty 30\nEND\n"
    "RUNG\nSET_PWM duty 2000\nEND\n"
    "RUNG\nCONTACTS Xa 0\nFORMATTED_STRING v 9 118 61 92 45 50 92 114 92 110\nEND\n"
    "RUNG\nUART_RECV r\nADD t r 1\nUART_SEND t\nEND\n";

Program program() {
  Diagnostics diagnostics;
  const auto source = decode_ldmicro(kFile, "t.ld", diagnostics);
  return parse_ldmicro(*source, diagnostics).value();
}

const std::vector<std::uint8_t> kBytes = {0x00, 0x7f, 0x80, 0xff, 0x41, 0x42, 0x43};

// Text, echo, text again.
std::vector<std::uint8_t> expected(const Program& program) {
  Reference reference(program);
  std::vector<std::uint8_t> sent;
  const auto scans = [&](int count) {
    for (int i = 0; i < count; ++i) {
      reference.run_scan();
      for (const int byte : reference.sent()) sent.push_back(static_cast<std::uint8_t>(byte));
    }
  };
  scans(30);
  for (const std::uint8_t byte : kBytes) {
    reference.set(port::uart_rx_data, byte);
    scans(3);
  }
  reference.set(*DeviceNames(program).device("Xa"), 1);
  scans(30);
  return sent;
}

template <typename Which>
class LdmicroOnBoard : public testing::Test {
 protected:
  void load(const image::Image& image) {
    const isa::Config& config = *isa::find_config("hx8k");
    const int slot_bits = isa::slot_bits(Which::kMpu, config);
    for (std::size_t step = 0; step < image.steps.size(); ++step) {
      std::vector<std::uint16_t> chunks(
          static_cast<std::size_t>((slot_bits * isa::slots(Which::kMpu) + 15) / 16));
      int at = 0;
      for (const isa::SlotInstruction& instruction : image.steps[step]) {
        const std::uint64_t code = isa::encode(instruction, Which::kMpu, config);
        for (int bit = 0; bit < slot_bits; ++bit, ++at) {
          if ((code >> bit & 1) == 0) continue;
          chunks[static_cast<std::size_t>(at / 16)] |= static_cast<std::uint16_t>(1U << at % 16);
        }
      }
      for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk) {
        board_.write(kSteps, static_cast<std::uint32_t>(step * 8 + chunk), chunks[chunk]);
      }
    }
    for (std::size_t row = 0; row < image.lut.size(); ++row) {
      board_.write(kLut, static_cast<std::uint32_t>(row), image.lut[row]);
    }
    for (int i = 0; i < image.statistics.bit_devices; ++i) {
      board_.write(kBits, static_cast<std::uint32_t>(i), 0);
    }
    for (int i = 0; i < image.statistics.word_devices; ++i) {
      board_.write(kWords, static_cast<std::uint32_t>(i), 0);
    }
    for (int i = 1; i <= image.port_words; ++i) {
      board_.write(kWords, static_cast<std::uint32_t>(config.word_devices - i), 0);
    }
    for (const image::ImageConstant& each : image.constants) {
      board_.write(kWords, static_cast<std::uint32_t>(each.address),
                   static_cast<std::uint16_t>(each.value));
    }
    board_.write(kLength, 0, static_cast<std::uint16_t>(image.steps.size()));
    const std::uint32_t step = baud_step(12e6 / static_cast<double>(image.baud));
    board_.write(kPorts, 0, static_cast<std::uint16_t>(image.port_words << 8 | image.port_bits));
    board_.write(kPorts, 1, static_cast<std::uint16_t>(step));
    board_.write(kPorts, 2, static_cast<std::uint16_t>(step >> 16));
  }

  // Scans one behind the other while the line receives `levels`; adds what the other line sends.
  void scans(const std::vector<bool>& levels, std::vector<std::uint8_t>& sent) {
    board_.send(levels);
    while (board_.sending()) board_.exchange(kStart);
    const LineReader line(board_.tx(), kClocksABit);
    EXPECT_FALSE(line.framing_error || line.cut);
    sent.insert(sent.end(), line.bytes.begin(), line.bytes.end());
  }

  Board<typename Which::Top> board_;
};
TYPED_TEST_SUITE(LdmicroOnBoard, BoardCases);

TYPED_TEST(LdmicroOnBoard, BytesAndPwmAreTheReferences) {
  const Program source = program();
  Diagnostics diagnostics;
  CompileOptions options;
  options.mpu = TypeParam::kMpu;
  options.config = isa::find_config("hx8k");
  const auto compiled = compile(source, options, diagnostics);
  ASSERT_TRUE(compiled);
  const image::Image& image = compiled->image;
  EXPECT_EQ(image.port_bits, 2);
  EXPECT_EQ(image.port_words, 4);
  this->load(image);

  std::vector<std::uint8_t> sent;
  LineWriter quiet(kClocksABit);
  quiet.idle(120);
  LineWriter line(kClocksABit);
  line.idle(3);
  for (const std::uint8_t byte : kBytes) line.byte(byte);
  line.idle(30);
  this->scans(quiet.levels(), sent);
  this->scans(line.levels(), sent);
  const auto input = std::find_if(image.devices.begin(), image.devices.end(),
                                  [](const auto& device) { return device.name == "Xa"; });
  ASSERT_NE(input, image.devices.end());
  this->board_.write(kBits, static_cast<std::uint32_t>(input->address), 1);
  this->scans(quiet.levels(), sent);

  EXPECT_EQ(sent, expected(source));
  EXPECT_EQ(std::string(sent.begin(), sent.begin() + 7), "v=-42\r\n");
  EXPECT_EQ(sent.size(), 2 * 7 + kBytes.size());
  // Periods of 6,000 clocks, of which 1,800 are on.
  const std::vector<bool>& pwm = this->board_.pwm();
  ASSERT_GE(pwm.size(), 2 * 6000U);
  EXPECT_EQ(std::count(pwm.begin(), pwm.begin() + 6000, true), 1800);
  EXPECT_TRUE(std::equal(pwm.begin(), pwm.begin() + 6000, pwm.begin() + 6000));
}

}  // namespace
}  // namespace rung::tb

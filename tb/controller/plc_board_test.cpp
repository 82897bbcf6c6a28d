// SPDX-License-Identifier: Apache-2.0
// The controller's board top of the iCE40-HX8K through its pins, at its own 12 MHz: it finds its
// program in the flash behind the bitstream, answers Modbus RTU at the baud rate of the program's
// I/O map, refreshes its pins, and keeps what is not its own of the flash.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <verilated.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "Vplc_hx8k.h"
#include "controller/bit_line.hpp"
#include "controller/flash_model.hpp"
#include "device/flash_image.hpp"
#include "harness/model_coverage.hpp"
#include "host/support.hpp"
#include "load/load_file.hpp"

namespace rung::tb {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::int64_t kClockHz = 12'000'000;
constexpr std::int64_t kBaud = 115200;
constexpr std::uint64_t kMs = kClockHz / 1000;
constexpr std::uint8_t kUnit = 17;

// Y0 is X0 and M5, Y1 is not X1, D2 is D1 + 3.
constexpr const char* kProgram = R"(LD X0
AND M5
OUT Y0
LDI X1
OUT Y1
LD M8000
ADD D1 K3 D2
END
)";
constexpr const char* kMap = R"(board = "hx8k"
[modbus]
unit = 17
baud = 115200
parity = "odd"
[inputs]
X0 = "t1"
X1 = { pin = "r6", invert = true }
[outputs]
Y0 = "t5"
Y1 = { pin = "t11", safe = 1 }
)";
constexpr unsigned kT1 = 1U << 0, kR6 = 1U << 7, kT5 = 1U << 4, kT11 = 1U << 11;

const controller::Board& hx8k() {
  const auto& all = controller::boards();
  return *std::find_if(all.begin(), all.end(), [](const auto& one) { return one.name == "hx8k"; });
}

std::vector<std::uint16_t> load_file() {
  Diagnostics diagnostics;
  const image::Image image = image_of(program_of(kProgram), hx8k().mpu, "hx8k");
  const auto map = io::parse_map(kMap, "m.toml", diagnostics);
  if (!map) throw std::runtime_error(printed(diagnostics));
  const auto bindings = io::bind(*map, load::subject_of(image), diagnostics);
  const auto words = load::make(image, bindings, kClockHz, diagnostics);
  if (!words) throw std::runtime_error(printed(diagnostics));
  return *words;
}

std::uint16_t crc16(const Bytes& bytes) {
  unsigned crc = 0xFFFF;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? crc >> 1 ^ 0xA001 : crc >> 1;
  }
  return static_cast<std::uint16_t>(crc);
}

class PlcHx8k : public testing::Test {
 protected:
  PlcHx8k() {
    context_.randReset(2);
    context_.randSeed(7);
    top_ = std::make_unique<Vplc_hx8k>(&context_);
    top_->clk_12mhz_i = 0;
    top_->in_i = 0;
    top_->run_switch_i = 1;
    top_->rx_i = 1;
    top_->host_rx_i = 1;
    top_->flash_miso_i = 1;
    line_.set_rate(static_cast<std::uint32_t>((8 * kBaud << 20) / kClockHz), Parity::Odd);
  }
  ~PlcHx8k() override {
    top_->final();
    count_coverage(context_);
  }

  void clock() {
    top_->host_rx_i = line_.level(now_);
    top_->clk_12mhz_i = 0;
    top_->eval();
    top_->clk_12mhz_i = 1;
    top_->eval();
    line_.sample(++now_, top_->host_tx_o != 0);
    driver_seen_ = driver_seen_ || top_->host_de_o != 0;
    undriven_ = undriven_ || (top_->host_tx_o == 0 && top_->host_de_o == 0);
    top_->flash_miso_i =
        flash_.clock(top_->flash_csn_o != 0, top_->flash_sck_o != 0, top_->flash_mosi_o != 0);
  }
  void run(std::uint64_t clocks) {
    for (const std::uint64_t end = now_ + clocks; now_ < end;) clock();
  }
  // Clocks until the run lamp lights, at most `most`.
  bool runs_within(std::uint64_t most) {
    run(kMs);  // the reset is over; before it the lamp shows anything
    for (const std::uint64_t end = now_ + most; now_ < end && top_->run_o == 0;) clock();
    return top_->run_o != 0;
  }
  // The reply to a PDU, without unit and CRC; empty: none, or not a whole one.
  Bytes ask(Bytes pdu) {
    pdu.insert(pdu.begin(), kUnit);
    const std::uint16_t crc = crc16(pdu);
    pdu.insert(pdu.end(), {static_cast<std::uint8_t>(crc), static_cast<std::uint8_t>(crc >> 8)});
    for (const std::uint8_t byte : pdu) line_.send(byte);
    Bytes reply;
    // 30 ms: two frames of at most 20 characters, two silences of 1.75 ms, a few scans.
    for (const std::uint64_t end = now_ + 30 * kMs; now_ < end;) {
      run(kMs / 4);
      const Bytes more = line_.take();
      reply.insert(reply.end(), more.begin(), more.end());
      if (reply.size() > 4 && crc16(reply) == 0) break;
    }
    if (reply.size() < 4 || crc16(reply) != 0 || reply[0] != kUnit) return {};
    return {reply.begin() + 1, reply.end() - 2};
  }

  VerilatedContext context_;
  std::unique_ptr<Vplc_hx8k> top_;
  FlashModel flash_{2 << 20};
  BitLine line_;
  std::uint64_t now_ = 0;
  bool driver_seen_ = false, undriven_ = false;
};

TEST_F(PlcHx8k, BootsFromItsFlashAndAnswers) {
  const auto words = load_file();
  // The bitstream's part of the flash, which is not the controller's.
  std::fill_n(flash_.memory().begin(), hx8k().flash_base * controller::flash_sector_bytes, 0x5A);
  device::put_program(flash_.memory(), hx8k(), words);
  const Bytes before = flash_.memory();

  ASSERT_TRUE(runs_within(500 * kMs)) << "fault lamp " << int{top_->fault_o};
  EXPECT_EQ(top_->fault_o, 0);
  run(kMs);
  // X1's pin is 0 and inverted: X1 is 1, so Y1 is 0 now that the program runs; its safe level is 1.
  EXPECT_EQ(top_->out_o, 0U);

  // M5 on, Y0 follows X0 within two scans and the synchroniser; then D1, and D2 of it.
  EXPECT_EQ(ask({5, 0, 5, 0xFF, 0}), (Bytes{5, 0, 5, 0xFF, 0}));
  EXPECT_EQ(top_->out_o, 0U);
  top_->in_i = kT1 | kR6;
  run(kMs);
  EXPECT_EQ(top_->out_o, kT5 | kT11);
  EXPECT_EQ(ask({6, 0, 1, 0x12, 0x34}), (Bytes{6, 0, 1, 0x12, 0x34}));
  EXPECT_EQ(ask({3, 0, 1, 0, 2}), (Bytes{3, 4, 0x12, 0x34, 0x12, 0x37}));
  // What it says of itself: identity, interface, board, configuration, processor.
  EXPECT_EQ(ask({3, 0xE0, 0, 0, 5}),
            (Bytes{3, 10, 0x52, 0x47, 0, 1, 0, 2, 0, 2, 0, static_cast<std::uint8_t>(hx8k().mpu)}));
  // A coil of M that the HX8K does not have.
  EXPECT_EQ(ask({1, 0x02, 0x00, 0, 1}), (Bytes{0x81, 2}));

  // The force lamp, with the output forced; X is 0x3400 of the inputs, Y 0x3300.
  ask({6, 0xE0, 0x41, 0x33, 0x00});
  ask({6, 0xE0, 0x42, 0, 0});
  run(2 * kMs);
  EXPECT_EQ(top_->out_o, kT11);
  EXPECT_EQ(top_->forced_o, 1);

  // STOP at the switch: outputs safe.
  top_->run_switch_i = 0;
  run(20 * kMs);
  EXPECT_EQ(top_->run_o, 0);
  EXPECT_EQ(top_->out_o, kT11);
  top_->in_i = kT1;
  run(kMs);
  EXPECT_EQ(top_->out_o, kT11);

  EXPECT_TRUE(driver_seen_);
  EXPECT_FALSE(undriven_) << "a 0 was sent without the driver's enable";
  EXPECT_EQ(flash_.memory(), before);
  EXPECT_EQ(flash_.misuses(), std::vector<std::string>{});
}

TEST_F(PlcHx8k, WithoutAProgramItIsInFaultAndSafe) {
  run(100 * kMs);
  EXPECT_EQ(top_->run_o, 0);
  EXPECT_EQ(top_->fault_o, 1);
  EXPECT_EQ(top_->out_o, 0U);
}

}  // namespace
}  // namespace rung::tb

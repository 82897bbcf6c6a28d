// SPDX-License-Identifier: Apache-2.0
// CRC-32 against zlib's.
#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <random>
#include <vector>

#include "Vcrc32.h"
#include "harness/clocked.hpp"
#include "rung_controller.hpp"

namespace rung::tb {
namespace {

class Crc : public testing::Test {
 protected:
  Crc() {
    dut_->sel_register_i = 0;
    dut_->read_i = 0;
    dut_->write_i = 0;
    dut_.reset();
  }
  void write(int address, int value) {
    dut_->sel_register_i = 1;
    dut_->write_i = 1;
    dut_->addr_i = static_cast<std::uint8_t>(address);
    dut_->wdata_i = static_cast<std::uint16_t>(value);
    dut_.tick();
    dut_->sel_register_i = 0;
    dut_->write_i = 0;
  }
  std::uint32_t read(int address) {
    dut_->sel_register_i = 1;
    dut_->read_i = 1;
    dut_->addr_i = static_cast<std::uint8_t>(address);
    dut_.tick();
    dut_->sel_register_i = 0;
    dut_->read_i = 0;
    return dut_->rdata_o;
  }
  std::uint32_t crc() {
    const std::uint32_t low = read(controller::reg_crc_low);
    return low | read(controller::reg_crc_high) << 16;
  }
  // The high byte of the word written must not matter.
  void byte(std::uint8_t value) {
    write(controller::reg_crc_byte, value | 0xa500);
    for (int i = 0; i < 2; ++i) dut_.tick();
  }

  Clocked<Vcrc32> dut_{3};
};

TEST_F(Crc, IsThatOfNothingAfterReset) { EXPECT_EQ(crc(), 0U); }

TEST_F(Crc, IsZlibsAfterEveryByteOfRandomBlocks) {
  std::mt19937 random(11);
  for (int block = 0; block < 40; ++block) {
    write(controller::reg_crc_clear, block);
    std::vector<std::uint8_t> bytes(random() % 60);
    uLong expected = crc32(0, nullptr, 0);
    for (std::uint8_t& value : bytes) {
      value = static_cast<std::uint8_t>(random());
      byte(value);
      expected = crc32(expected, &value, 1);
      ASSERT_EQ(crc(), expected) << block;
    }
    ASSERT_EQ(crc(), expected) << block;
  }
}

TEST_F(Crc, AnswersNothingWhenNotAsked) {
  byte(0x31);
  EXPECT_EQ(read(controller::reg_crc_low), (crc() & 0xffff));
  dut_.tick();
  EXPECT_EQ(dut_->rdata_o, 0);
  EXPECT_EQ(read(controller::reg_flash_data), 0U);
  // Other registers' writes are not its own, nor what is written without its select.
  const std::uint32_t before = crc();
  write(controller::reg_flash_data, 0x77);
  dut_->write_i = 1;
  dut_->addr_i = controller::reg_crc_byte;
  for (int i = 0; i < 10; ++i) dut_.tick();
  dut_->write_i = 0;
  EXPECT_EQ(crc(), before);
}

}  // namespace
}  // namespace rung::tb

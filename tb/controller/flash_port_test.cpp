// SPDX-License-Identifier: Apache-2.0
// The flash port against the flash model, and the model's own rules through it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include "Vflash_port_1.h"
#include "Vflash_port_2.h"
#include "controller/flash_model.hpp"
#include "harness/clocked.hpp"
#include "rung_controller.hpp"

namespace rung::tb {
namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr std::size_t kSize = 262144;
constexpr std::uint8_t kErasing = 0x03;  // WIP and WEL

// A driver as the firmware is one: registers of the port, the flash at its pins.
template <typename Dut>
class Driver {
 public:
  explicit Driver(std::uint64_t seed = 1) : flash(kSize, seed) { reset(); }

  void reset() {
    dut_->sel_register_i = 0;
    dut_->read_i = 0;
    dut_->write_i = 0;
    dut_->miso_i = 1;
    dut_.reset();
  }
  // The flash sees the pins of the clock that the edge begins, the port what it answers a clock
  // later: its longest way there and back.
  void clock() {
    dut_->miso_i = miso_ ? 1 : 0;
    dut_.tick();
    ++clocks;
    miso_ = flash.clock(dut_->csn_o != 0, dut_->sck_o != 0, dut_->mosi_o != 0);
  }
  void select(bool on) { write(controller::reg_flash_select, on ? 1 : 0); }
  std::uint8_t transfer(std::uint8_t byte) {
    write(controller::reg_flash_data, byte | 0x9600);
    while (read(controller::reg_flash_busy) != 0) {
    }
    return static_cast<std::uint8_t>(read(controller::reg_flash_data));
  }
  Bytes command(Bytes out, std::size_t answer = 0) {
    select(true);
    for (const std::uint8_t byte : out) transfer(byte);
    Bytes in;
    for (std::size_t i = 0; i < answer; ++i) in.push_back(transfer(0x00));
    select(false);
    return in;
  }
  static Bytes at(std::uint8_t command, std::size_t address, const Bytes& rest = {}) {
    Bytes bytes = {command, static_cast<std::uint8_t>(address >> 16),
                   static_cast<std::uint8_t>(address >> 8), static_cast<std::uint8_t>(address)};
    bytes.insert(bytes.end(), rest.begin(), rest.end());
    return bytes;
  }
  std::uint8_t status() { return command({0x05}, 1)[0]; }
  void wait() {
    while ((status() & 1) != 0) {
    }
  }
  void program(std::size_t address, const Bytes& bytes) {
    command({0x06});
    command(at(0x02, address, bytes));
  }
  void erase(std::size_t address, std::uint8_t how = 0x20) {
    command({0x06});
    command(at(how, address));
  }
  Bytes read_back(std::size_t address, std::size_t count) {
    return command(at(0x03, address), count);
  }

  int read(int number) {
    access(number);
    dut_->read_i = 1;
    clock();
    release();
    return dut_->rdata_o;
  }
  void write(int number, int value) {
    access(number);
    dut_->write_i = 1;
    dut_->wdata_i = static_cast<std::uint16_t>(value);
    clock();
    release();
  }

  FlashModel flash;
  std::uint64_t clocks = 0;

 private:
  void access(int number) {
    dut_->sel_register_i = 1;
    dut_->addr_i = static_cast<std::uint8_t>(number);
  }
  void release() {
    dut_->sel_register_i = 0;
    dut_->read_i = 0;
    dut_->write_i = 0;
  }
  Clocked<Dut> dut_{9};
  bool miso_ = true;
};

template <typename Dut>
class FlashPort : public testing::Test {
 protected:
  void TearDown() override {
    for (const std::string& text : driver.flash.misuses()) ADD_FAILURE() << text;
    EXPECT_EQ(driver.flash.busy_accesses(), 0U);
  }
  Driver<Dut> driver;
};
using Rates = testing::Types<Vflash_port_1, Vflash_port_2>;
TYPED_TEST_SUITE(FlashPort, Rates);

TYPED_TEST(FlashPort, ReadsTheIdentification) {
  EXPECT_EQ(this->driver.command({0x9f}, 3), (Bytes{0xef, 0x40, 18}));
  EXPECT_EQ(this->driver.status(), 0);
}

TYPED_TEST(FlashPort, AByteTakesTheClocksItSays) {
  this->driver.select(true);
  this->driver.write(controller::reg_flash_data, 0x05);
  int clocks = 0;
  while (this->driver.read(controller::reg_flash_busy) != 0) ++clocks;
  const bool fast = std::is_same_v<TypeParam, Vflash_port_1>;
  EXPECT_EQ(clocks, fast ? 16 : 32);
  // A write of flash_data while busy is ignored: the status comes as if it had not been.
  this->driver.write(controller::reg_flash_data, 0x00);
  this->driver.write(controller::reg_flash_data, 0xff);
  while (this->driver.read(controller::reg_flash_busy) != 0) {
  }
  EXPECT_EQ(this->driver.read(controller::reg_flash_data), 0);
  this->driver.select(false);
}

TYPED_TEST(FlashPort, ProgramsReadsAndErases) {
  Driver<TypeParam>& driver = this->driver;
  std::mt19937 random(4);
  Bytes expected(kSize, 0xff);
  for (int i = 0; i < 60; ++i) {
    const std::size_t address = random() % kSize;
    if (random() % 8 == 0) {
      const bool block = random() % 4 == 0;
      const std::size_t bytes = block ? 65536 : 4096;
      driver.erase(address, block ? 0xd8 : 0x20);
      const std::size_t from = address / bytes * bytes;
      for (std::size_t k = 0; k < bytes; ++k) expected[from + k] = 0xff;
    } else {
      Bytes bytes(1 + random() % 300);
      for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random() | random());
      driver.program(address, bytes);
      Bytes page(256, 0xff);
      for (std::size_t k = 0; k < bytes.size(); ++k) page[(address + k) % 256] = bytes[k];
      for (std::size_t k = 0; k < 256; ++k) expected[address / 256 * 256 + k] &= page[k];
    }
    EXPECT_EQ(driver.status(), kErasing);
    driver.wait();
    EXPECT_EQ(driver.status(), 0);
    const std::size_t at = random() % (kSize - 64);
    const Bytes read = driver.read_back(at, 64);
    EXPECT_TRUE(std::equal(read.begin(), read.end(), &expected[at])) << i;
    const Bytes fast = driver.command(Driver<TypeParam>::at(0x0b, at, {0x5a}), 64);
    EXPECT_EQ(fast, read);
  }
  EXPECT_EQ(driver.flash.memory(), expected);
  // The address counts on from the end to the beginning.
  const Bytes round = driver.read_back(kSize - 2, 4);
  EXPECT_EQ(round, (Bytes{expected[kSize - 2], expected[kSize - 1], expected[0], expected[1]}));
}

TYPED_TEST(FlashPort, SleepsAndWakes) {
  this->driver.program(3, {0x12});
  this->driver.wait();
  this->driver.command({0xb9});
  this->driver.command({0xab});
  for (int i = 0; i < 100; ++i) this->driver.clock();
  EXPECT_EQ(this->driver.read_back(3, 1), Bytes{0x12});
}

using Fast = Driver<Vflash_port_1>;

TEST(FlashModel, WritingAsksForWriteEnableEachTime) {
  Fast driver;
  driver.command(Fast::at(0x02, 0, {0x00}));
  EXPECT_EQ(driver.flash.misuses().size(), 1U);
  driver.command({0x06});
  EXPECT_EQ(driver.status(), 2);
  driver.command({0x04});
  EXPECT_EQ(driver.status(), 0);
  driver.command(Fast::at(0x20, 0));
  EXPECT_EQ(driver.flash.misuses().size(), 2U);
  driver.program(0, {0x0f});
  driver.wait();
  driver.command(Fast::at(0x02, 0, {0x00}));
  EXPECT_EQ(driver.flash.misuses().size(), 3U);
  EXPECT_EQ(driver.flash.memory()[0], 0x0f);
}

TEST(FlashModel, WhatComesWhileBusyIsIgnoredAndCounted) {
  Fast driver;
  driver.program(0, {0x0f});
  EXPECT_EQ(driver.read_back(0, 2), (Bytes{0xff, 0xff}));
  driver.program(0, {0x00});
  driver.wait();
  EXPECT_EQ(driver.flash.busy_accesses(), 3U);
  EXPECT_EQ(driver.read_back(0, 1), Bytes{0x0f});
}

TEST(FlashModel, SaysWhatItDoesNotUnderstand) {
  Fast driver;
  driver.command({0x42});
  driver.command({0xb9});
  driver.command({0x9f}, 3);
  driver.command({0xab});
  driver.command({0x9f}, 1);  // before it is awake
  for (int i = 0; i < 100; ++i) driver.clock();
  EXPECT_EQ(driver.command({0x9f}, 1), Bytes{0xef});
  EXPECT_EQ(driver.flash.misuses().size(), 3U);
  driver.command({0x06});
  driver.command(Fast::at(0x02, 0));          // no data
  driver.command(Fast::at(0x20, 0, {0x00}));  // a byte too many
  driver.select(true);                        // and a cut one
  driver.write(controller::reg_flash_data, 0x06);
  for (int i = 0; i < 5; ++i) driver.clock();
  driver.select(false);
  EXPECT_EQ(driver.flash.misuses().size(), 6U);
  EXPECT_EQ(driver.flash.programs() + driver.flash.erases(), 0U);
}

// At every moment of a program and an erase: only their own place changes, and in between what was
// there and what was to be there; and the flash can be used as before.
TEST(FlashModel, APowerCutLeavesPartOfWhatWasUnderWay) {
  std::mt19937 random(13);
  int partly = 0;
  Bytes before(kSize);
  for (std::uint8_t& byte : before) byte = static_cast<std::uint8_t>(random());
  for (int round = 0; round < 200; ++round) {
    Fast driver(static_cast<std::uint64_t>(round));
    driver.flash.memory() = before;
    const bool erase = round % 2 == 0;
    const Bytes data(256, 0x3c);
    const std::size_t address = random() % kSize / 4096 * 4096;
    // The commands and the programming take some 7,000 clocks, those and the erasing 22,000.
    const std::uint64_t cut = random() % (erase ? 22000 : 7500);
    if (erase) {
      driver.erase(address);
    } else {
      driver.program(address, data);
    }
    const std::uint64_t begun = driver.clocks;
    while (driver.clocks < begun + cut) driver.clock();
    const bool under_way = driver.flash.busy();
    driver.flash.power_cut();
    driver.reset();
    const Bytes& after = driver.flash.memory();
    const std::size_t length = erase ? 4096 : 256;
    Bytes done = before;
    for (std::size_t i = 0; i < length; ++i) {
      done[address + i] = erase ? 0xff : done[address + i] & data[i];
    }
    if (!under_way) {
      ASSERT_EQ(after, done);
    } else {
      partly += after != before && after != done ? 1 : 0;
      for (std::size_t i = address; i < address + length; ++i) {
        // No bit is set by a program, none cleared that was to stay.
        const int wrong = (after[i] & ~before[i]) | (done[i] & ~after[i]);
        ASSERT_TRUE(erase || wrong == 0);
      }
      const auto place = static_cast<std::ptrdiff_t>(address);
      const auto end = static_cast<std::ptrdiff_t>(address + length);
      ASSERT_TRUE(std::equal(after.begin(), after.begin() + place, before.begin()));
      ASSERT_TRUE(std::equal(after.begin() + end, after.end(), before.begin() + end));
    }
    ASSERT_EQ(driver.status(), 0);
    driver.erase(address);
    driver.wait();
    ASSERT_EQ(driver.read_back(address, 3), (Bytes{0xff, 0xff, 0xff}));
    ASSERT_TRUE(driver.flash.misuses().empty());
  }
  EXPECT_GT(partly, 40);
}

TEST(FlashModel, IsKeptInAFile) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / "rung-flash-model-test.bin";
  FlashModel first(65536);
  first.memory()[777] = 0x12;
  ASSERT_TRUE(first.save(file));
  FlashModel larger(131072);
  ASSERT_TRUE(larger.load(file));
  EXPECT_EQ(larger.memory()[777], 0x12);
  EXPECT_EQ(larger.memory()[131071], 0xff);
  ASSERT_TRUE(larger.save(file));
  EXPECT_FALSE(first.load(file));
  std::filesystem::remove(file);
  EXPECT_FALSE(first.load(file));
  EXPECT_EQ(first.memory()[777], 0x12);
}

}  // namespace
}  // namespace rung::tb

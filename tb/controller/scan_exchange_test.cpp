// SPDX-License-Identifier: Apache-2.0
// The host exchange: every kind of request against a model, stopped and while a program runs, all
// of its points in one scan.
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <vector>

#include "controller/scan_bus.hpp"
#include "programs/random_source.hpp"
#include "unit/instructions.hpp"

namespace rung::tb {
namespace {

namespace c = controller;
using isa::Opcode;

constexpr int kBitPoints = 1024, kWordPoints = 472;

class Exchange : public testing::Test {
 protected:
  // Four of five points are devices, somewhere; a device may be more than one point.
  void draw_map() {
    for (const bool words : {false, true}) {
      auto& map = words ? word_map_ : bit_map_;
      map.assign(static_cast<std::size_t>(words ? kWordPoints : kBitPoints), -1);
      std::vector<std::uint16_t> entries;
      for (int& device : map) {
        if (random_.percent(80)) device = random_.below(words ? 256 : 1024);
        entries.push_back(
            static_cast<std::uint16_t>(device < 0 ? random_.bits() & 0x7fff : 0x8000 | device));
      }
      bus_.load(words ? c::space_word_map : c::space_bit_map, 0, entries);
    }
  }

  int device(const ExchangeRequest& request, int point) const {
    const auto& map = request.words ? word_map_ : bit_map_;
    if (request.raw) return point;
    return point < static_cast<int>(map.size()) ? map[static_cast<std::size_t>(point)] : -1;
  }

  ExchangeRequest draw(int most) {
    ExchangeRequest request;
    request.words = random_.percent(50);
    request.raw = random_.percent(30);
    const int points =
        request.words ? (request.raw ? 256 : kWordPoints) : (request.raw ? 1024 : kBitPoints);
    const int bound = std::min({most, points, request.words ? 125 : 2000});
    const int write = random_.percent(60) ? 1 + random_.below(bound) : 0;
    const int read = random_.percent(write > 0 ? 50 : 100) && write < bound
                         ? 1 + random_.below(bound - write)
                         : 0;
    request.write_first = random_.below(points - write + 1);
    request.read_first = random_.below(points - read + 1);
    for (int i = 0; i < write; ++i) {
      request.data.push_back(
          static_cast<std::uint16_t>(random_.bits() & (request.words ? 0xffff : 1)));
    }
    request.read_count = read;
    return request;
  }

  void check(const ExchangeRequest& request) {
    const std::vector<std::uint16_t> got = bus_.exchange(request);
    auto& values = request.words ? words_ : bits_;
    for (std::size_t i = 0; i < request.data.size(); ++i) {
      const int at = device(request, request.write_first + static_cast<int>(i));
      if (at >= 0) values[at] = request.data[i];
    }
    for (int i = 0; i < request.read_count; ++i) {
      const int at = device(request, request.read_first + i);
      ASSERT_EQ(got[static_cast<std::size_t>(i)], at < 0 ? 0 : values[at])
          << (request.words ? "word " : "bit ") << request.read_first + i;
    }
  }

  void mask_write(int point, bool raw, std::uint16_t mask, std::uint16_t value) {
    bus_.write(c::reg_exchange_write_first, point);
    bus_.write(c::reg_exchange_write_count, 1);
    bus_.write(c::reg_exchange_and, mask);
    bus_.write(c::reg_exchange_or, value);
    bus_.write(c::reg_exchange_control, 1 | 4 | 16 | (raw ? 8 : 0));
    bus_.wait_exchange();
    ExchangeRequest which;
    which.words = true;
    which.raw = raw;
    const int at = device(which, point);
    if (at >= 0) {
      words_[at] = static_cast<std::uint16_t>((words_[at] & mask) | (value & ~mask));
    }
  }

  void random_requests(int count, int most) {
    for (int i = 0; i < count && !HasFatalFailure(); ++i) {
      if (random_.percent(15)) {
        mask_write(random_.below(256), random_.percent(50),
                   static_cast<std::uint16_t>(random_.bits()),
                   static_cast<std::uint16_t>(random_.bits()));
      } else {
        check(draw(most));
      }
    }
    // And every device at the end.
    for (int at = 0; at < 256; at += 64) read_raw(true, at, 64);
    for (int at = 0; at < 1024; at += 64) read_raw(false, at, 64);
  }
  void read_raw(bool words, int first, int count) {
    ExchangeRequest request;
    request.words = words;
    request.raw = true;
    request.read_first = first;
    request.read_count = count;
    check(request);
  }

  RandomSource random_{21};
  ControllerBus bus_;
  std::vector<int> bit_map_, word_map_;
  std::map<int, std::uint16_t> bits_, words_;
};

TEST_F(Exchange, RandomRequestsStopped) {
  draw_map();
  bus_.setup(c::setup_exchange_points, 2000);
  random_requests(300, 2000);
}

TEST_F(Exchange, RandomRequestsRunning) {
  draw_map();
  bus_.load_steps({nop(), nop(), nop()});
  bus_.setup(c::setup_exchange_points, 250);
  bus_.run();
  random_requests(300, 250);
  EXPECT_EQ(bus_.read32(c::reg_scan_min_low), bus_.read32(c::reg_scan_max_low));
}

TEST_F(Exchange, AsManyPointsAsThePhaseIsFor) {
  draw_map();
  bus_.load_steps({nop()});
  for (const int points : {1, 2, 16, 17, 100, 128}) {
    bus_.setup(c::setup_exchange_points, points);
    bus_.run();
    for (int i = 0; i < 10; ++i) {
      ExchangeRequest request;
      request.words = i % 2 != 0;
      const int write = i % 3 == 0 ? 0 : i % 3 == 1 ? points / 2 : std::min(points, 120);
      for (int k = 0; k < write; ++k) {
        request.data.push_back(
            static_cast<std::uint16_t>(random_.bits() & (request.words ? 0xffff : 1)));
      }
      request.read_count = std::min(points - write, 125);
      ASSERT_NO_FATAL_FAILURE(check(request));
    }
    bus_.stop();
  }
}

TEST_F(Exchange, ARequestTakesAtMostOneScanMore) {
  bus_.load_steps({nop()});
  bus_.setup(c::setup_exchange_points, 100);
  bus_.run();
  bus_.wait_scans(2);
  const int scan = static_cast<int>(bus_.read32(c::reg_scan_last_low));
  for (int i = 0; i < 200; ++i) {
    ExchangeRequest request;
    request.raw = request.words = true;
    request.read_count = 100;
    bus_.clocks(random_.below(scan));
    bus_.post(request);
    const std::int64_t begin = bus_.now;
    bus_.wait_exchange();
    ASSERT_LE(bus_.now - begin, scan + 100 + c::micro_exchange_clocks);
  }
}

// A program that makes D1 to D90 equal to D0 in each scan, and D0 another value in the next.
TEST_F(Exchange, AReadSeesOneScan) {
  std::vector<isa::SlotInstruction> steps;
  for (int i = 1; i <= 90; ++i) steps.push_back(word(Opcode::Mv, 0, 0, i));
  steps.insert(steps.begin(), with_constant(Opcode::Add, 0, 1, 0));
  bus_.load_steps(steps);
  bus_.setup(c::setup_exchange_points, 91);
  bus_.run();
  std::uint16_t before = 0;
  int other = 0;
  for (int i = 0; i < 300; ++i) {
    ExchangeRequest request;
    request.raw = request.words = true;
    request.read_count = 91;
    bus_.clocks(random_.below(700));
    const auto got = bus_.exchange(request);
    for (const std::uint16_t value : got) ASSERT_EQ(value, got[0]);
    other += got[0] != before ? 1 : 0;
    before = got[0];
  }
  EXPECT_GT(other, 290);
}

// The program sees all of a write or nothing: it counts the scans in which two words differ.
TEST_F(Exchange, AWriteChangesOneScan) {
  bus_.load1(c::space_lut, 0, 0x0f);  // not a
  bus_.load_steps({test(isa::Mpu::Mpu2, Opcode::Eq, 0, 60, 5),
                   look_up(Opcode::Lut, 0, {5, false}, {5, false}, {5, false}),
                   with_constant(Opcode::Add, 100, 1, 100, false)});
  bus_.setup(c::setup_exchange_points, 64);
  bus_.run();
  for (int i = 1; i < 300; ++i) {
    ExchangeRequest request;
    request.raw = request.words = true;
    request.data.assign(61, static_cast<std::uint16_t>(i));
    bus_.clocks(random_.below(300));
    bus_.exchange(request);
  }
  EXPECT_EQ(bus_.device_word(100), 0);
  bus_.poke(true, 60, 7);
  bus_.wait_scans(3);
  EXPECT_GT(bus_.device_word(100), 1);
}

TEST_F(Exchange, ARequestThatIsTooLongIsCutOff) {
  bus_.setup(c::setup_exchange_points, 10);
  ExchangeRequest request;
  request.raw = request.words = true;
  request.read_count = 125;
  bus_.post(request);
  bus_.wait_exchange();
  draw_map();
  for (int i = 0; i < 20; ++i) ASSERT_NO_FATAL_FAILURE(check(draw(10)));
}

}  // namespace
}  // namespace rung::tb

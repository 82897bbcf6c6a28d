// SPDX-License-Identifier: Apache-2.0
// The RTU line (hdl/controller/rtu_line.v) byte by byte, and a model of its rules.
#pragma once

#include <cstdint>
#include <optional>
#include <random>

#include "Vrtu_line.h"
#include "controller/rtu_bus.hpp"

namespace rung::tb {

inline constexpr int kSilence = 400;
inline constexpr int kShortest = 12;  // clocks between bytes

class RtuLine : public RtuBus<Vrtu_line> {
 public:
  explicit RtuLine(int seed) : RtuBus(seed), random_(static_cast<unsigned>(seed)) {
    no_byte();
    dut->rx_active_i = 0;
    dut->tx_ready_i = 1;
    dut->tx_busy_i = 0;
    dut.reset();
    set_silence(kSilence);
  }
  // The sequencer keeps the RAM's port busy but for one clock in 64.
  bool hog = false;

  void clock() override {
    const bool mine = dut->read_i == 0 && dut->write_i == 0;
    if (hog && mine && clocks_ % 64 != 0) {
      dut->sel_tx_frame_i = 1;
      dut->read_i = 1;
      dut->addr_i = static_cast<std::uint8_t>(random_());
    }
    ++clocks_;
    dut.tick();
    if (mine) release();
  }
  void byte(std::uint8_t value, bool error = false) {
    dut->rx_valid_i = error ? 0 : 1;
    dut->rx_error_i = error ? 1 : 0;
    dut->rx_data_i = value;
    clock();
    no_byte();
  }
  void pause(int clocks) {
    for (int i = 0; i < clocks; ++i) clock();
  }
  void silence() { pause(kSilence + 3); }
  void frame_in(const Frame& bytes, int gap) {
    for (const std::uint8_t value : bytes) {
      byte(value);
      pause(gap);
    }
  }

 private:
  void no_byte() {
    dut->rx_valid_i = 0;
    dut->rx_error_i = 0;
    dut->rx_data_i = 0xee;
  }
  std::mt19937 random_;
  std::uint64_t clocks_ = 0;
};

// The rules, in bytes and silences.
struct RtuRules {
  Frame bytes;
  bool open = false;
  bool drop = false;
  bool bad = false;
  std::optional<Frame> waiting;
  LineCounts counts;

  void byte(std::uint8_t value, bool error) {
    if (!open) {
      open = true;
      bad = false;
      bytes.clear();
      drop = waiting.has_value();
      counts.lost += drop ? 1 : 0;
    }
    bad = bad || error;
    counts.bad_byte += error ? 1 : 0;
    bytes.push_back(value);
  }
  void silence() {
    if (open && !drop) {
      if (bad || bytes.size() < 4 || bytes.size() > 256 || modbus_crc(bytes) != 0) {
        ++counts.bad_crc;
      } else {
        waiting = Frame(bytes.begin(), bytes.end() - 2);
      }
    }
    open = false;
  }
};

}  // namespace rung::tb

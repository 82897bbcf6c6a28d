// SPDX-License-Identifier: Apache-2.0
// A MAX11123 at its SPI pins, as far as manual mode goes. It looks at the pins once a clock and
// notes what the data sheet forbids: a clock that does not rest at 1, one that is too fast, a frame
// that is not 16 bits long, a pause that is too short.
#pragma once

#include <array>
#include <cstdint>
#include <deque>

namespace rung::tb {

class Max11123Chip {
 public:
  // `latency`: how many frames after the one that selects a channel its sample is sent.
  explicit Max11123Chip(int latency) : latency_(latency) {}

  std::array<std::uint16_t, 8> inputs{};  // 12 bits
  int faults = 0;
  int frames = 0;
  int resets = 0;

  // The level of DOUT one clock after the given levels.
  bool clock(bool csn, bool sck, bool din) {
    since_edge_++;
    since_csn_++;
    if (csn != csn_) {
      if (!sck || since_csn_ < kPause) ++faults;
      csn ? end_frame() : begin_frame();
      since_csn_ = 0;
    } else if (!csn && sck != sck_) {
      if (since_edge_ < kHalf) ++faults;
      since_edge_ = 0;
      if (sck) {
        received_ = static_cast<std::uint16_t>(received_ << 1 | (din ? 1 : 0));
        ++bits_;
      } else {
        dout_ = (answer_ & 0x8000) != 0;
        answer_ = static_cast<std::uint16_t>(answer_ << 1);
      }
    }
    csn_ = csn;
    sck_ = sck;
    return csn || dout_;
  }

 private:
  // Clocks of 40 ns: 16 MHz at most, and 10 ns between two frames.
  static constexpr int kHalf = 1, kPause = 1;

  void begin_frame() {
    bits_ = 0;
    answer_ = 0;
    selected_.push_back(channel_);
    if (static_cast<int>(selected_.size()) < latency_) return;
    const int channel = selected_.front();
    selected_.pop_front();
    if (channel >= 0) {
      answer_ =
          static_cast<std::uint16_t>(channel << 12 | inputs.at(static_cast<std::size_t>(channel)));
    }
  }

  void end_frame() {
    ++frames;
    if (bits_ != 16) {
      ++faults;
      return;
    }
    const int number = received_ >> 11;  // of a register; below 16 it is mode control
    if (number < 16) {
      if ((received_ >> 5 & 3) == 2) {
        ++resets;
        channel_ = -1;
        selected_.clear();
        registers_.fill(0xffff);  // until they are set
        return;
      }
      const bool manual = (received_ >> 11 & 15) == 1;
      const bool with_channel = (received_ & 4) != 0;
      const bool awake = (received_ >> 3 & 3) == 0;
      if (!manual || !with_channel || !awake || (received_ >> 10 & 1) != 0) ++faults;
      channel_ = received_ >> 7 & 7;
      // Single-ended, unipolar, no averaging, no echo: all settings are 0.
      for (const int setting : {0, 1, 2}) {
        if (registers_.at(static_cast<std::size_t>(setting)) != 0) ++faults;
      }
    } else {
      registers_.at(static_cast<std::size_t>(number - 16)) = received_ & 0x7ff;
    }
  }

  const int latency_;
  bool csn_ = true, sck_ = true, dout_ = false;
  int since_edge_ = kHalf, since_csn_ = kPause, bits_ = 0, channel_ = -1;
  std::uint16_t received_ = 0, answer_ = 0;
  std::deque<int> selected_;
  std::array<std::uint16_t, 16> registers_{};
};

}  // namespace rung::tb

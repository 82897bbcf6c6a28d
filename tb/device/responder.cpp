// SPDX-License-Identifier: Apache-2.0
#include "responder.hpp"

#include <algorithm>
#include <utility>

#include "device/shared_line.hpp"

namespace rung::tb {

void Responder::run(std::uint64_t clocks) {
  for (std::uint64_t i = 0; i < clocks; ++i) clock();
}

std::vector<std::uint8_t> Responder::receive() { return std::exchange(sent_, {}); }

void Responder::clock() {
  ++now_;
  ++quiet_;
  if (!to_machine_.empty() && ++arriving_ == kCharacter) {
    if (!frame_.empty()) longest_gap = std::max(longest_gap, quiet_ - kCharacter);
    frame_.push_back(to_machine_.front());
    to_machine_.pop_front();
    arriving_ = 0;
    quiet_ = 0;
  }
  // A byte that is on the line has ended the silence with its start bit.
  if (!frame_.empty() && arriving_ == 0 && quiet_ == kCharacter * 7 / 2) {
    answer();
    frame_.clear();
  }
  if (!reply_.empty() && --reply_in_ == 0) {
    sent_.push_back(reply_.front());
    reply_.pop_front();
    reply_in_ = kCharacter;
  }
}

void Responder::answer() {
  if (frame_.size() < 4 || device::rtu_crc(frame_) != 0) {
    ++bad_frames;
    return;
  }
  ++frames;
  if (mute || !power || frame_[0] > 1) return;
  const auto word = [&](std::size_t i) {
    return static_cast<unsigned>(frame_[i] << 8 | frame_[i + 1]);
  };
  std::vector<std::uint8_t> reply{1, frame_[1]};
  const auto exception = [&](std::uint8_t code) {
    reply = {1, static_cast<std::uint8_t>(frame_[1] | 0x80), code};
  };
  if (frame_[1] == 3 && frame_.size() == 8) {
    if (word(2) + word(4) > registers.size()) {
      exception(2);
    } else {
      reply.push_back(static_cast<std::uint8_t>(2 * word(4)));
      for (unsigned i = word(2); i < word(2) + word(4); ++i) {
        reply.push_back(static_cast<std::uint8_t>(registers[i] >> 8));
        reply.push_back(static_cast<std::uint8_t>(registers[i] & 0xFF));
      }
    }
  } else if (frame_[1] == 6 && frame_.size() == 8 && word(2) < registers.size()) {
    registers[word(2)] = static_cast<std::uint16_t>(word(4));
    reply.assign(frame_.begin(), frame_.end() - 2);
  } else {
    exception(1);
  }
  if (frame_[0] == 0) return;
  const auto crc = static_cast<std::uint16_t>(device::rtu_crc(reply) ^ (wrong_crc ? 1 : 0));
  reply.push_back(static_cast<std::uint8_t>(crc & 0xFF));
  reply.push_back(static_cast<std::uint8_t>(crc >> 8));
  reply_.assign(reply.begin(), reply.end());
  reply_in_ = delay;
}

}  // namespace rung::tb

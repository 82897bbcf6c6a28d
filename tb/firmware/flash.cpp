// SPDX-License-Identifier: Apache-2.0
#include "flash.hpp"

namespace rung::tb {
namespace {

constexpr std::uint8_t kWriteEnable = 0x06;
constexpr std::uint8_t kStatus = 0x05;
constexpr std::uint8_t kErase = 0x20;
constexpr std::uint8_t kProgram = 0x02;
constexpr std::uint8_t kRead = 0x03;
constexpr std::uint8_t kWake = 0xAB;
constexpr std::size_t kSector = 4096;
constexpr std::size_t kPage = 256;
constexpr std::size_t kCommandBytes = 4;

}  // namespace

void Flash::select(bool selected) {
  if (selected_ && !selected) carry_out();
  if (selected && !selected_) in_.clear();
  selected_ = selected;
}

std::uint8_t Flash::transfer(std::uint8_t byte) {
  if (absent || !selected_) return 0xFF;
  in_.push_back(byte);
  const std::uint8_t command = in_[0];
  if (asleep_) {
    if (command != kWake && command != kStatus) ++violations;
    return 0xFF;
  }
  if (command == kStatus && in_.size() > 1) {
    const bool busy = busy_ > 0;
    if (busy && !stuck_busy) --busy_;
    return busy ? 1 : 0;
  }
  if (busy_ > 0 && command != kStatus && command != kWake && in_.size() == 1) ++violations;
  if (in_.size() == kCommandBytes) {
    address_ = (std::size_t{in_[1]} << 16U | std::size_t{in_[2]} << 8U | in_[3]) % data_.size();
  }
  if (command == kRead && in_.size() > kCommandBytes && busy_ == 0) {
    const std::uint8_t out = data_[address_];
    address_ = (address_ + 1) % data_.size();
    return out;
  }
  return 0xFF;
}

void Flash::carry_out() {
  if (in_.empty()) return;
  const std::uint8_t command = in_[0];
  if (asleep_) {
    if (command == kWake) asleep_ = false;
    return;
  }
  if (command == kWriteEnable && busy_ == 0) enabled_ = true;
  const bool programs = command == kProgram && in_.size() > kCommandBytes;
  const bool erases = command == kErase && in_.size() == kCommandBytes;
  if (!programs && !erases) return;
  if (!enabled_ || busy_ > 0) {
    ++violations;
    return;
  }
  enabled_ = false;
  ++writes;
  const std::size_t whole = programs ? in_.size() - kCommandBytes : kSector;
  std::size_t bytes = ignores_writes ? 0 : whole;
  const bool cut = cut_in_ == 0;
  if (cut) bytes = cut_partly_ ? std::uniform_int_distribution<std::size_t>(0, whole)(random_) : 0;
  if (cut_in_ >= 0) --cut_in_;
  if (programs) program(bytes);
  if (erases) erase(bytes);
  if (cut) throw PowerCut{};
  busy_ = std::uniform_int_distribution<int>(1, 4)(random_);
}

void Flash::program(std::size_t bytes) {
  const std::size_t start =
      (std::size_t{in_[1]} << 16U | std::size_t{in_[2]} << 8U | in_[3]) % data_.size();
  if (start % kPage + in_.size() - kCommandBytes > kPage) ++violations;
  for (std::size_t i = 0; i < bytes; ++i) data_[start + i] &= in_[kCommandBytes + i];
  // Of the byte that the cut came to, some bits
  if (bytes < in_.size() - kCommandBytes && cut_partly_) {
    data_[start + bytes] &= in_[kCommandBytes + bytes] | static_cast<std::uint8_t>(random_());
  }
}

void Flash::erase(std::size_t bytes) {
  const std::size_t start = address_ - address_ % kSector;
  for (std::size_t i = 0; i < bytes; ++i) data_[start + i] = 0xFF;
  for (std::size_t i = bytes; i < kSector && cut_partly_ && bytes > 0; ++i) {
    data_[start + i] |= static_cast<std::uint8_t>(random_() & random_());
  }
}

void Flash::power_up() {
  selected_ = false;
  asleep_ = true;
  enabled_ = false;
  busy_ = 0;
  cut_in_ = -1;
  in_.clear();
}

void Flash::cut_at(int n, bool partly, unsigned seed) {
  cut_in_ = n;
  cut_partly_ = partly;
  random_.seed(seed);
}

}  // namespace rung::tb

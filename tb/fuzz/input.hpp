// SPDX-License-Identifier: Apache-2.0
// The bytes of an input as choices, one after the other; 0 when there are no more.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

namespace rung::fuzz {

class Input {
 public:
  explicit Input(std::string_view bytes) : left_(bytes) {}

  bool empty() const { return left_.empty(); }
  std::uint8_t byte() {
    if (left_.empty()) return 0;
    const auto byte = static_cast<std::uint8_t>(left_.front());
    left_.remove_prefix(1);
    return byte;
  }
  std::uint16_t word() {
    const unsigned high = byte();
    return static_cast<std::uint16_t>(high << 8 | byte());
  }
  // 0 to bound - 1; bound is at most 65,536.
  unsigned below(unsigned bound) { return (bound > 256 ? word() : byte()) % bound; }
  // As many as there are, at most so many.
  std::vector<std::uint8_t> bytes(std::size_t most) {
    const std::string_view taken = left_.substr(0, std::min(most, left_.size()));
    left_.remove_prefix(taken.size());
    return {taken.begin(), taken.end()};
  }

 private:
  std::string_view left_;
};

}  // namespace rung::fuzz

// SPDX-License-Identifier: Apache-2.0
// Modbus TCP's frames: a header of seven bytes (MBAP) before each PDU.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace rung::device {

struct MbapRequest {
  std::uint16_t transaction = 0;
  std::uint8_t unit = 0;
  std::vector<std::uint8_t> pdu;  // 1 to 253 bytes
};

// Cuts a client's stream into requests.
class MbapStream {
 public:
  void put(std::span<const std::uint8_t> bytes);
  std::size_t waiting() const { return bytes_.size(); }
  // The next whole request, if there is one.
  std::optional<MbapRequest> next();
  // A header that is none was met; where the next one begins cannot be told.
  bool broken() const { return broken_; }

 private:
  std::deque<std::uint8_t> bytes_;
  bool broken_ = false;
};

std::vector<std::uint8_t> mbap_reply(const MbapRequest& request, std::span<const std::uint8_t> pdu);

}  // namespace rung::device

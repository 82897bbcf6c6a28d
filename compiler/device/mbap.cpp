// SPDX-License-Identifier: Apache-2.0
#include "device/mbap.hpp"

namespace rung::device {
namespace {

constexpr std::size_t kHeader = 7;
constexpr std::size_t kCounted = 6;  // the length counts what follows it: unit and PDU
constexpr std::size_t kMostCounted = 254;

}  // namespace

void MbapStream::put(std::span<const std::uint8_t> bytes) {
  if (!broken_) bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

std::optional<MbapRequest> MbapStream::next() {
  if (broken_ || bytes_.size() < kHeader) return std::nullopt;
  const auto word = [&](std::size_t i) {
    return static_cast<std::uint16_t>(bytes_[i] << 8 | bytes_[i + 1]);
  };
  const std::uint16_t protocol = word(2);
  const std::uint16_t counted = word(4);
  if (protocol != 0 || counted < 2 || counted > kMostCounted) {
    broken_ = true;
    bytes_.clear();
    return std::nullopt;
  }
  if (bytes_.size() < kCounted + counted) return std::nullopt;
  MbapRequest request{word(0), bytes_[kCounted], {}};
  const auto end = bytes_.begin() + static_cast<std::ptrdiff_t>(kCounted + counted);
  request.pdu.assign(bytes_.begin() + kHeader, end);
  bytes_.erase(bytes_.begin(), end);
  return request;
}

std::vector<std::uint8_t> mbap_reply(const MbapRequest& request,
                                     std::span<const std::uint8_t> pdu) {
  const std::size_t counted = pdu.size() + 1;
  std::vector<std::uint8_t> bytes;
  // g++ 12 sees an overflow in an insert() behind a list of 7 that is not there.
  bytes.reserve(7 + pdu.size());
  bytes.assign({static_cast<std::uint8_t>(request.transaction >> 8),
                static_cast<std::uint8_t>(request.transaction & 0xFF), 0, 0,
                static_cast<std::uint8_t>(counted >> 8), static_cast<std::uint8_t>(counted & 0xFF),
                request.unit});
  bytes.insert(bytes.end(), pdu.begin(), pdu.end());
  return bytes;
}

}  // namespace rung::device

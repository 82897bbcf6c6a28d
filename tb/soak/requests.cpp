// SPDX-License-Identifier: Apache-2.0
// What the soak's client asks, and what the answers must be.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "rung_controller.hpp"
#include "soak/session.hpp"

namespace rung::tb {
namespace {

namespace c = controller;

constexpr int kReadCoils = 1, kReadDiscretes = 2, kReadHolding = 3;
constexpr int kWriteCoil = 5, kWriteHolding = 6, kWriteCoils = 15, kMaskHolding = 22;
constexpr int kMostAsked = 16;
// Nothing answers a frame that is none.
constexpr std::uint64_t kSilence = 1500;
constexpr std::int16_t kCorners[] = {0, 1, -1, 2, 9, 10, 32767, -32768};

int function_of(io::Table table) {
  switch (table) {
    case io::Table::Coil:
      return kReadCoils;
    case io::Table::Discrete:
      return kReadDiscretes;
    case io::Table::Holding:
      break;
  }
  return kReadHolding;
}

// The values in an answer; nothing if it is none.
std::optional<std::vector<std::int16_t>> values_in(const std::optional<Bytes>& answer, int function,
                                                   std::size_t count) {
  const bool words = function == kReadHolding;
  const std::size_t bytes = words ? 2 * count : (count + 7) / 8;
  if (!answer || answer->size() != 2 + bytes || answer->at(0) != function ||
      answer->at(1) != bytes) {
    return std::nullopt;
  }
  std::vector<std::int16_t> values;
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(
        words ? static_cast<std::int16_t>((*answer)[2 + 2 * i] << 8U | (*answer)[3 + 2 * i])
              : static_cast<std::int16_t>((*answer)[2 + i / 8] >> i % 8 & 1));
  }
  // Bits behind the last are 0.
  if (!words && count % 8 != 0 && answer->back() >> count % 8 != 0) return std::nullopt;
  return values;
}

}  // namespace

Session::Values Session::values_of(const std::vector<Device>& devices) const {
  Values values;
  for (const Device device : devices) {
    const bool named = std::binary_search(now_->named.begin(), now_->named.end(), device);
    values.push_back(named ? watch_.reference().get(device) : std::int16_t{0});
  }
  return values;
}

// Some devices one behind the other: what they were after one scan between request and answer.
void Session::poll() {
  const Dialect dialect = now_->program.dialect;
  const Device first = now_->named[random_.bits() % now_->named.size()];
  const io::Point point = io::point_of(first, dialect, machine_->board().config).value();
  const int most = std::min(
      {kMostAsked, now_->bindings.settings.exchange_points, point.last - point.address + 1});
  const int count = 1 + random_.below(most);
  asked_.clear();
  for (int i = 0; i < count; ++i) {
    const auto device =
        io::device_at(point.table, point.address + i, dialect, machine_->board().config);
    if (!device) break;
    asked_.push_back(*device);
  }
  seen_ = {values_of(asked_)};
  const int function = function_of(point.table);
  const auto answer = client_.ask(
      pdu(function, {low(static_cast<std::size_t>(point.address)), low(asked_.size())}));
  const auto values = values_in(answer, function, asked_.size());
  if (!values) {
    throw Difference(fmt::format(
        "function {} at {}, {} points: {}", function, point.address, asked_.size(),
        answer ? fmt::format("answer [{:02x}]", fmt::join(*answer, " ")) : "no answer"));
  }
  if (std::find(seen_.begin(), seen_.end(), *values) == seen_.end()) {
    throw Difference(fmt::format(
        "program {}: function {} at {}: [{}] is what no scan left behind, the last one [{}]",
        now_->seed, function, point.address, fmt::join(*values, " "),
        fmt::join(seen_.back(), " ")));
  }
  asked_.clear();
  ++counts_["answers"];
}

// Devices up to a mark: with its output it is known when.
void Session::write() {
  const bool words = random_.percent(50);
  const Mark& mark = words ? now_->word : now_->bit;
  const std::vector<Device>& devices = words ? now_->words : now_->relays;
  const Dialect dialect = now_->program.dialect;
  const bool level = watch_.reference().get(mark.device) == 0;
  const auto address_of = [&](Device device) {
    return io::point_of(device, dialect, machine_->board().config).value().address;
  };
  const int last = address_of(mark.device);
  Watch::Write write{{{mark.device, level ? 1 : 0}}, mark.pin, level};
  Bytes request;
  std::size_t echoed = 5;
  switch (random_.below(words ? 3 : 2)) {
    case 0: {  // several
      const int most = std::min(now_->bindings.settings.exchange_points, 64);
      const Device from = devices[random_.bits() % devices.size()];
      const int first = std::max(address_of(from), last - most + 1);
      const auto count = static_cast<std::size_t>(last - first + 1);
      std::vector<std::int16_t> values(count);
      for (auto& value : values) {
        value = random_.percent(50) ? kCorners[random_.bits() % std::size(kCorners)]
                                    : static_cast<std::int16_t>(random_.bits());
        if (!words) value &= 1;
      }
      values.back() = level ? 1 : 0;
      request = pdu(words ? 16 : kWriteCoils, {low(static_cast<std::size_t>(first)), low(count)});
      if (words) {
        request.push_back(static_cast<std::uint8_t>(2 * count));
        for (const std::int16_t value : values) {
          const auto bits = static_cast<std::uint16_t>(value);
          request.push_back(static_cast<std::uint8_t>(bits >> 8U));
          request.push_back(static_cast<std::uint8_t>(bits));
        }
      } else {
        request.push_back(static_cast<std::uint8_t>((count + 7) / 8));
        request.resize(request.size() + (count + 7) / 8);
        for (std::size_t i = 0; i < count; ++i) {
          request[6 + i / 8] |= static_cast<std::uint8_t>(values[i] << i % 8);
        }
      }
      for (const Device device : devices) {
        const int at = address_of(device) - first;
        if (at >= 0 && device != mark.device) {
          write.values.emplace_back(device, values[static_cast<std::size_t>(at)]);
        }
      }
      break;
    }
    case 1:
      request = words ? pdu(kWriteHolding, {low(static_cast<std::size_t>(last)), level})
                      : pdu(kWriteCoil, {low(static_cast<std::size_t>(last)),
                                         static_cast<std::uint16_t>(level ? 0xFF00 : 0)});
      break;
    default:  // its lowest bit
      request = pdu(kMaskHolding, {low(static_cast<std::size_t>(last)), 0xFFFE, level});
      echoed = 7;
  }
  watch_.write(std::move(write));
  const auto answer = client_.ask(request);
  if (!answer ||
      *answer != Bytes(request.begin(), request.begin() + static_cast<std::ptrdiff_t>(echoed))) {
    throw Difference(fmt::format("function {} at {}: not the right answer", request[0], last));
  }
  watch_.advance(2 * static_cast<std::uint64_t>(now_->timing.period));
  if (!watch_.written()) throw Difference("a write that was answered has no effect");
  ++counts_["writes"];
}

// A request that is damaged on its way, or noise: no answer, and nothing happens.
void Session::break_frame() {
  Bytes frame = with_crc({1, kReadHolding, 0, 0, 0, 1});
  const auto at = [&] { return random_.bits() % frame.size(); };
  bool bad_byte = false;
  switch (random_.below(5)) {
    case 0:
      frame[at()] ^= static_cast<std::uint8_t>(1U << random_.below(8));
      break;
    case 1:
      frame.resize(1 + at());
      if (frame.size() == 8) frame.pop_back();
      break;
    case 2:
      frame.insert(frame.begin() + static_cast<std::ptrdiff_t>(at()),
                   static_cast<std::uint8_t>(random_.below(256)));
      break;
    case 3:
      frame.assign(static_cast<std::size_t>(1 + random_.below(300)), 0);
      for (auto& byte : frame) byte = static_cast<std::uint8_t>(random_.below(256));
      break;
    default:
      bad_byte = true;
  }
  const bool right = frame.size() >= 4 && with_crc(Bytes(frame.begin(), frame.end() - 2)) == frame;
  if (right && !bad_byte) return;
  watch_.advance(client_.gap);
  const std::size_t bad = at();
  for (std::size_t i = 0; i < frame.size(); ++i) {
    if (bad_byte && i == bad) {
      machine_->send_bad(frame[i]);
    } else {
      machine_->send(frame[i]);
    }
  }
  while (machine_->sending() > 0) watch_.advance(64);
  watch_.advance(kSilence);
  const Bytes answer = machine_->receive();
  if (!answer.empty()) {
    throw Difference(fmt::format("an answer to [{:02x}]: [{:02x}]", fmt::join(frame, " "),
                                 fmt::join(answer, " ")));
  }
  ++counts_["broken_frames"];
}

// Every scan has taken the clocks that the compiler says.
void Session::check_statistics() {
  const Words words = client_.read(c::holding_scan_last, 6);
  for (int i = 0; i < 6; i += 2) {
    const std::int64_t clocks = words[i] | static_cast<std::int64_t>(words[i + 1]) << 16U;
    if (clocks != now_->timing.cycle) {
      throw Difference(fmt::format("program {}: a scan of {} clocks, not {}", now_->seed, clocks,
                                   now_->timing.cycle));
    }
  }
  if (client_.holding(c::holding_overruns) != 0) throw Difference("a scan came too late");
  ++counts_["statistics"];
}

}  // namespace rung::tb

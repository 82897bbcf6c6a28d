// SPDX-License-Identifier: Apache-2.0
#include "plant/poller.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "io/modbus_map.hpp"
#include "plant/controlled_plant.hpp"

namespace rung::tb {
namespace {

constexpr std::uint8_t kUnit = 1;
constexpr std::uint8_t kReadCoils = 1, kReadDiscretes = 2, kReadHolding = 3;
// A reply that has not come by then never will.
constexpr std::uint64_t kPatienceMs = 2000;

std::uint16_t crc16(const std::vector<std::uint8_t>& bytes) {
  std::uint16_t crc = 0xFFFF;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int i = 0; i < 8; ++i) {
      crc = static_cast<std::uint16_t>((crc & 1) != 0 ? crc >> 1 ^ 0xA001 : crc >> 1);
    }
  }
  return crc;
}

void append(std::vector<std::uint8_t>& bytes, std::uint16_t value) {
  bytes.push_back(static_cast<std::uint8_t>(value >> 8));
  bytes.push_back(static_cast<std::uint8_t>(value & 0xFF));
}

}  // namespace

Poller::Poller(SimulatedController& machine, const Reference& reference)
    : machine_(machine), reference_(reference) {
  const std::string_view config = machine.board().config;
  const auto question = [&](std::uint8_t function, io::Table table, Device first,
                            std::uint16_t count) {
    const auto point = io::point_of(first, Dialect::Fx, config);
    if (!point) throw std::invalid_argument("no such area");
    Question made{function, static_cast<std::uint16_t>(point->address), count, {}};
    for (int i = 0; i < count; ++i) {
      const auto device = io::device_at(table, point->address + i, Dialect::Fx, config);
      made.devices.push_back(device.value());
    }
    questions_.push_back(std::move(made));
  };
  question(kReadCoils, io::Table::Coil, {DeviceKind::M, 0}, 32);
  question(kReadHolding, io::Table::Holding, {DeviceKind::D, 200}, 3);
  question(kReadDiscretes, io::Table::Discrete, {DeviceKind::X, 0}, 16);
  question(kReadHolding, io::Table::Holding, {DeviceKind::TN, 0}, 8);
  question(kReadCoils, io::Table::Coil, {DeviceKind::Y, 0}, 8);
  question(kReadHolding, io::Table::Holding, {DeviceKind::CN, 100}, 1);
}

Poller::Values Poller::values() const {
  Values values;
  for (const Device device : questions_[now_].devices) values.push_back(reference_.get(device));
  return values;
}

void Poller::scanned() {
  if (waiting_) scans_.push_back(values());
}

void Poller::send(std::vector<std::uint8_t> bytes) {
  const std::uint16_t crc = crc16(bytes);
  bytes.push_back(static_cast<std::uint8_t>(crc & 0xFF));
  bytes.push_back(static_cast<std::uint8_t>(crc >> 8));
  for (const std::uint8_t byte : bytes) machine_.send(byte);
  asked_at_ = machine_.now();
  heard_.clear();
}

void Poller::look() {
  for (const std::uint8_t byte : machine_.receive()) heard_.push_back(byte);
  if (!waiting_) {
    now_ = (now_ + 1) % questions_.size();
    std::vector<std::uint8_t> request{kUnit, questions_[now_].function};
    append(request, questions_[now_].first);
    append(request, questions_[now_].count);
    send(std::move(request));
    scans_ = {values()};
    waiting_ = true;
    return;
  }
  // Unit, function, bytes, data, CRC; or an exception of five bytes.
  const bool exception = heard_.size() >= 2 && (heard_[1] & 0x80) != 0;
  const std::size_t whole = exception ? 5 : heard_.size() >= 3 ? 5U + heard_[2] : 6U;
  if (heard_.size() >= whole) {
    check(heard_);
    waiting_ = false;
  } else if (machine_.now() - asked_at_ > kPatienceMs * machine_.clocks_per_ms()) {
    difference_ = fmt::format("no reply to function {} at {}", questions_[now_].function,
                              questions_[now_].first);
  }
}

std::vector<std::uint8_t> Poller::expected(const Question& question, const Values& values) const {
  std::vector<std::uint8_t> bytes{kUnit, question.function};
  if (question.function == kReadHolding) {
    bytes.push_back(static_cast<std::uint8_t>(2 * values.size()));
    for (const std::int16_t value : values) append(bytes, static_cast<std::uint16_t>(value));
  } else {
    bytes.push_back(static_cast<std::uint8_t>((values.size() + 7) / 8));
    const std::size_t data = bytes.size();
    bytes.resize(data + bytes.back(), 0);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i] != 0) bytes[data + i / 8] |= static_cast<std::uint8_t>(1U << i % 8);
    }
  }
  const std::uint16_t crc = crc16(bytes);
  bytes.push_back(static_cast<std::uint8_t>(crc & 0xFF));
  bytes.push_back(static_cast<std::uint8_t>(crc >> 8));
  return bytes;
}

void Poller::check(const std::vector<std::uint8_t>& reply) {
  const Question& question = questions_[now_];
  for (const Values& values : scans_) {
    if (reply == expected(question, values)) {
      ++replies_;
      return;
    }
  }
  difference_ = fmt::format("function {} at {}: reply [{:02x}] is what no scan left behind",
                            question.function, question.first, fmt::join(reply, " "));
}

void Poller::read_statistics(PlantResult& result) {
  // What is under way ends first, whatever it says.
  machine_.run(kPatienceMs * machine_.clocks_per_ms() / 10);
  machine_.receive();
  constexpr std::uint16_t kFirst = controller::holding_scan_count;
  constexpr std::uint16_t kCount = controller::holding_frames - controller::holding_scan_count + 1;
  std::vector<std::uint8_t> request{kUnit, kReadHolding};
  append(request, kFirst);
  append(request, kCount);
  send(std::move(request));
  while (heard_.size() < 5U + 2 * kCount &&
         machine_.now() - asked_at_ < kPatienceMs * machine_.clocks_per_ms()) {
    machine_.run(100);
    for (const std::uint8_t byte : machine_.receive()) heard_.push_back(byte);
  }
  if (heard_.size() != 5U + 2 * kCount)
    throw std::runtime_error("no statistics from the controller");
  const auto word = [&](int holding) -> std::uint32_t {
    const std::size_t at = 3 + 2 * static_cast<std::size_t>(holding - kFirst);
    return static_cast<std::uint32_t>(heard_[at] << 8 | heard_[at + 1]);
  };
  const auto wide = [&](int holding) { return word(holding) | word(holding + 1) << 16; };
  result.least_clocks = wide(controller::holding_scan_min);
  result.most_clocks = wide(controller::holding_scan_max);
  result.overruns = static_cast<int>(word(controller::holding_overruns));
}

}  // namespace rung::tb

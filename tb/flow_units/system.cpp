// SPDX-License-Identifier: Apache-2.0
#include "flow_units/system.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "device/flash_image.hpp"
#include "device/shared_line.hpp"
#include "flow_units/unit.hpp"
#include "rung_controller.hpp"
#include "rung_flow.hpp"

namespace rung::tb {
namespace {

constexpr std::uint64_t kClocksPerMs = RUNG_FLOW_CLOCKS_PER_MS;
constexpr std::uint64_t kPatienceMs = 10'000;
constexpr std::uint64_t kClocksBetweenNoise = 10'000;  // on average
constexpr int kHolding = 0xE100;  // register n of the flow tasks is holding register kHolding + n
constexpr std::uint8_t kUnitAddress = 1;

}  // namespace

FlowSystem::FlowSystem(int units, std::uint64_t seed)
    : random_(seed), faults_(static_cast<std::size_t>(units), LineFault::None) {
  for (int n = 1; n <= units; ++n) {
    units_.push_back(std::make_unique<FlowUnit>(kClocksPerMs, random_()));
  }
}
FlowSystem::~FlowSystem() = default;

std::uint64_t FlowSystem::clocks_per_ms() { return kClocksPerMs; }

void FlowSystem::load(int unit, std::span<const std::uint16_t> words) {
  device::put_program(at(unit).flash().memory(), controller::boards().front(), words);
}

void FlowSystem::attach_panel(int unit, int modbus_unit, double least_ms, double most_ms) {
  at(unit).attach_panel(modbus_unit, least_ms, most_ms);
}
void FlowSystem::silence_panel(int unit, bool silent) { at(unit).silence_panel(silent); }

void FlowSystem::attach_pc(int unit, int of_unit, int board, int first, int count) {
  at(unit).attach_pc({std::to_string(of_unit), std::to_string(board), std::to_string(first),
                      std::to_string(count)});
}
void FlowSystem::detach_pc(int unit) { at(unit).detach_pc(); }

void FlowSystem::clock() {
  // The link: what each drove in the last clock.
  for (std::size_t n = 0; n + 1 < units_.size(); ++n) {
    Vflow_unit& upper = units_[n]->pins();
    Vflow_unit& lower = units_[n + 1]->pins();
    bool down = upper.lower_tx_o != 0;
    bool up = lower.upper_tx_o != 0;
    if (faults_[n] == LineFault::Cut) down = up = true;
    // Now and then a bit the wrong way round, on both wires.
    if (faults_[n] == LineFault::Noise) {
      if (random_() % kClocksBetweenNoise == 0) noise_ends_ = now_ + flow::link_divisor;
      down = down != (now_ < noise_ends_);
      up = up != (now_ < noise_ends_);
    }
    lower.upper_rx_i = down;
    upper.lower_rx_i = up;
  }
  for (const auto& unit : units_) unit->before(now_);
  ++now_;
  for (const auto& unit : units_) unit->after(now_);
}

void FlowSystem::start() {
  const std::uint64_t end = now_ + kPatienceMs * kClocksPerMs;
  for (bool all = false; !all;) {
    run(kClocksPerMs);
    all = true;
    for (const auto& unit : units_) all = all && unit->pins().run_o != 0;
    if (now_ >= end) throw std::runtime_error("a unit does not run its program");
  }
}

void FlowSystem::set_input(int unit, int pin, bool level) {
  auto& pins = at(unit).pins().in_i;
  pins = static_cast<std::uint8_t>(level ? pins | 1 << pin : pins & ~(1 << pin));
}
bool FlowSystem::output(int unit, int pin) const { return (at(unit).pins().out_o >> pin & 1) != 0; }
bool FlowSystem::filtered(int unit, int pin) const {
  return (at(unit).pins().filtered_o >> pin & 1) != 0;
}
std::uint64_t FlowSystem::round_clocks(int unit) const { return at(unit).round_clocks(); }
std::uint64_t FlowSystem::most_round_clocks(int unit) const { return at(unit).most_round_clocks(); }
void FlowSystem::forget_most_round(int unit) { at(unit).forget_most_round(); }
std::uint64_t FlowSystem::rounds(int unit) const { return at(unit).rounds(); }
bool FlowSystem::faulted(int unit) const { return at(unit).pins().fault_o != 0; }

void FlowSystem::set_fault(int upper_unit, LineFault fault) {
  faults_.at(static_cast<std::size_t>(upper_unit - 1)) = fault;
}

std::vector<std::uint8_t> FlowSystem::ask(int unit, std::vector<std::uint8_t> pdu) {
  BitLine& line = at(unit).host();
  pdu.insert(pdu.begin(), kUnitAddress);
  const std::uint16_t crc = device::rtu_crc(pdu);
  pdu.push_back(static_cast<std::uint8_t>(crc & 0xFF));
  pdu.push_back(static_cast<std::uint8_t>(crc >> 8));
  line.take();
  for (const std::uint8_t byte : pdu) line.send(byte);
  std::vector<std::uint8_t> answer;
  for (const std::uint64_t end = now_ + kPatienceMs * kClocksPerMs; now_ < end;) {
    run(16);
    for (const std::uint8_t byte : line.take()) answer.push_back(byte);
    const std::size_t length = frame_length(answer, true);
    if (length != 0 && answer.size() >= length) {
      run(kClocksPerMs);  // the silence that ends the frame
      return answer;
    }
  }
  throw std::runtime_error(fmt::format("unit {} does not answer its host", unit));
}

std::vector<std::uint16_t> FlowSystem::registers(int unit, int first, int count) {
  const int address = kHolding + first;
  const auto answer =
      ask(unit, {3, static_cast<std::uint8_t>(address >> 8),
                 static_cast<std::uint8_t>(address & 0xFF), 0, static_cast<std::uint8_t>(count)});
  if (answer.at(1) != 3) throw std::runtime_error(fmt::format("exception {}", answer.at(2)));
  std::vector<std::uint16_t> words;
  for (std::size_t i = 3; i + 3 < answer.size(); i += 2) {
    words.push_back(static_cast<std::uint16_t>(answer[i] << 8 | answer[i + 1]));
  }
  return words;
}

int FlowSystem::write_registers(int unit, int first, const std::vector<std::uint16_t>& values) {
  const int address = kHolding + first;
  std::vector<std::uint8_t> pdu{
      16, static_cast<std::uint8_t>(address >> 8),  static_cast<std::uint8_t>(address & 0xFF),
      0,  static_cast<std::uint8_t>(values.size()), static_cast<std::uint8_t>(2 * values.size())};
  for (const std::uint16_t value : values) {
    pdu.push_back(static_cast<std::uint8_t>(value >> 8));
    pdu.push_back(static_cast<std::uint8_t>(value & 0xFF));
  }
  const auto answer = ask(unit, std::move(pdu));
  return answer.at(1) == 16 ? 0 : answer.at(2);
}

std::int64_t FlowSystem::pc_done(int unit) {
  std::int64_t done = 0;
  for (const std::string& line : at(unit).pc_said()) {
    if (line.starts_with("done")) {
      ++done;
    } else {
      complaints_.push_back(fmt::format("PC of unit {}: {}", unit, line));
    }
  }
  return done;
}
std::int64_t FlowSystem::panel_answers(int unit) const { return at(unit).panel_answers(); }
bool FlowSystem::panel_under_way(int unit) const { return at(unit).panel_under_way(); }

}  // namespace rung::tb

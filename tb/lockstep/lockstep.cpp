// SPDX-License-Identifier: Apache-2.0
#include "lockstep/lockstep.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "rungs/ports.hpp"

namespace rung::tb {

std::string describe(const Difference& difference) {
  std::string text = fmt::format("scan {}: {}: expected {}, got {}\n", difference.scan,
                                 difference.what, difference.expected, difference.got);
  if (!difference.where.empty()) text += fmt::format("  processor: {}\n", difference.where);
  if (!difference.source.empty()) text += fmt::format("  reference: {}\n", difference.source);
  return text;
}

Lockstep::Lockstep(const Program& program, AnyMachine& machine)
    : program_(program), machine_(machine), reference_(program, machine.tick_us()) {
  for (const image::ImageDevice& named : machine.image().devices) devices_.push_back(named.device);
  expected_.assign(devices_.size(), 0);
  got_.assign(devices_.size(), 0);
}

std::optional<Difference> Lockstep::scan(std::span<const StimulusEvent> events) {
  ++scan_;
  for (const StimulusEvent& event : events) {
    reference_.set(event.device, event.value);
    const int device = machine_.find(event.device);
    if (device >= 0) expected_[device] = got_[device] = reference_.get(event.device);
  }
  machine_.apply(events);
  reference_.run_scan();
  result_ = machine_.run_scan();

  if (const auto difference = compare_writes()) return difference;
  const auto flag = [](bool on) { return std::string(on ? "1" : "0"); };
  if (result_.error != reference_.error()) {
    return Difference{scan_, {}, {}, "error flag", flag(reference_.error()), flag(result_.error)};
  }
  if (machine_.sent() != reference_.sent()) {
    const auto show = [](const std::vector<int>& bytes) {
      return fmt::format("[{}]", fmt::join(bytes, " "));
    };
    return Difference{scan_, {}, {}, "bytes sent", show(reference_.sent()), show(machine_.sent())};
  }
  const std::string clocks = std::to_string(machine_.image().clocks);
  for (const std::uint32_t counted : {result_.clocks, result_.counted}) {
    if (std::to_string(counted) != clocks) {
      return Difference{scan_, {}, {}, "clocks", clocks, std::to_string(counted)};
    }
  }
  return compare_devices(machine_.every_write());
}

std::optional<Difference> Lockstep::compare_writes() {
  if (!machine_.every_write()) return std::nullopt;
  const std::vector<Change> expected = expected_changes();
  const std::vector<Change> got = got_changes();
  auto difference = compare_by_device(expected, got);
  if (!difference && machine_.image().mpu == isa::Mpu::Mpu1) {
    difference = compare_order(expected, got);
  }
  return difference;
}

std::string Lockstep::source_of(std::size_t instruction) const {
  const Instruction& source = program_.instructions[instruction];
  return fmt::format("{}:{}:{}: {}", program_.file, source.position.line, source.position.column,
                     source.text);
}

// Null stands for a write that one of the two does not have.
std::optional<Difference> Lockstep::compare_write(const ReferenceWrite* expected,
                                                  const MachineWrite* got) {
  const auto show = [&](Device device, std::int16_t value) {
    const auto comment = program_.comments.find(device);
    return fmt::format("{}{} = {}", device_name(device, program_),
                       comment == program_.comments.end() ? "" : " (" + comment->second + ")",
                       value);
  };
  if (expected != nullptr && got != nullptr && devices_[got->device] == expected->device &&
      got->value == expected->value) {
    return std::nullopt;
  }
  Difference difference;
  difference.scan = scan_;
  difference.what = "write";
  difference.expected = expected ? show(expected->device, expected->value) : "no write";
  difference.got = got ? show(devices_[got->device], got->value) : "no write";
  if (got != nullptr) difference.where = machine_.describe(*got);
  if (expected != nullptr) difference.source = source_of(expected->instruction);
  return difference;
}

std::vector<Lockstep::Change> Lockstep::expected_changes() {
  std::vector<Change> changes;
  for (const ReferenceWrite& write : reference_.writes()) {
    const int device = machine_.find(write.device);
    if (device < 0 || std::exchange(expected_[device], write.value) == write.value) continue;
    changes.push_back({device, write.value, &write, nullptr});
  }
  return changes;
}

std::vector<Lockstep::Change> Lockstep::got_changes() {
  std::vector<Change> changes;
  for (const MachineWrite& write : machine_.writes()) {
    if (std::exchange(got_[write.device], write.value) == write.value) continue;
    changes.push_back({write.device, write.value, nullptr, &write});
  }
  return changes;
}

std::optional<Difference> Lockstep::compare_by_device(const std::vector<Change>& expected,
                                                      const std::vector<Change>& got) {
  std::vector<std::vector<const ReferenceWrite*>> queues(devices_.size());
  for (const Change& change : expected) queues[change.device].push_back(change.expected);
  std::vector<std::size_t> next(devices_.size(), 0);
  for (const Change& change : got) {
    const auto& queue = queues[change.device];
    std::size_t& at = next[change.device];
    auto difference = compare_write(at < queue.size() ? queue[at] : nullptr, change.got);
    if (difference) return difference;
    ++at;
  }
  for (std::size_t device = 0; device < devices_.size(); ++device) {
    if (next[device] < queues[device].size()) {
      return compare_write(queues[device][next[device]], nullptr);
    }
  }
  return std::nullopt;
}

// Within one instruction several devices may change in either order.
std::optional<Difference> Lockstep::compare_order(const std::vector<Change>& expected,
                                                  const std::vector<Change>& got) {
  const auto& origins = machine_.image().origins;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const MachineWrite& write = *got[i].got;
    const auto instruction = static_cast<std::size_t>(origins[write.step][write.slot]);
    if (instruction == expected[i].expected->instruction) continue;
    Difference difference;
    difference.scan = scan_;
    difference.what = "order of writes";
    difference.expected = source_of(expected[i].expected->instruction);
    difference.got = source_of(instruction);
    difference.where = machine_.describe(write);
    return difference;
  }
  return std::nullopt;
}

std::optional<Difference> Lockstep::compare_state() {
  auto difference = compare_devices(false);
  return difference ? difference : compare_ports();
}

// Those that the program drives; what it has sent has been compared.
std::optional<Difference> Lockstep::compare_ports() {
  std::vector<Device> ports{port::uart_rx_full, port::persist_ready, port::pwm_duty,
                            port::pwm_hz_low,   port::pwm_hz_high,   port::persist_index};
  for (int i = 0; i < port::persist_value_count; ++i) {
    ports.push_back(port::at(port::persist_value, i));
  }
  for (const Device port : ports) {
    if (!machine_.peripherals().has(port)) continue;
    const std::int16_t expected = reference_.get(port);
    const std::int16_t got = machine_.peripherals().value(port);
    if (expected == got) continue;
    return Difference{scan_,
                      {},
                      {},
                      fmt::format("port {} after the scan", device_name(port, program_.dialect)),
                      std::to_string(expected),
                      std::to_string(got)};
  }
  return std::nullopt;
}

std::optional<Difference> Lockstep::compare_devices(bool outputs_only) {
  for (std::size_t i = 0; i < devices_.size(); ++i) {
    if (outputs_only && devices_[i].kind != DeviceKind::Y) continue;
    if (is_port(devices_[i].kind)) continue;
    const std::int16_t expected = reference_.get(devices_[i]);
    const std::int16_t got = machine_.value(i);
    if (expected == got) continue;
    return Difference{scan_,
                      {},
                      {},
                      fmt::format("value of {} after the scan", machine_.image().devices[i].name),
                      std::to_string(expected),
                      std::to_string(got)};
  }
  return std::nullopt;
}

}  // namespace rung::tb

// SPDX-License-Identifier: Apache-2.0
#include "lower/context.hpp"

#include <algorithm>

namespace rung::lower {
namespace {

// Hidden devices by number: memories from 0, temporaries from kTemporaries, words of ticks from
// kTicks, of tables from kConstants. Temporaries of one network are used again some networks later:
// far enough that rungs can still run side by side, early enough that memory does not fill up.
constexpr std::uint32_t kTemporaries = 1U << 20U;
constexpr std::uint32_t kTicks = 1U << 21U;
constexpr std::uint32_t kConstants = 1U << 22U;
constexpr std::uint32_t kBitsBeforeReuse = 96;
constexpr std::uint32_t kWordsBeforeReuse = 24;

}  // namespace

Context::Context(const Program& program) : program_(program) {
  for (const Device device : named_devices(program)) named_.insert(device);
  for (const IndexWindow& window : index_windows(program)) {
    std::vector<Device>& devices = windows_[window.kind];
    for (std::uint32_t n = window.first; n <= window.last; ++n) devices.push_back({window.kind, n});
    out_.windows.push_back(devices);
  }
}

void Context::begin_network() {
  begins_.push_back(out_.instructions.size());
  if (begins_.size() > 1) return;
  out_.networks.push_back({out_.instructions.size(), 0});
  if (next_bit_ > kBitsBeforeReuse) next_bit_ = 0;
  if (next_word_ > kWordsBeforeReuse) next_word_ = 0;
}

void Context::end_network() {
  const auto first = out_.instructions.begin() + static_cast<std::ptrdiff_t>(begins_.back());
  begins_.pop_back();
  if (!begins_.empty()) {
    // Of NOPs alone there is no result to drop.
    const bool result = std::any_of(first, out_.instructions.end(), [](const auto& instruction) {
      return instruction.op == core::Op::Ld || instruction.op == core::Op::Ldi;
    });
    if (result) block(core::Op::Pop);
    return;
  }
  core::Network& network = out_.networks.back();
  network.count = out_.instructions.size() - network.first;
  if (network.count == 0) out_.networks.pop_back();
}

core::Instruction Context::make(core::Op op) const {
  core::Instruction instruction;
  instruction.op = op;
  instruction.origin = index_;
  return instruction;
}

void Context::emit(core::Instruction instruction) {
  instruction.origin = index_;
  const bool can_be_always = core::is_output(instruction.op) && instruction.op != core::Op::Out;
  if (surely_on_ && can_be_always) instruction.always = true;
  out_.instructions.push_back(std::move(instruction));
}

void Context::contact(core::Op op, Device bit) {
  const SpecialRange* special = find_special(bit, dialect());
  surely_on_ = op == core::Op::Ld && special != nullptr && special->role == SpecialRole::On;
  core::Instruction instruction = make(op);
  instruction.targets = {bit};
  emit(std::move(instruction));
}

void Context::block(core::Op op) {
  surely_on_ = false;
  emit(make(op));
}

void Context::coil(core::Op op, Device bit, bool quiet) {
  core::Instruction instruction = make(op);
  instruction.targets = {bit};
  instruction.quiet = quiet;
  emit(std::move(instruction));
}

void Context::always(core::Op op, std::initializer_list<Device> targets,
                     std::initializer_list<WordSource> sources) {
  core::Instruction instruction = make(op);
  instruction.targets = targets;
  instruction.sources = sources;
  instruction.always = true;
  emit(std::move(instruction));
}

void Context::gated(core::Op op, std::initializer_list<Device> targets,
                    std::initializer_list<WordSource> sources, bool quiet) {
  core::Instruction instruction = make(op);
  instruction.targets = targets;
  instruction.sources = sources;
  instruction.quiet = quiet;
  emit(std::move(instruction));
}

void Context::compute(Device bit, const std::vector<std::pair<Device, bool>>& contacts) {
  bool first = true;
  for (const auto& [device, inverted] : contacts) {
    if (first) {
      contact(inverted ? core::Op::Ldi : core::Op::Ld, device);
    } else {
      contact(inverted ? core::Op::Ani : core::Op::And, device);
    }
    first = false;
  }
  coil(core::Op::Out, bit);
  block(core::Op::Pop);
}

void Context::gate() {
  if (power_) contact(core::Op::And, *power_);
  gate_live();
}

void Context::gate_live() {
  if (live_) contact(core::Op::And, *live_);
}

void Context::drive(Device bit, bool quiet) {
  if (live_) {
    gate_live();
    contact(core::Op::Ld, bit);
    contact(core::Op::Ani, *live_);
    block(core::Op::Orb);
    quiet = true;
  }
  coil(core::Op::Out, bit, quiet);
}

Device Context::fresh_bit() { return {DeviceKind::HB, next_memory_++}; }

Device Context::memory(int which) {
  const auto [place, fresh] = memories_.try_emplace({index_, which});
  if (fresh) place->second = fresh_bit();
  return place->second;
}

Device Context::memory_word(int which) {
  const auto number = static_cast<std::uint32_t>(memory_words_.size());
  return memory_words_.try_emplace({index_, which}, Device{DeviceKind::HW, number}).first->second;
}

Device Context::memory_of(Device device, Role role) {
  const auto [place, fresh] = device_memories_.try_emplace({device, role});
  if (fresh) place->second = fresh_bit();
  return place->second;
}

Device Context::temporary_bit() { return {DeviceKind::HB, kTemporaries + next_bit_++}; }

Device Context::temporary_word() { return {DeviceKind::HW, kTemporaries + next_word_++}; }

Device Context::ticks(std::int64_t base_us) {
  for (const core::TickWord& word : out_.ticks) {
    if (word.base_us == base_us) return word.device;
  }
  const Device device{DeviceKind::HW, kTicks + static_cast<std::uint32_t>(out_.ticks.size())};
  out_.ticks.push_back({device, base_us});
  return device;
}

void Context::load_constant(Device target, const std::vector<std::int32_t>& values,
                            const WordSource& index, bool always) {
  std::vector<Device>& table = tables_[values];
  if (table.empty()) {
    for (const std::int32_t value : values) {
      const auto number = kConstants + static_cast<std::uint32_t>(out_.constants.size());
      table.push_back({DeviceKind::HW, number});
      out_.constants.push_back({table.back(), constant(value).value});
    }
  }
  core::Instruction load = make(core::Op::LoadWord);
  load.head = table.front();
  load.sources = {index};
  load.targets = {target};
  load.reads = table;
  load.always = always;
  load.quiet = true;
  emit(std::move(load));
}

std::vector<Device> Context::named_of_role(SpecialRole role) const {
  std::vector<Device> devices = devices_of_role(role, dialect());
  std::erase_if(devices, [&](Device device) { return !is_named(device); });
  return devices;
}

const std::vector<Device>& Context::window(DeviceKind kind) const { return windows_.at(kind); }

}  // namespace rung::lower

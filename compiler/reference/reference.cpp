// SPDX-License-Identifier: Apache-2.0
#include "reference/reference.hpp"

#include "rungs/devices.hpp"

namespace rung {
namespace {

// The low 16 bits of `value` as a signed word.
std::int16_t low_word(std::int32_t value) {
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(value));
}

std::int16_t high_word(std::int32_t value) { return low_word(value >> 16); }

}  // namespace

Reference::Reference(const Program& program) : program_(program) {
  for (const DeviceKind kind : {DeviceKind::X, DeviceKind::Y, DeviceKind::M, DeviceKind::D}) {
    devices_[static_cast<std::size_t>(kind)].resize(device_range(kind, program.dialect).last + 1);
  }
}

void Reference::set(Device device, std::int16_t value) {
  if (!is_word(device)) value = value != 0 ? 1 : 0;
  devices_[static_cast<std::size_t>(device.kind)][device.number] = value;
}

std::int16_t Reference::get(Device device) const {
  return devices_[static_cast<std::size_t>(device.kind)][device.number];
}

void Reference::run_scan() {
  begin_scan();
  while (step()) {
  }
}

void Reference::begin_scan() {
  next_ = 0;
  network_ = 0;
  writes_.clear();
  error_ = false;
}

bool Reference::step() {
  if (next_ == program_.instructions.size()) return false;
  if (network_ < program_.networks.size() && program_.networks[network_].first == next_) {
    ++network_;
    blocks_.clear();
    branches_.clear();
    result_ = false;
  }
  execute(program_.instructions[next_]);
  ++next_;
  return true;
}

void Reference::execute(const Instruction& instruction) {
  switch (instruction.op) {
    case Op::Nop:
      return;
    case Op::Ld:
      return load(get(instruction.device) != 0);
    case Op::Ldi:
      return load(get(instruction.device) == 0);
    case Op::And:
      result_ = result_ && get(instruction.device) != 0;
      return;
    case Op::Ani:
      result_ = result_ && get(instruction.device) == 0;
      return;
    case Op::Or:
      result_ = result_ || get(instruction.device) != 0;
      return;
    case Op::Ori:
      result_ = result_ || get(instruction.device) == 0;
      return;
    case Op::Anb: {
      const bool block = pop_block();
      result_ = result_ && block;
      return;
    }
    case Op::Orb: {
      const bool block = pop_block();
      result_ = result_ || block;
      return;
    }
    case Op::Mps:
      branches_.push_back(result_);
      return;
    case Op::Mrd:
      result_ = branches_.back();
      return;
    case Op::Mpp:
      result_ = branches_.back();
      branches_.pop_back();
      return;
    case Op::Out:
      write(instruction.device, result_ ? 1 : 0);
      return;
    case Op::Set:
      if (result_) write(instruction.device, 1);
      return;
    case Op::Rst:
      if (result_) write(instruction.device, 0);
      return;
    case Op::Mov:
    case Op::Add:
    case Op::Sub:
    case Op::Mul:
    case Op::Div:
      if (result_) execute_word(instruction);
      return;
  }
}

void Reference::execute_word(const Instruction& instruction) {
  // Both sources are read before anything is written: a target may be a source too.
  const std::int32_t a = value(instruction.sources[0]);
  const std::int32_t b = value(instruction.sources[1]);
  const Device next{instruction.device.kind, instruction.device.number + 1};
  switch (instruction.op) {
    case Op::Mov:
      write(instruction.device, low_word(a));
      return;
    case Op::Add:
      write(instruction.device, low_word(a + b));
      return;
    case Op::Sub:
      write(instruction.device, low_word(a - b));
      return;
    case Op::Mul:
      write(instruction.device, low_word(a * b));
      if (instruction.double_width) write(next, high_word(a * b));
      return;
    case Op::Div:
      if (b == 0) {
        error_ = true;
        return;
      }
      // C++ divides toward zero, the remainder having the sign of the dividend, as MELSEC does.
      write(instruction.device, low_word(a / b));
      if (instruction.double_width) write(next, low_word(a % b));
      return;
    default:
      return;
  }
}

std::int16_t Reference::value(const WordSource& source) const {
  return source.constant ? source.value : get(source.device);
}

void Reference::load(bool value) {
  // At the start of a network this keeps a result that no ANB or ORB will ask for.
  blocks_.push_back(result_);
  result_ = value;
}

bool Reference::pop_block() {
  const bool block = blocks_.back();
  blocks_.pop_back();
  return block;
}

void Reference::write(Device device, std::int16_t value) {
  set(device, value);
  writes_.push_back({device, value, next_});
}

}  // namespace rung

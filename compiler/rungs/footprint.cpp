// SPDX-License-Identifier: Apache-2.0
#include "rungs/footprint.hpp"

#include <algorithm>
#include <map>

#include "rungs/devices.hpp"
#include "rungs/special.hpp"

namespace rung {
namespace {

// An indexed operand reaches so far beyond the highest head of its kind.
constexpr std::uint32_t kIndexReach = 127;

class Collector {
 public:
  Collector(const Instruction& instruction, Dialect dialect)
      : instruction_(instruction), dialect_(dialect) {}

  std::vector<Device> collect() {
    const auto at = [&](std::size_t i) -> const Operand& { return instruction_.operand(i); };
    const int width = instruction_.width;
    switch (instruction_.op) {
      case Op::OutT:
      case Op::OutC:
        timer_or_counter(at(0).device);
        word(at(1), instruction_.op == Op::OutC && wide_counter() ? 32 : 16);
        break;
      case Op::Rst:
        if (is_timer(at(0).device.kind) || is_counter(at(0).device.kind)) {
          timer_or_counter(at(0).device);
        } else {
          operand(at(0), 16);
        }
        break;
      case Op::Sft:
        bits(at(0), 1);
        if (at(0).device.number > 0) add({at(0).device.kind, at(0).device.number - 1});
        break;
      case Op::Sftl:
      case Op::Sftr:
      case Op::Wsfl:
      case Op::Wsfr:
        elements(at(0), at(3).value, 16);
        elements(at(1), at(2).value, 16);
        break;
      case Op::Bsfl:
      case Op::Bsfr:
      case Op::Dsfl:
      case Op::Dsfr:
        elements(at(0), at(1).value, 16);
        break;
      case Op::Bmov:
        elements(at(0), at(2).value, width);
        elements(at(1), at(2).value, width);
        break;
      case Op::Fmov:
        operand(at(0), width);
        elements(at(1), at(2).value, width);
        break;
      case Op::Mul:
      case Op::Div:
        operand(at(0), width);
        operand(at(1), width);
        word(at(2), instruction_.double_width ? 2 * width : width);
        break;
      case Op::Cmp:
        operand(at(0), width);
        operand(at(1), width);
        bits(at(2), 3);
        break;
      case Op::Zcp:
        for (std::size_t i = 0; i < 3; ++i) operand(at(i), width);
        bits(at(3), 3);
        break;
      case Op::Zrst:
        range(at(0).device, at(1).device);
        break;
      case Op::Rcl:
      case Op::Rcr:
        operand(at(0), width);
        for (const Device carry : devices_of_role(SpecialRole::Carry, dialect_)) add(carry);
        break;
      default:
        for (const Operand& each : instruction_.operands) operand(each, width);
    }
    return std::move(devices_);
  }

 private:
  void add(Device device) { devices_.push_back(device); }

  bool wide_counter() const { return is_32_bit_counter(instruction_.operand(0).device, dialect_); }

  void timer_or_counter(Device device) {
    add(contact_of(device));
    const Device value = value_of(contact_of(device));
    add(value);
    if (is_32_bit_counter(value, dialect_)) add(high_word(value, dialect_));
  }

  void bits(const Operand& head, int count) { elements(head, count, 16); }

  void elements(const Operand& head, int count, int width) {
    for (int i = 0; i < count; ++i) operand(element(head, i, width), width);
  }

  void word(const Operand& each, int width) {
    if (each.index) add(*each.index);
    if (each.kind != Operand::Kind::Device) return;
    for (const Device device : words_of(each.device, width, dialect_)) add(device);
  }

  void operand(const Operand& each, int width) {
    switch (each.kind) {
      case Operand::Kind::Device:
        if (is_word(each.device)) return word(each, width);
        if (each.index) add(*each.index);
        return add(each.device);
      case Operand::Kind::Digits:
        for (const Device bit : digit_bits(each)) add(bit);
        return;
      case Operand::Kind::WordBit:
        return add(each.device);
      case Operand::Kind::Constant:
      case Operand::Kind::Number:
        return;
    }
  }

  void range(Device first, Device last) {
    for (std::uint32_t n = first.number; n <= std::max(first.number, last.number); ++n) {
      const Device device{first.kind, n};
      if (is_timer(first.kind) || is_counter(first.kind)) {
        timer_or_counter(device);
      } else {
        add(device);
      }
    }
  }

  const Instruction& instruction_;
  Dialect dialect_;
  std::vector<Device> devices_;
};

}  // namespace

Operand element(const Operand& first, int i, int width) {
  Operand operand = first;
  if (first.kind == Operand::Kind::Digits) {
    operand.device.number += static_cast<std::uint32_t>(4 * first.digits * i);
  } else if (first.kind == Operand::Kind::Device) {
    const int stride = is_word(first.device) && width == 32 ? 2 : 1;
    operand.device.number += static_cast<std::uint32_t>(stride * i);
  }
  return operand;
}

std::vector<Device> digit_bits(const Operand& operand) {
  std::vector<Device> bits;
  for (int i = 0; i < 4 * operand.digits; ++i) {
    bits.push_back({operand.device.kind, operand.device.number + static_cast<std::uint32_t>(i)});
  }
  return bits;
}

std::vector<Device> words_of(Device device, int width, Dialect dialect) {
  std::vector<Device> words{device};
  if (width >= 32) words.push_back(high_word(device, dialect));
  for (int i = 2; i < width / 16; ++i) {
    words.push_back({device.kind, device.number + static_cast<std::uint32_t>(i)});
  }
  return words;
}

std::vector<Device> footprint(const Instruction& instruction, Dialect dialect) {
  return Collector(instruction, dialect).collect();
}

std::vector<IndexWindow> index_windows(const Program& program) {
  std::map<DeviceKind, std::uint32_t> heads;  // the highest indexed one of each kind
  for (const Instruction& instruction : program.instructions) {
    for (const Operand& operand : instruction.operands) {
      if (!operand.index) continue;
      std::uint32_t& head = heads[operand.device.kind];
      head = std::max(head, operand.device.number);
    }
  }
  std::vector<IndexWindow> windows;
  if (heads.empty()) return windows;
  const std::vector<Device> named = named_devices(program);
  for (const auto& [kind, head] : heads) {
    IndexWindow window{kind, head, head};
    for (const Device device : named) {
      if (device.kind != kind || find_special(device, program.dialect) != nullptr) continue;
      window.first = std::min(window.first, device.number);
      window.last = std::max(window.last, device.number);
    }
    const std::uint32_t end = device_range(kind, program.dialect).last;
    window.last = std::min(std::max(window.last, head + kIndexReach), end);
    windows.push_back(window);
  }
  return windows;
}

}  // namespace rung

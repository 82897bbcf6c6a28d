// SPDX-License-Identifier: Apache-2.0
// Timers and counters, and RST, which knows them.
#include <algorithm>
#include <utility>

#include "reference/reference.hpp"
#include "rungs/devices.hpp"

namespace rung {
namespace {

// Special relay M8200 + n is the direction of counter C200 + n.
constexpr std::uint32_t kDirections = 8000;

}  // namespace

void Reference::out_timer(const Instruction& instruction) {
  const Device contact = contact_of(instruction.operand(0).device);
  const Device value = value_of(contact);
  const bool on = condition();
  Coil& coil = coils_[contact];
  const bool was_on = std::exchange(coil.on, on);
  const bool ticks_used = std::exchange(coil.executed_scan, time_.scan) == time_.scan;
  if (!on) {
    if (timer_range(contact, program_.dialect).retentive) return;
    change(value, 0);
    change(contact, 0);
    return;
  }
  const auto preset = static_cast<std::uint16_t>(read_word(instruction.operand(1), 16));
  if (was_on && get(contact) == 0) {
    const int ticks = ticks_used ? 0 : ticks_since_last(instruction.base_us, time_);
    const auto sum = static_cast<std::uint16_t>(static_cast<std::uint16_t>(get(value)) + ticks);
    change(value, static_cast<std::int16_t>(std::min(sum, preset)));
  }
  if (static_cast<std::uint16_t>(get(value)) >= preset) change(contact, 1);
}

void Reference::out_counter(const Instruction& instruction) {
  const Device contact = contact_of(instruction.operand(0).device);
  const bool wide = is_32_bit_counter(contact, program_.dialect);
  const std::int32_t preset = read_word(instruction.operand(1), wide ? 32 : 16);
  const bool on = condition();
  Coil& coil = coils_[contact];
  const bool rise = !std::exchange(coil.on, on) && on && !coil.held;
  if (!rise) return;
  if (wide) {
    count_32(contact, preset);
  } else {
    count_16(contact, preset);
  }
}

void Reference::count_16(Device contact, std::int32_t preset) {
  if (get(contact) != 0) return;
  const Device value = value_of(contact);
  const auto count = static_cast<std::int16_t>(get(value) + 1);
  change(value, count);
  if (count >= preset) change(contact, 1);
}

void Reference::count_32(Device contact, std::int32_t preset) {
  Operand value;
  value.device = value_of(contact);
  // A ring: counted without a sign, so that the highest value and the lowest are neighbours.
  auto count = static_cast<std::uint32_t>(read_word(value, 32));
  const bool down = get({DeviceKind::M, kDirections + contact.number}) != 0;
  if (down && count == static_cast<std::uint32_t>(preset)) change(contact, 0);
  count += down ? -1U : 1U;
  change(value.device, static_cast<std::int16_t>(count));
  change(high_word(value.device, program_.dialect), static_cast<std::int16_t>(count >> 16));
  if (!down && count == static_cast<std::uint32_t>(preset)) change(contact, 1);
}

void Reference::reset(const Instruction& instruction) {
  const Operand& target = instruction.operand(0);
  if (is_counter(target.device.kind)) coils_[contact_of(target.device)].held = condition();
  if (!executes(instruction)) return;
  if (is_counter(target.device.kind) || is_timer(target.device.kind)) return clear(target.device);
  const std::optional<Operand> located = locate(target, 1);
  if (!located) return fail();
  if (located->kind == Operand::Kind::Device && is_word(located->device)) {
    write_word(*located, 0, 16);
  } else {
    write_bit(*located, false);
  }
}

void Reference::clear(Device timer_or_counter) {
  const Device contact = contact_of(timer_or_counter);
  const Device value = value_of(contact);
  change(value, 0);
  if (is_32_bit_counter(value, program_.dialect)) change(high_word(value, program_.dialect), 0);
  change(contact, 0);
}

// ZRST
void Reference::reset_range(const Instruction& instruction) {
  const Device first = instruction.operand(0).device;
  const std::uint32_t last = std::max(first.number, instruction.operand(1).device.number);
  for (std::uint32_t n = first.number; n <= last; ++n) {
    const Device device{first.kind, n};
    if (is_counter(first.kind) || is_timer(first.kind)) {
      clear(device);
    } else {
      write(device, 0);
    }
  }
}

}  // namespace rung

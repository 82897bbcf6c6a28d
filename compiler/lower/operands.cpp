// SPDX-License-Identifier: Apache-2.0
#include "lower/operands.hpp"

#include "lower/condition.hpp"
#include "rungs/devices.hpp"

namespace rung::lower {
namespace {

using core::Op;

// `bits` from `first` to before `end` as a word.
WordSource gather(Context& context, const std::vector<Device>& bits, std::size_t first,
                  std::size_t end) {
  core::Instruction instruction;
  instruction.op = Op::Gather;
  instruction.always = true;
  const Device target = context.temporary_word();
  instruction.targets = {target};
  for (std::size_t i = first; i < std::min(end, bits.size()); ++i) {
    instruction.reads.push_back(bits[i]);
  }
  context.emit(std::move(instruction));
  return word(target);
}

core::Instruction indexed(Context& context, Op op, DeviceKind kind, Device number) {
  core::Instruction instruction;
  instruction.op = op;
  instruction.head = context.window(kind).front();
  instruction.sources = {word(number)};
  return instruction;
}

WordSource load(Context& context, DeviceKind kind, Device number) {
  core::Instruction instruction = indexed(context, Op::LoadWord, kind, number);
  const Device target = context.temporary_word();
  instruction.targets = {target};
  instruction.reads = context.window(kind);
  instruction.always = true;
  context.emit(std::move(instruction));
  return word(target);
}

Device next_number(Context& context, Device number, int further) {
  if (further == 0) return number;
  const Device next = context.temporary_word();
  context.always(Op::Add, {next}, {word(number), constant(further)});
  return next;
}

void scatter(Context& context, const Operand& digits, const std::vector<WordSource>& words,
             bool quiet) {
  const std::vector<Device> bits = digit_bits(digits);
  for (std::size_t i = 0; i < bits.size() && i / 16 < words.size(); ++i) {
    const WordSource& source = words[i / 16];
    const int bit = static_cast<int>(i % 16);
    if (source.constant) {
      context.coil((source.value >> bit & 1) != 0 ? Op::Set : Op::Rst, bits[i], quiet);
    } else {
      context.gated(Op::Tb, {bits[i]}, {source, constant(bit)}, quiet);
    }
  }
}

}  // namespace

Offset index_offset(Context& context, const Operand& operand, int words) {
  const std::vector<Device>& window = context.window(operand.device.kind);
  const Offset offset{context.temporary_word(), context.temporary_bit()};
  const auto head = static_cast<std::int32_t>(operand.device.number - window.front().number);
  context.always(Op::Add, {offset.number}, {word(*operand.index), constant(head)});
  const auto size = static_cast<std::int32_t>(window.size()) - (words - 1);
  context.always(Op::Ltu, {offset.inside}, {word(offset.number), constant(std::max(size, 0))});
  return offset;
}

WordSource read16(Context& context, const Operand& operand, std::vector<Device>& valid) {
  switch (operand.kind) {
    case Operand::Kind::Constant:
      return constant(operand.value);
    case Operand::Kind::Digits:
      return gather(context, digit_bits(operand), 0, 16);
    default:
      break;
  }
  if (!operand.index) return word(operand.device);
  const Offset offset = index_offset(context, operand, 1);
  valid.push_back(offset.inside);
  return load(context, operand.device.kind, offset.number);
}

Pair read32(Context& context, const Operand& operand, std::vector<Device>& valid) {
  switch (operand.kind) {
    case Operand::Kind::Constant:
      return {constant(operand.value), constant(operand.value >> 16)};
    case Operand::Kind::Digits: {
      const std::vector<Device> bits = digit_bits(operand);
      const WordSource low = gather(context, bits, 0, 16);
      return {low, bits.size() > 16 ? gather(context, bits, 16, 32) : constant(0)};
    }
    default:
      break;
  }
  if (!operand.index) {
    return {word(operand.device), word(high_word(operand.device, context.dialect()))};
  }
  const Offset offset = index_offset(context, operand, 2);
  valid.push_back(offset.inside);
  const DeviceKind kind = operand.device.kind;
  const WordSource low = load(context, kind, offset.number);
  return {low, load(context, kind, next_number(context, offset.number, 1))};
}

Place place(Context& context, const Operand& operand, int words, std::vector<Device>& valid) {
  Place place{operand, std::nullopt};
  if (!operand.index) return place;
  const Offset offset = index_offset(context, operand, words);
  valid.push_back(offset.inside);
  place.offset = offset.number;
  return place;
}

std::vector<Device> direct_words(const Context& context, const Place& place, int count) {
  if (place.operand.kind != Operand::Kind::Device || place.offset) return {};
  return words_of(place.operand.device, 16 * count, context.dialect());
}

void store(Context& context, const Place& place, const std::vector<WordSource>& words, bool quiet) {
  if (place.operand.kind == Operand::Kind::Digits) {
    return scatter(context, place.operand, words, quiet);
  }
  const auto count = static_cast<int>(words.size());
  if (!place.offset) {
    const std::vector<Device> targets = direct_words(context, place, count);
    // A word that a later one still reads may not be written before it: DMOV D0 D1.
    const bool downward = count == 2 && !words[1].constant && words[1].device == targets[0];
    for (int i = 0; i < count; ++i) {
      const int n = downward ? count - 1 - i : i;
      context.gated(Op::Mov, {targets[n]}, {words[n]}, quiet);
    }
    return;
  }
  const DeviceKind kind = place.operand.device.kind;
  for (int i = 0; i < count; ++i) {
    core::Instruction instruction =
        indexed(context, Op::StoreWord, kind, next_number(context, *place.offset, i));
    instruction.sources.push_back(words[i]);
    instruction.targets = context.window(kind);
    instruction.quiet = quiet;
    context.emit(std::move(instruction));
  }
}

Device contact_bit(Context& context, const Operand& operand) {
  if (operand.kind == Operand::Kind::WordBit) {
    const Device bit = context.temporary_bit();
    context.always(Op::Tb, {bit}, {word(operand.device), constant(operand.bit)});
    return bit;
  }
  if (!operand.index) return operand.device;
  const Offset offset = index_offset(context, operand, 1);
  core::Instruction load = indexed(context, Op::LoadBit, operand.device.kind, offset.number);
  const Device found = context.temporary_bit();
  load.targets = {found};
  load.reads = context.window(operand.device.kind);
  load.always = true;
  context.emit(std::move(load));
  const Device bit = context.temporary_bit();
  context.compute(bit, {{found, false}, {offset.inside, false}});
  set_errors_beside(context, offset.inside);
  return bit;
}

}  // namespace rung::lower

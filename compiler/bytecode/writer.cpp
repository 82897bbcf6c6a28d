// SPDX-License-Identifier: Apache-2.0
#include "bytecode/writer.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <stdexcept>

#include "bytecode/code.hpp"
#include "bytecode/interpreter/rung_format.h"
#include "bytecode/layout.hpp"
#include "bytecode/stacks.hpp"
#include "rungs/footprint.hpp"
#include "rungs/ports.hpp"
#include "rungs/special.hpp"

namespace rung::bytecode {
namespace {

constexpr std::size_t kLongestName = 0xFFFF;

class Bytes {
 public:
  void put(std::uint64_t value, int width) {
    if (value >> (8 * width) != 0) throw std::logic_error("byte code: a number beyond its field");
    for (int i = 0; i < width; ++i) bytes_ += static_cast<char>(value >> (8 * i) & 0xFFU);
  }
  void add(const std::string& bytes) { bytes_ += bytes; }
  // Another value in the place of one that stands there.
  void set(std::size_t at, std::uint64_t value, int width) {
    for (int i = 0; i < width; ++i) bytes_[at + i] = static_cast<char>(value >> (8 * i) & 0xFFU);
  }
  std::size_t size() const { return bytes_.size(); }
  std::string take() { return std::move(bytes_); }
  std::uint32_t crc() const {
    return static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef*>(bytes_.data()), static_cast<uInt>(bytes_.size())));
  }

 private:
  std::string bytes_;
};

// A section: how many records, and their bytes.
struct Section {
  int count = 0;
  Bytes bytes;
};

std::uint32_t checked_time(std::int64_t microseconds) {
  if (microseconds < 0 || microseconds >= static_cast<std::int64_t>(RUNG_TIMES)) {
    throw std::logic_error("byte code: a time that it cannot hold");
  }
  return static_cast<std::uint32_t>(microseconds);
}

Section ticks_of(const core::Program& program, const Layout& layout) {
  Section section;
  for (const core::TickWord& word : program.ticks) {
    ++section.count;
    section.bytes.put(static_cast<std::uint64_t>(layout.number(word.device)), 2);
    section.bytes.put(checked_time(word.base_us), 4);
  }
  return section;
}

int role_of(SpecialRole role) {
  switch (role) {
    case SpecialRole::On:
      return RUNG_ROLE_ON;
    case SpecialRole::FirstScan:
      return RUNG_ROLE_FIRST_SCAN;
    case SpecialRole::NotFirstScan:
      return RUNG_ROLE_NOT_FIRST_SCAN;
    case SpecialRole::Clock:
      return RUNG_ROLE_CLOCK;
    default:
      return RUNG_ROLE_OFF;
  }
}

Section driven_of(const Program& source, const Layout& layout) {
  Section section;
  for (const auto& [device, number] : layout.devices()) {
    const SpecialRange* special = find_special(device, source.dialect);
    if (special == nullptr || !is_driven(special->role)) continue;
    ++section.count;
    section.bytes.put(static_cast<std::uint64_t>(number), 2);
    section.bytes.put(static_cast<std::uint64_t>(role_of(special->role)), 1);
    section.bytes.put(checked_time(special->period_us), 4);
  }
  return section;
}

Section ports_of(const Layout& layout) {
  Section section;
  for (const auto& [device, number] : layout.devices()) {
    if (!is_port(device.kind)) continue;
    ++section.count;
    section.bytes.put(is_word(device) ? RUNG_SPACE_WORD : RUNG_SPACE_BIT, 1);
    section.bytes.put(device.number, 1);
    section.bytes.put(static_cast<std::uint64_t>(number), 2);
  }
  return section;
}

void add_name(Section& section, Device device, int number, int use, const std::string& name) {
  const std::string shown = name.substr(0, kLongestName);
  ++section.count;
  section.bytes.put(static_cast<std::uint64_t>(use << 1 | (is_word(device) ? 1 : 0)), 1);
  section.bytes.put(static_cast<std::uint64_t>(number), 2);
  section.bytes.put(shown.size(), 2);
  section.bytes.add(shown);
}

Section names_of(const Program& source, const Layout& layout) {
  Section section;
  for (const Device device : visible_devices(source)) {
    if (is_hidden(device.kind)) continue;
    const int use = device.kind == DeviceKind::X   ? RUNG_USE_INPUT
                    : device.kind == DeviceKind::Y ? RUNG_USE_OUTPUT
                                                   : RUNG_USE_INNER;
    add_name(section, device, layout.number(device), use, device_name(device, source));
  }
  for (int i = 0; i < port::adc_count; ++i) {
    const Device channel = port::at(port::adc, i);
    const auto name = source.names.find(channel);
    const auto place = layout.devices().find(channel);
    if (name == source.names.end() || place == layout.devices().end()) continue;
    add_name(section, channel, place->second, RUNG_USE_CHANNEL, name->second);
  }
  return section;
}

// Whether byte code's numbers hold what the program has.
bool fits(const Program& source, const Layout& layout, Diagnostics& diagnostics) {
  const auto limit = static_cast<int>(RUNG_NUMBERS);
  if (layout.bits() > limit || layout.words() > limit) {
    diagnostics.error(
        source.file, {},
        fmt::format("{} bit and {} word devices, where byte code numbers {} of each at most",
                    layout.bits(), layout.words(), limit),
        "name fewer devices, or shorter ranges and index windows");
    return false;
  }
  if (source.ldmicro && source.ldmicro->cycle_us >= static_cast<std::int64_t>(RUNG_TIMES)) {
    diagnostics.error(source.file, source.ldmicro->cycle_position,
                      fmt::format("a cycle of {} us, where byte code has {} at most",
                                  source.ldmicro->cycle_us, RUNG_TIMES - 1),
                      "choose a shorter cycle");
    return false;
  }
  return true;
}

}  // namespace

std::optional<std::string> write(const Program& source, const core::Program& program,
                                 const Options& options, Diagnostics& diagnostics) {
  const Layout layout(source, program);
  if (!fits(source, layout, diagnostics)) return std::nullopt;
  const StackPlan plan = plan_stacks(program);
  const std::string code = encode(program, layout, plan);
  Section ticks = ticks_of(program, layout);
  Section driven = driven_of(source, layout);
  Section ports = ports_of(layout);
  Section names = options.names ? names_of(source, layout) : Section{};

  Bytes file;
  file.add(RUNG_FORMAT_MAGIC);
  file.put(RUNG_FORMAT_MAJOR, 1);
  file.put(RUNG_FORMAT_MINOR, 1);
  file.put(static_cast<std::uint64_t>(source.dialect), 1);
  file.put(0, 1);
  file.put(0, 4);  // the size, below
  file.put(source.ldmicro ? checked_time(source.ldmicro->cycle_us) : 0, 4);
  file.put(code.size(), 4);
  for (const int count : {layout.bits(), layout.words(), layout.first_constant(), ticks.count,
                          driven.count, ports.count, names.count, plan.blocks, plan.branches}) {
    file.put(static_cast<std::uint64_t>(count), 2);
  }
  for (const std::int16_t constant : layout.constants()) {
    file.put(static_cast<std::uint16_t>(constant), RUNG_CONSTANT_BYTES);
  }
  for (Section* section : {&ticks, &driven, &ports}) file.add(section->bytes.take());
  file.add(code);
  file.add(names.bytes.take());
  file.set(RUNG_AT_SIZE, file.size() + RUNG_CRC_BYTES, 4);
  file.put(file.crc(), RUNG_CRC_BYTES);
  return file.take();
}

}  // namespace rung::bytecode

// SPDX-License-Identifier: Apache-2.0
#include "bytecode/vm_engine.hpp"

#include <stdexcept>

#include "bytecode/writer.hpp"
#include "lower/lower.hpp"
#include "rungs/footprint.hpp"
#include "rungs/ports.hpp"

namespace rung::tb {
namespace {

// What rung_ports.h calls them.
rung_vm_device port_of(const rung_vm& vm, Device port, bool& used) {
  rung_vm_device device = {};
  const auto space = static_cast<std::uint8_t>(is_word(port) ? RUNG_SPACE_WORD : RUNG_SPACE_BIT);
  used = rung_vm_port(&vm, space, static_cast<std::uint8_t>(port.number), &device) != 0;
  return device;
}

const std::uint8_t* bytes_of(const std::string& file) {
  return reinterpret_cast<const std::uint8_t*>(file.data());
}

}  // namespace

std::string bytecode_of(const Program& program, bool names) {
  Diagnostics diagnostics;
  auto file = bytecode::write(program, lower::lower(program), {names}, diagnostics);
  if (!file) throw std::runtime_error(diagnostics.all().front().what);
  return std::move(*file);
}

VmEngine::VmEngine(const Program& program, std::int64_t tick_us)
    : file_(bytecode_of(program)), tick_us_(static_cast<std::uint32_t>(tick_us)) {
  rung_vm_memory memory = {};
  rung_vm_error error = rung_vm_needs(bytes_of(file_), file_.size(), &memory);
  if (error == RUNG_VM_OK) {
    times_.resize(memory.times_count);
    words_.resize(memory.words_count);
    bits_.resize(memory.bits_count);
    memory.times = times_.data();
    memory.words = words_.data();
    memory.bits = bits_.data();
    error = rung_vm_load(&vm_, bytes_of(file_), file_.size(), &memory);
  }
  if (error != RUNG_VM_OK) {
    throw std::runtime_error("byte code refused: " + std::string(rung_vm_error_text(error)));
  }
  for (const Device device : visible_devices(program)) {
    if (is_hidden(device.kind)) continue;
    rung_vm_device place = {};
    const std::string name = device_name(device, program);
    if (rung_vm_find(&vm_, name.c_str(), &place) == 0) {
      throw std::runtime_error("byte code without the device " + name);
    }
    places_[device] = place;
  }
}

void VmEngine::apply(std::span<const StimulusEvent> events) {
  for (const StimulusEvent& event : events) {
    if (is_port(event.device.kind)) {
      bool used = false;
      const rung_vm_device place = port_of(vm_, event.device, used);
      if (used) rung_vm_set_value(&vm_, place, event.value);
      if (event.device != port::uart_rx_data) continue;
      const rung_vm_device full = port_of(vm_, port::uart_rx_full, used);
      if (used) rung_vm_set_value(&vm_, full, 1);
      continue;
    }
    const auto place = places_.find(event.device);
    if (place != places_.end()) rung_vm_set_value(&vm_, place->second, event.value);
  }
}

void VmEngine::scan() {
  sent_.clear();
  if (busy_ > 0) --busy_;
  bool used = false;
  const rung_vm_device ready = port_of(vm_, port::uart_tx_ready, used);
  if (used) rung_vm_set_value(&vm_, ready, busy_ == 0 ? 1 : 0);
  rung_vm_scan(&vm_, tick_us_);
  if (!used || busy_ > 0 || rung_vm_value(&vm_, ready) != 0) return;
  sent_.push_back(value(port::uart_tx_data) & 0xFF);
  busy_ = 2;
}

std::int16_t VmEngine::value(Device device) const {
  if (is_port(device.kind)) {
    bool used = false;
    const rung_vm_device place = port_of(vm_, device, used);
    return used ? rung_vm_value(&vm_, place) : std::int16_t{0};
  }
  const auto place = places_.find(device);
  return place == places_.end() ? std::int16_t{0} : rung_vm_value(&vm_, place->second);
}

}  // namespace rung::tb

// SPDX-License-Identifier: Apache-2.0
#include "lockstep/peripherals.hpp"

#include "rungs/ports.hpp"

namespace rung::tb {

PortPlaces port_places(const image::Image& image) {
  PortPlaces places;
  if (image.wide) {
    for (const image::WidePort& port : image.wide->ports) places[port.device] = port.address;
    return places;
  }
  // From the end of each memory downwards.
  const isa::Config& config = *isa::find_config(image.config);
  const auto add = [&](DeviceKind kind, int count, int devices) {
    for (int i = 0; i < count; ++i) {
      places[{kind, static_cast<std::uint32_t>(i)}] = devices - 1 - i;
    }
  };
  add(DeviceKind::PB, image.port_bits, config.bit_devices);
  add(DeviceKind::PW, image.port_words, config.word_devices);
  return places;
}

void Peripherals::write(Device port, std::int16_t value) {
  const auto place = places_.find(port);
  if (place == places_.end()) return;
  if (is_word(port)) {
    memory_.write_word(place->second, static_cast<std::uint16_t>(value));
  } else {
    memory_.write_bit(place->second, value != 0);
  }
}

std::int16_t Peripherals::value(Device port) {
  const auto place = places_.find(port);
  if (place == places_.end()) return 0;
  if (is_word(port)) return static_cast<std::int16_t>(memory_.read_word(place->second));
  return memory_.read_bit(place->second) ? 1 : 0;
}

void Peripherals::set(Device port, std::int16_t value) {
  write(port, value);
  if (port == port::uart_rx_data) write(port::uart_rx_full, 1);
}

void Peripherals::begin_scan() {
  sent_.clear();
  if (busy_ > 0) --busy_;
  write(port::uart_tx_ready, busy_ == 0 ? 1 : 0);
}

void Peripherals::end_scan() {
  if (busy_ > 0 || !has(port::uart_tx_ready) || value(port::uart_tx_ready) != 0) return;
  sent_.push_back(value(port::uart_tx_data) & 0xFF);
  busy_ = 2;
}

void Peripherals::clear() {
  for (const auto& [port, place] : places_) write(port, 0);
}

}  // namespace rung::tb

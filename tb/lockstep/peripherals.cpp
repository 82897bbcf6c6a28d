// SPDX-License-Identifier: Apache-2.0
#include "lockstep/peripherals.hpp"

#include "rungs/ports.hpp"

namespace rung::tb {

bool Peripherals::has(Device port) const {
  const int used = is_word(port) ? image_.port_words : image_.port_bits;
  return static_cast<int>(port.number) < used;
}

int Peripherals::address(Device port) const {
  const isa::Config& config = processor_.config();
  const int devices = is_word(port) ? config.word_devices : config.bit_devices;
  return devices - 1 - static_cast<int>(port.number);
}

void Peripherals::write(Device port, std::int16_t value) {
  if (!has(port)) return;
  if (is_word(port)) {
    processor_.write_word(address(port), static_cast<std::uint16_t>(value));
  } else {
    processor_.write_bit(address(port), value != 0);
  }
}

std::int16_t Peripherals::value(Device port) {
  if (!has(port)) return 0;
  if (is_word(port)) return static_cast<std::int16_t>(processor_.read_word(address(port)));
  return processor_.read_bit(address(port)) ? 1 : 0;
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
  for (int i = 0; i < image_.port_bits; ++i) {
    write({DeviceKind::PB, static_cast<std::uint32_t>(i)}, 0);
  }
  for (int i = 0; i < image_.port_words; ++i) {
    write({DeviceKind::PW, static_cast<std::uint32_t>(i)}, 0);
  }
}

}  // namespace rung::tb

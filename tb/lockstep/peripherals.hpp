// SPDX-License-Identifier: Apache-2.0
// The peripherals of LDmicro's simulator behind the device ports of a processor: the transmitter is
// busy in the scan of a byte and in the next one, a byte that nobody takes waits, and the lasting
// memory is never ready unless a test makes it so.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "harness/processor.hpp"
#include "image/image.hpp"

namespace rung::tb {

// The device ports that a program has, and where its processor keeps them.
using PortPlaces = std::map<Device, int>;
PortPlaces port_places(const image::Image& image);

class Peripherals {
 public:
  // `memory` must outlive this. A program without ports costs nothing.
  Peripherals(PortPlaces places, DeviceMemory& memory)
      : places_(std::move(places)), memory_(memory) {}

  // Gives a port a value before a scan, if the program has it: a sample, or something for the
  // lasting memory; a value for port::uart_rx_data is a byte that arrives.
  void set(Device port, std::int16_t value);
  // To be called just before and just after each scan.
  void begin_scan();
  void end_scan();

  // The bytes that the program has sent in the scan that ran last.
  const std::vector<int>& sent() const { return sent_; }
  // A port as it stands in the processor.
  std::int16_t value(Device port);
  bool has(Device port) const { return places_.contains(port); }
  // Sets all ports back to 0.
  void clear();

 private:
  void write(Device port, std::int16_t value);

  PortPlaces places_;
  DeviceMemory& memory_;
  int busy_ = 0;  // scans until the transmitter takes a byte again
  std::vector<int> sent_;
};

}  // namespace rung::tb

// SPDX-License-Identifier: Apache-2.0
// The peripherals of LDmicro's simulator behind the device ports of a processor: the transmitter is
// busy in the scan of a byte and in the next one, a byte that nobody takes waits, and the lasting
// memory is never ready unless a test makes it so.
#pragma once

#include <cstdint>
#include <vector>

#include "harness/processor.hpp"
#include "image/image.hpp"

namespace rung::tb {

class Peripherals {
 public:
  // Both must outlive this. A program without ports costs nothing.
  Peripherals(const image::Image& image, Processor& processor)
      : image_(image), processor_(processor) {}

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
  bool has(Device port) const;
  // Sets all ports back to 0.
  void clear();

 private:
  int address(Device port) const;
  void write(Device port, std::int16_t value);

  const image::Image& image_;
  Processor& processor_;
  int busy_ = 0;  // scans until the transmitter takes a byte again
  std::vector<int> sent_;
};

}  // namespace rung::tb

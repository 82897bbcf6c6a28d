// SPDX-License-Identifier: Apache-2.0
// A machine with a serial line, in simulated time: what `rung device` puts behind a
// pseudo-terminal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rung::device {

class SerialMachine {
 public:
  virtual ~SerialMachine() = default;
  virtual void run(std::uint64_t clocks) = 0;
  // Clocks since the start.
  virtual std::uint64_t now() const = 0;
  virtual std::uint64_t clocks_per_ms() const = 0;
  // A byte for the machine, behind those that are still on their way to it.
  virtual void send(std::uint8_t byte) = 0;
  // Bytes that are not yet wholly on the line.
  virtual std::size_t sending() const = 0;
  // What the machine has sent since the last call.
  virtual std::vector<std::uint8_t> receive() = 0;
  // Clocks of a character on the line, start and stop bits included.
  virtual std::uint64_t character_clocks() const = 0;
};

}  // namespace rung::device

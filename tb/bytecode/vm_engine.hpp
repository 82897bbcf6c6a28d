// SPDX-License-Identifier: Apache-2.0
// The byte code's interpreter as an engine for tests: a program is lowered, written as byte code,
// loaded and run, with the peripherals of LDmicro's simulator behind its device ports (the
// transmitter is busy in the scan of a byte and in the next one, a byte that nobody takes waits,
// and the lasting memory is never ready unless a test makes it so).
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "bytecode/interpreter/rung_vm.h"
#include "rungs/program.hpp"
#include "trace/stimulus.hpp"

namespace rung::tb {

class VmEngine {
 public:
  // Throws std::runtime_error if the interpreter refuses what was written, or the program has more
  // devices than byte code can number. `tick_us` is the time from scan to scan.
  explicit VmEngine(const Program& program, std::int64_t tick_us = 10000);
  VmEngine(const VmEngine&) = delete;
  VmEngine& operator=(const VmEngine&) = delete;

  // Gives devices their values before a scan; a value for port::uart_rx_data is a byte that
  // arrives. Devices that the program does not have are ignored.
  void apply(std::span<const StimulusEvent> events);
  void scan();

  // A device that the program shows, or one of its ports; 0 for any other.
  std::int16_t value(Device device) const;
  // Of the scan that ran last: the bytes sent, and whether it has divided by zero.
  const std::vector<int>& sent() const { return sent_; }
  bool error() const { return vm_.error != 0; }

  const std::string& file() const { return file_; }
  const rung_vm& vm() const { return vm_; }

 private:
  std::map<Device, rung_vm_device> places_;
  std::string file_;
  std::vector<std::uint32_t> times_;
  std::vector<std::uint16_t> words_;
  std::vector<std::uint8_t> bits_;
  rung_vm vm_ = {};
  std::uint32_t tick_us_;
  int busy_ = 0;  // scans until the transmitter takes a byte again
  std::vector<int> sent_;
};

// `program` as a byte code file; throws std::runtime_error if it cannot be one.
std::string bytecode_of(const Program& program, bool names = true);

}  // namespace rung::tb

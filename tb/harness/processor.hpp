// SPDX-License-Identifier: Apache-2.0
// One of the three processors as RTL under Verilator, with the sizes of a configuration: load a
// program, write and read devices, run scans and see what every instruction did.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "isa/isa.hpp"

namespace rung::tb {

// What one slot's instruction did, taken from the retire port in the clock in which it completes.
struct Retired {
  std::uint32_t step = 0;
  std::uint8_t slot = 0;
  bool exc = false;  // the slot's accumulator after the instruction
  bool bit_we = false;
  std::uint16_t bit_address = 0;
  bool bit_value = false;
  bool word_we = false;
  std::uint16_t word_address = 0;
  std::uint16_t word_value = 0;
};

struct ScanResult {
  std::uint32_t clocks = 0;   // from the edge that samples start to the first that samples done
  std::uint32_t counted = 0;  // the processor's own counter
  bool error = false;         // a division by 0 was executed
};

// Called for each retired instruction, in order of steps, slot 0 first; may be empty.
using RetireObserver = std::function<void(const Retired&)>;

// The devices of a processor, by their addresses, between two scans.
class DeviceMemory {
 public:
  virtual ~DeviceMemory() = default;
  virtual void write_bit(int address, bool value) = 0;
  virtual void write_word(int address, std::uint16_t value) = 0;
  virtual bool read_bit(int address) = 0;
  virtual std::uint16_t read_word(int address) = 0;
};

class Processor : public DeviceMemory {
 public:
  // Processor and configuration that this is.
  virtual isa::Mpu mpu() const = 0;
  virtual const isa::Config& config() const = 0;

  // Resets all state but the memories; the program stays loaded.
  virtual void reset() = 0;
  // Loads the program: per step one encoded word a slot, slot 0 first. Throws std::invalid_argument
  // if it is longer than the instruction memory or a step has another number of slots.
  virtual void load_program(std::span<const std::vector<std::uint64_t>> steps) = 0;
  // Loads one row of all slots' LUTs: bit {a,b,c} of `function`, `a` the highest. No effect on
  // MPU1.
  virtual void load_lut(int row, std::uint8_t function) = 0;

  // Of DeviceMemory: a write takes one clock; addresses are below the configuration's number of
  // devices.

  // Writes 0 to every device; make_processor() has done it once.
  virtual void clear_devices() = 0;

  // One scan of the loaded program. Throws std::runtime_error if it does not end in time, or if the
  // write port does not show, two clocks later, each word that retires and nothing else.
  virtual ScanResult run_scan(const RetireObserver& on_retire) = 0;
  // The same of steps `entry` to `end` - 1 alone.
  virtual ScanResult run_range(std::uint16_t entry, std::uint16_t end,
                               const RetireObserver& on_retire) = 0;
  // From now on or no longer, the load port's inputs change in every clock of a scan: accesses,
  // which a processor ignores while it is busy. The scan throws std::runtime_error if a read is
  // answered.
  virtual void disturb_load_port(bool on) = 0;
};

// A processor after reset, with all devices 0 and an empty program.
std::unique_ptr<Processor> make_processor(isa::Mpu mpu, const isa::Config& config);

// The configurations whose processors differ: another clock alone makes none of its own.
std::vector<const isa::Config*> distinct_configs();

}  // namespace rung::tb

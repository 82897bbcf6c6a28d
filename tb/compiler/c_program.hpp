// SPDX-License-Identifier: Apache-2.0
// Programs as C, compiled by the C compiler and loaded, beside the reference.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "programs/random_source.hpp"
#include "rungs/program.hpp"

namespace rung {

// Several programs in one translation unit.
class CPrograms {
 public:
  // Translates and compiles, every warning an error; undefined behaviour traps. A failure to
  // compile is a failure of the test, with the compiler's messages.
  explicit CPrograms(std::span<const Program> programs);
  ~CPrograms();
  CPrograms(const CPrograms&) = delete;
  CPrograms& operator=(const CPrograms&) = delete;

  bool good() const { return library_ != nullptr; }
  void reset(std::size_t program) const;
  void cycle(std::size_t program) const;
  void elapsed(std::size_t program, std::uint32_t microseconds) const;
  bool error(std::size_t program) const;
  // By name.
  long get(std::size_t program, const std::string& device) const;
  // Whether there is such a device.
  bool set(std::size_t program, const std::string& device, long value) const;
  // By number.
  std::int16_t read(std::size_t program, Device device) const;
  void write(std::size_t program, Device device, std::int16_t value) const;

 private:
  void* symbol(std::size_t program, const std::string& name) const;

  void* library_ = nullptr;
};

// What LDmicro's simulator has around a program: the transmitter is busy in the scan of a byte and
// in the next one; a byte that nobody takes waits, and a newer one replaces it; the lasting memory
// is not ready.
class CPeripherals {
 public:
  CPeripherals(const CPrograms& c, std::size_t program) : c_(c), program_(program) {}

  // For the next scan.
  void receive(int byte) const;
  void sample(int channel, int value) const;
  // One scan; gives the bytes that were sent in it.
  std::vector<int> cycle();

 private:
  void set(Device port, long value) const;

  const CPrograms& c_;
  std::size_t program_;
  bool busy_ = false;
};

// Runs `scans` scans of `program` as C and on the reference, with random inputs and at times a
// random preset, and expects every named device and the error flag to be equal after each.
void expect_c_equals_reference(const Program& program, int scans, RandomSource& random,
                               std::uint32_t tick_us = 10000);
// The same of several programs, which are compiled already.
void expect_c_equals_reference(const CPrograms& c, std::span<const Program> programs, int scans,
                               RandomSource& random, std::uint32_t tick_us = 10000);

}  // namespace rung

// SPDX-License-Identifier: Apache-2.0
// The Verilated batch: all its programs, scan after scan.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "hardwired/batch.hpp"

namespace rung::tb {

// A Verilated model (model.hpp), whatever Verilator has called it.
class BatchModel {
 public:
  virtual ~BatchModel() = default;
  // Ports as arrays of 32 bits.
  std::uint32_t* start = nullptr;
  std::uint32_t* state_load = nullptr;
  std::uint32_t* in = nullptr;
  std::uint32_t* clocks = nullptr;
  std::uint32_t* ticks = nullptr;
  std::uint32_t* state_in = nullptr;
  const std::uint32_t* busy = nullptr;
  const std::uint32_t* done = nullptr;
  const std::uint32_t* error = nullptr;
  const std::uint32_t* out = nullptr;
  const std::uint32_t* state = nullptr;
  virtual void clock(bool reset) = 0;
};

class Bench {
 public:
  Bench(const Batch& batch, std::unique_ptr<BatchModel> model);

  // Between two scans: an input, or any other device through the state port. What the program does
  // not have, or is driven, is left alone.
  void set(std::size_t program, Device device, std::int16_t value);
  // Clock relays and ticks of this scan.
  void drive(std::size_t program, Dialect dialect, ScanTime time);
  // A scan of those programs; gives the clocks that each took, 0 of the others. Throws
  // std::runtime_error if one does not end, or its outputs change before the end.
  std::vector<int> scan(const std::vector<bool>& programs);
  std::int16_t get(std::size_t program, Device device) const;
  bool output(std::size_t program, std::size_t which) const;
  bool error(std::size_t program) const;

 private:
  void load();

  const Batch& batch_;
  std::unique_ptr<BatchModel> model_;
  bool to_load_ = false;
};

}  // namespace rung::tb

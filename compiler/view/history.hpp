// SPDX-License-Identifier: Apache-2.0
// What the devices' values were in the last scans: for timing diagrams, and as VCD and CSV.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "view/program_view.hpp"

namespace rung::view {

class History {
 public:
  explicit History(std::size_t devices = 0) : changes_(devices) {}

  struct Change {
    std::int64_t scan = 0;
    std::int16_t value = 0;
  };

  // A device's value after a scan; scans in ascending order, all is 0 before the first one.
  void add(std::int64_t scan, int device, std::int16_t value);
  void end_scan(std::int64_t scan);

  std::int64_t first() const { return first_; }
  std::int64_t last() const { return last_; }  // -1: nothing has run
  // Of one device: its value in scan `from` or the first one that is kept, then where it changes.
  std::vector<Change> of(int device, std::int64_t from = 0) const;

 private:
  std::vector<std::deque<Change>> changes_;  // by device; the first one may be older than first()
  std::int64_t first_ = 0, last_ = -1;
};

// The chosen devices as a value change dump, its unit the scan's period, and as one row a scan.
std::string to_vcd(const History& history, const ProgramView& view, const std::vector<int>& devices,
                   std::int64_t tick_us);
std::string to_csv(const History& history, const ProgramView& view, const std::vector<int>& devices,
                   std::int64_t tick_us);

}  // namespace rung::view

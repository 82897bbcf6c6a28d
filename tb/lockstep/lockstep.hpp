// SPDX-License-Identifier: Apache-2.0
// A processor beside the reference, scan by scan, stopped at the first difference.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "lockstep/any_machine.hpp"
#include "reference/reference.hpp"

namespace rung::tb {

// The first place where processor and reference differ.
struct Difference {
  std::int64_t scan = 0;
  std::string where;   // step, slot, instruction and source line on the processor, if there is one
  std::string source;  // source line that the reference executed, if there is one
  std::string what;    // "write of M0", "clocks", ...
  std::string expected;  // as the reference has it
  std::string got;
};
// Several lines, as `run` and the tests show it.
std::string describe(const Difference& difference);

class Lockstep {
 public:
  // `program` is what `machine` was compiled from. Both must outlive this.
  Lockstep(const Program& program, AnyMachine& machine);

  // Gives both the same events, runs one scan on both and compares: for each device the sequence of
  // the values that it gets, on MPU1 also the order of the source instructions that change
  // something; outputs, the error flag, bytes sent, and the clocks with those that the compiler has
  // counted. Where not every write is made (MPU4 with merging), in place of the sequences every
  // device's value after the scan.
  std::optional<Difference> scan(std::span<const StimulusEvent> events);
  // Compares every device that the program names, and the device ports.
  std::optional<Difference> compare_state();

  const Reference& reference() const { return reference_; }
  // As Reference::watch.
  void watch(std::vector<Conduction>& seen) { reference_.watch(seen); }
  // Of the scan that ran last.
  const ScanResult& result() const { return result_; }

 private:
  struct Change {
    int device = 0;  // index into Image::devices
    std::int16_t value = 0;
    const ReferenceWrite* expected = nullptr;  // the write that it is, on either side
    const MachineWrite* got = nullptr;
  };

  // Writes that change a value, of the reference and of the processor.
  std::vector<Change> expected_changes();
  std::vector<Change> got_changes();
  std::optional<Difference> compare_writes();
  std::optional<Difference> compare_by_device(const std::vector<Change>& expected,
                                              const std::vector<Change>& got);
  std::optional<Difference> compare_order(const std::vector<Change>& expected,
                                          const std::vector<Change>& got);
  std::optional<Difference> compare_write(const ReferenceWrite* expected, const MachineWrite* got);
  std::optional<Difference> compare_devices(bool outputs_only);
  std::optional<Difference> compare_ports();
  std::string source_of(std::size_t instruction) const;

  const Program& program_;
  AnyMachine& machine_;
  Reference reference_;
  std::vector<Device> devices_;               // of Image::devices
  std::vector<std::int16_t> expected_, got_;  // their values
  ScanResult result_;
  std::int64_t scan_ = -1;
};

}  // namespace rung::tb

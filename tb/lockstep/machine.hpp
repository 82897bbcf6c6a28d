// SPDX-License-Identifier: Apache-2.0
// A processor that runs an image: devices by name instead of by address.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "harness/processor.hpp"
#include "image/image.hpp"
#include "lockstep/peripherals.hpp"
#include "rungs/special.hpp"
#include "trace/recorder.hpp"
#include "trace/stimulus.hpp"

namespace rung::tb {

// One executed write of a device that the program names.
struct MachineWrite {
  int device = 0;  // index into Image::devices
  std::int16_t value = 0;
  std::uint32_t step = 0;
  std::uint8_t slot = 0;
};

class Machine {
 public:
  // Loads `image` into `processor`, which is its processor in its configuration; all devices are 0.
  // `tick_us` is the time from scan to scan; an LDmicro program has its own. Both must outlive
  // this.
  Machine(const image::Image& image, Processor& processor, std::int64_t tick_us = 10000);
  // Sets what it has used back to 0, so that the processor is as new for the next machine.
  ~Machine();
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  // Gives devices their values before a scan; devices that the image does not have are ignored.
  void apply(std::span<const StimulusEvent> events);
  // One scan, with its ticks, clocks and first-scan relays; `writes()` holds what it wrote, in the
  // order of steps and in a step by slot, without those of lowered instructions that left a value
  // as it was.
  ScanResult run_scan();

  const std::vector<MachineWrite>& writes() const { return writes_; }
  // The bytes that the program sent in that scan.
  const std::vector<int>& sent() const { return peripherals_.sent(); }
  // Also shows `observer` every retired instruction of the scans to come.
  void observe(RetireObserver observer) { observer_ = std::move(observer); }
  // Reads a device, by its index in Image::devices, back from the processor.
  std::int16_t value(std::size_t device);
  // The same as what it was given and what has retired since leave it: without asking the
  // processor.
  std::int16_t known_value(std::size_t device) const { return values_[device]; }
  // Index of the device, or -1.
  int find(Device device) const;
  // The device ports, as the program has left them.
  Peripherals& peripherals() { return peripherals_; }

  const image::Image& image() const { return image_; }
  std::int64_t tick_us() const { return time_.tick_us; }
  // "step 3, slot 1: LUTO ... (line 4: OUT Y0)"
  std::string describe(std::uint32_t step, std::uint8_t slot) const;

 private:
  // A device that the controller drives.
  struct Driven {
    int device;  // index into Image::devices
    const SpecialRange* special;
  };

  void set(int device, std::int16_t value);
  void drive();
  void retire(const Retired& retired);

  const image::Image& image_;
  Processor& processor_;
  Peripherals peripherals_;
  std::vector<int> bit_devices_;  // address -> index into Image::devices, or -1
  std::vector<int> word_devices_;
  std::map<Device, int> by_device_;
  std::vector<std::int16_t> values_;  // of Image::devices, as the writes so far leave them
  std::vector<Driven> driven_;
  std::vector<std::int16_t> ticks_;  // as they stand in the processor
  ScanTime time_;
  std::vector<MachineWrite> writes_;
  RetireObserver observer_;
};

// What the devices of an image are called.
DeviceNames names_of(const image::Image& image);

// A machine as an engine that gives a trace.
class MachineRun {
 public:
  MachineRun(Machine& machine, bool with_state);

  TraceHeader header() const;
  // Applies the events, runs one scan and gives what happened in it, the clocks too.
  TraceScan scan(std::span<const StimulusEvent> events);
  // The same for a scan that has already run.
  TraceScan record(std::span<const StimulusEvent> events, const ScanResult& result);

 private:
  Machine& machine_;
  DeviceNames names_;
  bool with_state_;
  TraceRecorder recorder_;
};

}  // namespace rung::tb

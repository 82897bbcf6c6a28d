// SPDX-License-Identifier: Apache-2.0
// A processor that runs an image, whichever of the four it is: devices by name instead of by
// address, and what the controller gives a program before each scan.
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
  std::uint8_t slot = 0;  // of a word on MPU4: its unit
};

class AnyMachine {
 public:
  virtual ~AnyMachine() = default;
  AnyMachine(const AnyMachine&) = delete;
  AnyMachine& operator=(const AnyMachine&) = delete;

  // Gives devices their values before a scan; devices that the image does not have are ignored.
  void apply(std::span<const StimulusEvent> events);
  // One scan, with its ticks, clocks and first-scan relays; `writes()` holds what it wrote, in the
  // order of steps and in a step by slot (on MPU4 by device), without those of lowered instructions
  // that left a value as it was.
  ScanResult run_scan();

  const std::vector<MachineWrite>& writes() const { return writes_; }
  // Each of a device's writes is among them: not so if the program was compiled with merging.
  bool every_write() const { return !image_.wide || !image_.wide->merged; }
  // The bytes that the program sent in that scan.
  const std::vector<int>& sent() const { return peripherals_.sent(); }
  // Reads a device, by its index in Image::devices, back from the processor.
  virtual std::int16_t value(std::size_t device);
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
  virtual std::string describe(const MachineWrite& write) const = 0;

 protected:
  // `tick_us` is the time from scan to scan; an LDmicro program has its own. Both must outlive
  // this.
  AnyMachine(const image::Image& image, DeviceMemory& memory, std::int64_t tick_us);

  // One scan of the processor; every write of it is reported with add().
  virtual ScanResult execute() = 0;
  // `quiet`: writing the value that is there already is no write. A device of -1 has no name.
  void add(const MachineWrite& write, bool quiet);
  // Gives a device of the image a value before a scan.
  virtual void put(int device, std::int16_t value);
  // " (line 4: OUT Y0)", or nothing if `origin` is -1
  std::string source_of(int origin) const;

  const image::Image& image_;
  DeviceMemory& memory_;
  Peripherals peripherals_;

 private:
  // A device that the controller drives.
  struct Driven {
    int device;  // index into Image::devices
    const SpecialRange* special;
  };

  void set(int device, std::int16_t value);
  void drive();

  std::map<Device, int> by_device_;
  std::vector<std::int16_t> values_;  // of Image::devices, as the writes so far leave them
  std::vector<Driven> driven_;
  std::vector<std::int16_t> ticks_;  // as they stand in the processor
  ScanTime time_;
  std::vector<MachineWrite> writes_;
};

// What the devices of an image are called.
DeviceNames names_of(const image::Image& image);

// A machine as an engine that gives a trace.
class MachineRun {
 public:
  MachineRun(AnyMachine& machine, bool with_state);

  TraceHeader header() const;
  // Applies the events, runs one scan and gives what happened in it, the clocks too.
  TraceScan scan(std::span<const StimulusEvent> events);
  // The same for a scan that has already run.
  TraceScan record(std::span<const StimulusEvent> events, const ScanResult& result);

 private:
  AnyMachine& machine_;
  DeviceNames names_;
  bool with_state_;
  TraceRecorder recorder_;
};

// The RTL of an image's processor with the image on it.
struct LoadedMachine {
  std::unique_ptr<DeviceMemory> processor;
  std::unique_ptr<AnyMachine> machine;
};
// `image` must outlive it.
LoadedMachine load_machine(const image::Image& image, std::int64_t tick_us = 10000);

}  // namespace rung::tb

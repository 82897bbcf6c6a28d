// SPDX-License-Identifier: Apache-2.0
// What an I/O map is checked against: the devices and needs of a program, from its source or its
// image.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rungs/program.hpp"

namespace rung::io {

struct SubjectDevice {
  Device device;
  std::string name;     // as traces write it
  std::string comment;  // the name that a comment file gives it
};

struct Subject {
  std::string file;
  Dialect dialect = Dialect::Fx;
  std::string config;
  int mpu = 0;  // 0: none, the reference
  // Those that the program names, by kind and number, and its analogue channels (device ports with
  // the names of their variables).
  std::vector<SubjectDevice> devices;
  std::int64_t cycle_us = 0;  // of an LDmicro program
  bool uart = false;          // it has UART instructions
  bool pwm = false;           // it has SET PWM
  bool flow = false;          // it has flow tasks
  // LDmicro: the pins that its IO LIST assigns, for a micro-controller of its own.
  bool own_pins = false;

  bool has(Device device) const;
  std::string name(Device device) const;
  // The device that a map or a command line means: a device's name in the dialect, or a name of the
  // program's. Nothing if it is neither; a device of a list need not be one of the program's.
  // `kinds` decides where a name stands for several: with `word` a timer or counter is its value.
  std::optional<Device> find(std::string_view name, bool word) const;
  // The analogue channel that is read into the variable of this name.
  std::optional<Device> find_channel(std::string_view name) const;
  // The name of a device, or comment, nearest to `name`; empty if none is near.
  std::string near(std::string_view name) const;
};

Subject subject_of(const Program& program, std::string_view config);

}  // namespace rung::io

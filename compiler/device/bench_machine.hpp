// SPDX-License-Identifier: Apache-2.0
// A machine with a serial line, pins and a power supply.
#pragma once

#include <cstdint>
#include <vector>

#include "device/serial_machine.hpp"

namespace rung::device {

// An output pin that changed; lamps are those of the controller itself.
struct PinChange {
  enum class Pin : std::uint8_t { Output, Run, Fault, Forced };
  std::uint64_t clock = 0;
  Pin pin = Pin::Output;
  int index = 0;
  bool level = false;
};

class BenchMachine : public SerialMachine {
 public:
  virtual void set_input(int pin, bool level) = 0;
  virtual void set_adc(int channel, int sample) = 0;
  virtual void set_run_switch(bool run) = 0;
  // Without power nothing runs, every output is low, and what is sent to it is lost.
  virtual void set_power(bool on) = 0;
  virtual bool powered() const = 0;
  virtual bool output(int pin) const = 0;
  virtual bool lamp(PinChange::Pin lamp) const = 0;
  // Since the last call, in their order.
  virtual std::vector<PinChange> changes() = 0;
};

}  // namespace rung::device

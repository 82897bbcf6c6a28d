// SPDX-License-Identifier: Apache-2.0
// `rung translate --to c`: a program as C.
#pragma once

#include <string>

#include "rungs/program.hpp"

namespace rung {

struct COptions {
  // What the names of the functions begin with; the names of all else begin with it in lower case.
  // With a prefix each, several programs can stand in one file.
  std::string prefix = "Plc";
  // Adds access by name: int PlcSet("D10", value), long PlcGet("D10").
  bool table = false;
  // An LDmicro program meets its inputs, outputs and peripherals through functions that its user
  // writes. Without them the caller does what a controller does to the devices and to the device
  // ports, which the table then has too (c_port_name).
  bool hooks = true;
  // For very many programs in one file, which a compiler then reads in half the time: functions are
  // static, there is no access but by the array PlcDevices (struct plc_device: name, bit or word; a
  // name of 0 ends it), and small functions that do the same in all programs stand there once. No
  // hooks.
  bool bare = false;
};

// One C99 file, freestanding (it includes stdint.h only), with
//   void PlcCycle(void);    one scan
//   void PlcReset(void);    all devices 0, the next scan is the first
//   uint8_t PlcError(void); 1 if the last cycle divided by zero
// and how else it is used in its head comment; compiler/backends/README.md has examples. A list has
//   void PlcElapsed(uint32_t microseconds);    the time from one scan to the next
//   PlcReadX/Y/M/D/..., PlcWriteX/Y/M/D/...    a device by its number: 8 for Y10 of an octal
//   dialect; to be called before and after PlcCycle
// An LDmicro program has PlcReadBit_NAME, PlcWriteWord_NAME, ..., and calls the functions
// PlcInput_NAME, PlcOutput_NAME, PlcUartSend, ... which its user writes.
// Each network begins with its source. Signed arithmetic is done so that no compiler finds
// undefined behaviour in it.
std::string write_c(const Program& program, const COptions& options);
std::string to_c(const Program& program);

// What tables call a device port, which no device is called: "%adc2".
std::string c_port_name(Device port);

}  // namespace rung

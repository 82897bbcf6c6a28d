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
  // For very many programs in one file, which a compiler then reads in half the time: functions are
  // static, there is no access but by the array PlcDevices (struct plc_device: name, bit or word; a
  // name of 0 ends it), and small functions that do the same in all programs stand there once.
  bool bare = false;
};

// One C99 file, freestanding (it includes stdint.h only), with
//   void PlcCycle(void);    one scan: inputs in, outputs as the program leaves them
//   void PlcReset(void);    all devices 0, the next scan is the first
//   void PlcElapsed(uint32_t microseconds);    the time from one scan to the next
//   PlcReadX/Y/M/D/..., PlcWriteX/Y/M/D/...    a device by its number: 8 for Y10 of an octal
//   dialect uint8_t PlcError(void); 1 if the last cycle divided by zero
// Each network begins with its source. Signed arithmetic is done so that no compiler finds
// undefined behaviour in it.
std::string write_c(const Program& program, const COptions& options);
std::string to_c(const Program& program);

}  // namespace rung

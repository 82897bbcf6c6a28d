// SPDX-License-Identifier: Apache-2.0
// `rung translate --to c`: a program as C.
#pragma once

#include <string>

#include "rungs/program.hpp"

namespace rung {

// One C99 file, freestanding (it includes stdint.h only), with
//   void PlcCycle(void);    one scan: inputs in, outputs as the program leaves them
//   void PlcReset(void);    all devices 0
//   PlcReadX/Y/M/D, PlcWriteX/Y/M/D    a device by its number: 8 for Y10 of an octal dialect
//   uint8_t PlcError(void); 1 if the last cycle divided by zero
// Each network is a block that begins with its source. Signed arithmetic is done so that no
// compiler finds undefined behaviour in it.
std::string to_c(const Program& program);

}  // namespace rung

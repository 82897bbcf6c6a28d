/* SPDX-License-Identifier: Apache-2.0
 * stairs.il on the board: inputs before the cycle, outputs after it. */
#include "board.h"
#include "program.c"

void board_scan(void) {
  uint8_t i;
  for (i = 0; i < 4; ++i) PlcWriteX(i, board_input(i));
  PlcElapsed(CYCLE_US);
  PlcCycle();
  for (i = 0; i < 5; ++i) board_output(i, PlcReadY(i));
}

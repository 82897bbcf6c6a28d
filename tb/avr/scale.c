/* SPDX-License-Identifier: Apache-2.0
 * scale.ld on the board: where its inputs and outputs are. */
#include "board.h"
#include "program.c"

uint8_t PlcInput_Xtare(void) { return board_input(0); }
uint8_t PlcInput_Xprint(void) { return board_input(1); }
void PlcOutput_Yheavy(uint8_t value) { board_output(0, value); }
void PlcOutput_Ybusy(uint8_t value) { board_output(1, value); }
void PlcOutput_Yzero(uint8_t value) { board_output(2, value); }
void PlcOutput_Ygot(uint8_t value) { board_output(3, value); }
void PlcOutput_Yodd(uint8_t value) { board_output(4, value); }
int16_t PlcAdc_Aload(void) { return board_sample(0); }

void board_scan(void) { PlcCycle(); }

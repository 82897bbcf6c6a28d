/* SPDX-License-Identifier: Apache-2.0
 * heater.ld on the board: where its inputs and outputs are. */
#include "board.h"
#include "program.c"

uint8_t PlcInput_Xmore(void) { return board_input(0); }
uint8_t PlcInput_Xless(void) { return board_input(1); }
uint8_t PlcInput_Xnight(void) { return board_input(2); }
void PlcOutput_Yheat(uint8_t value) { board_output(0, value); }
void PlcOutput_Ylow(uint8_t value) { board_output(1, value); }
void PlcOutput_Ys0(uint8_t value) { board_output(2, value); }
void PlcOutput_Ys3(uint8_t value) { board_output(3, value); }
int16_t PlcAdc_Aroom(void) { return board_sample(0); }

void board_scan(void) { PlcCycle(); }

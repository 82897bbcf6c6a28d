/* SPDX-License-Identifier: Apache-2.0
 * conveyor.ld on the board: where its inputs and outputs are. */
#include "board.h"
#include "program.c"

uint8_t PlcInput_Xstart(void) { return board_input(0); }
uint8_t PlcInput_Xstop(void) { return board_input(1); }
uint8_t PlcInput_Xpart(void) { return board_input(2); }
uint8_t PlcInput_Xhold(void) { return board_input(3); }
void PlcOutput_Yrun(uint8_t value) { board_output(0, value); }
void PlcOutput_Yfull(uint8_t value) { board_output(1, value); }
void PlcOutput_Yblink(uint8_t value) { board_output(2, value); }
void PlcOutput_Yjam(uint8_t value) { board_output(3, value); }
void PlcOutput_Ydone(uint8_t value) { board_output(4, value); }

void board_scan(void) { PlcCycle(); }

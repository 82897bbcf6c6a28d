/* SPDX-License-Identifier: Apache-2.0
 * An ATmega328P board for a program that Rung has translated to C: inputs 0 to 3 at PD4 to PD7,
 * outputs 0 to 4 at PB0 to PB2, PB4 and PB5, PWM at PB3 (OC2A), analogue inputs 0 to 3 at ADC0 to
 * ADC3, the UART, the EEPROM. PC5 is high during a scan. */
#ifndef BOARD_H
#define BOARD_H

#include <stdint.h>

/* Written by the file that goes with a program: one scan of it. */
void board_scan(void);

uint8_t board_input(uint8_t number);
void board_output(uint8_t number, uint8_t value);
/* 10 bits. */
int16_t board_sample(uint8_t number);

#endif

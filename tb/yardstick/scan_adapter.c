/* SPDX-License-Identifier: Apache-2.0
 * The same pseudo-random inputs and the same checksum for a translated program wherever it runs.
 * INPUTS, OUTPUTS, RELAYS and WORDS are the numbers of its X, Y, M and D. */
#include "scans.h"

void PlcWriteX(uint32_t number, uint8_t value);
uint8_t PlcReadY(uint32_t number);
uint8_t PlcReadM(uint32_t number);
int16_t PlcReadD(uint32_t number);

/* Marsaglia's xorshift32. */
static uint32_t next_random(void) {
  static uint32_t state = 2463534242u;
  state ^= state << 13;
  state ^= state >> 17;
  state ^= state << 5;
  return state;
}

void scan_set_inputs(void) {
  uint32_t bits = 0;
  for (uint32_t i = 0; i < INPUTS; ++i) {
    if (i % 32 == 0) bits = next_random();
    PlcWriteX(i, bits & 1u);
    bits >>= 1;
  }
}

uint32_t scan_checksum(uint32_t checksum) {
  for (uint32_t i = 0; i < OUTPUTS; ++i) checksum = checksum * 31u + PlcReadY(i);
  for (uint32_t i = 0; i < RELAYS; ++i) checksum = checksum * 31u + PlcReadM(i);
  for (uint32_t i = 0; i < WORDS; ++i) checksum = checksum * 31u + (uint16_t)PlcReadD(i);
  return checksum;
}

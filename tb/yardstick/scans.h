/* SPDX-License-Identifier: Apache-2.0
 * The adapter between a translated program and the yardsticks' two main programs; it is written for
 * each program. Both mains call it in the same order, so their checksums must be equal. */
#ifndef RUNG_SCANS_H
#define RUNG_SCANS_H

#include <stdint.h>

/* The translated program: one scan. */
void PlcCycle(void);

/* Give every input the next bit of a fixed pseudo-random sequence. */
void scan_set_inputs(void);

/* `checksum` continued by the state of every output. */
uint32_t scan_checksum(uint32_t checksum);

#endif

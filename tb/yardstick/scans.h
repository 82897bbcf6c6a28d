/* SPDX-License-Identifier: Apache-2.0
 * What the yardsticks' two main programs, of the soft cores and of the host, call. */
#ifndef RUNG_SCANS_H
#define RUNG_SCANS_H

#include <stdint.h>

/* The translated program: one scan. */
void PlcCycle(void);

/* Give every input the next bit of a fixed pseudo-random sequence. */
void scan_set_inputs(void);

/* `checksum` continued by the state of every output, relay and word. */
uint32_t scan_checksum(uint32_t checksum);

#endif

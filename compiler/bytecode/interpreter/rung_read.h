/* SPDX-License-Identifier: Apache-2.0 */
/* Reading a byte code file byte by byte; only the interpreter's own files include this.
 *
 * Where a file lies in a memory that needs an instruction of its own (flash of an AVR), define
 * RUNG_VM_READ(address) to that: -DRUNG_VM_READ=pgm_read_byte -include avr/pgmspace.h
 */
#ifndef RUNG_READ_H
#define RUNG_READ_H

#include <stdint.h>

#ifndef RUNG_VM_READ
#define RUNG_VM_READ(address) (*(address))
#endif

static uint8_t rung_read8(const uint8_t* at) { return RUNG_VM_READ(at); }

static uint16_t rung_read16(const uint8_t* at) {
  return (uint16_t)(rung_read8(at) | (uint16_t)rung_read8(at + 1) << 8);
}

#define rung_read32(at) (rung_read16(at) | (uint32_t)rung_read16((at) + 2) << 16)

#endif

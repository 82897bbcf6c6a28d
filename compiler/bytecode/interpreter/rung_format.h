/* SPDX-License-Identifier: Apache-2.0 */
/* The frame of a byte code file: where its fields are. Shared by the writer, which is C++, and the
 * interpreter, which is C. compiler/bytecode/README.md describes it. All numbers are little-endian.
 */
#ifndef RUNG_FORMAT_H
#define RUNG_FORMAT_H

/* The first four bytes. The last one keeps terminals and text converters from taking it for text.
 */
#define RUNG_FORMAT_MAGIC "RBC\x1A"

/* An interpreter runs files of its own major version and of a minor one that is not above its own.
 */
#define RUNG_FORMAT_MAJOR 1
#define RUNG_FORMAT_MINOR 0

/* Offsets of the header's fields; the number is the width in bytes. */
#define RUNG_AT_MAGIC 0           /* 4 */
#define RUNG_AT_MAJOR 4           /* 1 */
#define RUNG_AT_MINOR 5           /* 1 */
#define RUNG_AT_DIALECT 6         /* 1: 0 paper, 1 fx, 2 q, 3 ldmicro */
#define RUNG_AT_ZERO 7            /* 1: 0 */
#define RUNG_AT_SIZE 8            /* 4: of the file */
#define RUNG_AT_PERIOD 12         /* 4: microseconds from scan to scan; 0: the user decides */
#define RUNG_AT_CODE_SIZE 16      /* 4 */
#define RUNG_AT_BITS 20           /* 2: bit devices */
#define RUNG_AT_WORDS 22          /* 2: word devices, constants included */
#define RUNG_AT_FIRST_CONSTANT 24 /* 2: words from this one on are constants */
#define RUNG_AT_TICKS 26          /* 2: how many there are, of this and what follows */
#define RUNG_AT_DRIVEN 28         /* 2 */
#define RUNG_AT_PORTS 30          /* 2 */
#define RUNG_AT_NAMES 32          /* 2 */
#define RUNG_AT_BLOCKS 34         /* 2: greatest depth of the block stack */
#define RUNG_AT_BRANCHES 36       /* 2: greatest depth of the branch stack */
#define RUNG_HEADER_BYTES 38

/* Records of the sections, which follow the header in this order; then the code, the names and the
 * CRC-32 of all bytes before it. */
#define RUNG_CONSTANT_BYTES 2 /* value 2 */
#define RUNG_TICK_BYTES 6     /* word 2, base in microseconds 4 */
#define RUNG_DRIVEN_BYTES 7   /* bit 2, role 1, period in microseconds 4 */
#define RUNG_PORT_BYTES 4     /* space 1, port number 1, device 2 */
#define RUNG_NAME_BYTES 5     /* use 1, device 2, length 2; its characters follow */
#define RUNG_CRC_BYTES 4

/* Roles of driven bits. */
#define RUNG_ROLE_ON 0
#define RUNG_ROLE_OFF 1
#define RUNG_ROLE_FIRST_SCAN 2
#define RUNG_ROLE_NOT_FIRST_SCAN 3
#define RUNG_ROLE_CLOCK 4

/* Spaces of devices and ports. */
#define RUNG_SPACE_BIT 0
#define RUNG_SPACE_WORD 1

/* Use of a name: the space in bit 0, above it what the device is for. */
#define RUNG_USE_INNER 0
#define RUNG_USE_INPUT 1
#define RUNG_USE_OUTPUT 2
#define RUNG_USE_CHANNEL \
  3 /* an analogue channel; it has the name of the variable it is read into */

/* Device numbers and skips have 15 bits: below 128 one byte, else two, the high one first with its
 * top bit set. */
#define RUNG_NUMBERS 0x8000L

/* Tick bases, clock periods and the time between two scans are below this. */
#define RUNG_TIMES 0x80000000UL

#endif

/* SPDX-License-Identifier: Apache-2.0
 * Main program of a soft core used as a yardstick: runs scans between marks that the bench sees on
 * the bus. Freestanding, RV32IM.
 *
 * Marks: START (with the kind of what follows) and END around what is timed, CHECKSUM after all
 * cold and after all warm scans, FINISH at the end. */
#include <stdint.h>

#include "scans.h"

#define MARK(number) (*(volatile uint32_t*)(0x80000000u + 4u * (number)))
enum { kStart = 0, kEnd = 1, kChecksum = 2, kFinish = 3 };
enum { kEmpty = 0, kCold = 1, kWarm = 2 };

#ifndef COLD_SCANS
#define COLD_SCANS 100
#endif
#ifndef WARM_SCANS
#define WARM_SCANS 400
#endif

/* Empty the caches that the core has: the instruction cache by FENCE.I, VexRiscv's data cache,
 * which is write-through, by an instruction of its own. */
static void empty_caches(void) {
#ifdef DATA_CACHE
  __asm__ volatile(".word 0x0000500F" ::: "memory");
#endif
#ifdef INSTRUCTION_CACHE
  __asm__ volatile(".word 0x0000100F" ::: "memory");
#endif
}

static void scans(uint32_t kind, uint32_t count, uint32_t* checksum) {
  for (uint32_t i = 0; i < count; ++i) {
    scan_set_inputs();
    if (kind == kCold) empty_caches();
    MARK(kStart) = kind;
    PlcCycle();
    MARK(kEnd) = kind;
    *checksum = scan_checksum(*checksum);
  }
  MARK(kChecksum) = *checksum;
}

int main(void) {
  uint32_t checksum = 0;
  for (int i = 0; i < 3; ++i) { /* two marks one after the other: what the marks themselves cost */
    MARK(kStart) = kEmpty;
    MARK(kEnd) = kEmpty;
  }
  scans(kCold, COLD_SCANS, &checksum);
  scans(kWarm, WARM_SCANS, &checksum);
  MARK(kFinish) = 0;
  for (;;) {
  }
}

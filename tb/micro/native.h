/* SPDX-License-Identifier: Apache-2.0
   What the bus answers in these tests, in C for the native programs and in C++ for the sequencer's
   bench. */
#ifndef RUNG_TB_MICRO_NATIVE_H
#define RUNG_TB_MICRO_NATIVE_H

#include <stdint.h>

static inline uint32_t rung_mix(uint32_t x) {
  x = (x ^ (x >> 16)) * 0x7feb352dU;
  x = (x ^ (x >> 15)) * 0x846ca68bU;
  return x ^ (x >> 16);
}

/* The value of the read that is event number `event`: small ones often, so that compares meet equal
 * values. */
static inline uint16_t rung_bus_value(uint32_t seed, uint32_t event, uint16_t address) {
  const uint32_t x = rung_mix(rung_mix(seed + event) + address);
  switch (x >> 29) {
    case 0:
      return 0;
    case 1:
      return (uint16_t)(0U - (x & 3));
    case 2:
    case 3:
      return x & 15;
    default:
      return (uint16_t)x;
  }
}

#endif

// SPDX-License-Identifier: Apache-2.0
// Comparisons whose result nothing needs, right before a branch by a value: the branch must not go
// by them.
#include "common.h"

static u16 count;
static u16 least;

void firmware_reset(void) {}

void firmware_poll(void) {
  u16 left = 4;
  do {
    left = left - 1;
    count++;
    u16 unused = (u16)((u16)(-!left) << 8);
    unused = 3;
  } while (left);
  u16 value = io_read(IN);
  u16 never = value < 5;
  never = 1;
  if (value) {
    least++;
  }
  io_write(OUT, count);
  io_write(OUT, least);
}

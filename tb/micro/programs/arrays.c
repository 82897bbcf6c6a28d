// SPDX-License-Identifier: Apache-2.0
// Words of arrays: at constants, at variables, at what calls give; stores whose value needs an
// index itself.
#include "common.h"

static u16 a[16];
static u16 b[5];
static u16 k;
static u16 last[1];

static u16 step(void) {
  k = (k + 5) & 15;
  return k;
}

void firmware_reset(void) {
  for (k = 0; k < 16; k++) a[k] = a[k] + (k << 8) + k;
}

void firmware_poll(void) {
  u16 i;
  u16 x = io_read(IN);
  a[3] = x;
  a[x & 15] = a[(x >> 4) & 15] + a[3];
  a[step()] = x;
  a[x & 7] += 2;
  a[1]++;
  a[x & 1] ^= 0x8001;
  b[2] = a[a[x & 15] & 15];
  b[x & 3] = step();
  i = step();
  b[i & 3] = a[step()] - 1;
  last[0] = last[0] + b[4] + 1;
  b[4] = a[15];
  io_write(OUT, last[0]);
  io_write(0x2000 + (x & 255), a[x & 7]);
  io_write(0x3000 + (a[2] & 15), step());
  io_write(0x2100 + step(), io_read(0x2000 + (x & 127)));
  io_write(x, x >> 1);
  io_write(OUT, io_read(io_read(IN)));
  for (i = 0; i < 16; i++) io_write(OUT + 1, a[i]);
  for (i = 0; i < 5; i++) io_write(OUT + 2, b[i]);
}

// SPDX-License-Identifier: Apache-2.0
// Every statement; && and || with effects on either side.
#include "common.h"

enum { RED, GREEN = 7, BLUE, LAST = GREEN + 4 };

static u16 count;

static u16 bump(u16 value) {
  count = count + 1;
  io_write(OUT + 1, count);
  return value;
}

static u16 which(u16 a) {
  switch (a & 15) {
    case RED:
      return 100;
    case GREEN:
    case BLUE:
      a = a + 1;
      // fall through
    case LAST:
      a = a ^ 0x55;
      break;
    default:
      io_write(OUT + 2, a);
      if (a & 16) break;
      a = 9;
    case 3:
      a = a << 1;
  }
  return a;
}

static u16 far(u16 a) {
  switch (a) {
    case 0xFFFF:
      return 1;
    case 0:
      return 2;
    case 0x8000:
      return 3;
    case 0xFFFE:
      return 4;
    case 5:
      return 5;
  }
  return 0;
}

static void loops(u16 n) {
  u16 i;
  u16 k;
  n = n & 7;
  for (i = 0; i < n; i = i + 1) {
    if (i == 2) continue;
    if (i == 5) break;
    io_write(OUT + 3, i);
    for (k = i; k; k = k - 1) {
      if (k == 3) break;
      io_write(OUT + 4, k);
    }
  }
  i = n;
  while (i) {
    i--;
    if (i & 1) continue;
    io_write(OUT + 5, i);
  }
  i = 0;
  do {
    i += 3;
    if (i == 6) continue;
    io_write(OUT + 6, i);
    switch (i) {
      case 3:
        continue;
      case 9:
        k = 1;
        break;
      default:
        k = 2;
    }
    io_write(OUT + 7, k);
  } while (i < (u16)(2 * n));
  for (;;) {
    n = n + 5;
    if (n > 30) return;
  }
}

static void logic(u16 a, u16 b) {
  if (bump(a & 1) && bump(b & 1)) io_write(OUT, 1);
  if (bump(a & 2) || bump(b & 2)) io_write(OUT, 2);
  if ((bump(a & 1) && bump(a & 2)) || (bump(b & 1) && bump(b & 2)))
    io_write(OUT, 3);
  else if (!(bump(a & 4) || bump(b & 4)) && a < b)
    io_write(OUT, 4);
  else
    io_write(OUT, 5);
  while (bump(a) && a > 3 && !(a & 0x40)) a = a >> 1;
  io_write(OUT, a ? b ? 1 : 2 : bump(3));
  io_write(OUT, bump(a) == 1 && bump(b) != 2);
  if (1 || bump(1)) io_write(OUT, 6);
  if (0 && bump(1)) io_write(OUT, 7);
}

void firmware_reset(void) {}

void firmware_poll(void) {
  u16 a = io_read(IN);
  u16 b = io_read(IN);
  io_write(OUT, which(a));
  io_write(OUT, which(b));
  io_write(OUT, which(GREEN) + which(LAST) * 256);
  io_write(OUT, far(a) * 16);
  io_write(OUT, far(0x8000) * 4096 | far(0xFFFF) * 256 | far(0xFFFE) << 4 | far(5));
  loops(a);
  loops(b);
  logic(a, b);
  logic(b & 7, a & 3);
}

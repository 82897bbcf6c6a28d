// SPDX-License-Identifier: Apache-2.0
// Every operator on words from the bus, with every kind of operand.
#include "common.h"

static u16 g;
static u16 word[3];

static void show(u16 value) { io_write(OUT, value); }

static void sums(u16 a, u16 b) {
  show(a + b);
  show(a - b);
  show(a & b);
  show(a | b);
  show(a ^ b);
  show(~a);
  show(-a);
  show(!a);
  show(a + 1);
  show(a + 2047);
  show(a + 2048);
  show(a - 2047);
  show(a - 0xFFFF);
  show(a & 0xFF00);
  show(a | 0x8000);
  show(a ^ 0xFFFF);
  show(5 - a);
  show(60000 - a);
  show(g + a);
  show(a - g);
  show(g - a);
  show(word[1] - a);
  show((u16)(a + b) - (u16)(a ^ b));
  show((a & b) - (a | b));
}

static void shifts(u16 a) {
  show(a << 0);
  show(a << 1);
  show(a << 4);
  show(a << 7);
  show(a << 8);
  show(a << 9);
  show(a << 15);
  show(a >> 0);
  show(a >> 1);
  show(a >> 4);
  show(a >> 7);
  show(a >> 8);
  show(a >> 9);
  show(a >> 15);
  show(a * 1);
  show(a * 64);
  show(32 * a);
  show(a >> 8 | (u16)(a << 8));
  show((a >> 3 & 1) | (a >> 12 & 2));
}

static void compares(u16 a, u16 b) {
  show(a == b);
  show(a != b);
  show(a < b);
  show(a <= b);
  show(a > b);
  show(a >= b);
  show(a == 0);
  show(a != 0);
  show(a < 1);
  show(a > 0);
  show(a <= 2047);
  show(a > 2047);
  show(a < 2048);
  show(a >= 2048);
  show(a < 40000);
  show(a > 40000);
  show(a <= 0xFFFE);
  show(a == 0xFFFF);
  show(a != 0x8000);
  show(7 < a);
  show(50000 >= a);
  show(3 == a);
  show((a < b) + (a == b) * 2 + (a > b) * 4);
  show(a && b);
  show(a || b);
  show(!(a < b) && !(b < 300));
  show((a & 4) != 0);
  show((a & 4) == 0);
  show((a & 0x8000) ? 11 : 12);
}

void firmware_reset(void) {
  show(g);
  show(word[2]);
  g = 0x1234;
}

void firmware_poll(void) {
  u16 i;
  word[1] = io_read(IN);
  for (i = 0; i < 6; i++) {
    u16 a = io_read(IN);
    u16 b = io_read(IN + 1);
    if (i == 4) b = a;
    if (i == 5) b = a + 1;
    sums(a, b);
    if (!(i & 3)) shifts(a);
    compares(a, b);
    g = g + a;
  }
}

// SPDX-License-Identifier: Apache-2.0
// Arguments and results: functions that call each other in their arguments, locals that lie over
// one another.
#include "common.h"

static u16 total;

static u16 twice(u16 a) { return a + a; }
static u16 less(u16 a, u16 b) { return a - b; }
static u16 three(u16 a, u16 b, u16 c) {
  u16 d = less(twice(a), b);
  return d ^ less(c, twice(b));
}
static u16 five(u16 a, u16 b, u16 c, u16 d, u16 e) { return a + 2 * b + 4 * c + 8 * d + 16 * e; }
static void note(u16 a) {
  total = total + a;
  io_write(OUT, total);
}
static u16 absent(u16 a) { return a; }
static u16 nothing_uses_it(u16 a) { return absent(a) + absent(a + 1); }
static u16 pass(u16 a) { return a; }
static u16 early(u16 a, u16 b) {
  if (a < b) return twice(a);
  if (a == b) {
    note(a);
    return 0;
  }
  a = less(a, b);
  return three(a, b, a);
}

void firmware_reset(void) { note(3); }

void firmware_poll(void) {
  u16 a = io_read(IN);
  u16 b = io_read(IN + 1);
  u16 c = io_read(IN + 2);
  note(three(a, b, c));
  note(less(less(a, b), less(b, c)));
  note(less(5, a));
  note(less(a, twice(b)));
  note(three(twice(a), less(b, 1), less(less(a, 2), less(3, c))));
  note(five(a, b, c, twice(a), less(b, c)));
  note(five(1, 2, 3, 4, 5));
  note(five(twice(1), 2, twice(3), 4, twice(5)));
  note(pass(a) - pass(b));
  note(a - pass(b));
  note(pass(a) - b);
  note(1000 - pass(c));
  note(early(a, b));
  note(early(b, b));
  note(early(b, a));
  twice(early(c, a));
}

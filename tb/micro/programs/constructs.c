// SPDX-License-Identifier: Apache-2.0
// Every construct of the language once, with what is easily got wrong.
enum { ZERO, ONE, NINE = 9, TEN };
u16 array[16];
u16 calls;
static u16 sum3(u16 x, u16 y, u16 z) {
  calls += 1;
  return x + y + z;
}
static void note(u16 value) { io_write(TEN, value); }
static u16 side(void) {
  calls++;
  return calls & 1;
}
static u16 chosen(u16 value) {
  switch (value) {
    case 0:
      return 'z';
    case 3:
    case 4:
      value = value + 100;
      // falls through
    case 2000:
      value = value ^ 1;
      break;
    case 0xFFFF:
      return ~value;
    default:
      value = 0;
  }
  return value;
}
void firmware_reset(void) {
  u16 k;
  u16 n;
  for (k = 0; k < 16; k = k + 1) array[k] = k << 3;
  for (k = 2; k < 14; k++) array[k - 1] = array[k + 1] ^ array[k];
  for (k = 0; k < 16; k++) io_write(512 + k, array[k]);
  n = 5;
  while (1) {
    n--;
    if (n == 3) continue;
    note(n);
    if (!n) break;
  }
  do {
    n = n + 7;
  } while (n < 30);
  note(n);
  note(sum3(sum3(1, 2, n), 4, sum3(n, 5, 6)));  // the order of arguments does not matter here
  note(sum3(n, array[side()], 7));
  if (side() && side() || !side()) note(1);
  note(side() ? io_read(5) : io_read(6));
}
void firmware_poll(void) {
  u16 in = io_read(512 + (calls & 63));
  note(chosen(in));
  note(chosen(in & 7));
  note(chosen(0xFFFF));
  note(chosen(2000));
  note((in < 60000) + (in <= 60000) + (in > 0x8000) + (in >= 0xFFFE));
  note((in & 0x7FFF) ^ (in & 0xFFF0));
  if (in & 0xC000) note(in >> 14);
  if (in == 0xFFFE || in != 0xFFFD) note((u16)(-in) >> 1);
  note(calls);
}

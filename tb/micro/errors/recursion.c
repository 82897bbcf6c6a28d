// SPDX-License-Identifier: Apache-2.0
typedef unsigned short u16;
u16 io_read(u16 address);
void io_write(u16 address, u16 value);
static u16 f(u16 a);
static u16 g(u16 a) { return f(a); }
static u16 f(u16 a) {  // error: recursion
  return a ? g(a - 1) : 0;
}
void firmware_reset(void) {}
void firmware_poll(void) {
  f(3);
}

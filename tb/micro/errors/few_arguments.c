// SPDX-License-Identifier: Apache-2.0
typedef unsigned short u16;
u16 io_read(u16 address);
void io_write(u16 address, u16 value);
static u16 f(u16 a, u16 b) { return a + b; }
void firmware_reset(void) {}
void firmware_poll(void) {
  f(1);  // error: 2 arguments
}

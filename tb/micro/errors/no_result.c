// SPDX-License-Identifier: Apache-2.0
typedef unsigned short u16;
u16 io_read(u16 address);
void io_write(u16 address, u16 value);
static void f(void) { io_write(1, 1); }
void firmware_reset(void) {}
void firmware_poll(void) {
  io_write(1, f());  // error: gives nothing
}

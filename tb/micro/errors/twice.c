// SPDX-License-Identifier: Apache-2.0
typedef unsigned short u16;
u16 io_read(u16 address);
void io_write(u16 address, u16 value);
void firmware_reset(void) {}
u16 a[4];
void firmware_poll(void) {
  a[io_read(1) & 3] += 2;  // error: twice
}

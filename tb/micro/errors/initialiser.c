// SPDX-License-Identifier: Apache-2.0
typedef unsigned short u16;
u16 io_read(u16 address);
void io_write(u16 address, u16 value);
u16 x = 3;  // error: initialiser
void firmware_reset(void) {}
void firmware_poll(void) {}

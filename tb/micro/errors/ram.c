// SPDX-License-Identifier: Apache-2.0
typedef unsigned short u16;
u16 io_read(u16 address);
void io_write(u16 address, u16 value);
u16 x[300];
u16 y[300];
void firmware_reset(void) {}
void firmware_poll(void) { x[1] = y[1]; }  // error anywhere: RAM

/* SPDX-License-Identifier: Apache-2.0 */
typedef unsigned short u16;
u16 io_read(u16 address);
void io_write(u16 address, u16 value);
#define OUT (REGISTERS + 16)
#define IN (REGISTERS + 32)

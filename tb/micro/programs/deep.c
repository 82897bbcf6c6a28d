// SPDX-License-Identifier: Apache-2.0
// Calls as deep as returns are kept: 16 with the entry's own. Each is called twice, and does something after its calls.
u16 total;
static void d1(u16 n) { total = total + n; io_write(1, n); }
static void d2(u16 n) { d1(n); total = total ^ n; d1(n + 1); io_write(2, n); }
static void d3(u16 n) { d2(n); total = total ^ n; io_write(3, total); if (n & 1) d2(n + 3); io_write(3, n); }
static void d4(u16 n) { d3(n); total = total ^ n; io_write(4, total); if (n & 2) d3(n + 3); io_write(4, n); }
static void d5(u16 n) { d4(n); io_write(5, n); if (n & 64) d4(n); io_write(15, n); }
static void d6(u16 n) { d5(n); io_write(6, n); if (n & 64) d5(n); io_write(16, n); }
static void d7(u16 n) { d6(n); io_write(7, n); if (n & 64) d6(n); io_write(17, n); }
static void d8(u16 n) { d7(n); io_write(8, n); if (n & 64) d7(n); io_write(18, n); }
static void d9(u16 n) { d8(n); io_write(9, n); if (n & 64) d8(n); io_write(19, n); }
static void d10(u16 n) { d9(n); io_write(10, n); if (n & 64) d9(n); io_write(20, n); }
static void d11(u16 n) { d10(n); io_write(11, n); if (n & 64) d10(n); io_write(21, n); }
static void d12(u16 n) { d11(n); io_write(12, n); if (n & 64) d11(n); io_write(22, n); }
static void d13(u16 n) { d12(n); io_write(13, n); if (n & 64) d12(n); io_write(23, n); }
static void d14(u16 n) { d13(n); io_write(14, n); if (n & 64) d13(n); io_write(24, n); }
static void d15(u16 n) { d14(n); io_write(15, n); if (n & 64) d14(n); io_write(25, n); }
void firmware_reset(void) { d15(3); io_write(99, total); }
void firmware_poll(void) { d15(io_read(3)); io_write(98, total); }

/* SPDX-License-Identifier: Apache-2.0
   Runs natively compiled programs; micro_test.py compiles it with PROGRAMS, a list of PROGRAM(name,
   seed): name_reset and name_poll are the program. usage: native EVENTS POLLS: as micro_run prints
   it, at most so many each. */
#include "native.h"

#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>

#define PROGRAM(name, seed) \
  void name##_reset(void);  \
  void name##_poll(void);
#include PROGRAMS
#undef PROGRAM

static uint32_t seed_now;
static unsigned events, most_events;
static jmp_buf enough;

uint16_t io_read(uint16_t address) {
  uint16_t value;
  if (events == most_events) longjmp(enough, 1);
  value = rung_bus_value(seed_now, events++, address);
  printf("r %x %x\n", address, value);
  return value;
}

void io_write(uint16_t address, uint16_t value) {
  if (events == most_events) longjmp(enough, 1);
  ++events;
  printf("w %x %x\n", address, value);
}

static void run(const char* name, uint32_t seed, void (*reset)(void), void (*poll)(void),
                unsigned polls) {
  puts(name);
  seed_now = seed;
  events = 0;
  if (setjmp(enough)) return;
  reset();
  while (polls--) poll();
}

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  most_events = (unsigned)atoi(argv[1]);
#define PROGRAM(name, seed) run(#name, seed, name##_reset, name##_poll, (unsigned)atoi(argv[2]));
#include PROGRAMS
  return 0;
}

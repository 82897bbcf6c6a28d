/* SPDX-License-Identifier: Apache-2.0
 * Times an engine on this machine: the median over several runs of many scans under random inputs,
 * which are the same for every engine. Prints nanoseconds a scan.
 *
 * usage: engine SCANS [FILE] */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "engine.h"

enum { kRuns = 11, kInputs = 4096 };

/* Processor time: what else runs on the machine counts less. */
static double now_ns(void) {
  struct timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

/* Marsaglia's xorshift32. */
static uint32_t next_random(void) {
  static uint32_t state = 2463534242u;
  state ^= state << 13;
  state ^= state >> 17;
  state ^= state << 5;
  return state;
}

static int compare(const void* a, const void* b) {
  const double x = *(const double*)a, y = *(const double*)b;
  return (x > y) - (x < y);
}

int main(int argc, char** argv) {
  static uint32_t inputs[kInputs];
  double times[kRuns];
  const long scans = argc > 1 ? strtol(argv[1], NULL, 10) : 0;
  if (scans < 1 || engine_start(argc > 2 ? argv[2] : NULL) != 0) return 2;
  for (int i = 0; i < kInputs; ++i) inputs[i] = next_random();
  for (int run = 0; run < kRuns; ++run) {
    const double start = now_ns();
    for (long i = 0; i < scans; ++i) engine_scan(inputs[i % kInputs]);
    times[run] = (now_ns() - start) / (double)scans;
  }
  qsort(times, kRuns, sizeof *times, compare);
  printf("%.3f\n", times[kRuns / 2]);
  return 0;
}

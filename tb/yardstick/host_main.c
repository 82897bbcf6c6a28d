/* SPDX-License-Identifier: Apache-2.0
 * Main program of the machine that makes the report: times single scans one by one and prints one
 * JSON object with the scan times in nanoseconds. The cost of reading the clock, the median of as
 * many empty measurements, is subtracted.
 *
 * usage: host [SCANS]      (default and least 100,000) */
#define _POSIX_C_SOURCE 200809L
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "scans.h"

enum { kWarmUp = 1000, kLeastScans = 100000, kChecked = 500 };

static int64_t now_ns(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (int64_t)t.tv_sec * 1000000000 + t.tv_nsec;
}

static int compare(const void* a, const void* b) {
  const int64_t x = *(const int64_t*)a, y = *(const int64_t*)b;
  return (x > y) - (x < y);
}

int main(int argc, char** argv) {
  const size_t scans = argc > 1 ? strtoul(argv[1], NULL, 10) : kLeastScans;
  if (scans < kLeastScans) {
    fprintf(stderr, "at least %d scans\n", kLeastScans);
    return 2;
  }
  int64_t* times = malloc(scans * sizeof *times);
  if (times == NULL) return 1;

  for (size_t i = 0; i < scans; ++i) {
    const int64_t start = now_ns();
    times[i] = now_ns() - start;
  }
  qsort(times, scans, sizeof *times, compare);
  const int64_t overhead = times[scans / 2];

  /* The first scans are those that the soft cores run, for the checksum, and warm the caches. */
  uint32_t checksum = 0;
  for (int i = 0; i < kChecked; ++i) {
    scan_set_inputs();
    PlcCycle();
    checksum = scan_checksum(checksum);
  }
  for (int i = 0; i < kWarmUp; ++i) {
    scan_set_inputs();
    PlcCycle();
  }
  for (size_t i = 0; i < scans; ++i) {
    scan_set_inputs();
    const int64_t start = now_ns();
    PlcCycle();
    times[i] = now_ns() - start - overhead;
  }
  qsort(times, scans, sizeof *times, compare);
  printf("{\"scans\": %zu, \"clock_overhead_ns\": %" PRId64 ", \"min_ns\": %" PRId64
         ", \"median_ns\": %" PRId64 ", \"p999_ns\": %" PRId64 ", \"worst_ns\": %" PRId64
         ", \"checksum\": %" PRIu32 "}\n",
         scans, overhead, times[0], times[scans / 2], times[scans - 1 - scans / 1000],
         times[scans - 1], checksum);
  free(times);
  return 0;
}

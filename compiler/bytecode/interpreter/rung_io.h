/* SPDX-License-Identifier: Apache-2.0 */
/* Peripherals of a byte code program: functions of yours behind its device ports. Optional: a
 * program that names none of them needs none.
 */
#ifndef RUNG_IO_H
#define RUNG_IO_H

#include "rung_vm.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Each function gets `user`; any of them may be null, for a peripheral that is not there. */
typedef struct rung_io {
  void* user;
  /* Whether the transmitter takes a byte now; and the byte, if the program has one to send. */
  int (*uart_ready)(void* user);
  void (*uart_send)(void* user, uint8_t byte);
  /* A byte that has come in, or -1. It waits in the program until that takes it; no other is asked
   * for before. */
  int (*uart_receive)(void* user);
  /* The sample of a channel, before each scan for each channel that the program reads. */
  int16_t (*adc)(void* user, uint8_t channel);
  /* After each scan, from the program's first SET PWM on: frequency in Hz, duty in per cent. */
  void (*pwm)(void* user, uint32_t hz, int16_t duty);
  /* Whether the lasting memory can be read and written now; value number `i` of it (0 to 47), and
   * one to keep. */
  int (*persist_ready)(void* user);
  int16_t (*persist_value)(void* user, uint8_t i);
  void (*persist_keep)(void* user, uint8_t i, int16_t value);
} rung_io;

/* rung_vm_scan() with the peripherals served before and after it. */
void rung_io_scan(const rung_io* io, rung_vm* vm, uint32_t elapsed_us);

#ifdef __cplusplus
}
#endif
#endif

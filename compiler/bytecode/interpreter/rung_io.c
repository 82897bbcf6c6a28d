/* SPDX-License-Identifier: Apache-2.0 */
#include "rung_io.h"

#include "rung_ports.h"

/* A port's value, 0 if the program does not use it. */
static int16_t get(const rung_vm* vm, uint8_t space, uint8_t port) {
  rung_vm_device device;
  return rung_vm_port(vm, space, port, &device) ? rung_vm_value(vm, device) : 0;
}

static void set(rung_vm* vm, uint8_t space, uint8_t port, int16_t value) {
  rung_vm_device device;
  if (rung_vm_port(vm, space, port, &device)) rung_vm_set_value(vm, device, value);
}

static int is_used(const rung_vm* vm, uint8_t space, uint8_t port) {
  rung_vm_device device;
  return rung_vm_port(vm, space, port, &device);
}

static void before(const rung_io* io, rung_vm* vm) {
  uint8_t i;
  if (io->uart_receive != NULL && is_used(vm, RUNG_SPACE_BIT, RUNG_PORT_UART_RX_FULL) &&
      !get(vm, RUNG_SPACE_BIT, RUNG_PORT_UART_RX_FULL)) {
    const int byte = io->uart_receive(io->user);
    if (byte >= 0) {
      set(vm, RUNG_SPACE_WORD, RUNG_PORT_UART_RX_DATA, (int16_t)(byte & 0xFF));
      set(vm, RUNG_SPACE_BIT, RUNG_PORT_UART_RX_FULL, 1);
    }
  }
  set(vm, RUNG_SPACE_BIT, RUNG_PORT_UART_TX_READY,
      io->uart_ready != NULL && io->uart_ready(io->user));
  for (i = 0; io->adc != NULL && i < RUNG_PORT_ADC_COUNT; ++i) {
    const uint8_t port = (uint8_t)(RUNG_PORT_ADC + i);
    if (is_used(vm, RUNG_SPACE_WORD, port)) {
      set(vm, RUNG_SPACE_WORD, port, io->adc(io->user, i));
    }
  }
  if (io->persist_ready == NULL || io->persist_value == NULL || io->persist_keep == NULL ||
      !io->persist_ready(io->user)) {
    set(vm, RUNG_SPACE_BIT, RUNG_PORT_PERSIST_READY, 0);
    return;
  }
  for (i = 0; i < RUNG_PORT_PERSIST_VALUE_COUNT; ++i) {
    const uint8_t port = (uint8_t)(RUNG_PORT_PERSIST_VALUE + i);
    if (is_used(vm, RUNG_SPACE_WORD, port)) {
      set(vm, RUNG_SPACE_WORD, port, io->persist_value(io->user, i));
    }
  }
  set(vm, RUNG_SPACE_BIT, RUNG_PORT_PERSIST_READY, 1);
}

static void after(const rung_io* io, rung_vm* vm, int could_send, int could_keep) {
  if (could_send && !get(vm, RUNG_SPACE_BIT, RUNG_PORT_UART_TX_READY) && io->uart_send != NULL) {
    io->uart_send(io->user,
                  (uint8_t)((uint16_t)get(vm, RUNG_SPACE_WORD, RUNG_PORT_UART_TX_DATA) & 0xFFU));
  }
  if (io->pwm != NULL) {
    const uint32_t hz = (uint16_t)get(vm, RUNG_SPACE_WORD, RUNG_PORT_PWM_HZ_LOW) |
                        (uint32_t)(uint16_t)get(vm, RUNG_SPACE_WORD, RUNG_PORT_PWM_HZ_HIGH) << 16;
    if (hz != 0) io->pwm(io->user, hz, get(vm, RUNG_SPACE_WORD, RUNG_PORT_PWM_DUTY));
  }
  if (could_keep && !get(vm, RUNG_SPACE_BIT, RUNG_PORT_PERSIST_READY)) {
    const int16_t i = get(vm, RUNG_SPACE_WORD, RUNG_PORT_PERSIST_INDEX);
    if (i >= 0 && i < RUNG_PORT_PERSIST_VALUE_COUNT) {
      const uint8_t port = (uint8_t)(RUNG_PORT_PERSIST_VALUE + i);
      io->persist_keep(io->user, (uint8_t)i, get(vm, RUNG_SPACE_WORD, port));
    }
  }
}

void rung_io_scan(const rung_io* io, rung_vm* vm, uint32_t elapsed_us) {
  int could_send, could_keep;
  before(io, vm);
  could_send = get(vm, RUNG_SPACE_BIT, RUNG_PORT_UART_TX_READY) != 0;
  could_keep = get(vm, RUNG_SPACE_BIT, RUNG_PORT_PERSIST_READY) != 0;
  rung_vm_scan(vm, elapsed_us);
  after(io, vm, could_send, could_keep);
}

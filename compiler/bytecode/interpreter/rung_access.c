/* SPDX-License-Identifier: Apache-2.0 */
/* Devices of a loaded program, by number, by name and as ports. */
#include "rung_read.h"
#include "rung_vm.h"

uint8_t rung_vm_bit(const rung_vm* vm, uint16_t number) {
  return number < vm->bits_count ? vm->bits[number] : 0;
}

void rung_vm_set_bit(rung_vm* vm, uint16_t number, uint8_t value) {
  if (number < vm->bits_count) vm->bits[number] = value != 0;
}

int16_t rung_vm_word(const rung_vm* vm, uint16_t number) {
  const uint16_t word = number < vm->words_count ? vm->words[number] : 0;
  return (int16_t)(word < 0x8000U ? (int32_t)word : (int32_t)word - 0x10000L);
}

void rung_vm_set_word(rung_vm* vm, uint16_t number, int16_t value) {
  if (number < vm->first_constant) vm->words[number] = (uint16_t)value;
}

int16_t rung_vm_value(const rung_vm* vm, rung_vm_device device) {
  return device.space == RUNG_SPACE_BIT ? rung_vm_bit(vm, device.number)
                                        : rung_vm_word(vm, device.number);
}

void rung_vm_set_value(rung_vm* vm, rung_vm_device device, int16_t value) {
  if (device.space == RUNG_SPACE_BIT) {
    rung_vm_set_bit(vm, device.number, value != 0);
  } else {
    rung_vm_set_word(vm, device.number, value);
  }
}

/* The device of the name at `at`; the name behind it is length bytes further. */
static rung_vm_device device_at(const uint8_t* at) {
  rung_vm_device device;
  device.space = rung_read8(at) & 1U;
  device.use = (uint8_t)(rung_read8(at) >> 1);
  device.number = rung_read16(at + 1);
  return device;
}

static int is_name(const uint8_t* at, const char* name) {
  const uint16_t length = rung_read16(at + 3);
  uint16_t i;
  for (i = 0; i < length; ++i) {
    if (name[i] == '\0' || (uint8_t)name[i] != rung_read8(at + RUNG_NAME_BYTES + i)) return 0;
  }
  return name[length] == '\0';
}

int rung_vm_find(const rung_vm* vm, const char* name, rung_vm_device* device) {
  const uint8_t* at = vm->names;
  uint16_t i;
  for (i = 0; i < vm->names_count; ++i) {
    if (rung_read8(at) >> 1 != RUNG_USE_CHANNEL && is_name(at, name)) {
      *device = device_at(at);
      return 1;
    }
    at += RUNG_NAME_BYTES + rung_read16(at + 3);
  }
  return 0;
}

int rung_vm_name(const rung_vm* vm, uint16_t i, char* name, size_t size, rung_vm_device* device) {
  const uint8_t* at = vm->names;
  uint16_t length;
  size_t k;
  if (i >= vm->names_count || size == 0) return 0;
  for (; i > 0; --i) at += RUNG_NAME_BYTES + rung_read16(at + 3);
  length = rung_read16(at + 3);
  for (k = 0; k < length && k + 1 < size; ++k) name[k] = (char)rung_read8(at + RUNG_NAME_BYTES + k);
  name[k] = '\0';
  *device = device_at(at);
  return 1;
}

int rung_vm_port(const rung_vm* vm, uint8_t space, uint8_t port, rung_vm_device* device) {
  const uint8_t* at = vm->ports;
  uint16_t i;
  for (i = 0; i < vm->ports_count; ++i, at += RUNG_PORT_BYTES) {
    if (rung_read8(at) != space || rung_read8(at + 1) != port) continue;
    device->space = space;
    device->use = RUNG_USE_INNER;
    device->number = rung_read16(at + 2);
    return 1;
  }
  return 0;
}

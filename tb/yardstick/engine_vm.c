/* SPDX-License-Identifier: Apache-2.0
 * A byte code file as an engine. Its peripherals: a transmitter that is always ready, nothing to
 * receive, samples of 0, no lasting memory. */
#include <stdio.h>
#include <stdlib.h>

#include "engine.h"
#include "rung_io.h"

enum { kMostInputs = 1024 };

static rung_vm vm;
static rung_vm_device inputs_of[kMostInputs];
static unsigned input_count;

static int ready(void* user) {
  (void)user;
  return 1;
}

static const rung_io io = {.uart_ready = ready};

static uint8_t* read_file(const char* path, size_t* size) {
  FILE* const file = fopen(path, "rb");
  uint8_t* bytes = NULL;
  if (file == NULL) return NULL;
  if (fseek(file, 0, SEEK_END) == 0) {
    *size = (size_t)ftell(file);
    rewind(file);
    bytes = malloc(*size + 1);
    if (bytes != NULL && fread(bytes, 1, *size, file) != *size) bytes = NULL;
  }
  fclose(file);
  return bytes;
}

int engine_start(const char* file) {
  size_t size = 0;
  const uint8_t* const image = file == NULL ? NULL : read_file(file, &size);
  rung_vm_memory memory;
  rung_vm_error error;
  char name[2];
  if (image == NULL) return 1;
  error = rung_vm_needs(image, size, &memory);
  if (error == RUNG_VM_OK) {
    memory.times = calloc(memory.times_count + 1, sizeof *memory.times);
    memory.words = calloc(memory.words_count + 1, sizeof *memory.words);
    memory.bits = calloc(memory.bits_count + 1, sizeof *memory.bits);
    error = rung_vm_load(&vm, image, size, &memory);
  }
  if (error != RUNG_VM_OK) {
    fprintf(stderr, "%s: %s\n", file, rung_vm_error_text(error));
    return 1;
  }
  for (uint16_t i = 0; i < vm.names_count && input_count < kMostInputs; ++i) {
    rung_vm_device device;
    if (rung_vm_name(&vm, i, name, sizeof name, &device) && device.use == RUNG_USE_INPUT) {
      inputs_of[input_count++] = device;
    }
  }
  return 0;
}

void engine_scan(uint32_t inputs) {
  for (unsigned i = 0; i < input_count; ++i) {
    rung_vm_set_value(&vm, inputs_of[i], inputs >> i % 32 & 1);
  }
  rung_io_scan(&io, &vm, vm.period_us);
}

/* SPDX-License-Identifier: Apache-2.0 */
/* Interpreter of Rung's byte code, to be built into other programs: rung_check.c, rung_vm.c and
 * rung_access.c, and rung_io.c for peripherals. It needs nothing of the C library, allocates
 * nothing and does not recurse. compiler/bytecode/README.md says how to use it.
 */
#ifndef RUNG_VM_H
#define RUNG_VM_H

#include <stddef.h>
#include <stdint.h>

#include "rung_format.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum rung_vm_error {
  RUNG_VM_OK,
  RUNG_VM_BAD_MAGIC,    /* not a byte code file */
  RUNG_VM_BAD_VERSION,  /* of another version than this interpreter can run */
  RUNG_VM_BAD_SIZE,     /* shorter or longer than it says */
  RUNG_VM_BAD_CRC,      /* damaged */
  RUNG_VM_BAD_HEADER,   /* counts or a section that cannot be */
  RUNG_VM_BAD_OPCODE,   /* an unknown instruction, or code without its END */
  RUNG_VM_BAD_OPERAND,  /* a device, count or distance that cannot be */
  RUNG_VM_BAD_STACK,    /* a stack that would not hold */
  RUNG_VM_SMALL_MEMORY, /* less memory than rung_vm_needs() asks for */
  RUNG_VM_ERRORS
} rung_vm_error;

/* What a program works in; the arrays are the caller's. */
typedef struct rung_vm_memory {
  uint32_t* times;
  uint16_t* words;
  uint8_t* bits;
  uint32_t times_count, words_count, bits_count;
} rung_vm_memory;

/* A loaded program. Its fields are the interpreter's own, but for those that the functions below
 * speak of. */
typedef struct rung_vm {
  const uint8_t* image;
  const uint8_t *ticks, *driven, *ports, *code, *names; /* its sections */
  uint32_t* times;
  uint16_t* words;
  uint8_t *bits, *blocks, *branches;
  uint32_t period_us; /* from scan to scan, as the program wants it; 0: any */
  uint16_t bits_count, words_count, first_constant;
  uint16_t ticks_count, driven_count, ports_count, names_count;
  uint16_t blocks_count, branches_count;
  uint32_t code_size;
  uint8_t dialect;
  uint8_t started; /* a scan has run */
  uint8_t error;   /* the last scan has divided by 0 */
} rung_vm;

/* A device: RUNG_SPACE_BIT or RUNG_SPACE_WORD, and its number there. */
typedef struct rung_vm_device {
  uint8_t space;
  uint8_t use; /* RUNG_USE_... */
  uint16_t number;
} rung_vm_device;

/* Checks the file and says in the counts of `memory` how long its arrays have to be. */
rung_vm_error rung_vm_needs(const uint8_t* image, size_t size, rung_vm_memory* memory);

/* Checks all of the file, so that nothing needs to be checked when it runs, and makes it ready: all
 * devices 0. `image` and the arrays must outlive `vm`. After an error `vm` must not be used. */
rung_vm_error rung_vm_load(rung_vm* vm, const uint8_t* image, size_t size,
                           const rung_vm_memory* memory);

/* What an error means. */
const char* rung_vm_error_text(rung_vm_error error);

/* Back to the start: all devices 0, and the next scan is the first. */
void rung_vm_reset(rung_vm* vm);

/* One scan, `elapsed_us` microseconds (at most 2^31 - 1) after the one before; the first one takes
 * no notice of it. vm->error then says whether it has divided by 0. */
void rung_vm_scan(rung_vm* vm, uint32_t elapsed_us);

/* Devices by number; a number that the program does not have reads 0 and is not written. Constants
 * are not written. */
uint8_t rung_vm_bit(const rung_vm* vm, uint16_t number);
void rung_vm_set_bit(rung_vm* vm, uint16_t number, uint8_t value);
int16_t rung_vm_word(const rung_vm* vm, uint16_t number);
void rung_vm_set_word(rung_vm* vm, uint16_t number, int16_t value);
int16_t rung_vm_value(const rung_vm* vm, rung_vm_device device);
void rung_vm_set_value(rung_vm* vm, rung_vm_device device, int16_t value);

/* The device of this name; 1 if there is one. Analogue channels are not found by name. */
int rung_vm_find(const rung_vm* vm, const char* name, rung_vm_device* device);

/* Name number `i` of vm->names_count, in the program's order: its first characters, as many as
 * `size` leaves room for beside the 0 at the end, and its device. 1 if there is such a name. */
int rung_vm_name(const rung_vm* vm, uint16_t i, char* name, size_t size, rung_vm_device* device);

/* The device that is this port (rung_ports.h); 1 if the program uses it. */
int rung_vm_port(const rung_vm* vm, uint8_t space, uint8_t port, rung_vm_device* device);

#ifdef __cplusplus
}
#endif
#endif

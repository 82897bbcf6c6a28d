/* SPDX-License-Identifier: Apache-2.0 */
/* What a byte code file must be before it may run: after this nothing can go out of bounds. */
#include "rung_read.h"
#include "rung_vm.h"

/* What is left to read of a file or a part of it. */
typedef struct part {
  const uint8_t* at;
  uint32_t left;
} part;

/* The stacks, as far as the code has been walked through. */
typedef struct depths {
  uint16_t blocks, branches;
} depths;

static uint32_t crc32_of(const uint8_t* at, uint32_t size) {
  uint32_t crc = 0xFFFFFFFFUL;
  int i;
  for (; size > 0; --size, ++at) {
    crc ^= rung_read8(at);
    for (i = 0; i < 8; ++i) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xEDB88320UL : 0);
  }
  return crc ^ 0xFFFFFFFFUL;
}

/* The next `bytes` of the part, or null. */
static const uint8_t* take(part* rest, uint32_t bytes) {
  const uint8_t* at = rest->at;
  if (bytes > rest->left) return NULL;
  rest->at += bytes;
  rest->left -= bytes;
  return at;
}

static int take_byte(part* rest, uint16_t* byte) {
  const uint8_t* at = take(rest, 1);
  if (at == NULL) return 0;
  *byte = rung_read8(at);
  return 1;
}

static int take_number(part* rest, uint16_t* number) {
  uint16_t low = 0;
  if (!take_byte(rest, number)) return 0;
  if (*number < 0x80) return 1;
  if (!take_byte(rest, &low)) return 0;
  *number = (uint16_t)((uint16_t)(*number & 0x7FU) << 8 | low);
  return 1;
}

/* Effect and operands of an instruction, or null. */
static const char* form_of(uint16_t opcode) {
  switch (opcode) {
#define RUNG_OPCODE(name, code, operands, effect, meaning) \
  case code:                                               \
    return effect operands;
#include "rung_opcodes.h"
#undef RUNG_OPCODE
    default:
      return NULL;
  }
}

static int take_device(part* code, uint16_t count) {
  uint16_t number = 0;
  return take_number(code, &number) && number < count;
}

static int take_window(part* code, uint16_t count) {
  uint16_t first = 0;
  uint16_t length = 0;
  return take_number(code, &first) && take_number(code, &length) && length > 0 && first < count &&
         length <= count - first;
}

/* One operand that is a device, a window or a bit number. */
static int take_operand(const rung_vm* vm, part* code, char kind) {
  uint16_t number = 0;
  switch (kind) {
    case 'b':
    case 'B':
      return take_device(code, vm->bits_count);
    case 'w':
      return take_device(code, vm->words_count);
    case 'W':
      return take_device(code, vm->first_constant);
    case 'a':
      return take_window(code, vm->bits_count);
    case 'A':
      return take_window(code, vm->first_constant);
    case 't':
      return take_window(code, vm->words_count);
    default: /* 'n' */
      return take_byte(code, &number) && number < 16;
  }
}

/* The most that a count may be: bits of a word, or words of a result. */
static uint16_t greatest_count(const char* operands) {
  if (operands[1] == 'b') return 16;
  return operands[-3] == 'w' ? 4 : 2;
}

/* The operands; `skip` is the distance, if there is one. */
static int take_operands(const rung_vm* vm, part* code, const char* operands, uint16_t* skip) {
  const char* at;
  uint16_t count = 0;
  for (at = operands; *at != '\0'; ++at) {
    if (*at == 's') {
      if (!take_number(code, skip) || *skip == 0) return 0;
    } else if (*at == 'c') {
      if (!take_byte(code, &count) || count == 0 || count > greatest_count(at)) return 0;
      for (++at; count > 0; --count) {
        if (!take_operand(vm, code, *at)) return 0;
      }
    } else if (!take_operand(vm, code, *at)) {
      return 0;
    }
  }
  return 1;
}

/* What an instruction does to the stacks; 0 if they would not hold. */
static int move(const rung_vm* vm, depths* now, char effect) {
  switch (effect) {
    case '(':
      return now->blocks++ < vm->blocks_count;
    case ')':
      return now->blocks-- > 0;
    case '[':
      return now->branches++ < vm->branches_count;
    case ']':
      return now->branches-- > 0;
    case '=':
      return now->branches > 0;
    default:
      return 1;
  }
}

static rung_vm_error check_code(const rung_vm* vm) {
  part code;
  depths now = {0, 0};
  uint32_t guarded = 0; /* what is left of the code when the last IF ends */
  int in_if = 0;
  code.at = vm->code;
  code.left = vm->code_size;
  for (;;) {
    uint16_t opcode = 0;
    uint16_t skip = 0;
    const char* form;
    if (!take_byte(&code, &opcode)) return RUNG_VM_BAD_OPCODE;
    form = form_of(opcode);
    if (form == NULL) return RUNG_VM_BAD_OPCODE;
    if (opcode == 0) return code.left == 0 ? RUNG_VM_OK : RUNG_VM_BAD_OPCODE;
    if (!take_operands(vm, &code, form + 1, &skip)) return RUNG_VM_BAD_OPERAND;
    if (in_if) {
      /* Only what may be left out, and nothing that goes beyond its end. */
      if (form[0] != '.' || code.left < guarded) return RUNG_VM_BAD_OPERAND;
      in_if = code.left > guarded;
    } else if (skip > 0) {
      if (skip >= code.left) return RUNG_VM_BAD_OPERAND;
      guarded = code.left - skip;
      in_if = 1;
    }
    if (!move(vm, &now, form[0])) return RUNG_VM_BAD_STACK;
  }
}

static int check_ticks(const rung_vm* vm) {
  uint16_t i;
  for (i = 0; i < vm->ticks_count; ++i) {
    const uint8_t* at = vm->ticks + (size_t)i * RUNG_TICK_BYTES;
    const uint32_t base = rung_read32(at + 2);
    if (rung_read16(at) >= vm->first_constant || base == 0 || base >= RUNG_TIMES) return 0;
  }
  return 1;
}

static int check_driven(const rung_vm* vm) {
  uint16_t i;
  for (i = 0; i < vm->driven_count; ++i) {
    const uint8_t* at = vm->driven + (size_t)i * RUNG_DRIVEN_BYTES;
    const uint8_t role = rung_read8(at + 2);
    const uint32_t period = rung_read32(at + 3);
    if (rung_read16(at) >= vm->bits_count || role > RUNG_ROLE_CLOCK) return 0;
    if (period >= RUNG_TIMES || (period == 0) != (role != RUNG_ROLE_CLOCK)) return 0;
  }
  return 1;
}

static int check_ports(const rung_vm* vm) {
  uint16_t i;
  for (i = 0; i < vm->ports_count; ++i) {
    const uint8_t* at = vm->ports + (size_t)i * RUNG_PORT_BYTES;
    const uint8_t space = rung_read8(at);
    if (space > RUNG_SPACE_WORD) return 0;
    if (rung_read16(at + 2) >= (space == RUNG_SPACE_BIT ? vm->bits_count : vm->first_constant)) {
      return 0;
    }
  }
  return 1;
}

static int check_names(const rung_vm* vm, part* rest) {
  uint16_t i;
  for (i = 0; i < vm->names_count; ++i) {
    const uint8_t* at = take(rest, RUNG_NAME_BYTES);
    uint16_t number;
    if (at == NULL) return 0;
    number = rung_read16(at + 1);
    if (rung_read8(at) >> 1 > RUNG_USE_CHANNEL) return 0;
    if (number >= ((rung_read8(at) & 1U) == 0 ? vm->bits_count : vm->first_constant)) return 0;
    if (rung_read16(at + 3) == 0 || take(rest, rung_read16(at + 3)) == NULL) return 0;
  }
  return rest->left == 0;
}

/* Finds the sections behind the header. */
static int find_sections(rung_vm* vm, part* rest) {
  const uint32_t constants = (uint32_t)(vm->words_count - vm->first_constant);
  if (take(rest, constants * RUNG_CONSTANT_BYTES) == NULL) return 0;
  vm->ticks = take(rest, (uint32_t)vm->ticks_count * RUNG_TICK_BYTES);
  if (vm->ticks == NULL) return 0;
  vm->driven = take(rest, (uint32_t)vm->driven_count * RUNG_DRIVEN_BYTES);
  if (vm->driven == NULL) return 0;
  vm->ports = take(rest, (uint32_t)vm->ports_count * RUNG_PORT_BYTES);
  if (vm->ports == NULL) return 0;
  vm->code = take(rest, vm->code_size);
  if (vm->code == NULL) return 0;
  vm->names = rest->at;
  return 1;
}

static int read_header(rung_vm* vm) {
  const uint8_t* image = vm->image;
  vm->period_us = rung_read32(image + RUNG_AT_PERIOD);
  vm->code_size = rung_read32(image + RUNG_AT_CODE_SIZE);
  vm->bits_count = rung_read16(image + RUNG_AT_BITS);
  vm->words_count = rung_read16(image + RUNG_AT_WORDS);
  vm->first_constant = rung_read16(image + RUNG_AT_FIRST_CONSTANT);
  vm->ticks_count = rung_read16(image + RUNG_AT_TICKS);
  vm->driven_count = rung_read16(image + RUNG_AT_DRIVEN);
  vm->ports_count = rung_read16(image + RUNG_AT_PORTS);
  vm->names_count = rung_read16(image + RUNG_AT_NAMES);
  vm->blocks_count = rung_read16(image + RUNG_AT_BLOCKS);
  vm->branches_count = rung_read16(image + RUNG_AT_BRANCHES);
  vm->dialect = rung_read8(image + RUNG_AT_DIALECT);
  return vm->bits_count <= RUNG_NUMBERS && vm->words_count <= RUNG_NUMBERS &&
         vm->first_constant <= vm->words_count && vm->dialect <= 3 && vm->period_us < RUNG_TIMES &&
         rung_read8(image + RUNG_AT_ZERO) == 0;
}

/* All checks; fills in what the file says. */
static rung_vm_error check(rung_vm* vm, const uint8_t* image, size_t size) {
  part rest;
  uint32_t checked;
  int i;
  for (i = 0; i < 4; ++i) {
    if (size <= (size_t)i) return RUNG_VM_BAD_SIZE;
    if (rung_read8(image + i) != (uint8_t)RUNG_FORMAT_MAGIC[i]) return RUNG_VM_BAD_MAGIC;
  }
  if (size < RUNG_HEADER_BYTES + RUNG_CRC_BYTES) return RUNG_VM_BAD_SIZE;
  if (rung_read8(image + RUNG_AT_MAJOR) != RUNG_FORMAT_MAJOR ||
      rung_read8(image + RUNG_AT_MINOR) > RUNG_FORMAT_MINOR) {
    return RUNG_VM_BAD_VERSION;
  }
  if (rung_read32(image + RUNG_AT_SIZE) != size) return RUNG_VM_BAD_SIZE;
  checked = (uint32_t)size - RUNG_CRC_BYTES;
  if (crc32_of(image, checked) != rung_read32(image + checked)) return RUNG_VM_BAD_CRC;
  vm->image = image;
  rest.at = image + RUNG_HEADER_BYTES;
  rest.left = checked - RUNG_HEADER_BYTES;
  if (!read_header(vm) || !find_sections(vm, &rest) || !check_ticks(vm) || !check_driven(vm) ||
      !check_ports(vm) || !check_names(vm, &rest)) {
    return RUNG_VM_BAD_HEADER;
  }
  return check_code(vm);
}

static void count_needs(const rung_vm* vm, rung_vm_memory* memory) {
  memory->times_count = (uint32_t)vm->ticks_count + vm->driven_count;
  memory->words_count = vm->words_count;
  memory->bits_count = (uint32_t)vm->bits_count + vm->blocks_count + vm->branches_count;
}

rung_vm_error rung_vm_needs(const uint8_t* image, size_t size, rung_vm_memory* memory) {
  rung_vm vm;
  const rung_vm_error error = check(&vm, image, size);
  if (error == RUNG_VM_OK) count_needs(&vm, memory);
  return error;
}

rung_vm_error rung_vm_load(rung_vm* vm, const uint8_t* image, size_t size,
                           const rung_vm_memory* memory) {
  rung_vm_memory needs;
  const rung_vm_error error = check(vm, image, size);
  if (error != RUNG_VM_OK) return error;
  count_needs(vm, &needs);
  if (memory->times_count < needs.times_count || memory->words_count < needs.words_count ||
      memory->bits_count < needs.bits_count) {
    return RUNG_VM_SMALL_MEMORY;
  }
  vm->times = memory->times;
  vm->words = memory->words;
  vm->bits = memory->bits;
  vm->blocks = vm->bits + vm->bits_count;
  vm->branches = vm->blocks + vm->blocks_count;
  rung_vm_reset(vm);
  return RUNG_VM_OK;
}

const char* rung_vm_error_text(rung_vm_error error) {
  switch (error) {
    case RUNG_VM_OK:
      return "no error";
    case RUNG_VM_BAD_MAGIC:
      return "not a byte code file";
    case RUNG_VM_BAD_VERSION:
      return "byte code of a version that this interpreter cannot run";
    case RUNG_VM_BAD_SIZE:
      return "shorter or longer than the file says";
    case RUNG_VM_BAD_CRC:
      return "damaged: wrong check sum";
    case RUNG_VM_BAD_HEADER:
      return "counts or a section that cannot be";
    case RUNG_VM_BAD_OPCODE:
      return "an unknown instruction, or code without its end";
    case RUNG_VM_BAD_OPERAND:
      return "a device, count or distance that cannot be";
    case RUNG_VM_BAD_STACK:
      return "a stack that would not hold";
    case RUNG_VM_SMALL_MEMORY:
      return "less memory than the program needs";
    default:
      return "unknown error";
  }
}

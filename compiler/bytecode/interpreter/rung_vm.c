/* SPDX-License-Identifier: Apache-2.0 */
/* Runs what rung_check.c has let through: here nothing is checked any more. */
#include "rung_vm.h"

#include "rung_read.h"

enum {
#define RUNG_OPCODE(name, code, operands, effect, meaning) CODE_##name = code,
#include "rung_opcodes.h"
#undef RUNG_OPCODE
  CODES
};

/* --- Values. Words are unsigned in memory, so that nothing overflows that must wrap. */

static int32_t signed16(uint16_t word) {
  return word < 0x8000U ? (int32_t)word : (int32_t)word - 0x10000L;
}

static uint32_t pair_of(uint16_t low, uint16_t high) { return low | (uint32_t)high << 16; }

static uint32_t magnitude(uint32_t value) {
  return (value & 0x80000000UL) != 0 ? 0UL - value : value;
}

static void split(uint16_t* words, uint32_t value) {
  words[0] = (uint16_t)(value & 0xFFFFU);
  words[1] = (uint16_t)(value >> 16);
}

/* a * b as four words, lowest first. */
static void multiply32(uint16_t* result, uint32_t a, uint32_t b) {
  uint64_t product = (uint64_t)magnitude(a) * magnitude(b);
  if (((a ^ b) & 0x80000000UL) != 0) product = 0U - product;
  split(result, (uint32_t)(product & 0xFFFFFFFFUL));
  split(result + 2, (uint32_t)(product >> 32));
}

/* Quotient and remainder, two words each; b is not 0. */
static void divide32(uint16_t* result, uint32_t a, uint32_t b) {
  uint32_t quotient = magnitude(a) / magnitude(b);
  uint32_t remainder = magnitude(a) % magnitude(b);
  if (((a ^ b) & 0x80000000UL) != 0) quotient = 0UL - quotient;
  if ((a & 0x80000000UL) != 0) remainder = 0UL - remainder;
  split(result, quotient);
  split(result + 2, remainder);
}

static uint16_t rotate(uint16_t word, uint16_t count) {
  const uint32_t doubled = pair_of(word, word);
  return (uint16_t)(doubled >> (16U - (count & 15U)) & 0xFFFFU);
}

/* --- Time. An accumulator holds what is left of the time so far: below its base or period. */

static uint32_t advance(uint32_t* left, uint32_t elapsed_us, uint32_t base) {
  const uint32_t now = *left + elapsed_us;
  *left = now % base;
  return now / base;
}

static void drive(rung_vm* vm, uint32_t elapsed_us) {
  const uint8_t* at = vm->ticks;
  uint32_t* left = vm->times;
  uint16_t i;
  if (elapsed_us >= RUNG_TIMES) elapsed_us = RUNG_TIMES - 1;
  if (!vm->started) elapsed_us = 0;
  for (i = 0; i < vm->ticks_count; ++i, ++left, at += RUNG_TICK_BYTES) {
    const uint32_t ticks = advance(left, elapsed_us, rung_read32(at + 2));
    vm->words[rung_read16(at)] = (uint16_t)(ticks > 0x7FFFU ? 0x7FFFU : ticks);
  }
  at = vm->driven;
  for (i = 0; i < vm->driven_count; ++i, ++left, at += RUNG_DRIVEN_BYTES) {
    uint8_t* bit = vm->bits + rung_read16(at);
    const uint32_t period = rung_read32(at + 3);
    switch (rung_read8(at + 2)) {
      case RUNG_ROLE_ON:
        *bit = 1;
        break;
      case RUNG_ROLE_OFF:
        *bit = 0;
        break;
      case RUNG_ROLE_FIRST_SCAN:
        *bit = (uint8_t)!vm->started;
        break;
      case RUNG_ROLE_NOT_FIRST_SCAN:
        *bit = vm->started;
        break;
      default:
        advance(left, elapsed_us, period);
        *bit = *left >= period - *left;
        break;
    }
  }
}

/* --- Code. BIT() and WORD() are the device that the next operand means. */

#define BIT() bits[next_number(&at)]
#define WORD() words[next_number(&at)]

static uint16_t next_number(const uint8_t** at) {
  const uint16_t first = rung_read8((*at)++);
  if (first < 0x80U) return first;
  return (uint16_t)((uint16_t)(first & 0x7FU) << 8 | rung_read8((*at)++));
}

/* Two words as one value of 32 bits, the low one first. */
static uint32_t next_pair(const uint16_t* words, const uint8_t** at) {
  const uint16_t low = words[next_number(at)];
  return pair_of(low, words[next_number(at)]);
}

/* Writes as many words of `result` as the instruction has targets. */
static const uint8_t* deliver(uint16_t* words, const uint8_t* at, const uint16_t* result) {
  uint8_t count = rung_read8(at++);
  for (; count > 0; --count) WORD() = *result++;
  return at;
}

/* The instructions with 32 bits, with a count or a window; gives the next one. */
static const uint8_t* run_long(rung_vm* vm, uint8_t opcode, const uint8_t* at) {
  uint8_t* const bits = vm->bits;
  uint16_t* const words = vm->words;
  uint16_t result[4];
  uint32_t a, b;
  uint16_t index, first, length;
  uint8_t i, count;
  switch (opcode) {
    case CODE_ADD32:
    case CODE_SUB32:
      a = next_pair(words, &at);
      b = next_pair(words, &at);
      split(result, opcode == CODE_ADD32 ? a + b : a - b);
      WORD() = result[0];
      WORD() = result[1];
      return at;
    case CODE_LT32:
      a = next_pair(words, &at);
      b = next_pair(words, &at);
      BIT() = (a ^ 0x80000000UL) < (b ^ 0x80000000UL);
      return at;
    case CODE_MUL:
      a = WORD();
      b = WORD();
      split(result, (uint32_t)(signed16((uint16_t)a) * signed16((uint16_t)b)));
      return deliver(words, at, result);
    case CODE_MUL32:
      a = next_pair(words, &at);
      b = next_pair(words, &at);
      multiply32(result, a, b);
      return deliver(words, at, result);
    case CODE_DIV:
      a = WORD();
      b = WORD();
      if (b != 0) {
        divide32(result, (uint32_t)signed16((uint16_t)a), (uint32_t)signed16((uint16_t)b));
        result[1] = result[2];
        return deliver(words, at, result);
      }
      break;
    case CODE_DIV32:
      a = next_pair(words, &at);
      b = next_pair(words, &at);
      if (b != 0) {
        divide32(result, a, b);
        return deliver(words, at, result);
      }
      break;
    case CODE_GATHER:
      count = rung_read8(at++);
      result[0] = 0;
      for (i = 0; i < count; ++i) result[0] = (uint16_t)(result[0] | (uint16_t)BIT() << i);
      WORD() = result[0];
      return at;
    default: /* with a window */
      index = WORD();
      first = next_number(&at);
      length = next_number(&at);
      first = (uint16_t)(first + (index < length ? index : 0));
      switch (opcode) {
        case CODE_LOADW:
          result[0] = words[first];
          WORD() = index < length ? result[0] : 0;
          break;
        case CODE_LOADB:
          count = bits[first];
          BIT() = index < length ? count : 0;
          break;
        case CODE_STOREW:
          result[0] = WORD();
          if (index < length) words[first] = result[0];
          break;
        default:
          if (index < length) bits[first] = opcode == CODE_SETB;
          break;
      }
      return at;
  }
  /* A division by 0: its targets are passed over. */
  vm->error = 1;
  for (count = rung_read8(at++); count > 0; --count) next_number(&at);
  return at;
}

/* The other instructions on words; gives the next one. */
static const uint8_t* run_word(rung_vm* vm, uint8_t opcode, const uint8_t* at) {
  uint8_t* const bits = vm->bits;
  uint16_t* const words = vm->words;
  uint16_t a, b;
  if (opcode == CODE_MOV) {
    a = WORD();
    WORD() = a;
    return at;
  }
  if (opcode == CODE_TB) {
    a = WORD();
    b = rung_read8(at++);
    BIT() = (uint8_t)((unsigned)a >> b & 1U);
    return at;
  }
  if ((opcode >= CODE_ADD32 && opcode <= CODE_DIV32) || opcode >= CODE_LT32) {
    return run_long(vm, opcode, at);
  }
  a = WORD();
  b = WORD();
  switch (opcode) {
    case CODE_ADD:
      WORD() = (uint16_t)(a + b);
      break;
    case CODE_SUB:
      WORD() = (uint16_t)(a - b);
      break;
    case CODE_WAND:
      WORD() = a & b;
      break;
    case CODE_WOR:
      WORD() = a | b;
      break;
    case CODE_WXOR:
      WORD() = a ^ b;
      break;
    case CODE_ROL:
      WORD() = rotate(a, b);
      break;
    case CODE_MINU:
      WORD() = a < b ? a : b;
      break;
    case CODE_EQ:
      BIT() = a == b;
      break;
    case CODE_LT:
      BIT() = (a ^ 0x8000U) < (b ^ 0x8000U);
      break;
    default:
      BIT() = a < b;
      break;
  }
  return at;
}

/* One scan: all of the code. */
static void run(rung_vm* vm) {
  uint8_t* const bits = vm->bits;
  uint8_t* block = vm->blocks;
  uint8_t* branch = vm->branches;
  const uint8_t* at = vm->code;
  uint8_t r = 0;
  for (;;) {
    const uint8_t opcode = rung_read8(at++);
    switch (opcode) {
      case CODE_END:
        return;
      case CODE_LD:
        r = BIT();
        break;
      case CODE_LDI:
        r = BIT() ^ 1U;
        break;
      case CODE_AND:
        r &= BIT();
        break;
      case CODE_ANI:
        r = (uint8_t)(r & (BIT() ^ 1U));
        break;
      case CODE_OR:
        r |= BIT();
        break;
      case CODE_ORI:
        r = (uint8_t)(r | (BIT() ^ 1U));
        break;
      case CODE_BLD:
        *block++ = r;
        r = BIT();
        break;
      case CODE_BLDI:
        *block++ = r;
        r = BIT() ^ 1U;
        break;
      case CODE_ANB:
        r &= *--block;
        break;
      case CODE_ORB:
        r |= *--block;
        break;
      case CODE_POP:
        r = *--block;
        break;
      case CODE_INV:
        r ^= 1U;
        break;
      case CODE_MPS:
        *branch++ = r;
        break;
      case CODE_MRD:
        r = branch[-1];
        break;
      case CODE_MPP:
        r = *--branch;
        break;
      case CODE_OUT:
        BIT() = r;
        break;
      case CODE_SET:
        BIT() |= r;
        break;
      case CODE_RST:
        BIT() &= r ^ 1U;
        break;
      case CODE_IF: {
        const uint16_t distance = next_number(&at);
        if (!r) at += distance;
        break;
      }
      case CODE_ON:
        BIT() = 1;
        break;
      case CODE_OFF:
        BIT() = 0;
        break;
      default:
        at = run_word(vm, opcode, at);
        break;
    }
  }
}

void rung_vm_reset(rung_vm* vm) {
  const uint8_t* constant = vm->image + RUNG_HEADER_BYTES;
  uint32_t i;
  for (i = 0; i < (uint32_t)vm->ticks_count + vm->driven_count; ++i) vm->times[i] = 0;
  for (i = 0; i < vm->bits_count; ++i) vm->bits[i] = 0;
  for (i = 0; i < vm->first_constant; ++i) vm->words[i] = 0;
  for (; i < vm->words_count; ++i, constant += RUNG_CONSTANT_BYTES) {
    vm->words[i] = rung_read16(constant);
  }
  vm->started = 0;
  vm->error = 0;
}

void rung_vm_scan(rung_vm* vm, uint32_t elapsed_us) {
  drive(vm, elapsed_us);
  vm->error = 0;
  run(vm);
  vm->started = 1;
}

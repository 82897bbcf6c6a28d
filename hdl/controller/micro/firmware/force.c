// SPDX-License-Identifier: Apache-2.0
// Forces: a Modbus point to its entry of the io list, by way of the load file in the flash, as the
// list cannot be read and there is no memory for another one.

#define FIRST_OUTPUT 0x3300
#define FIRST_INPUT 0x3400
#define MOST_FORCES HOLDING_FORCE_LIST_COUNT
#define NO_FORCE 0x7FFF
#define RELEASE 2
#define NONE 0xFFFF

#define force_point HELD(FORCE_POINT)
#define force_value HELD(FORCE_VALUE)
u16 force_wanted;   // the point that a request's force_value will mean
u16 entries_first;  // entries that count
u16 entries_count;

// In records of a space of the program's file: in the bit map the device of a point, in the io list
// the entry of a bit device. NONE: there is none.
static u16 find_record(u16 in_space, u16 what) {
  u16 word;
  u16 hit;
  file(0) = program(2);
  file(1) = program(3);
  file_start(copy);
  at_low = HEADER_WORDS;
  hit = 0;
  while (!file_ended()) {
    file_open();
    word = file_word();
    left = word & 255;
    address = file_word();
    if (word >> 12 != in_space) {
      at_low = at_low + left;
      if (at_low < left) at_high = at_high + 1;
      if (!left) break;
      continue;
    }
    while (left && !file_ended()) {
      left = left - 1;
      word = file_word();
      if (in_space == SPACE_BIT_MAP) {
        if (address == what) return (word & 0x8000) ? word & 0x7FFF : NONE;
      } else if (!(address & 1)) {
        hit = word == what && within(address >> 1, entries_first, entries_count);
      } else if (hit && !(word & 0x8000)) {
        return address >> 1;
      }
      address = address + 1;
    }
  }
  return NONE;
}

static u16 find_entry(void) {
  u16 device;
  wanted_kind = 0;
  find_area(force_wanted);
  if (!room || !within(force_wanted, FIRST_OUTPUT, 0x200)) return NONE;
  entries_first = 0;
  entries_count = latch_count;
  if (force_wanted < FIRST_INPUT) {
    entries_first = refresh_first;
    entries_count = refresh_count;
  }
  device = find_record(SPACE_BIT_MAP, point);
  if (device == NONE) return NONE;
  return find_record(SPACE_IO, device);
}

// Place of a point in the list of those that are forced; force_count: it is not.
static u16 find_force(u16 at_point) {
  u16 k;
  for (k = 0; k < force_count; k = k + 1) {
    if ((force_list(k) & 0x7FFF) == at_point) break;
  }
  return k;
}

// 0 or the exception of a force_value
static u16 check_force(u16 value) {
  if (value > RELEASE) return ILLEGAL_VALUE;
  if (job || no_program) return FAILURE;
  force_entry = find_entry();
  flash_end();
  if (force_entry == NONE) return ILLEGAL_ADDRESS;
  if (value != RELEASE && find_force(force_wanted) == MOST_FORCES) return FAILURE;
  return 0;
}

// As checked
static void force(u16 value) {
  u16 k;
  k = find_force(force_point);
  if (value == RELEASE) {
    if (k < force_count) {
      force_count = force_count - 1;
      force_list(k) = force_list(force_count);
    }
    value = 0;
  } else {
    if (k == force_count) force_count = force_count + 1;
    force_list(k) = force_point | value << 15;
    value = value | 2;
  }
  io_write(REG(FORCE_ENTRY), value << 8 | force_entry);
}

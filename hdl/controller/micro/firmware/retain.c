// SPDX-License-Identifier: Apache-2.0
// What outlives a power cut: devices of the ranges that `keep` marks, and PERSIST values, which are
// a range of their own behind them. They are saved as a record in the ring behind the copies of the
// program:
//
//   retain_id, values (a range behind the other, bits 16 a word), sequence low, high, CRC-32 low,
//   high
//
// in a slot that is a power of two of 64 bytes. The CRC is what is written last: a record torn by a
// power cut is none. The ring is counted in units of 64 bytes.

#define KEEP_RANGES 16
#define KEEP_PERSIST 64
#define KEEP_IS_WORDS 1
#define KEEP_SAVED 2

#define UNIT_BYTES 64
#define RING_UNITS (FLASH_RING_SECTORS * (FLASH_SECTOR_BYTES / UNIT_BYTES))
#define SECTOR_UNITS (FLASH_SECTOR_BYTES / UNIT_BYTES)
#define RECORD_EXTRA 5  // words that are not values
#define NO_UNIT 0xFFFF

#define FIRST_PERSIST_PORT 16
#define MOST_KEPT 2048  // devices in a range

// Most points of one raw exchange: what goes into the buffer as words.
#define MOST_RAW 128

#if SPACE_WORDS != SPACE_BITS + 1
#error "spaces of words are told from those of bits by one bit more"
#endif

// values(): what to do with them
#define SUM 0
#define SAVE 1
#define RESTORE 2
#define CLEAR 3

u16 value_count;  // words saved
u16 slot_units;   // size of a slot; 0: nothing is saved
u16 next_unit;    // where the next record goes
u16 newest_unit;  // where the newest is
u16 sequence_low;
u16 sequence_high;
u16 saved_low;  // CRC of the values saved last
u16 saved_high;
u16 record_low;  // of the record that was read last: its sequence, and the CRC of its values
u16 record_high;
u16 values_low;
u16 values_high;
u16 save_pause;  // seconds until a PERSIST value that could not be saved is tried again

// Sizes from the ranges. What would be more than a sector is not saved: ranges that do not overlap
// never are.
static void lay_out(void) {
  u16 k;
  u16 bytes;
  value_count = 0;
  slot_units = 0;
  for (k = 0; k < KEEP_WORDS; k = k + 4) {
    if (keep(k + 2) > MOST_KEPT) return;
    if (keep(k) & KEEP_SAVED) {
      value_count =
          value_count + ((keep(k) & KEEP_IS_WORDS) ? keep(k + 2) : (keep(k + 2) + 15) >> 4);
    }
  }
  // Bits are read 16 at a time.
  if (value_count && value_count <= FLASH_SECTOR_BYTES / 2 - RECORD_EXTRA &&
      exchange_points >= 16) {
    slot_units = 1;
    bytes = (value_count + RECORD_EXTRA) << 1;
    while (slot_units * UNIT_BYTES < bytes) slot_units = slot_units << 1;
  }
}

// All values one behind the other. 1: the devices cannot be read.
static u16 values(u16 what) {
  u16 k;
  u16 is_words;
  u16 left;
  u16 count;
  u16 have;
  u16 from;
  u16 word;
  for (k = 0; k < KEEP_WORDS; k = k + 4) {
    is_words = keep(k) & KEEP_IS_WORDS;
    read_first = keep(k + 1);
    left = keep(k + 2);
    if (what != CLEAR && !(keep(k) & KEEP_SAVED)) continue;
    if (what >= RESTORE) {
      io_write(REG(LOAD_SPACE), SPACE_BITS + is_words);
      io_write(REG(LOAD_ADDRESS), read_first);
    }
    have = 0;
    while (left) {
      count = 1;
      if (!is_words) count = left < 16 ? left : 16;
      left = left - count;
      if (what >= RESTORE) {
        word = what == RESTORE ? flash_word() : 0;
        while (count) {
          io_write(REG(LOAD_DATA), is_words ? word : word & 1);
          word = word >> 1;
          count = count - 1;
        }
      } else {
        if (!have) {
          have = exchange_points & 0xFFF0;
          if (have > MOST_RAW) have = MOST_RAW;
          if (have > left + count) have = left + count;
          read_count = have;
          if (exchange(READ + RAW + is_words * WORDS)) return 1;
          read_first = read_first + have;
          if (!is_words) have = (have + 15) >> 4;
          from = EXCHANGE_READ;
        }
        word = io_read(from);
        from = from + 1;
        have = have - 1;
        if (what == SAVE)
          flash_put_checked(word);
        else
          crc_word(word);
      }
    }
  }
  return 0;
}

static u16 ring_page(u16 at) { return sector_page(2 * FLASH_COPY_SECTORS) + (at >> 2); }

static void ring_open(u16 at) { flash_at(FLASH_READ, ring_page(at), (at & 3) << 6); }

// Reads the record of the slot at a unit. 1: it is whole, and of this program.
static u16 whole_record(u16 at) {
  u16 n;
  io_write(REG(CRC_CLEAR), 0);
  ring_open(at);
  if (checked_word() != retain_id) return 0;
  for (n = value_count; n; n = n - 1) checked_word();
  values_low = io_read(REG(CRC_LOW));
  values_high = io_read(REG(CRC_HIGH));
  record_low = checked_word();
  record_high = checked_word();
  return crc_follows();
}

static u16 blank_slot(u16 at) {
  u16 n;
  ring_open(at);
  for (n = slot_units * (UNIT_BYTES / 2); n; n = n - 1) {
    if (flash_word() != 0xFFFF) return 0;
  }
  return 1;
}

// Writes a record into the next slot; 1: it did not become whole. The slot is blank, or the first
// of a sector, which is erased: the newest record is in a slot before it, thus in another sector,
// and a ring that has gone round without getting any further ends there.
static u16 write_record(void) {
  u16 at;
  u16 low;
  if ((next_unit & (SECTOR_UNITS - 1)) && !blank_slot(next_unit)) {
    next_unit = ((next_unit | (SECTOR_UNITS - 1)) + 1) & (RING_UNITS - 1);
  }
  at = next_unit;
  if (!(at & (SECTOR_UNITS - 1))) {
    low = at ^ newest_unit;
    if (low < SECTOR_UNITS) return 1;
    flash_erase(ring_page(at));
  }
  next_unit = (at + slot_units) & (RING_UNITS - 1);
  sequence_low = sequence_low + 1;
  if (!sequence_low) sequence_high = sequence_high + 1;
  io_write(REG(CRC_CLEAR), 0);
  flash_write_at(ring_page(at), (at & 3) << 6);
  flash_put_checked(retain_id);
  if (values(SAVE)) {
    flash_wait();
    return 1;
  }
  flash_put_checked(sequence_low);
  flash_put_checked(sequence_high);
  flash_put_crc();
  if (!whole_record(at)) return 1;
  newest_unit = at;
  saved_low = values_low;
  saved_high = values_high;
  saves = saves + 1;
  return 0;
}

// Saves the values, if `always` is not set only when they have changed. 1: it was not possible.
static u16 save(u16 always) {
  flash_failed = 0;
  if (no_program || !slot_units || scan_state() == FAULT) return 1;
  if (!always) {
    io_write(REG(CRC_CLEAR), 0);
    crc_word(retain_id);
    if (values(SUM)) return 1;
    if (io_read(REG(CRC_LOW)) == saved_low && io_read(REG(CRC_HIGH)) == saved_high) return 0;
  }
  // A bad place is left behind.
  if (!write_record()) return 0;
  return flash_failed || scan_state() == FAULT || write_record();
}

// Finds the newest record of the program just loaded and writes its values into the devices.
static void restore(void) {
  u16 at;
  newest_unit = NO_UNIT;
  sequence_low = 0;
  sequence_high = 0;
  next_unit = 0;
  restored = 0;
  save_pause = 0;
  // No record: whatever the values are then, they have not been saved.
  saved_low = 0;
  saved_high = 0;
  if (slot_units) {
    at = 0;
    do {
      if (whole_record(at) && (record_high > sequence_high ||
                               (record_high == sequence_high && record_low >= sequence_low))) {
        newest_unit = at;
        sequence_low = record_low;
        sequence_high = record_high;
        saved_low = values_low;
        saved_high = values_high;
      }
      at = at + slot_units;
    } while (at < RING_UNITS);
  }
  if (newest_unit != NO_UNIT) {
    ring_open(newest_unit);
    flash_word();
    values(RESTORE);
    next_unit = (newest_unit + slot_units) & (RING_UNITS - 1);
    restored = 1;
  }
  flash_end();
  io_write(REG(KEEP_DONE), slot_units != 0);
}

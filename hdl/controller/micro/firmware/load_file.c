// SPDX-License-Identifier: Apache-2.0
// Load files: read from the flash, checked word by word, and loaded into the spaces.

#define FILE_MAGIC 0x5250
#define HEADER_WORDS 16  // of a load file
#define SHORTEST_FILE (HEADER_WORDS + 1)
#define CHECK_WORDS 16384  // words read in a poll

// register load_state
#define LOAD_NONE 0
#define LOAD_UNDER_WAY 1
#define LOAD_DONE 2
#define LOAD_WRONG_CRC 3
#define LOAD_WRONG_KIND 4
#define LOAD_FLASH_ERROR 5
#define LOAD_BAD_RECORD 6

// The last space that a file may have, and whether `space` is more than the firmware's own.
#if FLOW
#define LAST_SPACE SPACE_FLOW_SETUP
#define IN_HARDWARE (space <= SPACE_SETUP || space > SPACE_HOST)
#else
#define LAST_SPACE SPACE_HOST
#define IN_HARDWARE (space <= SPACE_SETUP)
#endif

// What a file's next word is.
#define HEAD 0
#define ADDRESS 1
#define DATA 2
#define NOTHING 3

// The file being read: its header's first words as they should be, the last of them its length; its
// CRC; and where reading is.
u16 file_header[10];
#define FILE_LENGTH 6
#define file(k) file_header[FILE_LENGTH + (k)]
u16 file_page;
u16 at_low;
u16 at_high;
u16 loading;  // else it is checked only
u16 result;   // load_state so far, 0: nothing is wrong
u16 expects;
u16 chunks;
u16 left;  // data words of the record
u16 space;
u16 address;
u16 address_high;

// Where a word of a file is whose first page is `page`, for flash_at.
static u16 page_of(u16 page, u16 low, u16 high) { return page + (high << 9) + (low >> 7); }
static u16 byte_of(u16 low) { return (low & 127) << 1; }

static void file_open(void) {
  flash_at(FLASH_READ, page_of(file_page, at_low, at_high), byte_of(at_low));
}

static u16 file_word(void) {
  at_low = at_low + 1;
  if (!at_low) at_high = at_high + 1;
  return checked_word();
}

static u16 file_ended(void) { return at_low == file(0) && at_high == file(1); }

static void file_start(u16 of_copy) {
  file_page = copy_page(of_copy, 1);
  at_low = 0;
  at_high = 0;
}

static void place(void) {
  if (loading) {
    io_write(REG(LOAD_SPACE), space | address_high << 8);
    io_write(REG(LOAD_ADDRESS), address);
  }
}

static void header_word(u16 word) {
  if (at_low <= FILE_LENGTH + 2) {
    if (word != file_header[at_low - 1]) result = LOAD_WRONG_KIND;
  } else if (at_low == 9) {
    if (loading) retain_id = word;
  } else if (at_low == 11) {
    chunks = word;
    if (!within(word, 1, 8)) result = LOAD_BAD_RECORD;
  }
}

// What the firmware itself wants to know of a program.
static void note(u16 word) {
  switch (space) {
    case SPACE_PORTS:
      word = word >> 8 & 127;
      if (!address && word > FIRST_PERSIST_PORT) {
        keep(KEEP_PERSIST) = KEEP_SAVED | KEEP_IS_WORDS;
        keep(KEEP_PERSIST + 1) = WORD_DEVICES - word;
        keep(KEEP_PERSIST + 2) = word - FIRST_PERSIST_PORT;
      }
      break;
    case SPACE_SETUP:
      if (address <= SETUP_EXCHANGE_POINTS) settings[address] = word;
      break;
    case SPACE_KEEP:
      keep(address) = word;
      break;
    case SPACE_HOST:
      if (address <= HOST_RETAIN_ID) settings[HOST_SETTINGS + address] = word;
      // baud, parity and silence stand in the same order in both
      if (within(address, HOST_BAUD_LOW, 5)) {
        io_write(REG(LINE_BAUD_LOW) - HOST_BAUD_LOW + address, word);
      }
      break;
  }
}

static void data_word(u16 word) {
  if (space == SPACE_KEEP && (address_high || address >= KEEP_PERSIST)) {
    result = LOAD_BAD_RECORD;
    return;
  }
  if (loading) {
    if (IN_HARDWARE) io_write(REG(LOAD_DATA), word);
    note(word);
  }
  if (space == SPACE_STEPS && (address & 7) == chunks - 1) {
    address = (address | 7) + 1;
    if (!address) address_high = address_high + 1;
    place();
  } else {
    address = address + 1;
  }
  left = left - 1;
  if (!left) expects = HEAD;
}

static void take_word(u16 word) {
  if (result) return;
  if (!at_high && at_low <= HEADER_WORDS) {
    header_word(word);
    return;
  }
  switch (expects) {
    case HEAD:
      left = word & 255;
      expects = ADDRESS;
      if (!word && space == SPACE_LENGTH) {
        expects = NOTHING;
      } else if (!left || word >> 12 > LAST_SPACE) {
        result = LOAD_BAD_RECORD;
      }
      space = word >> 12;
      address_high = word >> 8 & 15;
      break;
    case ADDRESS:
      address = word;
      place();
      expects = DATA;
      break;
    case DATA:
      data_word(word);
      break;
    default:
      result = LOAD_BAD_RECORD;
  }
}

#if FLOW
// Zeros to `count` words of a space.
static void clear_space(u16 number, u16 first, u16 count) {
  io_write(REG(LOAD_SPACE), number);
  io_write(REG(LOAD_ADDRESS), first);
  while (count) {
    count = count - 1;
    io_write(REG(LOAD_DATA), 0);
  }
}
#endif

static void check_start(u16 of_copy, u16 and_load) {
  loading = and_load;
  file_start(of_copy);
  result = 0;
  expects = HEAD;
  space = SPACE_HOST;
  io_write(REG(CRC_CLEAR), 0);
#if FLOW
  if (and_load) {
    // A program names its own tasks and boards only.
    clear_space(SPACE_FLOW_SETUP, FLOW_SETUP_ENABLE, 1);
    clear_space(SPACE_FLOW_SETUP, FLOW_FIRST_BOARD, FLOW_BOARDS);
    clear_space(SPACE_FLOW_TASKS, 0, FLOW_TASKS);
  }
#endif
}

static void check_words(u16 count) {
  file_open();
  while (count && !file_ended()) {
    count = count - 1;
    take_word(file_word());
  }
  flash_end();
}

static u16 check_result(void) {
  if (io_read(REG(CRC_LOW)) != file(2) || io_read(REG(CRC_HIGH)) != file(3)) return LOAD_WRONG_CRC;
  if (!result && expects != NOTHING) return LOAD_BAD_RECORD;
  return result;
}

static u16 check_file(u16 of_copy, u16 and_load) {
  check_start(of_copy, and_load);
  while (!file_ended()) check_words(CHECK_WORDS);
  return check_result();
}

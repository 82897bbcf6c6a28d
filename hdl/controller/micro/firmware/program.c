// SPDX-License-Identifier: Apache-2.0
// The program: load files in the flash's two copies, checked and loaded, at power-up and after a
// download.

#define FILE_MAGIC 0x5250
#define HEADER_MAGIC 0x5243
#define HEADER_WORDS 16  // of a load file
#define SHORTEST_FILE (HEADER_WORDS + 1)
#define FIRST_FORCE_ENTRIES 256

// register load_state
#define LOAD_NONE 0
#define LOAD_UNDER_WAY 1
#define LOAD_DONE 2
#define LOAD_WRONG_CRC 3
#define LOAD_WRONG_KIND 4
#define LOAD_FLASH_ERROR 5
#define LOAD_BAD_RECORD 6

// Faults of the firmware's own
#define NO_PROGRAM 2
#define NOT_LOADABLE 3

// What a file's next word is.
#define HEAD 0
#define ADDRESS 1
#define DATA 2
#define NOTHING 3

// Stages of a commit: one a poll, or more of them for CHECK, so that requests are answered between
// them.
#define JOB_NONE 0
#define JOB_CHECK 1
#define JOB_STOP 2
#define JOB_LOAD 3
#define JOB_START 4

#define CHECK_WORDS 16384  // words read in a poll

u16 program[6];  // of the program that is loaded: generation, length, CRC, low words first
u16 header[6];   // the same of the copy that was looked at last
u16 load[4];     // registers load_length, load_crc
u16 load_state;
u16 erased[FLASH_COPY_SECTORS];  // sectors of the copy being written

// The file being read: length and CRC as they should be, and where reading is.
u16 file[4];
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

static void file_open(void) {
  flash_at(FLASH_READ, file_page + (at_high << 9) + (at_low >> 7), (at_low & 127) << 1);
}

static u16 file_word(void) {
  at_low = at_low + 1;
  if (!at_low) at_high = at_high + 1;
  return checked_word();
}

static u16 file_ended(void) { return at_low == file[0] && at_high == file[1]; }

static void file_start(u16 of_copy) {
  file_page = sector_page(of_copy * FLASH_COPY_SECTORS + 1);
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
  u16 right;
  right = word;
  switch (at_low) {
    case 1:
      right = FILE_MAGIC;
      break;
    case 2:
      right = 1;
      break;
    case 3:
      right = TABLES;
      break;
    case 4:
      right = io_read(REG(CONFIG_ID));
      break;
    case 5:
      right = io_read(REG(BOARD_ID));
      break;
    case 6:
      right = io_read(REG(MPU));
      break;
    case 7:
      right = file[0];
      break;
    case 8:
      right = file[1];
      break;
    case 9:
      if (loading) retain_id = word;
      break;
    case 11:
      chunks = word;
      if (!within(word, 1, 8)) result = LOAD_BAD_RECORD;
      break;
  }
  if (word != right) result = LOAD_WRONG_KIND;
}

// What the firmware itself wants to know of a program.
static void note(u16 word) {
  switch (space) {
    case SPACE_PORTS:
      word = word >> 8 & 127;
      if (!address && word > FIRST_PERSIST_PORT) {
        keep[KEEP_PERSIST] = KEEP_SAVED | KEEP_IS_WORDS;
        keep[KEEP_PERSIST + 1] = WORD_DEVICES - word;
        keep[KEEP_PERSIST + 2] = word - FIRST_PERSIST_PORT;
      }
      break;
    case SPACE_SETUP:
      switch (address) {
        case SETUP_LATCH_COUNT:
          latch_count = word;
          break;
        case SETUP_REFRESH_FIRST:
          refresh_first = word;
          break;
        case SETUP_REFRESH_COUNT:
          refresh_count = word;
          break;
        case SETUP_EXCHANGE_POINTS:
          exchange_points = word;
          break;
      }
      break;
    case SPACE_KEEP:
      keep[address] = word;
      break;
    case SPACE_HOST:
      switch (address) {
        case HOST_UNIT:
          unit = word;
          break;
        case HOST_POLICY:
          policy = word;
          break;
        case HOST_SAVE_SECONDS:
          save_seconds = word;
          break;
        case HOST_RETAIN_ID:
          retain_id = word;
          break;
        default:
          // baud, parity and silence stand in the same order in both
          if (within(address, HOST_BAUD_LOW, 5)) {
            io_write(REG(LINE_BAUD_LOW) - HOST_BAUD_LOW + address, word);
          }
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
    if (space <= SPACE_SETUP) io_write(REG(LOAD_DATA), word);
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
      } else if (!left || word >> 12 > SPACE_HOST) {
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

static void check_start(u16 of_copy, u16 and_load) {
  loading = and_load;
  file_start(of_copy);
  result = 0;
  expects = HEAD;
  space = SPACE_HOST;
  io_write(REG(CRC_CLEAR), 0);
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
  if (io_read(REG(CRC_LOW)) != file[2] || io_read(REG(CRC_HIGH)) != file[3]) return LOAD_WRONG_CRC;
  if (!result && expects != NOTHING) return LOAD_BAD_RECORD;
  return result;
}

static u16 check_file(u16 of_copy, u16 and_load) {
  check_start(of_copy, and_load);
  while (!file_ended()) check_words(CHECK_WORDS);
  return check_result();
}

static void fill(u16 in_space, u16 count) {
  io_write(REG(LOAD_SPACE), in_space);
  io_write(REG(LOAD_ADDRESS), 0);
  while (count) {
    io_write(REG(LOAD_DATA), 0);
    count = count - 1;
  }
}

// As after reset, but for the registers of the line.
static void clear_all(void) {
  u16 n;
  no_program = NO_PROGRAM;
  fill(SPACE_BITS, BIT_DEVICES);
  fill(SPACE_WORDS, WORD_DEVICES);
  fill(SPACE_PORTS, 3);
  fill(SPACE_BIT_MAP, BIT_POINTS);
  fill(SPACE_WORD_MAP, WORD_POINTS);
  fill(SPACE_SETUP, SETUP_OUTPUT + SETUP_OUTPUT_COUNT);
  for (n = 0; n < FIRST_FORCE_ENTRIES; n = n + 1) io_write(REG(FORCE_ENTRY), n);
  for (n = 0; n < KEEP_WORDS; n = n + 1) keep[n] = 0;
  for (n = 0; n < 6; n = n + 1) program[n] = 0;
  force_count = 0;
  exchange_points = 0;
  latch_count = 0;
  refresh_count = 0;
  unit = 1;
  policy = 0;
  save_seconds = 0;
  slot_units = 0;
  restored = 0;
  io_write(REG(KEEP_DONE), 0);
}

// Stops after the scan under way. A processor that does not end its scan is reset.
static void stop(void) {
  u16 start_at;
  start_at = io_read(REG(MILLISECONDS));
  io_write(REG(SCAN_COMMAND), SCAN_STOP);
  while (!(io_read(REG(SCAN_STATUS)) & SCAN_IDLE)) {
    if (scan_state() == FAULT) {
      io_write(REG(SCAN_COMMAND), SCAN_LEAVE_FAULT);
    } else if (milliseconds_since(start_at) > PATIENCE_MS) {
      io_write(REG(FAULT_SET), 0);
    }
  }
}

// Runs from stop, if the switch allows it, with the devices as they are.
static void start(void) {
  if (!no_program && (io_read(REG(SCAN_STATUS)) & SCAN_SWITCH)) {
    io_write(REG(SCAN_FIRST), 0);
    io_write(REG(SCAN_COMMAND), SCAN_RUN);
  }
}

static void clear_devices(u16 is_words, u16 count) {
  u16 device;
  u16 k;
  io_write(REG(LOAD_SPACE), is_words ? SPACE_WORDS : SPACE_BITS);
  device = 0;
  while (device < count) {
    for (k = 0; k < KEEP_WORDS; k = k + 4) {
      if ((keep[k] & KEEP_IS_WORDS) == is_words && within(device, keep[k + 1], keep[k + 2])) break;
    }
    if (k == KEEP_WORDS) {
      io_write(REG(LOAD_ADDRESS), device);
      io_write(REG(LOAD_DATA), 0);
    }
    device = device + 1;
  }
}

// STOP to RUN
static void run(void) {
  if (no_program) return;
  clear_devices(0, BIT_DEVICES);
  clear_devices(1, WORD_DEVICES);
  start();
}

static u16 length_fits(u16 low, u16 high) {
  if (high) return high == 1 && low <= 0xF800;
  return low >= SHORTEST_FILE;
}

// 1: the copy has a whole header, now in `header`.
static u16 read_header(u16 of_copy) {
  u16 n;
  io_write(REG(CRC_CLEAR), 0);
  flash_at(FLASH_READ, sector_page(of_copy * FLASH_COPY_SECTORS), 0);
  if (checked_word() != HEADER_MAGIC) return 0;
  for (n = 0; n < 6; n = n + 1) header[n] = checked_word();
  return crc_follows() && length_fits(header[2], header[3]);
}

// Loads a file that was checked, into a processor that is stopped. Else a load_state.
static u16 load_file(u16 of_copy) {
  u16 wrong;
  clear_all();
  wrong = check_file(of_copy, 1);
  if (wrong) {
    clear_all();
    return wrong;
  }
  lay_out();
  copy = of_copy;
  return 0;
}

// The program whose header was just read is the one that is loaded.
static void adopt_header(void) {
  u16 n;
  for (n = 0; n < 6; n = n + 1) program[n] = header[n];
  no_program = 0;
}

// Loads the newest whole program of the flash, and the values saved of it; start() runs it.
static void boot(void) {
  u16 first;
  u16 low;
  u16 high;
  u16 n;
  u16 why;
  stop();
  clear_all();
  first = 1;
  if (read_header(0)) {
    low = header[0];
    high = header[1];
    if (!read_header(1) || header[1] < high || (header[1] == high && header[0] < low)) first = 0;
  }
  why = NO_PROGRAM;
  for (n = 0; n < 2; n = n + 1) {
    if (read_header(first ^ n)) {
      why = NOT_LOADABLE;
      for (low = 0; low < 4; low = low + 1) file[low] = header[low + 2];
      if (!check_file(first ^ n, 0) && !load_file(first ^ n)) {
        adopt_header();
        restore();
        return;
      }
    }
  }
  no_program = why;
  copy = 0;
  flash_end();
  io_write(REG(FAULT_SET), 0);
}

// Makes a copy whose file has been checked and loaded the program of the next power-up. 1: the
// flash does not hold it.
static u16 write_header(u16 of_copy) {
  u16 low;
  u16 high;
  u16 n;
  low = 0;
  high = 0;
  if (read_header(of_copy ^ 1)) {
    low = header[0];
    high = header[1];
  }
  low = low + 1;
  if (!low) high = high + 1;
  io_write(REG(CRC_CLEAR), 0);
  flash_write_at(sector_page(of_copy * FLASH_COPY_SECTORS), 0);
  flash_put_checked(HEADER_MAGIC);
  flash_put_checked(low);
  flash_put_checked(high);
  for (n = 0; n < 4; n = n + 1) flash_put_checked(file[n]);
  flash_put_crc();
  return !read_header(of_copy) || header[0] != low || header[1] != high;
}

static void load_failed(u16 state) {
  load_state = state;
  job = JOB_NONE;
  if ((policy & STOP_AFTER_FAILURE) && scan_state() == RUNNING)
    io_write(REG(SCAN_COMMAND), SCAN_STOP);
}

// Half way into another program: what the flash holds, which is the one before, or the new one if
// its header was written after all.
static void load_again(u16 state) {
  load_failed(state);
  boot();
  if (!(policy & STOP_AFTER_FAILURE)) start();
}

static void begin_load(void) {
  u16 n;
  flash_failed = 0;
  load_state = LOAD_UNDER_WAY;
  flash_erase(sector_page((copy ^ 1) * FLASH_COPY_SECTORS));
  for (n = 0; n < FLASH_COPY_SECTORS; n = n + 1) erased[n] = 0;
  if (flash_failed) load_failed(LOAD_FLASH_ERROR);
}

static void begin_commit(void) {
  u16 n;
  for (n = 0; n < 4; n = n + 1) file[n] = load[n];
  check_start(copy ^ 1, 0);
  job = JOB_CHECK;
}

static void advance_job(void) {
  u16 wrong;
  switch (job) {
    case JOB_CHECK:
      check_words(CHECK_WORDS);
      if (file_ended()) {
        wrong = check_result();
        job = JOB_STOP;
        if (wrong) load_failed(wrong);
      }
      break;
    case JOB_STOP:
      stop();
      save(0);
      job = JOB_LOAD;
      break;
    case JOB_LOAD:
      // The line may be set anew: answers go out first.
      if (io_read(REG(LINE_STATUS)) & 2) break;
      job = JOB_START;
      wrong = load_file(copy ^ 1);
      if (!wrong && write_header(copy)) wrong = LOAD_FLASH_ERROR;
      if (wrong)
        load_again(wrong);
      else
        adopt_header();
      break;
    default:
      restore();
      start();
      load_state = LOAD_DONE;
      job = JOB_NONE;
  }
}

// SPDX-License-Identifier: Apache-2.0
// The program: the flash's two copies, RUN and STOP, boot, download and commit.

#define HEADER_MAGIC 0x5243
#define FIRST_FORCE_ENTRIES 256

// Faults of the firmware's own
#define NO_PROGRAM 2
#define NOT_LOADABLE 3

// Stages of a commit: one a poll, or more of them for CHECK, so that requests are answered between
// them.
#define JOB_NONE 0
#define JOB_CHECK 1
#define JOB_STOP 2
#define JOB_LOAD 3
#define JOB_START 4

u16 header[6];                   // as program(), of the copy that was looked at last
u16 erased[FLASH_COPY_SECTORS];  // sectors of the copy being written

static void fill(u16 in_space, u16 count) {
  io_write(REG(LOAD_SPACE), in_space);
  io_write(REG(LOAD_ADDRESS), 0);
  while (count) {
    io_write(REG(LOAD_DATA), 0);
    count = count - 1;
  }
}

u16 force_entry;  // entry of the point that is forced

static void release_all(void) {
  force_count = 0;
  for (force_entry = 0; force_entry < FIRST_FORCE_ENTRIES; force_entry = force_entry + 1) {
    io_write(REG(FORCE_ENTRY), force_entry);
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
  fill(SPACE_SETUP, SETUP_OUTPUT);  // outputs stay: a load file sets them all
  release_all();
  for (n = 0; n < SETTINGS; n = n + 1) settings[n] = 0;
  for (n = 0; n < 6; n = n + 1) program(n) = 0;
  unit = 1;
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
    } else if (milliseconds_since(start_at) >= PATIENCE_MS) {
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
  io_write(REG(LOAD_SPACE), SPACE_BITS + is_words);
  device = 0;
  while (device < count) {
    for (k = 0; k < KEEP_WORDS; k = k + 4) {
      if ((keep(k) & KEEP_IS_WORDS) == is_words && within(device, keep(k + 1), keep(k + 2))) break;
    }
    if (k == KEEP_WORDS) {
      io_write(REG(LOAD_ADDRESS), device);
      io_write(REG(LOAD_DATA), 0);
    }
    device = device + 1;
  }
}

// STOP to RUN. Without a program the devices are 0 already, and start() does nothing.
static void run(void) {
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
  flash_at(FLASH_READ, copy_page(of_copy, 0), 0);
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
  for (n = 0; n < 6; n = n + 1) program(n) = header[n];
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
      for (low = 0; low < 4; low = low + 1) file(low) = header[low + 2];
      if (!check_file(first ^ n, 0) && !load_file(first ^ n)) {
        adopt_header();
        restore();
        return;
      }
    }
  }
  clear_all();
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
  flash_write_at(copy_page(of_copy, 0), 0);
  flash_put_checked(HEADER_MAGIC);
  flash_put_checked(low);
  flash_put_checked(high);
  for (n = 0; n < 4; n = n + 1) flash_put_checked(file(n));
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
  flash_erase(copy_page(copy ^ 1, 0));
  for (n = 0; n < FLASH_COPY_SECTORS; n = n + 1) erased[n] = 0;
  if (flash_failed) load_failed(LOAD_FLASH_ERROR);
}

static void begin_commit(void) {
  u16 n;
  for (n = 0; n < 4; n = n + 1) file(n) = load(n);
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

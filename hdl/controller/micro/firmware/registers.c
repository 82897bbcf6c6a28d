// SPDX-License-Identifier: Apache-2.0
// The controller's holding registers, 0xE000 to 0xE151, and with flow tasks those to 0xE1BF: those
// between them that the table does not have read 0 and cannot be written. Writes of a request are
// all checked before the first takes effect.

#define BEHIND_WINDOW (HOLDING_WINDOW + HOLDING_WINDOW_COUNT)
#if FLOW
#define HOLDING_REGISTERS (HOLDING_FLOW + HOLDING_FLOW_COUNT - FIRST_HOLDING)
#else
#define HOLDING_REGISTERS (BEHIND_WINDOW - FIRST_HOLDING)
#endif

// register command
#define COMMAND_RUN 1
#define COMMAND_STOP 2
#define COMMAND_ONE 3
#define COMMAND_CLEAR_STATISTICS 4
#define COMMAND_LEAVE_FAULT 5
#define COMMAND_SAVE 6
#define COMMAND_RELEASE 7
#define COMMAND_CLEAR_KEPT 8

// register load_command
#define LOAD_BEGIN 1
#define LOAD_COMMIT 2
#define LOAD_ABORT 3

u16 window_wanted[2];  // what window() will be when the request is carried out

// Numbers of registers behind the first
#define NUMBER(name) (HOLDING_##name - FIRST_HOLDING)
#define LOWER NUMBER(FORCE_LIST)

// What never changes: registers, and what a load file has to say of its kind.
static void describe(void) {
  HELD(IDENTITY) = 0x5247;
  file_header[0] = FILE_MAGIC;
  HELD(INTERFACE) = 1;
  file_header[1] = 1;
  HELD(TABLES) = TABLES;
  file_header[2] = HELD(TABLES);
  HELD(CONFIG) = io_read(REG(CONFIG_ID));
  file_header[3] = HELD(CONFIG);
  HELD(BOARD) = io_read(REG(BOARD_ID));
  file_header[4] = HELD(BOARD);
  HELD(MPU) = io_read(REG(MPU));
  file_header[5] = HELD(MPU);
}

// A word of the running program's file: n of the window. The first of a request sets out to read
// there.
static u16 window_word(u16 n, u16 first) {
  u16 low;
  u16 high;
  low = window(0) + n;
  high = window(1);
  if (low < n) high = high + 1;
  if (high > program(3) || (high == program(3) && low >= program(2))) return 0;
  if (first) {
    // A commit may be checking the other copy: its place stays as it is.
    flash_at(FLASH_READ, page_of(copy_page(copy, 1), low, high), byte_of(low));
  }
  return flash_word();
}

#if FLOW
#define FLOW_NUMBER(name) (REG_##name - REG_FLOW_PC_RESOURCE)

// Registers of the flow tasks, by their numbers behind the first: they are the hardware's own.
static u16 flow_read(u16 at, u16 first) {
  at = at + REG(FLOW_PC_RESOURCE);
  // A high word is that of the low word read before it.
  if (first) {
    if (at == REG(FLOW_ROUNDS_HIGH) || at == REG(FLOW_ROUND_MAX_HIGH)) io_read(at - 1);
  }
  return io_read(at);
}

static u16 flow_write(u16 really, u16 at, u16 value) {
  u16 command;  // it is the PC's command
  command = at <= FLOW_NUMBER(FLOW_PC_CONTROL) || at >= FLOW_NUMBER(FLOW_PC_DATA);
  if (!command && !within(at, FLOW_NUMBER(FLOW_BREAK_STEP), 3) &&
      at != FLOW_NUMBER(FLOW_TASK_CONTINUE)) {
    return ILLEGAL_ADDRESS;
  }
  if (really)
    io_write(at + REG(FLOW_PC_RESOURCE), value);
  else if (command && io_read(REG(FLOW_PC_CONTROL)))
    return BUSY;
  return 0;
}
#endif

static u16 flags(void) {
  u16 status;
  status = io_read(REG(SCAN_STATUS));
  return (status >> 3 & 1) | (io_read(REG(SCAN_OVERRUNS)) ? 2 : 0) | (force_count ? 4 : 0) |
         restored << 3 | (status >> 1 & 16) | copy << 5;
}

// A register by its number; first: the request's reading begins here.
static u16 holding_read(u16 at, u16 first) {
#if FLOW
  if (at >= NUMBER(FLOW)) return flow_read(at - NUMBER(FLOW), first);
  if (at >= BEHIND_WINDOW - FIRST_HOLDING) return 0;
#endif
  if (at >= NUMBER(WINDOW)) return window_word(at - NUMBER(WINDOW), first || at == NUMBER(WINDOW));
  if (at >= NUMBER(LOAD_COMMAND)) return upper[at - NUMBER(LOAD_COMMAND)];
  if (at >= LOWER) {
    if (at - LOWER >= MOST_FORCES) return 0;
    return at - LOWER < force_count ? held[at] : NO_FORCE;
  }
  // Registers that stand in the same order on both sides
  if (within(at, NUMBER(INPUTS), 8)) return io_read(REG(INPUTS) - NUMBER(INPUTS) + at);
  if (within(at, NUMBER(BAD_FRAMES), 3)) {
    return io_read(REG(LINE_BAD_CRC) - NUMBER(BAD_FRAMES) + at);
  }
  if (within(at, NUMBER(SCAN_COUNT), 9)) {
    at = REG(SCAN_COUNT_LOW) - NUMBER(SCAN_COUNT) + at;
    // A high word is that of the low word read before it.
    if (first) io_read(at & 0xFFFE);
    return io_read(at);
  }
  switch (at) {
    case NUMBER(STATE):
      return no_program ? 4 : scan_state();
    case NUMBER(FAULT):
      return no_program ? no_program : io_read(REG(SCAN_STATUS)) >> 8;
    case NUMBER(FLAGS):
      return flags();
    case NUMBER(EXCHANGE_POINTS):
      return exchange_points;
  }
  return held[at];
}

static u16 check_command(u16 value) {
  u16 status;
  status = io_read(REG(SCAN_STATUS));
  if (!within(value, 1, 8)) return ILLEGAL_VALUE;
  if (job) return FAILURE;
  switch (value) {
    case COMMAND_STOP:
    case COMMAND_CLEAR_STATISTICS:
    case COMMAND_RELEASE:
      return 0;
    case COMMAND_RUN:
      if ((status & 3) == FAULT || !(status & SCAN_SWITCH)) return FAILURE;
      break;
    case COMMAND_ONE:
      if (!(status & SCAN_SWITCH)) return FAILURE;
      // fall through
    case COMMAND_CLEAR_KEPT:
      if (!(status & SCAN_IDLE)) return FAILURE;
      break;
  }
  return no_program ? FAILURE : 0;
}

static void do_command(u16 value) {
  HELD(COMMAND) = value;
  switch (value) {
    case COMMAND_RUN:
      // One scan may be under way: it ends first.
      if (scan_state() != RUNNING) {
        stop();
        run();
      }
      break;
    case COMMAND_STOP:
      if (scan_state() != FAULT) stop();
      break;
    case COMMAND_ONE:
      io_write(REG(SCAN_COMMAND), SCAN_ONE);
      break;
    case COMMAND_CLEAR_STATISTICS:
      io_write(REG(SCAN_COMMAND), SCAN_CLEAR);
      break;
    case COMMAND_LEAVE_FAULT:
      if (scan_state() == FAULT) io_write(REG(SCAN_COMMAND), SCAN_LEAVE_FAULT);
      break;
    case COMMAND_SAVE:
      save_request = 2;
      break;
    case COMMAND_RELEASE:
      release_all();
      break;
    case COMMAND_CLEAR_KEPT:
      values(CLEAR);
      save_request = 1;
      break;
  }
}

static u16 check_load(u16 value) {
  if (!within(value, 1, 3)) return ILLEGAL_VALUE;
  if (job || (value == LOAD_COMMIT && load_state != LOAD_UNDER_WAY)) return FAILURE;
  if (value != LOAD_ABORT && !length_fits(load(0), load(1))) return ILLEGAL_VALUE;
  return 0;
}

static u16 do_load(u16 value) {
  UPPER_FROM(LOAD_COMMAND, 0) = value;
  switch (value) {
    case LOAD_BEGIN:
      begin_load();
      return load_state == LOAD_UNDER_WAY ? 0 : FAILURE;
    case LOAD_COMMIT:
      begin_commit();
      break;
    default:
      load_state = LOAD_NONE;
  }
  return 0;
}

// Words that a window at window_wanted has: 64, or less at the end of the file; 0: there can be
// none.
static u16 window_size(void) {
  u16 page;
  u16 pages;
  if (window_wanted[0] & (HOLDING_WINDOW_COUNT - 1) || window_wanted[1] > 1 ||
      !length_fits(load(0), load(1))) {
    return 0;
  }
  page = window_wanted[1] << 10 | window_wanted[0] >> 6;
  pages = load(1) << 10 | load(0) >> 6;
  if (page < pages) return HOLDING_WINDOW_COUNT;
  return page == pages ? load(0) & (HOLDING_WINDOW_COUNT - 1) : 0;
}

// The sector that the window lies in is erased when the first window of it comes.
static void window_begin(void) {
  u16 sector;
  flash_failed = 0;
  sector = (window(1) << 5 | window(0) >> 11) + 1;
  if (!erased[sector]) {
    flash_erase(copy_page(copy ^ 1, sector));
    erased[sector] = 1;
  }
  flash_write_at(page_of(copy_page(copy ^ 1, 1), window(0), window(1)), byte_of(window(0)));
}

// Checks a write, or `really` carries out what was checked; `count` registers are written from this
// one on. 0 or an exception.
static u16 holding_write(u16 really, u16 at, u16 value, u16 count) {
#if FLOW
  if (at >= NUMBER(FLOW)) return flow_write(really, at - NUMBER(FLOW), value);
  if (at >= BEHIND_WINDOW - FIRST_HOLDING) return ILLEGAL_ADDRESS;
#endif
  if (at >= NUMBER(WINDOW)) {
    if (!really) {
      if (job || load_state != LOAD_UNDER_WAY) return FAILURE;
      // The words behind the first belong to it.
      return at > NUMBER(WINDOW) || count == window_size() ? 0 : ILLEGAL_VALUE;
    }
    if (at == NUMBER(WINDOW)) window_begin();
    flash_put(value);
    if (count == 1) {
      flash_wait();
      if (flash_failed) {
        load_failed(LOAD_FLASH_ERROR);
        return FAILURE;
      }
    }
    return 0;
  }
  if (at >= NUMBER(WINDOW_OFFSET)) {
    at = at - NUMBER(WINDOW_OFFSET);
    window_wanted[at] = value;
    if (really) window(at) = value;
    return 0;
  }
  if (within(at, NUMBER(LOAD_LENGTH), 4)) {
    if (job) return FAILURE;
    if (really) load(at - NUMBER(LOAD_LENGTH)) = value;
    return 0;
  }
  switch (at) {
    case NUMBER(COMMAND):
      if (!really) return check_command(value);
      do_command(value);
      return 0;
    case NUMBER(FORCE_POINT):
      force_wanted = value;
      if (really) force_point = value;
      return 0;
    case NUMBER(FORCE_VALUE):
      if (!really) return check_force(value);
      force_value = value;
      force(value);
      return 0;
    case NUMBER(LOAD_COMMAND):
      if (!really) return check_load(value);
      return do_load(value);
  }
  return ILLEGAL_ADDRESS;
}

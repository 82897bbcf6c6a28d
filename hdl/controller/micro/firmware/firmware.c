// SPDX-License-Identifier: Apache-2.0
// The controller's firmware: what its micro-sequencer runs (README.md). The compiler's C subset:
// every value is a u16, globals are 0 at reset, no arrays but global ones, no pointers, no
// recursion. The order of the files is such that everything is defined before its use.
//
// RUNG_CONFIG names the configuration (configs.toml), which decides the device map.
#include "rung_controller.h"

typedef unsigned short u16;

#define PASTE(a, b) a##b
#define OF_CONFIG(name, config) PASTE(name, config)
#define AREAS OF_CONFIG(AREAS_, RUNG_CONFIG)
#define BIT_POINTS OF_CONFIG(BIT_POINTS_, RUNG_CONFIG)
#define WORD_POINTS OF_CONFIG(WORD_POINTS_, RUNG_CONFIG)
#define BIT_DEVICES OF_CONFIG(BIT_DEVICES_, RUNG_CONFIG)
#define WORD_DEVICES OF_CONFIG(WORD_DEVICES_, RUNG_CONFIG)
#define FLOW OF_CONFIG(FLOW_, RUNG_CONFIG)  // 1: there is the hardware of flow tasks

#define REG(name) (MICRO_REGISTERS + REG_##name)

// Modbus exceptions
#define ILLEGAL_FUNCTION 1
#define ILLEGAL_ADDRESS 2
#define ILLEGAL_VALUE 3
#define FAILURE 4
#define BUSY 6

// Commands and states of the scan controller, see scan_command and scan_status.
#define SCAN_RUN 1
#define SCAN_STOP 2
#define SCAN_ONE 3
#define SCAN_CLEAR 4
#define SCAN_LEAVE_FAULT 5
#define STOPPED 0
#define RUNNING 1
#define FAULT 3
#define SCAN_IDLE 4
#define SCAN_SWITCH 8

// Bits of `policy`
#define STOP_AFTER_FAILURE 1
#define STOP_AFTER_POWER_UP 2

// No loop waits longer than this for a scan to end: a program with a minimum period of more than a
// minute has no host.
#define PATIENCE_MS 60000

#ifndef RUNG_NATIVE
u16 io_read(u16 address);
void io_write(u16 address, u16 value);
#endif

// Holding registers by their numbers behind the first, those that are more than a variable left
// out: registers.c. The upper ones are a table of their own.
#define FIRST_HOLDING HOLDING_IDENTITY
#define FIRST_UPPER HOLDING_LOAD_COMMAND
u16 held[HOLDING_FORCE_LIST + HOLDING_FORCE_LIST_COUNT - FIRST_HOLDING];
u16 upper[HOLDING_WINDOW - FIRST_UPPER];

#define HELD(name) held[HOLDING_##name - FIRST_HOLDING]
#define HELD_FROM(name, k) held[HOLDING_##name - FIRST_HOLDING + (k)]
#define UPPER_FROM(name, k) upper[HOLDING_##name - FIRST_UPPER + (k)]
#define frames HELD(FRAMES)
#define exceptions HELD(EXCEPTIONS)
#define saves HELD(SAVES)
#define force_count HELD(FORCE_COUNT)
#define force_list(k) HELD_FROM(FORCE_LIST, k)
// of the program that is loaded: generation, length, CRC, low words first
#define program(k) HELD_FROM(PROGRAM_GENERATION, k)
#define load_state UPPER_FROM(LOAD_STATE, 0)
#define load(k) UPPER_FROM(LOAD_LENGTH, k)  // registers load_length, load_crc
#define window(k) UPPER_FROM(WINDOW_OFFSET, k)

// What the program that is loaded says: the firmware's parts of its spaces setup and host,
// and what `keep` says.
#define KEEP_WORDS 68  // four words a range, and that of PERSIST
#define HOST_SETTINGS (SETUP_EXCHANGE_POINTS + 1)
#define KEEP_SETTINGS (HOST_SETTINGS + HOST_RETAIN_ID + 1)
#define SETTINGS (KEEP_SETTINGS + KEEP_WORDS)
u16 settings[SETTINGS];
#define keep(k) settings[KEEP_SETTINGS + (k)]
#define exchange_points settings[SETUP_EXCHANGE_POINTS]
#define latch_count settings[SETUP_LATCH_COUNT]
#define refresh_first settings[SETUP_REFRESH_FIRST]
#define refresh_count settings[SETUP_REFRESH_COUNT]
#define unit settings[HOST_SETTINGS + HOST_UNIT]
#define policy settings[HOST_SETTINGS + HOST_POLICY]  // bits of the two that follow
#define save_seconds settings[HOST_SETTINGS + HOST_SAVE_SECONDS]
#define retain_id settings[HOST_SETTINGS + HOST_RETAIN_ID]

u16 no_program;  // 0: there is one; else the fault that register `fault` shows
u16 copy;        // of the flash, that runs

u16 restored;      // latched devices are
u16 save_request;  // 1 if changed, 2 in any case
u16 job;           // stage of a commit, see program.c

// a is one of `count` numbers from `first` on.
#define within(a, first, count) ((u16)((a) - (first)) < (count))

static u16 scan_state(void) { return io_read(REG(SCAN_STATUS)) & 3; }

static u16 milliseconds_since(u16 start) {
  start = io_read(REG(MILLISECONDS)) - start;
  return start;
}

// Each of them uses those before it.
// clang-format off
#include "flash.c"
#include "devices.c"
#include "retain.c"
#include "load_file.c"
#include "program.c"
#include "force.c"
#include "registers.c"
#include "modbus.c"
// clang-format on

u16 second_at;  // milliseconds at the last whole second
u16 seconds;    // since the last saving
u16 was_running;
u16 was_on;  // the RUN switch

void firmware_reset(void) {
  describe();
  flash_wake();
  boot();
  if (!(policy & STOP_AFTER_POWER_UP)) start();
  was_on = io_read(REG(SCAN_STATUS)) & SCAN_SWITCH;
}

// What is looked at between two requests while no program is being taken over.
static void watch(void) {
  u16 status;
  status = io_read(REG(SCAN_STATUS));
  if ((status & SCAN_SWITCH) != was_on) {
    was_on = status & SCAN_SWITCH;
    if (was_on) {
      if (status & SCAN_IDLE) run();
    } else if ((status & 3) == RUNNING) {
      io_write(REG(SCAN_COMMAND), SCAN_STOP);
    }
  }
  if ((status & 3) == RUNNING) {
    was_running = 1;
  } else if (was_running && (status & SCAN_IDLE)) {
    was_running = 0;
    save_request = save_request | 1;
  }
  if (milliseconds_since(second_at) >= 1000) {
    second_at = second_at + 1000;
    seconds = seconds + 1;
    if (save_pause) save_pause = save_pause - 1;
    if (save_seconds && seconds >= save_seconds) save_request = save_request | 1;
  }
  if (save_request) {
    seconds = 0;
    save(save_request & 2);
    save_request = 0;
  }
  if ((io_read(REG(KEEP_STATUS)) & 1) && !save_pause) {
    if (save(1))
      save_pause = 2;
    else
      io_write(REG(KEEP_DONE), 1);
  }
}

void firmware_poll(void) {
  // A frame waits and nothing is being sent.
  if ((io_read(REG(LINE_STATUS)) & 3) == 1) serve();
  if (job)
    advance_job();
  else
    watch();
}

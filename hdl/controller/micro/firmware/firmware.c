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

#define REG(name) (MICRO_REGISTERS + REG_##name)

// Modbus exceptions
#define ILLEGAL_FUNCTION 1
#define ILLEGAL_ADDRESS 2
#define ILLEGAL_VALUE 3
#define FAILURE 4

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

// What the program that is loaded says.
u16 exchange_points;
u16 latch_count;
u16 refresh_first;
u16 refresh_count;
u16 unit;
u16 policy;  // bits of the two that follow
u16 save_seconds;
u16 retain_id;
u16 no_program;  // 0: there is one; else the fault that register `fault` shows
u16 copy;        // of the flash, that runs

u16 restored;      // latched devices are
u16 save_request;  // 1 if changed, 2 in any case
u16 job;           // stage of a commit, see program.c

u16 force_list[HOLDING_FORCE_LIST_COUNT];  // as register force_list
u16 force_count;

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

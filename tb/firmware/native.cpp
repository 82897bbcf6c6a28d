// SPDX-License-Identifier: Apache-2.0
// The firmware's C files as the members of a class: globals are members, functions member
// functions. That it is C as well is seen to by the library firmware_as_c of the CMake file.
#include "native.hpp"

namespace rung::tb {
namespace {

struct Bus {
  Machine* machine;
  unsigned short io_read(unsigned short address) const { return machine->read(address); }
  void io_write(unsigned short address, unsigned short value) const {
    machine->write(address, value);
  }
};

}  // namespace

#define RUNG_NATIVE
#define static
struct Native::Firmware : Bus {
#include "firmware.c"
};
#undef static

Native::Native(Machine& machine) : firmware_(new Firmware{}) { firmware_->machine = &machine; }
Native::Native(const Native& other, Machine& machine) : firmware_(new Firmware{*other.firmware_}) {
  firmware_->machine = &machine;
}
Native::~Native() = default;
void Native::reset() { firmware_->firmware_reset(); }
void Native::poll() { firmware_->firmware_poll(); }

}  // namespace rung::tb

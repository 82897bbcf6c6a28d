// SPDX-License-Identifier: Apache-2.0
// A small builder of load files (hdl/controller/README.md) for the tests of the firmware.
#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "machine.hpp"

namespace rung::tb {

class LoadFile {
 public:
  std::uint16_t format = 1, tables = controller::tables, config, board = 0, mpu = 3,
                retain_id = 0x1234;
  std::uint16_t chunks = 3;
  std::uint16_t magic = 0x5250;

  LoadFile();
  LoadFile& at(int space, int address, std::uint16_t value) {
    values_[{space, address}] = value;
    return *this;
  }
  LoadFile& record(int space, int address, const Words& data);  // as it is, before the others
  LoadFile& steps(const Words& chunks);
  // Range n of `keep`
  LoadFile& keep(int n, std::uint16_t flags, std::uint16_t first, std::uint16_t count);

  [[nodiscard]] Words words() const;

 private:
  std::map<std::pair<int, int>, std::uint16_t> values_;
  Words records_;
};

// CRC-32 as load_crc has it
std::uint32_t crc_of(const Words& words);

// The address of the first device of an area of the tests' configuration, and how many it has.
struct Place {
  int first, count, index;
};
Place area(std::string_view name);

// A program with some of everything: device n of M, Y and X is bit device `n` + 0, 100, 200, of D
// word device n; eight devices of each. Input X n is latch entry n, output Y n entry 8 + n. D2 to
// D5 and M2 to M6 are latched, M7 kept. Three PERSIST values. `mark` is in its instructions and the
// initial value of D7.
LoadFile sample_program(std::uint16_t mark);

}  // namespace rung::tb

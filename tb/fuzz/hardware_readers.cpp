// SPDX-License-Identifier: Apache-2.0
#include "fuzz/hardware_readers.hpp"

namespace rung::fuzz {

std::span<const Reader> hardware_readers() {
  static constexpr Reader kReaders[] = {
      {"rtu_line", read_rtu_line},     {"panel", read_panel},   {"link", read_link},
      {"controller", read_controller}, {"modbus", read_modbus}, {"flash", read_flash},
  };
  return kReaders;
}

}  // namespace rung::fuzz

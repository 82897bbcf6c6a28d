// SPDX-License-Identifier: Apache-2.0
// Byte code files made by hand, right and wrong ones.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bytecode/interpreter/rung_vm.h"
#include "bytecode/opcodes.hpp"

namespace rung::tb {

// A file: what is not set is empty or 0, and the last word may be a constant.
struct HandMade {
  int major = RUNG_FORMAT_MAJOR;
  int minor = RUNG_FORMAT_MINOR;
  int bits = 8;
  int words = 16;
  std::vector<std::int16_t> constants;  // behind the words
  int blocks = 2;
  int branches = 2;
  std::vector<std::uint8_t> ticks, driven, ports, names;  // sections as they stand in the file
  int names_count = 0;
  std::vector<std::uint8_t> code;

  std::string bytes() const;
};

// Puts the right check sum under bytes that have been changed.
std::string with_crc(std::string bytes);

// An instruction as bytes.
template <typename... Operands>
std::vector<std::uint8_t> op(bytecode::Code code, Operands... operands) {
  return {static_cast<std::uint8_t>(code), static_cast<std::uint8_t>(operands)...};
}
std::vector<std::uint8_t> operator+(std::vector<std::uint8_t> left,
                                    const std::vector<std::uint8_t>& right);

// A loaded file with its memory.
class Loaded {
 public:
  explicit Loaded(std::string file);
  Loaded(const Loaded&) = delete;
  Loaded& operator=(const Loaded&) = delete;

  rung_vm_error error() const { return error_; }
  rung_vm& vm() { return vm_; }
  // What rung_vm_needs() says.
  const rung_vm_memory& needs() const { return memory_; }

 private:
  std::string file_;
  std::vector<std::uint32_t> times_;
  std::vector<std::uint16_t> words_;
  std::vector<std::uint8_t> bits_;
  rung_vm_memory memory_ = {};
  rung_vm vm_ = {};
  rung_vm_error error_ = RUNG_VM_OK;
};

}  // namespace rung::tb

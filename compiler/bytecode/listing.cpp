// SPDX-License-Identifier: Apache-2.0
#include "bytecode/listing.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <utility>

#include "bytecode/interpreter/rung_format.h"
#include "bytecode/opcodes.hpp"
#include "rungs/ports.hpp"

namespace rung::bytecode {
namespace {

class Lister {
 public:
  explicit Lister(std::string_view file) : file_(file) {}

  std::string run() {
    read_header();
    out_ = fmt::format(
        "; byte code {}.{}: {} bytes, {} of them code; {} bits, {} words, {} times; scan period "
        "{} us\n",
        number(RUNG_AT_MAJOR, 1), number(RUNG_AT_MINOR, 1), file_.size(), code_size_,
        number(RUNG_AT_BITS, 2) + number(RUNG_AT_BLOCKS, 2) + number(RUNG_AT_BRANCHES, 2),
        number(RUNG_AT_WORDS, 2), number(RUNG_AT_TICKS, 2) + number(RUNG_AT_DRIVEN, 2),
        number(RUNG_AT_PERIOD, 4));
    while (at_ < code_ + code_size_) instruction();
    return std::move(out_);
  }

 private:
  std::uint32_t number(std::size_t at, int width) const {
    std::uint32_t value = 0;
    for (int i = 0; i < width; ++i) {
      value |= static_cast<std::uint32_t>(static_cast<std::uint8_t>(file_[at + i])) << (8 * i);
    }
    return value;
  }

  void read_header() {
    std::size_t at = RUNG_HEADER_BYTES;
    const std::uint32_t words = number(RUNG_AT_WORDS, 2);
    for (std::uint32_t i = number(RUNG_AT_FIRST_CONSTANT, 2); i < words; ++i) {
      names_[{RUNG_SPACE_WORD, i}] =
          fmt::format("K{}", static_cast<std::int16_t>(number(at, RUNG_CONSTANT_BYTES)));
      at += RUNG_CONSTANT_BYTES;
    }
    for (std::uint32_t i = 0; i < number(RUNG_AT_TICKS, 2); ++i, at += RUNG_TICK_BYTES) {
      names_[{RUNG_SPACE_WORD, number(at, 2)}] = fmt::format("ticks of {} us", number(at + 2, 4));
    }
    at += number(RUNG_AT_DRIVEN, 2) * RUNG_DRIVEN_BYTES;
    for (std::uint32_t i = 0; i < number(RUNG_AT_PORTS, 2); ++i, at += RUNG_PORT_BYTES) {
      const std::uint32_t space = number(at, 1);
      const DeviceKind kind = space == RUNG_SPACE_BIT ? DeviceKind::PB : DeviceKind::PW;
      names_[{space, number(at + 2, 2)}] = port::name({kind, number(at + 1, 1)});
    }
    code_ = at_ = at;
    code_size_ = number(RUNG_AT_CODE_SIZE, 4);
    at += code_size_;
    for (std::uint32_t i = 0; i < number(RUNG_AT_NAMES, 2); ++i) {
      const std::uint32_t use = number(at, 1);
      const std::uint32_t length = number(at + 3, 2);
      if (use >> 1U != RUNG_USE_CHANNEL) {
        names_[{use & 1U, number(at + 1, 2)}] = file_.substr(at + RUNG_NAME_BYTES, length);
      }
      at += RUNG_NAME_BYTES + length;
    }
  }

  std::uint32_t next_byte() { return number(at_++, 1); }
  std::uint32_t next_number() {
    const std::uint32_t first = next_byte();
    return first < 0x80 ? first : (first & 0x7FU) << 8U | next_byte();
  }
  std::string device(std::uint32_t space) {
    const std::uint32_t n = next_number();
    const auto name = names_.find({space, n});
    if (name != names_.end()) return name->second;
    return fmt::format("{}{}", space == RUNG_SPACE_BIT ? "bit" : "word", n);
  }

  std::string operand(char kind) {
    switch (kind) {
      case 'b':
      case 'B':
        return device(RUNG_SPACE_BIT);
      case 'w':
      case 'W':
        return device(RUNG_SPACE_WORD);
      case 'a':
      case 'A':
      case 't': {
        const std::string first = device(kind == 'a' ? RUNG_SPACE_BIT : RUNG_SPACE_WORD);
        return fmt::format("{}[{}]", first, next_number());
      }
      case 's':
        return fmt::format("+{}", next_number());
      default:  // n
        return fmt::format("{}", next_byte());
    }
  }

  void instruction() {
    std::string line = fmt::format("{:6}  ", at_ - code_);
    const CodeInfo& what = info(static_cast<Code>(next_byte()));
    line += what.name;
    std::uint32_t times = 1;
    for (const char kind : what.operands) {
      if (kind == 'c') {
        times = next_byte();
        continue;
      }
      for (; times > 0; --times) line += " " + operand(kind);
      times = 1;
    }
    out_ += line + "\n";
  }

  std::string_view file_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::string> names_;  // by space and number
  std::size_t code_ = 0, at_ = 0;
  std::uint32_t code_size_ = 0;
  std::string out_;
};

}  // namespace

std::string listing(std::string_view file) { return Lister(file).run(); }

}  // namespace rung::bytecode

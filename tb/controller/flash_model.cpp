// SPDX-License-Identifier: Apache-2.0
#include "controller/flash_model.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

namespace rung::tb {
namespace {

constexpr std::uint8_t kReadId = 0x9f;
constexpr std::uint8_t kReadStatus = 0x05;
constexpr std::uint8_t kWriteEnable = 0x06;
constexpr std::uint8_t kWriteDisable = 0x04;
constexpr std::uint8_t kRead = 0x03;
constexpr std::uint8_t kFastRead = 0x0b;
constexpr std::uint8_t kPageProgram = 0x02;
constexpr std::uint8_t kSectorErase = 0x20;
constexpr std::uint8_t kBlockErase = 0xd8;
constexpr std::uint8_t kWake = 0xab;
constexpr std::uint8_t kSleep = 0xb9;

constexpr std::uint8_t kErased = 0xff;
constexpr std::uint8_t kManufacturer = 0xef;
constexpr std::uint8_t kType = 0x40;
constexpr std::size_t kAddressed = 4;  // bytes of a command with its address
constexpr std::size_t kMostKept = 16;  // messages: a driver gone wrong must not fill the memory

}  // namespace

FlashModel::FlashModel(std::size_t size, std::uint64_t seed, FlashTimes times)
    : memory_(size, kErased),
      random_(seed),
      times_(times),
      page_(page_size, kErased),
      page_set_(page_size, false) {}

void FlashModel::misuse(const std::string& what) {
  if (misuses_.size() < kMostKept) misuses_.push_back(fmt::format("clock {}: {}", now_, what));
}

// csn first: a clock edge in the same clock as the selection would be a set-up violation.
void FlashModel::edge(bool csn, bool sck, bool mosi) {
  if (csn != csn_) {
    if (csn) {
      deselected();
    } else {
      if (sck) misuse("selected with sck 1: mode 0 begins with sck 0");
      bits_ = 0;
      bytes_ = 0;
      ignored_ = false;
    }
    drives_ = false;
    miso_ = true;
  } else if (sck) {
    in_ = static_cast<std::uint8_t>(in_ << 1 | (mosi ? 1 : 0));
    if (++bits_ == 8) byte_in(in_);
  } else {
    if (bits_ == 8) {
      bits_ = 0;
      if (drives_) out_ = byte_out();
    }
    miso_ = !drives_ || (out_ >> (7 - bits_) & 1) != 0;
  }
  csn_ = csn;
  sck_ = sck;
}

void FlashModel::command(std::uint8_t byte) {
  command_ = byte;
  address_ = 0;
  if (asleep_ && byte != kWake) {
    ignored_ = true;
    misuse(fmt::format("command {:02x} while powered down", byte));
  } else if (!asleep_ && now_ < awake_at_) {
    ignored_ = true;
    misuse(fmt::format("command {:02x} before the wake time", byte));
  } else if (busy() && byte != kReadStatus) {
    ignored_ = true;
    ++busy_accesses_;
  } else if (byte == kReadId || byte == kReadStatus) {
    drives_ = true;
  } else if (byte == kPageProgram) {
    page_set_.assign(page_size, false);
  } else if (byte != kWriteEnable && byte != kWriteDisable && byte != kRead && byte != kFastRead &&
             byte != kSectorErase && byte != kBlockErase && byte != kWake && byte != kSleep) {
    ignored_ = true;
    misuse(fmt::format("command {:02x} is not known", byte));
  }
}

void FlashModel::byte_in(std::uint8_t byte) {
  ++bytes_;
  if (bytes_ == 1) {
    command(byte);
  } else if (ignored_) {
    return;
  } else if (bytes_ <= kAddressed) {
    address_ = (address_ << 8 | byte) & (memory_.size() - 1);
  } else if (command_ == kPageProgram) {
    // More than a page: the later bytes replace those before them.
    const std::size_t at = (address_ + bytes_ - kAddressed - 1) % page_size;
    page_[at] = byte;
    page_set_[at] = true;
  }
  const std::size_t header = command_ == kFastRead ? kAddressed + 1 : kAddressed;
  if (!ignored_ && bytes_ == header &&
      (command_ == kRead || command_ == kFastRead || command_ == kWake)) {
    drives_ = true;
  }
}

std::uint8_t FlashModel::byte_out() {
  if (command_ == kReadStatus) {
    return static_cast<std::uint8_t>((busy() ? 1 : 0) | (write_enabled_ ? 2 : 0));
  }
  if (command_ == kReadId) {
    std::uint8_t capacity = 0;
    while (std::size_t{1} << capacity < memory_.size()) ++capacity;
    const std::uint8_t id[] = {kManufacturer, kType, capacity};
    return id[(bytes_ - 1) % 3];
  }
  if (command_ == kWake) return 0x17;
  const std::uint8_t byte = memory_[address_];
  address_ = (address_ + 1) & (memory_.size() - 1);
  return byte;
}

// csn has risen: commands that change something are carried out, if they are whole.
void FlashModel::deselected() {
  if (bytes_ == 0 && bits_ == 0) return;
  // Eight bits with sck still 1 are a whole byte.
  const bool whole = bits_ == 0 || bits_ == 8;
  if (!whole) misuse(fmt::format("deselected after {} bits of a byte", bits_));
  if (ignored_ || !whole || bytes_ == 0) return;
  const auto exactly = [&](std::size_t bytes) {
    if (bytes_ != bytes) {
      misuse(fmt::format("command {:02x} with {} bytes instead of {}", command_, bytes_, bytes));
    }
    return bytes_ == bytes;
  };
  switch (command_) {
    case kWriteEnable:
      if (exactly(1)) write_enabled_ = true;
      break;
    case kWriteDisable:
      if (exactly(1)) write_enabled_ = false;
      break;
    case kPageProgram:
      start_program();
      break;
    case kSectorErase:
      if (exactly(kAddressed)) start_erase(sector_size, times_.sector_erase);
      break;
    case kBlockErase:
      if (exactly(kAddressed)) start_erase(block_size, times_.block_erase);
      break;
    case kWake:
      if (asleep_) awake_at_ = now_ + times_.wake;
      asleep_ = false;
      break;
    case kSleep:
      if (exactly(1)) asleep_ = true;
      break;
    default:
      break;
  }
}

void FlashModel::start_program() {
  if (bytes_ <= kAddressed) {
    misuse("page program without data");
  } else if (!write_enabled_) {
    misuse("page program without write enable");
  } else {
    operation_ = Operation::program;
    operation_at_ = address_ / page_size * page_size;
    operation_end_ = now_ + times_.page_program;
  }
}

void FlashModel::start_erase(std::size_t bytes, std::uint64_t clocks) {
  if (!write_enabled_) {
    misuse("erase without write enable");
    return;
  }
  operation_ = Operation::erase;
  operation_at_ = address_ / bytes * bytes;
  operation_bytes_ = bytes;
  operation_end_ = now_ + clocks;
}

void FlashModel::finish() {
  if (operation_ == Operation::program) {
    for (std::size_t i = 0; i < page_size; ++i) {
      if (page_set_[i]) memory_[operation_at_ + i] &= page_[i];
    }
    ++programs_;
  } else {
    for (std::size_t i = 0; i < operation_bytes_; ++i) memory_[operation_at_ + i] = kErased;
    ++erases_;
  }
  operation_ = Operation::none;
  write_enabled_ = false;
}

// A cut program has cleared some of its bits. An erase first clears bits, so that all cells wear
// alike, and then sets them: a cut one has left any of them as it was, cleared or set.
void FlashModel::power_cut() {
  const auto chance = static_cast<double>(random_() % 1001) / 1000;
  std::bernoulli_distribution reached(chance);
  const auto some_bits = [&] {
    int bits = 0;
    for (int bit = 0; bit < 8; ++bit) bits |= reached(random_) ? 1 << bit : 0;
    return static_cast<std::uint8_t>(bits);
  };
  if (operation_ == Operation::program) {
    for (std::size_t i = 0; i < page_size; ++i) {
      if (page_set_[i]) {
        memory_[operation_at_ + i] &= static_cast<std::uint8_t>(page_[i] | ~some_bits());
      }
    }
  } else if (operation_ == Operation::erase) {
    const bool clearing = random_() % 2 == 0;
    for (std::size_t i = 0; i < operation_bytes_; ++i) {
      std::uint8_t& byte = memory_[operation_at_ + i];
      byte = clearing ? static_cast<std::uint8_t>(byte & ~some_bits()) : some_bits();
    }
  }
  operation_ = Operation::none;
  write_enabled_ = false;
  asleep_ = false;
  awake_at_ = 0;
  csn_ = true;
  sck_ = false;
  miso_ = true;
  drives_ = false;
  bits_ = 0;
  bytes_ = 0;
}

bool FlashModel::load(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return false;
  const std::vector<char> bytes{std::istreambuf_iterator<char>(in),
                                std::istreambuf_iterator<char>()};
  if (in.bad() || bytes.size() > memory_.size()) return false;
  memory_.assign(memory_.size(), kErased);
  for (std::size_t i = 0; i < bytes.size(); ++i) memory_[i] = static_cast<std::uint8_t>(bytes[i]);
  return true;
}

bool FlashModel::save(const std::filesystem::path& file) const {
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  out.write(reinterpret_cast<const char*>(memory_.data()),
            static_cast<std::streamsize>(memory_.size()));
  out.close();
  return out.good();
}

}  // namespace rung::tb

// SPDX-License-Identifier: Apache-2.0
// A SPI NOR flash at its pins (mode 0), clock by clock: what a W25Q and its like do of the commands
// 9F 05 06 04 03 0B 02 20 D8 AB B9. Programming can only clear bits and wraps within its page; it
// and erasing take their time, in which only 05 is understood. Power may go at any clock.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace rung::tb {

struct FlashTimes {  // in clocks of the model
  std::uint64_t page_program = 2000;
  std::uint64_t sector_erase = 20000;  // 4 KiB, command 20
  std::uint64_t block_erase = 60000;   // 64 KiB, command D8
  std::uint64_t wake = 100;            // after AB
};

class FlashModel {
 public:
  static constexpr std::size_t page_size = 256;
  static constexpr std::size_t sector_size = 4096;
  static constexpr std::size_t block_size = 65536;

  // Erased, and size bytes (a power of two, 64 KiB to 16 MiB). The seed is of what a power cut
  // leaves.
  explicit FlashModel(std::size_t size, std::uint64_t seed = 1, FlashTimes times = {});

  // One clock: the pins' levels in it; the level of miso then (1, a pull-up's, while it is not
  // driven).
  bool clock(bool csn, bool sck, bool mosi) {
    ++now_;
    if (operation_ != Operation::none && now_ >= operation_end_) finish();
    if (csn != csn_ || (!csn && sck != sck_)) edge(csn, sck, mosi);
    return miso_;
  }

  // Power goes: what was being programmed or erased is left partly done, each bit at random; all
  // else in the memory stays. The flash is as after power-up then, and its pins must begin with
  // csn 1.
  void power_cut();
  bool busy() const { return operation_ != Operation::none; }

  std::vector<std::uint8_t>& memory() { return memory_; }
  const std::vector<std::uint8_t>& memory() const { return memory_; }
  // A file shorter than the memory leaves its rest erased; false: it cannot be read (or written),
  // or is longer.
  bool load(const std::filesystem::path& file);
  bool save(const std::filesystem::path& file) const;

  // What no driver should do, each in words: programming or erasing without WEL, commands that are
  // not understood or are cut within a byte, commands while asleep or before the wake time has
  // passed.
  const std::vector<std::string>& misuses() const { return misuses_; }
  // Commands other than 05 while busy: ignored, as the flash does.
  std::uint64_t busy_accesses() const { return busy_accesses_; }
  std::uint64_t programs() const { return programs_; }
  std::uint64_t erases() const { return erases_; }

 private:
  enum class Operation { none, program, erase };

  void edge(bool csn, bool sck, bool mosi);
  void byte_in(std::uint8_t byte);
  void command(std::uint8_t byte);
  std::uint8_t byte_out();
  void deselected();
  void start_program();
  void start_erase(std::size_t bytes, std::uint64_t clocks);
  void finish();
  void misuse(const std::string& what);

  std::vector<std::uint8_t> memory_;
  std::mt19937_64 random_;
  FlashTimes times_;
  std::uint64_t now_ = 0;

  // pins and the byte under way
  bool csn_ = true;
  bool sck_ = false;
  bool miso_ = true;
  int bits_ = 0;
  std::uint8_t in_ = 0;
  std::uint8_t out_ = 0;

  // the command under way
  std::size_t bytes_ = 0;  // of it so far
  std::uint8_t command_ = 0;
  bool ignored_ = false;
  bool drives_ = false;
  std::size_t address_ = 0;
  std::vector<std::uint8_t> page_;  // what 02 has brought, by place in the page
  std::vector<bool> page_set_;

  // state
  bool write_enabled_ = false;
  bool asleep_ = false;
  std::uint64_t awake_at_ = 0;
  Operation operation_ = Operation::none;
  std::uint64_t operation_end_ = 0;
  std::size_t operation_at_ = 0;
  std::size_t operation_bytes_ = 0;

  std::vector<std::string> misuses_;
  std::uint64_t busy_accesses_ = 0;
  std::uint64_t programs_ = 0;
  std::uint64_t erases_ = 0;
};

}  // namespace rung::tb

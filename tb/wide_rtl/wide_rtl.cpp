// SPDX-License-Identifier: Apache-2.0
#include "wide_rtl/wide_rtl.hpp"

#include <fmt/format.h>

#include <numeric>
#include <stdexcept>

#include "Vw16_mpu4.h"
#include "Vw4_mpu4.h"
#include "Vw8_mpu4.h"
#include "wide_rtl/verilated_wide.hpp"

namespace rung::tb::wide {
namespace {

// Spaces of the load port (hdl/wide/wide_load_port.v).
constexpr int kInstructions = 0;
constexpr int kBits = 2;
constexpr int kWords = 3;
constexpr int kControl = 4;
}  // namespace

void WideRtl::load(std::span<const Step> steps, int latch_row, int latch_rows) {
  for (std::size_t step = 0; step < steps.size(); ++step) {
    for (int slot = 0; slot < slots(); ++slot) {
      load_chunks(static_cast<int>(step), slot, chunks(steps[step], slot));
    }
  }
  set_program(static_cast<int>(steps.size()), latch_row, latch_rows);
}
void WideRtl::load_chunks(int step, int slot, std::span<const std::uint16_t> chunks) {
  const auto first = static_cast<std::uint32_t>(step * slots() + slot) * 8;
  for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk) {
    write(kInstructions, first + static_cast<std::uint32_t>(chunk), chunks[chunk]);
  }
}
void WideRtl::set_program(int steps, int latch_row, int latch_rows) {
  write(kControl, 0, static_cast<std::uint16_t>(steps));
  write(kControl, 1, static_cast<std::uint16_t>(latch_row));
  write(kControl, 2, static_cast<std::uint16_t>(latch_rows));
}
void WideRtl::write_bit(const Place& place, bool value) {
  write(kBits, static_cast<std::uint32_t>(place.row * slots() + place.lane), value ? 1 : 0);
}
void WideRtl::write_word(const Place& place, std::uint16_t value) {
  write(kWords, static_cast<std::uint32_t>(place.row * units() + place.lane), value);
}
std::vector<std::uint16_t> WideRtl::read_bits(std::span<const int> addresses) {
  return read(kBits, addresses);
}
std::vector<std::uint16_t> WideRtl::read_words(std::span<const int> addresses) {
  return read(kWords, addresses);
}
bool WideRtl::read_bit(const Place& place) {
  const int address = place.row * slots() + place.lane;
  return read_bits({&address, 1}).front() != 0;
}
std::uint16_t WideRtl::read_word(const Place& place) {
  const int address = place.row * units() + place.lane;
  return read_words({&address, 1}).front();
}
std::vector<std::uint16_t> WideRtl::read_bit_rows(int rows) {
  std::vector<int> addresses(static_cast<std::size_t>(rows * slots()));
  std::iota(addresses.begin(), addresses.end(), 0);
  return read_bits(addresses);
}
std::vector<std::uint16_t> WideRtl::read_word_rows(int rows) {
  std::vector<int> addresses(static_cast<std::size_t>(rows * units()));
  std::iota(addresses.begin(), addresses.end(), 0);
  return read_words(addresses);
}

std::unique_ptr<WideRtl> make_wide_rtl(int slots, int seed) {
  switch (slots) {
    case 4:
      return std::make_unique<VerilatedWide<Vw4_mpu4, 4>>(seed);
    case 8:
      return std::make_unique<VerilatedWide<Vw8_mpu4, 8>>(seed);
    case 16:
      return std::make_unique<VerilatedWide<Vw16_mpu4, 16>>(seed);
    default:
      throw std::invalid_argument(fmt::format("MPU4 with {} slots: there are 4, 8 and 16", slots));
  }
}

}  // namespace rung::tb::wide

// SPDX-License-Identifier: Apache-2.0
// MPU4 that runs the program of an image: the compiler's simulator of its instructions, and beside
// it the RTL under Verilator unless only the simulator is wanted. The RTL must give every row of
// every step, and the error flag, as the simulator does: what its retire port cannot show, whether
// a word was written or kept, is then the simulator's to say.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "harness/processor.hpp"
#include "image/image.hpp"
#include "wide/simulate.hpp"
#include "wide_rtl/wide_rtl.hpp"

namespace rung::tb {

class WideProcessor final : public DeviceMemory {
 public:
  // `rtl` may be null.
  WideProcessor(int slots, std::unique_ptr<wide::WideRtl> rtl);

  const rung::wide::Machine& machine() const { return machine_; }
  // Loads the program of an image for as many slots; all places are 0 then.
  void load(const image::Image& image);

  // Addresses are row * lanes + lane, lanes being slots for a bit and units for a word.
  void write_bit(int address, bool value) override;
  void write_word(int address, std::uint16_t value) override;
  bool read_bit(int address) override;
  std::uint16_t read_word(int address) override;
  // Many of them: the RTL answers one a clock.
  std::vector<std::uint16_t> read_bits(std::span<const int> addresses);
  std::vector<std::uint16_t> read_words(std::span<const int> addresses);

  // One scan, with the bits that are latched, row by row. Throws std::runtime_error where RTL and
  // simulator differ.
  ScanResult run_scan(std::span<const std::uint8_t> inputs);
  // What the last scan computed.
  const rung::wide::Simulator& last() const { return *simulator_; }

 private:
  std::vector<std::uint16_t> read(bool words, std::span<const int> addresses);
  void compare(const wide::Scan& scan) const;

  const rung::wide::Machine& machine_;
  std::optional<rung::wide::Simulator> simulator_;
  std::unique_ptr<wide::WideRtl> rtl_;
  int steps_ = 0;
  int latch_rows_ = 0;
};

// MPU4 with so many slots, as RTL.
std::unique_ptr<WideProcessor> make_wide_processor(int slots);
// Its simulator alone.
std::unique_ptr<WideProcessor> make_wide_simulator(int slots);

}  // namespace rung::tb

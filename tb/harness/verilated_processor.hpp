// SPDX-License-Identifier: Apache-2.0
// The processor interface over one Verilated model.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "harness/clocked.hpp"
#include "harness/processor.hpp"

namespace rung::tb {

// Spaces of the load port (hdl/core/load_port.v).
enum class LoadSpace : std::uint8_t { Steps = 0, Lut = 1, Bits = 2, Words = 3, Length = 4 };

template <typename Dut, isa::Mpu kMpu>
class VerilatedProcessor final : public Processor {
 public:
  explicit VerilatedProcessor(const isa::Config& config)
      : config_(config), slot_bits_(isa::slot_bits(kMpu, config)) {
    dut_->start_i = 0;
    dut_->range_i = 0;
    dut_->load_valid_i = 0;
    reset();
    clear_devices();
  }

  isa::Mpu mpu() const override { return kMpu; }
  const isa::Config& config() const override { return config_; }

  void reset() override {
    dut_.reset();
    write(LoadSpace::Length, 0, length_);
  }

  void load_program(std::span<const std::vector<std::uint64_t>> steps) override {
    if (steps.size() > static_cast<std::size_t>(config_.steps(kMpu))) {
      throw std::invalid_argument(fmt::format("{} steps, but the instruction memory has {}",
                                              steps.size(), config_.steps(kMpu)));
    }
    const int chunks = (kSlots * slot_bits_ + kChunkBits - 1) / kChunkBits;
    for (std::size_t step = 0; step < steps.size(); ++step) {
      if (steps[step].size() != kSlots) {
        throw std::invalid_argument(
            fmt::format("step {} has {} slots instead of {}", step, steps[step].size(), kSlots));
      }
      for (int chunk = 0; chunk < chunks; ++chunk) {
        write(LoadSpace::Steps, static_cast<std::uint32_t>(step * 8) + chunk,
              step_chunk(steps[step], chunk));
      }
    }
    length_ = static_cast<std::uint16_t>(steps.size());
    write(LoadSpace::Length, 0, length_);
    // A scan takes at most this, even if every step waits for a division.
    const int wait = std::max({config_.mul_latency, config_.div_latency, config_.mul32_latency,
                               config_.div32_latency}) +
                     1;
    clock_limit_ = static_cast<std::uint32_t>(steps.size()) * wait + 1000;
  }

  void load_lut(int row, std::uint8_t function) override {
    write(LoadSpace::Lut, static_cast<std::uint32_t>(row), function);
  }
  void write_bit(int address, bool value) override {
    write(LoadSpace::Bits, static_cast<std::uint32_t>(address), value ? 1 : 0);
  }
  void write_word(int address, std::uint16_t value) override {
    write(LoadSpace::Words, static_cast<std::uint32_t>(address), value);
  }
  bool read_bit(int address) override { return read(LoadSpace::Bits, address) != 0; }
  std::uint16_t read_word(int address) override { return read(LoadSpace::Words, address); }

  void clear_devices() override {
    for (int i = 0; i < config_.bit_devices; ++i) write_bit(i, false);
    for (int i = 0; i < config_.word_devices; ++i) write_word(i, 0);
  }

  ScanResult run_scan(const RetireObserver& on_retire) override {
    dut_->range_i = 0;
    return run(on_retire);
  }

  ScanResult run_range(std::uint16_t entry, std::uint16_t end,
                       const RetireObserver& on_retire) override {
    dut_->range_i = 1;
    dut_->entry_i = entry;
    dut_->end_i = end;
    return run(on_retire);
  }

  void disturb_load_port(bool on) override { disturbed_ = on; }

  // Calls `observer` in every clock of the scans to come, with the model as it is in that clock.
  void observe_clocks(std::function<void()> observer) { on_clock_ = std::move(observer); }
  Dut& dut() { return *dut_.operator->(); }

 private:
  static constexpr int kSlots = kMpu == isa::Mpu::Mpu3 ? 2 : 1;
  static constexpr int kChunkBits = 16;
  // Clocks within which the load port must have answered a read.
  static constexpr int kReadLimit = 100;

  // Bits 16 * chunk and up of a step: its slots side by side, slot 0 lowest.
  std::uint16_t step_chunk(const std::vector<std::uint64_t>& slots, int chunk) const {
    std::uint64_t bits = 0;
    for (int slot = 0; slot < kSlots; ++slot) {
      const int shift = slot * slot_bits_ - chunk * kChunkBits;
      if (shift >= kChunkBits || shift <= -slot_bits_) continue;
      const std::uint64_t word = slots[static_cast<std::size_t>(slot)];
      bits |= shift >= 0 ? word << shift : word >> -shift;
    }
    return static_cast<std::uint16_t>(bits);
  }

  ScanResult run(const RetireObserver& on_retire) {
    const bool observe = static_cast<bool>(on_retire);
    dut_->start_i = 1;
    dut_.tick();
    dut_->start_i = 0;
    // Sampled with start, so nothing may depend on them any more.
    dut_->range_i = !dut_->range_i;
    dut_->entry_i = ~dut_->entry_i;
    dut_->end_i = ~dut_->end_i;
    ScanResult result;
    bool done = false;
    while (!done) {
      check_writes();
      if (on_clock_) on_clock_();
      if (observe && dut_->retire_valid_o != 0) report(on_retire);
      done = dut_->done_o != 0;
      if (done) {
        result.counted = dut_->clocks_o;
        result.error = dut_->error_o != 0;
      }
      if (disturbed_) disturb();
      dut_.tick();
      if (++result.clocks > clock_limit_) {
        throw std::runtime_error(fmt::format("no end of the scan after {} clocks", clock_limit_));
      }
    }
    check_writes();
    dut_->load_valid_i = 0;
    return result;
  }

  // Another access; none in the clock with done, which is not busy any more.
  void disturb() {
    if (dut_->load_rvalid_o != 0) throw std::runtime_error("the load port answers in a scan");
    noise_ = noise_ * 1664525U + 1013904223U;
    dut_->load_valid_i = dut_->busy_o;
    dut_->load_write_i = noise_ >> 31U;
    dut_->load_space_i = noise_ >> 28U & 7U;
    dut_->load_addr_i = noise_ >> 8U & 0xfffffU;
    dut_->load_data_i = static_cast<std::uint16_t>(noise_);
  }

  // Words written in a clock, as the retire port has them: a slot's valid bit, address, data.
  struct Writes {
    std::uint32_t valid = 0;
    std::uint32_t address = 0;
    std::uint32_t data = 0;
  };
  void check_writes() {
    const Writes& due = writes_[1];
    bool right = dut_->write_valid_o == due.valid;
    for (int slot = 0; slot < kSlots; ++slot) {
      const std::uint32_t mask = 0xffffU << 16 * slot;
      right = right &&
              ((due.valid >> slot & 1) == 0 || ((dut_->write_addr_o ^ due.address) & mask) == 0);
      right =
          right && ((due.valid >> slot & 1) == 0 || ((dut_->write_data_o ^ due.data) & mask) == 0);
    }
    if (!right) throw std::runtime_error("the write port differs from what has retired");
    writes_[1] = writes_[0];
    writes_[0] = {dut_->retire_word_we_o, dut_->retire_word_addr_o, dut_->retire_word_data_o};
  }

  void write(LoadSpace space, std::uint32_t address, std::uint16_t data) {
    dut_->load_valid_i = 1;
    dut_->load_write_i = 1;
    dut_->load_space_i = static_cast<std::uint8_t>(space);
    dut_->load_addr_i = address;
    dut_->load_data_i = data;
    dut_.tick();
    dut_->load_valid_i = 0;
  }

  std::uint16_t read(LoadSpace space, int address) {
    dut_->load_valid_i = 1;
    dut_->load_write_i = 0;
    dut_->load_space_i = static_cast<std::uint8_t>(space);
    dut_->load_addr_i = static_cast<std::uint32_t>(address);
    dut_.tick();
    dut_->load_valid_i = 0;
    for (int i = 0; i < kReadLimit; ++i) {
      if (dut_->load_rvalid_o != 0) return dut_->load_rdata_o;
      dut_.tick();
    }
    throw std::runtime_error("the load port does not answer");
  }

  void report(const RetireObserver& on_retire) {
    for (int slot = 0; slot < kSlots; ++slot) {
      if ((dut_->retire_valid_o >> slot & 1) == 0) continue;
      Retired retired;
      retired.step = static_cast<std::uint16_t>(dut_->retire_step_o >> 16 * slot);
      retired.slot = static_cast<std::uint8_t>(slot);
      retired.exc = (dut_->retire_exc_o >> slot & 1) != 0;
      retired.bit_we = (dut_->retire_bit_we_o >> slot & 1) != 0;
      retired.bit_address = static_cast<std::uint16_t>(dut_->retire_bit_addr_o >> 16 * slot);
      retired.bit_value = (dut_->retire_bit_data_o >> slot & 1) != 0;
      retired.word_we = (dut_->retire_word_we_o >> slot & 1) != 0;
      retired.word_address = static_cast<std::uint16_t>(dut_->retire_word_addr_o >> 16 * slot);
      retired.word_value = static_cast<std::uint16_t>(dut_->retire_word_data_o >> 16 * slot);
      on_retire(retired);
    }
  }

  const isa::Config& config_;
  int slot_bits_;
  std::uint16_t length_ = 0;  // of the loaded program
  std::uint32_t clock_limit_ = 1000;
  std::array<Writes, 2> writes_{};  // of the last two clocks of a scan, the last one first
  std::function<void()> on_clock_;
  bool disturbed_ = false;
  std::uint32_t noise_ = 1;
  Clocked<Dut> dut_;
};

}  // namespace rung::tb

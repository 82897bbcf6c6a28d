// SPDX-License-Identifier: Apache-2.0
// The interface of wide_rtl.hpp over one Verilated model.
#pragma once

#include <stdexcept>
#include <type_traits>

#include "harness/clocked.hpp"
#include "wide_rtl/wide_rtl.hpp"

namespace rung::tb::wide {

// A bit of a port of up to 64 bits, or of a wider one.
template <typename Port>
bool bit_of(const Port& port, int i) {
  if constexpr (std::is_integral_v<Port>) {
    return ((port >> i) & 1U) != 0;
  } else {
    return ((port[static_cast<std::size_t>(i / 32)] >> (i % 32)) & 1U) != 0;
  }
}
template <typename Port>
void set_bit(Port& port, int i, bool value) {
  if constexpr (std::is_integral_v<Port>) {
    const Port mask = static_cast<Port>(Port{1} << i);
    port = static_cast<Port>(value ? port | mask : port & ~mask);
  } else {
    auto& word = port[static_cast<std::size_t>(i / 32)];
    const auto mask = std::uint32_t{1} << (i % 32);
    word = value ? word | mask : word & ~mask;
  }
}

template <typename Dut, int kSlots>
class VerilatedWide final : public WideRtl {
 public:
  explicit VerilatedWide(int seed) : dut_(seed) {
    dut_->start_i = 0;
    dut_->load_valid_i = 0;
    reset();
  }
  int slots() const override { return kSlots; }
  void reset() override { dut_.reset(); }

  void write(int space, std::uint32_t address, std::uint16_t data) override {
    access(space, address, data, true);
    since_access_ = 0;
  }

  std::vector<std::uint16_t> read(int space, std::span<const int> addresses) override {
    std::vector<std::uint16_t> values;
    if (addresses.empty()) return values;
    const auto count = static_cast<int>(addresses.size());
    for (int i = 0; i < count + kReadClocks - 1; ++i) {
      if (i < count) {
        access(space, static_cast<std::uint32_t>(addresses[static_cast<std::size_t>(i)]), 0, false);
      } else {
        tick();
      }
      // What was sampled at edge n is there in clock n + 10, and at no other time.
      if ((dut_->load_rvalid_o != 0) != (i >= kReadClocks - 1))
        throw std::runtime_error("load port: no answer in time");
      if (dut_->load_rvalid_o != 0) values.push_back(dut_->load_rdata_o);
    }
    return values;
  }

  void idle(int clocks) override {
    for (int i = 0; i < clocks; ++i) tick();
  }

  std::vector<Scan> scans(const std::vector<std::vector<bool>>& inputs) override {
    while (since_access_ < kAccessClocks) tick();
    rows_.clear();
    std::vector<Scan> scans(inputs.size());
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      set_inputs(inputs[i], false);
      dut_->start_i = 1;
      tick();
      dut_->start_i = 0;
      // Inputs are sampled with the start: what comes later is another scan's.
      set_inputs(inputs[i], true);
      scans[i].edges = 1;
      for (; dut_->done_o == 0; ++scans[i].edges) {
        if (scans[i].edges > kLimit) throw std::runtime_error("no done");
        tick();
      }
      scans[i].clocks = dut_->clocks_o;
      if (dut_->busy_o != 0) throw std::runtime_error("busy with done");
    }
    idle(kDrain);
    std::size_t scan = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (i > 0 && rows_[i].step == 0) ++scan;
      scans.at(scan).rows.push_back(rows_[i]);
    }
    scans.back().error = dut_->error_o != 0;
    return scans;
  }

 private:
  // Clocks that have to lie between the last access and start.
  static constexpr int kAccessClocks = 6;
  static constexpr int kReadClocks = 10;
  static constexpr int kLimit = 2000;

  void set_inputs(const std::vector<bool>& inputs, bool inverted) {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      set_bit(dut_->in_i, static_cast<int>(i), inputs[i] != inverted);
    }
  }

  void access(int space, std::uint32_t address, std::uint16_t data, bool write) {
    dut_->load_valid_i = 1;
    dut_->load_write_i = write;
    dut_->load_space_i = static_cast<std::uint8_t>(space);
    dut_->load_addr_i = address;
    dut_->load_data_i = data;
    tick();
    dut_->load_valid_i = 0;
  }

  void tick() {
    dut_.tick();
    ++since_access_;
    if (dut_->retire_valid_o == 0) return;
    Row row;
    row.step = dut_->retire_step_o;
    for (int i = 0; i < kSlots; ++i) row.bits.push_back(bit_of(dut_->retire_bits_o, i));
    for (int u = 0; u < kSlots / 2; ++u) {
      unsigned word = 0;
      for (int i = 0; i < 16; ++i)
        word |= static_cast<unsigned>(bit_of(dut_->retire_words_o, 16 * u + i)) << i;
      row.words.push_back(static_cast<std::uint16_t>(word));
    }
    rows_.push_back(row);
  }

  // The last step's row retires, and a division by 0 shows, after done.
  static constexpr int kDrain = 4;
  Clocked<Dut> dut_;
  std::vector<Row> rows_;
  int since_access_ = 0;
};

}  // namespace rung::tb::wide
